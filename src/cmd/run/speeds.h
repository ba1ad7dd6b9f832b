/* Revolutions per minute instead of tip speeds.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_RUN_SPEEDS_H
#define TIPSPEED_CMD_RUN_SPEEDS_H

#include "cmd/lang/parse.h"
#include "cmd/session/session.h"

/* Converts each speed typed in rpm to m/s: "1450rpm", "from=1450rpm",
 * "speeds=1300..1500:100rpm".  The rotor diameter is that of rotor_mm= in the
 * line, else that of the current site.  If a command has the option rpm=, a
 * single speed becomes that option.  Returns false with an error if no diameter
 * is known. */
bool speeds_convert_from_rpm(struct session *s, struct words *words,
    struct place place, struct error *error);

/* Turns several speeds after a command into "speeds=69,74,79" if the command,
 * or one that it stands for, has a list of them: "predict 69 74 79", "card 70
 * 75", "card 68 to 78".  Notes that "69,74" is read as one speed. */
void speeds_join_words_to_list(struct session *s, struct words *words);

#endif

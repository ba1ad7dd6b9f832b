/* Speeds as typed: several in a row, and rpm instead of m/s.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_RUN_SPEEDS_H
#define TIPSPEED_CMD_RUN_SPEEDS_H

#include "cmd/lang/parse.h"
#include "cmd/session/session.h"

/* Converts each speed typed in rpm to m/s: "1450rpm", "from=1450rpm",
 * "speeds=1300..1500:100rpm".  The diameter of the rotor is that of rotor_mm=
 * in the line, or else that of the current site.  If the command has the option
 * rpm=, a single speed becomes that option.  Returns false with an error if no
 * diameter is known. */
bool speeds_convert_from_rpm(struct session *s, struct words *words,
    struct place place, struct error *error);

/* Turns several speeds after the name of a command into "speeds=69,74,79":
 * "predict 69 74 79", "card 70 75", "card 68 to 78", "card 68-78".  Only if the
 * command, or one that may be meant instead, has the option speeds=.  Notes
 * that "69,74" was read as a single speed. */
void speeds_join_words_to_list(struct session *s, struct words *words);

#endif

/* Revolutions per minute in the place of tip speeds.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_RUN_TURNS_H
#define TIPSPEED_CMD_RUN_TURNS_H

#include "cmd/lang/parse.h"
#include "cmd/session/session.h"

/* Puts m/s in the place of each speed that is typed in revolutions per minute:
 * "1450rpm", "from=1450rpm", "speeds=1300..1500:100rpm".  The diameter is that
 * of rotor_mm= in the line, else that of the site in use.  Where a command has
 * the option rpm=, a single speed becomes that option.  False, with an error,
 * where no diameter is known. */
bool turns_to_speeds(struct session *s, struct words *words, struct place place,
    struct error *error);

/* Makes "speeds=69,74,79" of several speeds behind a command that has a list
 * of them, or stands for one that has: "predict 69 74 79", "card 70 75". */
void speeds_join(struct words *words, bool prompt);

#endif

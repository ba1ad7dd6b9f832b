/* Runs command lines for the full screen, with all they print kept off it.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_UI_CONTROL_H
#define TIPSPEED_UI_CONTROL_H

#include "ui/tui_state.h"

/* A full screen on a session, as it opens, and its end: what runs is stopped
 * and kept, and the session has its ways again. */
void control_begin(
    struct tui *t, struct session *s, const struct tui_ways *ways);
void control_end(struct tui *t);

/* The one that is open, or NULL. */
const struct tui *control_open(void);

/* Runs a line that a key composed, and shows it.  False with a message where
 * it failed. */
bool control_run(struct tui *t, const char *line);

/* The same for a typed line: what it prints is shown, but of a prediction that
 * the page shows; control_show: that, too. */
void control_typed(struct tui *t, const char *line);
void control_show(struct tui *t, const char *line);

/* Predicts at the slider's speed, where there is something to predict with and
 * it is not done already. */
void control_predict(struct tui *t);

/* Looks what the session is like after a command that was not run here. */
void control_look(struct tui *t);

/* Some steps of the calibration that runs, as many as are due. */
void control_pump(struct tui *t);

/* Lets the calibration that runs wait, or go on; makes one step of it. */
void control_hold(struct tui *t, bool hold);
void control_step(struct tui *t);

/* Stops the calibration that runs and keeps its best. */
void control_keep(struct tui *t);

#endif

/* Runs a calibration while the full screen shows it.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TUI_WATCH_H
#define TIPSPEED_TUI_WATCH_H

#include "tui/tui_state.h"

/* Runs those steps of the calibration that are due. */
void watch_run_due_fit_steps(struct tui *t);

/* watch_set_fit_paused pauses or continues the calibration; watch_run_fit_step
 * runs one step of it. */
void watch_set_fit_paused(struct tui *t, bool hold);
void watch_run_fit_step(struct tui *t);

/* Stops the running calibration (session_stop_job_for_user) and shows the
 * outcome. Returns it in words to append to another message, or "" if none ran.
 */
const char *tui_stop_fit(struct tui *t);

#endif

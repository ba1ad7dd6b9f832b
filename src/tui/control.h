/* Runs command lines for the full screen and keeps their output off it.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TUI_CONTROL_H
#define TIPSPEED_TUI_CONTROL_H

#include "tui/tui_state.h"
#include "tui/view.h"

/* control_open_screen opens a full screen on a session.  control_close_screen
 * closes it, pauses a running calibration, and restores the session's streams
 * and hooks. */
void control_open_screen(
    struct tui *t, struct session *s, const struct tui_callbacks *callbacks);
void control_close_screen(struct tui *t);

/* Returns the full screen if it is open, or else NULL. */
struct tui *control_current_screen(void);

/* Runs a line composed by a key, and shows it as the last command.  If it
 * fails, shows the error and returns false. */
bool control_run_command_captured(struct tui *t, const char *line);

/* Brings the state of the screen up to date after a command that was run
 * elsewhere. */
void control_discard_outdated_state(struct tui *t);

/* ---- For cmdline.c ---- */

/* Returns the command in a line, or NULL if there are several or it is
 * unknown. */
const struct command *control_command_of_line(const char *line);

/* Stores the page and the quantity shown as settings, for save and restore. */
void control_store_page_settings(struct tui *t);

/* Says that a speed, m/s, is outside the slider's range, and how to extend the
 * range. */
void control_report_speed_off_slider(struct tui *t, double speed);

#endif

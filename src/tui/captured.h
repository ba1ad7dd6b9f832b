/* What commands say while a full screen is open, kept off it until it is shown.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TUI_CAPTURED_H
#define TIPSPEED_TUI_CAPTURED_H

#include "tui/tui_state.h"

/* Forgets what was said before. */
void captured_forget(struct tui *t);

/* See struct driver, of = struct tui *: the line itself stands on the screen.
 */
void captured_error(
    void *of, const struct error *e, const char *line, const char *name);

/* Shows what was said: one line is a message, more take the whole screen. */
void captured_show(struct tui *t);

#endif

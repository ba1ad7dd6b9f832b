/* Captures the output of commands while the full screen is open, until it is
 * shown.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TUI_CAPTURED_H
#define TIPSPEED_TUI_CAPTURED_H

#include "tui/tui_state.h"

/* Discards what was captured so far.  Output that follows is formatted for this
 * screen, without escape sequences. */
void captured_discard_output(struct tui *t);

/* The `fail` of struct driver: shows an error as the message, without the line,
 * which is already on the screen.  of: a struct tui *. */
void captured_show_error(
    void *of, const struct error *e, const char *line, const char *name);

/* Shows the output: a single line as a message, several on the whole screen. */
void captured_show_output(struct tui *t);

#endif

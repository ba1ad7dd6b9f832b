/* Captures the output of commands while the full screen is open, until it is
 * shown.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TUI_CAPTURED_H
#define TIPSPEED_TUI_CAPTURED_H

#include "tui/tui_state.h"

/* Discards earlier output. */
void captured_discard_output(struct tui *t);

/* See `fail` in struct driver; of: a struct tui *.  The line itself is already
 * on the screen. */
void captured_show_error(
    void *of, const struct error *e, const char *line, const char *name);

/* Shows the output: a single line as a message, several on the whole screen. */
void captured_show_output(struct tui *t);

#endif

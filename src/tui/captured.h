/* Output of commands while a full screen is open, kept off the screen until it
 * is shown.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TUI_CAPTURED_H
#define TIPSPEED_TUI_CAPTURED_H

#include "tui/tui_state.h"

/* Discards what was printed before. */
void captured_clear(struct tui *t);

/* See `fail` in struct driver, of = struct tui *: the line itself is on the
 * screen already. */
void captured_say_error(
    void *of, const struct error *e, const char *line, const char *name);

/* Shows what was printed: a single line as a message, more on the whole
 * screen. */
void captured_show(struct tui *t);

#endif

/* A question about a sheet on the full screen: a box with the table of its
 * columns and a line for the answer.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TUI_WIDGETS_DIALOG_H
#define TIPSPEED_TUI_WIDGETS_DIALOG_H

#include "cmd/sheets/ask_user.h"
#include "tui/tui_state.h"

/* The `ask` of session->hooks: asks q and returns the answer, which the caller
 * frees, or NULL if the user gave up. */
char *dialog_ask(struct tui *t, const struct user_question *q);

/* Handles a key of the open dialogue. */
enum edit_result dialog_handle_key(struct tui *t, int code, bool special);

/* Draws the dialogue over the screen, at any size, with the cursor in its
 * line. */
void dialog_draw(struct tui *t, int rows, int columns);

#endif

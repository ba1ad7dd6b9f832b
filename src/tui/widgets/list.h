/* The list of a page, or the list over it: keys, mouse and a word after / move
 * through its rows.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TUI_WIDGETS_LIST_H
#define TIPSPEED_TUI_WIDGETS_LIST_H

#include "tui/pane.h"

/* rows_here: true if the page has a list; rows_count: how many of its rows have
 * the word searched for; without a word all. */
bool rows_here(const struct tui *t);
size_t rows_count(const struct tui *t);

/* rows_first returns the first row to draw, so that the row under the cursor is
 * among `room` of them; rows_next the next row after i to draw, at the end at
 * least the number of rows. */
size_t rows_first(struct tui *t, size_t room);
size_t rows_next(const struct tui *t, size_t i);

/* rows_touch: row i is drawn in the area: a click chooses it, a click on the
 * chosen row opens it.  rows_wheel: the wheel scrolls the list in the area. */
void rows_touch(struct tui *t, struct area area, size_t i);
void rows_wheel(struct tui *t, struct area area);

/* See move in page_ops. */
bool rows_move(struct tui *t, const struct key *key);

/* Handles a key while the word is typed; false if it is not for the word. */
bool rows_letter(struct tui *t, int code, bool special);

/* Clears the word; false if there was none. */
bool rows_forget(struct tui *t);

#endif

/* The list of a page, or that over it: keys, mouse and a word after / go
 * through its rows.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TUI_WIDGETS_LIST_H
#define TIPSPEED_TUI_WIDGETS_LIST_H

#include "tui/pane.h"

/* Whether there is one; how many of its rows have the word that is looked for:
 * without a word all have. */
bool rows_here(const struct tui *t);
size_t rows_count(const struct tui *t);

/* The first to draw, so that the one under the cursor is among `room` of them;
 * and the next one after i to draw, at least the number of rows at the end. */
size_t rows_first(struct tui *t, size_t room);
size_t rows_next(const struct tui *t, size_t i);

/* A row that is drawn there: a click chooses it, one on the chosen row opens
 * it.  rows_wheel: the wheel goes through the list there. */
void rows_touch(struct tui *t, struct area area, size_t i);
void rows_wheel(struct tui *t, struct area area);

/* See move in page_ops. */
bool rows_move(struct tui *t, const struct key *key);

/* A key while the word is typed; false: it is none of the word's. */
bool rows_letter(struct tui *t, int code, bool special);

/* No word any more; false: there was none. */
bool rows_forget(struct tui *t);

#endif

/* The list of a page, or the list over it: keys, mouse and a word move through
 * its rows.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TUI_WIDGETS_LIST_H
#define TIPSPEED_TUI_WIDGETS_LIST_H

#include "tui/pane.h"

/* rows_here: true if there is a list with rows; rows_count: how many of its
 * rows have the word searched for; without a word all. */
bool rows_here(const struct tui *t);
size_t rows_count(const struct tui *t);

/* Draws row i of a list; look: of its text; of: as given to rows_draw. */
typedef void row_way(struct tui *t, const struct area *line, size_t i,
    unsigned look, const void *of);

/* Draws the rows that there is room for, with the one under the cursor.  A
 * click selects a row; a click on the selected row opens it.  Returns how many
 * were drawn. */
int rows_draw(
    struct tui *t, const struct area *area, row_way *draw, const void *of);

/* The wheel scrolls the list in the area. */
void rows_wheel(struct tui *t, struct area area);

/* See move in page_ops. */
bool rows_move(struct tui *t, const struct key *key);

/* Handles a key while the word is typed; false if it is not for the word. */
bool rows_letter(struct tui *t, int code, bool special);

/* Clears the word; false if there was none. */
bool rows_forget(struct tui *t);

#endif

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

/* A column of a list.  least: columns of the screen below which it is not
 * shown, if its texts take as many; rank: columns of low rank get room first;
 * indent: that of its heading; right: numbers; fixed: as wide as `least`,
 * whatever its texts take. */
struct list_column {
	const char *head;
	int least, rank, indent;
	bool right, fixed;
};

/* The n columns of a list.  cell: the text of a row there; series: the colour
 * of a text that has one, else false; sort: a heading was clicked; then the
 * column that ui.sort names is marked.  These two may be NULL. */
struct list_table {
	const struct list_column *column;
	int n;
	void (*cell)(
	    const struct tui *t, size_t i, int column, char *text, size_t n);
	bool (*series)(const struct tui *t, size_t i, int column,
	    const char *text, enum series *series);
	void (*sort)(struct tui *t, int column);
};

/* table_measure finds how wide the texts of `rows` rows make each column, a gap
 * included; table_share how wide each is drawn where there is less room, 0: not
 * at all.  table_draw draws headings and rows. */
void table_measure(const struct tui *t, const struct list_table *table,
    size_t rows, int wanted[static LIST_COLUMNS]);
void table_share(const struct list_table *table, int columns,
    const int wanted[static LIST_COLUMNS], int width[static LIST_COLUMNS]);
void table_draw(struct tui *t, const struct area *area,
    const struct list_table *table, const int wanted[static LIST_COLUMNS]);

/* The wheel scrolls the list in the area. */
void rows_wheel(struct tui *t, struct area area);

/* See move in page_ops. */
bool rows_move(struct tui *t, const struct key *key);

/* Handles a key while the word is typed; false if it is not for the word. */
bool rows_letter(struct tui *t, int code, bool special);

/* Clears the word; false if there was none. */
bool rows_forget(struct tui *t);

#endif

/* The list on a page or over it: keys, the mouse and a search word move through
 * its rows.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TUI_WIDGETS_LIST_H
#define TIPSPEED_TUI_WIDGETS_LIST_H

#include "tui/pane.h"

/* list_has_rows returns true if there is a list with rows; list_count_matching
 * returns the number of rows that contain the search word, or of all without a
 * word. */
bool list_has_rows(const struct tui *t);
size_t list_count_matching(const struct tui *t);

/* Draws row i of a list.  look: of its text; of: as passed to list_draw_rows.
 */
typedef void row_drawer(struct tui *t, const struct area *line, size_t i,
    unsigned look, const void *of);

/* Draws as many rows as fit, including the one under the cursor.  A click
 * selects a row; a click on the selected row opens it.  Returns the number
 * drawn. */
int list_draw_rows(
    struct tui *t, const struct area *area, row_drawer *draw, const void *of);

/* A column of a list.  least: minimum width, if its texts need that much; with
 * less it is not shown.  rank: columns with a low rank get room first; indent:
 * of its heading; right: right-aligned, for numbers; fixed: always `least`
 * wide. */
struct list_column {
	const char *head;
	int least, rank, indent;
	bool right, fixed;
};

/* The n columns of a list.  cell returns the text of a row in a column, which
 * the caller frees.  series
 * finds the colour of a text, or returns false; sort handles a click on a
 * heading; with it, the column in ui.sort is marked.  These two may be NULL. */
struct list_table {
	const struct list_column *column;
	int n;
	char *(*cell)(const struct tui *t, size_t i, int column);
	bool (*series)(const struct tui *t, size_t i, int column,
	    const char *text, enum series *series);
	void (*sort)(struct tui *t, int column);
};

/* table_measure_columns finds the width that the texts of `rows` rows need in
 * each column, including a gap; table_fit_columns fits the widths into
 * `columns`, with 0 for columns not drawn.  table_draw draws headings and rows.
 */
void table_measure_columns(const struct tui *t, const struct list_table *table,
    size_t rows, int wanted[static LIST_COLUMNS]);
void table_fit_columns(const struct list_table *table, int columns,
    const int wanted[static LIST_COLUMNS], int width[static LIST_COLUMNS]);
void table_draw(struct tui *t, const struct area *area,
    const struct list_table *table, const int wanted[static LIST_COLUMNS]);

/* The wheel scrolls the list in the area. */
void list_add_wheel_area(struct tui *t, struct area area);

/* See move in page_ops. */
bool list_handle_move_key(struct tui *t, const struct key *key);

/* Handles a key while the word is typed.  Returns false if it is not for the
 * word. */
bool list_handle_filter_key(struct tui *t, int code, bool special);

/* Clears the word.  Returns false if there was none. */
bool list_clear_filter(struct tui *t);

#endif

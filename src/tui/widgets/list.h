/* The list on a page or over it: keys, the mouse and a filter word move through
 * its rows.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TUI_WIDGETS_LIST_H
#define TIPSPEED_TUI_WIDGETS_LIST_H

#include "tui/pane.h"

/* list_has_rows returns true if there is a list that has rows;
 * list_count_matching_rows returns the number of rows that contain the filter
 * word, or of all rows without a word. */
bool list_has_rows(const struct tui *t);
size_t list_count_matching_rows(const struct tui *t);

/* Draws row i of a list in `line`.  look: of its text.  of: as passed to
 * list_draw_rows. */
typedef void row_drawer(struct tui *t, const struct area *line, size_t i,
    unsigned look, const void *of);

/* Draws as many rows as fit, including the one under the cursor.  A click on a
 * row selects it; a click on the selected row opens it.  Returns the number of
 * rows drawn. */
int list_draw_rows(
    struct tui *t, const struct area *area, row_drawer *draw, const void *of);

/* A column of a list.  least: minimum width, or less if its texts are narrower;
 * with less room it is not shown.  rank: 0, 1 .. n - 1, each once; columns with
 * a low rank get room first.  indent: of its heading.  right: right-aligned,
 * for numbers.  fixed: always `least` wide. */
struct list_column {
	const char *head;
	int least, rank, indent;
	bool right, fixed;
};

/* The n columns of a list.  cell returns the text of row i in a column, which
 * the caller frees.  series finds the colour of a text, or returns false.  sort
 * handles a click on a heading; if it is not NULL, the heading of the column in
 * ui.sort is marked.  series and sort may be NULL. */
struct list_table {
	const struct list_column *column;
	int n;
	char *(*cell)(const struct tui *t, size_t i, int column);
	bool (*series)(const struct tui *t, size_t i, int column,
	    const char *text, enum series *series);
	void (*sort)(struct tui *t, int column);
};

/* table_measure_columns finds the width that the texts of all rows need in each
 * column, with a gap.  table_fit_columns fits these widths into `columns`;
 * columns that are not drawn get 0.  table_draw draws headings and rows. */
void table_measure_columns(const struct tui *t, const struct list_table *table,
    size_t rows, int wanted[static LIST_COLUMNS]);
void table_fit_columns(const struct list_table *table, int columns,
    const int wanted[static LIST_COLUMNS], int width[static LIST_COLUMNS]);
void table_draw(struct tui *t, const struct area *area,
    const struct list_table *table, const int wanted[static LIST_COLUMNS]);

/* Makes the wheel scroll the list in an area. */
void list_add_wheel_area(struct tui *t, struct area area);

/* Handles a key that moves, like `move` in page_ops. */
bool list_handle_move_key(struct tui *t, const struct key *key);

/* Handles a key while the filter word is typed.  Returns false if the key is
 * not for the word. */
bool list_handle_filter_key(struct tui *t, int code, bool special);

/* Clears the filter word.  Returns false if there was none. */
bool list_clear_filter(struct tui *t);

#endif

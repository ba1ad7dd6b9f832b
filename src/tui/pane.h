/* The operations of a page of the full screen, the open page, and functions
 * with which pages draw.  Pages draw from the state; only `update` computes.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TUI_PANE_H
#define TIPSPEED_TUI_PANE_H

#include "tui/tui_state.h"

/* Rows through which a cursor moves, see list.h.  n returns their number.  id
 * returns a number that identifies a row in any order; if NULL, its index does.
 * text returns a text of the row to search besides its columns; the caller
 * frees it.  chosen is called when the cursor has moved, open for Enter.
 * update computes what is shown.  table: the columns.  All but n may be
 * NULL. */
struct list_table;
struct page_list {
	size_t (*n)(const struct tui *t);
	size_t (*id)(const struct tui *t, size_t i);
	char *(*text)(const struct tui *t, size_t i);
	void (*chosen)(struct tui *t), (*open)(struct tui *t),
	    (*update)(struct tui *t);
	const struct list_table *table;
};

/* The operations of a page, which are defined in its own file.  Those that it
 * does not need are NULL. */
struct page_ops {
	/* The row of hints, see keys_hint_row_text; if hints is NULL, hints_now
	 * returns it. */
	const char *hints;
	const char *(*hints_now)(const struct tui *t);
	/* Columns of its side panel: by default; from 100 screen columns (0: as
	 * by default); from 120. */
	int side, middle_side, wide_side;
	bool differences, strip; /* see struct layout_ask */

	/* Returns the rows of the list to which the body is reduced now, or
	 * 0. */
	int (*list_rows)(const struct tui *t);

	/* Computes anything drawn that is not part of the prediction. */
	void (*update)(struct tui *t);

	/* Draws the body. */
	void (*draw)(struct tui *t);

	/* Draws its own caption above the track.  Returns false if the usual
	 * caption is to be drawn instead. */
	bool (*caption)(struct tui *t, const struct area *area);

	/* Its list, for keys and the mouse. */
	const struct page_list *list;

	/* Handles act_move_list_or_slider, act_move_to_end and act_move_in_list
	 * on the page. If it returns false, they act on its list, or else on
	 * the slider. */
	bool (*move)(struct tui *t, const struct key *key);

	/* Handles a click on its plot of that kind, at these values of the
	 * axes. */
	void (*point)(struct tui *t, enum plot_kind kind, double x, double y);

	/* Returns the name of its plot for `describe`, which the caller frees.
	 * If it is NULL, the plot is the curves. */
	char *(*words)(const struct tui *t);
};

#define PAGE_DECLARED(NUMBER, name, heading, key) \
	extern const struct page_ops page_##name;
SCREEN_PAGES(PAGE_DECLARED)

/* The names of the pages in the heading. */
extern const char *const PAGE_HEADINGS[PAGES];

/* pages_current returns the open page; pages_go_to opens a page. */
const struct page_ops *pages_current(const struct tui *t);
void pages_go_to(struct tui *t, enum page page);

/* Updates what is shown besides the prediction: the list of files if it is
 * open, the response strip and the goal, and the open page (`update` in
 * page_ops). */
void pages_update(struct tui *t);

/* Draws a plot in an area, or says why there is none.  A click on it says what
 * is there (see point in page_ops).  The plot is of the current site unless the
 * request names an entry; then a click does nothing. */
void pane_draw_plot(
    struct tui *t, const struct plot_request *request, const struct area *area);

/* Draws curves in the plot area, with a legend below if there is room.  notes:
 * also draw the chart's notes, because no side panel shows what they say. */
void pane_draw_curves(struct tui *t, struct plot_request *request, bool notes);

/* Returns the name of the curves for `describe`.  The caller frees it. */
char *pane_curves_plot_arguments(const struct tui *t);

/* Returns the body including the row of the legend, which a list does not
 * need. */
struct area pane_list_area(const struct tui *t);

/* pane_draw_key_hints draws the row of hints, which are separated by two
 * spaces, up to the first that does not fit.  Each hint begins with the name of
 * its key, or of two, in bold: "Up/Down site".  pane_make_hints_clickable lets
 * a click on a name press that key. */
void pane_draw_key_hints(struct tui *t, const char *hints);
void pane_make_hints_clickable(
    struct tui *t, int row, int column, const char *hints);

/* Draws a line being typed, after its prompt, scrolled to show the cursor.
 * Returns the cursor's column.  Sets *from to the offset of the first byte
 * shown. */
int pane_draw_typed_line(const struct area *area, const char *prompt,
    const struct edit *typing, size_t *from);

/* Draws "/" and the word being searched for, then `found`, which says how many
 * were found, and, if there is room, the keys of the search.  found NULL: only
 * the word.  Returns the cursor's column. */
int pane_draw_search_word(struct tui *t, const struct area *area,
    const char *word, const char *found, const char *keys);

/* Draws lines of text from a row down, the first in bold. */
void pane_draw_text_lines(const struct area *area, int row, const char *text);

/* Returns an index in a list of n, moved by `by` and clamped. */
size_t pane_move_index_clamped(size_t at, int by, size_t n);

#endif

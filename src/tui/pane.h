/* The operations of a page of the full screen, and what pages draw with.  Pages
 * draw from the state; only `update` computes.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TUI_PANE_H
#define TIPSPEED_TUI_PANE_H

#include "tui/tui_state.h"

/* Rows that a cursor moves through, see list.h.  n: how many; id: what the
 * cursor is on in a row, whatever their order; NULL: its number; text: returns
 * the text of a row beside its columns, to search for a word, which the caller
 * frees; chosen: called when the cursor has moved; open: what Enter does there;
 * update: computes what is shown of the list; table: its columns.  Each of
 * these may be NULL. */
struct list_table;
struct page_list {
	size_t (*n)(const struct tui *t);
	size_t (*id)(const struct tui *t, size_t i);
	char *(*text)(const struct tui *t, size_t i);
	void (*chosen)(struct tui *t), (*open)(struct tui *t),
	    (*update)(struct tui *t);
	const struct list_table *table;
};

/* The operations of a page, which are in its own file; pages.c lists the pages.
 * Operations that a page does not need are NULL. */
struct page_ops {
	const char *name;  /* in the heading */
	const char *hints; /* its keys, see keys_bar; or NULL: */
	const char *(*hints_now)(const struct tui *t);
	/* Columns of its side panel; the same on screens of 100 columns or
	 * more, or 0: no other; of 120 or more. */
	int side, middle_side, wide_side;
	bool differences, strip; /* see struct layout_ask */

	/* Computes what is drawn but does not come with the prediction. */
	void (*update)(struct tui *t);

	/* Draws the body. */
	void (*draw)(struct tui *t);

	/* Draws its own caption of the track; false: the usual one. */
	bool (*caption)(struct tui *t, const struct area *area);

	/* Its list, for keys and mouse. */
	const struct page_list *list;

	/* Handles act_move, act_ends and act_list on the page; false: they act
	 * on its list, else on the slider. */
	bool (*move)(struct tui *t, const struct key *key);

	/* A click on its plot, at values of the axes of that kind. */
	void (*point)(struct tui *t, enum plot_kind kind, double x, double y);

	/* Returns the name of its picture for `describe`, which the caller
	 * frees; NULL: the curves. */
	char *(*words)(const struct tui *t);
};

extern const struct page_ops page_predict, page_fit, page_data, page_parity,
    page_sites;

/* Draws a plot in an area, or says why there is none.  A click on it says what
 * is there, see point in page_ops, unless the request names an entry: without
 * one it is of the site in use. */
void pane_plot(
    struct tui *t, const struct plot_request *request, const struct area *area);

/* Draws curves in the plot area, with a legend below them where there is room.
 * notes: they show what the side panel does not. */
void pane_curves(struct tui *t, struct plot_request *request, bool notes);

/* Returns the name of the curves for `describe`.  The caller frees. */
char *pane_curves_words(const struct tui *t);

/* Returns the body with the row of the legend, which a list does not have. */
struct area pane_list_area(const struct tui *t);

/* pane_hints draws the row of hints, with two spaces between them; a hint that
 * does not fit is left out as a whole.  pane_touch_hints: each hint begins with
 * the name of its key, "Up/Down site" with two, and a click on a name presses
 * that key. */
void pane_hints(struct tui *t, unsigned look, const char *hints);
void pane_touch_hints(struct tui *t, int row, int column, const char *hints);

/* Draws a line being typed, after its prompt; one too long is moved to the left
 * until the cursor is seen.  Returns the cursor's column; from: offset of the
 * first byte shown. */
int pane_typed(const struct area *area, const char *prompt,
    const struct edit *typing, size_t *from);

/* Draws a word being searched for, after /, with how many match, or NULL, and
 * where there is room the keys of the search.  Returns the cursor's column. */
int pane_word(struct tui *t, const struct area *area, const char *word,
    const char *found, const char *keys);

/* Draws lines of text from a row on, the first one bold.  Returns the row after
 * them. */
int pane_lines(const struct area *area, int row, const char *text);

/* Returns a place in a list of n, moved by `by` and kept within it. */
int pane_moved(int at, int by, size_t n);

#endif

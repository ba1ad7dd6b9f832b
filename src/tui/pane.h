/* What a page of the full screen is, and what pages draw with.  They draw from
 * the state and compute nothing.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TUI_PANE_H
#define TIPSPEED_TUI_PANE_H

#include "tui/tui_state.h"

/* Rows that a cursor goes through, see list.h.  at: the one under it; go: puts
 * it onto another one; text: all that a row says, for a word to be looked for
 * in, which the caller frees, or NULL; open: what Enter does there, or NULL;
 * update: works out what is shown of it, or NULL. */
struct page_list {
	size_t (*n)(const struct tui *t);
	size_t (*at)(const struct tui *t);
	void (*go)(struct tui *t, size_t i);
	char *(*text)(const struct tui *t, size_t i);
	void (*open)(struct tui *t);
	void (*update)(struct tui *t);
};

/* All that there is of a page is in its own file; pages.c lists them.  What a
 * page has no use for is NULL. */
struct page_ops {
	const char *name;  /* in the heading */
	const char *hints; /* of its keys, two spaces between them; or NULL: */
	const char *(*hints_now)(const struct tui *t);
	/* Columns of its panel; on screens of 100 or more, or 0: no other; of
	 * 120 or more. */
	int side, middle_side, wide_side;
	bool differences, strip; /* see struct layout_ask */

	/* Works out what is drawn and does not come with the prediction. */
	void (*update)(struct tui *t);

	/* Draws the body. */
	void (*draw)(struct tui *t);

	/* Draws its own caption of the track; false: the usual one. */
	bool (*caption)(struct tui *t, const struct area *area);

	/* Its list, which keys and mouse go through. */
	const struct page_list *list;

	/* What act_move, act_ends and act_list do to what it has; false: what
	 * they do to its list, else to the slider. */
	bool (*move)(struct tui *t, const struct key *key);

	/* A click on its plot, at values of the axes of that kind. */
	void (*point)(struct tui *t, enum plot_kind kind, double x, double y);

	/* The picture as `describe` names it, which the caller frees; NULL: the
	 * curves. */
	char *(*words)(const struct tui *t);
};

extern const struct page_ops page_predict, page_fit, page_data, page_parity,
    page_sites;

/* A plot in an area, or in words why there is none.  A click on it says what
 * is there; see point in page_ops. */
void pane_plot(
    struct tui *t, const struct plot_request *request, const struct area *area);

/* Curves in the plot area, with a legend below them where there is room.
 * notes: they show what the side panel does not. */
void pane_curves(struct tui *t, struct plot_request *request, bool notes);

/* The curves, as `describe` names them.  The caller frees. */
char *pane_curves_words(const struct tui *t);

/* The body with the row of the legend: a list has none. */
struct area pane_list_area(const struct tui *t);

/* The row of hints, two spaces between them: what does not fit is left out by
 * whole ones.  pane_touch_hints: each begins with the name of its key, "Up/Down
 * site" with those of two, and a click there presses it. */
void pane_hints(struct tui *t, unsigned look, const char *hints);
void pane_touch_hints(struct tui *t, int row, int column, const char *hints);

/* A line that is typed, after its prompt; one too long is moved to the left
 * until the cursor is seen.  Returns the cursor's column; from: of its bytes
 * the first that is shown. */
int pane_typed(const struct area *area, const char *prompt,
    const struct edit *typing, size_t *from);

/* A word that is looked for, after /, with how many have it, or NULL, and where
 * there is room the keys that are its own.  Returns the cursor's column. */
int pane_word(struct tui *t, const struct area *area, const char *word,
    const char *found, const char *keys);

/* Leaves out words, two spaces between them, that there is no room for. */
void pane_cut(char *words, int columns);

/* A place in a list of n, moved and kept within it. */
int pane_moved(int at, int by, size_t n);

#endif

/* The parts of the full screen: each draws from the state and computes nothing.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_UI_PANE_H
#define TIPSPEED_UI_PANE_H

#include "ui/tui_state.h"

/* Keys with a name, for who does not know ncurses. */
extern const int PANE_PAGE_UP, PANE_PAGE_DOWN, PANE_MOUSE, PANE_BACKSPACE,
    PANE_ENTER;

/* One frame, with the cursor on the focus. */
void pane_draw(struct tui *t);

/* The track of the slider without its ends, in the frame that was drawn. */
struct area pane_track(const struct tui *t);

/* The body of each page. */
void pane_predict(struct tui *t);
void pane_fit(struct tui *t);
void pane_data(struct tui *t);
void pane_parity(struct tui *t);
void pane_sites(struct tui *t);

/* The screen's row of the site under the cursor. */
int pane_site_row(const struct tui *t);

/* A plot in the plot area, or in words why there is none. */
void pane_plot(const struct tui *t, const struct plot_request *request,
    const struct area *area);

/* Curves in the plot area, with a legend below them where there is room. */
void pane_curves(const struct tui *t, struct plot_request *request);

/* The body with the row of the legend: a list has none. */
struct area pane_list_area(const struct tui *t);

/* The side panel of the Predict page. */
void pane_side(struct tui *t);

/* The viewer's text with its hints, and where the cursor is. */
void pane_text(const struct tui *t, int *row, int *column);

/* How many rows a message may have. */
int pane_message_rows(const struct places *l);

/* A row of hints, two blanks between them: what does not fit is left out by
 * whole ones. */
void pane_hints(const struct area *area, unsigned look, const char *hints);

/* The row of numbers that takes the side panel's place. */
void pane_numbers(struct tui *t);

/* The slider of the generations, at the caption's place on the Fit page.
 * Returns the column of the cursor, or -1 where there are no generations. */
int pane_generations(struct tui *t, const struct area *area);

#endif

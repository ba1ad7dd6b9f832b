/* The Predict page's curves, and plots on any page.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "io/units.h"
#include "ui/pane.h"
#include "ui/screen.h"

void
pane_plot(const struct tui *t, const struct plot_request *request,
    const struct area *area)
{
	struct error error = {0};
	struct plot_request r = *request;
	if (area->rows < 1 || area->columns < 1)
		return;
	r.charset = screen_charset();
	struct canvas *canvas =
	    plots_draw(t->session, &r, area->columns, area->rows, &error);
	if (canvas != NULL) {
		screen_canvas(area, canvas);
		canvas_free(canvas);
		return;
	}
	int row = screen_words(area, area->rows / 3, LOOK_BOLD, error.text);
	screen_words(area, row, 0, error.hint);
}

/* Of the run whose sample a prediction takes. */
static int
draw_feed_speed(const struct tui *t, const struct site *site, int column)
{
	char text[16];
	snprintf(text, sizeof text, " %g", site->run[tui_feed(t)].speed);
	return screen_series(
	    &t->places.legend, 0, column, SERIES_FEED, 0, text);
}

/* One row, where the plot's own legend would leave the plot little room. */
static void
draw_legend(const struct tui *t)
{
	static const char marks[] = "v^o";
	const struct area *area = &t->places.legend;
	const struct entry *entry = tui_entry(t);
	bool ascii = screen_charset() == CHARSET_ASCII;
	if (entry == NULL)
		return;
	int column = screen_series(
	    area, 0, 0, SERIES_FEED, 0, ascii ? ". feed" : "\u2508 feed");
	if (entry != NULL && entry->site->individual_feeds)
		column = draw_feed_speed(t, entry->site, column);
	size_t shown = 0;
	for (size_t r = 0; entry != NULL && r < entry->site->n_run; r++) {
		char text[24];
		if (entry->site->run[r].product.n == 0)
			continue;
		snprintf(text, sizeof text, "%c %g", marks[shown % 3],
		    entry->site->run[r].speed);
		column = screen_series(area, 0, column + 2,
		    (enum series)(SERIES_MEASURED_1 + shown % 3), 0, text);
		shown++;
	}
	if (t->now.site[0] == '\0')
		return;
	column = screen_series(area, 0, column + 2, SERIES_PREDICTED, LOOK_BOLD,
	    ascii ? "# predicted" : "\u254C predicted");
	if (t->page == PAGE_PREDICT && t->pin.site[0] != '\0')
		column = screen_series(area, 0, column + 2, SERIES_OTHER, 0,
		    ascii ? "% kept" : "\u2501%\u2501 kept");
	screen_series(area, 0, column + 2, SERIES_BREAK, 0,
	    ascii ? ": break size" : "\u250A break size");
}

void
pane_curves(const struct tui *t, struct plot_request *request)
{
	enum { TALL = 20 };
	struct area plot = t->places.plot;
	bool below = request->kind != PLOT_PSD && t->places.legend.rows > 0;
	if (plot.rows >= TALL || below) {
		bool told = t->page == PAGE_PREDICT && t->places.side.rows > 0;
		request->words |= CHART_LEGEND | (told ? 0 : CHART_NOTES);
		plot.rows += t->places.legend.rows;
	} else if (t->places.legend.rows > 0)
		draw_legend(t);
	pane_plot(t, request, &plot);
}

void
pane_predict(struct tui *t)
{
	const struct prediction *p = &t->session->last;
	struct plot_request request = plots_request(PLOT_PSD);
	request.words = 0;
	request.speed = t->tenths / 10.0;
	request.feed_speed = t->feed;
	request.band = t->band;
	request.level = t->level;
	if (t->pin.site[0] != '\0') {
		request.beside = t->pin.site;
		request.kept = &t->kept;
	}
	if (t->cross && t->cross_at < p->product.n)
		request.crosshair_mm = units_mm(p->product.size[t->cross_at]);
	pane_curves(t, &request);
	pane_side(t);
}

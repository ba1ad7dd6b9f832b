/* The Predict page's curves, and plots on any page.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/text.h"
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

/* A curve's name behind those to its left, where there is room for all of it.
 * Returns the column behind. */
static int
draw_name(const struct tui *t, int column, enum series series, unsigned look,
    const char *text)
{
	const struct area *area = &t->places.legend;
	int from = column > 0 ? column + 2 : 0;
	if (from + text_width(text) > area->columns)
		return column;
	return screen_series(area, 0, from, series, look, text);
}

/* One row, where the plot's own legend would leave the plot little room; the
 * runs are those of plots_psd. */
static void
draw_legend(const struct tui *t)
{
	const struct entry *entry = tui_entry(t);
	bool ascii = screen_charset() == CHARSET_ASCII;
	char text[40], sample[16] = "";
	size_t shown = 0;
	if (entry == NULL)
		return;
	const struct site *site = entry->site;
	if (site->individual_feeds)
		snprintf(
		    sample, sizeof sample, " %g", site->run[tui_feed(t)].speed);
	snprintf(
	    text, sizeof text, "%s feed%s", ascii ? "." : "\u2508", sample);
	int column = draw_name(t, 0, SERIES_FEED, 0, text);
	for (size_t r = 0; r < site->n_run; r++) {
		if (!site_run_is_near(
			site, r, t->tenths / 10.0, PLOTS_MEASURED))
			continue;
		struct chart_series look = plots_look(shown++);
		snprintf(
		    text, sizeof text, "%c %g", look.mark, site->run[r].speed);
		column = draw_name(t, column, look.series, 0, text);
	}
	if (t->now.site[0] == '\0')
		return;
	column = draw_name(t, column, SERIES_PREDICTED, LOOK_BOLD,
	    ascii ? "# predicted" : "\u254C predicted");
	if (t->page == PAGE_PREDICT && t->pin.site[0] != '\0')
		column = draw_name(t, column, SERIES_OTHER, 0,
		    ascii ? "% kept" : "\u2501%\u2501 kept");
	draw_name(t, column, SERIES_BREAK, 0,
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
	const struct prediction *p = &t->shown;
	struct plot_request request = plots_request(PLOT_PSD);
	request.words = 0;
	request.speed = t->tenths / 10.0;
	request.feed_speed = t->feed;
	request.band = t->band;
	if (p->product.n > 0 && t->asked.tenths == t->tenths)
		request.made = p;
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

/* What pages draw with.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "ui/pane.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "base/xalloc.h"
#include "cmd/outlook.h"
#include "ui/screen.h"

struct area
pane_list_area(const struct tui *t)
{
	struct area area = t->places.body;
	area.rows += t->places.legend.rows;
	return area;
}

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

/* A curve's name after those to its left, where there is room for all of it.
 * Returns the column after. */
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
draw_legend(const struct tui *t, const struct plot_request *request)
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
		if (site_run_repeats(site, r) ||
		    !site_run_is_near(
			site, r, t->tenths / 10.0, PLOTS_MEASURED))
			continue;
		struct chart_series look = plots_look(shown++);
		snprintf(
		    text, sizeof text, "%c %g", look.mark, site->run[r].speed);
		column = draw_name(t, column, look.series, 0, text);
	}
	if (t->now.site[0] == '\0')
		return;
	snprintf(text, sizeof text, "%s predicted%s", ascii ? "#" : "\u254C",
	    outlook_short(t->session, &t->shown));
	column = draw_name(t, column, SERIES_PREDICTED, LOOK_BOLD, text);
	if (request->kept != NULL)
		column = draw_name(t, column, SERIES_OTHER, 0,
		    ascii ? "% pinned" : "\u2501%\u2501 pinned");
	draw_name(t, column, SERIES_BREAK, 0,
	    ascii ? ": break size" : "\u250A break size");
}

void
pane_curves(const struct tui *t, struct plot_request *request, bool notes)
{
	enum { TALL = 20 };
	struct area plot = t->places.plot;
	bool below = request->kind != PLOT_PSD && t->places.legend.rows > 0;
	if (plot.rows >= TALL || below) {
		request->words |= CHART_LEGEND | (notes ? CHART_NOTES : 0);
		plot.rows += t->places.legend.rows;
	} else if (t->places.legend.rows > 0)
		draw_legend(t, request);
	pane_plot(t, request, &plot);
}

void
pane_cut(char *words, int columns)
{
	while (text_width(words) > columns) {
		char *cut = NULL;
		for (char *p = strstr(words, "  "); p != NULL;
		     p = strstr(p + 2, "  "))
			cut = p;
		if (cut == NULL)
			break;
		*cut = '\0';
	}
}

void
pane_hints(const struct area *area, unsigned look, const char *hints)
{
	char text[128];
	snprintf(text, sizeof text, "%s", hints);
	pane_cut(text, area->columns);
	screen_text(area, 0, 0, look, "%s", text);
}

char *
pane_curves_words(const struct tui *t)
{
	char *where = tui_where(t), *words = xasprintf("psd %s", where);
	free(where);
	return words;
}

int
pane_moved(int at, int by, size_t n)
{
	int to = at + by;
	return n == 0 || to < 0 ? 0 : to >= (int)n ? (int)n - 1 : to;
}

/* The page Parity: predicted against measured.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "ui/pane.h"

#include "base/xalloc.h"

static void
draw(struct tui *t)
{
	struct plot_request request = plots_request(PLOT_PARITY);
	if (t->places.legend.rows == 0)
		request.words = CHART_TITLE;
	struct area plot = t->places.body;
	plot.rows = t->places.plot.rows + t->places.legend.rows;
	pane_plot(t, &request, &plot);
}

static char *
words(const struct tui *t)
{
	(void)t;
	return xstrdup("parity");
}

const struct page_ops page_parity = {.name = "Parity",
    .hints = "<-/-> speed  ? keys  q quit  " PAGE_HINT "  : command",
    .draw = draw,
    .words = words};

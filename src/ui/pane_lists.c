/* The pages Data, Parity and Sites.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>

#include "cmd/fit.h"
#include "core/predict.h"
#include "io/units.h"
#include "ui/pane.h"
#include "ui/screen.h"

/* Passing of a curve at a size, or a dash where it was not sieved. */
static int
draw_passing(const struct area *area, int row, int column,
    const struct psd *psd, double x, unsigned look)
{
	enum { WIDTH = 9 };
	if (psd->n > 0 && psd_covers(psd, x))
		screen_text(area, row, column, look, "%8.1f",
		    100 * psd_passing(psd, x));
	else
		screen_text(area, row, column, look, "%8s", "-");
	return column + WIDTH;
}

static void
draw_heads(const struct tui *t, const struct area *area)
{
	const struct site *site = tui_entry(t)->site;
	int column = 18;
	screen_text(area, 0, 0, LOOK_BOLD, "%8s %8s", "sieve mm", "feed %");
	for (size_t r = 0; r < site->n_run; r++, column += 9)
		if (site->run[r].product.n > 0)
			screen_text(area, 0, column, LOOK_BOLD, "%7g%s",
			    site->run[r].speed,
			    tui_entry(t)->train[r] ? "*" : " ");
		else
			column -= 9;
	screen_text(area, 0, column, LOOK_BOLD, "%8s", "PRED");
}

void
pane_data(struct tui *t)
{
	const struct area *area = &t->places.body;
	const struct entry *entry = tui_entry(t);
	if (entry == NULL || entry->site->n_run == 0)
		return;
	const struct site *site = entry->site;
	const struct psd *feed = &site->run[0].feed;
	draw_heads(t, area);
	for (size_t i = 0; i < feed->n; i++) {
		double x = feed->size[i];
		int row = (int)i + 1;
		screen_text(area, row, 0, 0, "%8g", units_mm(x));
		int column = draw_passing(area, row, 9, feed, x, 0);
		for (size_t r = 0; r < site->n_run; r++)
			if (site->run[r].product.n > 0)
				column = draw_passing(area, row, column,
				    &site->run[r].product, x, 0);
		draw_passing(
		    area, row, column, &t->session->last.product, x, LOOK_BOLD);
	}
	int row = (int)feed->n + 2;
	screen_text(area, row++, 0, 0,
	    "columns: product at each speed, m/s; * trained on; PRED: at the "
	    "slider");
	if (site->machine[0] != '\0')
		screen_text(area, row++, 0, 0, "machine: %s", site->machine);
	if (site->provenance[0] != '\0')
		screen_text(area, row++, 0, 0, "data: %s", site->provenance);
	screen_text(area, row, 0, LOOK_DIM, ":check looks for slips");
}

void
pane_parity(struct tui *t)
{
	struct plot_request request = plots_request(PLOT_PARITY);
	if (t->places.legend.rows == 0)
		request.words = CHART_TITLE;
	struct area plot = t->places.body;
	plot.rows = t->places.plot.rows + t->places.legend.rows;
	pane_plot(t, &request, &plot);
}

enum { KEY_ENDS = 17, LABEL_ENDS = 50 };

static void
draw_site(const struct tui *t, const struct area *area, int row, size_t i)
{
	const struct entry *e = &t->session->entry[i];
	unsigned look = i == t->site_at ? LOOK_REVERSE : LOOK_PLAIN;
	char *label = session_label(e->site);
	/* Columns are set one by one: names may have wide letters. */
	screen_text(area, row, 0, look, "%*s", area->columns, "");
	screen_text(area, row, 0, look, "%c %s",
	    i == t->session->current ? '*' : ' ', e->key);
	screen_text(area, row, KEY_ENDS, look, "%s", label);
	if (e->has_fit)
		screen_text(area, row, LABEL_ENDS, look, "fit %s, %.2f points",
		    fit_verdict(&e->fit), 100 * e->fit.rmse);
	else
		screen_text(
		    area, row, LABEL_ENDS, look, "%s", session_origin(e));
	free(label);
}

void
pane_sites(struct tui *t)
{
	struct area area = t->places.body;
	const struct session *s = t->session;
	screen_text(&area, 0, 2, LOOK_BOLD, "site");
	screen_text(&area, 0, LABEL_ENDS, LOOK_BOLD, "parameters");
	if (s->n_entry == 0)
		screen_text(&area, 1, 2, 0, "none is loaded: type :load FILE");
	int room = area.rows - 1;
	size_t top = room > 0 && t->site_at >= (size_t)room
			 ? t->site_at - (size_t)room + 1
			 : 0;
	for (size_t i = top; i < s->n_entry; i++)
		draw_site(t, &area, (int)(i - top) + 1, i);
}

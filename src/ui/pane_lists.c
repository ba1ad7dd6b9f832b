/* The pages Data, Parity and Sites.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>

#include "base/xalloc.h"
#include "cmd/fit.h"
#include "core/predict.h"
#include "io/units.h"
#include "ui/pane.h"
#include "ui/screen.h"

/* The body with the row of the legend: a list has none. */
static struct area
list_area(const struct tui *t)
{
	struct area area = t->places.body;
	area.rows += t->places.legend.rows;
	return area;
}

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

/* Whether a run has a column: those that fit beside feed and prediction. */
static bool
has_column(const struct site *site, size_t r, int column, int columns)
{
	return site->run[r].product.n > 0 && column + 2 * 9 <= columns + 1;
}

static void
draw_heads(const struct tui *t, const struct area *area)
{
	const struct site *site = tui_entry(t)->site;
	int column = 18;
	screen_text(area, 0, 0, LOOK_BOLD, "%8s %8s", "sieve mm", "feed %");
	for (size_t r = 0; r < site->n_run; r++)
		if (has_column(site, r, column, area->columns)) {
			screen_text(area, 0, column, LOOK_BOLD, "%7g%s",
			    site->run[r].speed,
			    tui_entry(t)->train[r] ? "*" : " ");
			column += 9;
		}
	screen_text(area, 0, column, LOOK_BOLD, "%8s", "PRED");
}

static void
draw_sieve(const struct tui *t, const struct area *area, int row, double x)
{
	const struct site *site = tui_entry(t)->site;
	screen_text(area, row, 0, 0, "%8g", units_mm(x));
	int column = draw_passing(area, row, 9, &site->run[0].feed, x, 0);
	for (size_t r = 0; r < site->n_run; r++)
		if (has_column(site, r, column, area->columns))
			column = draw_passing(
			    area, row, column, &site->run[r].product, x, 0);
	draw_passing(
	    area, row, column, &t->session->last.product, x, LOOK_BOLD);
}

/* Where the data are from, below them. */
static void
draw_about(const struct site *site, const struct area *area, int row)
{
	char *from = xasprintf("data: %s", site->provenance);
	row = screen_words(area, row, 0,
	    "columns: product at each speed, m/s; * trained on; PRED: at the "
	    "slider");
	if (site->provenance[0] != '\0')
		row = screen_words(area, row, 0, from);
	if (site->machine[0] != '\0')
		screen_text(area, row++, 0, 0, "machine: %s", site->machine);
	screen_text(area, row, 0, LOOK_DIM, ":check looks for slips");
	free(from);
}

void
pane_data(struct tui *t)
{
	const struct area area = list_area(t);
	const struct entry *entry = tui_entry(t);
	if (entry == NULL || entry->site->n_run == 0) {
		screen_text(
		    &area, 0, 0, 0, "no site is loaded: type :load FILE");
		return;
	}
	const struct psd *feed = &entry->site->run[0].feed;
	size_t room = area.rows > 1 ? (size_t)area.rows - 1 : 1;
	size_t most = feed->n > room ? feed->n - room : 0;
	if (t->data_top > most)
		t->data_top = most;
	draw_heads(t, &area);
	int row = 1;
	for (size_t i = t->data_top; i < feed->n; i++)
		draw_sieve(t, &area, row++, feed->size[i]);
	draw_about(entry->site, &area, row + 1);
}

void
pane_parity(struct tui *t)
{
	struct plot_request request = {.kind = PLOT_PARITY,
	    .speed = t->tenths / 10.0,
	    .other_speed = NAN,
	    .crosshair_mm = NAN,
	    .legend = t->places.legend.rows > 0};
	struct area plot = t->places.body;
	plot.rows = t->places.plot.rows + t->places.legend.rows;
	pane_plot(t, &request, &plot);
}

enum { KEY_ENDS = 17, LABEL_ENDS = 50, WIDE = 72 };

/* Where a narrow screen has what is known of the parameters: in the place of
 * the label. */
static int
known_column(const struct area *area)
{
	return area->columns >= WIDE ? LABEL_ENDS : KEY_ENDS;
}

static void
draw_site(const struct tui *t, const struct area *area, int row, size_t i)
{
	const struct entry *e = &t->session->entry[i];
	unsigned look = i == t->site_at ? LOOK_REVERSE : LOOK_PLAIN;
	char *label = session_label(e->site);
	int known = known_column(area);
	/* Columns are set one by one: names may have wide letters. */
	screen_text(area, row, 0, look, "%*s", area->columns, "");
	screen_text(area, row, 0, look, "%c %s",
	    i == t->session->current ? '*' : ' ', e->key);
	if (known > KEY_ENDS)
		screen_text(area, row, KEY_ENDS, look, "%s", label);
	if (e->has_fit)
		screen_text(area, row, known, look, "fit %s, %.2f points",
		    fit_verdict(&e->fit), 100 * e->fit.rmse);
	else
		screen_text(area, row, known, look, "%s", session_origin(e));
	free(label);
}

void
pane_sites(struct tui *t)
{
	const struct area area = list_area(t);
	const struct session *s = t->session;
	screen_text(&area, 0, 2, LOOK_BOLD, "site");
	screen_text(&area, 0, known_column(&area), LOOK_BOLD, "parameters");
	if (s->n_entry == 0)
		screen_text(&area, 1, 2, 0, "none is loaded: type :load FILE");
	int room = area.rows - 1;
	size_t top = room > 0 && t->site_at >= (size_t)room
			 ? t->site_at - (size_t)room + 1
			 : 0;
	for (size_t i = top; i < s->n_entry; i++)
		draw_site(t, &area, (int)(i - top) + 1, i);
}

/* The page Data: the sheet.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "ui/pane.h"

#include <limits.h>
#include <stdio.h>
#include <stdlib.h>

#include "base/xalloc.h"
#include "cmd/fit.h"
#include "core/predict.h"
#include "io/units.h"
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

enum { FIRST = 18, WIDTH = 9 };

/* Columns that the runs at so many speeds take, nearest to the slider's. */
static int
columns_of(const struct tui *t, size_t speeds)
{
	const struct site *site = tui_entry(t)->site;
	int n = 0;
	for (size_t r = 0; r < site->n_run; r++)
		n += site_run_is_near(site, r, t->tenths / 10.0, speeds);
	return n;
}

/* Whether there is room for a run's column: those nearest to the slider's speed
 * come first. */
static bool
is_shown(const struct tui *t, size_t run)
{
	const struct site *site = tui_entry(t)->site;
	int room = (t->places.body.columns - FIRST) / WIDTH - 1;
	size_t speeds = site->n_run;
	while (speeds > 0 && columns_of(t, speeds) > room)
		speeds--;
	return site_run_is_near(site, run, t->tenths / 10.0, speeds);
}

/* The run whose feed the slider predicts with. */
static const struct run *
feed_run(const struct tui *t)
{
	return &tui_entry(t)->site->run[tui_feed(t)];
}

/* Returns the column after the table. */
static int
draw_heads(const struct tui *t, const struct area *area)
{
	const struct site *site = tui_entry(t)->site;
	int column = FIRST;
	char feed[16] = "feed %";
	if (site->individual_feeds)
		snprintf(feed, sizeof feed, "feed@%.4g", feed_run(t)->speed);
	screen_text(area, 0, 0, LOOK_BOLD, "%8s %8s", "sieve mm", feed);
	for (size_t r = 0; r < site->n_run; r++) {
		if (!is_shown(t, r))
			continue;
		char name[32];
		snprintf(name, sizeof name, "%g%s", site->run[r].speed,
		    site->run[r].repeat);
		screen_text(area, 0, column, LOOK_BOLD, "%7s%s", name,
		    tui_entry(t)->train[r] ? "*" : " ");
		column += WIDTH;
	}
	screen_text(area, 0, column, LOOK_BOLD, "%8s", "PRED");
	return column + WIDTH;
}

static void
draw_sieve(const struct tui *t, const struct area *area, int row, size_t i)
{
	const struct site *site = tui_entry(t)->site;
	const struct psd *feed = &feed_run(t)->feed;
	double x = feed->size[i];
	screen_text(area, row, 0, 0, "%8g", units_mm(x));
	int column = draw_passing(area, row, WIDTH, feed, x, 0);
	for (size_t r = 0; r < site->n_run; r++)
		if (is_shown(t, r))
			column = draw_passing(
			    area, row, column, &site->run[r].product, x, 0);
	draw_passing(area, row, column, &t->shown.product, x, LOOK_BOLD);
}

/* Where the data are from, as far as there is room, in SOURCE rows of a wide
 * screen. */
enum { SOURCE = 4 };

static void
draw_source(const struct tui *t, const struct area *area, int row)
{
	const struct site *site = tui_entry(t)->site;
	char *from = xasprintf("data: %s", site->provenance);
	row = screen_words(area, row, 0,
	    "columns: product at each speed, m/s; * training; PRED: at the "
	    "slider");
	if (site->machine[0] != '\0')
		screen_text(area, row++, 0, 0, "machine: %s", site->machine);
	if (site->provenance[0] != '\0')
		row = screen_words(area, row, 0, from);
	screen_text(area, row, 0, LOOK_DIM, ":check looks for typing errors");
	free(from);
}

/* What is left between measured and predicted, where the table leaves room;
 * returns whether it does. */
static bool
draw_residuals(const struct tui *t, int behind)
{
	enum { GAP = 2, LEAST = 50, MOST = 120, TALL = 14 };
	struct area area = pane_list_area(t);
	area.column = behind + GAP;
	area.columns -= behind + GAP;
	area.rows -= SOURCE + 1;
	if (area.columns > MOST)
		area.columns = MOST;
	if (area.columns < LEAST || area.rows < TALL ||
	    !tui_entry(t)->has_params)
		return false;
	struct plot_request request = plots_request(PLOT_RESIDUALS);
	pane_plot(t, &request, &area);
	return true;
}

/* Up and Down scroll where there are more sieves than rows. */
static void
draw_more(const struct area *area, bool above, bool below)
{
	if (above)
		screen_text(area, 1, area->columns - 1, LOOK_BOLD, "^");
	if (below)
		screen_text(
		    area, area->rows - 1, area->columns - 1, LOOK_BOLD, "v");
}

static void
draw(struct tui *t)
{
	enum { GAP = 1 };
	const struct area area = pane_list_area(t);
	const struct entry *entry = tui_entry(t);
	if (entry == NULL || entry->site->n_run == 0) {
		screen_text(
		    &area, 0, 0, 0, "no site is loaded: type :load FILE");
		return;
	}
	size_t n = feed_run(t)->feed.n, row = 1;
	size_t room = area.rows > 1 ? (size_t)area.rows - 1 : 0;
	size_t last = n > room ? n - room : 0;
	t->data_top = t->data_top > last ? last : t->data_top;
	int behind = draw_heads(t, &area);
	for (size_t i = t->data_top; i < n && row <= room; i++, row++)
		draw_sieve(t, &area, (int)row, i);
	draw_more(&area, t->data_top > 0, t->data_top < last);
	int foot = draw_residuals(t, behind) ? area.rows - SOURCE : 0;
	int below = (int)row + GAP;
	draw_source(t, &area, foot > below ? foot : below);
}

static bool
act(struct tui *t, const struct key *key)
{
	if (key->act != ACT_LIST)
		return false;
	t->data_top =
	    (size_t)pane_moved((int)t->data_top, key->amount, INT_MAX);
	return true;
}

const struct page_ops page_data = {.name = "Data",
    .hints = "<-/-> speed  ? keys  q quit  " PAGE_HINT "  Up/Down sieves  "
	     ": command",
    .draw = draw,
    .key = act};

/* Draws a row for each sieve, as many as fit, with passings, difference and a
 * bar.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "tui/widgets/sieve_table.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "base/tr.h"
#include "base/xalloc.h"
#include "cmd/ask/answers.h"
#include "cmd/draw/site_chart.h"
#include "cmd/ask/pin.h"
#include "io/sitefile/units.h"
#include "tui/pane.h"
#include "tui/screen.h"

/* The columns where the differences and the bars begin; a bar needs a few
 * cells. */
enum { COMPARED = 18, BAR = 25, BAR_CELLS = 4 };

/* Returns what the product is compared with: the pinned product, else that of
 * the run measured at the nearest speed, else NULL.  Writes its name and sets
 * *series to its colour. */
static const struct psd *
find_compared_product(
    const struct tui *t, char name[static 40], enum series *series)
{
	const struct site *site = tui_current_site_entry(t)->site;
	const struct run *nearest = NULL;
	if (t->view.pinned.site[0] != '\0') {
		snprintf(name, 40, tr("vs pin"));
		*series = SERIES_OTHER;
		return &t->session->pin->p.product;
	}
	for (size_t r = 0; r < site->n_run && tui_other_feed(t)[0] == '\0';
	     r++) {
		const struct run *run = &site->run[r];
		if (run->product.n > 0 &&
		    (nearest == NULL ||
			fabs(run->speed - t->view.current.speed) <
			    fabs(nearest->speed - t->view.current.speed)))
			nearest = run;
	}
	if (nearest == NULL)
		return NULL;
	FREED char *speed = answers_speed_text(site, nearest->speed, -1);
	if (fabs(nearest->speed - t->view.current.speed) < 0.05)
		snprintf(name, 40, tr("vs %g measured"),
		    answers_speed_in_sheet_unit(site, nearest->speed));
	else
		snprintf(name, 40, tr("vs %s"), speed);
	size_t run = (size_t)(nearest - site->run);
	*series = site_chart_run_style(site, run, false).series;
	return tui_product_adjusted_to_feed(t, run);
}

/* Returns by how many points the product lies above another at sieve i; NAN if
 * the other does not cover it. */
static double
passing_difference_at_sieve(
    const struct tui *t, const struct psd *other, size_t i)
{
	double x = t->view.shown.product.size[i];
	if (other == NULL || !psd_covers_size(other, x))
		return NAN;
	double off =
	    100 * (t->view.shown.product.passing[i] - psd_passing(other, x));
	/* So that 0 has no sign. */
	return fabs(off) < 0.05 ? 0 : off;
}

/* Returns the points that fill a bar.  They change seldom, and not where the
 * scale of the strip of differences does, so that one step of the slider does
 * not redraw both. */
static double
percent_points_of_full_bar(const struct tui *t, const struct psd *other)
{
	static const double FULL[] = {1.5, 3, 7, 15, 30, 70, 100};
	double most = 0;
	size_t at = 0;
	for (size_t i = 0; i < t->view.shown.product.n; i++)
		most =
		    fmax(most, fabs(passing_difference_at_sieve(t, other, i)));
	while (at + 1 < ARRAY_LEN(FULL) && FULL[at] < most)
		at++;
	return FULL[at];
}

/* Draws a bar in eighths, halves or whole cells, as the characters allow, in
 * the colour of the product compared with. */
static void
sieve_table_draw_bar(
    const struct area *area, int row, enum series series, double share)
{
	static const char *const EIGHTH[] = {"", "\u258f", "\u258e", "\u258d",
	    "\u258c", "\u258b", "\u258a", "\u2589"};
	enum charset charset = screen_charset();
	int parts = charset == CHARSET_BRAILLE     ? 8
		    : charset == CHARSET_QUADRANTS ? 2
						   : 1,
	    cells = area->columns - BAR,
	    n = (int)lround(fmin(fabs(share), 1) * cells * parts);
	for (int c = 0; c < n / parts; c++)
		screen_draw_text_in_series_colour(area, row, BAR + c, series, 0,
		    charset == CHARSET_ASCII ? "#" : "\u2588");
	screen_draw_text_in_series_colour(area, row, BAR + n / parts, series, 0,
	    EIGHTH[n % parts * 8 / parts]);
}

static void
on_click_sieve(struct tui *t, const struct mouse_event *touched)
{
	t->ui.crosshair = touched->item < t->view.shown.product.n;
	t->ui.crosshair_sieve = touched->item;
}

static void
draw_sieve_row(
    struct tui *t, const struct area *area, int row, size_t i, double off)
{
	const struct prediction *p = &t->view.shown;
	unsigned look = t->ui.crosshair && t->ui.crosshair_sieve == i
			    ? LOOK_BOLD
			    : LOOK_PLAIN;
	char sieve[24];
	/* A longer name takes a space from the next number. */
	int n = snprintf(
	    sieve, sizeof sieve, "%5g", units_m_to_mm(p->product.size[i]));
	screen_draw_text(area, row, 0, look, "%s%*.1f%6.1f", sieve, 11 - n,
	    100 * p->feed.passing[i], 100 * p->product.passing[i]);
	if (!isnan(off))
		screen_draw_text(area, row, COMPARED, look,
		    off != 0 ? "%+5.1f" : "%5.1f", off);
	hits_add_mouse_handler(
	    &t->hits, HIT_PRESS, area_of_row(area, row), on_click_sieve, i);
}

/* Returns the sieve of row r.  If there are fewer rows than sieves, they are
 * spread from the coarsest sieve that retains feed to the finest, so that they
 * do not change with the speed. */
static size_t
sieve_shown_in_row(const struct tui *t, size_t r, size_t rows)
{
	const double all = 0.9995;
	const struct psd *feed = &t->view.shown.feed;
	size_t first = 0, gaps = rows - 1;
	if (rows >= feed->n || rows < 2)
		return r;
	while (first + rows < feed->n && feed->passing[first] > all)
		first++;
	return first + (r * (feed->n - 1 - first) + gaps / 2) / gaps;
}

/* Returns the row that shows the sieve of the quantity above the track, if need
 * be instead of its own sieve; SIZE_MAX if no row has to.  Sets *sieve to that
 * sieve. */
static size_t
row_for_sieve_of_quantity(const struct tui *t, size_t rows, size_t *sieve)
{
	const struct psd *product = &t->view.shown.product;
	const double same = 1e-3;
	size_t best = 0;
	*sieve = 0;
	while (*sieve < product->n &&
	       fabs(product->size[*sieve] / t->ui.quantity.x - 1) > same)
		++*sieve;
	if (t->ui.quantity.kind != QUANTITY_PASSING || *sieve == product->n ||
	    rows >= product->n)
		return SIZE_MAX;
	for (size_t r = 1; r < rows; r++)
		if (labs((long)sieve_shown_in_row(t, r, rows) - (long)*sieve) <
		    labs(
			(long)sieve_shown_in_row(t, best, rows) - (long)*sieve))
			best = r;
	return best;
}

int
sieve_table_count_rows(const struct tui *t)
{
	return 1 + (int)t->view.shown.product.n;
}

/* Draws "sieve  feed   now vs 74".  For a longer name, moves "now", and finally
 * shortens the name to its speed. */
static void
sieve_table_draw_heading(
    const struct area *area, enum series series, char *name)
{
	enum { FEED_END = 11 };
	const char *now = tr("now");
	const int room =
	    area->columns - FEED_END - text_width_in_columns(now) - 2;
	char *vs = name, *last = strrchr(name, ' ');
	if (text_width_in_columns(name) > area->columns - COMPARED &&
	    last != NULL && strchr(name, ' ') != last)
		*last = '\0';
	if (text_width_in_columns(name) > room && strchr(name, ' ') != NULL)
		vs = strchr(name, ' ') + 1;
	int column = area->columns - text_width_in_columns(vs);
	column = column < COMPARED ? column : COMPARED;
	const char *feed = tr("sieve  feed");
	int gap = column - 1 - text_width_in_columns(now) -
		  text_width_in_columns(feed);
	screen_draw_text(area, 0, 0, LOOK_DIM, "%s%*s%s", feed, gap, "", now);
	screen_draw_text_in_series_colour(area, 0, column, series, 0, vs);
}

void
sieve_table_draw(struct tui *t, const struct area *area)
{
	size_t n = t->view.shown.product.n, rows = (size_t)area->rows - 1;
	char name[40] = "";
	enum series series = SERIES_TEXT;
	const struct psd *other = find_compared_product(t, name, &series);
	double full = percent_points_of_full_bar(t, other);
	sieve_table_draw_heading(area, series, name);
	size_t wanted, at = row_for_sieve_of_quantity(t, rows, &wanted);
	for (size_t r = 0; r < rows && r < n; r++) {
		size_t i = r == at ? wanted : sieve_shown_in_row(t, r, rows);
		double off = passing_difference_at_sieve(t, other, i);
		draw_sieve_row(t, area, (int)r + 1, i, off);
		if (area->columns >= BAR + BAR_CELLS && !isnan(off))
			sieve_table_draw_bar(
			    area, (int)r + 1, series, off / full);
	}
}

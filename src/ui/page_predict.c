/* The page Predict: the curves, and the numbers at the slider's speed.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "ui/page_predict.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "base/xalloc.h"
#include "cmd/answers.h"
#include "cmd/light.h"
#include "io/units.h"
#include "ui/screen.h"

/* Where differences stand. */
enum { CHANGE = 17 };

/* "2.81 mm", or why there is no such number. */
static const char *
size_text(double mm, char text[static 24])
{
	if (isnan(mm))
		snprintf(text, 24, "off sieves");
	else if (isinf(mm))
		snprintf(text, 24, "none");
	else if (mm < 1000 * ANSWERS_NO_SIZE)
		snprintf(text, 24, "all");
	else
		snprintf(text, 24, "%.2f mm", mm);
	return text;
}

/* The same in four characters at most, where there is little room: a number cut
 * by its end would be another. */
static const char *
short_size(double mm, char text[static 24])
{
	if (isnan(mm))
		snprintf(text, 24, "off");
	else if (isinf(mm))
		snprintf(text, 24, "none");
	else
		snprintf(text, 24, "%.*f",
		    mm < 9.995   ? 2
		    : mm < 99.95 ? 1
				 : 0,
		    mm);
	return text;
}

/* "-0.03", what is now less what was; nothing where that is 0 as shown. */
static void
draw_change(
    const struct area *side, int row, double now, double was, int digits)
{
	double least = 0.5 * pow(10, -digits);
	if (isfinite(now) && isfinite(was) && fabs(now - was) >= least)
		screen_text(side, row, CHANGE, 0, "%+.*f", digits, now - was);
}

/* P20, P50 and P80 of shown, and what they are now less what they were; was:
 * NULL for none. */
static int
draw_sizes(const struct tui *t, int row, const struct numbers *shown,
    const struct numbers *was)
{
	static const char *const names[] = {"P20", "P50", "P80"};
	const struct area *side = &t->places.side;
	const struct numbers *now = &t->now;
	bool kept = shown != now, here = now->site[0] != '\0';
	for (size_t i = 0; i < 3; i++, row++) {
		char size[24];
		screen_text(side, row, 0, kept ? 0 : LOOK_BOLD, "%s", names[i]);
		screen_text(
		    side, row, 4, 0, "%s", size_text(shown->size[i], size));
		if (kept && here)
			screen_text(side, row, CHANGE - 4, 0, "now");
		if (here && was != NULL)
			draw_change(side, row, now->size[i], was->size[i], 2);
	}
	return row;
}

/* Shares of the product below some sizes that sand is sold by. */
static int
draw_fractions(const struct tui *t, int row, const struct numbers *was)
{
	static const char *const names[] = {"< 0.063", "0/2", "0/4"};
	const struct area *side = &t->places.side;
	for (size_t i = 0; i < NUMBERS_FRACTIONS; i++) {
		double now = t->now.passing[i];
		if (isnan(now))
			continue;
		screen_text(side, row, 0, 0, "%-8s%5.1f %%", names[i], now);
		if (was != NULL)
			draw_change(side, row, now, was->passing[i], 1);
		row++;
	}
	return row;
}

/* Speed, sizes and break size, with the change since the slider last paused. */
static int
draw_numbers(const struct tui *t, const struct numbers *was)
{
	char size[24];
	const struct area *side = &t->places.side;
	screen_text(side, 0, 0, 0, "%.1f m/s", t->now.speed);
	if (was != NULL && was->speed != t->now.speed)
		screen_text(
		    side, 0, CHANGE - 4, LOOK_DIM, "since %.1f", was->speed);
	int row = draw_sizes(t, 1, &t->now, was);
	screen_text(
	    side, row, 0, 0, "break %s", size_text(t->now.break_mm, size));
	if (was != NULL)
		draw_change(side, row, t->now.break_mm, was->break_mm, 2);
	return row + 1;
}

static int
draw_pin(const struct tui *t, int row)
{
	const struct area *side = &t->places.side;
	if (t->pin.site[0] == '\0')
		return row;
	screen_text(side, row++, 0, LOOK_BOLD, "pinned: %.1f m/s %s",
	    t->pin.speed, t->pin.site);
	return draw_sizes(t, row, &t->pin, &t->pin);
}

/* A row of the crosshair: what a curve passes there, and its size at the
 * level. */
static void
draw_reading(const struct tui *t, int row, unsigned look, const char *name,
    const struct psd *psd)
{
	const struct area *side = &t->places.side;
	double x = t->shown.product.size[t->cross_at];
	char size[24] = "-";
	double mm = 1000 * psd_size(psd, t->level / 100.0);
	if (isfinite(mm))
		size_text(mm, size);
	screen_text(side, row, 0, look, "%-8.8s", name);
	if (psd_covers(psd, x))
		screen_text(
		    side, row, 8, look, "%5.1f %%", 100 * psd_passing(psd, x));
	screen_text(side, row, 15, look, "%9s", size);
}

/* Between which sizes the level lies in the band, mm. */
static void
level_range(const struct prediction *p, int level, double range[2])
{
	double passing = level / 100.0;
	struct psd edge = p->product;
	edge.passing = p->high;
	range[0] = 1000 * psd_size(&edge, passing);
	edge.passing = p->low;
	range[1] = 1000 * psd_size(&edge, passing);
	for (size_t k = 0; k < PSD_SIZES; k++)
		for (size_t i = 0; i < 2 && passing == PSD_PASSING[k]; i++)
			range[i] = 1000 * p->range[k][i];
}

/* One row, or two where there is room: the passing there, and the size at the
 * level. */
static int
draw_cross_band(const struct tui *t, int row, bool sizes)
{
	const struct area *side = &t->places.side;
	const struct prediction *p = &t->shown;
	double range[2];
	if (!t->band || p->low == NULL)
		return row;
	screen_text(side, row++, 0, 0, "band %5.1f .. %.1f %%",
	    100 * p->low[t->cross_at], 100 * p->high[t->cross_at]);
	level_range(p, t->level, range);
	if (sizes && isfinite(range[0]) && isfinite(range[1]))
		screen_text(side, row++, 0, 0, "     %5.2f .. %.2f mm",
		    range[0], range[1]);
	return row;
}

/* What every curve passes at the crosshair, and the sizes at its level; room:
 * rows that may be used. */
static int
draw_cross(const struct tui *t, int row, int room)
{
	const struct area *side = &t->places.side;
	const struct prediction *p = &t->shown;
	const struct site *site = tui_entry(t)->site;
	char name[40];
	int from = row;
	if (!t->cross || t->cross_at >= p->product.n)
		return row;
	snprintf(name, sizeof name, "crosshair %g mm",
	    units_mm(p->product.size[t->cross_at]));
	screen_text(side, row++, 0,
	    t->focus == &page_predict ? LOOK_REVERSE : LOOK_BOLD, "%-18s%4d %%",
	    name, t->level);
	draw_reading(t, row++, 0, "feed", &p->feed);
	int others = 2 + (t->band ? 1 : 0);
	for (size_t r = 0; r < site->n_run; r++) {
		const struct run *run = &site->run[r];
		if (run->product.n == 0 || row - from + others > room)
			continue;
		snprintf(
		    name, sizeof name, "meas %g%s", run->speed, run->repeat);
		draw_reading(t, row++, 0, name, &run->product);
	}
	draw_reading(t, row++, LOOK_BOLD, "PRED", &p->product);
	row = draw_cross_band(t, row, row - from + 2 <= room);
	if (t->pin.site[0] != '\0' && row - from < room)
		draw_reading(t, row++, 0, "pinned", &t->kept.product);
	return row;
}

/* The light of the answer shown, and how far off the model was where it could
 * be tried. */
static void
draw_worth(const struct tui *t, int row)
{
	static const unsigned LOOKS[] = {LOOK_PLAIN, LOOK_BOLD, LOOK_REVERSE};
	const struct area *side = &t->places.side;
	struct trust light = light_of(t->session, tui_entry(t), &t->shown);
	char *words = light.n == 0 ? xasprintf("trust green")
				   : xasprintf("trust %s, %zu reason%s",
					 LIGHT_NAME[light.light], light.n,
					 light.n == 1 ? "" : "s");
	screen_text(side, row++, 0, LOOKS[light.light], "%s", words);
	free(words);
	trust_free(&light);
	if (isfinite(t->holdout))
		screen_text(
		    side, row, 0, 0, "hold-out RMSE %.1f points", t->holdout);
}

/* How far the fit leaves P50 open; the crosshair tells it for any size. */
static int
draw_p50_band(const struct tui *t, int row)
{
	const double *p50 = t->shown.range[1];
	if (t->band && !t->cross && t->shown.low != NULL && isfinite(p50[0]))
		screen_text(&t->places.side, row++, 0, 0,
		    "P50 in %.2f .. %.2f mm", 1000 * p50[0], 1000 * p50[1]);
	return row;
}

static void
draw_side(struct tui *t)
{
	enum { PIN = 4, CROSS = 5, FRACTIONS = 3 };
	const struct area *side = &t->places.side;
	if (side->rows == 0)
		return;
	screen_wall(side->row, side->column - 1, side->rows);
	if (t->now.site[0] == '\0') {
		/* The row of numbers has said it already. */
		const struct entry *entry = tui_entry(t);
		int row = t->places.numbers.rows == 0;
		if (row > 0)
			screen_text(side, 0, 0, 0, "nothing predicted yet");
		screen_text(side, row, 0, 0,
		    entry == NULL                    ? "type :load FILE"
		    : site_products(entry->site) > 0 ? "f calibrates"
						     : "no product: type "
						       ":guess");
		draw_pin(t, 3);
		return;
	}
	const struct numbers *was = t->pause.site[0] != '\0' ? &t->pause : NULL;
	int row = draw_numbers(t, was);
	int pin = t->pin.site[0] != '\0' ? PIN : 0;
	int runs = t->cross ? (int)site_products(tui_entry(t)->site) : 0;
	int cross = t->cross ? CROSS - 1 + runs + (t->band ? 1 : 0) : 0;
	if (row + FRACTIONS + cross + pin <= side->rows)
		row = draw_fractions(t, row, was);
	row = draw_p50_band(t, row);
	if (t->focus == &page_predict && row < side->rows)
		t->cursor = (struct cursor){side->row + row, side->column};
	row = draw_cross(t, row, side->rows - row - pin);
	row = draw_pin(t, row);
	draw_worth(t, row < side->rows - 2 ? side->rows - 2 : row);
}

void
page_predict_numbers(struct tui *t)
{
	const struct area *area = &t->places.numbers;
	const struct prediction *p = &t->shown;
	char a[24], b[24], c[24], d[24];
	if (area->rows == 0)
		return;
	if (t->now.site[0] == '\0')
		screen_text(area, 0, 0, 0,
		    area->columns < 21 ? "not predicted yet"
				       : "nothing predicted yet");
	else if (t->cross && t->cross_at < p->product.n) {
		if (t->focus == &page_predict)
			t->cursor =
			    (struct cursor){area->row, t->places.side.column};
		bool narrow = area->columns < 34;
		double mm = 1000 * psd_size(&p->product, t->level / 100.0);
		screen_text(area, 0, 0, LOOK_BOLD,
		    narrow ? "%g %.1f%% P%d %s mm" : "%g mm %.1f %%  %d %% %s",
		    units_mm(p->product.size[t->cross_at]),
		    100 * p->product.passing[t->cross_at], t->level,
		    narrow ? short_size(mm, a) : size_text(mm, a));
	} else if (area->columns < 34)
		screen_text(area, 0, 0, LOOK_BOLD, "P50 %s P80 %s mm",
		    short_size(t->now.size[1], b),
		    short_size(t->now.size[2], c));
	else if (area->columns < 60)
		screen_text(area, 0, 0, LOOK_BOLD, "P20 %s P50 %s P80 %s mm",
		    short_size(t->now.size[0], a),
		    short_size(t->now.size[1], b),
		    short_size(t->now.size[2], c));
	else
		screen_text(area, 0, 0, LOOK_BOLD,
		    "P20 %s  P50 %s  P80 %s  break size %s",
		    size_text(t->now.size[0], a), size_text(t->now.size[1], b),
		    size_text(t->now.size[2], c),
		    size_text(t->now.break_mm, d));
}

static void
draw(struct tui *t)
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
	pane_curves(t, &request, t->places.side.rows == 0);
	draw_side(t);
}

static bool
can_focus(const struct tui *t)
{
	return t->cross;
}

/* Up is a higher passing. */
static void
move_level(struct tui *t, int by)
{
	enum { STEP = 5, LEAST = 5, MOST = 95 };
	int to = t->level - by * STEP;
	t->level = to < LEAST ? LEAST : to > MOST ? MOST : to;
}

static bool
act(struct tui *t, const struct key *key)
{
	bool moves = key->act == ACT_MOVE || key->act == ACT_LIST;
	if (t->focus != &page_predict || !moves)
		return false;
	/* Sieves stand coarsest first, the plot finest first. */
	if (key->act == ACT_MOVE)
		t->cross_at = (size_t)pane_moved(
		    (int)t->cross_at, -key->amount, t->shown.product.n);
	else
		move_level(t, key->amount);
	return true;
}

void
page_predict_cross(struct tui *t)
{
	t->cross = !t->cross && t->shown.product.n > 0;
	if (t->cross && t->cross_at == 0)
		t->cross_at = t->shown.product.n / 3;
	if (t->cross)
		t->page = PAGE_PREDICT;
	t->focus = t->cross ? &page_predict : NULL;
	if (t->shown.product.n == 0)
		tui_say(t, true, "no prediction yet: f calibrates");
	else if (t->cross)
		tui_say(t, false,
		    "left and right: the sieve; up and down: the passing; Tab: "
		    "the speed again");
}

static char *
words(const struct tui *t)
{
	const struct prediction *p = &t->shown;
	char *words = pane_curves_words(t);
	if (t->pin.site[0] != '\0')
		xappend(
		    &words, " beside=%s other=%.1f", t->pin.site, t->pin.speed);
	if (t->band)
		xappend(&words, " band=on");
	if (t->cross && t->cross_at < p->product.n)
		xappend(&words, " at=%g level=%d",
		    units_mm(p->product.size[t->cross_at]), t->level);
	return words;
}

const struct page_ops page_predict = {.name = "Predict",
    .hints = "<-/-> speed  ? keys  q quit  f fit  : command  c crosshair  x "
	     "pin  e export  u undo",
    .side = 24,
    .wide_side = 24,
    .draw = draw,
    .can_focus = can_focus,
    .key = act,
    .words = words};

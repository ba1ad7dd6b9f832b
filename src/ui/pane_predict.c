/* The Predict page: the curves and the numbers at the slider's speed.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "cmd/fit.h"
#include "core/predict.h"
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
	screen_series(area, 0, column + 2, SERIES_BREAK, 0,
	    ascii ? ": break size" : "\u250A break size");
}

void
pane_curves(const struct tui *t, struct plot_request *request)
{
	enum { TALL = 20 };
	struct area plot = t->places.plot;
	request->legend = plot.rows >= TALL || (request->kind != PLOT_PSD &&
						   t->places.legend.rows > 0);
	if (request->legend)
		plot.rows += t->places.legend.rows;
	else if (t->places.legend.rows > 0 && request->kind == PLOT_PSD)
		draw_legend(t);
	pane_plot(t, request, &plot);
}

/* "2.81 mm", or why there is no such number. */
static const char *
size_text(double mm, char text[static 24])
{
	if (isnan(mm))
		snprintf(text, 24, "off sieves");
	else if (isinf(mm))
		snprintf(text, 24, "none");
	else
		snprintf(text, 24, "%.2f mm", mm);
	return text;
}

/* "-0.03" since the slider last stood still; "" without. */
static const char *
change_text(double now, double before, char text[static 24])
{
	text[0] = '\0';
	if (isfinite(now) && isfinite(before) && fabs(now - before) >= 0.005)
		snprintf(text, 24, "%+.2f", now - before);
	return text;
}

static int
draw_size(
    const struct tui *t, int row, const char *name, double now, double before)
{
	char size[24], change[24];
	bool any = t->pause.site[0] != '\0';
	screen_text(&t->places.side, row, 0, LOOK_BOLD, "%-4s%s", name,
	    size_text(now, size));
	screen_text(&t->places.side, row, 16, 0, "%s",
	    change_text(now, any ? before : NAN, change));
	return row + 1;
}

static int
draw_sizes(const struct tui *t, int row)
{
	char size[24];
	row = draw_size(t, row, "P20", t->now.p20, t->pause.p20);
	row = draw_size(t, row, "P50", t->now.p50, t->pause.p50);
	row = draw_size(t, row, "P80", t->now.p80, t->pause.p80);
	screen_text(&t->places.side, row, 0, 0, "breaks from %s",
	    size_text(t->now.break_mm, size));
	return row + 1;
}

/* Shares of the product below some sizes that sand is sold by. */
static int
draw_fractions(const struct tui *t, int row)
{
	static const double sizes[] = {0.063e-3, 2e-3, 4e-3};
	static const char *const names[] = {"fines <0.063", "0/2", "0/4"};
	const struct psd *product = &t->session->last.product;
	for (size_t i = 0; i < 3; i++)
		if (psd_covers(product, sizes[i]))
			screen_text(&t->places.side, row++, 0, 0,
			    "%-14s%5.1f %%", names[i],
			    100 * psd_passing(product, sizes[i]));
	return row;
}

static int
draw_pin(const struct tui *t, int row)
{
	const struct area *side = &t->places.side;
	const struct numbers *pin = &t->pin, *now = &t->now;
	const char *names[] = {"P20", "P50", "P80"};
	const double kept[] = {pin->p20, pin->p50, pin->p80};
	const double here[] = {now->p20, now->p50, now->p80};
	if (pin->site[0] == '\0')
		return row;
	screen_text(
	    side, row++, 0, LOOK_BOLD, "kept: %s %.1f", pin->site, pin->speed);
	for (size_t i = 0; i < 3; i++) {
		char size[24], change[24];
		screen_text(side, row, 0, 0, "%-4s%s", names[i],
		    size_text(kept[i], size));
		screen_text(side, row++, 16, 0, "%s",
		    change_text(here[i], kept[i], change));
	}
	return row;
}

/* What every curve passes at the crosshair, and the sizes at 50 %. */
static int
draw_cross(const struct tui *t, int row)
{
	const struct area *side = &t->places.side;
	const struct prediction *p = &t->session->last;
	const struct site *site = tui_entry(t)->site;
	if (!t->cross || t->cross_at >= p->product.n)
		return row;
	double x = p->product.size[t->cross_at];
	screen_text(side, row++, 0,
	    LOOK_BOLD | (t->focus == FOCUS_CROSS ? LOOK_REVERSE : 0),
	    "crosshair %g mm", units_mm(x));
	screen_text(side, row++, 0, 0, "%-14s%5.1f %%", "feed",
	    100 * p->feed.passing[t->cross_at]);
	for (size_t r = 0; r < site->n_run; r++) {
		const struct run *run = &site->run[r];
		if (run->product.n == 0 || !psd_covers(&run->product, x))
			continue;
		screen_text(side, row++, 0, 0, "measured %-5g%5.1f %%",
		    run->speed, 100 * psd_passing(&run->product, x));
	}
	screen_text(side, row++, 0, LOOK_BOLD, "PRED %-9.1f%5.1f %%", p->speed,
	    100 * p->product.passing[t->cross_at]);
	char feed[24];
	screen_text(side, row++, 0, 0, "feed 50 %%  %s",
	    size_text(1000 * psd_size(&p->feed, 0.5), feed));
	return row;
}

static void
draw_worth(const struct tui *t, int row)
{
	const struct area *side = &t->places.side;
	const struct entry *entry = tui_entry(t);
	if (entry->has_fit)
		screen_text(side, row++, 0, 0, "fit %s, seed %llu",
		    fit_verdict(&entry->fit),
		    (unsigned long long)entry->fit.seed);
	if (isfinite(t->holdout))
		screen_text(
		    side, row, 0, 0, "hold-out %.1f points", t->holdout);
}

static void
draw_side(const struct tui *t)
{
	const struct area *side = &t->places.side;
	const struct session *s = t->session;
	if (side->rows == 0)
		return;
	screen_wall(side->row, side->column - 1, side->rows);
	if (t->now.site[0] == '\0') {
		screen_text(side, 0, 0, 0, "nothing predicted yet");
		screen_text(side, 1, 0, 0, "f calibrates");
		return;
	}
	screen_text(side, 0, 0, LOOK_BOLD, "%.1f m/s  %.0f J/kg", t->now.speed,
	    s->last.energy);
	int row = draw_sizes(t, 1);
	bool tight = t->cross && t->pin.site[0] != '\0' && side->rows < 20;
	if (!tight)
		row = draw_fractions(t, row);
	row = draw_cross(t, row);
	row = draw_pin(t, row);
	draw_worth(t, row < side->rows - 2 ? side->rows - 2 : row);
}

void
pane_numbers(const struct tui *t)
{
	const struct area *area = &t->places.numbers;
	char a[24], b[24], c[24], d[24];
	if (area->rows == 0)
		return;
	if (t->now.site[0] == '\0')
		screen_text(area, 0, 0, 0,
		    area->columns < 21 ? "not predicted yet"
				       : "nothing predicted yet");
	else if (area->columns < 34)
		screen_text(area, 0, 0, LOOK_BOLD, "P50 %s P80 %.4s",
		    size_text(t->now.p50, a), size_text(t->now.p80, b));
	else
		screen_text(area, 0, 0, LOOK_BOLD,
		    area->columns < 60 ? "P20 %.4s P50 %s P80 %.4s"
				       : "P20 %s  P50 %s  P80 %s  breaks from "
					 "%s",
		    size_text(t->now.p20, a), size_text(t->now.p50, b),
		    size_text(t->now.p80, c), size_text(t->now.break_mm, d));
}

void
pane_predict(struct tui *t)
{
	const struct prediction *p = &t->session->last;
	struct plot_request request = {.kind = PLOT_PSD,
	    .speed = t->tenths / 10.0,
	    .other_speed = NAN,
	    .crosshair_mm = NAN,
	    .band = t->band};
	if (t->pin.site[0] != '\0' && strcmp(t->pin.site, t->now.site) == 0)
		request.other_speed = t->pin.speed;
	if (t->cross && t->cross_at < p->product.n)
		request.crosshair_mm = units_mm(p->product.size[t->cross_at]);
	pane_curves(t, &request);
	draw_side(t);
}

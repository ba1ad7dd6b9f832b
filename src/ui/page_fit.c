/* The Fit page: the search, generation by generation, while it runs and after.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "ui/pane.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/xalloc.h"
#include "cmd/fit.h"
#include "cmd/light.h"
#include "core/sensitivity.h"
#include "ui/screen.h"

/* The slider of the generations, instead of the usual caption. */
static bool
caption(struct tui *t, const struct area *area)
{
	size_t n = tui_past(t).n, at = tui_generation(t);
	if (n == 0)
		return false;
	char label[32], last[32];
	int from = screen_text(area, 0, 0, 0, "generation 1 ");
	snprintf(last, sizeof last, " %zu", n);
	int room = area->columns - from - (int)strlen(last) - 1;
	if (room < 12)
		return false;
	t->scrubber = (struct area){area->row, from, 1, room};
	for (int c = 0; c < room; c++)
		screen_text(area, 0, from + c, LOOK_DIM, "-");
	screen_text(area, 0, from + room, 0, "%s", last);
	snprintf(label, sizeof label, "[%zu]", at);
	int length = (int)strlen(label);
	double share = n > 1 ? (double)(at - 1) / (double)(n - 1) : 1;
	int column = from + (int)lround(share * (room - length));
	bool focus = t->focus == &page_fit;
	screen_text(
	    area, 0, column, focus ? LOOK_REVERSE : LOOK_BOLD, "%s", label);
	if (focus)
		t->cursor = (struct cursor){area->row, column + 1};
	return true;
}

/* Where a value stands within its bounds, as a cell of a bar. */
static int
cell_of(double value, double lower, double upper, int width)
{
	double share = upper > lower ? (value - lower) / (upper - lower) : 0.5;
	share = share < 0 ? 0 : share > 1 ? 1 : share;
	return (int)lround(share * (width - 1));
}

/* The parameters that were found, once the search has ended and its last
 * generation is shown; else NULL. */
static const struct params *
found(const struct tui *t)
{
	size_t n = tui_past(t).n;
	const struct entry *entry = tui_entry(t);
	bool last =
	    n > 0 && tui_generation(t) == n && !session_busy(t->session);
	return last && entry->has_fit ? &entry->params : NULL;
}

/* What the gauge, which counts by its direction only, is multiplied by to have
 * the size of that of a generation. */
static double
gauge_scale(const struct params *params, const struct calibrate_generation *g)
{
	double most = params_gauge(&g->params), own = params_gauge(params);
	return own > 0 ? most / own : 1;
}

/* "beta1 |  ==*=    | -0.591": the bounds, the middle 80 % of the candidates
 * and the best, or what the polish made of it. */
static void
draw_parameter(const struct area *side, int row, size_t j,
    const struct calibrate_generation *g, const struct params *polished,
    const struct bounds *bounds)
{
	enum { NAME = 7, VALUE = 18, MOST = 40 };
	double lower = bounds->lower[j], upper = bounds->upper[j];
	bool gauge = j < breakage_of(&g->params)->gauge;
	const struct params *p = polished != NULL ? polished : &g->params;
	double value = p->at[j];
	double best = value;
	if (polished != NULL && gauge)
		best *= gauge_scale(polished, g);
	int width = side->columns - NAME - VALUE - 2;
	width = width > MOST ? MOST : width < 3 ? 3 : width;
	char bar[MOST + 1];
	memset(bar, ' ', (size_t)width);
	bar[width] = '\0';
	int from = cell_of(g->p10[j], lower, upper, width);
	int to = cell_of(g->p90[j], lower, upper, width);
	for (int c = from; c <= to; c++)
		bar[c] = '=';
	bar[cell_of(best, lower, upper, width)] = '*';
	const char *remark = lower >= upper                       ? "fixed"
			     : sensitivity_on_bound(bounds, p, j) ? "at bound"
								  : "";
	screen_text(side, row, 0, 0, "%-7s|%s|%7.3g %s",
	    breakage_of(&g->params)->parameter[j].name, bar, value, remark);
}

static int
draw_parameters(const struct tui *t, const struct area *side, int row)
{
	struct plots_past past = tui_past(t);
	const struct params *polished = found(t);
	if (past.n == 0)
		return row;
	screen_text(side, row++, 0, LOOK_DIM, "bounds, = middle 80 %%, * %s",
	    polished != NULL ? "polished" : "best");
	const struct calibrate_generation *g =
	    &past.generation[tui_generation(t) - 1];
	for (size_t j = 0; j < breakage_of(&g->params)->n; j++)
		draw_parameter(side, row++, j, g, polished, past.bounds);
	return row;
}

/* How far the search is, and how fast. */
static int
draw_progress(const struct tui *t, const struct area *side, int row)
{
	const struct session *s = t->session;
	const struct calibrate_options *o = &s->job.options;
	struct calibrate_status st = calibration_status(s->job.calibration);
	double seconds = tui_searched(t);
	double rate = seconds > 0 ? (double)st.evaluations / seconds : 0;
	screen_text(side, row++, 0, LOOK_BOLD, "%sgeneration %zu of %zu",
	    t->held ? "PAUSED " : "", st.generation, o->generations);
	if (st.state == CALIBRATE_POLISHING)
		screen_text(side, row++, 0, 0,
		    "polishing: %zu starting points done", st.starts_done);
	else
		screen_text(side, row++, 0, 0, "stall %zu of %zu, tolerance %g",
		    st.stall, o->stall, o->tolerance);
	screen_text(
	    side, row++, 0, 0, "best %.4g median %.4g", st.best, st.median);
	screen_text(side, row++, 0, 0, "worst %.3g  seed %llu", st.worst,
	    (unsigned long long)o->seed);
	screen_text(side, row++, 0, 0, "%.0f evaluations a second", rate);
	if (st.generation > 0)
		screen_text(side, row++, 0, 0, "%.1f s, at most %.0f s more",
		    seconds,
		    seconds * (double)(o->generations - st.generation) /
			(double)st.generation);
	return row;
}

static const char *
why_stopped(enum calibrate_state stop)
{
	return stop == CALIBRATE_TOLERANCE     ? "converged"
	       : stop == CALIBRATE_STALLED     ? "stalled"
	       : stop == CALIBRATE_GENERATIONS ? "limit reached"
					       : "stopped";
}

static int
draw_result(const struct tui *t, const struct area *side, int row)
{
	const struct entry *entry = tui_entry(t);
	struct plots_past past = tui_past(t);
	size_t at = tui_generation(t);
	if (past.n == 0 || !entry->has_fit)
		return row;
	const struct calibrate_generation *g = &past.generation[at - 1];
	screen_text(side, row++, 0, LOOK_BOLD, "generation %zu of %zu (%s)", at,
	    past.n, why_stopped(entry->fit.stop));
	screen_text(
	    side, row++, 0, 0, "best %.4g median %.4g", g->best, g->median);
	screen_text(side, row++, 0, 0, "polished: misfit %.4g  seed %llu",
	    entry->fit.misfit, (unsigned long long)entry->fit.seed);
	screen_text(side, row++, 0, 0, "RMSE %.2f points, %s",
	    100 * entry->fit.rmse, light_verdict(t->session, entry, NULL));
	return row;
}

static void
draw_side(const struct tui *t)
{
	enum { LEAST = 7 };
	const struct area *side = &t->places.side;
	if (side->rows == 0)
		return;
	screen_wall(side->row, side->column - 1, side->rows);
	int row = session_busy(t->session) ? draw_progress(t, side, 0)
					   : draw_result(t, side, 0);
	if (row == 0) {
		bool can = tui_entry(t) == NULL ||
			   site_products(tui_entry(t)->site) > 0;
		screen_text(side, 0, 0, 0, "%s",
		    can ? "not calibrated yet: f starts"
			: "no product: type :guess");
		screen_text(side, 1, 0, 0, "%s",
		    can ? "+ and -: generations a second" : "");
		return;
	}
	row = draw_parameters(t, side, row);
	struct area below = *side;
	below.row += row + 1;
	below.rows -= row + 1;
	struct plot_request request = plots_request(PLOT_CONVERGENCE);
	request.words = CHART_TITLE;
	request.generation = t->generation;
	if (below.rows >= LEAST && t->picture != PLOT_CONVERGENCE)
		pane_plot(t, &request, &below);
}

static void
draw(struct tui *t)
{
	struct plot_request request = plots_request(t->picture);
	request.words = CHART_TITLE;
	request.speed = t->tenths / 10.0;
	request.feed_speed = t->feed;
	request.generation = t->generation;
	pane_curves(t, &request, true);
	draw_side(t);
}

static const char *
hints(const struct tui *t)
{
	return session_busy(t->session) && t->held
		   ? "Space continue  ? keys  q quit  s stop, keep  f fit "
		     "again  Tab generations  v plot"
	       : session_busy(t->session)
		   ? "Space pause  ? keys  q quit  s stop, keep  +/- gen/s  f "
		     "fit again  Tab generations  v plot"
	       : tui_past(t).n > 0
		   ? "f fit again  ? keys  q quit  Tab generations  v plot  "
		     "+/- gen/s  : command"
		   : "f fit  ? keys  q quit  +/- gen/s  : command";
}

static bool
can_focus(const struct tui *t)
{
	return tui_past(t).n > 0;
}

static void
move(struct tui *t, int by)
{
	int at = (int)tui_generation(t) - 1;
	tui_look_at(t, (size_t)pane_moved(at, by, tui_past(t).n) + 1);
}

/* Arrows go through the generations where these have the focus. */
static bool
act(struct tui *t, const struct key *key)
{
	bool to_end = key->act == ACT_TO && key->amount <= TO_MOST;
	if (key->act == ACT_PICTURE)
		t->picture = t->picture == PLOT_PSD           ? PLOT_CONVERGENCE
			     : t->picture == PLOT_CONVERGENCE ? PLOT_SPREAD
							      : PLOT_PSD;
	else if (t->focus != &page_fit)
		return false;
	else if (to_end)
		tui_look_at(t, key->amount == TO_LEAST ? 1 : tui_past(t).n);
	else if (key->act == ACT_MOVE || key->act == ACT_FINE ||
		 key->act == ACT_LIST)
		move(t, key->amount);
	else
		return false;
	return true;
}

static bool
mouse(struct tui *t, int row, int column, bool pressed)
{
	const struct area *s = &t->scrubber;
	size_t n = tui_past(t).n;
	if (pressed ? !area_has(s, row, column) : t->focus != &page_fit)
		return false;
	t->focus = &page_fit;
	if (n == 0 || s->columns < 2)
		return true;
	int at = column - s->column;
	at = at < 0 ? 0 : at >= s->columns ? s->columns - 1 : at;
	tui_look_at(t, 1 + (size_t)at * (n - 1) / (size_t)(s->columns - 1));
	return true;
}

static char *
words(const struct tui *t)
{
	if (t->picture == PLOT_PSD)
		return pane_curves_words(t);
	return xstrdup(t->picture == PLOT_SPREAD ? "spread" : "convergence");
}

const struct page_ops page_fit = {.name = "Fit",
    .hints_now = hints,
    .side = 38,
    .wide_side = 50,
    .draw = draw,
    .caption = caption,
    .can_focus = can_focus,
    .key = act,
    .mouse = mouse,
    .words = words};

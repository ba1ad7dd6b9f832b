/* Page Fit: the search, generation by generation, while it runs and afterwards.
 * Beside its plot are a row for each parameter, with its bounds and the middle
 * 80 % of candidates and draws, and below these the convergence.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/tr.h"
#include "tui/pane.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "base/xalloc.h"
#include "cmd/ask/answers.h"
#include "cmd/ask/outlook.h"
#include "cmd/ask/trust_light.h"
#include "cmd/draw/plots_search.h"
#include "cmd/draw/site_chart.h"
#include "core/search/misfit.h"
#include "plot/draw.h"
#include "tui/acts.h"
#include "tui/screen.h"
#include "tui/watch.h"

/* ---- The panel ---- */

/* Columns in the row of a parameter: for its name, lower bound, bar, upper
 * bound, value and, on a wide panel, a remark. */
enum { NAME = 7, BOUND = 6, VALUE = 8, SIGN = 1, REMARK = 12, WIDE = 48 };

/* The fewest rows for the plot of the convergence. */
enum { CONVERGENCE = 3 };

/* Where and how a row of the panel is drawn. */
struct row {
	const struct area *side;
	int row, width;
	bool wide;
};

static void
move_parameter_cursor(struct tui *t, int by)
{
	struct search_shown past = tui_calibration_history(t);
	if (past.n == 0)
		return;
	/* The first key only shows which parameter is chosen. */
	if (t->ui.param_at == 0)
		t->ui.param_at = 1;
	else
		t->ui.param_at =
		    1 + pane_move_index_clamped(t->ui.param_at - 1, by,
			    breakage_model_of_params(&past.best)->n);
}

void
act_open_bounds_command(struct tui *t, const struct key *key)
{
	(void)key;
	struct search_shown past = tui_calibration_history(t);
	if (past.n == 0)
		return;
	size_t j = t->ui.param_at > 0 ? t->ui.param_at - 1 : 0;
	const struct breakage *of = breakage_model_of_params(&past.best);
	const struct session *s = t->session;
	/* The bounds of the next search; if that uses another model, those of
	 * the last. */
	const struct bounds *now = s->set.model.breakage == past.best.breakage
				       ? &s->set.bounds
				       : past.bounds;
	t->ui.param_at = j + 1;
	FREED char *line = xasprintf("bounds %s ", of->parameter[j].name);
	edit_begin(&t->line, line);
	tui_set_message(t, false,
	    j < of->gauge ? N_("%s: %g..%g now; type low..high, or one value; "
			       "the bar shows each beta divided by the "
			       "largest, as only ratios matter")
			  : N_("%s: %g..%g now; type low..high, or one value"),
	    of->parameter[j].name, now->lower[j], now->upper[j]);
}

static void
on_click_parameter(struct tui *t, const struct mouse_event *touched)
{
	t->ui.param_at = touched->item;
	act_open_bounds_command(t, NULL);
}

/* Returns the cell of a bar, `width` cells long, where a value stands between
 * the bounds. */
static int
bar_cell_of_value(const struct param_span *span, double value, int width)
{
	double range = span->upper - span->lower;
	double share = range > 0 ? (value - span->lower) / range : 0.5;
	share = share < 0 ? 0 : share > 1 ? 1 : share;
	return (int)lround(share * (width - 1));
}

/* Draws a sign in the cells from end[0] to end[1]. */
static void
draw_bar_span(const struct row *r, const struct param_span *span,
    const double *end, enum series series, const char *sign)
{
	int from = bar_cell_of_value(span, end[0], r->width);
	int to = bar_cell_of_value(span, end[1], r->width);
	for (int c = from; c <= to; c++)
		screen_draw_text_in_series_colour(
		    r->side, r->row, NAME + BOUND + 1 + c, series, 0, sign);
}

/* Writes a number in few characters: "0.001", "2746". */
static const char *
short_number_text(double value, bool scaled, char text[static 24])
{
	/* So that it is not "-0.000". */
	if (scaled)
		snprintf(text, 24, "%.3f", fabs(value) < 0.5e-3 ? 0 : value);
	else
		snprintf(text, 24, "%.*g", fabs(value) >= 1000 ? 5 : 3, value);
	return text;
}

/* Draws the bar between the bounds, with the middle 80 % of the draws and of
 * the candidates, and the best candidate. */
static void
draw_parameter_bar(const struct row *r, const struct param_span *span)
{
	bool ascii = screen_charset() == CHARSET_ASCII;
	int end = NAME + BOUND + 1 + r->width;
	char text[24];
	screen_draw_text(r->side, r->row, NAME, LOOK_DIM, "%*s|", BOUND,
	    short_number_text(span->lower, false, text));
	screen_draw_text(r->side, r->row, end, LOOK_DIM, "|%-*s", BOUND,
	    short_number_text(span->upper, false, text));
	if (isfinite(span->drawn[0]))
		draw_bar_span(r, span, span->drawn, SERIES_PREDICTED,
		    ascii ? "-" : "\u2500");
	draw_bar_span(r, span, (double[]){span->p10, span->p90}, SERIES_FEED,
	    ascii ? "=" : "\u2501");
	screen_draw_text_in_series_colour(r->side, r->row,
	    NAME + BOUND + 1 + bar_cell_of_value(span, span->best, r->width),
	    SERIES_PREDICTED, LOOK_BOLD, "*");
}

/* Draws "f_mat  0.01|  ==*=    |10    2.18".  A fixed parameter has no bar. */
static void
draw_parameter_row(const struct row *r, const char *name, bool scaled,
    bool chosen, const struct param_span *span)
{
	int at = NAME + 2 * (BOUND + 1) + r->width;
	/* Without room for the remark, the sign stands only for a value at the
	 * bound. */
	bool marked = span->at_bound || (r->wide && span->near);
	const char *remark = span->at_bound ? tr("AT BOUND")
			     : span->near   ? tr("NEAR BOUND")
					    : "";
	char text[24];
	screen_draw_text(
	    r->side, r->row, 0, chosen ? LOOK_REVERSE : LOOK_PLAIN, "%s", name);
	/* For terminals that have no reverse. */
	if (chosen)
		screen_draw_text(r->side, r->row, NAME - 1, LOOK_BOLD, ">");
	if (span->fixed)
		screen_draw_text(
		    r->side, r->row, NAME + BOUND + 1, LOOK_DIM, "held fixed");
	else
		draw_parameter_bar(r, span);
	at = screen_draw_text(r->side, r->row, at,
	    marked ? LOOK_BOLD : LOOK_PLAIN, "%*s", VALUE - 1,
	    short_number_text(span->best, scaled, text));
	if (marked)
		screen_draw_text(r->side, r->row, at, LOOK_BOLD, "!%s%s",
		    r->wide ? " " : "", r->wide ? remark : "");
}

static int
draw_parameter_panel(struct tui *t, const struct search_shown *past, int row)
{
	const struct area *side = &t->layout.side;
	const struct breakage *of = breakage_model_of_params(&past->best);
	bool wide = side->columns >= WIDE;
	int rest = NAME + 2 * (BOUND + 1) + VALUE + (wide ? REMARK : SIGN);
	struct row r = {side, row, side->columns - rest, wide};
	bool end =
	    t->ui.generation == 0 && !session_entry_being_fitted(t->session);
	bool ascii = screen_charset() == CHARSET_ASCII;
	screen_draw_text(side, row, 0, LOOK_DIM, "%s 80 %%  * %s%s%s",
	    ascii ? "=" : "\u2501", end ? tr("polished") : tr("best"),
	    !end    ? ""
	    : ascii ? tr("  - draws")
		    : tr("  \u2500 draws"),
	    wide ? "" : tr("  ! bound"));
	r.width = r.width < 3 ? 3 : r.width;
	for (size_t j = 0; j < of->n && r.row + 1 < side->rows; j++) {
		struct param_span span = param_span_of_generation(
		    t->session, past, t->ui.generation, j);
		r.row++;
		draw_parameter_row(&r, of->parameter[j].name, j < of->gauge,
		    t->ui.param_at == j + 1, &span);
		hits_add_mouse_handler(&t->hits, HIT_PRESS,
		    area_of_row(side, r.row), on_click_parameter, j + 1);
	}
	return r.row + 1;
}

static const char *
stop_reason_text(enum calibrate_state stop)
{
	return stop == CALIBRATE_TOLERANCE     ? tr("converged")
	       : stop == CALIBRATE_STALLED     ? tr("stalled")
	       : stop == CALIBRATE_GENERATIONS ? tr("limit reached")
					       : tr("stopped");
}

/* Draws "1.2 s  350000 candidates  pace auto".  The time left is not known,
 * because the polish goes on until it finds nothing better. */
static int
draw_calibration_time_and_pace(const struct tui *t, int row)
{
	struct calibrate_status st =
	    calibration_status(t->session->job.calibration);
	double seconds = tui_calibration_seconds(t);
	char pace[32];
	snprintf(pace, sizeof pace, tr("full"));
	if (t->ui.pace == PACE_AUTO)
		snprintf(pace, sizeof pace, tr("auto"));
	else if (t->ui.pace < PACE_FULL)
		snprintf(pace, sizeof pace, "%g/s", PACES[t->ui.pace]);
	screen_draw_text(&t->layout.side, row, 0, LOOK_DIM,
	    "%.1f s  %zu candidates  pace %s", seconds, st.evaluations, pace);
	return row + 1;
}

/* Returns "converged; seed 1; doubtful: ..", with the first reason or, if the
 * search shown did not replace the fit, "stopped; this stays: doubtful: ..".
 * The caller frees it. */
static char *
fit_stop_and_verdict_text(const struct tui *t, const struct entry *entry)
{
	struct trust light = trust_in_answer_or_fit(t->session, entry, NULL);
	FREED char *verdict = xasprintf("%s%s%s",
	    verdict_on_fit(entry, light.light), light.n > 0 ? ": " : "",
	    light.n > 0 ? light.reason[0].text : "");
	trust_free(&light);
	if (is_calibration_of_site_running(
		t->session, tui_current_site_entry(t)) &&
	    t->session->job.held_back)
		return xasprintf(tr("stopped; this stays: %s"), verdict);
	return xasprintf(tr("%s; seed %llu; %s"),
	    stop_reason_text(entry->fit.stop),
	    (unsigned long long)entry->fit.seed, verdict);
}

/* Draws the verdict when the end of a search is shown, in rows that the
 * parameters and the convergence leave free.  Returns the row after it. */
static int
draw_calibration_result(const struct tui *t, int row)
{
	const struct entry *entry = tui_current_site_entry(t);
	const struct area *side = &t->layout.side;
	if (!entry->has_fit || t->ui.generation > 0)
		return row;
	const struct posterior *p =
	    posterior_even_if_correction_off(t->session, entry);
	int heads = 1 + (int)breakage_model_of_params(&entry->params)->n;
	int room = side->rows - row - heads - CONVERGENCE - (p != NULL);
	char *words = fit_stop_and_verdict_text(t, entry);
	row = screen_draw_wrapped_rows(
	    side, row, room > 1 ? room : 1, 0, words, " .. :why");
	free(words);
	if (p == NULL)
		return row;
	double halves =
	    trust_evidence_of_calibration(t->session, entry)->halves;
	words = xasprintf(halves > DRAWS_SETTLED ? tr("%d draws, not settled")
						 : tr("%d draws, settled"),
	    POSTERIOR_DRAWS);
	row = screen_draw_wrapped(side, row, 0, words);
	free(words);
	return row;
}

/* Draws the state of the search at the generation shown.  Returns the row after
 * it. */
static int
draw_calibration_state(const struct tui *t, const struct search_shown *past)
{
	const struct area *side = &t->layout.side;
	size_t at = tui_shown_unpolished_generation(t);
	const struct calibrate_generation *g = &past->generation[at - 1];
	bool end = t->ui.generation == 0 && past->polished;
	double best = misfit_as_rmse_points(past, end ? past->misfit : g->best);
	int row = 0;
	screen_draw_text(side, row++, 0, LOOK_BOLD,
	    end ? N_("%sgeneration %zu of %zu, polished")
		: N_("%sgeneration %zu of %zu"),
	    session_is_calibrating(t->session) && t->held ? tr("PAUSED ") : "",
	    at, past->n);
	screen_draw_text(side, row++, 0, 0, "best %.2f, median %.2f points RMS",
	    best, misfit_as_rmse_points(past, g->median));
	FREED char *words =
	    t->computing != NULL
		? xstrdup(t->computing)
		: fit_search_progress_text(t->session, past, t->ui.generation);
	row = screen_draw_wrapped(side, row, LOOK_BOLD, words);
	return session_entry_being_fitted(t->session)
		   ? draw_calibration_time_and_pace(t, row)
		   : draw_calibration_result(t, row);
}

static void
draw_convergence_plot(struct tui *t, int row)
{
	struct area below = t->layout.side;
	area_cut_off_edge(&below, EDGE_TOP, row);
	struct plot_request request = plots_default_request(PLOT_CONVERGENCE);
	request.words = 0;
	request.generation = t->ui.generation;
	if (below.rows >= CONVERGENCE && t->ui.picture != PLOT_CONVERGENCE)
		pane_draw_plot(t, &request, &below);
}

/* Returns "beta1=-0.000  .. alpha=1!", with "!" at a bound. */
static char *
parameters_text(const struct tui *t, const struct search_shown *past)
{
	const struct breakage *of = breakage_model_of_params(&past->best);
	char *words = xstrdup(""), text[24];
	for (size_t j = 0; j < of->n; j++) {
		struct param_span span = param_span_of_generation(
		    t->session, past, t->ui.generation, j);
		xappend(&words, "%s%s=%s%s", j > 0 ? "  " : "",
		    of->parameter[j].name,
		    short_number_text(span.best, j < of->gauge, text),
		    span.at_bound ? "!" : "");
	}
	return words;
}

/* Draws the parameters as text, for a panel without rows for bars. */
static void
draw_params_in_words(const struct tui *t, const struct search_shown *past)
{
	const struct area *side = &t->layout.side;
	const struct entry *entry = tui_current_site_entry(t);
	size_t at = tui_shown_unpolished_generation(t);
	bool over = t->ui.generation == 0 &&
		    !session_is_calibrating(t->session) && entry->has_fit;
	double points = t->ui.generation == 0 ? past->misfit
					      : past->generation[at - 1].best;
	screen_draw_text(side, 0, 0, LOOK_BOLD,
	    "generation %zu: %.2f points RMS", at,
	    misfit_as_rmse_points(past, points));
	char *words = parameters_text(t, past);
	int row =
	    screen_draw_wrapped_rows(side, 1, side->rows - 1, 0, words, " ..");
	free(words);
	words =
	    over ? fit_stop_and_verdict_text(t, entry)
		 : fit_search_progress_text(t->session, past, t->ui.generation);
	screen_draw_wrapped_rows(
	    side, row, side->rows - row, 0, words, over ? " .. :why" : " ..");
	free(words);
}

static void
draw_calibration_side_panel(struct tui *t)
{
	enum { LOW = 12 };
	const struct area *side = &t->layout.side;
	struct search_shown past = tui_calibration_history(t);
	if (side->rows == 0)
		return;
	screen_draw_vertical_rule(side->row, t->layout.wall, side->rows);
	if (past.n > 0 && side->rows < LOW) {
		draw_params_in_words(t, &past);
		return;
	}
	if (past.n > 0) {
		int row = draw_calibration_state(t, &past);
		draw_convergence_plot(t, draw_parameter_panel(t, &past, row));
		return;
	}
	const struct entry *entry = tui_current_site_entry(t);
	bool can = entry == NULL || site_count_products(entry->site) > 0;
	bool before = entry != NULL && entry->has_fit;
	screen_draw_text(side, 0, 0, 0, "%s",
	    before ? tr("search not kept: f starts a new one")
	    : can  ? tr("not calibrated yet: f starts")
		   : tr("no product: type :guess"));
	screen_draw_text(
	    side, 1, 0, 0, "%s", can ? tr("+ and -: pace of the search") : "");
}

/* ---- The generations and the plot ---- */

static void
on_click_generations(struct tui *t, const struct mouse_event *touched)
{
	size_t n = tui_count_generations(t);
	int last = touched->area.columns - 1, at = touched->column;
	if (n == 0 || last < 1)
		return;
	at = at < 0 ? 0 : at > last ? last : at;
	tui_show_generation(t, 1 + (size_t)at * (n - 1) / (size_t)last);
}

/* Draws the slider of generations instead of the usual caption. */
static bool
caption(struct tui *t, const struct area *area)
{
	size_t n = tui_count_generations(t),
	       at = tui_shown_generation_number(t);
	if (n == 0)
		return false;
	bool polished = n > tui_calibration_history(t).n;
	char label[32], last[32];
	int from = screen_draw_text(area, 0, 0, 0, "generation 1 ");
	snprintf(last, sizeof last, polished ? tr(" polished") : " %zu", n);
	int room = area->columns - from - (int)strlen(last) - 1;
	if (room < 12)
		return false;
	hits_add_mouse_handler(&t->hits, HIT_SLIDE,
	    area_of_columns_in_row(area, 0, from, room), on_click_generations,
	    0);
	for (int c = 0; c < room; c++)
		screen_draw_text(area, 0, from + c, LOOK_DIM, "-");
	screen_draw_text(area, 0, from + room, 0, "%s", last);
	snprintf(label, sizeof label,
	    polished && at == n ? tr("[polished]") : "[%zu]", at);
	int length = (int)strlen(label);
	double share = n > 1 ? (double)(at - 1) / (double)(n - 1) : 1;
	int column = from + (int)lround(share * (room - length));
	screen_draw_text(area, 0, column, LOOK_REVERSE, "%s", label);
	t->cursor = (struct cursor){area->row, column};
	return true;
}

/* Draws the bar, the mark and the name of a run, if there is room.  Returns the
 * column after them. */
static int
draw_legend_of_run(const struct area *area, int column, const struct site *site,
    size_t run, const char *bar)
{
	struct chart_series look = site_chart_run_style(site, run, false);
	FREED char *mark = chart_legend_sample(&look, screen_charset());
	FREED char *speed = answers_speed_text(site, site->run[run].speed, -1);
	FREED char *name = xasprintf(" %s%s  ", speed, site->run[run].repeat);
	if (column + text_width_in_columns(bar) + text_width_in_columns(mark) +
		text_width_in_columns(name) >
	    area->columns)
		return column;
	column = screen_draw_text_in_series_colour(
	    area, 0, column, look.series, 0, bar);
	column = screen_draw_text_in_series_colour(
	    area, 0, column, SERIES_PREDICTED, 0, mark);
	return screen_draw_text_in_series_colour(
	    area, 0, column, look.series, 0, name);
}

/* Draws a legend of one row, because the plot's own legend would leave it
 * little room. */
static void
fit_page_draw_legend(const struct tui *t)
{
	static const char *const BARS[] = {"\u2503", "\u2502", "\u250a"},
				 *const ASCII[] = {"#", "|", ":"};
	const struct area *area = &t->layout.legend;
	const struct search_shown past = tui_calibration_history(t);
	bool ascii = screen_charset() == CHARSET_ASCII;
	const char *means = tr("bar: middle 80 %, mark: best  "),
		   *noise = ascii ? tr(", noise") : tr("\u2508 noise");
	int column = 0;
	size_t nth = 0;
	for (size_t r = 0; r < past.site->n_run; r++) {
		if (!past.train[r] ||
		    misfit_count_covered_sieves(&past.site->run[r]) == 0)
			continue;
		size_t kind = nth++ % ARRAY_LEN(BARS);
		column = draw_legend_of_run(area, column, past.site, r,
		    ascii ? ASCII[kind] : BARS[kind]);
	}
	if (column + text_width_in_columns(means) > area->columns)
		return;
	column = screen_draw_text_in_series_colour(
	    area, 0, column, SERIES_PREDICTED, 0, means);
	if (column + text_width_in_columns(noise) <= area->columns)
		screen_draw_text_in_series_colour(
		    area, 0, column, SERIES_FEED, 0, noise);
}

static void
fit_page_draw(struct tui *t)
{
	enum { TALL = 20, LOW = 9 };
	bool any = tui_calibration_history(t).n > 0;
	struct layout *l = &t->layout;
	/* Without rows for a plot, the state of the search is shown as text. */
	if (l->side.rows == 0 && l->plot.rows < LOW && any &&
	    t->ui.picture == PLOT_SEARCH) {
		l->side = l->plot;
		draw_calibration_side_panel(t);
		return;
	}
	struct plot_request request =
	    plots_default_request(any ? t->ui.picture : PLOT_PSD);
	request.words = CHART_TITLE;
	request.asked.speed = tui_slider_speed(t);
	request.asked.feed = tui_run_index_of_feed(t);
	request.generation = t->ui.generation;
	bool own = request.kind == PLOT_SEARCH && t->layout.plot.rows < TALL;
	if (own)
		pane_draw_plot(t, &request, &t->layout.plot);
	else
		pane_draw_curves(t, &request, request.kind == PLOT_PSD);
	if (own && t->layout.legend.rows > 0)
		fit_page_draw_legend(t);
	draw_calibration_side_panel(t);
}

static const char *
fit_page_hints(const struct tui *t)
{
	bool busy = session_is_calibrating(t->session);
	if (busy && !t->session->job.fits)
		return t->held ? N_("Space continue  Esc stop  ?  q  :")
			       : N_("Space  Esc stop  ?  q  :");
	return busy && t->held ? N_("Space continue  .  ?  q  s  Down Enter  v")
	       : busy          ? "Space  .  ?  q  s  +/-  v"
	       : tui_calibration_history(t).n > 0
		   ? N_("<-/-> generation  1 predict  f again  ?  q  Down "
			"Enter  v")
	       : tui_current_site(t) != NULL &&
		       site_count_products(tui_current_site(t)) == 0
		   ? N_(":  ?  q  o  1-5 pages")
		   : "f  ?  q  +/-  :";
}

static void
move_shown_generation_by(struct tui *t, int by)
{
	size_t at = tui_shown_generation_number(t) - 1;
	tui_show_generation(
	    t, pane_move_index_clamped(at, by, tui_count_generations(t)) + 1);
}

/* Runs the next generation of a running search; of a finished search, shows the
 * next generation. */
void
act_next_generation(struct tui *t, const struct key *key)
{
	(void)key;
	if (!session_is_calibrating(t->session)) {
		move_shown_generation_by(t, 1);
		return;
	}
	watch_set_fit_paused(t, true);
	t->ui.generation = 0;
	watch_run_fit_step(t);
}

void
act_next_plot(struct tui *t, const struct key *key)
{
	static const enum plot_kind NEXT[] = {[PLOT_SEARCH] = PLOT_PSD,
	    [PLOT_PSD] = PLOT_CONVERGENCE,
	    [PLOT_CONVERGENCE] = PLOT_SPREAD,
	    [PLOT_SPREAD] = PLOT_SEARCH};
	(void)key;
	t->ui.picture = NEXT[t->ui.picture];
}

/* Left and Right move through the generations, Up and Down through the
 * parameters. */
static bool
fit_page_move_by_key(struct tui *t, const struct key *key)
{
	if (key->act == act_move_in_list)
		move_parameter_cursor(t, key->amount);
	else if (tui_calibration_history(t).n == 0)
		return false;
	else if (key->act == act_move_to_end)
		tui_show_generation(
		    t, key->amount == TO_LEAST ? 1 : tui_count_generations(t));
	else
		move_shown_generation_by(t, key->amount);
	return true;
}

static char *
fit_page_plot_arguments(const struct tui *t)
{
	static const char *const NAMES[] = {[PLOT_SEARCH] = "search",
	    [PLOT_CONVERGENCE] = "convergence",
	    [PLOT_SPREAD] = "spread"};
	bool curves =
	    t->ui.picture == PLOT_PSD || tui_calibration_history(t).n == 0;
	char *line = curves ? pane_curves_plot_arguments(t)
			    : xstrdup(NAMES[t->ui.picture]);
	if (t->ui.generation > 0)
		xappend(&line, " generation=%zu", t->ui.generation);
	return line;
}

const struct page_ops page_fit = {.hints_now = fit_page_hints,
    .side = 40,
    .wide_side = 58,
    .draw = fit_page_draw,
    .caption = caption,
    .move = fit_page_move_by_key,
    .words = fit_page_plot_arguments};

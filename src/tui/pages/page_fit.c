/* The page Fit: the search, generation by generation, during and after its run.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/tr.h"
#include "tui/pane.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/text.h"
#include "base/xalloc.h"
#include "cmd/ask/answers.h"
#include "cmd/draw/plots_search.h"
#include "cmd/draw/site_chart.h"
#include "core/search/misfit.h"
#include "plot/draw.h"
#include "tui/acts.h"
#include "tui/screen.h"
#include "tui/widgets/search_side.h"
#include "tui/watch.h"

static void
on_click_generations(struct tui *t, const struct touched *touched)
{
	size_t n = tui_count_generations(t);
	int last = touched->area.columns - 1, at = touched->column;
	if (n == 0 || last < 1)
		return;
	at = at < 0 ? 0 : at > last ? last : at;
	tui_show_generation(t, 1 + (size_t)at * (n - 1) / (size_t)last);
}

/* Draws the slider of the generations instead of the usual caption. */
static bool
caption(struct tui *t, const struct area *area)
{
	size_t n = tui_count_generations(t), at = tui_generation_shown(t);
	if (n == 0)
		return false;
	bool polished = n > tui_search_shown(t).n;
	char label[32], last[32];
	int from = screen_text(area, 0, 0, 0, "generation 1 ");
	snprintf(last, sizeof last, polished ? tr(" polished") : " %zu", n);
	int room = area->columns - from - (int)strlen(last) - 1;
	if (room < 12)
		return false;
	hits_add(&t->hits, HIT_SLIDE, area_part_of_row(area, 0, from, room),
	    on_click_generations, 0);
	for (int c = 0; c < room; c++)
		screen_text(area, 0, from + c, LOOK_DIM, "-");
	screen_text(area, 0, from + room, 0, "%s", last);
	snprintf(label, sizeof label,
	    polished && at == n ? tr("[polished]") : "[%zu]", at);
	int length = (int)strlen(label);
	double share = n > 1 ? (double)(at - 1) / (double)(n - 1) : 1;
	int column = from + (int)lround(share * (room - length));
	screen_text(area, 0, column, LOOK_REVERSE, "%s", label);
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
	column = screen_draw_series_text(area, 0, column, look.series, 0, bar);
	column =
	    screen_draw_series_text(area, 0, column, SERIES_PREDICTED, 0, mark);
	return screen_draw_series_text(area, 0, column, look.series, 0, name);
}

/* Draws a legend of one row, as that of the plot itself would leave it little
 * room. */
static void
fit_draw_legend(const struct tui *t)
{
	static const char *const BARS[] = {"\u2503", "\u2502", "\u250a"},
				 *const ASCII[] = {"#", "|", ":"};
	const struct area *area = &t->layout.legend;
	const struct search_shown past = tui_search_shown(t);
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
	if (column + text_width_in_columns(means) <= area->columns)
		column = screen_draw_series_text(
		    area, 0, column, SERIES_PREDICTED, 0, means);
	if (column + text_width_in_columns(noise) <= area->columns)
		screen_draw_series_text(area, 0, column, SERIES_FEED, 0, noise);
}

static void
fit_draw(struct tui *t)
{
	enum { TALL = 20, LOW = 9 };
	bool any = tui_search_shown(t).n > 0;
	struct layout *l = &t->layout;
	/* Without rows for a plot, the state of the search is shown in
	 * words. */
	if (l->side.rows == 0 && l->plot.rows < LOW && any &&
	    t->ui.picture == PLOT_SEARCH) {
		l->side = l->plot;
		search_side_draw(t);
		return;
	}
	struct plot_request request =
	    plots_default_request(any ? t->ui.picture : PLOT_PSD);
	request.words = CHART_TITLE;
	request.asked.speed = tui_slider_speed(t);
	request.asked.feed = tui_feed_run(t);
	request.generation = t->ui.generation;
	bool own = request.kind == PLOT_SEARCH && t->layout.plot.rows < TALL;
	if (own)
		pane_draw_plot(t, &request, &t->layout.plot);
	else
		pane_draw_curves(t, &request, request.kind == PLOT_PSD);
	if (own && t->layout.legend.rows > 0)
		fit_draw_legend(t);
	search_side_draw(t);
}

static const char *
fit_hints(const struct tui *t)
{
	bool busy = session_is_calibrating(t->session);
	if (busy && !t->session->job.fits)
		return t->held ? N_("Space continue  Esc stop  ?  q  :")
			       : N_("Space  Esc stop  ?  q  :");
	return busy && t->held ? N_("Space continue  .  ?  q  s  Down Enter  v")
	       : busy          ? "Space  .  ?  q  s  +/-  v"
	       : tui_search_shown(t).n > 0 ? N_("<-/-> generation  1 predict  "
						"f again  ?  q  Down Enter  "
						"v")
					   : "f  ?  q  +/-  :";
}

static void
move_shown_generation_by(struct tui *t, int by)
{
	size_t at = tui_generation_shown(t) - 1;
	tui_show_generation(
	    t, pane_clamp_index(at, by, tui_count_generations(t)) + 1);
}

/* Runs the next generation of a running search; of one that is over, shows
 * it. */
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
fit_move_by_key(struct tui *t, const struct key *key)
{
	if (key->act == act_move_in_list)
		search_side_choose_parameter(t, key->amount);
	else if (tui_search_shown(t).n == 0)
		return false;
	else if (key->act == act_move_to_end)
		tui_show_generation(
		    t, key->amount == TO_LEAST ? 1 : tui_count_generations(t));
	else
		move_shown_generation_by(t, key->amount);
	return true;
}

static char *
fit_plot_name(const struct tui *t)
{
	static const char *const NAMES[] = {[PLOT_SEARCH] = "search",
	    [PLOT_CONVERGENCE] = "convergence",
	    [PLOT_SPREAD] = "spread"};
	bool curves = t->ui.picture == PLOT_PSD || tui_search_shown(t).n == 0;
	char *line =
	    curves ? pane_curves_plot_name(t) : xstrdup(NAMES[t->ui.picture]);
	if (t->ui.generation > 0)
		xappend(&line, " generation=%zu", t->ui.generation);
	return line;
}

const struct page_ops page_fit = {.hints_now = fit_hints,
    .side = 40,
    .wide_side = 58,
    .draw = fit_draw,
    .caption = caption,
    .move = fit_move_by_key,
    .words = fit_plot_name};

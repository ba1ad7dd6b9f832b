/* response: plots quantities against the speed, with their bands, limits and
 * measured values, and the speeds that meet the limits.  There is a chart for
 * each unit.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/draw/plots.h"

#include <math.h>
#include <string.h>

#include "base/tr.h"
#include "base/xalloc.h"
#include "cmd/ask/answers.h"
#include "cmd/ask/feed.h"
#include "cmd/ask/moved.h"
#include "cmd/ask/condition.h"
#include "cmd/ask/trust_light.h"
#include "cmd/ask/forecast.h"
#include "cmd/ask/outlook.h"
#include "cmd/ask/quantity_words.h"
#include "cmd/ask/asked.h"
#include "cmd/ask/screened.h"
#include "cmd/draw/site_chart.h"
#include "core/psd/rotor_speed.h"
#include "core/answer/predict.h"

/* The quantities [n] to draw, the limits on them, and the range of speeds, m/s.
 * Quantities that name no fraction have that of the question.  moved: the most
 * by which a measured product was moved to the feed, see
 * largest_change_by_moving_to_feed. */
enum { POINTS = 81, MOST = 12 };
struct drawn {
	const struct question *asked;
	size_t n;
	struct quantity q[MOST];
	struct condition_list limits;
	double from, to, moved;
	struct chart_series *line[MOST];
};

/* Chooses sieves whose passings are well apart at a speed: those nearest to 80,
 * 50 and 20 %, and the finest one. */
static void
choose_sieves_for_response_plot(struct session *s, struct drawn *d)
{
	static const double WANTED[] = {0.8, 0.5, 0.2, 0};
	struct prediction p = forecast_product(
	    s, d->asked, site_middle_speed(d->asked->entry->site));
	const struct psd *product = &p.product;
	size_t first = 0;
	while (first + 1 < product->n && product->passing[first] >= 1)
		first++;
	for (size_t k = 0; k < ARRAY_LEN(WANTED); k++) {
		size_t best = first;
		for (size_t i = first + 1; i < product->n; i++)
			if (fabs(product->passing[i] - WANTED[k]) <
			    fabs(product->passing[best] - WANTED[k]))
				best = i;
		struct quantity q = {.kind = QUANTITY_PASSING,
		    .x = product->size[best],
		    .fraction = d->asked->fraction};
		if (d->n == 0 || d->q[d->n - 1].x > q.x)
			d->q[d->n++] = q;
	}
	prediction_free(&p);
}

/* Adds a quantity unless it is there already.  Returns false if there are too
 * many. */
static bool
add_drawn_quantity_once(struct drawn *d, const struct quantity *q)
{
	for (size_t i = 0; i < d->n; i++)
		if (quantity_is_same(&d->q[i], q))
			return true;
	if (d->n == MOST)
		return false;
	d->q[d->n++] = *q;
	return true;
}

static bool
error_too_many_quantities(struct error *error)
{
	return error_set(error, ERROR_USAGE,
	    "more than %d quantities are too many to draw\n"
	    "choose some by of=",
	    MOST);
}

/* Reads the quantities and limits, and checks that the feed covers them. */
static bool
parse_quantities_to_plot(struct session *s, const char *of_words,
    const char *limits, struct drawn *d, struct error *error)
{
	const struct psd *feed =
	    site_feed_of_run(d->asked->entry->site, d->asked->feed);
	size_t n = 0;
	if (limits != NULL && !conditions_parse_list(limits,
				  &d->asked->fraction, &d->limits, error))
		return false;
	for (size_t i = 0; i < d->limits.n; i++)
		if (!conditions_check_feed_covers(
			&d->limits.at[i], feed, error))
			return false;
	FREED struct quantity *of =
	    of_words != NULL ? quantities_parse_list_for_feed(of_words,
				   &d->asked->fraction, feed, true, &n, error)
			     : NULL;
	if (of_words != NULL && of == NULL)
		return false;
	bool ok = true;
	for (size_t i = 0; i < n && ok; i++)
		ok = add_drawn_quantity_once(d, &of[i]) ||
		     error_too_many_quantities(error);
	for (size_t i = 0; i < d->limits.n && ok; i++)
		ok = add_drawn_quantity_once(d, &d->limits.at[i].quantity) ||
		     error_too_many_quantities(error);
	if (ok && d->n == 0)
		choose_sieves_for_response_plot(s, d);
	return ok;
}

/* Returns the style of quantity i, in a colour that no run has and a line that
 * differs from the others even without colour. */
static struct chart_series
quantity_line_style(size_t i)
{
	static const enum chart_line LINES[] = {
	    CHART_SOLID, CHART_DASHED, CHART_LONG};
	struct chart_series look = site_chart_series_style(i);
	look.line = LINES[i % ARRAY_LEN(LINES)];
	look.mark = 0;
	return look;
}

static void
add_measured_quantity_marks(
    struct chart *chart, const struct session *s, struct drawn *d, size_t i)
{
	const struct entry *entry = d->asked->entry;
	const struct site *site = entry->site;
	const struct quantity *q = &d->q[i];
	struct chart_series look = site_chart_series_style(i);
	look.line = CHART_MARKS;
	if (site_count_products(site) == 0 || site->with[0] != '\0')
		return;
	FREED char *name = quantities_name(q);
	struct chart_series *points =
	    chart_append_series(chart, look, site->n_run, "measured %s", name);
	points->n = 0;
	for (size_t r = 0; r < site->n_run; r++) {
		double speed = site->run[r].speed;
		if (speed < d->from || speed > d->to)
			continue;
		const struct psd *product = measured_product_moved_to_feed(
		    s, entry, &entry->params, r, d->asked->feed);
		double value = product->n > 0
				   ? screened_quantity_of_product(product, q)
				   : NAN;
		if (isnan(value))
			continue;
		points->x[points->n] = speed;
		points->y[points->n++] =
		    quantities_value_in_shown_unit(q, value);
		d->moved =
		    fmax(d->moved, largest_change_by_moving_to_feed(s, entry,
				       &entry->params, r, d->asked->feed));
	}
}

/* Adds a horizontal line at each limit on a quantity. */
static void
add_limit_lines_to_chart(struct chart *chart, const struct drawn *d, size_t i)
{
	struct chart_series look = site_chart_series_style(i);
	look.line = CHART_DOTTED;
	look.ascii = '.';
	look.mark = 0;
	for (size_t k = 0; k < 2 * d->limits.n; k++) {
		const struct condition *c = &d->limits.at[k / 2];
		double limit = k % 2 == 0 ? c->least : c->most;
		if (!quantity_is_same(&c->quantity, &d->q[i]) || isnan(limit))
			continue;
		FREED char *words = conditions_limit_text(
		    d->limits.at, (struct wanted_limit){k / 2, k % 2 == 1});
		double y = quantities_value_in_shown_unit(&c->quantity, limit);
		chart_append_point_series(chart, look, 2,
		    (double[]){d->from, d->to}, (double[]){y, y}, words);
	}
}

/* Sets a y axis with round limits that covers all series of the chart. */
static void
set_round_y_axis(struct chart *chart)
{
	struct chart_extent e = chart_compute_extent(chart);
	bool any = isfinite(e.y[0]);
	struct axis axis =
	    axis_new_linear(chart->y.title, any ? e.y[0] : 0, any ? e.y[1] : 1);
	axis_free(&chart->y);
	chart->y = axis;
}

/* Marks the range of the measured speeds. */
static void
mark_measured_speeds(struct chart *chart, const struct entry *entry)
{
	double slowest, fastest;
	if (!origin_training_speed_range(entry, &slowest, &fastest))
		return;
	FREED char *words =
	    answers_training_range_text(entry, slowest, fastest);
	if (!(fastest > slowest)) {
		chart_add_vertical_rule(
		    chart, SERIES_BREAK, slowest, "%s", words);
		return;
	}
	FREED char *from = answers_speed_text(entry->site, slowest, -1);
	FREED char *to = answers_speed_text(entry->site, fastest, -1);
	chart_add_vertical_rule(chart, SERIES_BREAK, slowest, "%.*s from %s",
	    (int)strcspn(words, ","), words, from);
	chart_add_vertical_rule(chart, SERIES_BREAK, fastest, "to %s", to);
}

/* Marks the ranges of speeds at which all conditions hold, and the best
 * speed. */
static void
mark_speed_window(
    struct chart *chart, const struct drawn *d, const struct speed_search *w)
{
	const struct site *site = d->asked->entry->site;
	for (size_t k = 0; k < w->n_inside; k++) {
		const struct speed_range *in = &w->inside[k];
		FREED char *from = answers_speed_text(site, in->from, 1);
		FREED char *to = answers_speed_text(site, in->to, 1);
		chart_add_vertical_rule(
		    chart, SERIES_OTHER, in->from, "limits met from %s", from);
		chart_add_vertical_rule(
		    chart, SERIES_OTHER, in->to, "to %s", to);
	}
	if (d->limits.n == 0 || !isfinite(w->margin.passing))
		return;
	FREED char *best = answers_speed_text(site, w->best, 1);
	chart_add_vertical_rule(chart, SERIES_CROSSHAIR, w->best, "%s %s",
	    w->n_inside > 0 ? tr("best") : tr("nearest"), best);
}

static void
note_certainty_of_window(struct chart *chart, const struct site *site,
    double level, const struct speed_search *w)
{
	FREED char *rpm =
	    rotor_speed_rpm_text(site->rotor, w->sure[0], w->sure[1]);
	if (w->n_inside == 0)
		chart_add_note(chart, "at no speed are all limits met");
	if (isnan(w->best_certain))
		return;
	if (isfinite(w->sure[0]))
		chart_add_note(chart,
		    "all limits met with %.0f %% certainty from %.1f to %.1f "
		    "m/s%s",
		    100 * level, w->sure[0], w->sure[1], rpm);
	else
		chart_add_note(chart,
		    "at no speed are all limits met with %.0f %% certainty",
		    100 * level);
}

/* Returns a chart of the quantities in a unit, or NULL if there are none, or
 * they already have a line. */
static struct chart *
make_chart_of_unit(struct session *s, struct drawn *d, const char *unit)
{
	static const struct {
		const char *unit, *title, *about;
	} TITLES[] = {{"%", N_("share, %"), N_("shares")},
	    {"mm", N_("size, mm"), N_("sizes")}};
	const char *about = tr("single figures");
	const struct site *site = d->asked->entry->site;
	size_t n = 0;
	for (size_t i = 0; i < d->n; i++)
		n += d->line[i] == NULL &&
		     strcmp(quantities_unit(&d->q[i]), unit) == 0;
	if (n == 0)
		return NULL;
	char *title = xasprintf(tr("value, %s"), unit[0] != '\0' ? unit : "-");
	for (size_t i = 0; i < ARRAY_LEN(TITLES); i++)
		if (strcmp(TITLES[i].unit, unit) == 0) {
			xfree_and_set(&title, xstrdup(tr(TITLES[i].title)));
			about = tr(TITLES[i].about);
		}
	struct chart *chart = site_chart_new(site,
	    axis_new_linear(tr("tip speed, m/s"), d->from, d->to),
	    (struct axis){.title = title},
	    answers_is_sheet_in_rpm(site) ? N_("%s against rotor speed")
					  : N_("%s against tip speed"),
	    about);
	chart->mixed = true;
	for (size_t i = 0; i < d->n; i++)
		if (strcmp(quantities_unit(&d->q[i]), unit) == 0) {
			FREED char *name = quantities_name(&d->q[i]);
			d->line[i] = chart_append_series(
			    chart, quantity_line_style(i), POINTS, "%s", name);
			add_measured_quantity_marks(chart, s, d, i);
			add_limit_lines_to_chart(chart, d, i);
		}
	mark_measured_speeds(chart, d->asked->entry);
	return chart;
}

static void
fill_quantity_chart_lines(
    struct session *s, struct drawn *d, struct chart *first)
{
	struct forecast *f = forecast_open(s, d->asked, d->q, d->n);
	site_chart_fill_forecast_by_speed(f, d->n, d->from, d->to, d->line);
	forecast_close(f);
	for (struct chart *c = first; c != NULL; c = c->below)
		set_round_y_axis(c);
}

static struct chart *
make_chart_for_each_unit(struct session *s, struct drawn *d)
{
	static const char *const FIRST[] = {"%", "mm", ""};
	const size_t n_first = ARRAY_LEN(FIRST);
	const struct entry *entry = d->asked->entry;
	struct chart *first = NULL, **next = &first, *last = NULL;
	for (size_t i = 0; i < n_first + d->n; i++) {
		*next = make_chart_of_unit(s, d,
		    i < n_first ? FIRST[i]
				: quantities_unit(&d->q[i - n_first]));
		if (*next != NULL) {
			last = *next;
			next = &last->below;
		}
	}
	fill_quantity_chart_lines(s, d, first);
	if (d->limits.n > 0) {
		struct conditions_search wanted =
		    conditions_open_search(s, d->asked, &d->limits, NULL);
		wanted.from = d->from;
		wanted.to = d->to;
		struct speed_search *w = speed_search_run(&wanted);
		for (struct chart *c = first; c != NULL; c = c->below)
			mark_speed_window(c, d, w);
		note_certainty_of_window(last, entry->site, wanted.level, w);
		speed_search_free(w);
		forecast_close(wanted.forecast);
	}
	FREED char *feed = feed_sampling_text(entry->site, d->asked->feed);
	if (feed != NULL)
		chart_add_note(last, "feed: %s", feed);
	site_chart_note_moved_products(last, d->moved);
	if (first->series[0]->low != NULL)
		chart_add_note(last, "shaded: %.0f %% uncertainty band",
		    100 * settings_band_probability(&s->set));
	else
		chart_add_note(last, "%s", band_why_missing(s, entry));
	/* The light at the middle speed, where it is at its best.  The lines
	 * reach beyond the measured speeds, which are marked. */
	FREED char *light = trust_in_words_at_speed(
	    s, entry, site_middle_speed(entry->site), d->asked->feed);
	chart_add_note(last, "%s", light);
	for (struct chart *c = first; c != NULL; c = c->below)
		site_chart_show_speeds_in_rpm(c, entry->site);
	return first;
}

/* Finds the range to draw: from the slowest of speeds= to the fastest, or,
 * without speeds=, the range of the settings. */
static bool
find_speed_range_to_plot(const struct session *s, const struct question *asked,
    double *from, double *to, struct error *error)
{
	settings_default_speed_range(&s->set, asked->entry->site, from, to);
	if (asked->n_at == 0)
		return true;
	*from = *to = asked->at[0];
	for (size_t i = 1; i < asked->n_at; i++) {
		*from = fmin(*from, asked->at[i]);
		*to = fmax(*to, asked->at[i]);
	}
	return *to > *from ||
	       error_set(error, ERROR_USAGE,
		   "response is drawn over a range of speeds, got only one\n"
		   "such as speeds=60..85");
}

struct chart *
plots_response(
    struct session *s, const struct plot_request *q, struct error *error)
{
	const struct entry *entry = q->asked.entry;
	struct drawn d = {.asked = &q->asked};
	struct chart *chart = NULL;
	if (!answers_require_params(s, entry, error))
		return NULL;
	if (!find_speed_range_to_plot(s, &q->asked, &d.from, &d.to, error))
		return NULL;
	if (parse_quantities_to_plot(s, q->of, q->limits, &d, error))
		chart = make_chart_for_each_unit(s, &d);
	conditions_free(&d.limits);
	return chart;
}

/* runs: plots each feed once, and each product with its prediction by the model
 * alone, as many as can be told apart.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/draw/plots.h"

#include "base/tr.h"
#include "base/xalloc.h"
#include "cmd/ask/answers.h"
#include "cmd/ask/feed.h"
#include "cmd/ask/outlook.h"
#include "cmd/draw/plots_search.h"
#include "cmd/draw/site_chart.h"
#include "core/answer/predict.h"

/* Marks of the predicted speeds, which no run has, so that they can be told
 * apart without colour. */
static const char MARKS[] = "#@%$szNH";
enum { MOST_SPEEDS = sizeof MARKS - 1 };

/* True if an earlier run has the same feed, or the run has none sampled. */
static bool
is_feed_drawn_already(const struct site *site, size_t run)
{
	if (!site_run_has_feed_sample(site, run))
		return true;
	for (size_t i = 0; i < run; i++)
		if (psd_is_same(&site->run[i].feed, &site->run[run].feed))
			return true;
	return false;
}

/* Adds the feeds in grey, each once.  own: the question has another. */
static void
add_distinct_feed_curves(struct chart *chart, const struct site *site, bool own)
{
	static const enum chart_line LINES[] = {
	    CHART_SOLID, CHART_LONG, CHART_DOTTED};
	static const char ASCII[] = ".,'";
	size_t n = 0;
	for (size_t i = 0; i < site->n_run; i++) {
		size_t kind = n % ARRAY_LEN(LINES);
		if (is_feed_drawn_already(site, i))
			continue;
		const struct run *r = &site->run[i];
		FREED char *speed = answers_speed_text(site, r->speed, -1);
		site_chart_add_psd(chart,
		    (struct chart_series){.series = SERIES_FEED,
			.line = LINES[kind],
			.ascii = ASCII[kind]},
		    &r->feed, NULL,
		    site->individual_feeds && r->speed > 0
			? xasprintf(tr("feed %s%s"), speed, r->repeat)
			: xstrdup(own ? tr("feed of the sheet") : tr("feed")));
		n++;
	}
}

/* Adds the prediction by the model alone, because that is what a held-out run
 * tests. */
static void
add_predicted_product_curve(struct chart *chart, const struct session *s,
    const struct entry *entry, const struct params *params, double speed,
    size_t feed, struct chart_series look, const char *repeat)
{
	struct prediction p = predict_with_model_alone(entry->site, params,
	    model_settings_with_scenario(s, entry), speed, feed);
	FREED char *at = answers_speed_text(entry->site, speed, -1);
	site_chart_add_psd(chart, look, &p.product, NULL,
	    xasprintf(tr("predicted %s%s"), at, repeat));
	prediction_free(&p);
}

/* Adds the product of a run and its prediction, which is left out if it is the
 * same as for the run before. */
static void
add_run_and_predicted_curve(struct chart *chart, const struct session *s,
    const struct entry *entry, const struct params *params, size_t run)
{
	static const char ASCII[] = "=~_\"`;";
	const struct site *site = entry->site;
	const struct run *r = &site->run[run];
	bool held_out = !entry->train[run];
	struct chart_series look = site_chart_run_style(site, run, held_out);
	struct chart_series dashed = {.series = look.series,
	    .line = CHART_DASHED,
	    .ascii = ASCII[run % (sizeof ASCII - 1)]};
	look.line = CHART_SOLID;
	look.ascii = '-';
	FREED char *speed = answers_speed_text(site, r->speed, -1);
	site_chart_add_psd(chart, look, &r->product, NULL,
	    xasprintf(
		held_out ? tr("measured %s%s (held out)") : tr("measured %s%s"),
		speed, r->repeat));
	if (params != NULL &&
	    (!site_run_repeats_speed(site, run) ||
		!psd_is_same(&site->run[run - 1].feed, &r->feed)))
		add_predicted_product_curve(
		    chart, s, entry, params, r->speed, run, dashed, r->repeat);
}

static void
add_predicted_curves_at_speeds(struct chart *chart, const struct session *s,
    const struct plot_request *q, const struct params *params)
{
	const struct site *site = q->asked.entry->site;
	for (size_t i = 0; i < q->asked.n_at; i++) {
		struct chart_series look = site_chart_series_style(i);
		look.line = CHART_LONG;
		look.mark = MARKS[i];
		add_predicted_product_curve(chart, s, q->asked.entry, params,
		    q->asked.at[i], q->asked.feed, look, "");
	}
	FREED char *words = feed_sampling_text(site, q->asked.feed);
	if (q->asked.n_at > 0 && words != NULL)
		chart_add_note(
		    chart, "feed at speeds that were not measured: %s", words);
}

static bool
has_bad_plot_speed(const struct plot_request *q, struct error *error)
{
	const struct site *site = entry_without_scenario(q->asked.entry)->site;
	if (q->asked.n_at > MOST_SPEEDS)
		return !error_set(error, ERROR_USAGE,
		    "%zu speeds are too many to draw\n"
		    "use at most %zu, so that the curves can be distinguished",
		    q->asked.n_at, (size_t)MOST_SPEEDS);
	for (size_t i = 0; i < q->asked.n_at; i++)
		if (site_run_at_speed(site, q->asked.at[i]) < site->n_run)
			return !error_set(error, ERROR_USAGE,
			    "%g m/s was measured and is drawn already\n"
			    "speeds= adds speeds that were not measured",
			    q->asked.at[i]);
	return false;
}

/* Adds all runs on one axis.  params may be NULL. */
static void
add_curves_of_all_runs(struct chart *chart, const struct session *s,
    const struct plot_request *q, const struct params *params)
{
	const struct entry *entry = entry_without_scenario(q->asked.entry);
	const struct site *site = entry->site;
	double middle = site_middle_speed(site);
	add_distinct_feed_curves(
	    chart, site, q->asked.entry->site->with[0] != '\0');
	for (size_t i = 0; i < site->n_run; i++)
		if (site_run_is_among_nearest(
			site, i, middle, SITE_CHART_SPEEDS))
			add_run_and_predicted_curve(chart, s, entry, params, i);
	site_chart_note_run_marks(chart, site);
	if (params == NULL)
		return;
	chart_add_note(chart,
	    site->individual_feeds
		? N_("predicted: the model alone, each run from its own feed")
		: N_("predicted: the model alone"));
	add_predicted_curves_at_speeds(chart, s, q, params);
}

/* Draws the paper's figure 7: each run's product as measured, solid, and as the
 * model alone predicts it from the run's own feed, dashed.  With `speeds` it is
 * figure 9: predictions at speeds that were not measured, from the feed of the
 * question.  Without parameters only what was measured is drawn. */
struct chart *
plots_runs(struct session *s, const struct plot_request *q, struct error *error)
{
	const struct site *site = entry_without_scenario(q->asked.entry)->site;
	struct params params;
	struct error unknown = {0};
	bool known = find_param_values_for_plot(s, q, &params, &unknown);
	if (has_bad_plot_speed(q, error))
		return NULL;
	if (!known && (q->generation > 0 || q->asked.n_at > 0)) {
		*error = unknown;
		return NULL;
	}
	size_t n;
	FREED double *size = site_all_sieves(site, &n);
	struct chart *chart = site_chart_new(site,
	    site_chart_sieve_axis(size, n), axis_new_percent(tr("passing, %")),
	    site_count_products(site) == 0 ? N_("feed")
	    : known ? N_("products measured and predicted")
		    : N_("feed and products"));
	add_curves_of_all_runs(chart, s, q, known ? &params : NULL);
	if (!known)
		chart_add_note(chart, "no prediction: %s", unknown.text);
	return chart;
}

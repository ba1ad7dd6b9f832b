/* The functions that make and draw a chart of any kind, the table of all kinds,
 * and the charts residuals, parity, selection and appearance.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/draw/plots.h"

#include <math.h>
#include <string.h>

#include "base/tr.h"
#include "base/xalloc.h"
#include "cmd/ask/answers.h"
#include "cmd/ask/outlook.h"
#include "cmd/draw/plots_search.h"
#include "cmd/draw/site_chart.h"
#include "cmd/fit/trials.h"
#include "cmd/session/sites.h"
#include "core/numeric/elementary.h"
#include "core/model/breakage.h"
#include "core/model/selection.h"
#include "core/search/misfit.h"
#include "core/answer/predict.h"
#include "core/check/validate.h"
#include "io/sitefile/units.h"

struct plot_request
plots_default_request(enum plot_kind kind)
{
	enum { STRIP = 6 }; /* rows, with the title */
	return (struct plot_request){.kind = kind,
	    .asked = {.feed = SITE_MEAN_FEED,
		.speed = NAN,
		.fraction = {.partition = PARTITION_IDEAL}},
	    .other_speed = NAN,
	    .crosshair_mm = NAN,
	    .level = 50,
	    .charset = CHARSET_ASCII,
	    .words = CHART_ALL,
	    .strip = STRIP};
}

/* Adds a series of predicted minus measured passing of a run, in points.  At
 * sieves that its feed does not cover the series has a gap. */
static void
add_residual_series(struct chart *chart, const struct session *s,
    const struct entry *entry, size_t run, const struct params *params,
    struct chart_series look)
{
	const struct run *r = &entry->site->run[run];
	const struct psd *product = &r->product;
	struct prediction p = predict_with_model_alone(
	    entry->site, params, s->set.model, r->speed, run);
	FREED char *speed = answers_speed_text(entry->site, r->speed, -1);
	struct chart_series *series =
	    chart_append_series(chart, look, product->n, "%s%s%s", speed,
		r->repeat, entry->train[run] ? "" : tr(" (held out)"));
	for (size_t i = 0; i < product->n; i++) {
		double predicted = psd_passing(&p.product, product->size[i]);
		series->x[i] = units_m_to_mm(product->size[i]);
		series->y[i] = i < misfit_count_covered_sieves(r)
				   ? 100 * (predicted - product->passing[i])
				   : NAN;
	}
	prediction_free(&p);
}

/* Returns a y axis with round limits for the chart, which includes 0 and has a
 * guide line there. */
static struct axis
axis_including_zero(const struct chart *chart, const char *title)
{
	struct chart_extent e = chart_compute_extent(chart);
	struct axis axis =
	    axis_new_linear(title, fmin(0, e.y[0]), fmax(0, e.y[1]));
	for (size_t i = 0; i < axis.n; i++)
		axis.tick[i].guide = axis.tick[i].at == 0;
	return axis;
}

static struct chart *
residuals_chart(
    struct session *s, const struct plot_request *q, struct error *error)
{
	const struct site *site = q->asked.entry->site;
	struct params params;
	if (!find_param_values_for_plot(s, q, &params, error))
		return NULL;
	size_t compared = 0;
	for (size_t i = 0; i < site->n_run; i++)
		compared += misfit_count_covered_sieves(&site->run[i]) > 0;
	if (compared == 0) {
		error_set(error, ERROR_USAGE,
		    site_count_products(site) == 0
			? N_("%s has no measured product\n"
			     "'add' a belt cut, or load a site file with "
			     "products")
			: N_("%s: no product sieve is in the range of the "
			     "feed's sieves\n"
			     "sieve the feed as far down as the product"),
		    site->name);
		return NULL;
	}
	double middle = site_middle_speed(site);
	struct chart *chart = site_chart_new(site, (struct axis){0},
	    (struct axis){0}, "predicted minus measured, sieve by sieve");
	for (size_t i = 0; i < site->n_run; i++) {
		if (!site_run_is_among_nearest(
			site, i, middle, SITE_CHART_SPEEDS) ||
		    misfit_count_covered_sieves(&site->run[i]) == 0)
			continue;
		struct chart_series look =
		    site_chart_run_style(site, i, !q->asked.entry->train[i]);
		look.line = CHART_SOLID;
		look.ascii = look.mark;
		add_residual_series(chart, s, q->asked.entry, i, &params, look);
	}
	site_chart_set_sieve_axis(chart);
	chart->y = axis_including_zero(chart, tr("difference, points"));
	return chart;
}

static void
add_parity_points(struct chart *chart, const struct session *s,
    const struct trials *pairs, double low, double high)
{
	const double ends[] = {low, high};
	chart_append_point_series(
	    chart, SITE_CHART_LEVEL, 2, ends, ends, tr("as measured"));
	for (size_t i = 0; i < PSD_SIZES; i++) {
		struct chart_series look = site_chart_series_style(i);
		look.line = CHART_MARKS;
		struct chart_series *p = chart_append_series(
		    chart, look, pairs->n, "%s", PSD_NAME[i]);
		chart_allocate_point_names(p);
		for (size_t j = 0; j < pairs->n; j++) {
			const struct trial *of = &pairs->item[j];
			const struct site *site = s->entry[of->entry].site;
			p->whose[j] = (struct chart_whose){xstrdup(of->key),
			    site_provenance_first_clause(site, ""), NULL};
			p->x[j] = 1000 * of->v.measured[i];
			p->y[j] = isnan(p->x[j])
				      ? NAN
				      : 1000 * of->v.size[VALIDATE_MODEL][i];
		}
	}
}

/* Notes the figures of validate all: "P50: bias -0.3 %, RMS 1.2 %, R2 0.9987;
 * 19 runs". */
static void
note_bias_and_rms(struct chart *chart, const struct trials *pairs)
{
	for (size_t i = 0; i < PSD_SIZES; i++) {
		char r2[16] = "-";
		struct validate_score score =
		    trials_score_at_size(pairs, VALIDATE_MODEL, i);
		if (score.n == 0)
			continue;
		if (!isnan(score.r2))
			snprintf(r2, sizeof r2, "%.4f", score.r2);
		chart_add_note(chart,
		    tr_n("P%g: bias %+.2f %%, RMS %.2f %%, R2 %s; %zu run",
			"P%g: bias %+.2f %%, RMS %.2f %%, R2 %s; %zu runs",
			score.n),
		    100 * PSD_PASSING[i], 100 * score.bias, 100 * score.rms, r2,
		    score.n);
	}
}

static struct chart *
parity_chart(
    struct session *s, const struct plot_request *q, struct error *error)
{
	(void)q;
	struct trials pairs = {.n = 0};
	struct chart *chart = NULL;
	double low = INFINITY, high = 0;
	for (size_t i = 0; i < s->n_entry; i++)
		if (s->entry[i].has_params)
			trials_add_held_out_runs_of_site(&pairs, s, i, NULL);
	for (size_t j = 0; j < PSD_SIZES * pairs.n; j++) {
		const struct validation *v = &pairs.item[j / PSD_SIZES].v;
		double measured = 1000 * v->measured[j % PSD_SIZES];
		double predicted =
		    1000 * v->size[VALIDATE_MODEL][j % PSD_SIZES];
		low = fmin(low, fmin(measured, predicted));
		high = fmax(high, fmax(measured, predicted));
	}
	if (high > 0) {
		struct axis x = axis_new_log(tr("measured, mm"), low, high);
		struct axis y = axis_new_log(tr("predicted, mm"), low, high);
		size_t sites;
		FREED char *about = trials_data_sources_text(&pairs, &sites);
		FREED char *title =
		    xasprintf(tr_n("sizes at held-out speeds, %zu site",
				  "sizes at held-out speeds, %zu sites", sites),
			sites);
		chart = chart_new(title, about, x, y);
		add_parity_points(chart, s, &pairs, x.low, x.high);
		note_bias_and_rms(chart, &pairs);
	} else {
		error_set(error, ERROR_USAGE,
		    "no loaded site has both parameters and a product at a "
		    "held-out speed\n"
		    "load sites with three speeds, then run 'calibrate', or "
		    "'calibrate all' for all of them");
	}
	trials_clear(&pairs);
	return chart;
}

enum { SAMPLES = 241 };

/* Returns value i of SAMPLES from low to high, evenly spaced on a log scale. */
static double
log_spaced_value(double low, double high, size_t i)
{
	return low * pow(high / low, (double)i / (SAMPLES - 1));
}

static void
add_selection_function_curve(struct chart *chart, const struct session *s,
    const struct entry *entry, const struct params *params, double speed,
    struct chart_series look)
{
	struct model_settings settings = model_settings_with_scenario(s, entry);
	FREED char *at = answers_speed_text(entry->site, speed, -1);
	struct chart_series *series =
	    chart_append_series(chart, look, SAMPLES, "%s", at);
	struct breaker b;
	breaker_set_params(&b, params, &settings);
	breaker_set_speed(&b, speed);
	for (size_t i = 0; i < SAMPLES; i++) {
		series->x[i] = log_spaced_value(chart->x.low, chart->x.high, i);
		series->y[i] = 100 * selection_share_at_log_size(
					 &b, el_log(series->x[i] / 1000));
	}
	double mm =
	    1000 * params_break_size_by_impacts(params, &settings, speed);
	chart_add_vertical_rule(chart,
	    look.series == SERIES_OTHER ? SERIES_OTHER : SERIES_BREAK, mm,
	    "break size %.2f mm at %s", mm, at);
}

static struct chart *
selection_function_chart(
    struct session *s, const struct plot_request *q, struct error *error)
{
	const struct site *site = q->asked.entry->site;
	double speed =
	    isnan(q->asked.speed) ? site_middle_speed(site) : q->asked.speed;
	struct params params;
	if (!find_param_values_for_plot(s, q, &params, error))
		return NULL;
	const struct psd *feed = site_feed_of_run(site, q->asked.feed);
	struct chart *chart =
	    site_chart_new(site, site_chart_sieve_axis(feed->size, feed->n),
		axis_new_percent(tr("share that breaks S(x), %")),
		"selection function (Eq 3)");
	if (!isnan(q->other_speed))
		add_selection_function_curve(chart, s, q->asked.entry, &params,
		    q->other_speed,
		    (struct chart_series){.series = SERIES_OTHER,
			.line = CHART_LONG,
			.ascii = '%'});
	add_selection_function_curve(
	    chart, s, q->asked.entry, &params, speed, SITE_CHART_PREDICTED);
	return chart;
}

static struct chart *
appearance_function_chart(
    struct session *s, const struct plot_request *q, struct error *error)
{
	struct params params;
	if (!find_param_values_for_plot(s, q, &params, error))
		return NULL;
	if (s->set.model.appearance != APPEARANCE_RATIO) {
		error_set(error, ERROR_USAGE,
		    "only the appearance function of the form ratio can be "
		    "drawn\n"
		    "run 'show appearance' for the matrix of any form");
		return NULL;
	}
	const struct site *site = q->asked.entry->site;
	double speed =
	    isnan(q->asked.speed) ? site_middle_speed(site) : q->asked.speed;
	struct breaker b;
	breaker_set_params(&b, &params, &s->set.model);
	breaker_set_speed(&b, speed);
	struct chart *chart = site_chart_new(site,
	    axis_new_log(tr("size ratio u: progeny / parent, -"), 0.001, 1),
	    axis_new_percent(tr("share finer than u: B(u), %")),
	    "appearance function (Eq 1)");
	struct chart_series *curve =
	    chart_append_series(chart, SITE_CHART_PREDICTED, SAMPLES, "B(u)");
	for (size_t i = 0; i < SAMPLES; i++) {
		curve->x[i] = log_spaced_value(chart->x.low, chart->x.high, i);
		curve->y[i] =
		    100 * answers_breakage_at_ratio(&b, curve->x[i], site);
	}
	return chart;
}

/* Notes which model the site's parameters belong to, if it is not that of the
 * paper. */
static void
note_model_unless_of_paper(
    struct chart *chart, const struct session *s, const struct entry *entry)
{
	if (entry == NULL || !entry->has_params)
		return;
	const struct breakage *model = breakage_model_of_params(&entry->params);
	bool energies = s->set.model.impacts.n > 0;
	if (model == BREAKAGES[0] && !energies)
		return;
	chart_add_note(chart,
	    energies ? N_("model: %s, with collision energies")
		     : N_("model: %s"),
	    model->name);
}

/* Returns the chart through an argument, because cppcheck mistakes a returned
 * chart for the request. */
static void
make_chart_in_theme(plot_make *make, struct session *s,
    const struct plot_request *request, struct chart **chart,
    struct error *error)
{
	*chart = make(s, request, error);
	if (*chart == NULL)
		return;
	(*chart)->theme = (enum theme)s->set.theme;
	if (request->kind != PLOT_MAP && request->kind != PLOT_ENERGY)
		note_model_unless_of_paper(*chart, s, request->asked.entry);
}

struct chart *
plots_make_chart(
    struct session *s, const struct plot_request *request, struct error *error)
{
	static const struct {
		plot_make *make;
		bool any_site;
		bool asks; /* uses the feed and the machine of the question */
	} KINDS[] = {[PLOT_PSD] = {plots_psd, false, true},
	    [PLOT_RUNS] = {plots_runs, false, true},
	    [PLOT_PARITY] = {parity_chart},
	    [PLOT_CONVERGENCE] = {plots_search_convergence},
	    [PLOT_SPREAD] = {plots_search_param_spread},
	    [PLOT_RESIDUALS] = {residuals_chart},
	    [PLOT_SELECTION] = {selection_function_chart, false, true},
	    [PLOT_APPEARANCE] = {appearance_function_chart},
	    [PLOT_MAP] = {plots_material_map, true},
	    [PLOT_SWEEP] = {plots_sweep, false, true},
	    [PLOT_RESPONSE] = {plots_response, false, true},
	    [PLOT_PROFILE] = {plots_parameter_profile},
	    [PLOT_CORRELATION] = {plots_parameter_correlations},
	    [PLOT_DRIFT] = {plots_control_charts},
	    [PLOT_SEARCH] = {plots_candidate_residuals},
	    [PLOT_ENERGY] = {plots_impact_energies, true}};
	if (!KINDS[request->kind].any_site &&
	    !session_require_site(s, tr("this plot"), error))
		return NULL;
	size_t at = s->current;
	if (request->site != NULL &&
	    !session_find_site(s, request->site, &at, error))
		return NULL;
	struct plot_request as = *request;
	if (as.asked.entry == NULL && s->n_entry > 0)
		as.asked.entry = &s->entry[at];
	if (as.asked.entry != NULL && !KINDS[as.kind].asks)
		as.asked.entry = entry_without_scenario(as.asked.entry);
	as.asked.level = settings_band_probability(&s->set);
	struct chart *chart = NULL;
	make_chart_in_theme(KINDS[as.kind].make, s, &as, &chart, error);
	return chart;
}

/* Returns a value with the unit of its axis: "82.1 %". */
static char *
value_with_unit_text(const struct axis *axis, double value)
{
	const char *unit = axis_unit_suffix(axis);
	return xasprintf(
	    strcmp(unit, " %") == 0 ? "%.1f%s" : "%.4g%s", value, unit);
}

static char *
text_of_mark_near_cell(const struct chart_found *f)
{
	const struct chart_series *of = f->series;
	if (of == NULL)
		return NULL;
	FREED char *x = value_with_unit_text(&f->chart->x, of->x[f->point]),
		   *y = value_with_unit_text(&f->chart->y, of->y[f->point]);
	bool whose = of->whose != NULL && of->whose[f->point].site != NULL;
	return xasprintf("%s%s%s: %s, %s",
	    whose ? of->whose[f->point].site : "", whose ? ", " : "", of->name,
	    x, y);
}

bool
plots_find_mark_at_cell(struct session *s, const struct plot_request *request,
    int columns, int rows, int column, int row, struct plots_found *found)
{
	struct error error = {0};
	struct chart_found f;
	struct chart *chart = plots_make_chart(s, request, &error);
	if (chart == NULL)
		return false;
	bool in = chart_find_data_at_cell(chart, columns, rows,
	    request->charset, request->words, column, row, &f);
	if (in)
		*found =
		    (struct plots_found){f.x, f.y, text_of_mark_near_cell(&f)};
	chart_free(chart);
	return in;
}

struct canvas *
plots_draw_canvas(struct session *s, const struct plot_request *request,
    int columns, int rows, struct error *error)
{
	struct chart *chart = plots_make_chart(s, request, error);
	if (chart == NULL)
		return NULL;
	struct canvas *canvas =
	    chart_draw(chart, columns, rows, request->charset, request->words);
	chart_free(chart);
	return canvas;
}

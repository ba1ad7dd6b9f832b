/* Plots over the sieves: the products at a speed, those of several speeds, and
 * what is left between measured and predicted.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/xalloc.h"
#include "cmd/answers.h"
#include "cmd/doubt.h"
#include "cmd/origin.h"
#include "cmd/plots.h"
#include "core/misfit.h"
#include "core/predict.h"
#include "io/units.h"

/* Curves to be drawn on one axis.  psd is borrowed, or of a prediction that
 * is kept for it. */
struct curves {
	size_t n, n_prediction;
	struct {
		const struct psd *psd;
		char *name;
		struct chart_series look;
	} item[16];
	struct prediction prediction[8];
};

static const struct chart_series PREDICTED = {
    .series = SERIES_PREDICTED, .line = CHART_DASHED, .ascii = '#'};
static const struct chart_series OTHER = {
    .series = SERIES_OTHER, .line = CHART_LONG, .ascii = '%', .mark = '%'};

/* Takes the name. */
static void
add_curve(struct curves *c, const struct psd *psd, char *name,
    struct chart_series look)
{
	c->item[c->n].psd = psd;
	c->item[c->n].name = name;
	c->item[c->n++].look = look;
}

/* One that is kept with the curves. */
static const struct prediction *
make_prediction(struct curves *c, const struct session *s,
    const struct site *site, const struct params *params, double speed,
    size_t feed)
{
	struct prediction *p = &c->prediction[c->n_prediction++];
	*p = predict(site, params, s->set.model, speed, feed);
	return p;
}

/* The sieves of all curves as an axis. */
static struct axis
sieves_of(const struct curves *c)
{
	size_t n = 0;
	double *size = NULL;
	for (size_t i = 0; i < c->n; i++) {
		const struct psd *psd = c->item[i].psd;
		size = xrealloc(size, n + psd->n + 1, sizeof *size);
		for (size_t j = 0; j < psd->n; j++)
			size[n++] = units_mm(psd->size[j]);
	}
	struct axis axis = axis_sieves("size, mm", size, n);
	free(size);
	return axis;
}

static void
put_curves(struct chart *chart, const struct curves *c)
{
	for (size_t i = 0; i < c->n; i++) {
		const struct psd *psd = c->item[i].psd;
		struct chart_series *s = chart_add(
		    chart, c->item[i].look, psd->n, "%s", c->item[i].name);
		for (size_t j = 0; j < psd->n; j++) {
			s->x[j] = units_mm(psd->size[j]);
			s->y[j] = units_pct(psd->passing[j]);
		}
	}
}

static void
free_curves(struct curves *c)
{
	for (size_t i = 0; i < c->n; i++)
		free(c->item[i].name);
	for (size_t i = 0; i < c->n_prediction; i++)
		prediction_free(&c->prediction[i]);
}

static void
add_measured(
    struct curves *c, const struct site *site, double speed, size_t most)
{
	size_t taken = 0;
	for (size_t i = 0; i < site->n_run; i++)
		if (site_run_is_near(site, i, speed, most))
			add_curve(c, &site->run[i].product,
			    xasprintf("measured %g m/s", site->run[i].speed),
			    plots_look(taken++));
}

/* What is read at a place: chart_at at a size, chart_at_y at a passing. */
typedef double reading(
    const struct chart *, const struct chart_series *, double);

/* Adds " feed 16.0 %" to a note, or " predicted 33.1 % (31.6 to 34.5)" of what
 * has a band, or " feed -". */
static void
add_reading(char **note, const struct chart *chart,
    const struct chart_series *s, reading *read, double at)
{
	struct chart_series low = *s, high = *s;
	int digits = read == chart_at ? 1 : 2;
	double own = read(chart, s, at);
	if (isnan(own)) {
		xappend(note, " %s -", s->name);
		return;
	}
	xappend(note, " %s %.*f %s", s->name, digits, own,
	    read == chart_at ? "%" : "mm");
	if (s->low == NULL)
		return;
	low.y = s->low;
	high.y = s->high;
	double a = read(chart, &low, at), b = read(chart, &high, at);
	if (!isnan(a) && !isnan(b))
		xappend(note, " (%.*f to %.*f)", digits, fmin(a, b), digits,
		    fmax(a, b));
}

/* "at 2 mm: feed 16.0 %, measured 69 m/s 29.0 %", and of each curve the size
 * that the level passes. */
static void
note_crosshair(struct chart *chart, double x, double level)
{
	char *at = xasprintf("at %g mm:", x);
	char *sizes = xasprintf("%g %% pass:", level);
	for (size_t i = 0; i < chart->n; i++) {
		const char *comma = i + 1 < chart->n ? "," : "";
		add_reading(&at, chart, &chart->series[i], chart_at, x);
		add_reading(
		    &sizes, chart, &chart->series[i], chart_at_y, level);
		xappend(&at, "%s", comma);
		xappend(&sizes, "%s", comma);
	}
	chart_add_rule(chart, SERIES_CROSSHAIR, x, "crosshair at %g mm", x);
	chart_note(chart, "%s", at);
	chart_note(chart, "%s", sizes);
	free(at);
	free(sizes);
}

/* A rule at the break size and a note; whose: the site it is of, or NULL where
 * that is no longer loaded.  The name of a rule tells no numbers where there
 * are no notes. */
static void
note_prediction(struct chart *chart, const struct plot_request *q,
    const struct entry *whose, const struct prediction *p, const char *name,
    enum series series)
{
	double mm = 1000 * p->break_size;
	if (!(q->words & CHART_NOTES))
		chart_add_rule(chart, series, mm, "%sbreak size",
		    series == SERIES_OTHER ? "pin " : "");
	else if (series == SERIES_OTHER && q->beside != NULL)
		chart_add_rule(
		    chart, series, mm, "%s: break size %.2f mm", q->beside, mm);
	else
		chart_add_rule(chart, series, mm,
		    "break size %.2f mm at %g m/s", mm, p->speed);
	char p20[32], p50[32], p80[32];
	char *const words[] = {p20, p50, p80};
	for (size_t i = 0; i < PSD_SIZES; i++)
		snprintf(words[i], sizeof p20,
		    isnan(p->size[i]) ? "outside" : "%.2f mm",
		    1000 * p->size[i]);
	bool beyond = whose != NULL && answers_extrapolates(whose, p->speed);
	chart_note(chart, "%s: P20 %s, P50 %s, P80 %s%s", name, p20, p50, p80,
	    beyond ? "; extrapolated" : "");
	if (whose == NULL || origin_key(whose) == whose->key)
		return;
	char *from = origin_sentence(whose);
	chart_note(
	    chart, "%s%s", origin_is_other(whose) ? "warning: " : "", from);
	free(from);
}

/* The shade of a prediction with the site's own parameters, whose series is the
 * chart's last. */
static void
shade_prediction(
    struct chart *chart, struct session *s, const struct prediction *p)
{
	const struct band *band = doubt_band(s, session_entry(s), p);
	if (band == NULL) {
		chart_note(chart, "%s", doubt_why_none(session_entry(s)));
		return;
	}
	struct chart_series *series = &chart->series[chart->n - 1];
	chart_add_band(series);
	for (size_t i = 0; i < series->n; i++) {
		series->low[i] = units_pct(band->low[i]);
		series->high[i] = units_pct(band->high[i]);
	}
	char p50[64] = "";
	if (isfinite(band->p50[0]) && isfinite(band->p50[1]))
		snprintf(p50, sizeof p50, "; P50 %.2f to %.2f mm",
		    1000 * band->p50[0], 1000 * band->p50[1]);
	chart_note(
	    chart, "shaded: %d %% uncertainty band%s", UNCERTAINTY_LEVEL, p50);
}

/* A second prediction beside the first, and the site it is of; p NULL: there is
 * none. */
struct second {
	const struct prediction *p;
	const struct entry *whose; /* NULL: no longer loaded */
};

/* own: parameters of the site in use, or NULL; speed and feed are those of the
 * first.  False with an error where the site beside has no prediction. */
static bool
add_second(struct curves *c, struct session *s, const struct plot_request *q,
    const struct params *own, double speed, size_t feed, struct second *second,
    struct error *error)
{
	size_t i = s->current;
	struct error gone = {0};
	bool beside = q->beside != NULL, kept = q->kept != NULL;
	*second = (struct second){.p = q->kept};
	if (beside && session_find(s, q->beside, &i, kept ? &gone : error))
		second->whose = &s->entry[i];
	else if (beside && !kept)
		return false;
	else if (!beside)
		second->whose = session_entry(s);
	if (!kept && i != s->current) {
		if (!answers_known(s, second->whose, error))
			return false;
		own = &second->whose->params;
	}
	if (!kept && (own == NULL || (!beside && isnan(q->other_speed))))
		return true;
	if (!kept) {
		const struct site *site = second->whose->site;
		double v = isnan(q->other_speed) ? speed : q->other_speed;
		if (i != s->current)
			feed = site_run_nearest(site, v);
		second->p = make_prediction(c, s, site, own, v, feed);
	}
	char *name = xasprintf("%s %s%s%g m/s", kept ? "pin" : "predicted",
	    beside ? q->beside : "", beside ? " " : "", second->p->speed);
	add_curve(c, &second->p->product, name, OTHER);
	return true;
}

/* What is to be said of the two, whose curves are the chart's last. */
static void
note_curves(struct chart *chart, struct session *s,
    const struct plot_request *q, const struct prediction *one,
    const struct second *two, bool shade)
{
	const struct entry *entry = session_entry(s);
	const struct chart_series *last = &chart->series[chart->n - 1];
	if (one != NULL)
		note_prediction(chart, q, entry, one, last->name, SERIES_BREAK);
	if (one != NULL && shade)
		shade_prediction(chart, s, one);
	if (two->p != NULL)
		note_prediction(chart, q, two->whose, two->p,
		    last[one != NULL ? -1 : 0].name, SERIES_OTHER);
}

/* Named by its run where another one is nearer to the speed. */
static void
add_feed(struct curves *c, const struct plot_request *q,
    const struct site *site, size_t run, double speed)
{
	bool sampled =
	    site->individual_feeds &&
	    (!(q->words & CHART_NOTES) || run != site_run_nearest(site, speed));
	add_curve(c, &site->run[run].feed,
	    sampled ? xasprintf("feed %g m/s", site->run[run].speed)
		    : xstrdup("feed"),
	    PLOTS_FEED);
}

struct chart *
plots_psd(struct session *s, const struct plot_request *q, struct error *error)
{
	const struct entry *entry = session_entry(s);
	const struct site *site = entry->site;
	double speed = isnan(q->speed) ? answers_middle(site) : q->speed;
	size_t feed =
	    site_run_nearest(site, q->feed_speed > 0 ? q->feed_speed : speed);
	struct curves c = {0};
	struct params params = {0};
	struct error unknown = {0};
	struct second two;
	/* What was measured is worth a look before there are parameters. */
	bool known = plots_params(s, q, &params, &unknown);
	if (!known && q->generation > 0) {
		*error = unknown;
		return NULL;
	}
	add_feed(&c, q, site, feed, speed);
	add_measured(&c, site, speed, PLOTS_MEASURED);
	if (!add_second(
		&c, s, q, known ? &params : NULL, speed, feed, &two, error)) {
		free_curves(&c);
		return NULL;
	}
	const struct prediction *one =
	    !known ? NULL
	    : q->made != NULL
		? q->made
		: make_prediction(&c, s, site, &params, speed, feed);
	if (known)
		add_curve(&c, &one->product,
		    q->words & CHART_NOTES
			? xasprintf("predicted %g m/s", speed)
			: xstrdup("predicted"),
		    PREDICTED);
	struct chart *chart =
	    plots_site_chart(site, sieves_of(&c), axis_percent("passing, %"),
		known                     ? "product at %.1f m/s"
		: site_products(site) > 0 ? "feed and products"
					  : "feed",
		speed);
	put_curves(chart, &c);
	bool own = memcmp(&entry->params, &params, sizeof params) == 0;
	note_curves(chart, s, q, one, &two, q->band && own);
	if (!known)
		chart_note(chart, "no prediction: %s", unknown.text);
	if (!isnan(q->crosshair_mm))
		note_crosshair(chart, q->crosshair_mm, q->level);
	free_curves(&c);
	return chart;
}

struct chart *
plots_sweep(
    struct session *s, const struct plot_request *q, struct error *error)
{
	const struct site *site = session_entry(s)->site;
	size_t n = q->n_speed;
	struct curves c = {0};
	struct params params;
	if (!plots_params(s, q, &params, error))
		return NULL;
	if (n > ARRAY_LEN(c.prediction)) {
		error_set(error, ERROR_USAGE,
		    "%zu speeds are too many to draw\n"
		    "use at most %zu, which can be told apart",
		    n, ARRAY_LEN(c.prediction));
		return NULL;
	}
	size_t feed = site_run_nearest(
	    site, q->feed_speed > 0 ? q->feed_speed : answers_middle(site));
	add_curve(&c, &site->run[feed].feed, xstrdup("feed"), PLOTS_FEED);
	double *usual = n == 0 ? answers_speeds(site, &n) : NULL;
	const double *speed = usual != NULL ? usual : q->speeds;
	for (size_t i = 0; i < n; i++)
		add_curve(&c,
		    &make_prediction(&c, s, site, &params, speed[i], feed)
			 ->product,
		    xasprintf("predicted %g m/s", speed[i]), plots_look(i));
	free(usual);
	struct chart *chart = plots_site_chart(site, sieves_of(&c),
	    axis_percent("passing, %"), "products at %zu speeds", n);
	put_curves(chart, &c);
	free_curves(&c);
	return chart;
}

/* The product of a run and the prediction for it at the sieves that its feed
 * covers: differences in points. */
static void
add_residuals(struct chart *chart, struct session *s, size_t run,
    const struct params *params, struct chart_series look)
{
	const struct entry *entry = session_entry(s);
	const struct run *r = &entry->site->run[run];
	size_t n = misfit_covered(r);
	struct prediction p =
	    predict(entry->site, params, s->set.model, r->speed, run);
	struct chart_series *series = chart_add(chart, look, n, "%g m/s%s",
	    r->speed, entry->train[run] ? "" : " (held out)");
	for (size_t i = 0; i < n; i++) {
		double predicted = psd_passing(&p.product, r->product.size[i]);
		series->x[i] = units_mm(r->product.size[i]);
		series->y[i] = 100 * (predicted - r->product.passing[i]);
	}
	prediction_free(&p);
}

/* A round axis that holds all y of the chart and 0, with a guide at 0. */
static struct axis
around_zero(const struct chart *chart, const char *title)
{
	double low = 0, high = 0;
	for (size_t i = 0; i < chart->n; i++)
		for (size_t j = 0; j < chart->series[i].n; j++) {
			low = fmin(low, chart->series[i].y[j]);
			high = fmax(high, chart->series[i].y[j]);
		}
	struct axis axis = axis_linear(title, low, high);
	for (size_t i = 0; i < axis.n; i++)
		axis.tick[i].guide = axis.tick[i].at == 0;
	return axis;
}

struct chart *
plots_residuals(
    struct session *s, const struct plot_request *q, struct error *error)
{
	enum { MOST = 12 };
	const struct site *site = session_entry(s)->site;
	struct params params;
	struct curves c = {0};
	if (!plots_params(s, q, &params, error))
		return NULL;
	size_t compared = 0, taken = 0;
	for (size_t i = 0; i < site->n_run; i++)
		compared += misfit_covered(&site->run[i]) > 0;
	if (compared == 0) {
		error_set(error, ERROR_USAGE,
		    site_products(site) == 0 ? "%s has no measured product"
					     : "%s: no product sieve is in the "
					       "range of the feed's sieves",
		    site->name);
		return NULL;
	}
	double middle = answers_middle(site);
	add_measured(&c, site, middle, MOST);
	struct chart *chart = plots_site_chart(site, sieves_of(&c),
	    (struct axis){0}, "predicted minus measured, sieve by sieve");
	for (size_t i = 0; i < site->n_run; i++) {
		if (!site_run_is_near(site, i, middle, MOST))
			continue;
		struct chart_series look = plots_look(taken++);
		if (misfit_covered(&site->run[i]) > 0)
			add_residuals(chart, s, i, &params, look);
	}
	chart->y = around_zero(chart, "difference, points");
	free_curves(&c);
	return chart;
}

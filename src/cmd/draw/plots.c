/* Plots of a session: functions that all kinds share, most of the kinds, and
 * the table of all.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/draw/plots.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/tr.h"
#include "base/xalloc.h"
#include "cmd/ask/answers.h"
#include "cmd/ask/feed.h"
#include "cmd/ask/moved.h"
#include "cmd/ask/forecast.h"
#include "cmd/ask/outlook.h"
#include "cmd/ask/quantity_words.h"
#include "cmd/ask/screened.h"
#include "cmd/ask/pin.h"
#include "cmd/ask/asked.h"
#include "cmd/draw/plots_difference.h"
#include "cmd/draw/plots_limits.h"
#include "cmd/draw/plots_past.h"
#include "cmd/draw/plots_search.h"
#include "cmd/draw/site_chart.h"
#include "cmd/fit/trials.h"
#include "cmd/session/sites.h"
#include "core/numeric/elementary.h"
#include "core/model/breakage.h"
#include "core/search/misfit.h"
#include "core/answer/predict.h"
#include "core/check/validate.h"
#include "io/sitefile/units.h"
#include "plot/marks.h"

/* The looks of a feed, or what lies behind, and of a single curve. */
static const struct chart_series FEED = {
    .series = SERIES_FEED, .line = CHART_DOTTED, .ascii = '.'};
static const struct chart_series PREDICTED = {
    .series = SERIES_PREDICTED, .line = CHART_SOLID, .ascii = '#'};

struct plot_request
plots_request(enum plot_kind kind)
{
	return (struct plot_request){.kind = kind,
	    .speed = NAN,
	    .other_speed = NAN,
	    .crosshair_mm = NAN,
	    .level = 50,
	    .charset = CHARSET_ASCII,
	    .words = CHART_ALL,
	    .fraction = {.partition = PARTITION_IDEAL},
	    .strip = PLOTS_STRIP};
}

/* Curves to be drawn on one axis.  psd is borrowed, of a prediction that is
 * kept for it, or its own (part); finer: the same curve at more sizes, or
 * NULL.  near: of what was measured nearest to the speed; moved: how far any of
 * that, see moved_largest. */
struct curves {
	size_t n, n_prediction;
	struct {
		const struct psd *psd, *finer;
		struct psd *part;
		char *name;
		bool near;
		struct chart_series look;
	} * item;
	double moved;
	struct prediction prediction[8];
};

static const struct chart_series OTHER = {
    .series = SERIES_OTHER, .line = CHART_DASHED, .ascii = '%'};
static const struct chart_series PART = {
    .series = SERIES_PREDICTED, .line = CHART_LONG, .ascii = '@'};

/* Takes the name. */
static void
plots_add_curve(struct curves *c, const struct psd *psd, char *name,
    struct chart_series look)
{
	c->item = xrealloc(c->item, c->n + 1, sizeof *c->item);
	c->item[c->n].psd = psd;
	c->item[c->n].finer = NULL;
	c->item[c->n].part = NULL;
	c->item[c->n].near = false;
	c->item[c->n].name = name;
	c->item[c->n++].look = look;
}

/* Its sizes are read where the prediction itself reads them. */
static void
add_product(struct curves *c, const struct prediction *p, char *name,
    struct chart_series look)
{
	plots_add_curve(c, &p->product, name, look);
	c->item[c->n - 1].finer = p->curve.n > 0 ? &p->curve : NULL;
}

/* One that is kept with the curves. */
static const struct prediction *
make_prediction(struct curves *c, const struct session *s,
    const struct plot_request *request, const struct entry *entry,
    const struct params *params, double speed, size_t feed)
{
	struct prediction *p = &c->prediction[c->n_prediction++];
	struct question q = question_of_whole_product(s, entry, feed);
	q.fraction = request->fraction;
	q.params = params;
	*p = forecast_product(s, &q, speed);
	return p;
}

/* The sieves of all curves as an axis. */
static struct axis
sieves_of(const struct curves *c)
{
	size_t n = 0;
	FREED double *size = NULL;
	for (size_t i = 0; i < c->n; i++) {
		const struct psd *psd = c->item[i].psd;
		size = xrealloc(size, n + psd->n + 1, sizeof *size);
		for (size_t j = 0; j < psd->n; j++)
			size[n++] = units_mm(psd->size[j]);
	}
	struct axis axis = axis_sieves(tr("size, mm"), size, n);
	return axis;
}

static void
put_points(struct chart_series *s, const struct psd *psd)
{
	for (size_t j = 0; j < psd->n; j++) {
		s->x[j] = units_mm(psd->size[j]);
		s->y[j] = units_pct(psd->passing[j]);
	}
}

static void
put_curves(struct chart *chart, const struct curves *c)
{
	for (size_t i = 0; i < c->n; i++) {
		const struct psd *psd = c->item[i].psd;
		const struct psd *finer = c->item[i].finer;
		struct chart_series *s = chart_add(
		    chart, c->item[i].look, psd->n, "%s", c->item[i].name);
		put_points(s, psd);
		if (finer != NULL)
			put_points(chart_add_finer(s, finer->n), finer);
	}
}

static void
free_curves(struct curves *c)
{
	for (size_t i = 0; i < c->n; i++) {
		free(c->item[i].name);
		if (c->item[i].part != NULL)
			psd_free(c->item[i].part);
		free(c->item[i].part);
	}
	for (size_t i = 0; i < c->n_prediction; i++)
		prediction_free(&c->prediction[i]);
	free(c->item);
}

/* What was measured, or the fraction of it that is drawn.  Nothing where
 * another feed or machine is asked about. */
static void
add_measured(struct curves *c, const struct session *s,
    const struct entry *entry, const struct fraction *fraction,
    const struct params *params, double speed, size_t feed)
{
	const struct site *site = entry->site;
	for (size_t i = 0; i < site->n_run && site->with[0] == '\0'; i++) {
		if (!site_run_is_near(site, i, speed, SITE_CHART_RUNS))
			continue;
		const struct psd *product =
		    moved_product(s, entry, params, i, feed);
		struct psd *part = NULL;
		if (fraction_screens(fraction)) {
			part = xcalloc(1, sizeof *part);
			*part = screened_measured(product, fraction);
		}
		plots_add_curve(c, part != NULL ? part : product,
		    xasprintf(tr("measured %g m/s%s"), site->run[i].speed,
			site->run[i].repeat),
		    site_chart_run(site, i, !entry->train[i]));
		c->item[c->n - 1].part = part;
		c->item[c->n - 1].near = site_run_is_near(site, i, speed, 1);
		c->moved =
		    fmax(c->moved, moved_largest(s, entry, params, i, feed));
	}
}

static void
note_measured(
    struct chart *chart, const struct curves *c, const struct site *site)
{
	bool hollow = false;
	for (size_t i = 0; i < c->n; i++)
		hollow = hollow || (c->item[i].look.fine &&
				       mark_of(c->item[i].look.mark)->hollow);
	if (hollow)
		chart_note(chart, "hollow marks: held out from the fit");
	if (site_chart_speeds_left_out(site) > 0)
		chart_note(chart, "%zu measured runs are not drawn",
		    site_chart_speeds_left_out(site));
}

/* Below curves whose last one is the prediction. */
static void
add_strip(struct chart *chart, const struct curves *c, int rows)
{
	FREED bool *near = xcalloc(chart->n, sizeof *near);
	for (size_t i = 0; i < c->n; i++)
		near[chart->n - c->n + i] = c->item[i].near;
	plots_difference(chart, rows, near);
}

/* What is read at a place: chart_y_at at a size, chart_x_at at a passing. */
typedef double reading(
    const struct chart *, const struct chart_series *, double);

/* Adds " feed 16.0 %" to a note, or " predicted 33.1 % (31.6 to 34.5)" of what
 * has a band there, or " feed -". */
static void
add_reading(char **note, const struct chart *chart,
    const struct chart_series *s, reading *read, double at,
    const struct figure *band)
{
	int digits = read == chart_y_at ? 1 : 2;
	double own = read(chart, s, at);
	if (isnan(own)) {
		xappend(note, " %s -", s->name);
		return;
	}
	xappend(note, " %s %.*f %s", s->name, digits, own,
	    read == chart_y_at ? "%" : "mm");
	if (s->low != NULL && isfinite(band->low) && isfinite(band->high))
		xappend(note, tr(" (%.*f to %.*f)"), digits, band->low, digits,
		    band->high);
}

/* What is pinned has bands at its sieves and of its sizes, and no others. */
static void
read_pinned(const struct plot_request *q, const struct prediction *p,
    struct figure band[static 2])
{
	for (size_t i = 0; i < p->product.n && p->low != NULL; i++)
		if (fabs(units_mm(p->product.size[i]) - q->crosshair_mm) < 1e-9)
			band[0] = (struct figure){
			    NAN, units_pct(p->low[i]), units_pct(p->high[i])};
	for (size_t k = 0; k < PSD_SIZES; k++)
		if (fabs(q->level - 100 * PSD_PASSING[k]) < 1e-9)
			band[1] = (struct figure){
			    NAN, 1000 * p->range[k][0], 1000 * p->range[k][1]};
}

/* The band of a passing, %, and of a size, mm. */
static void
read_crosshair_bands(const struct session *s, const struct plot_request *q,
    const struct params *params, const struct prediction *p,
    struct figure band[static 2])
{
	struct question question =
	    question_of_whole_product(s, q->entry, p->feed_run);
	question.params = params;
	const struct quantity asked[] = {{.kind = QUANTITY_PASSING,
					     .x = q->crosshair_mm / 1000,
					     .fraction = q->fraction},
	    {.kind = QUANTITY_SIZE,
		.x = q->level / 100,
		.fraction = q->fraction}};
	struct forecast *f = forecast_open(s, &question, asked, 2);
	forecast_at(f, p->speed);
	for (size_t i = 0; i < 2; i++)
		band[i] = forecast_shown(f, i);
	forecast_close(f);
}

/* A rule, and where there are notes "at 2 mm: feed 16.0 %, measured 69 m/s
 * 29.0 %", and of each curve the size that the level passes; p: the prediction
 * that has a band, of these parameters, or NULL. */
static void
note_crosshair(struct chart *chart, const struct session *s,
    const struct plot_request *q, const struct params *params,
    const struct prediction *p)
{
	double x = q->crosshair_mm, level = q->level;
	struct figure band[2] = {{NAN, NAN, NAN}, {NAN, NAN, NAN}};
	chart_add_rule(chart, SERIES_CROSSHAIR, x, "crosshair at %g mm", x);
	if (!(q->words & CHART_NOTES))
		return;
	if (p != NULL && p == q->made)
		read_pinned(q, p, band);
	else if (p != NULL)
		read_crosshair_bands(s, q, params, p, band);
	FREED char *at = xasprintf(tr("at %g mm:"), x);
	FREED char *sizes = xasprintf(tr("%g %% pass:"), level);
	for (size_t i = 0; i < chart->n; i++) {
		const struct chart_series *of = chart->series[i];
		const char *comma = i + 1 < chart->n ? "," : "";
		add_reading(&at, chart, of, chart_y_at, x, &band[0]);
		add_reading(&sizes, chart, of, chart_x_at, level, &band[1]);
		xappend(&at, "%s", comma);
		xappend(&sizes, "%s", comma);
	}
	chart_note(chart, "%s", at);
	chart_note(chart, "%s", sizes);
}

/* A rule at the break size and a note; whose: the site it is of, or NULL where
 * that is no longer loaded.  The name of a rule tells no numbers where there
 * are no notes. */
static void
note_prediction(struct chart *chart, const struct session *s,
    const struct plot_request *q, const struct entry *whose,
    const struct prediction *p, const char *name, enum series series)
{
	double mm = 1000 * p->break_size;
	if (!(q->words & CHART_NOTES))
		chart_add_rule(chart, series, mm, "%sbreak size",
		    series == SERIES_OTHER ? tr("pin ") : "");
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
		    isnan(p->size[i]) ? tr("outside") : "%.2f mm",
		    1000 * p->size[i]);
	FREED char *text =
	    xasprintf("%s: P20 %s, P50 %s, P80 %s", name, p20, p50, p80);
	if (whose != NULL && answers_extrapolates(whose, p->speed))
		xlist(&text, "; ", "%s", tr("extrapolated"));
	if (whose != NULL && p->low != NULL)
		xlist(&text, "; ", "%s", outlook_words(s, whose));
	chart_note(chart, "%s", text);
	if (whose == NULL || origin_key(whose) == whose->key)
		return;
	FREED char *from = origin_sentence(whose);
	chart_note(
	    chart, "%s%s", origin_is_other(whose) ? tr("warning: ") : "", from);
}

/* The shade of a prediction with the site's own parameters, whose series is the
 * chart's last. */
static void
shade_prediction(struct chart *chart, const struct session *s,
    const struct entry *entry, const struct prediction *p)
{
	if (p->low == NULL) {
		chart_note(chart, "%s", outlook_why_none(s, entry));
		return;
	}
	struct chart_series *series = chart->series[chart->n - 1];
	chart_add_band(series);
	for (size_t i = 0; i < series->n; i++) {
		series->low[i] = units_pct(p->low[i]);
		series->high[i] = units_pct(p->high[i]);
	}
	const double *range = p->range[1];
	if (isfinite(range[0]) && isfinite(range[1]))
		chart_note(chart,
		    "shaded: %.0f %% uncertainty band; P50 %.2f to %.2f mm",
		    100 * settings_level(&s->set), 1000 * range[0],
		    1000 * range[1]);
	else
		chart_note(chart, "shaded: %.0f %% uncertainty band",
		    100 * settings_level(&s->set));
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
	size_t i;
	struct error gone = {0};
	bool beside = q->beside != NULL, kept = q->kept != NULL;
	*second = (struct second){.p = q->kept};
	if (beside && session_find(s, q->beside, &i, kept ? &gone : error))
		second->whose = q->second != NULL ? q->second : &s->entry[i];
	else if (beside && !kept)
		return false;
	else if (!beside)
		second->whose = q->entry;
	bool other = second->whose != NULL &&
		     entry_loaded(second->whose) != entry_loaded(q->entry);
	if (!kept && other) {
		if (!answers_check_params(s, second->whose, error))
			return false;
		own = &second->whose->params;
	}
	if (!kept && (own == NULL || (!beside && isnan(q->other_speed))))
		return true;
	if (!kept) {
		const struct site *site = second->whose->site;
		double v = isnan(q->other_speed) ? speed : q->other_speed;
		if (other)
			feed = SITE_MEAN_FEED;
		if (q->other_feed != 0 &&
		    !feed_find_sampled(site, q->other_feed, &feed, error))
			return false;
		second->p =
		    make_prediction(c, s, q, second->whose, own, v, feed);
	}
	char *name = xasprintf("%s %s%s%g m/s",
	    s->pin != NULL && q->kept == &s->pin->p ? tr("pin")
						    : tr("predicted"),
	    beside ? q->beside : "", beside ? " " : "", second->p->speed);
	add_product(c, second->p, name, OTHER);
	return true;
}

/* What is to be said of the two, whose curves are the chart's last. */
static void
note_curves(struct chart *chart, struct session *s,
    const struct plot_request *q, const struct prediction *one,
    const struct second *two, bool shade)
{
	const struct entry *entry = q->entry;
	struct chart_series **last = &chart->series[chart->n - 1];
	if (one != NULL)
		note_prediction(
		    chart, s, q, entry, one, (*last)->name, SERIES_BREAK);
	if (one != NULL && shade)
		shade_prediction(chart, s, entry, one);
	if (two->p != NULL)
		note_prediction(chart, s, q, two->whose, two->p,
		    last[one != NULL ? -1 : 0]->name, SERIES_OTHER);
}

/* Named by its run where it is that of one of several. */
static void
add_feed(struct curves *c, const struct site *site, size_t run)
{
	bool one = run < site->n_run && site->individual_feeds;
	plots_add_curve(c, site_feed(site, run),
	    one ? xasprintf(tr("feed %g m/s%s"), site->run[run].speed,
		      site->run[run].repeat)
		: xstrdup(tr("feed")),
	    FEED);
}

/* The fraction that an envelope in use is for, with its limits. */
static void
add_part(struct curves *c, const struct session *s, const struct entry *entry,
    const struct prediction *whole)
{
	struct prediction *part = &c->prediction[c->n_prediction];
	if (!plots_limits_fraction(s, entry, whole, part))
		return;
	c->n_prediction++;
	FREED char *words = plots_limits_words(s);
	add_product(c, part, xasprintf(tr("fraction %s"), words), PART);
}

/* Dashed where it is extrapolated. */
static void
plots_add_predicted(struct curves *c, const struct session *s,
    const struct plot_request *q, const struct prediction *p)
{
	struct chart_series look = PREDICTED;
	if (answers_extrapolates(q->entry, p->speed))
		look.line = CHART_LONG;
	add_product(c, p,
	    q->words & CHART_NOTES ? xasprintf(tr("predicted %g m/s"), p->speed)
				   : xasprintf(tr("predicted%s"),
					 outlook_short_words(s, q->entry, p)),
	    look);
}

/* The first prediction, and of it the fraction that is looked at. */
static const struct prediction *
make_first_prediction(struct curves *c, struct session *s,
    const struct plot_request *q, const struct params *params, double speed,
    size_t feed)
{
	const struct entry *entry = q->entry;
	const struct prediction *one =
	    q->made != NULL
		? q->made
		: make_prediction(c, s, q, entry, params, speed, feed);
	if (!fraction_screens(&q->fraction))
		add_part(c, s, entry, one);
	return one;
}

static struct chart *
psd_chart(struct session *s, const struct plot_request *q, struct error *error)
{
	const struct entry *entry = q->entry;
	const struct site *site = entry->site;
	double speed = isnan(q->speed) ? site_middle(site) : q->speed;
	size_t feed = feed_sampled_at(site, q->feed_speed);
	struct curves c = {0};
	struct params params = {0};
	struct error unknown = {0};
	struct second two;
	/* What was measured is worth a look before there are parameters. */
	bool known = plots_past_params(s, q, &params, &unknown);
	if (!known && q->generation > 0) {
		*error = unknown;
		return NULL;
	}
	add_feed(&c, site, feed);
	add_measured(
	    &c, s, entry, &q->fraction, known ? &params : NULL, speed, feed);
	const struct prediction *one =
	    known ? make_first_prediction(&c, s, q, &params, speed, feed)
		  : NULL;
	if (!add_second(
		&c, s, q, known ? &params : NULL, speed, feed, &two, error)) {
		free_curves(&c);
		return NULL;
	}
	if (known)
		plots_add_predicted(&c, s, q, one);
	FREED char *fraction = screened_title(&q->fraction);
	struct chart *chart =
	    site_chart(site, sieves_of(&c), axis_percent(tr("passing, %")),
		known                     ? N_("product at %.*f m/s%s")
		: site_products(site) > 0 ? N_("feed and products")
					  : N_("feed"),
		units_speed_digits(speed), speed, fraction);
	plots_limits_add(chart, s, (q->words & CHART_NOTES) != 0);
	put_curves(chart, &c);
	bool own = memcmp(&entry->params, &params, sizeof params) == 0;
	note_curves(chart, s, q, one, &two, q->band && own);
	if (!known)
		chart_note(chart, "no prediction: %s", unknown.text);
	else if (q->strip > 0)
		add_strip(chart, &c, q->strip);
	note_measured(chart, &c, site);
	site_chart_moved(chart, c.moved);
	if (!isnan(q->crosshair_mm))
		note_crosshair(chart, s, q, &params, one);
	free_curves(&c);
	return chart;
}

static struct chart *
sweep_chart(
    struct session *s, const struct plot_request *q, struct error *error)
{
	const struct entry *entry = q->entry;
	const struct site *site = entry->site;
	size_t n = q->n_speed;
	struct curves c = {0};
	struct params params;
	if (!plots_past_params(s, q, &params, error))
		return NULL;
	if (n > ARRAY_LEN(c.prediction)) {
		error_set(error, ERROR_USAGE,
		    "%zu speeds are too many to draw\n"
		    "use at most %zu, so that the curves can be distinguished",
		    n, ARRAY_LEN(c.prediction));
		return NULL;
	}
	size_t feed = feed_sampled_at(site, q->feed_speed);
	plots_add_curve(&c, site_feed(site, feed), xstrdup(tr("feed")), FEED);
	FREED double *usual = n == 0 ? answers_speeds(s, site, &n) : NULL;
	const double *speed = usual != NULL ? usual : q->speeds;
	for (size_t i = 0; i < n; i++)
		add_product(&c,
		    make_prediction(&c, s, q, entry, &params, speed[i], feed),
		    xasprintf(tr("predicted %g m/s"), speed[i]),
		    site_chart_style(i));
	FREED char *fraction = screened_title(&q->fraction);
	struct chart *chart =
	    site_chart(site, sieves_of(&c), axis_percent(tr("passing, %")),
		"products at %zu speeds%s", n, fraction);
	put_curves(chart, &c);
	free_curves(&c);
	return chart;
}

/* The product of a run and the prediction for it at the sieves that its feed
 * covers: differences in points. */
static void
add_residuals(struct chart *chart, const struct session *s,
    const struct entry *entry, size_t run, const struct params *params,
    struct chart_series look)
{
	const struct run *r = &entry->site->run[run];
	size_t n = misfit_covered(r);
	struct prediction p =
	    predict(entry->site, params, s->set.model, r->speed, run);
	struct chart_series *series = chart_add(chart, look, n, "%g m/s%s%s",
	    r->speed, r->repeat, entry->train[run] ? "" : tr(" (held out)"));
	for (size_t i = 0; i < n; i++) {
		double predicted = psd_passing(&p.product, r->product.size[i]);
		series->x[i] = units_mm(r->product.size[i]);
		series->y[i] = 100 * (predicted - r->product.passing[i]);
	}
	prediction_free(&p);
}

/* A round axis that holds all y of the chart and 0, with a guide at 0. */
static struct axis
axis_with_zero(const struct chart *chart, const char *title)
{
	double low = 0, high = 0;
	for (size_t i = 0; i < chart->n; i++)
		for (size_t j = 0; j < chart->series[i]->n; j++) {
			low = fmin(low, chart->series[i]->y[j]);
			high = fmax(high, chart->series[i]->y[j]);
		}
	struct axis axis = axis_linear(title, low, high);
	for (size_t i = 0; i < axis.n; i++)
		axis.tick[i].guide = axis.tick[i].at == 0;
	return axis;
}

static struct chart *
residuals_chart(
    struct session *s, const struct plot_request *q, struct error *error)
{
	const struct site *site = q->entry->site;
	struct params params;
	struct curves c = {0};
	if (!plots_past_params(s, q, &params, error))
		return NULL;
	size_t compared = 0;
	for (size_t i = 0; i < site->n_run; i++)
		compared += misfit_covered(&site->run[i]) > 0;
	if (compared == 0) {
		error_set(error, ERROR_USAGE,
		    site_products(site) == 0
			? N_("%s has no measured product")
			: N_("%s: no product sieve is in the "
			     "range of the feed's sieves"),
		    site->name);
		return NULL;
	}
	double middle = site_middle(site);
	const struct fraction whole = {0};
	add_measured(&c, s, q->entry, &whole, NULL, middle, SITE_MEAN_FEED);
	struct chart *chart = site_chart(site, sieves_of(&c), (struct axis){0},
	    "predicted minus measured, sieve by sieve");
	for (size_t i = 0; i < site->n_run; i++) {
		if (!site_run_is_near(site, i, middle, SITE_CHART_RUNS) ||
		    misfit_covered(&site->run[i]) == 0)
			continue;
		struct chart_series look =
		    site_chart_run(site, i, !q->entry->train[i]);
		look.line = CHART_SOLID;
		look.ascii = look.mark;
		add_residuals(chart, s, q->entry, i, &params, look);
	}
	chart->y = axis_with_zero(chart, "difference, points");
	free_curves(&c);
	return chart;
}

static void
put_pairs(struct chart *chart, const struct session *s,
    const struct trials *pairs, double low, double high)
{
	struct chart_series *equal = chart_add(chart,
	    (struct chart_series){
		.series = SERIES_TEXT, .line = CHART_DOTTED, .ascii = '.'},
	    2, N_("as measured (1:1)"));
	equal->x[0] = equal->y[0] = low;
	equal->x[1] = equal->y[1] = high;
	for (size_t i = 0; i < PSD_SIZES; i++) {
		struct chart_series look = site_chart_style(i);
		look.line = CHART_MARKS;
		struct chart_series *p =
		    chart_add(chart, look, pairs->n, "%s", PSD_NAME[i]);
		chart_add_point_sites(p);
		for (size_t j = 0; j < pairs->n; j++) {
			const struct trial *of = &pairs->item[j];
			const struct site *site = s->entry[of->entry].site;
			p->whose[j] = (struct chart_whose){
			    xstrdup(of->key), site_source(site, ""), NULL};
			p->x[j] = 1000 * of->v.measured[i];
			p->y[j] = isnan(p->x[j])
				      ? NAN
				      : 1000 * of->v.size[VALIDATE_MODEL][i];
		}
	}
}

/* "P50: bias -0.3 %, RMS 1.2 %, R2 0.9987; 19 runs", as validate all has it. */
static void
note_scores(struct chart *chart, const struct trials *pairs)
{
	for (size_t i = 0; i < PSD_SIZES; i++) {
		char r2[16] = "-";
		struct validate_score score =
		    trials_score(pairs, VALIDATE_MODEL, i);
		if (score.n == 0)
			continue;
		if (!isnan(score.r2))
			snprintf(r2, sizeof r2, "%.4f", score.r2);
		chart_note(chart,
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
			trials_add_entry(&pairs, s, i, NULL);
	for (size_t j = 0; j < PSD_SIZES * pairs.n; j++) {
		const struct validation *v = &pairs.item[j / PSD_SIZES].v;
		double measured = 1000 * v->measured[j % PSD_SIZES];
		double predicted =
		    1000 * v->size[VALIDATE_MODEL][j % PSD_SIZES];
		low = fmin(low, fmin(measured, predicted));
		high = fmax(high, fmax(measured, predicted));
	}
	if (high > 0) {
		struct axis x = axis_log(tr("measured, mm"), low, high);
		struct axis y = axis_log(tr("predicted, mm"), low, high);
		size_t sites;
		FREED char *about = trials_sources(&pairs, &sites);
		FREED char *title =
		    xasprintf(tr_n("sizes at held-out speeds, %zu site",
				  "sizes at held-out speeds, %zu sites", sites),
			sites);
		chart = chart_new(title, about, x, y);
		put_pairs(chart, s, &pairs, x.low, x.high);
		note_scores(chart, &pairs);
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

/* Value i of SAMPLES between low and high, evenly on the log. */
static double
log_sample(double low, double high, size_t i)
{
	return low * pow(high / low, (double)i / (SAMPLES - 1));
}

static void
add_selection(struct chart *chart, const struct session *s,
    const struct entry *entry, const struct params *params, double speed,
    struct chart_series look)
{
	struct model_settings settings = outlook_settings(s, entry);
	struct chart_series *series =
	    chart_add(chart, look, SAMPLES, "%g m/s", speed);
	struct breaker b;
	breaker_set_params(&b, params, &settings);
	breaker_set_speed(&b, speed);
	for (size_t i = 0; i < SAMPLES; i++) {
		series->x[i] = log_sample(chart->x.low, chart->x.high, i);
		series->y[i] = 100 * b.model->selection(
					 &b, el_log(series->x[i] / 1000), NULL);
	}
	double mm = 1000 * params_break_size_by(params, &settings, speed);
	chart_add_rule(chart,
	    look.series == SERIES_OTHER ? SERIES_OTHER : SERIES_BREAK, mm,
	    "break size %.2f mm at %g m/s", mm, speed);
}

static struct chart *
selection_chart(
    struct session *s, const struct plot_request *q, struct error *error)
{
	const struct site *site = q->entry->site;
	double speed = isnan(q->speed) ? site_middle(site) : q->speed;
	struct params params;
	if (!plots_past_params(s, q, &params, error))
		return NULL;
	const struct psd *feed =
	    site_feed(site, feed_sampled_at(site, q->feed_speed));
	struct curves c = {0};
	plots_add_curve(&c, feed, xstrdup(""), FEED);
	struct chart *chart = site_chart(site, sieves_of(&c),
	    axis_percent(tr("share that breaks S(x), %")),
	    "selection function (Eq 3)");
	free_curves(&c);
	if (!isnan(q->other_speed))
		add_selection(chart, s, q->entry, &params, q->other_speed,
		    (struct chart_series){.series = SERIES_OTHER,
			.line = CHART_LONG,
			.ascii = '%'});
	add_selection(chart, s, q->entry, &params, speed, PREDICTED);
	return chart;
}

static struct chart *
appearance_chart(
    struct session *s, const struct plot_request *q, struct error *error)
{
	struct params params;
	if (!plots_past_params(s, q, &params, error))
		return NULL;
	if (s->set.model.appearance != APPEARANCE_RATIO) {
		error_set(error, ERROR_USAGE,
		    "only the appearance function of the form ratio can be "
		    "drawn\n"
		    "run 'show appearance' for the matrix of any form");
		return NULL;
	}
	const struct site *site = q->entry->site;
	double speed = isnan(q->speed) ? site_middle(site) : q->speed;
	struct breaker b;
	breaker_set_params(&b, &params, &s->set.model);
	breaker_set_speed(&b, speed);
	struct chart *chart =
	    site_chart(site, axis_log(tr("progeny / parent u, -"), 0.001, 1),
		axis_percent(tr("finer than u B(u), %")),
		"appearance function (Eq 1)");
	struct chart_series *curve =
	    chart_add(chart, PREDICTED, SAMPLES, "B(u)");
	for (size_t i = 0; i < SAMPLES; i++) {
		curve->x[i] = log_sample(chart->x.low, chart->x.high, i);
		curve->y[i] = 100 * answers_share_finer(&b, curve->x[i], site);
	}
	return chart;
}

/* In the session's colours; *chart stays NULL where there is none. */
static void
make_chart(struct session *s, const struct plot_request *request,
    plot_make *make, struct chart **chart, struct error *error)
{
	*chart = make(s, request, error);
	if (*chart != NULL)
		(*chart)->theme = (enum theme)s->set.theme;
}

struct chart *
plots_chart(
    struct session *s, const struct plot_request *request, struct error *error)
{
	static const struct {
		plot_make *make;
		bool any_site;
	} KINDS[] = {[PLOT_PSD] = {psd_chart, false},
	    [PLOT_RUNS] = {plots_runs, false},
	    [PLOT_PARITY] = {parity_chart, false},
	    [PLOT_CONVERGENCE] = {plots_search_convergence, false},
	    [PLOT_SPREAD] = {plots_search_spread, false},
	    [PLOT_RESIDUALS] = {residuals_chart, false},
	    [PLOT_SELECTION] = {selection_chart, false},
	    [PLOT_APPEARANCE] = {appearance_chart, false},
	    [PLOT_MAP] = {plots_map, true},
	    [PLOT_SWEEP] = {sweep_chart, false},
	    [PLOT_RESPONSE] = {plots_response, false},
	    [PLOT_PROFILE] = {plots_draws_profile, false},
	    [PLOT_CORRELATION] = {plots_draws_correlation, false},
	    [PLOT_DRIFT] = {plots_drift, false},
	    [PLOT_SEARCH] = {plots_search, false},
	    [PLOT_ENERGY] = {plots_energy, true}};
	if (!KINDS[request->kind].any_site &&
	    !session_need_site(s, "this plot", error))
		return NULL;
	size_t at = s->current;
	if (request->site != NULL &&
	    !session_find(s, request->site, &at, error))
		return NULL;
	struct plot_request as = *request;
	if (as.entry == NULL && s->n_entry > 0)
		as.entry = &s->entry[at];
	struct chart *chart = NULL;
	make_chart(s, &as, KINDS[as.kind].make, &chart, error);
	return chart;
}

/* "82.1 %". */
static char *
value_with_unit(const struct axis *axis, double value)
{
	const char *unit = axis_unit_suffix(axis);
	return xasprintf(
	    strcmp(unit, " %") == 0 ? "%.1f%s" : "%.4g%s", value, unit);
}

static char *
words_of_found(const struct chart_found *f)
{
	const struct chart_series *of = f->series;
	if (of == NULL)
		return NULL;
	FREED char *x = value_with_unit(&f->chart->x, of->x[f->point]),
		   *y = value_with_unit(&f->chart->y, of->y[f->point]);
	bool whose = of->whose != NULL && of->whose[f->point].site != NULL;
	return xasprintf("%s%s%s: %s, %s",
	    whose ? of->whose[f->point].site : "", whose ? ", " : "", of->name,
	    x, y);
}

bool
plots_find_at(struct session *s, const struct plot_request *request,
    int columns, int rows, int column, int row, struct plots_found *found)
{
	struct error error = {0};
	struct chart_found f;
	struct chart *chart = plots_chart(s, request, &error);
	if (chart == NULL)
		return false;
	struct canvas *canvas = canvas_new(columns, rows);
	bool in = chart_find(
	    chart, canvas, request->charset, request->words, column, row, &f);
	if (in)
		*found = (struct plots_found){f.x, f.y, words_of_found(&f)};
	canvas_free(canvas);
	chart_free(chart);
	return in;
}

struct canvas *
plots_draw(struct session *s, const struct plot_request *request, int columns,
    int rows, struct error *error)
{
	struct chart *chart = plots_chart(s, request, error);
	if (chart == NULL)
		return NULL;
	struct canvas *canvas =
	    chart_draw(chart, columns, rows, request->charset, request->words);
	chart_free(chart);
	return canvas;
}

/* predict: what comes out at a speed, and how far to trust it.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/answers.h"

#include <math.h>
#include <stdlib.h>

#include "base/xalloc.h"
#include "cmd/fit.h"
#include "core/predict.h"
#include "io/units.h"
#include "plot/curve.h"

static const struct value *
option(const char *command, const struct args *args, const char *name)
{
	return args_value(command_find(command), args, name);
}

bool
answers_ready(struct session *s, struct error *error)
{
	const struct entry *entry = session_entry(s);
	if (entry->has_params)
		return fit_settings_agree(&s->settings, error);
	error_set(
	    error, ERROR_USAGE, "%s has no parameters yet", entry->site->name);
	return error_hint(
	    error, "'calibrate' finds them, or 'params set' takes known ones");
}

static json_t *
psd_as_json(const struct psd *psd, bool sizes)
{
	json_t *list = json_array();
	for (size_t i = 0; i < psd->n; i++)
		json_array_append_new(list,
		    report_json_number(sizes ? units_mm(psd->size[i])
					     : units_pct(psd->passing[i])));
	return list;
}

static const char *
method_name(enum method method)
{
	return method == METHOD_CLASSES ? "classes" : "continuous";
}

json_t *
answers_prediction_json(struct session *s, const struct prediction *p)
{
	const struct entry *entry = session_entry(s);
	json_t *o = json_object();
	json_object_set_new(o, "command", json_string("predict"));
	json_object_set_new(o, "site", json_string(entry->site->name));
	json_object_set_new(o, "speed", json_real(p->speed));
	json_object_set_new(o, "extrapolated",
	    json_boolean(
		predict_extrapolates(entry->site, entry->train, p->speed)));
	json_object_set_new(
	    o, "method", json_string(method_name(s->settings.method)));
	json_object_set_new(o, "sieve_mm", psd_as_json(&p->product, true));
	json_object_set_new(o, "passing_pct", psd_as_json(&p->product, false));
	json_object_set_new(o, "p20_mm", report_json_number(1000 * p->p20));
	json_object_set_new(o, "p50_mm", report_json_number(1000 * p->p50));
	json_object_set_new(o, "p80_mm", report_json_number(1000 * p->p80));
	json_object_set_new(
	    o, "break_mm", report_json_number(1000 * p->break_size));
	json_object_set_new(o, "params", fit_params_json(&entry->params));
	if (entry->has_fit)
		json_object_set_new(
		    o, "verdict", json_string(fit_verdict(&entry->fit)));
	if (entry->recalled[0] != '\0')
		json_object_set_new(
		    o, "recalled", json_string(entry->recalled));
	return o;
}

/* Which sizes break at this speed, in a sentence. */
static void
note_breakage(struct report *r, const struct prediction *p)
{
	double top = p->feed.size[0];
	if (p->no_daughters)
		report_note(r,
		    "the appearance gives no fragment any daughter: the "
		    "product is the feed");
	else if (p->break_size >= top)
		report_note(r,
		    "nothing breaks at %.1f m/s: only fragments of %.3g mm or "
		    "more would, and the feed has none above %g mm: product = "
		    "feed",
		    p->speed, 1000 * p->break_size, units_mm(top));
	else
		report_note(r,
		    "breaks from %.2f mm up; %.1f %% of the feed is broken",
		    1000 * p->break_size, 100 * p->selected);
}

void
answers_note_recalled(struct report *r, const struct entry *entry)
{
	if (entry->recalled[0] != '\0')
		report_note(r,
		    "parameters from store: %s; they are no fit of this site",
		    entry->recalled);
}

static void
note_doubt(struct session *s, struct report *r, const struct prediction *p)
{
	const struct entry *entry = session_entry(s);
	const struct site *site = entry->site;
	answers_note_recalled(r, entry);
	if (predict_extrapolates(site, entry->train, p->speed) &&
	    site_products(site) > 0)
		report_note(r,
		    "extrapolated: %.1f m/s lies outside the speeds trained "
		    "on",
		    p->speed);
	if (site->individual_feeds &&
	    fabs(site->run[p->feed_run].speed - p->speed) > 1e-3)
		report_note(r, "feed: the sample taken at %g m/s",
		    site->run[p->feed_run].speed);
	if (entry->has_fit && entry->fit.rmse > FIT_POOR)
		report_note(r,
		    "the calibration is poor (%.1f points RMS): do not rely "
		    "on this",
		    100 * entry->fit.rmse);
}

/* Measured passing at a sieve of a run at this very speed, else NAN. */
static double
measured_at(const struct site *site, double speed, double x)
{
	size_t r = site_run_at(site, speed);
	if (r == site->n_run)
		return NAN;
	const struct psd *product = &site->run[r].product;
	for (size_t i = 0; i < product->n; i++)
		if (product->size[i] == x)
			return product->passing[i];
	return NAN;
}

static struct report *
prediction_report(struct session *s, const struct prediction *p)
{
	const struct site *site = session_entry(s)->site;
	size_t run = site_run_at(site, p->speed);
	bool measured = run < site->n_run && site->run[run].product.n > 0;
	struct report *r = report_new("predict");
	char *label = session_label(site);
	report_title(r, "%s: product at %.1f m/s (%.0f J/kg)", label, p->speed,
	    p->energy);
	free(label);
	report_site(r, site->name, site->provenance);
	report_column(r, "sieve_mm", "sieve mm");
	report_column(r, "feed_pct", "feed %");
	report_column(r, "passing_pct", "product %");
	if (measured)
		report_column(r, "measured_pct", "measured %");
	for (size_t i = 0; i < p->product.n; i++) {
		double x = p->product.size[i];
		report_number(r, units_mm(x), -1);
		report_number(r, units_pct(p->feed.passing[i]), 1);
		report_number(r, units_pct(p->product.passing[i]), 1);
		if (measured)
			report_number(
			    r, units_pct(measured_at(site, p->speed, x)), 1);
	}
	return r;
}

/* "P50 2.81 mm", or "P20 below 0.063 mm". */
static char *
size_words(const struct psd *psd, double passing, double x)
{
	if (isfinite(x))
		return xasprintf("P%.0f %.2f mm", 100 * passing, 1000 * x);
	bool fine = psd->passing[psd->n - 1] >= passing;
	return xasprintf("P%.0f %s %g mm", 100 * passing,
	    fine ? "below" : "above",
	    units_mm(psd->size[fine ? psd->n - 1 : 0]));
}

static void
note_sizes(struct report *r, const struct prediction *p)
{
	char *p20 = size_words(&p->product, 0.2, p->p20);
	char *p50 = size_words(&p->product, 0.5, p->p50);
	char *p80 = size_words(&p->product, 0.8, p->p80);
	report_note(r, "%s, %s, %s", p20, p50, p80);
	free(p20);
	free(p50);
	free(p80);
}

bool
answers_feed(const struct site *site, const struct value *feed, double speed,
    size_t *run, struct error *error)
{
	*run = site_run_nearest(site, speed);
	if (!feed->given)
		return true;
	*run = site_run_at(site, feed->number);
	if (*run < site->n_run)
		return true;
	error_set(error, ERROR_USAGE, "%s has no feed sampled at %g m/s",
	    site->name, feed->number);
	return error_hint(error, "'show feed' lists the feeds");
}

/* What a curve is drawn from: sizes in mm and passings in per cent. */
static struct curve
curve_of(const struct psd *psd, const char *name, char mark)
{
	double *size = xdoubles(psd->n), *passing = xdoubles(psd->n);
	for (size_t i = 0; i < psd->n; i++) {
		size[i] = 1000 * psd->size[i];
		passing[i] = 100 * psd->passing[i];
	}
	return (struct curve){name, mark, false, psd->n, size, passing};
}

/* The feed, the measured product where there is one, and the prediction. */
static void
print_curves(struct session *s, const struct prediction *p)
{
	enum { WIDTH = 78, HEIGHT = 24 };
	const struct site *site = session_entry(s)->site;
	size_t run = site_run_at(site, p->speed), n = 0;
	struct curve curve[3];
	curve[n++] = curve_of(&p->feed, "feed", '.');
	curve[n++] = curve_of(&p->product, "predicted", '#');
	if (run < site->n_run && site->run[run].product.n > 0) {
		curve[n] = curve_of(&site->run[run].product, "measured", 'o');
		curve[n++].points = true;
	}
	fputc('\n', s->out);
	curve_print(curve, n, 1000 * p->break_size, WIDTH, HEIGHT, s->out);
	for (size_t i = 0; i < n; i++) {
		free(curve[i].size);
		free(curve[i].passing);
	}
}

bool
cmd_predict(struct session *s, const struct args *args, struct error *error)
{
	if (!answers_ready(s, error))
		return false;
	struct entry *entry = session_entry(s);
	double speed = option("predict", args, "speed")->number;
	size_t feed;
	if (!answers_feed(entry->site, option("predict", args, "feed"), speed,
		&feed, error))
		return false;
	struct prediction p =
	    predict(entry->site, &entry->params, s->settings, speed, feed);
	s->answer[ANSWER_SPEED] = speed;
	s->answer[ANSWER_EXTRAPOLATED] =
	    predict_extrapolates(entry->site, entry->train, speed);
	s->answer[ANSWER_P20] = 1000 * p.p20;
	s->answer[ANSWER_P50] = 1000 * p.p50;
	s->answer[ANSWER_P80] = 1000 * p.p80;
	s->answer[ANSWER_BREAK] = 1000 * p.break_size;
	struct report *r = prediction_report(s, &p);
	note_sizes(r, &p);
	note_breakage(r, &p);
	note_doubt(s, r, &p);
	report_json(r, answers_prediction_json(s, &p));
	session_report(s, r);
	bool curve = option("predict", args, "curve")->choice == 1;
	if (curve && s->format == REPORT_TABLE)
		print_curves(s, &p);
	prediction_free(&p);
	return true;
}

/* advise: the next sample that would most narrow the band of an answer.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/answers/advise.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/tr.h"
#include "base/xalloc.h"
#include "cmd/answers/predict.h"
#include "cmd/ask/answers.h"
#include "cmd/ask/question.h"
#include "cmd/ask/forecast.h"
#include "cmd/ask/outlook.h"
#include "cmd/ask/quantity_words.h"
#include "cmd/lang/parse.h"
#include "cmd/session/settings.h"
#include "cmd/lang/table.h"
#include "core/answer/advise.h"
#include "core/psd/rotor_speed.h"
#include "core/search/misfit.h"

/* What is asked: the question, the quantity, its name, and the unit of widths.
 * What is computed: the draws of the quantity, in the unit shown, the ends and
 * the width of their band, and its width if the stated speeds were exact. */
struct advice_request {
	const struct question *question;
	struct quantity q;
	char *name;
	const char *unit;
	double draw[POSTERIOR_DRAWS], ends[2], width, exact_width;
};

/* Subtracts from a row of draws the part that is proportional to the errors of
 * the stated speeds.  Another sample says nothing about these errors, because
 * its own speed has a different one. */
static void
remove_speed_errors_of_draws(double *row)
{
	double along = 0, squares = 0;
	for (size_t d = 0; d < POSTERIOR_DRAWS; d++) {
		double error = ensemble_speed_error_of_draw(d);
		along += error * row[d];
		squares += error * error;
	}
	for (size_t d = 0; d < POSTERIOR_DRAWS; d++)
		row[d] -= along / squares * ensemble_speed_error_of_draw(d);
}

static double
band_width_of_draws(const double *draw, double level, double ends[static 2])
{
	ensemble_interval_around_answer(draw, level, NAN, ends);
	return ends[1] - ends[0];
}

/* Finds the draws of the answer and their band.  Returns false if a draw lies
 * outside the sieves. */
static bool
compute_draws_and_bands_of_quantity(
    const struct session *s, struct advice_request *w)
{
	struct forecast *f = forecast_open(s, w->question, &w->q, 1);
	bool known = true;
	forecast_set_speed(f, w->question->speed);
	for (size_t d = 0; d < POSTERIOR_DRAWS; d++) {
		w->draw[d] = quantities_value_in_shown_unit(
		    &w->q, forecast_draws_of_quantity(f, 0)[d]);
		known = known && isfinite(w->draw[d]);
	}
	forecast_close(f);
	if (!known)
		return false;
	double level = w->question->level, ends[2], exact[POSTERIOR_DRAWS];
	w->width = band_width_of_draws(w->draw, level, w->ends);
	memcpy(exact, w->draw, sizeof exact);
	if (s->set.speed_sd > 0)
		remove_speed_errors_of_draws(exact);
	w->exact_width = band_width_of_draws(exact, level, ends);
	return true;
}

static size_t
add_candidate_sample_speed(
    const struct site *site, struct sample_advice *c, size_t n, double v)
{
	for (size_t i = 0; i < n; i++)
		if (fabs(c[i].speed - v) < 0.5)
			return n;
	size_t r = site_run_at_speed(site, v);
	c[n] = (struct sample_advice){.speed = v,
	    .repeat = r < site->n_run && site->run[r].product.n > 0};
	return n + 1;
}

/* Returns the speeds to consider: a repeat at each measured speed, the speed
 * asked about, and round speeds.  Sets *n to their number.  The caller frees
 * them. */
static struct sample_advice *
list_candidate_sample_speeds(
    const struct session *s, const struct site *site, double asked, size_t *n)
{
	size_t more, k = 0;
	FREED double *round = answers_list_few_round_speeds(s, site, &more);
	struct sample_advice *c = xcalloc(site->n_run + more + 1, sizeof *c);
	for (size_t r = 0; r < site->n_run; r++)
		if (misfit_count_covered_sieves(&site->run[r]) > 0)
			k = add_candidate_sample_speed(
			    site, c, k, site->run[r].speed);
	k = add_candidate_sample_speed(site, c, k, asked);
	for (size_t i = 0; i < more; i++)
		k = add_candidate_sample_speed(site, c, k, round[i]);
	*n = k;
	return c;
}

static int
compare_band_widths(const void *a, const void *b)
{
	double x = ((const struct sample_advice *)a)->width;
	double y = ((const struct sample_advice *)b)->width;
	return (x > y) - (x < y);
}

/* Returns a forecast of the passings at those sieves of the site that the feed
 * covers.  Sets *n to the number of sieves. */
static struct forecast *
open_forecast_of_all_sieves(
    const struct session *s, const struct question *q, size_t *n)
{
	FREED double *sieve = site_all_sieves(q->entry->site, n);
	while (*n > 0 && !psd_covers_size(question_feed(q), sieve[*n - 1]))
		(*n)--;
	FREED struct quantity *asked = xcalloc(*n, sizeof *asked);
	for (size_t i = 0; i < *n; i++)
		asked[i] =
		    (struct quantity){.kind = QUANTITY_PASSING, .x = sieve[i]};
	return forecast_open(s, q, asked, *n);
}

/* Sorts the candidates by the width of the band that each is expected to
 * leave. */
static void
sort_sample_speeds_by_band_width(const struct session *s,
    const struct advice_request *w, struct sample_advice *c, size_t n)
{
	enum { N = POSTERIOR_DRAWS };
	size_t sieves;
	struct forecast *f =
	    open_forecast_of_all_sieves(s, w->question, &sieves);
	FREED double *sample = xcalloc_doubles(sieves * N);
	for (size_t i = 0; i < n; i++) {
		forecast_set_speed_and_ensemble(f, c[i].speed, ENSEMBLE_SAMPLE);
		for (size_t k = 0; k < sieves; k++) {
			memcpy(sample + k * N, forecast_draws_of_quantity(f, k),
			    N * sizeof *sample);
			if (s->set.speed_sd > 0)
				remove_speed_errors_of_draws(sample + k * N);
		}
		double share =
		    advise_variance_share_removed(w->draw, sample, sieves);
		c[i].width = w->width * sqrt(1 - share);
	}
	forecast_close(f);
	qsort(c, n, sizeof *c, compare_band_widths);
}

/* Says how far the quantity varies with the feeds of the runs, if they differ:
 * the product is then as uncertain as the feed. */
static void
warn_of_spread_over_feeds(
    struct answer *r, const struct session *s, const struct advice_request *w)
{
	double range[2];
	if (!predict_value_range_over_feeds(
		s, w->question, &w->q, NAN, w->question->speed, range))
		return;
	double low = quantities_value_in_shown_unit(&w->q, range[0]),
	       high = quantities_value_in_shown_unit(&w->q, range[1]);
	if (!(high > low))
		return;
	answer_add_sentence(r, ANSWER_REMARK,
	    "with the feeds that were sampled %s ranges from %.3g to %.3g%s: "
	    "sample the feed together with the product",
	    w->name, low, high, quantities_unit_suffix(&w->q));
	fields_put_values(
	    answer_json_fields(r), "feeds_low %g feeds_high %g", low, high);
}

static void
note_best_sample_speed(struct answer *r, const struct advice_request *w,
    const struct sample_advice *best)
{
	double width = w->width;
	double level = 100 * w->question->level;
	double less = 100 * (1 - best->width / width);
	FREED char *rpm = rotor_speed_rpm_text(
	    w->question->entry->site->rotor, best->speed, NAN);
	if (less < 100 * ADVISE_WORTH)
		answer_note(r,
		    "no single sample narrows the %.0f %% band of %s at %g "
		    "m/s (%.2g%s wide) by more than %.0f %%: take several",
		    level, w->name, w->question->speed, width, w->unit,
		    fmax(less, 0));
	else
		answer_note(r,
		    best->repeat
			? N_("a sample at %g m/s%s (a repeat) is expected to "
			     "narrow the %.0f %% band of %s at %g m/s most: "
			     "from %.2g to %.2g%s, by %.0f %%")
			: N_("a sample at %g m/s%s is expected to narrow the "
			     "%.0f %% band of %s at %g m/s most: from %.2g to "
			     "%.2g%s, by %.0f %%"),
		    best->speed, rpm, level, w->name, w->question->speed, width,
		    best->width, w->unit, less);
}

/* Says how far exact tip speeds would narrow the band, if further than the best
 * sample does. */
static void
note_gain_of_exact_speeds(struct answer *r, const struct session *s,
    const struct advice_request *w, const struct sample_advice *best)
{
	if (w->exact_width < best->width)
		answer_note(r,
		    "tip speeds known better than to %g %% would narrow it "
		    "more: exact ones to %.2g%s, by %.0f %%; 'set speed_sd' "
		    "states how well they are known",
		    s->set.speed_sd, w->exact_width, w->unit,
		    100 * (1 - w->exact_width / w->width));
}

/* Returns the candidates, best first, and sets *n to their number.  Returns
 * NULL if there is no band to narrow.  The caller frees them. */
static struct sample_advice *
rank_candidate_sample_speeds(
    const struct session *s, const struct advice_request *w, size_t *n)
{
	if (!(w->width > 0))
		return NULL;
	struct sample_advice *c = list_candidate_sample_speeds(
	    s, w->question->entry->site, w->question->speed, n);
	sort_sample_speeds_by_band_width(s, w, c, *n);
	return c;
}

bool
advise_find_best_sample(const struct session *s, const struct question *q,
    const struct quantity *of, struct sample_advice *best, double *width,
    double *exact_width)
{
	struct advice_request w = {.question = q, .q = *of};
	size_t n;
	FREED struct sample_advice *c =
	    compute_draws_and_bands_of_quantity(s, &w)
		? rank_candidate_sample_speeds(s, &w, &n)
		: NULL;
	if (c == NULL)
		return false;
	*best = c[0];
	*width = w.width;
	*exact_width = w.exact_width;
	return true;
}

/* Returns NULL if there is no band to narrow. */
static struct answer *
build_next_sample_answer(
    const struct session *s, const struct advice_request *w)
{
	const struct entry *entry = w->question->entry;
	double rotor = entry->site->rotor;
	size_t n;
	FREED struct sample_advice *c = rank_candidate_sample_speeds(s, w, &n);
	if (c == NULL)
		return NULL;
	FREED char *rpm = rotor_speed_rpm_text(rotor, w->question->speed, NAN);
	struct answer *r = answer_new_about_site(entry->site, "advise",
	    "what to sample next, for %s at %g m/s%s", w->name,
	    w->question->speed, rpm);
	answer_add_columns(r, "speed: sample at m/s");
	if (rotor > 0)
		answer_add_columns(r, "rpm: rpm");
	answer_add_columns(r,
	    "kind, width%s: band after%s, narrower_pct: narrower %%",
	    quantities_is_size(&w->q)                  ? "_mm"
	    : strcmp(quantities_unit(&w->q), "%") == 0 ? "_points"
						       : "",
	    w->unit);
	for (size_t i = 0; i < n; i++) {
		answer_add_cells(r, "%g", c[i].speed);
		if (rotor > 0)
			answer_add_cells(
			    r, "%.0f", rotor_speed_to_rpm(c[i].speed, rotor));
		answer_add_cells(r, "%s %.3f %.0f",
		    c[i].repeat ? tr("repeat") : tr("new"), c[i].width,
		    100 * (1 - c[i].width / w->width));
	}
	struct fields *o = answer_json_fields(r);
	fields_put_values(o, "quantity %s speed %g low %g high %g width %g",
	    w->name, w->question->speed, w->ends[0], w->ends[1], w->width);
	fields_put_values(
	    o, "best_mps %g best_width %g", c[0].speed, c[0].width);
	answer_add_rows_as_json_objects(r, "samples");
	note_best_sample_speed(r, w, &c[0]);
	note_gain_of_exact_speeds(r, s, w, &c[0]);
	warn_of_spread_over_feeds(r, s, w);
	return r;
}

/* Reads the quantity of of=; by default it is P80. */
static bool
parse_quantity_or_p80(
    const struct args *args, struct advice_request *w, struct error *error)
{
	const char *of = args->of != NULL ? args->of : "P80";
	size_t n;
	FREED struct quantity *q =
	    quantities_parse_list_for_feed(of, &w->question->fraction,
		question_feed(w->question), true, &n, error);
	if (q == NULL)
		return false;
	if (n > 1)
		return error_set(error, ERROR_USAGE,
		    "advise: expected one figure, got '%s'\n"
		    "write 'advise p80' or 'advise passing 2'",
		    of);
	w->q = q[0];
	w->name = quantities_name(&w->q);
	w->unit = quantities_difference_suffix(&w->q);
	return true;
}

static bool
show_sampling_advice(
    struct session *s, struct advice_request *w, struct error *error)
{
	const struct entry *entry = w->question->entry;
	if (posterior_if_params_of_entry(s, entry, &entry->params) == NULL)
		return band_set_error_missing(s, entry, error);
	if (!compute_draws_and_bands_of_quantity(s, w))
		return error_set(error, ERROR_DATA,
		    "%s at %g m/s lies outside the sieves\n"
		    "ask for another size",
		    w->name, w->question->speed);
	struct answer *r = build_next_sample_answer(s, w);
	if (r == NULL)
		return error_set(error, ERROR_DATA,
		    "%s at %g m/s is the same in all draws: no sample can "
		    "narrow its band",
		    w->name, w->question->speed);
	answers_note_basis_and_trust_at_speed(
	    s, r, w->question, w->question->speed, false);
	return session_show_answer(s, r);
}

bool
cmd_advise(struct session *s, const struct args *args, struct question *q,
    struct error *error)
{
	question_use_last_speed_and_feed(s, args, q);
	struct advice_request w = {.question = q};
	bool ok = parse_quantity_or_p80(args, &w, error) &&
		  show_sampling_advice(s, &w, error);
	free(w.name);
	return ok;
}

/* Compares each run that was not trained on with all ways to predict it
 * (validate_run), and sums their errors.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/fit/comparison.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/tr.h"
#include "base/xalloc.h"
#include "cmd/ask/answers.h"
#include "cmd/fit/job.h"
#include "cmd/fit/scores.h"
#include "core/posterior/ensemble.h"
#include "core/search/misfit.h"
#include "core/check/trust.h"
#include "io/sitefile/units.h"

void
comparison_drop(void *of)
{
	struct comparison *c = of;
	for (size_t i = 0; i < c->n; i++) {
		free(c->item[i].name);
		free(c->item[i].train);
		free(c->item[i].corrected);
	}
	free(c->item);
	free(c->options);
	free(c);
}

void
comparison_append(struct comparison *c, struct comparison *from)
{
	c->left_out += from->left_out;
	c->item = xrealloc(c->item, c->n + from->n + 1, sizeof *c->item);
	for (size_t i = 0; i < from->n; i++)
		c->item[c->n++] = from->item[i];
	from->n = 0;
	comparison_drop(from);
}

double *
comparison_corrected(const struct run *run, const struct posterior *posterior,
    double level, size_t *within)
{
	size_t n = misfit_covered(run);
	*within = 0;
	if (posterior == NULL)
		return NULL;
	double *passing = xdoubles(n);
	struct ensemble *e =
	    ensemble_new(posterior, &run->feed, run->product.size, n);
	ensemble_at(e, run->speed);
	ensemble_mean(e, passing);
	for (size_t i = 0; i < n; i++) {
		double P = run->product.passing[i], low, high;
		ensemble_band(e, ENSEMBLE_SAMPLE, i, level, &low, &high);
		/* To the 0.01 % that sheets are rounded to. */
		*within += P >= low - 1e-4 && P <= high + 1e-4;
	}
	ensemble_free(e);
	return passing;
}

/* Speeds of the training runs. */
static size_t
count_trained(const struct site *site, const bool *train)
{
	size_t n = 0;
	double last = 0;
	for (size_t r = 0; r < site->n_run; r++) {
		n += train[r] && site->run[r].speed != last;
		last = train[r] ? site->run[r].speed : last;
	}
	return n;
}

static void
comparison_compare(
    struct comparison *c, const struct predicted_by *by, size_t run)
{
	const struct site *site = by->site;
	const struct posterior *posterior = by->posterior;
	c->item = xrealloc(c->item, c->n + 1, sizeof *c->item);
	struct compared *item = &c->item[c->n++];
	size_t within;
	double *corrected =
	    comparison_corrected(&site->run[run], posterior, c->level, &within);
	*item = (struct compared){.entry = by->entry,
	    .site = site,
	    .name =
		xasprintf("%g%s", site->run[run].speed, site->run[run].repeat),
	    .train = xcalloc(site->n_run, sizeof *by->train),
	    .params = by->params,
	    .settings = by->settings,
	    .corrected = corrected,
	    .v = validate_run(
		site, run, by->train, &by->params, by->settings, corrected),
	    .open =
		trust_without_band(by->rmse, count_trained(site, by->train))};
	memcpy(item->train, by->train, site->n_run * sizeof *by->train);
	item->has_band = !c->all && posterior != NULL && !item->open;
	item->within = item->has_band ? within : 0;
}

void
comparison_add(struct comparison *c, const struct predicted_by *by)
{
	for (size_t r = 0; r < by->site->n_run; r++)
		if (!by->train[r] && misfit_covered(&by->site->run[r]) > 0)
			comparison_compare(c, by, r);
}

/* Root mean square over the runs of what each way errs. */
static void
run_rmse(const struct comparison *c, double rmse[static VALIDATE_WAYS])
{
	for (size_t way = 0; way < VALIDATE_WAYS; way++) {
		double sum = 0;
		for (size_t i = 0; i < c->n; i++)
			sum += pow(c->item[i].v.rmse[way], 2);
		rmse[way] = sqrt(sum / (double)c->n);
	}
}

/* What a way predicts at the sieves compared, [v.n_sieve]; the caller frees. */
static double *
passing_of_way(const struct compared *item, enum validate_way way)
{
	double *passing = xdoubles(item->v.n_sieve);
	validate_passing(item->site, item->v.run, item->train, &item->params,
	    item->settings, way, passing);
	if (way == VALIDATE_CORRECTED && item->corrected != NULL)
		memcpy(passing, item->corrected,
		    item->v.n_sieve * sizeof *passing);
	return passing;
}

/* "null", "winner". */
static void
put_null(struct fields *o, const double rmse[static VALIDATE_WAYS])
{
	scores_put_null(o, rmse);
	fields_put(o, "winner %s", SCORES_WAYS[validate_winner(rmse)].key);
}

static void
put_sizes(struct fields *o, const struct validation *v)
{
	for (size_t i = 0; i < PSD_SIZES; i++) {
		struct fields *size = fields_object(o, SCORES_SIZES[i]);
		fields_put(size,
		    "measured_mm %g predicted_mm %g corrected_mm %g",
		    1000 * v->measured[i], 1000 * v->size[VALIDATE_MODEL][i],
		    1000 * v->size[VALIDATE_CORRECTED][i]);
		for (size_t way = VALIDATE_NULL; way < VALIDATE_WAYS; way++) {
			FREED char *key =
			    xasprintf("%s_mm", SCORES_WAYS[way].key);
			fields_number(size, key, 1000 * v->size[way][i]);
		}
	}
}

static void
put_sieves(struct fields *o, const struct compared *item)
{
	const struct psd *product = &item->site->run[item->v.run].product;
	size_t n = item->v.n_sieve;
	fields_numbers(o, "sieve_mm", product->size, n, units_mm);
	fields_numbers(o, "measured_pct", product->passing, n, units_pct);
	for (enum validate_way way = 0; way < VALIDATE_WAYS; way++) {
		FREED double *passing = passing_of_way(item, way);
		FREED char *key = xasprintf("%s_pct", SCORES_WAYS[way].key);
		fields_numbers(o, key, passing, n, units_pct);
	}
}

static void
put_run(struct fields *o, const struct compared *item)
{
	const struct validation *v = &item->v;
	fields_number(o, "speed", v->speed);
	if (item->site->run[v->run].repeat[0] != '\0')
		fields_put(o, "run %s", item->name);
	fields_number(o, "rmse_pct", 100 * v->rmse[VALIDATE_MODEL]);
	fields_number(
	    o, "corrected_rmse_pct", 100 * v->rmse[VALIDATE_CORRECTED]);
	if (item->has_band)
		fields_number(o, "within", (double)item->within);
	put_sizes(o, v);
	put_null(o, v->rmse);
	fields_put(o, "loses_to_interpolation %d nearest_mps %g",
	    validation_loses_to_interpolation(v), v->nearest);
	fields_numbers(o, "interpolation_mps", v->line, 2, NULL);
	put_sieves(o, item);
}

static void
put_all(struct fields *o, const struct comparison *c)
{
	struct fields *list = fields_list(o, "holdout");
	double rmse[VALIDATE_WAYS];
	for (size_t i = 0; i < c->n; i++)
		put_run(fields_object(list, NULL), &c->item[i]);
	if (c->each)
		fields_put(o, "holdout_each %d", true);
	if (c->n == 0)
		return;
	run_rmse(c, rmse);
	o = fields_object(o, "overall");
	fields_number(o, "rmse_pct", 100 * rmse[VALIDATE_MODEL]);
	fields_number(o, "corrected_rmse_pct", 100 * rmse[VALIDATE_CORRECTED]);
	put_null(o, rmse);
}

/* The run, for programs behind its speed. */
static void
comparison_begin_row(struct answer *r, const struct compared *item, bool exact)
{
	if (exact)
		answer_cells(r, "%g", item->v.speed);
	answer_text(r, "%s", item->name);
}

static void
comparison_add_sieves(struct answer *r, const struct compared *item, bool exact)
{
	const struct psd *product = &item->site->run[item->v.run].product;
	double *passing[VALIDATE_WAYS];
	for (enum validate_way way = 0; way < VALIDATE_WAYS; way++)
		passing[way] = passing_of_way(item, way);
	answer_set_missing(r, "-");
	for (size_t i = 0; i < item->v.n_sieve; i++) {
		comparison_begin_row(r, item, exact);
		if (exact)
			answer_cells(r, "%g", units_mm(product->size[i]));
		else
			answer_text(r, "%g mm, %%", units_mm(product->size[i]));
		answer_cells(r, "%.1f", units_pct(product->passing[i]));
		for (size_t way = 0; way < VALIDATE_WAYS; way++)
			answer_cells(r, "%.1f", units_pct(passing[way][i]));
	}
	for (size_t way = 0; way < VALIDATE_WAYS; way++)
		free(passing[way]);
}

static void
add_rmse(struct answer *r, const char *run, const double *rmse)
{
	answer_text(r, "%s", run);
	answer_text(r, "RMSE points");
	answer_set_missing(r, "-");
	answer_cells(r, "%.2f", NAN);
	for (size_t way = 0; way < VALIDATE_WAYS; way++)
		answer_cells(r, "%.2f", 100 * rmse[way]);
}

static void
add_sizes(struct answer *r, const struct compared *item, bool exact)
{
	const struct validation *v = &item->v;
	answer_set_missing(r, "outside");
	for (size_t i = 0; i < PSD_SIZES; i++) {
		comparison_begin_row(r, item, exact);
		answer_text(
		    r, exact ? "P%.0f" : N_("P%.0f mm"), 100 * PSD_PASSING[i]);
		answer_cells(r, "%.3f", 1000 * v->measured[i]);
		for (size_t way = 0; way < VALIDATE_WAYS; way++)
			answer_cells(r, "%.3f", 1000 * v->size[way][i]);
	}
}

/* A table of sieves or of sizes for programs; people have both, and RMSE, below
 * each other. */
static void
add_table(struct answer *r, const struct comparison *c, bool exact)
{
	const char *unit = !exact ? "" : c->sieves ? "_pct" : "_mm";
	answer_columns(r, !exact      ? N_("speed: m/s, of: ")
			  : c->sieves ? N_("speed, run, sieve_mm")
				      : N_("speed, run, size"));
	answer_columns(r, "measured%s: measured", unit);
	for (size_t way = 0; way < VALIDATE_WAYS; way++)
		answer_columns(r, "%s%s: %s", SCORES_WAYS[way].key, unit,
		    tr(SCORES_WAYS[way].head));
	for (size_t i = 0; i < c->n; i++) {
		const struct compared *item = &c->item[i];
		if (c->sieves)
			comparison_add_sieves(r, item, exact);
		if (!exact)
			add_rmse(r, item->name, item->v.rmse);
		if (!exact || !c->sieves)
			add_sizes(r, item, exact);
	}
}

/* A difference of RMSE, passing 0..1, that sampling could tell. */
static const double CLEARLY = 0.001;

/* RMSE of the other sieves than the worst, passing 0..1. */
static double
rmse_of_others(const struct validation *v)
{
	double n = (double)v->n_sieve;
	double square = v->misfit - v->worst_difference * v->worst_difference;
	return sqrt(fmax(square, 0) / (n - 1));
}

/* The worst sieve is far beyond the others and beyond sampling: rather a slip
 * of the pen than a fault of the model, which errs on several sieves. */
static bool
is_worst_far_off(const struct validation *v)
{
	const double times = 4, least = 0.03;
	double worst = fabs(v->worst_difference);
	return v->n_sieve > 3 && worst > least &&
	       worst > times * rmse_of_others(v);
}

/* Who predicts best.  worse: that is neither the model nor the corrected
 * answer; clearly: and sampling could tell. */
struct winner {
	enum validate_way best;
	bool worse, clearly;
};

static struct winner
winner_of(const double rmse[static VALIDATE_WAYS])
{
	enum validate_way best = validate_winner(rmse);
	double corrected = rmse[VALIDATE_CORRECTED];
	double own =
	    fmin(rmse[VALIDATE_MODEL], isnan(corrected) ? INFINITY : corrected);
	bool worse = best >= VALIDATE_NULL;
	return (struct winner){.best = best,
	    .worse = worse,
	    .clearly =
		worse && own > 1.1 * rmse[best] && own - rmse[best] > CLEARLY};
}

/* A run that something else clearly predicts better. */
static void
warn_worse(struct answer *r, const struct validation *v, const char *run)
{
	struct winner w = winner_of(v->rmse);
	bool between =
	    w.best == VALIDATE_INTERPOLATION && !validation_extrapolates(v);
	FREED char *who = xstrdup(tr(SCORES_WAYS[w.best].noun));
	if (!w.clearly)
		return;
	if (w.best == VALIDATE_NEAREST)
		xappend(&who, ", %g m/s", v->nearest);
	answer_say(r, ANSWER_WARNING,
	    between ? N_("at %s model and corrected answer predict "
			 "worse than %s: between the training speeds, "
			 "prefer the interpolated products")
		    : N_("at %s model and corrected answer predict "
			 "worse than %s"),
	    run, who);
}

/* One way for all runs, of which each is warned of by itself. */
static void
note_winner(struct answer *r, const struct comparison *c)
{
	double rmse[VALIDATE_WAYS];
	run_rmse(c, rmse);
	struct winner w = winner_of(rmse);
	FREED char *who = xstrdup(tr(SCORES_WAYS[w.best].noun));
	bool one = c->n == 1, some = isnan(rmse[VALIDATE_INTERPOLATION]);
	if (one && w.best == VALIDATE_NEAREST)
		xappend(&who, ", %g m/s", c->item[0].v.nearest);
	if (!w.worse)
		answer_note(r,
		    one && some ? N_("  %s predicts best of those with an "
				     "answer on all sieves")
		    : one       ? N_("  %s predicts best")
		    : some ? N_("in all: %s predicts best of those with an "
				"answer on all sieves")
			   : N_("in all: %s predicts best"),
		    who);
	else if (!w.clearly)
		answer_say(r, ANSWER_REMARK,
		    one ? N_("  the model predicts no better than %s at this "
			     "speed; the difference is too small for sampling "
			     "to show")
			: N_("in all: the model predicts no better than %s; "
			     "the difference is too small for sampling to "
			     "show"),
		    who);
	else if (!one)
		answer_say(r, ANSWER_REMARK,
		    "in all: model and corrected answer predict worse than %s",
		    who);
}

static void
note_run(struct answer *r, const struct comparison *c, size_t i)
{
	const struct compared *item = &c->item[i];
	const struct validation *v = &item->v;
	FREED char *run =
	    xasprintf("%g m/s%s", v->speed, item->site->run[v->run].repeat);
	answer_note(r,
	    "at %s: largest error %+.2f points at %g mm (model alone - "
	    "measured)",
	    run, 100 * v->worst_difference, units_mm(v->worst_sieve));
	warn_worse(r, v, run);
	if (c->n == 1)
		note_winner(r, c);
	if (item->has_band)
		answer_note(r,
		    "  %zu of %zu measured passings lie in the %.0f %% band "
		    "for a sample there",
		    item->within, v->n_sieve, 100 * c->level);
	else if (item->open)
		answer_say(r, ANSWER_REMARK,
		    "  no band: the fit is poor, and two speeds do not show "
		    "how its error changes with the speed");
	if (isnan(v->rmse[VALIDATE_INTERPOLATION]))
		answer_say(r, ANSWER_REMARK,
		    isnan(v->line[1])
			? N_("  no interpolation: there is one training speed")
			: N_("  no interpolation: a training product lacks "
			     "some of these sieves"));
	else if (validation_extrapolates(v))
		answer_say(r, ANSWER_REMARK,
		    "  interpolation extrapolates here: the line through %g "
		    "and %g m/s",
		    v->line[0], v->line[1]);
	if (is_worst_far_off(v))
		answer_say(r, ANSWER_REMARK,
		    "  %g mm stands out (RMSE of the other sieves: %.2f "
		    "points): check that cell",
		    units_mm(v->worst_sieve), 100 * rmse_of_others(v));
	if (v->n_left_out > 0)
		answer_say(r, ANSWER_REMARK,
		    "  %zu finer sieves are not compared: the feed was not "
		    "sieved so fine",
		    v->n_left_out);
}

struct answer *
comparison_answer(const struct comparison *c, const struct site *site)
{
	double rmse[VALIDATE_WAYS];
	struct answer *r = answers_new(site, "validate", "%s",
	    c->each ? tr("each speed held out, the others calibrated on")
		    : tr("held-out speeds, measured and predicted"));
	add_table(r, c, false);
	if (c->n > 1) {
		run_rmse(c, rmse);
		add_rmse(r, "all", rmse);
	}
	answer_fill_for_programs(r);
	add_table(r, c, true);
	for (size_t i = 0; i < c->n; i++)
		note_run(r, c, i);
	if (c->n > 1)
		note_winner(r, c);
	if (c->n == 0)
		answer_say(r, ANSWER_REMARK,
		    job_speeds(site) < JOB_FOR_EACH
			? N_("no run was held out; measure another speed to "
			     "test "
			     "the model")
			: N_("no run was held out: 'validate holdout=each' "
			     "holds "
			     "out each speed in turn"));
	put_all(answer_fields(r), c);
	return r;
}

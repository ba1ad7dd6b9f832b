/* validate: the model against runs it has not seen, beside who needs no model.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/xalloc.h"
#include "cmd/answers.h"
#include "cmd/fit.h"
#include "cmd/job.h"
#include "cmd/light.h"
#include "cmd/outlook.h"
#include "cmd/table.h"
#include "core/misfit.h"
#include "core/trust.h"
#include "core/validate.h"
#include "io/units.h"

/* How each way is called: in keys, over its column, and in sentences. */
static const struct {
	const char *key, *head, *noun;
} WAYS[VALIDATE_WAYS] = {[VALIDATE_MODEL] = {"model", "model", "the model"},
    [VALIDATE_CORRECTED] = {"corrected", "corrected", "the corrected answer"},
    [VALIDATE_INTERPOLATION] = {"interpolation", "interpolated",
	"interpolation"},
    [VALIDATE_NEAREST] = {"nearest", "nearest",
	"the product at the nearest training speed"},
    [VALIDATE_FEED] = {"feed", "feed", "the unchanged feed"}};

static const char *const SIZES[PSD_SIZES] = {"p20", "p50", "p80"};

/* A run that was compared, with what predicted it.  name: "74 (2)".  within:
 * how many of its passings lie in the band for one more sample. */
struct compared {
	const struct site *site;
	char *name;
	bool *train;
	struct params params;
	struct model_settings settings;
	bool has_band, open; /* open: see trust_without_band */
	struct validation v;
	size_t within;
	double *corrected; /* [v.n_sieve] */
};

/* What one `validate` compares.  at, end, speed: of holdout=each, the site that
 * is looked at, the one to stop before, and the speed left out last. */
struct comparison {
	bool all, each, sieves;
	double level;
	size_t n, left_out;
	struct compared *item;
	size_t at, end;
	double speed;
};

static void
comparison_drop(void *of)
{
	struct comparison *c = of;
	for (size_t i = 0; i < c->n; i++) {
		free(c->item[i].name);
		free(c->item[i].train);
		free(c->item[i].corrected);
	}
	free(c->item);
	free(c);
}

/* How many of the run's passings lie in the band for a sample. */
static size_t
count_within(const struct site *site, size_t run,
    const struct posterior *posterior, double level)
{
	const struct run *at = &site->run[run];
	size_t n = misfit_covered(at), within = 0;
	struct ensemble *e =
	    ensemble_new(posterior, &at->feed, at->product.size, n);
	ensemble_at(e, at->speed);
	for (size_t i = 0; i < n; i++) {
		double P = at->product.passing[i], low, high;
		ensemble_band(e, ENSEMBLE_SAMPLE, i, level, &low, &high);
		/* To the 0.01 % that sheets are rounded to. */
		within += P >= low - 1e-4 && P <= high + 1e-4;
	}
	ensemble_free(e);
	return within;
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

/* rmse: of the fit, 0..1. */
static void
compare(struct comparison *c, const struct site *site, size_t run,
    const bool *train, const struct params *p, struct model_settings settings,
    const struct posterior *posterior, double rmse)
{
	c->item = xrealloc(c->item, c->n + 1, sizeof *c->item);
	struct compared *item = &c->item[c->n++];
	*item = (struct compared){.site = site,
	    .name =
		xasprintf("%g%s", site->run[run].speed, site->run[run].repeat),
	    .train = xcalloc(site->n_run, sizeof *train),
	    .params = *p,
	    .settings = settings,
	    .v = validate_run(site, run, train, p, settings, posterior),
	    .open = trust_without_band(rmse, count_trained(site, train)),
	    .has_band = posterior != NULL,
	    .within = posterior != NULL
			  ? count_within(site, run, posterior, c->level)
			  : 0};
	item->has_band = item->has_band && !item->open;
	memcpy(item->train, train, site->n_run * sizeof *train);
	item->corrected = xdoubles(item->v.n_sieve);
	validate_passing(site, run, train, p, settings, posterior,
	    VALIDATE_CORRECTED, item->corrected);
}

/* Root mean square over the runs of what each way errs. */
static void
overall(const struct comparison *c, double rmse[static VALIDATE_WAYS])
{
	for (size_t way = 0; way < VALIDATE_WAYS; way++) {
		double sum = 0;
		for (size_t i = 0; i < c->n; i++)
			sum += pow(c->item[i].v.rmse[way], 2);
		rmse[way] = sqrt(sum / (double)c->n);
	}
}

/* "null": {"feed_rmse_pct": ..}, "winner". */
static void
put_null(struct fields *o, const double rmse[static VALIDATE_WAYS])
{
	struct fields *null = fields_object(o, "null");
	for (enum validate_way way = VALIDATE_NULL; way < VALIDATE_WAYS;
	     way++) {
		char *key = xasprintf("%s_rmse_pct", WAYS[way].key);
		fields_number(null, key, 100 * rmse[way]);
		free(key);
	}
	fields_put(o, "winner %s", WAYS[validate_winner(rmse)].key);
}

static void
put_sizes(struct fields *o, const struct validation *v)
{
	for (size_t i = 0; i < PSD_SIZES; i++) {
		struct fields *size = fields_object(o, SIZES[i]);
		fields_put(size,
		    "measured_mm %g predicted_mm %g corrected_mm %g",
		    1000 * v->measured[i], 1000 * v->size[VALIDATE_MODEL][i],
		    1000 * v->size[VALIDATE_CORRECTED][i]);
		for (size_t way = VALIDATE_NULL; way < VALIDATE_WAYS; way++) {
			char *key = xasprintf("%s_mm", WAYS[way].key);
			fields_number(size, key, 1000 * v->size[way][i]);
			free(key);
		}
	}
}

/* What a way predicts at the sieves compared, [n_sieve]; the caller frees. */
static double *
passing_of(const struct compared *item, enum validate_way way)
{
	double *passing = xdoubles(item->v.n_sieve);
	validate_passing(item->site, item->v.run, item->train, &item->params,
	    item->settings, NULL, way, passing);
	if (way == VALIDATE_CORRECTED)
		memcpy(passing, item->corrected,
		    item->v.n_sieve * sizeof *passing);
	return passing;
}

static void
put_sieves(struct fields *o, const struct compared *item)
{
	const struct psd *product = &item->site->run[item->v.run].product;
	size_t n = item->v.n_sieve;
	fields_numbers(o, "sieve_mm", product->size, n, units_mm);
	fields_numbers(o, "measured_pct", product->passing, n, units_pct);
	for (enum validate_way way = 0; way < VALIDATE_WAYS; way++) {
		double *passing = passing_of(item, way);
		char *key = xasprintf("%s_pct", WAYS[way].key);
		fields_numbers(o, key, passing, n, units_pct);
		free(key);
		free(passing);
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
	    validation_loses(v), v->nearest);
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
	overall(c, rmse);
	o = fields_object(o, "overall");
	fields_number(o, "rmse_pct", 100 * rmse[VALIDATE_MODEL]);
	fields_number(o, "corrected_rmse_pct", 100 * rmse[VALIDATE_CORRECTED]);
	put_null(o, rmse);
}

/* The run, for programs behind its speed. */
static void
begin_row(struct answer *r, const struct compared *item, bool exact)
{
	if (exact)
		answer_cells(r, "%g", item->v.speed);
	answer_text(r, "%s", item->name);
}

static void
add_sieves(struct answer *r, const struct compared *item, bool exact)
{
	const struct psd *product = &item->site->run[item->v.run].product;
	double *passing[VALIDATE_WAYS];
	for (enum validate_way way = 0; way < VALIDATE_WAYS; way++)
		passing[way] = passing_of(item, way);
	answer_missing(r, "-");
	for (size_t i = 0; i < item->v.n_sieve; i++) {
		begin_row(r, item, exact);
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
	answer_text(r, "RMSE, points");
	answer_missing(r, "-");
	answer_cells(r, "%.2f", NAN);
	for (size_t way = 0; way < VALIDATE_WAYS; way++)
		answer_cells(r, "%.2f", 100 * rmse[way]);
}

static void
add_sizes(struct answer *r, const struct compared *item, bool exact)
{
	const struct validation *v = &item->v;
	answer_missing(r, "outside");
	for (size_t i = 0; i < PSD_SIZES; i++) {
		begin_row(r, item, exact);
		answer_text(
		    r, exact ? "P%.0f" : "P%.0f, mm", 100 * PSD_PASSING[i]);
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
	answer_columns(r, !exact      ? "speed: m/s, of: "
			  : c->sieves ? "speed, run, sieve_mm"
				      : "speed, run, size");
	answer_columns(r, "measured%s: measured", unit);
	for (size_t way = 0; way < VALIDATE_WAYS; way++)
		answer_columns(
		    r, "%s%s: %s", WAYS[way].key, unit, WAYS[way].head);
	for (size_t i = 0; i < c->n; i++) {
		const struct compared *item = &c->item[i];
		if (c->sieves)
			add_sieves(r, item, exact);
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
rest(const struct validation *v)
{
	double n = (double)v->n_sieve;
	double square = v->misfit - v->worst_difference * v->worst_difference;
	return sqrt(fmax(square, 0) / (n - 1));
}

/* The worst sieve is far beyond the others and beyond sampling: rather a slip
 * of the pen than a fault of the model, which errs on several sieves. */
static bool
stands_out(const struct validation *v)
{
	const double times = 4, least = 0.03;
	double worst = fabs(v->worst_difference);
	return v->n_sieve > 3 && worst > least && worst > times * rest(v);
}

/* Who predicts best, and a warning where that is clearly neither the model nor
 * the corrected answer. */
static void
note_winner(struct answer *r, const struct validation *v, const char *run)
{
	enum validate_way best = validate_winner(v->rmse);
	double own = fmin(v->rmse[VALIDATE_MODEL],
	    isnan(v->rmse[VALIDATE_CORRECTED]) ? INFINITY
					       : v->rmse[VALIDATE_CORRECTED]);
	double least = v->rmse[best];
	bool clearly = own > 1.1 * least && own - least > CLEARLY;
	bool between =
	    best == VALIDATE_INTERPOLATION && !validation_extrapolates(v);
	char *who = xstrdup(WAYS[best].noun);
	if (best == VALIDATE_NEAREST)
		xappend(&who, ", %g m/s", v->nearest);
	if (best < VALIDATE_NULL)
		answer_note(r, "  %s predicts best%s", who,
		    isnan(v->rmse[VALIDATE_INTERPOLATION])
			? " of those with an answer on all sieves"
			: "");
	else if (clearly)
		answer_say(r, ANSWER_WARNING,
		    "at %s model and corrected answer predict worse than %s%s",
		    run, who,
		    between ? ": between the training speeds, prefer the "
			      "interpolated products"
			    : "");
	else
		answer_say(r, ANSWER_REMARK,
		    "  the model predicts no better than %s at this speed; the "
		    "difference is too small for sampling to show",
		    who);
	free(who);
}

static void
note_run(struct answer *r, const struct compared *item, double level)
{
	const struct validation *v = &item->v;
	char *run =
	    xasprintf("%g m/s%s", v->speed, item->site->run[v->run].repeat);
	answer_note(r,
	    "at %s: RMSE %.2f points over %zu sieves, misfit %.4g; largest "
	    "error %+.2f points at %g mm (predicted - measured)",
	    run, 100 * v->rmse[VALIDATE_MODEL], v->n_sieve, v->misfit,
	    100 * v->worst_difference, units_mm(v->worst_sieve));
	note_winner(r, v, run);
	if (item->has_band)
		answer_note(r,
		    "  %zu of %zu measured passings lie in the %.0f %% band "
		    "for a sample there",
		    item->within, v->n_sieve, 100 * level);
	else if (item->open)
		answer_say(r, ANSWER_REMARK,
		    "  no band: the fit is poor, and two speeds do not show "
		    "how its error changes with the speed");
	free(run);
	if (isnan(v->rmse[VALIDATE_INTERPOLATION]))
		answer_say(r, ANSWER_REMARK, "  no interpolation: %s",
		    isnan(v->line[1])
			? "there is one training speed"
			: "a training product lacks some of these sieves");
	else if (validation_extrapolates(v))
		answer_say(r, ANSWER_REMARK,
		    "  interpolation extrapolates here: the line through %g "
		    "and %g m/s",
		    v->line[0], v->line[1]);
	if (stands_out(v))
		answer_say(r, ANSWER_REMARK,
		    "  %g mm stands out (RMSE of the other sieves: %.2f "
		    "points): check that cell",
		    units_mm(v->worst_sieve), 100 * rest(v));
	if (v->n_left_out > 0)
		answer_say(r, ANSWER_REMARK,
		    "  %zu finer sieves are not compared: the feed was not "
		    "sieved so fine",
		    v->n_left_out);
}

/* Of one site. */
static struct answer *
run_answer(struct session *s, const struct comparison *c)
{
	const struct site *site =
	    c->n > 0 ? c->item[0].site : session_entry(s)->site;
	double rmse[VALIDATE_WAYS];
	struct answer *r = answers_new(site, "validate", "%s",
	    c->each ? "each speed held out, the others calibrated on"
		    : "held-out speeds, measured and predicted");
	add_table(r, c, false);
	if (c->n > 1) {
		overall(c, rmse);
		add_rmse(r, "all", rmse);
	}
	answer_for_programs(r);
	add_table(r, c, true);
	for (size_t i = 0; i < c->n; i++)
		note_run(r, &c->item[i], c->level);
	if (c->n == 0)
		answer_say(r, ANSWER_REMARK,
		    job_speeds(site) < JOB_FOR_EACH
			? "no run was held out; measure another speed to test "
			  "the model"
			: "no run was held out: 'validate holdout=each' holds "
			  "out each speed in turn");
	put_all(answer_fields(r), c);
	return r;
}

/* Bias, rms and R2 of a size. */
static void
put_score(struct fields *o, size_t i, struct validate_score score)
{
	fields_put(fields_object(o, SIZES[i]),
	    "n %zu bias_pct %g rms_pct %g r2 %g", score.n, 100 * score.bias,
	    100 * score.rms, score.r2);
}

static void
add_scores(struct answer *r, const struct comparison *c)
{
	struct fields *o = answer_fields(r), *null = NULL;
	const struct validation **v = xcalloc(c->n + 1, sizeof(*v));
	for (size_t k = 0; k < c->n; k++)
		v[k] = &c->item[k].v;
	answer_columns(r, "size, by: predicted by, n: runs, bias_pct: bias %%, "
			  "rms_pct: rms %%, r2: R2");
	for (size_t i = 0; i < PSD_SIZES; i++)
		for (enum validate_way way = 0; way < VALIDATE_WAYS; way++) {
			struct validate_score score =
			    validate_score(v, c->n, way, i);
			answer_text(r, "P%.0f", 100 * PSD_PASSING[i]);
			answer_cells(r, "%s %g %.2f %.2f %.4f", WAYS[way].key,
			    (double)score.n, 100 * score.bias, 100 * score.rms,
			    score.r2);
			if (way == VALIDATE_MODEL)
				put_score(o, i, score);
		}
	struct fields *corrected = fields_object(o, "corrected");
	for (size_t i = 0; i < PSD_SIZES; i++)
		put_score(corrected, i,
		    validate_score(v, c->n, VALIDATE_CORRECTED, i));
	null = fields_object(o, "null");
	for (enum validate_way way = VALIDATE_NULL; way < VALIDATE_WAYS;
	     way++) {
		struct fields *own = fields_object(null, WAYS[way].key);
		for (size_t i = 0; i < PSD_SIZES; i++)
			put_score(own, i, validate_score(v, c->n, way, i));
	}
	free(v);
}

/* At how many runs each way is the best. */
static void
add_wins(struct answer *r, const struct comparison *c)
{
	size_t wins[VALIDATE_WAYS] = {0};
	struct fields *o = fields_object(answer_fields(r), "wins");
	char *list = xstrdup("");
	for (size_t k = 0; k < c->n; k++)
		wins[validate_winner(c->item[k].v.rmse)]++;
	for (size_t way = 0; way < VALIDATE_WAYS; way++) {
		fields_number(o, WAYS[way].key, (double)wins[way]);
		xlist(&list, ", ", "%s %zu", WAYS[way].noun, wins[way]);
	}
	answer_note(
	    r, "best at how many of the %zu runs (RMSE): %s", c->n, list);
	free(list);
}

/* Over all sites. */
static struct answer *
all_answer(const struct comparison *c)
{
	struct answer *r = answer_new("validate");
	char *about = xstrdup("");
	size_t sites = 0;
	for (size_t k = 0; k < c->n; k++) {
		if (k > 0 && c->item[k].site == c->item[k - 1].site)
			continue;
		sites++;
		site_add_source(&about, c->item[k].site);
	}
	answer_title(r, "sizes at %s, %zu site%s",
	    c->each ? "each speed held out in turn" : "held-out speeds", sites,
	    sites == 1 ? "" : "s");
	answer_sites(r, "all", about);
	fields_put(answer_fields(r), "sites %zu runs %zu", sites, c->n);
	add_scores(r, c);
	add_wins(r, c);
	if (c->each)
		fields_put(answer_fields(r), "holdout_each %d", true);
	if (c->left_out > 0)
		answer_say(r, ANSWER_REMARK,
		    c->each
			? "%zu loaded site%s with fewer than three speeds: not "
			  "compared"
			: "%zu loaded site%s without a calibration or a "
			  "held-out run: not compared",
		    c->left_out, c->left_out == 1 ? "" : "s");
	free(about);
	return r;
}

/* Compares the held-out runs of an entry. */
static void
compare_entry(
    struct session *s, const struct entry *entry, struct comparison *c)
{
	size_t before = c->n;
	const struct fit *fit = origin_fit(entry);
	for (size_t i = 0; i < entry->site->n_run; i++)
		if (!entry->train[i] &&
		    misfit_covered(&entry->site->run[i]) > 0)
			compare(c, entry->site, i, entry->train, &entry->params,
			    s->set.model,
			    outlook_posterior(s, entry, CORRECTION_TRAIN),
			    fit != NULL ? fit->rmse : 0);
	c->left_out += c->n == before;
}

static bool
validate_all(struct session *s, struct comparison *c, struct error *error)
{
	for (size_t i = 0; i < s->n_entry; i++) {
		const struct entry *entry = &s->entry[i];
		if (!entry->has_fit) {
			c->left_out++;
			continue;
		}
		if (!answers_known(s, entry, error))
			return false;
		compare_entry(s, entry, c);
	}
	if (c->n == 0)
		return error_set(error, ERROR_USAGE,
		    "no loaded site has both a calibration and a held-out run\n"
		    "load sites with three speeds, then run 'calibrate all'");
	return session_answer(s, all_answer(c));
}

static bool
validate_one(struct session *s, struct comparison *c, struct error *error)
{
	if (!answers_ready(s, error))
		return false;
	const struct entry *entry = session_entry(s);
	compare_entry(s, entry, c);
	struct answer *r = run_answer(s, c);
	origin_note(r, entry);
	if (entry->has_fit)
		fields_put(answer_fields(r), "verdict %s",
		    light_verdict(s, entry, NULL));
	answers_note_model(s, r, entry);
	light_show(r, light_of(s, entry, NULL));
	return session_answer(s, r);
}

/* The next speed to hold out, of a site that has enough. */
static bool
next_speed(struct session *s)
{
	struct comparison *c = s->job.of;
	for (; c->at < c->end; c->at++, c->speed = 0) {
		const struct site *site = s->entry[c->at].site;
		if (job_speeds(site) < JOB_FOR_EACH) {
			c->left_out++;
			continue;
		}
		free(s->job.train);
		s->job.train = xcalloc(site->n_run, sizeof *s->job.train);
		s->job.entry = c->at;
		if (job_hold_out(site, &c->speed, s->job.train))
			return true;
	}
	return false;
}

/* Compares the runs at the speed held out with what the others have found. */
static void
take_speed(struct session *s)
{
	struct comparison *c = s->job.of;
	const struct job *job = &s->job;
	const struct site *site = s->entry[job->entry].site;
	struct fit fit = calibration_fit(job->calibration);
	bool few = fit.cells <= fit.parameters;
	struct posterior_options o = {.use = job->train,
	    .settings = fit.settings,
	    .bounds = *calibration_bounds(job->calibration),
	    .seed = fit.seed,
	    .threads = s->set.threads,
	    .isa = s->isa,
	    .noise = s->set.noise / 100,
	    .stop = job->options.stop};
	struct posterior *posterior =
	    few ? NULL : posterior_new(site, &fit.params, &o);
	for (size_t r = 0; r < site->n_run; r++)
		if (site->run[r].speed == c->speed &&
		    misfit_covered(&site->run[r]) > 0)
			compare(c, site, r, job->train, &fit.params,
			    fit.settings, posterior, fit.rmse);
	posterior_free(posterior);
}

static void
end_speeds(struct session *s, void *of)
{
	struct comparison *c = of;
	session_answer(s, c->all ? all_answer(c) : run_answer(s, c));
	comparison_drop(c);
}

static const struct rounds EACH = {next_speed, take_speed, end_speeds,
    comparison_drop, false, "stopped before all speeds were predicted"};

/* Calibrates without each speed in turn; c is the job's. */
static bool
validate_each(struct session *s, struct comparison *c, struct error *error)
{
	c->at = c->all ? 0 : s->current;
	c->end = c->all ? s->n_entry : s->current + 1;
	session_let_go(s);
	const struct job job = {
	    .rounds = &EACH, .of = c, .options = job_options(s)};
	return job_start(s, &job) ||
	       error_set(error, ERROR_DATA,
		   "holdout=each: expected products at three or more speeds, "
		   "so that two are left to calibrate on\n"
		   "measure another speed");
}

bool
cmd_validate(struct session *s, const struct args *args, struct error *error)
{
	struct comparison c = {.all = args->n_operand > 0,
	    .each = args_value(args, "holdout")->choice == 1,
	    .sieves = args_value(args, "sieves")->choice == 1,
	    .level = settings_level(&s->set)};
	if (c.all && strcmp(args->operand[0], "all") != 0)
		return error_set(error, ERROR_USAGE,
		    "validate: expected options or all, got '%s'",
		    args->operand[0]);
	if (c.all && c.sieves)
		return error_set(error, ERROR_USAGE,
		    "validate all: expected no sieves=on; it sums up over the "
		    "sites");
	if (c.each &&
	    !fit_settings_agree(&s->set.model, s->set.model.breakage, error))
		return false;
	struct comparison *own = xcalloc(1, sizeof *own);
	*own = c;
	if (c.each)
		return validate_each(s, own, error);
	bool ok = (c.all ? validate_all : validate_one)(s, own, error);
	comparison_drop(own);
	return ok;
}

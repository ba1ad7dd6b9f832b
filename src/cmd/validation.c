/* validate: the model against runs it has not seen, beside who needs no model.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/pool.h"
#include "base/tr.h"
#include "base/xalloc.h"
#include "cmd/answers.h"
#include "cmd/fit.h"
#include "cmd/invocation.h"
#include "cmd/job.h"
#include "cmd/light.h"
#include "cmd/outlook.h"
#include "cmd/part.h"
#include "cmd/scores.h"
#include "cmd/table.h"
#include "core/misfit.h"
#include "core/trust.h"
#include "core/validate.h"
#include "io/units.h"

/* A run that was compared, with what predicted it.  entry: its site's.  name:
 * "74 (2)".  within: how many of its passings lie in the band for one more
 * sample; this and corrected are of one site alone. */
struct compared {
	size_t entry;
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
	struct part part;
	char *options; /* that all parts must have */
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
	free(c->options);
	free(c);
}

/* Moves the runs of one behind those of the other. */
static void
comparison_take(struct comparison *c, struct comparison *from)
{
	c->left_out += from->left_out;
	c->item = xrealloc(c->item, c->n + from->n + 1, sizeof *c->item);
	for (size_t i = 0; i < from->n; i++)
		c->item[c->n++] = from->item[i];
	from->n = 0;
	comparison_drop(from);
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

/* What runs of a site are compared with.  rmse: of the fit, 0..1. */
struct predicted_by {
	size_t entry;
	const struct site *site;
	const bool *train;
	struct params params;
	struct model_settings settings;
	const struct posterior *posterior;
	double rmse;
};

static void
compare(struct comparison *c, const struct predicted_by *by, size_t run)
{
	const struct site *site = by->site;
	const struct posterior *posterior = by->posterior;
	c->item = xrealloc(c->item, c->n + 1, sizeof *c->item);
	struct compared *item = &c->item[c->n++];
	*item = (struct compared){.entry = by->entry,
	    .site = site,
	    .name =
		xasprintf("%g%s", site->run[run].speed, site->run[run].repeat),
	    .train = xcalloc(site->n_run, sizeof *by->train),
	    .params = by->params,
	    .settings = by->settings,
	    .v = validate_run(
		site, run, by->train, &by->params, by->settings, posterior),
	    .open =
		trust_without_band(by->rmse, count_trained(site, by->train))};
	memcpy(item->train, by->train, site->n_run * sizeof *by->train);
	if (c->all)
		return;
	item->has_band = posterior != NULL && !item->open;
	if (item->has_band)
		item->within = count_within(site, run, posterior, c->level);
	item->corrected = xdoubles(item->v.n_sieve);
	validate_passing(site, run, by->train, &by->params, by->settings,
	    posterior, VALIDATE_CORRECTED, item->corrected);
}

/* All runs held out. */
static void
compare_runs(struct comparison *c, const struct predicted_by *by)
{
	for (size_t r = 0; r < by->site->n_run; r++)
		if (!by->train[r] && misfit_covered(&by->site->run[r]) > 0)
			compare(c, by, r);
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
		char *key = xasprintf("%s_rmse_pct", SCORES_WAYS[way].key);
		fields_number(null, key, 100 * rmse[way]);
		free(key);
	}
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
			char *key = xasprintf("%s_mm", SCORES_WAYS[way].key);
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
		char *key = xasprintf("%s_pct", SCORES_WAYS[way].key);
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
		    r, exact ? "P%.0f" : N_("P%.0f, mm"), 100 * PSD_PASSING[i]);
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
	char *who = xstrdup(tr(SCORES_WAYS[best].noun));
	if (best == VALIDATE_NEAREST)
		xappend(&who, ", %g m/s", v->nearest);
	if (best < VALIDATE_NULL)
		answer_note(r,
		    isnan(v->rmse[VALIDATE_INTERPOLATION])
			? N_("  %s predicts best of those with an answer on "
			     "all sieves")
			: N_("  %s predicts best"),
		    who);
	else if (clearly)
		answer_say(r, ANSWER_WARNING,
		    between ? N_("at %s model and corrected answer predict "
				 "worse than %s: between the training speeds, "
				 "prefer the interpolated products")
			    : N_("at %s model and corrected answer predict "
				 "worse than %s"),
		    run, who);
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
	    c->each ? tr("each speed held out, the others calibrated on")
		    : tr("held-out speeds, measured and predicted"));
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
			? N_("no run was held out; measure another speed to "
			     "test "
			     "the model")
			: N_("no run was held out: 'validate holdout=each' "
			     "holds "
			     "out each speed in turn"));
	put_all(answer_fields(r), c);
	return r;
}

/* Compares the held-out runs of an entry. */
static void
compare_entry(const struct session *s, size_t index,
    const struct posterior *posterior, struct comparison *c)
{
	size_t before = c->n;
	const struct entry *entry = &s->entry[index];
	const struct fit *fit = origin_fit(entry);
	compare_runs(c, &(struct predicted_by){index, entry->site, entry->train,
			    entry->params, s->set.model, posterior,
			    fit != NULL ? fit->rmse : 0});
	c->left_out += c->n == before;
}

/* A line for each run of a site of many as it ends. */
static void
tell_compared(const struct session *s, const struct comparison *found)
{
	for (size_t i = 0; i < found->n; i++) {
		const struct compared *item = &found->item[i];
		const double *rmse = item->v.rmse;
		bool drawn = !isnan(rmse[VALIDATE_CORRECTED]);
		session_note(s,
		    drawn ? N_("  %s at %s m/s: RMSE %.2f points, "
			       "corrected %.2f")
			  : N_("  %s at %s m/s: RMSE %.2f points (%.2f "
			       "interpolated)"),
		    s->entry[item->entry].key, item->name,
		    100 * rmse[VALIDATE_MODEL],
		    100 * rmse[drawn ? VALIDATE_CORRECTED
				     : VALIDATE_INTERPOLATION]);
	}
}

static void
give_all(struct session *s, const struct comparison *c)
{
	struct scores scores = {.each = c->each, .left_out = c->left_out};
	size_t *index = xcalloc(c->n + 1, sizeof *index);
	for (size_t i = 0; i < c->n; i++) {
		const struct compared *item = &c->item[i];
		char *source = site_source(item->site, "provenance not stated");
		index[i] = item->entry;
		scores_add(
		    &scores, &(struct scored){item->entry,
				 s->entry[item->entry].key, source, item->v});
		free(source);
	}
	struct answer *r = scores_answer(&scores);
	if (c->part.of > 0) {
		part_sign(r, s, &c->part, index, c->n, c->options);
		fields_put(answer_fields(r), "left_out %zu each %zu",
		    c->left_out, (size_t)c->each);
		scores_put(answer_fields(r), &scores);
	}
	session_answer(s, r);
	scores_clear(&scores);
	free(index);
}

/* Sites that `validate all` cannot compare though they are calibrated. */
struct failed {
	size_t n;
	char *keys;
	struct error first;
};

/* The answer is of the others, and stays. */
static void
fail_late(struct session *s, struct failed *failed, size_t n)
{
	if (failed->n > 0) {
		struct error e = failed->first;
		error_set(&e, failed->first.kind,
		    "%zu of %zu calibrated sites could not be compared (%s): "
		    "%s\n%s",
		    failed->n, n + failed->n, failed->keys, failed->first.text,
		    failed->first.hint);
		invocation_fails(s, &e);
	}
	free(failed->keys);
}

/* Sites that are compared side by side. */
struct beside {
	const struct session *s;
	size_t entry;
	struct comparison *found; /* NULL: not compared, as somebody waits */
};

static void
compare_beside(void *data, size_t piece, unsigned thread)
{
	struct beside *b = &((struct beside *)data)[piece];
	const struct session *s = b->s;
	(void)thread;
	if (s->hooks.stop != NULL && s->hooks.stop())
		return;
	struct posterior *p = outlook_beside(s, &s->entry[b->entry]);
	b->found = xcalloc(1, sizeof *b->found);
	b->found->all = true;
	compare_entry(s, b->entry, p, b->found);
	posterior_free(p);
}

/* Compares sites [n], some at a time.  False where somebody stopped it. */
static bool
compare_sites(
    struct session *s, struct comparison *c, const size_t *index, size_t n)
{
	enum { EACH_THREAD = 2 };
	size_t most = EACH_THREAD * s->set.threads;
	struct beside *beside = xcalloc(most, sizeof *beside);
	struct pool *pool = pool_new(s->set.threads);
	bool all = true;
	for (size_t from = 0; all && from < n; from += most) {
		size_t m = n - from < most ? n - from : most;
		for (size_t i = 0; i < m; i++)
			beside[i] = (struct beside){s, index[from + i], NULL};
		pool_run(pool, m, compare_beside, beside);
		for (size_t i = 0; i < m; i++) {
			all = all && beside[i].found != NULL;
			if (beside[i].found == NULL)
				continue;
			tell_compared(s, beside[i].found);
			comparison_take(c, beside[i].found);
		}
	}
	pool_free(pool);
	free(beside);
	return all;
}

/* The calibrated sites of the part, index [n_entry]. */
static size_t
find_calibrated(const struct session *s, struct comparison *c, size_t *index,
    struct failed *failed)
{
	size_t n = 0;
	for (size_t i = 0; i < s->n_entry; i++) {
		struct error error = {0};
		if (!part_has(&c->part, i))
			continue;
		if (!s->entry[i].has_fit) {
			c->left_out++;
		} else if (answers_known(s, &s->entry[i], &error)) {
			index[n++] = i;
		} else {
			if (failed->n++ == 0)
				failed->first = error;
			xlist(&failed->keys, ", ", "%s", s->entry[i].key);
		}
	}
	return n;
}

/* What the fits are of that parts made elsewhere must have too: seeds and
 * options, each once. */
static char *
fits_words(const struct session *s, const size_t *index, size_t n)
{
	char *words = xstrdup("fits");
	for (size_t i = 0; i < n; i++) {
		const struct entry *entry = &s->entry[index[i]];
		char *own = xasprintf(" [seed=%llu model=%s %s]",
		    (unsigned long long)entry->fit.seed,
		    breakage_of(&entry->fit.params)->name, entry->options);
		if (strstr(words, own) == NULL)
			xappend(&words, "%s", own);
		free(own);
	}
	return words;
}

static bool
validate_all(struct session *s, struct comparison *c, struct error *error)
{
	struct failed failed = {.keys = xstrdup("")};
	size_t *index = xcalloc(s->n_entry + 1, sizeof *index);
	size_t n = find_calibrated(s, c, index, &failed);
	char *fits = fits_words(s, index, n);
	struct calibrate_options o = job_options(s);
	bool whole = compare_sites(s, c, index, n);
	free(index);
	c->options = part_options(s, &o, fits);
	free(fits);
	if (!whole)
		session_note(s, "stopped before all sites were compared");
	else if (c->n > 0 || c->part.of > 0)
		give_all(s, c);
	else if (failed.n > 0)
		*error = failed.first;
	else
		error_set(error, ERROR_USAGE,
		    "no loaded site has both a calibration and a held-out run\n"
		    "load sites with three speeds, then run 'calibrate', or "
		    "'calibrate all' for all of them");
	fail_late(s, &failed, n);
	return error->kind == ERROR_NONE;
}

static bool
validate_one(struct session *s, struct comparison *c, struct error *error)
{
	if (!answers_ready(s, error))
		return false;
	const struct entry *entry = session_entry(s);
	compare_entry(
	    s, s->current, outlook_posterior(s, entry, CORRECTION_TRAIN), c);
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
		if (!part_has(&c->part, c->at))
			continue;
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
static void *
follow_speed(const struct session *s, const struct round *round)
{
	const struct comparison *c = s->job.of;
	const struct site *site = s->entry[round->entry].site;
	struct fit fit = calibration_fit(round->calibration);
	bool few = fit.cells <= fit.parameters;
	struct posterior_options o = {.use = round->train,
	    .settings = fit.settings,
	    .bounds = *calibration_bounds(round->calibration),
	    .seed = fit.seed,
	    .threads = c->all ? 1 : s->set.threads,
	    .isa = s->isa,
	    .noise = s->set.noise / 100,
	    .stop = round->stop};
	struct posterior *posterior =
	    few ? NULL : posterior_new(site, &fit.params, &o);
	if (posterior == NULL && !few)
		return NULL;
	struct comparison *found = xcalloc(1, sizeof *found);
	found->all = c->all;
	found->level = c->level;
	compare_runs(
	    found, &(struct predicted_by){round->entry, site, round->train,
		       fit.params, fit.settings, posterior, fit.rmse});
	posterior_free(posterior);
	return found;
}

static void
take_speed(struct session *s)
{
	struct comparison *c = s->job.of, *found = s->job.found;
	if (c->all)
		tell_compared(s, found);
	comparison_take(c, found);
}

static char *
at_speed(const struct session *s)
{
	const struct comparison *c = s->job.of;
	return xasprintf(tr("validate: %s without %g m/s"),
	    s->entry[s->job.entry].key, c->speed);
}

static void
end_speeds(struct session *s, void *of)
{
	struct comparison *c = of;
	if (c->all)
		give_all(s, c);
	else
		session_answer(s, run_answer(s, c));
	comparison_drop(c);
}

static const struct rounds EACH = {next_speed, NULL, take_speed, end_speeds,
    comparison_drop, false, at_speed,
    N_("stopped before all speeds were predicted"), follow_speed};

/* Whether the part has a site of enough speeds; without, it is a part, too. */
static bool
has_speeds(const struct session *s, struct comparison *c)
{
	size_t n = 0, of = 0;
	for (size_t i = 0; i < s->n_entry; i++)
		if (part_has(&c->part, i)) {
			of++;
			n += job_speeds(s->entry[i].site) >= JOB_FOR_EACH;
		}
	if (n == 0)
		c->left_out = of;
	return n > 0;
}

/* Calibrates without each speed in turn; c is the job's. */
static bool
validate_each(struct session *s, struct comparison *c, struct error *error)
{
	c->at = c->all ? 0 : s->current;
	c->end = c->all ? s->n_entry : s->current + 1;
	session_let_go(s);
	const struct job job = {.rounds = &EACH,
	    .of = c,
	    .apart = c->all,
	    .options = job_options(s)};
	c->options = part_options(s, &job.options, "each");
	if (c->part.of > 0 && !has_speeds(s, c)) {
		end_speeds(s, c);
		return true;
	}
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
	if (!part_choose(args, c.all, &c.part, error) ||
	    (c.each && !fit_settings_agree(
			   &s->set.model, s->set.model.breakage, error)))
		return false;
	struct comparison *own = xcalloc(1, sizeof *own);
	*own = c;
	if (c.each)
		return validate_each(s, own, error);
	bool ok = (c.all ? validate_all : validate_one)(s, own, error);
	comparison_drop(own);
	return ok;
}

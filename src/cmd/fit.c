/* calibrate.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/fit.h"

#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/xalloc.h"
#include "cmd/data.h"
#include "cmd/origin.h"
#include "cmd/table.h"
#include "core/misfit.h"

/* Marks the runs at the speeds given; each must have a product. */
static bool
mark_training(const struct site *site, const struct value *value, bool *train,
    struct error *error)
{
	if (!value->given)
		return misfit_default_train(site, train) > 0 ||
		       error_set(error, ERROR_DATA,
			   "%s has no product to calibrate on\n"
			   "run 'guess' for an estimate from its feed, or "
			   "'recall' to use a material's parameters",
			   site->name);
	for (size_t i = 0; i < value->n; i++) {
		size_t r = site_run_at(site, value->list[i]);
		if (r == site->n_run || site->run[r].product.n == 0)
			return error_set(error, ERROR_USAGE,
			    "%s has no product at %g m/s\n"
			    "run 'show' for its speeds",
			    site->name, value->list[i]);
		train[r] = true;
	}
	return true;
}

/* Every training run must have something to compare. */
static bool
check_training(const struct site *site, const bool *train, struct error *error)
{
	for (size_t r = 0; r < site->n_run; r++) {
		const struct run *run = &site->run[r];
		if (!train[r] || misfit_covered(run) > 0)
			continue;
		return error_set(error, ERROR_DATA,
		    "%s: no product sieve at %g m/s is in the range of the "
		    "feed's sieves\n"
		    "sieve the feed to finer sizes, or choose other training "
		    "runs: calibrate train=...",
		    site->name, run->speed);
	}
	return true;
}

/* Weights by standard deviation need one for every training run; a run without
 * would count next to nothing beside the others. */
static bool
check_weights(const struct site *site, const bool *train, struct error *error)
{
	for (size_t r = 0; r < site->n_run; r++) {
		if (!train[r] || site->run[r].product_sd != NULL)
			continue;
		return error_set(error, ERROR_DATA,
		    "expected standard deviations for every training run with "
		    "weights=sd; %s has none at %g m/s\n"
		    "add a column sd@%g, or calibrate without weights",
		    site->name, site->run[r].speed, site->run[r].speed);
	}
	return true;
}

bool
fit_settings_agree(
    const struct model_settings *settings, size_t breakage, struct error *error)
{
	const struct breakage *of = BREAKAGES[breakage];
	if (settings->appearance != APPEARANCE_RATIO && !of->forms)
		return error_set(error, ERROR_USAGE,
		    "this appearance works with the model %s only\n"
		    "run 'set appearance ratio'",
		    BREAKAGES[0]->name);
	if (settings->method == METHOD_CLASSES ||
	    settings->appearance == APPEARANCE_RATIO)
		return true;
	return error_set(error, ERROR_USAGE,
	    "this appearance works with the method classes only\n"
	    "run 'set method classes' or 'set appearance ratio'");
}

void
fit_announce(struct session *s)
{
	const struct entry *entry = &s->entry[s->job.entry];
	const struct calibrate_options *o = &s->job.options;
	char *train = data_speeds(entry->site, ", ", s->job.train, true);
	char *holdout = data_speeds(entry->site, ", ", s->job.train, false);
	session_note(s, "calibrating %s on %s m/s%s%s%s", entry->site->name,
	    train, holdout[0] != '\0' ? " (held out: " : "", holdout,
	    holdout[0] != '\0' ? ")" : "");
	session_note(s,
	    "  population %zu, generations %zu, tolerance %g, stall %zu, "
	    "polish %s, seed %llu, threads %u",
	    o->population, o->generations, o->tolerance, o->stall,
	    o->polish ? "on" : "off", (unsigned long long)o->seed, o->threads);
	free(train);
	free(holdout);
}

/* The weights in the order of the training runs, as one for each run. */
static bool
spread_weights(const struct site *site, const bool *train,
    const struct value *value, double **run_weight, struct error *error)
{
	size_t n = 0;
	if (!value->given)
		return true;
	double *weight = xdoubles(site->n_run);
	for (size_t r = 0; r < site->n_run; r++)
		if (train[r] && n++ < value->n)
			weight[r] = value->list[n - 1];
	if (n == value->n) {
		*run_weight = weight;
		return true;
	}
	free(weight);
	return error_set(error, ERROR_USAGE,
	    "run_weights: expected %zu numbers, one for each training run, got "
	    "%zu",
	    n, value->n);
}

static struct calibrate_options
chosen_options(const struct session *s, const struct args *args)
{
	struct calibrate_options o = calibrate_options_default();
	const struct value *seed = args_value(args, "seed");
	const struct value *threads = args_value(args, "threads");
	const struct value *polish = args_value(args, "polish");
	o.plain = args_value(args, "preset")->choice == 1;
	o.seed = seed->given ? seed->whole : s->set.seed;
	o.threads = threads->given ? (unsigned)threads->whole : s->set.threads;
	o.isa = s->isa;
	o.stop = s->stop;
	o.population = (size_t)args_value(args, "population")->whole;
	o.generations = (size_t)args_value(args, "generations")->whole;
	o.stall = (size_t)args_value(args, "stall")->whole;
	o.tolerance = args_value(args, "tolerance")->number;
	o.polish = polish->choice == 0 && (polish->given || !o.plain);
	o.by_sd = args_value(args, "weights")->choice == 1;
	o.bounds = s->set.bounds;
	o.settings = s->set.model;
	return o;
}

static bool
check_all(const struct args *args, struct error *error)
{
	if (!args_value(args, "train")->given &&
	    !args_value(args, "run_weights")->given &&
	    !args_value(args, "weights")->choice)
		return true;
	return error_set(error, ERROR_USAGE,
	    "calibrate all: expected no train=, weights= or run_weights=; each "
	    "site uses its own speeds");
}

/* The runs to train on, and what each counts. */
static bool
choose_runs(const struct site *site, const struct args *args, struct job *job,
    struct error *error)
{
	bool by_sd = args_value(args, "weights")->choice == 1;
	job->train = xcalloc(site->n_run, sizeof *job->train);
	return mark_training(
		   site, args_value(args, "train"), job->train, error) &&
	       check_training(site, job->train, error) &&
	       (!by_sd || check_weights(site, job->train, error)) &&
	       spread_weights(site, job->train, args_value(args, "run_weights"),
		   &job->run_weight, error);
}

bool
cmd_calibrate(struct session *s, const struct args *args, struct error *error)
{
	const struct site *site = session_entry(s)->site;
	struct job job = {.options = chosen_options(s, args),
	    .all = args->n_operand > 0,
	    .pause_at = (size_t)args_value(args, "pause")->whole};
	if (job.all && strcmp(args->operand[0], "all") != 0)
		return error_set(error, ERROR_USAGE,
		    "calibrate: expected options or all, got '%s'",
		    args->operand[0]);
	if (!fit_settings_agree(&s->set.model, s->set.model.breakage, error) ||
	    !(job.all ? check_all(args, error)
		      : choose_runs(site, args, &job, error))) {
		job_free(&job);
		return false;
	}
	job_start(s, &job);
	return session_busy(s) ||
	       error_set(error, ERROR_DATA,
		   "no loaded site has a product to calibrate on");
}

/* Keeps the job's generations and its misfit in its site. */
static void
take_history(struct entry *entry, const struct job *job)
{
	size_t n, size = sizeof(struct calibrate_generation);
	const struct calibrate_generation *g =
	    calibration_history(job->calibration, &n);
	struct history *h = xcalloc(1, sizeof *h);
	*h = (struct history){.holders = 1,
	    .fit = entry->fit,
	    .n = n,
	    .generation = xcalloc(n + 1, size),
	    .bounds = *calibration_bounds(job->calibration),
	    .misfit = calibrate_misfit(entry->site, &job->options)};
	if (n > 0)
		memcpy(h->generation, g, n * size);
	history_drop(entry->history);
	entry->history = h;
}

/* The options of the job as one would type them, for whoever asks later how the
 * fit was found; bounds only where they are not the default ones. */
static char *
options_words(const struct session *s, const struct fit *fit)
{
	const struct job *job = &s->job;
	const struct calibrate_options *o = &job->options;
	const size_t model = o->settings.breakage;
	const struct bounds usual = bounds_default(model);
	const char *sign = " run_weights=";
	char *words = xasprintf("population=%zu generations=%zu tolerance=%g "
				"stall=%zu polish=%s%s%s",
	    o->population, o->generations, o->tolerance, o->stall,
	    o->polish ? "on" : "off", o->plain ? " preset=paper" : "",
	    o->by_sd ? " weights=sd" : "");
	for (size_t r = 0; r < s->entry[job->entry].site->n_run; r++) {
		if (job->run_weight == NULL || !job->train[r])
			continue;
		xappend(&words, "%s%g", sign, job->run_weight[r]);
		sign = ",";
	}
	if (fit->edits > 0)
		xappend(&words, "; bounds edited after generation %zu%s",
		    fit->edited_at, fit->edits > 1 ? " and before" : "");
	for (size_t j = 0; j < BREAKAGES[model]->n; j++)
		if (o->bounds.lower[j] != usual.lower[j] ||
		    o->bounds.upper[j] != usual.upper[j])
			xappend(&words, "; bounds %s %g..%g",
			    BREAKAGES[model]->parameter[j].name,
			    o->bounds.lower[j], o->bounds.upper[j]);
	return words;
}

void
fit_take(struct session *s)
{
	struct entry *entry = &s->entry[s->job.entry];
	entry->fit = calibration_fit(s->job.calibration);
	char *options = options_words(s, &entry->fit);
	snprintf(entry->options, sizeof entry->options, "%s", options);
	free(options);
	entry->params = entry->fit.params;
	take_history(entry, &s->job);
	session_forget(s);
	entry->has_fit = entry->has_params = true;
	memcpy(entry->train, s->job.train,
	    entry->site->n_run * sizeof *entry->train);
	origin_drop(entry->origin);
	entry->origin = origin_of_fit(entry);
	/* That of `all` is a table of sites, and tells of none alone. */
	struct answer *answer = answer_new("calibrate");
	fit_put(answer_fields(answer), entry, session_clock() - s->job.started);
	session_keep(s, answer);
}

void
fit_show(struct session *s)
{
	double seconds = session_clock() - s->job.started;
	session_note(s, "  done in %.2f s", seconds);
	session_answer(s, fit_answer(&s->entry[s->job.entry],
			      calibration_bounds(s->job.calibration), seconds));
}

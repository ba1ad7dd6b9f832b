/* Compares each held-out run with all predictions of it
 * (validate_predict_by_all_ways).
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/fit/trials.h"

#include <stdlib.h>

#include "base/xalloc.h"
#include "cmd/ask/answers.h"
#include "core/posterior/ensemble.h"
#include "core/search/misfit.h"
#include "core/check/trust.h"

void
trials_clear(struct trials *c)
{
	for (size_t i = 0; i < c->n; i++) {
		free(c->item[i].key);
		free(c->item[i].source);
		free(c->item[i].name);
		free(c->item[i].passing);
	}
	free(c->item);
	*c = (struct trials){.n = 0};
}

void
trials_add_trial(struct trials *c, struct trial trial)
{
	c->item = xgrow_by_one(c->item, c->n, sizeof *c->item);
	c->item[c->n++] = trial;
}

void
trials_append_all(struct trials *c, struct trials *from)
{
	c->left_out += from->left_out;
	for (size_t i = 0; i < from->n; i++)
		trials_add_trial(c, from->item[i]);
	from->n = 0;
	trials_clear(from);
}

char *
trials_data_sources_text(const struct trials *c, size_t *sites)
{
	struct sources all = {0};
	*sites = 0;
	for (size_t k = 0; k < c->n; k++) {
		if (k > 0 && c->item[k].entry == c->item[k - 1].entry)
			continue;
		++*sites;
		sources_add(&all, c->item[k].key, c->item[k].source);
	}
	return sources_text_and_clear(&all);
}

const double *
trials_predicted_passing(const struct trial *trial, enum validate_way way)
{
	return trial->passing + way * trial->v.n_sieve;
}

struct validate_score
trials_score_at_size(const struct trials *c, enum validate_way way, size_t i)
{
	FREED const struct validation **v = xcalloc(c->n + 1, sizeof(*v));
	for (size_t k = 0; k < c->n; k++)
		v[k] = &c->item[k].v;
	return validate_score_at_size(v, c->n, way, i);
}

/* Returns the corrected answer at the run's covered sieves, and sets *within to
 * the number of its passings in the band for one more sample.  Without draws,
 * returns NULL and sets 0.  The caller frees the passings. */
static double *
corrected_passings_of_run(const struct run *run,
    const struct posterior *posterior, double level, size_t *within)
{
	size_t n = misfit_count_covered_sieves(run);
	*within = 0;
	if (posterior == NULL)
		return NULL;
	double *passing = xcalloc_doubles(n);
	struct ensemble *e =
	    ensemble_new(posterior, &run->feed, run->product.size, n);
	ensemble_set_speed(e, run->speed);
	ensemble_mean_answer(e, passing);
	for (size_t i = 0; i < n; i++) {
		double P = run->product.passing[i], low, high;
		ensemble_interval_at_sieve(
		    e, ENSEMBLE_SAMPLE, i, level, &low, &high);
		/* Site files are rounded to 0.01 %. */
		*within += P >= low - 1e-4 && P <= high + 1e-4;
	}
	ensemble_free(e);
	return passing;
}

static void
add_trial_of_held_out_run(struct trials *c, const struct entry *entry,
    const struct predicted_by *by, size_t r)
{
	const struct site *site = entry->site;
	const struct run *run = &site->run[r];
	struct trial trial = {.entry = by->entry,
	    .key = xstrdup(entry->key),
	    .source =
		site_provenance_first_clause(site, "provenance not stated"),
	    .name = xasprintf("%g%s", run->speed, run->repeat),
	    .rotor = site->rotor,
	    .in_rpm = answers_is_sheet_in_rpm(site),
	    .run = run,
	    .open = trust_is_band_impossible(
		by->rmse, site_count_speeds(site, by->train))};
	size_t within;
	FREED double *corrected =
	    corrected_passings_of_run(run, by->posterior, c->level, &within);
	trial.passing = validate_predict_by_all_ways(
	    site, r, by->train, &by->params, by->settings, corrected);
	trial.v =
	    validate_run_from_predictions(site, r, by->train, trial.passing);
	trial.has_band = c->one && by->posterior != NULL && !trial.open;
	trial.within = trial.has_band ? within - trial.v.n_idle : 0;
	trials_add_trial(c, trial);
}

void
trials_add_held_out_runs(
    struct trials *c, const struct session *s, const struct predicted_by *by)
{
	const struct entry *entry = &s->entry[by->entry];
	for (size_t r = 0; r < entry->site->n_run; r++)
		if (!by->train[r] &&
		    misfit_count_covered_sieves(&entry->site->run[r]) > 0)
			add_trial_of_held_out_run(c, entry, by, r);
}

void
trials_add_held_out_runs_of_site(struct trials *c, const struct session *s,
    size_t index, const struct posterior *posterior)
{
	const struct entry *entry = &s->entry[index];
	const struct fit *fit = origin_fit_behind_params(entry);
	trials_add_held_out_runs(c, s,
	    &(struct predicted_by){index, entry->train, entry->params,
		s->set.model, posterior, fit != NULL ? fit->rmse : 0});
}

/* Takes generations, bounds and the best candidate from the running
 * calibration, or from the history of the last.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/draw/search_shown.h"

#include <math.h>
#include <string.h>

#include "cmd/ask/answers.h"

bool
search_shown_is_running(const struct session *s, const struct entry *entry)
{
	return s->job.calibration != NULL && s->job.fits &&
	       &s->entry[s->job.entry] == entry_without_variant(entry);
}

static void
fill_from_running_search(struct search_shown *past, const struct session *s,
    const struct entry *entry)
{
	const struct job *job = &s->job;
	struct calibrate_status st = calibration_status(job->calibration);
	past->generation = calibration_history(job->calibration, &past->n);
	past->bounds = calibration_bounds(job->calibration);
	past->site = entry->site;
	past->train = job->train;
	past->settings = job->options.settings;
	past->weight = calibration_sum_of_weights(job->calibration);
	past->misfit = st.best;
	past->best = st.params;
	past->polished = st.state != CALIBRATE_SEARCHING;
	past->runs = true;
}

struct search_shown
search_shown_of_site(const struct session *s, const struct entry *entry)
{
	struct search_shown past = {0};
	const struct history *h = entry->history;
	if (search_shown_is_running(s, entry)) {
		fill_from_running_search(&past, s, entry);
	} else if (h != NULL) {
		past = (struct search_shown){h->n, h->generation, &h->bounds,
		    h->site, h->train, h->fit.settings, h->weight,
		    h->fit.misfit, h->fit.params, true, false};
	}
	if (past.n == 0 || !past.polished)
		return past;
	struct params last = past.generation[past.n - 1].params;
	params_scale_to_1(&last);
	past.polished = memcmp(&last, &past.best, sizeof last) != 0;
	return past;
}

size_t
search_shown_generation_index(const struct entry *entry,
    const struct search_shown *past, size_t generation, struct error *error)
{
	if (past->n == 0)
		error_set(error, ERROR_USAGE,
		    "%s has not been calibrated in this session\n"
		    "run 'calibrate' first",
		    entry->site->name);
	else if (generation <= past->n)
		return generation > 0 ? generation - 1 : past->n - 1;
	else
		error_set(error, ERROR_USAGE,
		    "there is no generation %zu, only %zu", generation,
		    past->n);
	return past->n;
}

struct params
search_shown_best_params(const struct search_shown *past, size_t generation)
{
	return generation > 0 ? past->generation[generation - 1].params
			      : past->best;
}

double
search_shown_rmse_points(const struct search_shown *past, double misfit)
{
	bool good = isfinite(misfit) && misfit > 0 && past->weight > 0;
	return good ? 100 * sqrt(misfit / past->weight) : NAN;
}

bool
search_shown_params(const struct session *s, const struct plot_request *request,
    struct params *params, struct error *error)
{
	const struct entry *entry = request->entry;
	struct search_shown past = search_shown_of_site(s, entry);
	bool search =
	    request->generation > 0 || search_shown_is_running(s, entry);
	if (search && past.n > 0) {
		if (search_shown_generation_index(
			entry, &past, request->generation, error) == past.n)
			return false;
		*params = search_shown_best_params(&past, request->generation);
		return true;
	}
	if (!answers_require_params(s, entry, error))
		return false;
	*params = entry->params;
	return true;
}

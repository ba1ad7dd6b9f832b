/* What is known of the search of a site.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_DRAW_PLOTS_PAST_H
#define TIPSPEED_CMD_DRAW_PLOTS_PAST_H

#include "cmd/draw/plot_request.h"

/* Of the calibration under way, else of the site's last one.  n is 0 where
 * there is none.  site, train: what was fitted; weight: see
 * calibration_weight; runs: it is under way; best, misfit: what was found so
 * far; polished: that is no longer the best of the last generation, but what
 * the polish made of it.
 * Borrowed. */
struct plots_past {
	size_t n;
	const struct calibrate_generation *generation;
	const struct bounds *bounds;
	const struct site *site;
	const bool *train;
	struct model_settings settings;
	double weight, misfit;
	struct params best;
	bool polished, runs;
};
struct plots_past plots_past(
    const struct session *s, const struct entry *entry);

/* Whether the calibration under way is that of the site. */
bool plots_past_runs(const struct session *s, const struct entry *entry);

/* Index of the generation asked for, 1..n; 0: of the last.  n with an error
 * where there is none. */
size_t plots_past_at(const struct entry *entry, const struct plots_past *past,
    size_t generation, struct error *error);

/* The best candidate of a generation, 1..n; of 0 what was found in the end. */
struct params plots_past_best(const struct plots_past *past, size_t generation);

/* A misfit as the root mean square difference, points; NAN of none. */
double plots_past_points(const struct plots_past *past, double misfit);

/* The parameters to draw the request's entry with: of the generation asked for,
 * the best so far of a calibration under way, or the site's. */
bool plots_past_params(const struct session *s,
    const struct plot_request *request, struct params *params,
    struct error *error);

#endif

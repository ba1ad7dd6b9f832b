/* The search of a site, as far as it is known.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_DRAW_PLOTS_PAST_H
#define TIPSPEED_CMD_DRAW_PLOTS_PAST_H

#include "cmd/draw/plot_request.h"

/* The calibration under way, or else the site's last one; n is 0 if there is
 * neither.  site, train: what was fitted; weight: see calibration_weight; runs:
 * whether it is under way; best, misfit: the best found so far; polished:
 * whether the polish has improved the best since the last generation.
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

/* True if the calibration under way is that of the site. */
bool plots_past_is_running(const struct session *s, const struct entry *entry);

/* Returns the index of the generation asked for, 1..n; 0: the last.  n with an
 * error where there is none. */
size_t plots_past_at(const struct entry *entry, const struct plots_past *past,
    size_t generation, struct error *error);

/* Returns the best candidate of a generation, 1..n; 0: what was found in the
 * end. */
struct params plots_past_best(const struct plots_past *past, size_t generation);

/* Returns a misfit as the root mean square difference, points; NAN if it is not
 * finite and positive. */
double plots_past_points(const struct plots_past *past, double misfit);

/* Finds the parameters to draw the request's entry with: of the generation
 * asked for, the best so far of a calibration under way, or the site's.  False
 * with an error where there are none. */
bool plots_past_params(const struct session *s,
    const struct plot_request *request, struct params *params,
    struct error *error);

#endif

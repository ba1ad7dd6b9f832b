/* The search for a site's parameters, as far as it has run, and plots of it:
 * the residuals of its candidates, their convergence, and their positions
 * within the bounds.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_DRAW_PLOTS_SEARCH_H
#define TIPSPEED_CMD_DRAW_PLOTS_SEARCH_H

#include "cmd/draw/plot_request.h"

/* The calibration in progress, or else the site's last; n is 0 if there is
 * neither.  site, train: the data fitted; weight: see
 * calibration_sum_of_weights; runs: it is in progress; best, misfit: the best
 * so far; polished: the polish has improved the best since the last generation.
 * Borrowed. */
struct search_shown {
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
struct search_shown search_shown_of_site(
    const struct session *s, const struct entry *entry);

/* True if the calibration in progress is for the site. */
bool search_shown_is_running(
    const struct session *s, const struct entry *entry);

/* Returns a misfit as RMSE, points, or NAN if it is not finite and positive. */
double misfit_as_rmse_points(const struct search_shown *past, double misfit);

/* Finds the parameters for drawing the request's entry: those of the requested
 * generation, the best so far of a calibration in progress, or the site's.
 * Returns false with an error if there are none. */
bool find_params_to_plot(const struct session *s,
    const struct plot_request *request, struct params *params,
    struct error *error);

plot_make plots_search_residuals, plots_search_convergence, plots_search_spread;

/* Parameter j, as reported, between its bounds; those in the gauge are between
 * -1 and 1, whatever their bounds (D4).  p10, p90: of the candidates; drawn:
 * the middle 80 % of the draws, NAN without draws.  near: within 5 % of a
 * bound; at_bound: on a bound. */
struct param_span {
	double lower, upper, p10, p90, best, drawn[2];
	bool fixed, near, at_bound;
};
struct param_span param_span_of_generation(struct session *s,
    const struct search_shown *past, size_t generation, size_t j);

/* Returns a sentence on what happens at that generation, which must exist.  The
 * caller frees it. */
char *search_progress_text(
    struct session *s, const struct search_shown *past, size_t generation);

#endif

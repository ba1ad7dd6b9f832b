/* The search for a site's parameters, running or finished, and plots of it: the
 * residuals of its candidates, their convergence, and their positions within
 * the bounds.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_DRAW_PLOTS_SEARCH_H
#define TIPSPEED_CMD_DRAW_PLOTS_SEARCH_H

#include "cmd/draw/plot_request.h"

/* The site's calibration in progress or else its last one; n is 0 if there is
 * neither.  generation [n]: its generations.  site, train: the data fitted;
 * weight: see calibration_sum_squared_weights; best, misfit: the best so far;
 * polished: the polish has improved the best since the last generation; runs:
 * it is in progress.  All pointers are borrowed. */
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
struct search_shown search_of_site_to_show(
    const struct session *s, const struct entry *entry);

/* True if a calibration of the site is in progress. */
bool is_calibration_of_site_running(
    const struct session *s, const struct entry *entry);

/* Returns a misfit as RMSE, points, or NAN if it is not finite. */
double misfit_as_rmse_points(const struct search_shown *past, double misfit);

/* Sets the parameters to draw: those of the requested generation, else the best
 * so far of a calibration in progress, else the site's.  Returns false with an
 * error if there are none. */
bool find_param_values_for_plot(const struct session *s,
    const struct plot_request *request, struct params *params,
    struct error *error);

plot_make plots_candidate_residuals, plots_search_convergence,
    plots_search_param_spread;

/* Parameter j, as reported, and its bounds; in the gauge these are -1 and 1,
 * whatever was set (D4).  p10, p90: of the candidates; best: of the best
 * candidate; drawn: the middle 80 % of the draws, NAN without draws; near:
 * within 5 % of a bound; at_bound: on a bound. */
struct param_span {
	double lower, upper, p10, p90, best, drawn[2];
	bool fixed, near, at_bound;
};
struct param_span param_span_of_generation(struct session *s,
    const struct search_shown *past, size_t generation, size_t j);

/* Returns a sentence on the state of the search at a generation, which must
 * exist (0: now).  The caller frees it. */
char *fit_search_progress_text(
    struct session *s, const struct search_shown *past, size_t generation);

#endif

/* Plots of a search: the residuals of its candidates, their convergence, and
 * their positions within the bounds.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_DRAW_PLOTS_SEARCH_H
#define TIPSPEED_CMD_DRAW_PLOTS_SEARCH_H

#include "cmd/draw/plot_request.h"
#include "cmd/draw/search_shown.h"

plot_make plots_search_residuals, plots_search_convergence, plots_search_spread;

/* Parameter j, as reported, between its bounds; those in the gauge are between
 * -1 and 1, whatever their bounds (D4).  p10, p90: of the candidates; drawn:
 * the middle 80 % of the draws, NAN without draws.  near: within 5 % of a
 * bound; at_bound: on a bound. */
struct param_span {
	double lower, upper, p10, p90, best, drawn[2];
	bool fixed, near, at_bound;
};
struct param_span plots_search_param_span(struct session *s,
    const struct search_shown *past, size_t generation, size_t j);

/* Returns a sentence on what happens at that generation, which must exist.  The
 * caller frees it. */
char *plots_search_progress_text(
    struct session *s, const struct search_shown *past, size_t generation);

#endif

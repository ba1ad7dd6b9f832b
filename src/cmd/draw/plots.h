/* Plots of a session: the curves of each kind.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_DRAW_PLOTS_H
#define TIPSPEED_CMD_DRAW_PLOTS_H

#include "cmd/draw/plot_request.h"

/* Returns a request of that kind with nothing else asked for: NANs, ASCII, with
 * a legend. */
struct plot_request plots_request(enum plot_kind kind);

/* Kinds with a file of their own, plots_KIND.c; plots_draws.c has profile and
 * correlation. */
plot_make plots_draws_profile, plots_draws_correlation, plots_drift,
    plots_energy, plots_map, plots_response, plots_runs;

/* Makes the chart; NULL with an error that says what is missing (no site, no
 * parameters, no history).  The caller frees with chart_free. */
struct chart *plots_chart(
    struct session *s, const struct plot_request *request, struct error *error);

/* As plots_chart, but drawn in exactly columns x rows.  The caller frees with
 * canvas_free. */
struct canvas *plots_draw(struct session *s, const struct plot_request *request,
    int columns, int rows, struct error *error);

/* Finds what lies at a cell of that picture: the values of its axes, and in
 * words the mark or line drawn there, "measured 74: 5.6 mm, 82.1 %", which the
 * caller frees, or NULL.  False outside the data, or if there is no picture. */
struct plots_found {
	double x, y;
	char *words;
};
bool plots_find_at(struct session *s, const struct plot_request *request,
    int columns, int rows, int column, int row, struct plots_found *found);

#endif

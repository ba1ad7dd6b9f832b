/* Makes the charts of all kinds of plots.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_DRAW_PLOTS_H
#define TIPSPEED_CMD_DRAW_PLOTS_H

#include "cmd/draw/plot_request.h"

/* Returns a request with defaults: NAN where nothing is asked, ASCII, all
 * texts. */
struct plot_request plots_default_request(enum plot_kind kind);

/* Kinds with a file of their own, plots_KIND.c.  plots_draws.c has profile and
 * correlation; plots_psd.c also has sweep. */
plot_make plots_parameter_profile, plots_parameter_correlations,
    plots_control_charts, plots_impact_energies, plots_material_map, plots_psd,
    plots_response, plots_runs, plots_sweep;

/* Makes the chart, which the caller frees with chart_free.  Returns NULL with
 * an error that says what is missing (site, parameters, history). */
struct chart *plots_make_chart(
    struct session *s, const struct plot_request *request, struct error *error);

/* As plots_make_chart, but drawn on exactly columns x rows cells.  The caller
 * frees the canvas with canvas_free. */
struct canvas *plots_draw_canvas(struct session *s,
    const struct plot_request *request, int columns, int rows,
    struct error *error);

/* Finds what plots_draw_canvas draws at a cell: the values on the axes, and the
 * mark or line there in words, "measured 74: 5.6 mm, 82.1 %", or NULL.  The
 * caller frees the words.  Returns false outside the area of the data or if the
 * chart cannot be made. */
struct plots_found {
	double x, y;
	char *words;
};
bool plots_find_mark_at_cell(struct session *s,
    const struct plot_request *request, int columns, int rows, int column,
    int row, struct plots_found *found);

#endif

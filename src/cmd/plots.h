/* Pictures of a session: from its site, parameters and history to a canvas.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_PLOTS_H
#define TIPSPEED_CMD_PLOTS_H

#include <stdbool.h>

#include "cmd/session.h"
#include "plot/canvas.h"

enum plot_kind {
	PLOT_PSD,
	PLOT_PARITY,
	PLOT_CONVERGENCE,
	PLOT_SPREAD,
	PLOT_RESIDUALS,
	PLOT_SELECTION,
	PLOT_APPEARANCE,
	PLOT_MAP,
	PLOT_SWEEP
};

struct plot_request {
	enum plot_kind kind;
	double speed;
	double other_speed;
	double crosshair_mm;
	bool band;
	size_t generation;
	enum charset charset;
	bool legend;
};

/* NULL with an error that says what is missing.  Exactly columns x rows; the
 * caller frees with canvas_free. */
struct canvas *plots_draw(struct session *s, const struct plot_request *request,
    int columns, int rows, struct error *error);

#endif

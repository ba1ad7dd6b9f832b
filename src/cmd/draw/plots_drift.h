/* The plot of routine cuts.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_DRAW_PLOTS_DRIFT_H
#define TIPSPEED_CMD_DRAW_PLOTS_DRIFT_H

#include "cmd/draw/plot_request.h"

/* The control charts of the site in use, as `drift` has them. */
plot_make plots_drift;

#endif

/* Plots of what was drawn: correlation and profile.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_DRAW_PLOTS_DRAWS_H
#define TIPSPEED_CMD_DRAW_PLOTS_DRAWS_H

#include "cmd/draw/plot_request.h"

/* For sites with a calibration; correlation wants its draws too. */
plot_make plots_draws_profile, plots_draws_correlation;

#endif

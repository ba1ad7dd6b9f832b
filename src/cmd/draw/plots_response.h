/* Plot response: quantities of the product against the tip speed.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_DRAW_PLOTS_RESPONSE_H
#define TIPSPEED_CMD_DRAW_PLOTS_RESPONSE_H

#include "cmd/draw/plot_request.h"

/* With bands, what was measured, the training speeds, limits and where all of
 * them hold; a chart for each unit, one below the other. */
plot_make plots_response;

#endif

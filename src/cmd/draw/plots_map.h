/* Materials by their parameters.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_DRAW_PLOTS_MAP_H
#define TIPSPEED_CMD_DRAW_PLOTS_MAP_H

#include "cmd/draw/plot_request.h"

/* The paper's figure 10: f_mat and e0_min of the materials of the store and of
 * Table 3, by rock, and of all loaded sites that have parameters; of these a
 * fit that has one at its bound is marked. */
plot_make plots_map;

#endif

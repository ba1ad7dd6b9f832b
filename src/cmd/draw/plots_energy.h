/* The plot of collision energies.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_DRAW_PLOTS_ENERGY_H
#define TIPSPEED_CMD_DRAW_PLOTS_ENERGY_H

#include "cmd/draw/plot_request.h"

/* How often particles are hit at which energy: those in use, the first impact
 * of each apart, and all others that were loaded. */
plot_make plots_energy;

#endif

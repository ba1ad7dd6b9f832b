/* Tonnes of a circuit's products against the speed, as a picture.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_DRAW_FLOW_CHART_H
#define TIPSPEED_CMD_DRAW_FLOW_CHART_H

#include "cmd/plant/plant.h"
#include "plot/chart.h"

/* A line with its band for each product, t/h, at speeds from..to, m/s; a gap
 * where the circuit has no steady state.  chart_free. */
struct chart *flow_chart(const struct plant *p, double from, double to);

#endif

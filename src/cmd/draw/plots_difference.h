/* Differences of curves as a strip below them, magnified.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_DRAW_PLOTS_DIFFERENCE_H
#define TIPSPEED_CMD_DRAW_PLOTS_DIFFERENCE_H

#include <stdbool.h>
#include <stddef.h>

#include "plot/chart.h"

/* How many rows such a strip has at the prompt: title, plot. */
enum { PLOTS_STRIP = 6 };

/* Puts it below a chart whose last series is the prediction: that less the
 * second prediction, and less it each series of marks for which wanted
 * [chart->n] is set.  Nothing where there is neither. */
void plots_difference(struct chart *chart, int rows, const bool *wanted);

#endif

/* Differences of curves, magnified, as a strip below the chart.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_DRAW_PLOTS_DIFFERENCE_H
#define TIPSPEED_CMD_DRAW_PLOTS_DIFFERENCE_H

#include <stdbool.h>
#include <stddef.h>

#include "plot/chart.h"

/* Rows of such a strip at the prompt, with its title. */
enum { PLOTS_STRIP = 6 };

/* Adds the strip below a chart whose last series is the prediction: the
 * prediction less the second prediction, and less each series of marks with
 * wanted [chart->n] set.  Adds nothing where there is neither. */
void plots_difference(struct chart *chart, int rows, const bool *wanted);

#endif

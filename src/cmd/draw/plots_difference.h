/* Differences between curves, magnified, in a strip below the chart.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_DRAW_PLOTS_DIFFERENCE_H
#define TIPSPEED_CMD_DRAW_PLOTS_DIFFERENCE_H

#include <stdbool.h>
#include <stddef.h>

#include "plot/chart.h"

/* Rows of such a strip at the prompt, with its title. */
enum { PLOTS_STRIP = 6 };

/* Adds the strip below a chart whose last series is the prediction: the
 * prediction minus the second prediction, and minus each series of marks with
 * wanted [chart->n] set.  Adds nothing if there is neither. */
void plots_difference(struct chart *chart, int rows, const bool *wanted);

#endif

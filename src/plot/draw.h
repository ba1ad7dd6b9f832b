/* Charts on a canvas of cells.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_PLOT_DRAW_H
#define TIPSPEED_PLOT_DRAW_H

#include "plot/chart.h"

/* What is written around the axes; the foot goes with the legend. */
enum { CHART_TITLE = 1, CHART_LEGEND = 2, CHART_NOTES = 4, CHART_ALL = 7 };

/* The chart in exactly columns x rows cells, whatever they are.  Where room is
 * short its parts go in this order: title of the y axis, notes and legend,
 * second row of labels, foot, title, labels, axis.  words: which of them to
 * draw at all, of CHART_ALL.  The caller frees. */
struct canvas *chart_draw(const struct chart *chart, int columns, int rows,
    enum charset charset, unsigned words);

#endif

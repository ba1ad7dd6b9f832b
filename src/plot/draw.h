/* Draws charts on a canvas of cells.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_PLOT_DRAW_H
#define TIPSPEED_PLOT_DRAW_H

#include "plot/chart.h"

/* Texts around the axes, as bits; the foot is part of the legend.  CHART_BARE:
 * only the data, in all cells. */
enum {
	CHART_TITLE = 1,
	CHART_LEGEND = 2,
	CHART_NOTES = 4,
	CHART_ALL = 7,
	CHART_BARE = 8
};

/* Draws a chart in exactly columns x rows cells.  If room is short, parts are
 * dropped in this order: title of the y axis, legend and notes, second row of
 * labels, foot, title, labels, axis.  words: the texts to draw, bits of
 * CHART_ALL, or CHART_BARE.  Each label is in the row or column that contains
 * its value, and each dot of a line in the part of the cell that does.  The
 * caller frees the canvas. */
struct canvas *chart_draw(const struct chart *chart, int columns, int rows,
    enum charset charset, unsigned words);

/* What is drawn in a cell: the chart there, the values of its axes, and the
 * series of the nearest mark within a cell or, without one, of the line there;
 * NULL if there is neither.  point: the nearest point of the series. */
struct chart_found {
	const struct chart *chart;
	double x, y;
	const struct chart_series *series;
	size_t point;
};

/* Finds what chart_draw would draw in a cell.  Returns false for a cell outside
 * the data. */
bool chart_find_data_at_cell(const struct chart *chart, int columns, int rows,
    enum charset charset, unsigned words, int column, int row,
    struct chart_found *found);

/* Returns the sample of a series in a legend: its line and mark.  The caller
 * frees it. */
char *chart_legend_sample(
    const struct chart_series *series, enum charset charset);

#endif

/* Draws charts on a canvas of cells.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_PLOT_DRAW_H
#define TIPSPEED_PLOT_DRAW_H

#include "plot/chart.h"

/* Texts around the axes; the foot is part of the legend.  CHART_BARE: only the
 * data, in all cells. */
enum {
	CHART_TITLE = 1,
	CHART_LEGEND = 2,
	CHART_NOTES = 4,
	CHART_ALL = 7,
	CHART_BARE = 8
};

/* Draws a chart in exactly columns x rows cells.  If room is short, parts are
 * dropped in this order: title of the y axis, notes and legend, second row of
 * labels, foot, title, labels, axis.  words: the parts to draw, from CHART_ALL.
 * Each label is in the row or column that contains its value, and each dot of a
 * line in that part of a cell.  The caller frees the canvas. */
struct canvas *chart_draw(const struct chart *chart, int columns, int rows,
    enum charset charset, unsigned words);

/* The content of a cell on that canvas: the chart there, the values on its
 * axes, and the nearest mark within a cell, or else the line drawn there.
 * point: the nearest point of the series.  series NULL: neither. */
struct chart_found {
	const struct chart *chart;
	double x, y;
	const struct chart_series *series;
	size_t point;
};

/* Finds the content of a cell of what chart_draw would draw.  Returns false for
 * a cell outside the data. */
bool chart_find_at_cell(const struct chart *chart, int columns, int rows,
    enum charset charset, unsigned words, int column, int row,
    struct chart_found *found);

/* Returns the sample of a series for a legend: its line and mark.  The caller
 * frees it. */
char *chart_legend_sample(
    const struct chart_series *series, enum charset charset);

#endif

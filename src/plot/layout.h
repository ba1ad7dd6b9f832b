/* Where the parts of a chart are on a canvas.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_PLOT_LAYOUT_H
#define TIPSPEED_PLOT_LAYOUT_H

#include "plot/chart.h"

/* The data's cells begin at left, top and are width x height.  Each other part
 * has its first row, -1 where it was dropped.  words: of CHART_ALL. */
struct layout {
	const struct chart *chart;
	struct canvas *canvas;
	enum charset charset;
	unsigned words;
	int left, top, width, height;
	int title, y_title, axis, labels, label_rows, legend, foot;
};

struct layout layout_make(const struct chart *chart, struct canvas *canvas,
    enum charset charset, unsigned words);

/* Titles, axes, labels, legend and foot: all but the data. */
void layout_draw_around(struct layout *l);

/* Column of an x and row of a y among the data, in parts of a cell: 1 for
 * cells, 2 or 4 for dots.  Always within. */
int layout_column(const struct layout *l, double x, int parts);
int layout_row(const struct layout *l, double y, int parts);

/* The character of a rule across the plot. */
uint32_t layout_rule_code(enum series series, enum charset charset);

#endif

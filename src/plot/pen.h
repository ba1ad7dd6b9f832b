/* What a picture is drawn with: a page in points, y downward from the top left.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_PLOT_PEN_H
#define TIPSPEED_PLOT_PEN_H

#include <stdio.h>

#include "plot/chart.h"

/* How much is left of the colour of what is faint. */
#define PEN_FAINT 0.6

enum pen_fill { PEN_OPEN, PEN_PAPER, PEN_FULL, PEN_TINT };
enum pen_anchor { PEN_START, PEN_MIDDLE, PEN_END };

/* How a path is drawn.  width 0: its outline is not; a fill closes it. */
struct pen_stroke {
	enum series series;
	enum chart_line line; /* dashes */
	double width;
	enum pen_fill fill;
};

/* size in points; upward: reads from below to above; inverse: in the colour of
 * the paper; faint: as dim on a terminal.  length: stretched to that, 0: as it
 * comes. */
struct pen_style {
	double size, length;
	enum pen_anchor anchor;
	bool bold, upward, inverse, faint;
	enum series series;
};

/* How bars are drawn: with round ends, so that one of no length is a dot. */
struct pen_bar {
	enum series series;
	double width, opacity;
	bool round;
};

/* What is drawn on, and its colours as 0xRRGGBB.  corner: radius of its
 * corners, edge: the line around it where that is not 0. mono: all letters have
 * one width. */
struct pen_paper {
	unsigned colour, edge, ink[SERIES_COUNT];
	double corner;
	bool mono;
};

/* path: through x, y [n].  bars: n straight ones, bar i from x, y [2 i] to the
 * next.  text: its base line begins, is centred or ends at x, y.  close: writes
 * what is left; false when that failed; frees the pen. */
struct pen {
	void (*path)(struct pen *, const double *x, const double *y, size_t n,
	    const struct pen_stroke *);
	void (*bars)(struct pen *, const double *x, const double *y, size_t n,
	    const struct pen_bar *);
	void (*text)(struct pen *, double x, double y, const char *text,
	    const struct pen_style *);
	bool (*close)(struct pen *);
};

/* Makes a pen for a page.  title and about go into the file's description; the
 * paper is borrowed until the pen is closed.  pdf: from cairo; else PNG. */
typedef struct pen *pen_maker(double width, double height,
    const struct pen_paper *paper, const char *title, const char *about,
    bool pdf, FILE *out);
pen_maker pen_svg, pen_cairo;

#endif

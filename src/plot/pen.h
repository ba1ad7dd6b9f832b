/* A pen draws an image on a page, in points, with y downward from the top left.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_PLOT_PEN_H
#define TIPSPEED_PLOT_PEN_H

#include <stdio.h>

#include "plot/chart.h"

/* The opacity of faint parts. */
#define PEN_FAINT 0.6

/* Monospaced fonts by their names on each system, as a browser's default
 * monospace is often Courier. */
#define PEN_MONO                                                            \
	"ui-monospace, SFMono-Regular, Menlo, Consolas, DejaVu Sans Mono, " \
	"Liberation Mono, monospace"

enum pen_fill { PEN_OPEN, PEN_PAPER, PEN_FULL, PEN_TINT };
enum pen_anchor { PEN_START, PEN_MIDDLE, PEN_END };

/* How to draw a path.  width 0: no outline.  Any fill but PEN_OPEN closes the
 * path. */
struct pen_stroke {
	enum series series;
	enum chart_line line; /* dashes */
	double width;
	enum pen_fill fill;
};

/* How to draw a text.  size: in points.  upward: reads from bottom to top.
 * inverse: in the colour of the paper.  faint: like dim text on a terminal.
 * mono: monospaced.  length: the length to which the text is stretched, or
 * 0. */
struct pen_style {
	double size, length;
	enum pen_anchor anchor;
	bool bold, upward, inverse, faint, mono;
	enum series series;
};

/* How to draw bars.  round: with round ends, so a bar of length 0 is a dot. */
struct pen_bar {
	enum series series;
	double width, opacity;
	bool round;
};

/* The paper and its colours, 0xRRGGBB.  corner: radius of its corners.  edge:
 * colour of its border, drawn if corner is not 0.  mono: all text is
 * monospaced. */
struct pen_paper {
	unsigned colour, edge, ink[SERIES_COUNT];
	double corner;
	bool mono;
};

/* path draws a path through x, y [n].  bars draws n straight bars, bar i from
 * point 2 i to point 2 i + 1.  text draws a text that starts, is centred or
 * ends at x, with its baseline at y.  close writes the rest and frees the pen;
 * it returns false if writing failed.
 *
 * For PDF only, which may have several pages: width returns the width of a
 * text, points; next begins another page; place makes the pen draw from x, y
 * on, to that scale. */
struct pen {
	void (*path)(struct pen *, const double *x, const double *y, size_t n,
	    const struct pen_stroke *);
	void (*bars)(struct pen *, const double *x, const double *y, size_t n,
	    const struct pen_bar *);
	void (*text)(struct pen *, double x, double y, const char *text,
	    const struct pen_style *);
	bool (*close)(struct pen *);
	double (*width)(
	    struct pen *, const char *text, const struct pen_style *);
	void (*next)(struct pen *);
	void (*place)(struct pen *, double x, double y, double scale);
};

/* Makes a pen for a page.  title and about go into the file's metadata; the
 * paper is copied.  other: pen_new_cairo makes a PDF instead of a PNG;
 * pen_new_svg makes an SVG for an HTML page instead of a file of its own. */
typedef struct pen *pen_maker(double width, double height,
    const struct pen_paper *paper, const char *title, const char *about,
    bool other, FILE *out);
pen_maker pen_new_svg, pen_new_cairo;

#endif

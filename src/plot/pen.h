/* What a picture is drawn with: a page in points, y downward from the top left.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_PLOT_PEN_H
#define TIPSPEED_PLOT_PEN_H

#include <stdio.h>

#include "plot/picture.h"

enum pen_fill { PEN_OPEN, PEN_WHITE, PEN_FULL, PEN_TINT };
enum pen_anchor { PEN_START, PEN_MIDDLE, PEN_END };

/* How a path is drawn.  width 0: its outline is not; a fill closes it. */
struct pen_stroke {
	enum series series;
	enum chart_line line; /* dashes */
	double width;
	enum pen_fill fill;
};

/* size in points; upward: reads from below to above. */
struct pen_style {
	double size;
	enum pen_anchor anchor;
	bool bold, upward;
	enum series series;
};

/* path: through x, y [n].  text: its base line begins, is centred or ends at x,
 * y.  close: writes what is left; false when that failed; frees the pen. */
struct pen {
	void (*path)(struct pen *, const double *x, const double *y, size_t n,
	    const struct pen_stroke *);
	void (*text)(struct pen *, double x, double y, const char *text,
	    const struct pen_style *);
	bool (*close)(struct pen *);
};

/* title and about go into the file's description. */
struct pen *pen_svg(double width, double height, const char *title,
    const char *about, FILE *out);
struct pen *pen_cairo(double width, double height, const char *title,
    const char *about, bool pdf, FILE *out);

/* 0xRRGGBB on white paper; safe for red-green blindness. */
unsigned pen_colour(enum series series);

#endif

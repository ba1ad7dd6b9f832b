/* Charts as pictures for papers: SVG, PNG, PDF.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_PLOT_PICTURE_H
#define TIPSPEED_PLOT_PICTURE_H

#include <stdio.h>

#include "plot/chart.h"
#include "plot/pen.h"

/* PICTURE_INLINE: SVG that stands in a page of HTML. */
enum picture_form { PICTURE_SVG, PICTURE_PNG, PICTURE_PDF, PICTURE_INLINE };

/* How wide a chart is drawn, points. */
#define PICTURE_WIDTH 592.0

/* The form by the end of a file's name (".svg"); false where it is none of
 * them. */
bool picture_form_of(const char *path, enum picture_form *form);

/* Whether this program can draw the form: it may have been built without cairo,
 * which png and pdf need. */
bool picture_can(enum picture_form form);

/* The forms that this program can draw, in words. */
const char *picture_forms(void);

/* Writes the chart with axes, legend, notes and, at the foot, where the data
 * are from and what drew it (program: "tipspeed 0.1.0").  Ticks, marks and
 * dashes are those of chart_draw.  False when it cannot be drawn or written. */
bool picture_write(const struct chart *chart, enum picture_form form,
    const char *program, FILE *out);

/* Pages of a PDF, in points, for callers that lay them out: a pen, or NULL
 * where this program was built without cairo.  picture_height: of a chart that
 * is PICTURE_WIDTH wide; picture_draw: draws it from the pen's place on. */
struct pen *picture_pages(double width, double height, const char *title,
    const char *about, FILE *out);
double picture_height(const struct chart *chart, const char *program);
void picture_draw(
    const struct chart *chart, const char *program, struct pen *pen);

/* Writes cells as a terminal with a dark background shows them; lines, dots and
 * blocks are shapes, so that they join whatever the font.  depth: how many
 * colours, 0, 8, 16 or 256; title and about: described so.  False when it
 * cannot be drawn or written. */
bool picture_cells(const struct canvas *canvas, int depth,
    enum picture_form form, const char *title, const char *about, FILE *out);

/* The same for callers that make the page: the paper with its size in points
 * [2], and the cells. */
struct pen_paper picture_cells_paper(
    const struct canvas *canvas, int depth, double size[2]);
void picture_cells_draw(
    const struct canvas *canvas, int depth, struct pen *pen);

/* Places of cells are multiples of this beyond their margin, points. */
#define PICTURE_GRID 0.75

/* Width of a letter of size 1. */
#define PICTURE_LETTER 0.6

#endif

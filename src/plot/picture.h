/* Charts as images for publication: SVG, PNG, PDF.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_PLOT_PICTURE_H
#define TIPSPEED_PLOT_PICTURE_H

#include <stdio.h>

#include "plot/chart.h"
#include "plot/pen.h"

/* PICTURE_INLINE: SVG inside an HTML page. */
enum picture_form { PICTURE_SVG, PICTURE_PNG, PICTURE_PDF, PICTURE_INLINE };

/* The width of a chart unless another is asked for, points. */
#define PICTURE_WIDTH 592.0

/* Determines the form from the extension of a file (".svg").  Returns false for
 * other extensions. */
bool picture_format_of_file_name(const char *path, enum picture_form *form);

/* True if this program can draw the form.  PNG and PDF need cairo, without
 * which it may have been built. */
bool picture_can_draw_format(enum picture_form form);

/* Returns the names of the forms that this program can draw. */
const char *picture_list_formats(void);

/* Writes the chart with axes, legend and notes and, at its foot, the source of
 * the data and the program ("tipspeed 0.1.0").  Ticks, marks and dashes are
 * those of chart_draw.  width: in points; below PICTURE_WIDTH the legend is
 * below the plot.  Returns false if it cannot be drawn or written. */
bool picture_write_chart(const struct chart *chart, enum picture_form form,
    double width, const char *program, FILE *out);

/* For callers that lay out the pages of a PDF, in points.
 * picture_new_pdf_pages returns a pen, or NULL if this program was built
 * without cairo.  chart_picture_height returns the height of a chart that is
 * PICTURE_WIDTH wide.  chart_picture_draw draws the chart from the pen's place
 * on. */
struct pen *picture_new_pdf_pages(double width, double height,
    const char *title, const char *about, FILE *out);
double chart_picture_height(const struct chart *chart, const char *program);
void chart_picture_draw(
    const struct chart *chart, const char *program, struct pen *pen);

/* Writes cells as a terminal shows them, on a dark background unless the theme
 * is light.  Lines, dots and blocks are drawn as shapes, so that they join in
 * any font.  depth: number of colours, 0, 8, 16 or 256.  title, about: for the
 * file's metadata.  Returns false if writing fails. */
bool picture_write_screen(const struct canvas *canvas, int depth,
    enum picture_form form, const char *title, const char *about, FILE *out);

#endif

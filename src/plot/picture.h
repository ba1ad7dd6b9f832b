/* Charts as pictures for papers: SVG, PNG, PDF.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_PLOT_PICTURE_H
#define TIPSPEED_PLOT_PICTURE_H

#include <stdio.h>

#include "plot/chart.h"

enum picture_form { PICTURE_SVG, PICTURE_PNG, PICTURE_PDF };

/* The form that the end of a file's name asks for (".svg"); false where it asks
 * for none. */
bool picture_form_of(const char *path, enum picture_form *form);

/* Whether this program can draw the form: it may have been built without cairo,
 * which png and pdf need. */
bool picture_can(enum picture_form form);

/* The forms it can, in words. */
const char *picture_forms(void);

/* Writes the chart with axes, legend, notes and, at the foot, where the data
 * are from and what drew it (program: "tipspeed 0.1.0").  Ticks, marks and
 * dashes are those of chart_draw.  False when it cannot be drawn or written. */
bool picture_write(const struct chart *chart, enum picture_form form,
    const char *program, FILE *out);

/* Writes cells as a terminal with a dark ground shows them; lines, dots and
 * blocks are shapes, so that they join whatever the font.  depth: how many
 * colours, 0, 8, 16 or 256; title and about: described so.  False when it
 * cannot be drawn or written. */
bool picture_cells(const struct canvas *canvas, int depth,
    enum picture_form form, const char *title, const char *about, FILE *out);

#endif

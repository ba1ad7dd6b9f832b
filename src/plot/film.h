/* A recording of a screen: frames of cells, one after the other.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_PLOT_FILM_H
#define TIPSPEED_PLOT_FILM_H

#include <stdbool.h>
#include <stdio.h>

#include "plot/canvas.h"

/* canvas [n], all of one size; ms [n]: how long each is shown. */
struct film {
	size_t n;
	struct canvas **canvas;
	unsigned *ms;
};

/* Adds a copy of a frame; one like the last makes that longer. */
void film_add(struct film *film, const struct canvas *frame, unsigned ms);

void film_free(struct film *film);

/* Writes it as one SVG that plays by itself, again and again; a cell is drawn
 * once for each time that it changed.  Who wants no motion, or has a viewer
 * without, sees the last frame.  At least one frame; depth, title and about: as
 * for picture_cells.  False when it cannot be written. */
bool film_write(const struct film *film, int depth, const char *title,
    const char *about, FILE *out);

#endif

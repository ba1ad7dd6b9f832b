/* Screen pictures and plots in image files, for commands.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_DRAW_PLOT_H
#define TIPSPEED_CMD_DRAW_PLOT_H

#include <stdbool.h>

#include "cmd/lang/command.h"
#include "cmd/draw/plots.h"
#include "cmd/session/session.h"

/* A request for a picture of the full screen.  columns, rows: 0: those of the
 * open screen or, if none is open, 100 x 30.  page: from 1; 0: the current
 * page.  keys: names of keys to press first, or "".  charset, colours (0, 8, 16
 * or 256): used if charset_asked and colours_asked, otherwise those of the open
 * screen.  words: draw for a screen reader, without plots and lines, and set
 * picture to the page's plot as describe calls it, or NULL; the caller frees
 * it. */
struct screen_request {
	int columns, rows, page, colours;
	enum charset charset;
	bool charset_asked, colours_asked;
	const char *keys;
	bool words;
	char *picture;
};

/* plot_is_image_wanted returns true if the results go to a document or to a
 * file whose name is that of an image.  plot_write_image writes the chart there
 * and frees it. */
bool plot_is_image_wanted(const struct session *s);
bool plot_write_image(
    struct session *s, struct chart *chart, struct error *error);

#endif

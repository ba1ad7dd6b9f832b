/* Screen pictures and plots in image files, for commands.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_DRAW_PLOT_H
#define TIPSPEED_CMD_DRAW_PLOT_H

#include <stdbool.h>

#include "cmd/lang/command.h"
#include "cmd/draw/plots.h"
#include "cmd/session/session.h"

/* A picture of the full screen.  columns, rows: if 0, those of the open screen,
 * or else 100 x 30.  page: from 1; 0: the current page.  keys: names of keys to
 * press first; "": none.  charset and colours (0, 8, 16 or 256) are those of
 * the open screen unless `asked`.  words: draw for a screen reader, without
 * plots and lines, and set picture to the name that describe has for the page's
 * plot, or NULL; the caller frees it. */
struct screen_request {
	int columns, rows, page, colours;
	enum charset charset;
	bool charset_asked, colours_asked;
	const char *keys;
	bool words;
	char *picture;
};

/* plot_is_image_wanted is true if the results go to an image file, recognised
 * by its name, or to a document.  plot_write_image writes the chart to it and
 * frees the chart. */
bool plot_is_image_wanted(const struct session *s);
bool plot_write_image(
    struct session *s, struct chart *chart, struct error *error);

#endif

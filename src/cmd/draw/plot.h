/* What commands need to draw pictures.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_DRAW_PLOT_H
#define TIPSPEED_CMD_DRAW_PLOT_H

#include <stdbool.h>

#include "cmd/lang/command.h"
#include "cmd/draw/plots.h"
#include "cmd/session/session.h"

/* A picture of the full screen.  columns, rows: 0: those of the open screen,
 * else 100 x 30.  page: from 1; 0: the one shown.  keys: names of keys, pressed
 * before; "": none.  charset and colours (0, 8, 16 or 256) are those of the
 * open screen unless they are `asked`.  words: for a screen reader, plots and
 * lines are left out, and `picture` is the name that describe has for the
 * page's plot, or NULL; the caller frees it. */
struct screen_request {
	int columns, rows, page, colours;
	enum charset charset;
	bool charset_asked, colours_asked;
	const char *keys;
	bool words;
	char *picture;
};

/* plot_writes_image is true if the results are written into a picture's file,
 * known by its name, or into a document.  plot_write_image writes the chart
 * there, and frees it. */
bool plot_writes_image(const struct session *s);
bool plot_write_image(
    struct session *s, struct chart *chart, struct error *error);

#endif

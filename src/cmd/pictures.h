/* Commands that draw.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_PICTURES_H
#define TIPSPEED_CMD_PICTURES_H

#include <stdbool.h>

#include "cmd/command.h"
#include "cmd/plots.h"
#include "cmd/session.h"

/* A picture of the full screen.  columns, rows: 0: as the one that is open,
 * else 100 x 30.  page: from 1; 0: the one shown.  keys: names of keys, pressed
 * before; "": none.  charset and colours (0, 8, 16 or 256) are those of the
 * open one unless they are `asked`. */
struct screen_request {
	int columns, rows, page, colours;
	enum charset charset;
	bool charset_asked, colours_asked;
	const char *keys;
};

/* Whether the results go into a file whose name asks for a picture, and the
 * chart as that picture. */
bool pictures_wanted(const struct session *s);
bool pictures_draw(
    struct session *s, const struct chart *chart, struct error *error);

#endif

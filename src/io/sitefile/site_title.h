/* The titles of tables: lines of words right above them.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_SITEFILE_SITE_TITLE_H
#define TIPSPEED_IO_SITEFILE_SITE_TITLE_H

#include "io/sitefile/classify.h"

/* Whether a line says which sample one of the layout's tables has. */
bool title_heads_any(const struct layout *layout, const struct row *row);

/* Returns the meanings of the words that stand next to a table and tell feed
 * from product: its title, the name of its sheet or file (path).  near: its
 * speed, rpm and strange are set if the title states them. */
uint64_t title_context(const struct layout *layout, const struct table *t,
    const char *path, struct surroundings *near);

#endif

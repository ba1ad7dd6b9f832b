/* Commands about the store of materials.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_STORE_H
#define TIPSPEED_CMD_STORE_H

#include <stdbool.h>

#include "cmd/session.h"

/* A material by its name, one's own before Table 3's: "tierp", else
 * "table3/tierp".  None: an error with the name that is nearest. */
bool store_find_material(const struct stored_list *list, const char *name,
    const struct stored **found, struct error *error);

/* "fit", "set by hand" or "Table 3". */
const char *store_origin_words(const struct stored *m);

#endif

/* Sheets in: of one site in one file or several, with what is asked about
 * them.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_LOAD_H
#define TIPSPEED_CMD_LOAD_H

#include "cmd/session.h"

/* Loads files, each "FILE" or "FILE@SPEED", and says so beside the results: as
 * one site where a speed is given or none of them is complete, else a site
 * each. */
bool load_files(
    struct session *s, size_t n, const char *const *word, struct error *error);

#endif

/* Puts a new file in the place of an old one, whole or not at all.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_REPLACE_H
#define TIPSPEED_IO_REPLACE_H

#include <stdbool.h>
#include <stdio.h>

#include "base/error.h"

/* write is given a new file beside path, which takes its place only when all of
 * it is on the disk.  The rights of a file that is there are kept; a symbolic
 * link is replaced by the file.  On failure false, an error of kind
 * ERROR_SYSTEM, and the old file untouched. */
bool replace_file(const char *path, void (*write)(const void *data, FILE *out),
    const void *data, struct error *error);

#endif

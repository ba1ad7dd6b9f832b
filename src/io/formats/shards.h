/* Reads files written by `calibrate all part=I/N` or `validate all part=I/N`.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_FORMATS_SHARDS_H
#define TIPSPEED_IO_FORMATS_SHARDS_H

#include <stdbool.h>
#include <stddef.h>

#include "base/error.h"

/* A row of a part: a site or one of its runs.  text [2]: the name, and the
 * remark or source of the data; number: the other columns, NAN if empty. */
enum { PART_NUMBERS = 23 };
struct part_site {
	size_t index; /* among all sites */
	char *text[2];
	double number[PART_NUMBERS];
};

/* A part, and the file from which it was read.  sites: digest of all loaded
 * sites.  left_out, each: from the answer of validate. */
struct part_file {
	char *path, *command, *sites, *version, *options;
	size_t number, of, loaded, left_out, each, n;
	struct part_site *site;
};

struct parts {
	size_t n;
	struct part_file *part;
};

/* Adds the parts in a file, one per line. */
bool parts_read_file(
    const char *path, struct parts *parts, struct error *error);
void parts_free(struct parts *parts);

/* True if the parts are complete, without duplicates, and have the same
 * version, options and sites. */
bool parts_check_agree(const struct parts *parts, struct error *error);

#endif

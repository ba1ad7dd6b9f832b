/* Reads files written by `calibrate all part=I/N` or `validate all part=I/N`.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_FORMATS_SHARDS_H
#define TIPSPEED_IO_FORMATS_SHARDS_H

#include <stdbool.h>
#include <stddef.h>

#include "base/error.h"

/* A row of a part: a site or one of its runs.  index: of the site among all;
 * order: of reading.  source: of the site's data; remark: of a calibration, or
 * NULL; number: the other columns, NAN if empty. */
enum { PART_NUMBERS = 23 };
struct part_row {
	size_t index, order;
	const char *site, *source, *remark;
	double number[PART_NUMBERS];
};

/* A part, and the file from which it was read.  sites: digest of all loaded
 * sites.  left_out, each: from the answer of validate.  The texts, also those
 * of rows, are in the JSON; the path is the caller's. */
struct part_file {
	struct json_t *json;
	const char *path, *command, *sites, *version, *options;
	size_t number, of, loaded, left_out, each;
};

struct parts {
	size_t n, n_row;
	struct part_file *part;
	struct part_row *row;
};

/* Adds the parts in a file, one per line. */
bool parts_read_file(
    const char *path, struct parts *parts, struct error *error);
void parts_free(struct parts *parts);

/* True if the parts are complete, without duplicates, and have the same
 * version, options and sites.  Their rows are then in the order of all sites,
 * those of one site as they were written. */
bool parts_check_and_sort(struct parts *parts, struct error *error);

#endif

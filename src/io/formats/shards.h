/* Reads files written by `calibrate all part=I/N` or `validate all part=I/N`.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_FORMATS_SHARDS_H
#define TIPSPEED_IO_FORMATS_SHARDS_H

#include <stdbool.h>
#include <stddef.h>

#include "base/error.h"

/* The format of the parts.  Raise it when a key or a number of theirs, or the
 * meaning of one, changes: parts of other formats are refused. */
enum { PART_FORMAT = 1 };

/* A row of a part: a site or one of its runs.  index: of the site among all;
 * order: of reading.  source: of the site's data; remark: of a calibration, or
 * NULL; number: the other columns, NAN if empty. */
enum { PART_NUMBERS = 23 };
struct part_row {
	size_t index, order;
	const char *site, *source, *remark;
	double number[PART_NUMBERS];
};

/* A part, and the file it was read from.  number, of: I and N of part=I/N.
 * loaded: the number of all loaded sites; sites: their digest.  left_out, each:
 * from the answer of validate.  All texts, also those of rows, belong to json,
 * except path, which is the caller's. */
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

/* Adds the parts in a file, one on each line.  Returns false if the file cannot
 * be read or if a part has another format than PART_FORMAT. */
bool parts_read_result_file(
    const char *path, struct parts *parts, struct error *error);
void parts_free(struct parts *parts);

/* Returns true if the parts are complete, without duplicates, and have the same
 * command, version, options and sites.  Then their rows are sorted in the order
 * of the sites, and those of one site in the order in which they were read. */
bool parts_check_and_sort(struct parts *parts, struct error *error);

#endif

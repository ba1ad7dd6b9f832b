/* Reads collision energies: exports, lists, spectra.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_FORMATS_COLLISIONS_H
#define TIPSPEED_IO_FORMATS_COLLISIONS_H

#include <stdbool.h>
#include <stdint.h>

#include "base/error.h"
#include "core/model/spectrum.h"

/* How to read a file.  columns: the names of its columns in order, separated by
 * commas; NULL: as in the file.  unit: of a list without headings, "J/kg" or
 * "m/s"; NULL: not given.  speed: m/s, NAN if not given.  progress: called now
 * and then with the rows so far; it returns false to stop reading; may be
 * NULL. */
struct collisions_way {
	const char *columns, *unit;
	double speed;
	bool (*progress)(void *data, uint64_t rows);
	void *data;
};

/* The content of a file.  form: its kind in words, a constant.  about: the
 * file's own description, or "".  rows: number of rows with numbers; impacts:
 * number of impacts on particles.  weighted: rows have weights and the file
 * does not give the number of impacts; `impacts` then counts rows. */
struct collisions {
	struct spectrum *spectrum;
	const char *form;
	char *about;
	uint64_t rows, impacts;
	bool weighted;
};

/* Reads a file row by row, in constant memory.  The columns are named by
 * headings or by `columns`: see HEADS in the .c.  A row is an impact; it may
 * also describe the particle or its first impact.
 *
 * On failure, returns false and faults in errors; *c is then empty.  If
 * progress stops the reading, there is one fault of kind ERROR_CHECK. */
bool collisions_read(const char *path, const struct collisions_way *way,
    struct collisions *c, struct error_list *errors);
void collisions_clear(struct collisions *c);

/* Prints a spectrum as a file that collisions_read can read. */
void collisions_write(const struct collisions *c, const char *name, FILE *out);

#endif

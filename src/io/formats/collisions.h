/* Reads and writes collision energies: exports of DEM programs, lists, spectra.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_FORMATS_COLLISIONS_H
#define TIPSPEED_IO_FORMATS_COLLISIONS_H

#include <stdbool.h>
#include <stdint.h>

#include "base/error.h"
#include "core/model/spectrum.h"

/* How to read a file.  columns: the names of its columns in order, separated by
 * commas; NULL to take those in the file.  unit: the unit of a list without
 * headings, "J/kg" or "m/s"; NULL if not given.  speed: m/s, NAN if not given.
 * progress: called now and then with the number of rows so far; it returns
 * false to stop reading; may be NULL. */
struct collisions_way {
	const char *columns, *unit;
	double speed;
	bool (*progress)(void *data, uint64_t rows);
	void *data;
};

/* The content of a file.  form: its kind in words, not to be freed.  about: the
 * file's own description, or "".  rows: the number of rows with numbers;
 * impacts: the number of impacts on particles.  weighted: rows have weights
 * and the file does not give the number of impacts; `impacts` counts rows. */
struct collisions {
	struct spectrum *spectrum;
	const char *form;
	char *about;
	uint64_t rows, impacts;
	bool weighted;
};

/* Reads a file row by row, in constant memory.  Headings or way->columns name
 * the columns: see HEADS in the .c.  A row is an impact; it may also describe
 * the particle or its first impact.
 *
 * On failure, returns false and adds faults to errors; *c is then empty.  If
 * progress stops the reading, there is one fault of kind ERROR_CHECK. */
bool collisions_read(const char *path, const struct collisions_way *way,
    struct collisions *c, struct error_list *errors);
void collisions_clear(struct collisions *c);

/* Prints a spectrum as a file that collisions_read can read. */
void collisions_write(const struct collisions *c, const char *name, FILE *out);

#endif

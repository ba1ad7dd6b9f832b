/* Reads collision energies: exports, lists, spectra.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_FORMATS_COLLISIONS_H
#define TIPSPEED_IO_FORMATS_COLLISIONS_H

#include <stdbool.h>
#include <stdint.h>

#include "base/error.h"
#include "core/model/spectrum.h"

/* How to read a file.  columns: names of its columns in order, separated by
 * commas, instead of the names in the file; NULL: the names in the file.  unit:
 * of a list without heads, "J/kg" or "m/s"; NULL: not given.  speed: m/s, NAN
 * if not given.  progress: called now and then with the rows so far; returning
 * false stops the reading; may be NULL. */
struct collisions_way {
	const char *columns, *unit;
	double speed;
	bool (*progress)(void *data, uint64_t rows);
	void *data;
};

/* The content of a file.  form: its kind in words, a constant.  about: its own
 * description, or "".  rows: number of rows of numbers; impacts: number of
 * impacts of particles. */
struct collisions {
	struct spectrum *spectrum;
	const char *form;
	char *about;
	uint64_t rows, impacts;
};

/* Reads a file row by row: memory does not grow with its rows.  Files have
 * heads, or `columns` names them: see HEADS in the .c.  A row is an impact, and
 * may tell of the particle, or of the first of its impacts, too.
 *
 * On failure false, and faults in errors; *c is then empty.  If progress stops
 * the reading there is one fault of kind ERROR_CHECK. */
bool collisions_read(const char *path, const struct collisions_way *way,
    struct collisions *c, struct error_list *errors);
void collisions_clear(struct collisions *c);

/* Prints a spectrum as a file that collisions_read can read. */
void collisions_write(const struct collisions *c, const char *name, FILE *out);

#endif

/* Reads collision energies: dumps of contacts, exports, lists, spectra.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_FORMATS_COLLISIONS_H
#define TIPSPEED_IO_FORMATS_COLLISIONS_H

#include <stdbool.h>
#include <stdint.h>

#include "base/error.h"
#include "core/model/spectrum.h"

/* How to read a file.  columns: names of its columns in order, separated by
 * commas, instead of the names in the file; NULL: the names in the file.
 * particles: file with the radius or size of each id, or NULL.  unit: of a list
 * without heads, "J/kg" or "m/s"; NULL: not given.  speed: m/s, NAN if not
 * given.  cut: J/kg; an impact below it does not count as a particle's first.
 * density: kg/m3.  progress: called now and then with the rows so far;
 * returning false stops the reading; may be NULL. */
struct collisions_way {
	const char *columns, *particles, *unit;
	double speed, cut, density;
	bool (*progress)(void *data, uint64_t rows);
	void *data;
};

/* The content of a file.  form: its kind in words, a constant.  about: its own
 * description, or "".  rows: number of rows of numbers; snapshots: number of
 * snapshots of a dump, else 0; impacts: number of impacts of particles, after
 * contacts were merged. */
struct collisions {
	struct spectrum *spectrum;
	const char *form;
	char *about;
	uint64_t rows, snapshots, impacts;
};

/* Reads a file row by row: memory does not grow with its rows, but with the
 * particles (8 bytes each) and the contacts of one snapshot.
 *
 * LIGGGHTS dump local: a contact that is in several successive snapshots is one
 * impact, at its largest relative normal velocity v.  The energy of a particle
 * of mass m that meets one of mass M is m M / (m + M) v^2 / (4 m), J/kg, since
 * each gets half; it is all of v^2 / 2 if the other never moves (velocity 0,
 * the bed).  Columns without names are taken for those of pos, vel and id.
 * Other files have heads, or `columns` names them: see COLUMNS in the .c.  A
 * row is an impact.
 *
 * On failure false, and faults in errors; *c is then empty.  If progress stops
 * the reading there is one fault of kind ERROR_CHECK. */
bool collisions_read(const char *path, const struct collisions_way *way,
    struct collisions *c, struct error_list *errors);
void collisions_clear(struct collisions *c);

/* Prints a spectrum as a file that collisions_read can read. */
void collisions_write(const struct collisions *c, const char *name, FILE *out);

#endif

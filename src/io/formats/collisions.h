/* Reads collision energies: dumps of contacts, exports, lists, spectra.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_FORMATS_COLLISIONS_H
#define TIPSPEED_IO_FORMATS_COLLISIONS_H

#include <stdbool.h>
#include <stdint.h>

#include "base/error.h"
#include "core/model/spectrum.h"

/* How to read a file.  columns: names of its columns in order, separated by
 * commas, instead of its own; NULL: its own.  particles: file with the radius
 * or size of each id, or NULL.  unit: of a list without heads, "J/kg" or "m/s";
 * NULL: not given.  speed, m/s: NAN where it is not given.  cut: J/kg, below
 * which an impact is not a particle's first.  density kg/m3.  progress: called
 * now and then with the rows so far; false stops the reading; or NULL. */
struct collisions_way {
	const char *columns, *particles, *unit;
	double speed, cut, density;
	bool (*progress)(void *data, uint64_t rows);
	void *data;
};

/* The content of a file.  form: its kind in words, a constant; about: its own
 * description, or ""; rows: of numbers; snapshots: of a dump, else 0; impacts:
 * of particles, after contacts were merged; unused: particles named that no
 * contact has. */
struct collisions {
	struct spectrum *spectrum;
	const char *form;
	char *about;
	uint64_t rows, snapshots, impacts;
};

/* Reads a file row by row: memory does not grow with its rows, but with the
 * particles (8 bytes each) and the contacts of one snapshot.
 *
 * LIGGGHTS dump local: a contact in snapshots one after another is one impact,
 * at its largest relative normal velocity v.  The energy of a particle of mass
 * m that meets one of mass M is m M / (m + M) v^2 / (4 m), J/kg: each has half;
 * all of v^2 / 2 where the other never moves (velocity 0, the bed).  Without
 * the columns' names they are those of pos, vel and id.
 * Other files have heads, or `columns`: see COLUMNS in the .c.  A row is an
 * impact.
 *
 * False and faults in errors; *c is then empty.  Stopped: one fault of kind
 * ERROR_CHECK. */
bool collisions_read(const char *path, const struct collisions_way *way,
    struct collisions *c, struct error_list *errors);
void collisions_clear(struct collisions *c);

/* Prints a spectrum as a file that collisions_read takes. */
void collisions_write(const struct collisions *c, const char *name, FILE *out);

#endif

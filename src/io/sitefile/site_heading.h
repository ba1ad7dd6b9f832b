/* The lines of a sheet outside its tables: keys with their values, titles.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_SITEFILE_SITE_HEADING_H
#define TIPSPEED_IO_SITEFILE_SITE_HEADING_H

#include "core/psd/site.h"
#include "io/sitefile/layout.h"

/* Reads the lines above the tables into the site: name, rock, rotor, others as
 * notes.  speed: set to m/s, or to rpm, if a speed is stated for all samples;
 * otherwise not changed. */
struct heading_speed {
	double mps, rpm;
};
void site_heading_read(const struct layout *layout, struct sheet *sheet,
    struct site *site, struct heading_speed *speed);

/* The rotor's diameter, mm, as lines outside the tables state it, with the
 * first of them; -1: they differ; 0: there is none. */
struct heading_rotor {
	double mm;
	int line;
};

/* Adds the rotor that the lines of a layout state to *said, which has those of
 * earlier layouts. */
void site_heading_rotor(
    const struct layout *layout, struct heading_rotor *said);

/* Returns the name of a file without folder and extension, in a form that can
 * be written into a sheet.  The caller frees. */
char *site_heading_name(const char *path);

#endif

/* The lines of a sheet outside its tables: keys with values, and titles.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_SITEFILE_SITE_HEADING_H
#define TIPSPEED_IO_SITEFILE_SITE_HEADING_H

#include "core/psd/site.h"
#include "io/sitefile/layout.h"

/* Reads the lines above the tables into the site: name, rock, rotor, and other
 * lines as notes.  other_site: they, or lines between tables, name another
 * site, rock or machine than those of an earlier sheet or table.  mps, rpm: the
 * speed, or 0 if none is stated, or several that differ. */
struct heading_speed {
	double mps, rpm;
	bool differ, other_site;
};
void site_heading_read(const struct layout *layout, struct sheet *sheet,
    struct site *site, struct heading_speed *speed);

/* Takes a speed in m/s or rpm (0: not stated).  If another one was taken
 * before, sets speed->differ. */
void site_heading_record_speed(
    struct heading_speed *speed, double mps, double rpm);

/* Takes the speed that a line states with a key, "tip speed; 70".  Returns
 * false if it states none. */
bool site_heading_speed_of_line(const struct sheet *sheet,
    const struct row *row, struct heading_speed *speed);

/* Returns the day that a line states with a key, "Date; 2026-05-03", as
 * "2026-05-03".  Returns NULL if it states none, or one that can be read in two
 * ways.  The caller frees it. */
char *site_heading_date_of_line(const struct row *row);

/* The rotor's diameter, mm, stated in lines outside the tables, and the first
 * line that states it, or 0.  other_mm, other_line: the first that differs from
 * it, or 0; -1 mm if this line itself states several. */
struct heading_rotor {
	double mm, other_mm;
	int line, other_line;
};

/* Updates *said, which may have a diameter from earlier layouts, with the
 * diameters stated in the lines of this one. */
void site_heading_merge_rotor(const struct layout *layout,
    const struct sheet *sheet, struct heading_rotor *said);

/* Returns "840 mm in line 2 and 900 mm in line 3" if two differ.  The caller
 * frees it. */
char *site_heading_rotors_text(const struct heading_rotor *said);

/* Returns the name of a file without folder and extension, with "_" for each
 * byte that cannot be written to a sheet.  The caller frees it. */
char *site_heading_name_from_path(const char *path);

/* Notes that a line, or a part of it, is not read. */
void site_heading_leave_out(struct site *site, int line, const char *format,
    ...) __attribute__((format(printf, 3, 4)));

#endif

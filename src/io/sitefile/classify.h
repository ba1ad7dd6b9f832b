/* Classifies the columns of a laboratory's table, and decides which are
 * uncertain.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_SITEFILE_CLASSIFY_H
#define TIPSPEED_IO_SITEFILE_CLASSIFY_H

#include <stdint.h>

#include "core/psd/site.h"
#include "io/sitefile/site_column.h"
#include "io/sitefile/site_samples.h"

/* What is known from outside the table.  rotor: the rotor's diameter, m, or 0
 * if not known.  speed, rpm: m/s and rpm of samples whose headings state no
 * speed, or 0.  context: the meanings of the words around the table (its title,
 * the name of its sheet or file), which tell feed from product.  told: the user
 * gave the headings.  samples: those that the user described by name. */
struct surroundings {
	double rotor, speed, rpm;
	uint64_t context;
	bool told;
	struct samples *samples;
};

/* Adds the columns of a table that contain samples, with role, speed and
 * quantity as their headings and numbers show.  An ambiguous column is marked
 * open.  Lists the other columns in site->left_out. */
void classify_columns(struct table *t, const struct surroundings *near,
    struct columns *all, struct site *site);

/* Decides what depends on all columns together: which of two quantities of a
 * sample to use, the role of a column that states none, the order of repeats.
 * told: the user gave the headings.  *wants_rotor becomes true if a speed is in
 * rpm and the rotor's diameter is not known. */
void classify_columns_together(
    struct columns *all, struct site *site, bool told, bool *wants_rotor);

/* Returns a column in the words of columns=, "product@69 retained_g".  The
 * caller frees the text. */
char *classify_describe_column(const struct column *c);

#endif

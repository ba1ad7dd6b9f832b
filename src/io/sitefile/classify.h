/* Classifies the columns of a laboratory's table, and decides which are
 * uncertain.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_SITEFILE_CLASSIFY_H
#define TIPSPEED_IO_SITEFILE_CLASSIFY_H

#include <stdint.h>

#include "core/psd/site.h"
#include "io/sitefile/site_column.h"
#include "io/sitefile/site_samples.h"

/* Facts known from outside the table.  rotor: diameter, m; 0: not known.
 * speed: m/s, for samples whose headings state none; or 0.  context: the
 * meanings of the words around the table (title, name of the sheet or file)
 * that distinguish feed from product.  told: the headings were given by the
 * user.  samples: the samples given by name.  counted: bare numbers in headings
 * are not tip speeds. */
struct surroundings {
	double rotor, speed, rpm;
	uint64_t context;
	bool told, counted;
	struct samples *samples;
};

/* Adds the columns of a table that contain samples, with all that follows from
 * their headings and numbers; lists other columns in site->left_out.  An
 * ambiguous column is open. */
void classify_columns(struct table *t, const struct surroundings *near,
    struct columns *all, struct site *site);

/* Settles what depends on all columns together: which of two quantities of a
 * sample to use, the role of a column that states none, the order of repeats.
 * told: the headings were given by the user.  wants_rotor: out, true if a speed
 * is in rpm and the rotor's diameter is not stated. */
void classify_columns_together(
    struct columns *all, struct site *site, bool told, bool *wants_rotor);

/* Returns the description of a column as used in columns=, "product@69
 * retained_g".  The caller frees it. */
char *classify_describe_column(const struct column *c);

#endif

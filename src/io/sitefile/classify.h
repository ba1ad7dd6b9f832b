/* Finds what the columns of a laboratory's table are, and with what certainty.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_SITEFILE_CLASSIFY_H
#define TIPSPEED_IO_SITEFILE_CLASSIFY_H

#include <stdint.h>

#include "core/psd/site.h"
#include "io/sitefile/site_column.h"
#include "io/sitefile/site_samples.h"

/* Facts known from outside the table.  rotor: its diameter, m; 0: not known.
 * speed: m/s, for samples whose headings state none; or 0.  context: the
 * meanings of the words around the table (title, name of the sheet or file)
 * that distinguish feed from product.  told: the heads were given by hand.
 * samples: the samples given by name.  counted: numbers alone in headings are
 * not tip speeds. */
struct surroundings {
	double rotor, speed, rpm;
	uint64_t context;
	bool told, counted;
	struct samples *samples;
};

/* Adds the columns of a table that contain samples, with everything that
 * follows from their headings and numbers; other columns are added to
 * site->left_out.  A column that could be several things is open. */
void recognise_columns(struct table *t, const struct surroundings *near,
    struct columns *all, struct site *site);

/* Settles the questions that depend on all columns together: which of two
 * quantities of one sample is used, the role of a column without one, the order
 * of repeats.  told: the headings were given by hand.  wants_rotor: out, true
 * if a speed is in rpm and the rotor's diameter is not stated. */
void recognise_roles(
    struct columns *all, struct site *site, bool told, bool *wants_rotor);

/* Returns the words for a column, "product@69 retained_g", as columns= contains
 * them.  The caller frees. */
char *recognise_column_text(const struct column *c);

#endif

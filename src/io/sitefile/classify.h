/* What the columns of somebody else's table are, and how sure that is.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_SITEFILE_CLASSIFY_H
#define TIPSPEED_IO_SITEFILE_CLASSIFY_H

#include <stdint.h>

#include "core/psd/site.h"
#include "io/sitefile/site_column.h"
#include "io/sitefile/site_samples.h"

/* What is known beside the table.  rotor: its diameter, m; 0: not known.
 * speed: m/s, of samples whose heads tell none; 0.  context: the meanings of
 * the words around the table (title, name of the sheet or file) that tell feed
 * from product.  told: the heads were given by hand.
 * samples: what is said of them by name.
 * counted: numbers alone in heads are no tip speeds.
 * strange: the title has words that may tell another machine or day. */
struct surroundings {
	double rotor, speed, rpm;
	uint64_t context;
	bool told, strange, counted;
	struct samples *samples;
};

/* Adds the columns of a table that hold samples, with what can be told from
 * their heads and numbers; what holds none goes to site->left_out.  A column
 * that could be several things is open. */
void recognise_columns(struct table *t, const struct surroundings *near,
    struct columns *all, struct site *site);

/* Settles what only all columns together tell: which of two quantities of one
 * sample is taken, what a column without a role is, the order of repeats.
 * told: the heads were given by hand.  wants_rotor: out, a speed is told in rpm
 * and the rotor's diameter is not. */
void recognise_settle(
    struct columns *all, struct site *site, bool told, bool *wants_rotor);

/* "product@69 retained_g", as columns= has it.  The caller frees. */
char *recognise_words(const struct column *c);

#endif

/* Reads the sheets of a site, see tipspeed-site(5), and says what is wrong or
 * open in them.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_SITE_READ_H
#define TIPSPEED_IO_SITE_READ_H

#include "base/error.h"
#include "core/site.h"

/* What is to be read as one site: files [n], with the tip speed of the samples
 * in each, m/s, where it was given (0: in the sheet); and what somebody says of
 * them, NULL or 0 where nothing.  columns: "1=sieve mm, 3=feed retained_g", by
 * number from 1 (lines where sieves go across); those not named are left out.
 * range: "A3:F20".  decimal: '.' or ','.  rotor: diameter, m.  parts: samples
 * of product to be added to a site, which need no feed. */
struct site_request {
	size_t n;
	const char *const *path;
	const double *speed;
	const char *columns, *sheet, *range;
	char decimal;
	double rotor;
	bool parts;
};

/* What could not be told: columns [n], with what each seems to be in the words
 * of columns=, and all of it as that option.  settle: the option that settles
 * it ("columns=\"1=sieve mm, ..\"", "rotor_mm=DIAMETER"); NULL: nothing was
 * open.  no_feed, no_product: what the files lack. */
struct site_ask {
	size_t n;
	struct site_ask_column {
		size_t number;
		char *head, *values, *guess;
		bool open;
	} * column;
	char *settle;
	bool no_feed, no_product;
};

/* Reads a site.  On success a site with digest and path (of the first file)
 * set, and nothing added to errors.  On failure NULL and at least one fault:
 * ERROR_SYSTEM when a file cannot be read, otherwise all the independent faults
 * of the sheets, in file order, each of kind ERROR_DATA with its line and
 * column; where something was open, one fault says so and *ask holds it.
 * errors: a list that the caller has zeroed, never NULL.  ask: zeroed by the
 * caller, who clears it, or NULL.
 *
 * Sizes are kept to 1e-9 mm and passings to 1e-12 %, which is what site_write
 * writes, so that a site and its saved copy have the same digest.  The rules
 * of psd.h hold in every run; feeds pass 1 on their coarsest sieve. */
struct site *site_read_as(const struct site_request *request,
    struct error_list *errors, struct site_ask *ask);
void site_ask_clear(struct site_ask *ask);

/* The same of one file without anything said. */
struct site *site_read(const char *path, struct error_list *errors);

#endif

/* What somebody wants read as a site, and what is to be asked about it.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_SITEFILE_SITE_REQUEST_H
#define TIPSPEED_IO_SITEFILE_SITE_REQUEST_H

#include <stdbool.h>
#include <stddef.h>

/* What is to be read as one site: files [n], with the tip speed of the samples
 * in each, m/s, where it was given (0: in the sheet); and what somebody says of
 * them, NULL or 0 where nothing.  columns: "1=sieve mm, 3=feed retained_g", by
 * number from 1 (lines where sieves go across); those not named are left out.
 * samples: "S01=feed, S02=@70", by name; those not named are left out.
 * top: mm, what all of a feed is assumed to pass whose coarsest sieve does not.
 * range: "A3:F20".  decimal: '.' or ','.  rotor: diameter, m.  parts: samples
 * of product to be added to a site, which need no feed; feed: the feed in it is
 * wanted, which is what a lone sample without a role then is.  text: NULL, or
 * what the one file would hold, which is then not read; path is its name. */
struct site_request {
	size_t n;
	const char *const *path;
	const double *speed;
	const char *columns, *samples, *sheet, *range, *text;
	char decimal;
	double rotor, top;
	bool parts, feed;
};

/* What could not be told: columns [n], with what each seems to be in the words
 * of columns=, and all of it as that option.  settle: the option that settles
 * it ("columns=\"1=sieve mm, ..\"", "rotor_mm=DIAMETER"); NULL: nothing was
 * open.  across: the numbers are those of lines; by_sample: columns are told by
 * their heads, which are names of samples, as samples= has them.  no_feed,
 * no_product: what the files lack. */
struct site_ask {
	size_t n;
	struct site_ask_column {
		size_t number;
		char *head, *values, *guess;
		bool open;
	} * column;
	char *settle;
	bool across, by_sample, no_feed, no_product;
};

/* Frees what *ask owns. */
void site_ask_clear(struct site_ask *ask);

#endif

/* A request to read files as a site, and the questions that they leave open.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_SITEFILE_SITE_REQUEST_H
#define TIPSPEED_IO_SITEFILE_SITE_REQUEST_H

#include <stdbool.h>
#include <stddef.h>

/* The files [n] to be read as one site, with the tip speed of the samples in
 * each, m/s, if given (0: the sheet states it); and options, NULL or 0 if not
 * given.  columns: "1=sieve mm, 3=feed retained_g", by number from 1 (by line
 * if sieves are in one row); columns not named are left out.  samples:
 * "S01=feed, S02=@70", by name; samples not named are left out.  top: mm, the
 * size that a whole feed is assumed to pass if its coarsest sieve does not pass
 * all.  range: "A3:F20".  decimal: '.' or ','.  rotor: diameter, m.  parts:
 * samples of product to be added to a site, which need no feed; site_rotor is
 * that site's diameter, m, for sheets that state none.  feed: only the
 * feed is read, and a single sample without a role is taken for it.  text:
 * NULL, or the content of the one file, which is then not opened; path is its
 * name. */
struct site_request {
	size_t n;
	const char *const *path;
	const double *speed;
	const char *columns, *samples, *sheet, *range, *text;
	char decimal;
	double rotor, site_rotor, top;
	bool parts, feed;
};

/* The open questions: columns [n], with what each seems to be, in the words of
 * columns=.  settle: the option that answers the question
 * ("columns=\"1=sieve mm, ..\"", "rotor_mm=DIAMETER"); NULL: no question was
 * open.  across: the numbers are those of lines.  by_sample: columns are
 * identified by their headings, which are names of samples, for samples=.
 * no_feed, no_product: the files contain none. */
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

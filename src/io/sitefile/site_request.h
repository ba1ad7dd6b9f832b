/* A request to read files as a site, and the questions that they leave open.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_SITEFILE_SITE_REQUEST_H
#define TIPSPEED_IO_SITEFILE_SITE_REQUEST_H

#include <stdbool.h>
#include <stddef.h>

/* Cells of a sheet from the first to the last line and column, from 1. */
struct site_box {
	int top, left, bottom, right;
};

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
 * no_feed, no_product: the files contain none.  tables: instead of columns they
 * are tables, each with its title as head, its lines as values, and its cells
 * as box; first, last: those that are proposed, from 0. */
struct site_ask {
	size_t n;
	struct site_ask_column {
		size_t number;
		char *head, *values, *guess;
		bool open;
		struct site_box box;
	} * column;
	size_t first, last;
	char *settle;
	bool across, by_sample, tables, no_feed, no_product;
};

/* Reads "A3:F20"; false if it is not of that form. */
bool site_box_read(const char *text, struct site_box *box);

/* Returns the cells as "A3:F20".  The caller frees. */
char *site_box_text(struct site_box box);

/* Returns the smallest box with the tables from..to of *ask, from 0. */
struct site_box site_ask_box(
    const struct site_ask *ask, size_t from, size_t to);

/* Frees what *ask owns. */
void site_ask_clear(struct site_ask *ask);

#endif

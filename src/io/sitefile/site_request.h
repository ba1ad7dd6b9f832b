/* A request to read files as a site, and the questions that they leave open.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_SITEFILE_SITE_REQUEST_H
#define TIPSPEED_IO_SITEFILE_SITE_REQUEST_H

#include <stdbool.h>
#include <stddef.h>

/* A box of cells on a sheet; lines and columns are counted from 1. */
struct site_box {
	int top, left, bottom, right;
};

/* The files [n] to read as one site, with the tip speed of the samples in each,
 * m/s (0: the sheet states it), and options, NULL or 0 if not given.  columns:
 * "1=sieve mm, 3=feed retained_g", by number from 1 (by line if the sieves are
 * in one row); samples: "S01=feed, S02=@70", by name; unnamed columns and
 * samples are ignored.  top: the size, mm, that all of a feed is assumed to
 * pass if not all passes its coarsest sieve.  range: "A3:F20".  decimal: '.' or
 * ','.  rotor: diameter, m.  parts: the samples are products to add to a site
 * and need no feed; site_rotor: that site's rotor diameter, m, for sheets that
 * state none.  feed: only the feed is read, which may be a single sample
 * without a role.  text: NULL, or the content of the only file, which is then
 * not opened; path is its name. */
struct site_request {
	size_t n;
	const char *const *path;
	const double *speed;
	const char *columns, *samples, *sheet, *range, *text;
	char decimal;
	double rotor, site_rotor, top;
	bool parts, feed;
};

/* The open questions: columns [n], with a guess at what each is, in the words
 * of columns=.  settle: the option that answers the question
 * ("columns=\"1=sieve mm, ..\"", "rotor_mm=DIAMETER"); NULL: no question was
 * open.  across: the numbers are those of lines.  by_sample: columns are
 * identified by their headings, which name samples, for samples=.  no_feed,
 * no_product: the files contain none.  tables: the entries are tables, not
 * columns, each with its title as head, its lines as values, and its cells as
 * box; first, last: the proposed ones, from 0.  further: the size in mm that
 * all of a feed may pass instead of the one in settle, or 0. */
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
	double further;
	bool across, by_sample, tables, no_feed, no_product;
};

/* Parses "A3:F20"; returns false for any other form. */
bool site_box_parse(const char *text, struct site_box *box);

/* Returns the box as "A3:F20".  The caller frees it. */
char *site_box_text(struct site_box box);

/* Returns the smallest box that contains tables from..to of *ask, counted from
 * 0. */
struct site_box site_box_around_tables(
    const struct site_ask *ask, size_t from, size_t to);

/* Frees the members of *ask. */
void site_ask_clear(struct site_ask *ask);

#endif

/* A request to read files as a site, and the questions that they leave open.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_SITEFILE_SITE_REQUEST_H
#define TIPSPEED_IO_SITEFILE_SITE_REQUEST_H

#include <stdbool.h>
#include <stddef.h>

/* A range of cells on a sheet; lines and columns are counted from 1. */
struct cell_range {
	int top, left, bottom, right;
};

/* The files [n] to read as one site, and options, which are NULL or 0 if not
 * given.  speed [n]: the speed of the samples in each file: tip speed, m/s; or
 * below 0: rpm; or 0: the sheet states it.  columns: "1=sieve mm, 3=feed
 * retained_g", by number from 1 (of lines if the sieves are in one line);
 * samples: "S01=feed, S02=@70", by name.  Columns and samples that are not
 * named there are not read.  range: "A3:F20".  decimal: '.' or ','.  rotor:
 * diameter, m.  top: the size, mm, that all of a feed passes, if not all passes
 * its coarsest sieve.  parts: the samples are products to add to a site, and
 * need no feed; site_rotor: that site's rotor diameter, m, for sheets that
 * state none.  feed: only the feed is read, which may be a single sample
 * without a role.  text: the content of the only file, which is then not
 * opened, though path still names it. */
struct site_request {
	size_t n;
	const char *const *path;
	const double *speed;
	const char *columns, *samples, *sheet, *range, *text;
	char decimal;
	double rotor, site_rotor, top;
	bool parts, feed;
};

/* An open question.  column [n]: the columns, each with a guess at what it is,
 * in the words of columns=; open: this guess is uncertain.  settle: the option
 * that answers the question ("columns=\"1=sieve mm, ..\"",
 * "rotor_mm=DIAMETER"), or NULL if no question was open.  across: the numbers
 * are those of lines.  by_sample: the answer is samples=, and head is the name
 * of each sample.  no_feed, no_product: the files contain none.  tables: column
 * [n] are tables instead, each with its title as head, its lines as values and
 * its cells as box; first, last: those that are proposed, from 0.  further:
 * another size, mm, that all of a feed may pass, larger than the one in settle;
 * or 0. */
struct site_ask {
	size_t n;
	struct site_ask_column {
		size_t number;
		char *head, *values, *guess;
		bool open;
		struct cell_range box;
	} * column;
	size_t first, last;
	char *settle;
	double further;
	bool across, by_sample, tables, no_feed, no_product;
};

/* Returns file i with the speed given for it, "cut.csv@70" or
 * "cut.csv@1650rpm".  The caller frees it. */
char *site_request_file_text(const struct site_request *q, size_t i);

/* Returns the options of a request as one would type them, " sheet=\"B\"
 * top=16".  The caller frees it. */
char *site_request_options_text(const struct site_request *q);

/* Parses "A3:F20".  Returns false for any other form. */
bool cell_range_parse(const char *text, struct cell_range *box);

/* Returns the range as "A3:F20".  The caller frees it. */
char *cell_range_text(struct cell_range box);

/* Returns the smallest range that contains the tables `from` to `to` of *ask,
 * counted from 0. */
struct cell_range cell_range_around_tables(
    const struct site_ask *ask, size_t from, size_t to);

/* Frees the members of *ask. */
void site_ask_clear(struct site_ask *ask);

#endif

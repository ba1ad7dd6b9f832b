/* The questions that a sheet leaves open.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_SITEFILE_SITE_ASK_H
#define TIPSPEED_IO_SITEFILE_SITE_ASK_H

#include "io/sitefile/site_column.h"
#include "io/sitefile/site_heading.h"
#include "io/sitefile/site_request.h"

/* What is open.  rotor: the rotor's diameter; stated: what the sheet says about
 * it; sieves: the unit of the sieves.  number: a cell whose sign may be decimal
 * or separate thousands; its text is NULL if there is none. */
struct open {
	bool rotor, sieves;
	struct heading_rotor stated;
	struct cell number;
	const struct table *other; /* a table that may be another site's */
	/* two tables in one: the first ends before row `end`, the second begins
	 * at row `again` */
	const struct table *twice;
	size_t end, again;
};

/* Notes the first number of the table whose sign is ambiguous, unless one has
 * been noted. */
void site_ask_find_ambiguous_number(struct open *open, const struct table *t);

/* Returns the samples of a table, "feed, product@69", the first ones if there
 * are more than `most`. */
char *site_ask_samples_of_table(
    const struct table *t, const struct columns *all, size_t most);

/* If a question is open, reports it as one fault, fills *ask with it and
 * returns true. */
bool site_ask_pending_question(const struct open *open,
    const struct site_request *request, struct table *const *table,
    size_t n_table, const struct columns *all, struct site_ask *ask);

/* Returns the size, mm, that all of a feed passes, if that need not be asked:
 * the next sieve above its coarsest one, if this passes 99.95 % or more, which
 * laboratories round to 100.0 %; else 0. */
double site_ask_find_known_top_size(const struct column *c);

/* Asks which size all of the feed passes, if less than 100 % passes its
 * coarsest sieve: adds a fault and, if it is the only one, fills *ask. */
void site_ask_top_size(const struct column *c,
    const struct site_request *request, struct site_ask *ask);

/* Reports a second feed for the same products, with a hint that keeps the
 * first. */
void site_ask_refuse_second_feed(const struct column *further,
    const struct columns *all, const struct site_request *request);

#endif

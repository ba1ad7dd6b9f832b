/* The questions that a sheet leaves open.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_SITEFILE_SITE_ASK_H
#define TIPSPEED_IO_SITEFILE_SITE_ASK_H

#include <stdint.h>

#include "io/sitefile/site_column.h"
#include "io/sitefile/site_request.h"

/* The open questions.  number: a cell whose sign could be decimal or separate
 * thousands; text NULL: none. */
struct open {
	bool rotor, sieves;
	struct cell number;
	const struct table *other; /* a table that may be another site's */
	const struct table *twice; /* two tables in one: the second begins at */
	size_t end, again;         /* row `again`; the first ends before
				    * `end` */
};

/* Notes the first number of the table with an open sign. */
void site_ask_find_ambiguous_number(struct open *open, const struct table *t);

/* If a question is open, reports it as one fault, copies it to *ask and returns
 * true. */
bool site_ask_pending_question(const struct open *open,
    const struct site_request *request, struct table *const *table,
    size_t n_table, const struct columns *all, struct site_ask *ask);

/* Returns the size, mm, that all of a feed passes if its coarsest sieve passes
 * 100.0 % when rounded as laboratories do: the next sieve up; 0 if more is
 * coarser. */
double site_ask_size_above_feed(const struct column *c);

/* If the coarsest sieve passes less than 100 % of the feed, asks which size all
 * of it passes: adds a fault and, if it is the only one, fills *ask. */
void site_ask_top_size(const struct column *c,
    const struct site_request *request, struct site_ask *ask);

/* Adds the fault of a further feed of the same products; its hint keeps the
 * first feed. */
void site_ask_refuse_second_feed(const struct column *further,
    const struct columns *all, const struct site_request *request);

#endif

/* The questions that a sheet leaves open, and their answers.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_SITEFILE_SITE_ASK_H
#define TIPSPEED_IO_SITEFILE_SITE_ASK_H

#include <stdint.h>

#include "io/sitefile/site_column.h"
#include "io/sitefile/site_request.h"

/* The columns that were named by hand [n].  others: some of them are columns of
 * samples; if only sieves are named, the samples keep their heads. */
struct names {
	size_t n, *number;
	char **text;
	bool others;
};

/* Reads "1=sieve um, 3=feed retained_g" (NULL: no column is named); notes the
 * column of the sieves in *range.  False with a usage error. */
bool names_read(struct names *names, const char *columns,
    struct layout_range *range, struct error *error);

/* Sets a table's headings to the names; returns the meanings of the heading of
 * its sieves, 0: none. */
uint64_t names_apply(const struct names *names, struct table *t);
void names_clear(struct names *names);

/* Reads "A3:F20"; NULL is the whole sheet. */
bool range_read(
    const char *text, struct layout_range *range, struct error *error);

/* The open questions.  number: a cell whose sign could be decimal or separate
 * thousands; text NULL: no such cell. */
struct open {
	bool rotor, sieves;
	struct cell number;
	const struct table *other; /* a table that may be another site's */
	const struct table *twice; /* two tables in one, the second from row */
	size_t end, again;         /* `again`, the first up to before `end` */
};

/* Notes the first number of the table whose sign is open. */
void site_ask_find_open_numbers(struct open *open, const struct table *t);

/* True if any question is open; it is then reported as one fault, and *ask
 * contains it. */
bool site_ask_open(const struct open *open, const struct site_request *request,
    struct table *const *table, size_t n_table, const struct columns *all,
    struct site_ask *ask, struct error_list *errors);

/* Asks which size the whole feed passes, if its coarsest sieve passes less than
 * 100 %: adds a fault, and fills *ask if it is the only fault. */
void site_ask_top(const struct column *c, const struct site_request *request,
    struct site_ask *ask);

/* Adds the fault of a further feed of the same products; its hint keeps the
 * first feed. */
void site_ask_one_feed(const struct column *further, const struct columns *all,
    const struct site_request *request);

#endif

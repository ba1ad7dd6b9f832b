/* What a sheet leaves open, as questions, and their answers.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_SITEFILE_SITE_ASK_H
#define TIPSPEED_IO_SITEFILE_SITE_ASK_H

#include <stdint.h>

#include "io/sitefile/site_column.h"
#include "io/sitefile/site_request.h"

/* The columns that were named by hand [n].  others: columns of samples are
 * some of them; where sieves alone are named, the samples keep their heads. */
struct names {
	size_t n, *number;
	char **text;
	bool others;
};

/* From "1=sieve um, 3=feed retained_g" (NULL: nothing is named); notes the
 * column of the sieves in *range.  False with a usage error. */
bool names_read(struct names *names, const char *columns,
    struct layout_range *range, struct error *error);

/* Sets a table's headings by them; returns the meanings of that of its sieves,
 * 0: none. */
uint64_t names_apply(const struct names *names, struct table *t);
void names_clear(struct names *names);

/* From "A3:F20"; NULL is everything. */
bool range_read(
    const char *text, struct layout_range *range, struct error *error);

/* What is open.  number: a cell whose sign could be decimal or separate
 * thousands; text NULL: there is none. */
struct open {
	bool rotor, sieves;
	struct cell number;
	const struct table *other; /* a table that may be another site's */
	const struct table *twice; /* two tables in one, the second from row */
	size_t end, again;         /* `again`, the first up to before `end` */
};

/* Notes numbers of the table whose sign is open. */
void open_numbers(struct open *open, const struct table *t);

/* Whether anything is open, which is then one fault, and is in *ask. */
bool open_ask(const struct open *open, const struct site_request *request,
    struct table *const *table, size_t n_table, const struct columns *all,
    struct site_ask *ask, struct error_list *errors);

/* Asks what size all of a feed passes, where its coarsest sieve passes less
 * than 100 %: a fault, in *ask where it is the only one. */
void open_top(const struct column *c, const struct site_request *request,
    struct site_ask *ask);

#endif

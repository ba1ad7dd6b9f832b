/* Mends: corrections that the user makes to a site whose sheet is wrong.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_CHECK_CORRECTION_H
#define TIPSPEED_CORE_CHECK_CORRECTION_H

#include <stdbool.h>
#include <stddef.h>

#include "base/error.h"
#include "core/psd/site.h"

enum mend_kind {
	MEND_READ,      /* a passing is replaced with `value` */
	MEND_OUT,       /* a passing is left out */
	MEND_SWAP_FEED, /* a product and its feed are swapped */
	MEND_UP,        /* a column moves up to the next coarser sieve */
	MEND_DOWN,      /* a column moves down to the next finer sieve */
	MEND_SWAP_RUNS, /* two products are swapped */
	MEND_SCALE,     /* the sieves of a column are multiplied by `value` */
	MEND_DROP       /* a run is left out */
};

/* A mend of one column.  run: 0 for a feed shared by all runs.  size: the sieve
 * of a passing, m.  value: the passing, 0..1, or the factor.  other: the run
 * whose product is swapped with this one's. */
struct mend {
	enum mend_kind kind;
	bool feed;
	size_t run, other;
	double size, value;
};

/* Returns the corrected site, with the mend in its provenance, or NULL with an
 * error if the result would not be a valid site: if passings rise on finer
 * sieves, not all of a feed passes its coarsest sieve, or a curve has fewer
 * than two sieves. */
struct site *site_with_mend(
    const struct site *site, const struct mend *mend, struct error *error);

/* Return the name of a column, "product@79", "feed", "product@79(2)", and the
 * mend in words, "product@79 at 2 mm: 69.1 read as 61.9".  The caller frees. */
char *mend_name_of_column(const struct site *site, bool feed, size_t run);
char *mend_description(const struct site *site, const struct mend *mend);

/* Finds the column with that name.  Returns false if there is none. */
bool mend_find_column_by_name(
    const struct site *site, const char *name, bool *feed, size_t *run);

#endif

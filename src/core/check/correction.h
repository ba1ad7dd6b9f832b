/* Corrections of a site whose sheet is wrong, which the user chooses (mends).
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_CHECK_CORRECTION_H
#define TIPSPEED_CORE_CHECK_CORRECTION_H

#include <stdbool.h>
#include <stddef.h>

#include "base/error.h"
#include "core/psd/site.h"

enum mend_kind {
	MEND_READ,  /* a passing is read as `value` */
	MEND_OUT,   /* a passing is left out */
	MEND_SWAP,  /* a product and its feed change places */
	MEND_UP,    /* a column belongs one sieve coarser */
	MEND_DOWN,  /* or finer */
	MEND_WITH,  /* two products change places */
	MEND_SCALE, /* the sieves of a column are `value` times as large */
	MEND_DROP   /* a run is left out */
};

/* A mend of one column.  run: 0 for a feed that all runs share.  size: the
 * sieve of a passing, m.  value: a passing, 0..1, or a factor.  other: the run
 * with which a product changes places. */
struct mend {
	enum mend_kind kind;
	bool feed;
	size_t run, other;
	double size, value;
};

/* Returns the corrected site, with the mend in its provenance; or NULL with an
 * error where the result would not be a site: passings that rise on finer
 * sieves, a feed that does not all pass its coarsest sieve, a curve of fewer
 * than two sieves. */
struct site *mend_site(
    const struct site *site, const struct mend *mend, struct error *error);

/* Return the name of a column, "product@79", "feed", "product@79(2)", and the
 * mend in words, "product@79 at 2 mm: 69.1 read as 61.9".  The caller frees. */
char *mend_column(const struct site *site, bool feed, size_t run);
char *mend_words(const struct site *site, const struct mend *mend);

/* Finds the column of that name; false where there is none. */
bool mend_find_column(
    const struct site *site, const char *name, bool *feed, size_t *run);

#endif

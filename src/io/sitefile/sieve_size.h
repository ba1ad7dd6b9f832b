/* The opening of a sieve from a cell: "22,4", "63 um", "No. 4", "pan".
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_SITEFILE_SIEVE_SIZE_H
#define TIPSPEED_IO_SITEFILE_SIEVE_SIZE_H

#include <stdint.h>

#include "io/cells/sheet.h"
#include "io/sitefile/sieve_names.h"

/* What the head of the sieves tells: mm in the unit of their numbers, 0 where
 * it tells none, and the series of their names. */
struct sieve_unit {
	double mm;
	enum sieve_series series;
};

/* From 1 m to 1 um: what is beyond is no size in phi. */
enum { SIEVE_MOST_PHI = 10 };

enum sieve_kind { SIEVE_IS_NONE, SIEVE_IS_PAN, SIEVE_IS_SIZE };

/* The unit that the words of a head tell, see vocabulary.h. */
struct sieve_unit sieve_unit_of(uint64_t means);

/* What a cell is, and of SIEVE_IS_SIZE its opening, mm to 9 decimals: NAN where
 * it has the form of a name that no sieve has.  Numbers without a unit are
 * taken for mm where the head tells none. */
enum sieve_kind sieve_size(const struct sheet *sheet, struct cell cell,
    struct sieve_unit unit, double *mm);

/* Whether it is a class between two sieves, "11,2/16", or above one, "> 22,4",
 * which sieve_size gives the lower one of where the unit is a length. */
bool sieve_size_is_class(const struct sheet *sheet, struct cell cell);

#endif

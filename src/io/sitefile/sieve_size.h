/* Sieves: their sizes and names, "22,4", "63 um", "#4", "BS 7 mesh", "3/8 in",
 * "pan".
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_SITEFILE_SIEVE_SIZE_H
#define TIPSPEED_IO_SITEFILE_SIEVE_SIZE_H

#include <stdint.h>

#include "io/cells/sheet.h"

/* Whose names they are.  SIEVE_MESH: mesh numbers of an unknown series. */
enum sieve_series {
	SIEVE_NONE,
	SIEVE_ASTM,
	SIEVE_INCH,
	SIEVE_TYLER,
	SIEVE_BS,
	SIEVE_MESH,
	SIEVE_PHI /* -log2 of mm, and no names */
};

/* The series that the name itself states; SIEVE_NONE where it is no name. */
enum sieve_series sieve_names_series(const char *text);

/* The opening in mm of the sieve so named; 0 where the text is no name of a
 * sieve, and NAN where it has the form of one but there is no such sieve, or
 * where a mesh number does not state its series.  It understands the numbers of
 * ASTM E11 after #, No.  or Nº, its inches, as 1/2 in, 1 1/2 inch or 3/8", and
 * mesh numbers with Tyler or BS.  head: the series of names that are a number
 * alone, from the heading of their column. */
double sieve_names_mm(const char *text, enum sieve_series head);

/* Whether it is a number of ASTM E11, of a sieve or not: not inches. */
bool sieve_names_is_number(const char *text);

/* Whether a size is that of a sieve of ISO 565, EN 933-2 or ASTM E11, to 1 %;
 * mm. */
bool sieve_names_standard(double mm);

/* The next coarser sieve of those that plants have, mm: of EN 933, or in inches
 * and numbers of ASTM E11.  Above all of them, the next step of the series. */
double sieve_names_coarser(double mm, bool astm);

/* Of a name that no sieve has: "1/4 in (6.3 mm) and No. 3 1/2 (5.6 mm)", the
 * next coarser and the next finer one.  The caller frees. */
char *sieve_names_nearest(const char *text);

/* The unit in the heading of sieves: mm in the unit of their numbers, 0 where
 * it has none, and the series of their names. */
struct sieve_unit {
	double mm;
	enum sieve_series series;
};

/* From 1 m to 1 um: numbers beyond are no sizes in phi. */
enum { SIEVE_MOST_PHI = 10 };

enum sieve_kind { SIEVE_IS_NONE, SIEVE_IS_PAN, SIEVE_IS_SIZE };

/* The unit in the words of a heading, see lexicon.h. */
struct sieve_unit sieve_unit_of(uint64_t means);

/* What a cell is, and of SIEVE_IS_SIZE its opening, mm to 9 decimals: NAN where
 * it has the form of a name that no sieve has.  Numbers without a unit are
 * taken for mm where the heading has none. */
enum sieve_kind sieve_size(const struct sheet *sheet, struct cell cell,
    struct sieve_unit unit, double *mm);

/* Whether it is a class between two sieves, "11,2/16", or above one, "> 22,4",
 * which sieve_size gives the lower one of where the unit is a length. */
bool sieve_size_is_class(const struct sheet *sheet, struct cell cell);

#endif

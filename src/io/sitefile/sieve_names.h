/* Sieves that have a name instead of a size: "#4", "BS 7 mesh", "3/8 in".
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_SITEFILE_SIEVE_NAMES_H
#define TIPSPEED_IO_SITEFILE_SIEVE_NAMES_H

#include <stdbool.h>

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

/* The series that the name itself tells; SIEVE_NONE where it is no name. */
enum sieve_series sieve_names_series(const char *text);

/* The opening in mm of the sieve so named; 0 where the text is no name of a
 * sieve, and NAN where it has the form of one but there is no such sieve, or
 * where a mesh number does not say of which series it is.  Understood are the
 * numbers of ASTM E11 after #, No. or Nº, its inches, as 1/2 in, 1 1/2 inch or
 * 3/8", and mesh numbers with Tyler or BS.  head: the series of names that are
 * a number alone, which the head of their column tells. */
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

#endif

/* Sieves that have a name instead of a size: "#4", "No. 200", "3/8 in".
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_SIEVE_NAMES_H
#define TIPSPEED_IO_SIEVE_NAMES_H

#include <stdbool.h>

/* The opening in mm of the sieve so named; 0 where the text is no name of a
 * sieve, and NAN where it has the form of one but there is no such sieve.
 * Understood are the numbers of ASTM E11 after #, No. or Nº, with or without
 * spaces, and its inches, as 1/2 in, 1 1/2 inch or 3/8". */
double sieve_names_mm(const char *text);

/* Whether it is such a number, of a sieve or not: not inches, not a size. */
bool sieve_names_is_number(const char *text);

/* Of a name that no sieve has: "1/4 in (6.3 mm) and No. 3 1/2 (5.6 mm)", the
 * next coarser and the next finer one.  The caller frees. */
char *sieve_names_nearest(const char *text);

#endif

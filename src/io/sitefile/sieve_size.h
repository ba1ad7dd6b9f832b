/* Sieves: their sizes and names, "22,4", "63 um", "#4", "BS 7 mesh", "3/8 in",
 * "pan".
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_SITEFILE_SIEVE_SIZE_H
#define TIPSPEED_IO_SITEFILE_SIEVE_SIZE_H

#include <stdint.h>

#include "io/cells/sheet.h"

/* The series to which a sieve's name belongs.  SIEVE_MESH: mesh numbers of an
 * unknown series. */
enum sieve_series {
	SIEVE_NONE,
	SIEVE_ASTM,
	SIEVE_INCH,
	SIEVE_TYLER,
	SIEVE_BS,
	SIEVE_MESH,
	SIEVE_PHI /* -log2 of mm, without names */
};

/* Returns the series that a name itself states, or SIEVE_NONE if the text is
 * not a name. */
enum sieve_series sieve_name_series(const char *text);

/* Returns the opening, mm, of the sieve with this name; 0 if the text is not a
 * sieve name; NAN if it has the form of one but there is no such sieve, or if a
 * mesh number does not state its series.  Reads ASTM E11 numbers after #, No.
 * or Nº, inches such as 1/2 in, 1 1/2 inch or 3/8", and mesh numbers with Tyler
 * or BS.  head: the series of bare numbers, from the heading of the column. */
double sieve_name_mm(const char *text, enum sieve_series head);

/* True if a size in mm is within 1 % of a sieve in ISO 565, EN 933-2 or ASTM
 * E11. */
bool sieve_is_standard(double mm);

/* Returns the next coarser sieve, mm, of those that plants have: the sieves of
 * EN 933, or the inch sizes and numbers of ASTM E11.  Above them all, it
 * returns the next step of the series. */
double sieve_next_coarser(double mm, bool astm);

/* For a name that no sieve has, returns the next coarser and finer sieves: "1/4
 * in (6.3 mm) and No. 3 1/2 (5.6 mm)".  The caller frees the text. */
char *sieve_nearest_names(const char *text);

/* The unit in the heading of the sieves.  mm: unit of the numbers, in mm, or 0
 * if not stated; series: that of the names. */
struct sieve_unit {
	double mm;
	enum sieve_series series;
};

/* Sizes in phi range from 1 m to 1 um; numbers beyond are not sizes. */
enum { SIEVE_MOST_PHI = 10 };

enum sieve_kind { SIEVE_IS_NONE, SIEVE_IS_PAN, SIEVE_IS_SIZE };

/* Returns the unit that the words of a heading mean, see lexicon.h. */
struct sieve_unit sieve_unit_from_words(uint64_t means);

/* Returns the kind of a cell and, for SIEVE_IS_SIZE, its opening, mm to 9
 * decimals, or NAN if it has the form of a name but there is no such sieve.
 * Numbers without a unit are in mm unless the heading states another unit. */
enum sieve_kind sieve_read_size(const struct sheet *sheet, struct cell cell,
    struct sieve_unit unit, double *mm);

/* True if a cell is a class between two sieves, "11,2/16", or above one, ">
 * 22,4".  sieve_read_size then returns the lower sieve if the unit is a length.
 */
bool sieve_cell_is_class(const struct sheet *sheet, struct cell cell);

/* Returns the upper sieve of a class between two, mm, which all of the class
 * passes; 0 if the cell is none. */
double sieve_upper_mm_of_class(
    const struct sheet *sheet, struct cell cell, struct sieve_unit unit);

#endif

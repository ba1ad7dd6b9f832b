/* The sizes and names of sieves: "22,4", "63 um", "#4", "BS 7 mesh", "3/8 in",
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
	SIEVE_PHI /* sizes are -log2 of mm; no names */
};

/* Returns the series that the name of a sieve states, or SIEVE_NONE if the text
 * is not such a name. */
enum sieve_series sieve_series_of_name(const char *text);

/* Returns the opening, mm, of the sieve with this name: an ASTM E11 number
 * after #, No. or Nº, inches such as 1/2 in, 1 1/2 inch or 3/8", or a mesh
 * number with Tyler or BS.  Returns 0 if the text is not a sieve name, and NAN
 * if it has the form of one but there is no such sieve, or two.  head: the
 * series of numbers without a name, from the heading of the column. */
double sieve_mm_of_name(const char *text, enum sieve_series head);

/* True if a size in mm is within 1 % of a sieve in ISO 565, EN 933-2 or ASTM
 * E11. */
bool sieve_is_standard(double mm);

/* Returns the next coarser sieve, mm, of the sieves that plants have: those of
 * EN 933 or, if astm, the inch sizes and numbers of ASTM E11.  For a size above
 * all of them, returns a rounded size that is about sqrt(2) coarser. */
double sieve_next_coarser(double mm, bool astm);

/* Returns the next coarser and the next finer sieve for a name that no sieve
 * has: "1/4 in (6.3 mm) and No. 3 1/2 (5.6 mm)".  The caller frees the text. */
char *sieve_nearest_names(const char *text);

/* The unit in the heading of the sieves.  mm: the length of the unit, mm, or 0
 * if not stated; series: the series of the names. */
struct sieve_unit {
	double mm;
	enum sieve_series series;
};

/* Sizes in phi are from -10 (1 m) to 10 (1 um). */
enum { SIEVE_MOST_PHI = 10 };

enum sieve_kind { SIEVE_IS_NONE, SIEVE_IS_PAN, SIEVE_IS_SIZE };

/* Returns the unit that the words of a heading state (means: see lexicon.h). */
struct sieve_unit sieve_unit_from_words(uint64_t means);

/* Returns what a cell is.  For SIEVE_IS_SIZE, *mm gets the opening, rounded to
 * 9 decimals, or NAN if the cell has the form of a name but there is no such
 * sieve.  Numbers without a unit are in mm unless the heading states another
 * unit. */
enum sieve_kind sieve_read_size(const struct sheet *sheet, struct cell cell,
    struct sieve_unit unit, double *mm);

/* True if a cell is a class between two sieves, "11,2/16", or above one, ">
 * 22,4".  For such a cell sieve_read_size returns the lower sieve, if the unit
 * is a length. */
bool sieve_cell_is_class(const struct sheet *sheet, struct cell cell);

/* Returns the upper sieve, mm, of a class between two sieves, or 0 if the cell
 * is not such a class. */
double sieve_upper_mm_of_class_cell(
    const struct sheet *sheet, struct cell cell, struct sieve_unit unit);

#endif

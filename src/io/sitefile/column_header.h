/* The heading of a column: its words and numbers.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_SITEFILE_COLUMN_HEADER_H
#define TIPSPEED_IO_SITEFILE_COLUMN_HEADER_H

#include <stdint.h>
#include <stdbool.h>
#include <stddef.h>

enum speed_unit {
	SPEED_NO_UNIT,
	SPEED_MPS,
	SPEED_KMH,
	SPEED_FT_MIN,
	SPEED_FT_S,
	SPEED_RPM
};

/* means: the meanings of all words, see lexicon.h.  unknown: the number of
 * words without a meaning.  unit: that of a speed, with or without a number.
 * speed: m/s, 0 if not stated; rpm: 0 if not stated.  number: the first of
 * n_number numbers without a unit.  several: two speeds are stated.  spread:
 * the speed is in a cell to the left.  range: it contains a range of sizes (0-4
 * mm, 53-D-63), which is the name of a sample. */
enum { HEAD_NUMBERS = 4 };
struct head {
	uint64_t means;
	size_t unknown, n_number;
	enum speed_unit unit;
	double speed, rpm, number[HEAD_NUMBERS];
	bool several, spread, range;
};

/* Parses one cell of a heading. */
struct head heading_parse(const char *text);

/* Parses the name of a sheet or file, in which / cannot be: of "cut_60ms" and
 * "VSI 60 m-s" the speed is 60 m/s. */
struct head heading_parse_name(const char *name);

/* True if a heading states a speed, in whatever unit. */
bool heading_has_speed(const struct head *head);

/* Returns the unit of speed that a heading states, if only by a word for turns;
 * SPEED_NO_UNIT if it states none. */
enum speed_unit heading_speed_unit(const struct head *head);

/* Returns the text, folded by text_fold_case_and_accents, without speeds and
 * their units.  The caller frees it. */
char *heading_without_speeds(const char *text);

/* True if a byte is a letter or part of one; all beyond ASCII are. */
bool text_is_letter_byte(char c);

/* Converts a speed to m/s.  SPEED_RPM needs the rotor's diameter, m. */
double speed_in_unit_to_mps(double number, enum speed_unit unit, double rotor);

#endif

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

/* What a heading says.  means: the meanings of all its words, see lexicon.h.
 * unknown: the number of words without a meaning.  unit: the unit of speed,
 * with or without a number.  speed, rpm: m/s and rpm, or 0 if not stated.
 * number [n_number]: the numbers without a unit, at most HEAD_NUMBERS of them.
 * several: it states two speeds.  spread: the speed comes from a cell to the
 * left.  range: it contains a range of sizes (0-4 mm, 53-D-63), which is a name
 * of the sample. */
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

/* Parses the name of a sheet or file.  Such names cannot contain a /, so
 * "cut_60ms" and "VSI 60 m-s" state 60 m/s. */
struct head heading_parse_file_name(const char *name);

/* True if a heading states a speed, in any unit. */
bool heading_has_speed(const struct head *head);

/* Returns the unit of speed that a heading states.  Without one, a word for the
 * speed of a rotor, such as "drehzahl", counts as SPEED_RPM; otherwise returns
 * SPEED_NO_UNIT. */
enum speed_unit heading_speed_unit(const struct head *head);

/* True if the rpm under such a heading are those of a motor, a screen or a
 * feeder rather than of the rotor, if the m/s are known. */
bool heading_is_of_other_part(const struct head *head);

/* Returns the text without speeds and their units, folded by
 * text_fold_case_and_accents.  The caller frees it. */
char *heading_without_speeds(const char *text);

/* True if two texts contain different names of machines, days and the like:
 * each has some that the other does not have. */
bool heading_names_differ(const char *a, const char *b);

/* True if a byte is a letter, or beyond ASCII and so taken for part of one. */
bool text_is_letter_byte(char c);

/* Converts a speed to m/s.  SPEED_RPM needs the rotor's diameter, m. */
double speed_in_unit_to_mps(double number, enum speed_unit unit, double rotor);

#endif

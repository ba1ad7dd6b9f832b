/* Marks for measured points, each with its own shape.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_PLOT_MARKS_H
#define TIPSPEED_PLOT_MARKS_H

#include <stdbool.h>

/* The shape for an ASCII character.  sign: code point in a cell.  On paper the
 * shape has `sides` sides, with the first corner at `turn` of a full turn.
 * hollow: for a held-out run. */
struct mark {
	char code;
	unsigned sign;
	int sides;
	double turn;
	bool hollow;
};

/* Returns the mark of a character, or NULL. */
const struct mark *mark_of_character(char code);

/* Returns character i of the full or hollow marks, which repeat cyclically. */
char mark_character(unsigned i, bool hollow);

#endif

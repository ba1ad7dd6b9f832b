/* Marks of what was measured, each with a shape of its own.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_PLOT_MARKS_H
#define TIPSPEED_PLOT_MARKS_H

#include <stdbool.h>

/* The shape for an ASCII character.  sign: in a cell.  On paper the shape has
 * `sides` sides, and its first corner is at the part `turn` of a full turn.
 * hollow: of a run that was held out. */
struct mark {
	char code;
	unsigned sign;
	int sides;
	double turn;
	bool hollow;
};

/* Returns the mark of a character, or NULL. */
const struct mark *mark_of(char code);

/* Returns character i of the full marks, or of the hollow ones, which take
 * turns. */
char mark_code(unsigned i, bool hollow);

#endif

/* A table of marks: as dots, quarters of a cell and polygons.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "plot/marks.h"

#include <stddef.h>

/* The full ones, then the same hollow; a row is read from its left, so that
 * 0272 is a cross of five dots. */
static const struct mark MARKS[] = {{'+', 0272, 15, 16, 0, false},
    {'x', 0777, 9, 4, 0.125, false}, {'v', 0277, 3, 3, 0.25, false},
    {'^', 0772, 12, 3, 0.75, false}, {'*', 0525, 5, 4, 0, false},
    {'&', 0222, 6, 6, 0, false}, {'o', 0252, 1, 16, 0, true},
    {'O', 0757, 2, 4, 0.125, true}, {'Q', 0255, 4, 3, 0.25, true},
    {'D', 0552, 8, 3, 0.75, true}, {'C', 0505, 7, 4, 0, true},
    {'0', 0202, 14, 6, 0, true}};
enum { ALL = sizeof MARKS / sizeof MARKS[0], EACH = ALL / 2 };

const struct mark *
mark_of(char code)
{
	for (size_t i = 0; i < ALL; i++)
		if (MARKS[i].code == code)
			return &MARKS[i];
	return NULL;
}

char
mark_code(unsigned i, bool hollow)
{
	return MARKS[i % EACH + (hollow ? EACH : 0)].code;
}

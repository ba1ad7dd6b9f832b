/* A table of marks, as characters and as polygons.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "plot/marks.h"

#include <stddef.h>

/* The full ones, then the same hollow. */
static const struct mark MARKS[] = {{'+', 0x25CF, 16, 0, false},
    {'x', 0x25A0, 4, 0.125, false}, {'v', 0x25BC, 3, 0.25, false},
    {'^', 0x25B2, 3, 0.75, false}, {'*', 0x25C6, 4, 0, false},
    {'&', 0x2605, 6, 0, false}, {'o', 0x25CB, 16, 0, true},
    {'O', 0x25A1, 4, 0.125, true}, {'Q', 0x25BD, 3, 0.25, true},
    {'D', 0x25B3, 3, 0.75, true}, {'C', 0x25C7, 4, 0, true},
    {'0', 0x2606, 6, 0, true}};
enum { ALL = sizeof MARKS / sizeof MARKS[0], EACH = ALL / 2 };

const struct mark *
mark_of_character(char code)
{
	for (size_t i = 0; i < ALL; i++)
		if (MARKS[i].code == code)
			return &MARKS[i];
	return NULL;
}

char
mark_character(unsigned i, bool hollow)
{
	return MARKS[i % EACH + (hollow ? EACH : 0)].code;
}

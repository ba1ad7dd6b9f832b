/* One table of colours for terminals and images.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "plot/palette.h"

/* Returns the dark version of one of 16 colours, or -1, the text colour,
 * instead of yellow. */
static int
dark_version_of_colour(int colour)
{
	enum { BRIGHT = 8, YELLOW = 3 };
	int dark = colour >= BRIGHT ? colour - BRIGHT : colour;
	return dark == YELLOW ? -1 : dark;
}

/* With few colours, series in the text colour are told apart by their shape.
 * No bright black, which some terminals do not show, and no dark blue, which
 * the Linux console hardly shows on black. */
int
palette_colour_of_series(enum series series, int depth, enum theme theme)
{
	static const struct {
		signed char of8, of16;
		short of256[THEMES];
	} COLOURS[SERIES_COUNT] = {
	    [SERIES_TEXT] = {-1, -1, {-1, -1, -1}},
	    [SERIES_FEED] = {-1, -1, {243, 248, 238}},
	    [SERIES_MEASURED_1] = {12, 12, {32, 111, 21}},
	    [SERIES_MEASURED_2] = {2, 10, {72, 78, 29}},
	    [SERIES_MEASURED_3] = {6, 14, {75, 195, 31}},
	    [SERIES_MEASURED_4] = {-1, -1, {103, 189, 17}},
	    [SERIES_KIND_1] = {-1, -1, {34, 31, 30}},
	    [SERIES_KIND_2] = {-1, -1, {161, 197, 99}},
	    [SERIES_KIND_3] = {-1, -1, {109, 99, 53}},
	    [SERIES_KIND_4] = {-1, -1, {94, 136, 19}},
	    [SERIES_PREDICTED] = {1, 9, {202, 214, 88}},
	    [SERIES_OTHER] = {5, 13, {165, 206, 91}},
	    [SERIES_BREAK] = {3, 3, {143, 229, 94}},
	    [SERIES_CROSSHAIR] = {-1, -1, {-1, -1, -1}},
	    [SERIES_GREEN] = {2, 2, {34, 40, 28}},
	    [SERIES_AMBER] = {3, 11, {172, 220, 130}},
	    [SERIES_RED] = {1, 1, {160, 203, 124}},
	};
	int few = depth < 16 ? COLOURS[series].of8 : COLOURS[series].of16;
	return depth <= 0             ? -1
	       : depth >= 256         ? COLOURS[series].of256[theme]
	       : theme == THEME_LIGHT ? dark_version_of_colour(few)
				      : few;
}

unsigned
palette_colour_to_rgb(int colour)
{
	enum { CUBE = 16, GREYS = 232 };
	static const unsigned FIRST[CUBE] = {0x000000, 0xCD3131, 0x0DBC79,
	    0xCDCD00, 0x3B78FF, 0xBC3FBC, 0x11A8CD, 0xE5E5E5, 0x666666,
	    0xF14C4C, 0x23D18B, 0xF5F543, 0x61A2FF, 0xD670D6, 0x29B8DB,
	    0xFFFFFF};
	static const unsigned LEVEL[6] = {0, 95, 135, 175, 215, 255};
	if (colour < CUBE)
		return FIRST[colour];
	unsigned at = (unsigned)colour - CUBE;
	if (colour >= GREYS)
		return 0x010101U * (8 + 10 * ((unsigned)colour - GREYS));
	return LEVEL[at / 36] << 16 | LEVEL[at / 6 % 6] << 8 | LEVEL[at % 6];
}

unsigned
palette_series_rgb_on_white(enum series series, enum theme theme)
{
	int colour = palette_colour_of_series(
	    series, 256, theme == THEME_NORMAL ? THEME_NORMAL : THEME_LIGHT);
	return colour < 0 ? 0x000000 : palette_colour_to_rgb(colour);
}

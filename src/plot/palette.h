/* All colours on the screen, at the prompt and in images, by their meaning.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_PLOT_PALETTE_H
#define TIPSPEED_PLOT_PALETTE_H

/* The meaning of something drawn, which decides its colour.  Runs at several
 * speeds have the colours MEASURED in turn, the same in every plot.
 * Quantities, rocks, streams and others that are not runs have the colours KIND
 * in turn. */
enum series {
	SERIES_TEXT, /* axes, labels, legend */
	SERIES_FEED, /* and other things in the background */
	SERIES_MEASURED_1,
	SERIES_MEASURED_2,
	SERIES_MEASURED_3,
	SERIES_MEASURED_4,
	SERIES_KIND_1,
	SERIES_KIND_2,
	SERIES_KIND_3,
	SERIES_KIND_4,
	SERIES_PREDICTED,
	SERIES_OTHER, /* a second prediction */
	SERIES_BREAK, /* a limit across the plot */
	SERIES_CROSSHAIR,
	SERIES_GREEN, /* lights, beside their words */
	SERIES_AMBER,
	SERIES_RED,
	SERIES_COUNT
};

/* THEME_NORMAL: colours for any background.  THEME_DARK, THEME_LIGHT: high
 * contrast on a dark or a light background, without faint colours. */
enum theme { THEME_NORMAL, THEME_DARK, THEME_LIGHT, THEMES };

/* Returns the number of a series' colour at a depth of 0 (no colour), 8, 16 or
 * 256 colours; -1 for the text colour.  At depth 256 the colours can be told
 * apart even with red-green blindness (tests/unit/test_palette.c), and nothing
 * is marked by colour alone.  Of 16 colours, those from 8 up are bright; with 8
 * colours, such a number means bold. */
int palette_colour_of_series(enum series series, int depth, enum theme theme);

/* Returns 0xRRGGBB for a colour number, as in xterm. */
unsigned palette_colour_to_rgb(int colour);

/* Returns 0xRRGGBB for a series on white paper: its colour at depth 256 or, for
 * high contrast, that of THEME_LIGHT. */
unsigned palette_series_rgb_on_white(enum series series, enum theme theme);

#endif

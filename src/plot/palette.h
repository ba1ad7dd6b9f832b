/* All colours, of the screen, the prompt and pictures, by their meaning.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_PLOT_PALETTE_H
#define TIPSPEED_PLOT_PALETTE_H

/* What a drawn thing belongs to, which decides its colour.  Runs of several
 * speeds take turns in the measured ones, each the same in every plot;
 * quantities, rocks, streams and others that are not runs take turns in the
 * colours of kinds. */
enum series {
	SERIES_TEXT, /* axes, labels, legend */
	SERIES_FEED, /* and what else lies behind */
	SERIES_MEASURED_1,
	SERIES_MEASURED_2,
	SERIES_MEASURED_3,
	SERIES_MEASURED_4,
	SERIES_KIND_1,
	SERIES_KIND_2,
	SERIES_KIND_3,
	SERIES_KIND_4,
	SERIES_PREDICTED,
	SERIES_OTHER, /* a second prediction, beside the first */
	SERIES_BAND,
	SERIES_BREAK, /* a limit across the plot */
	SERIES_CROSSHAIR,
	SERIES_GREEN, /* lights, beside their words */
	SERIES_AMBER,
	SERIES_RED,
	SERIES_COUNT
};

/* Colours for any background; with high contrast for a dark or a light one,
 * without faint ones. */
enum theme { THEME_NORMAL, THEME_DARK, THEME_LIGHT, THEMES };

/* Depth of colour: 0 (none), 8, 16 or 256.  Number of the colour of a series in
 * it, or -1 for that of the text; told apart with red-green blindness where
 * there are 256 (tests/unit/test_palette.c), and never the only mark.  Of 16
 * those from 8 on are bright, which among eight is bold. */
int palette_colour(enum series series, int depth, enum theme theme);

/* That of the shade behind a series: each has its own. */
enum series palette_tint(enum series series);

/* 0xRRGGBB of a colour by its number, as xterm has it. */
unsigned palette_rgb(int colour);

/* Of a series on white paper: that of 256. */
unsigned palette_ink(enum series series, enum theme theme);

#endif

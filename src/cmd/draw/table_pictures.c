/* Commands that draw, as rows of the command table.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/lang/rows.h"
#include "cmd/lang/table.h"

#include "cmd/draw/plot_request.h"
#include "cmd/session/screen_pages.h"

#define WHAT_OPTIONS                                                        \
	{SPEED(speed), "tip speed; default: that last asked about"},        \
	    {SPEED(other), "another speed for comparison"},                 \
	    {SPEED(other_feed), "psd: with other=, the feed of this speed", \
		.needs = "other=79"},                                       \
	    {TEXT(beside), "SITE", "",                                      \
		"psd: with the product of this site, or pinned"},           \
	    {TEXT(site), "SITE", "",                                        \
		"a loaded site, or pinned, instead of the one in use"},     \
	    {NUMBERS(speeds), "m/s", 1, SITE_FASTEST, NULL, "",             \
		"sweep, response: which; runs: added ones"},                \
	    {OFF_ON(band), "off", "psd: shade the uncertainty band"},       \
	    {TEXT(of), NULL, "",                                            \
		"response: quantities, such as passing 2,P50,0/4"},         \
	    {TEXT(limits), NULL, "",                                        \
		"response: conditions, such as passing 2 = 40..50"},        \
	    {WHOLE(generation), "", 0, 1000000, NULL, "0",                  \
		"generation of the search; 0: its end"},                    \
	    {TEXT(param), "PARAMETER", "",                                  \
		"profile: the parameter; default e0_min"},                  \
	    {NUMBER(at), "mm", 1e-6, 1e4, NULL, "",                         \
		"psd: line at this size, with passings"},                   \
	{                                                                   \
		NUMBER(level), "%", 0, 100, NULL, "50",                     \
		    "psd with at=: sizes at this passing", .needs = "at=2"  \
	}

const struct command TABLE_PICTURES[] = {
    {.name = "plot",
	.others = {"describe"},
	.brief = "draw a plot",
	.operands = {"KIND", {PLOT_KINDS}, 1, 1},
	.bare = "speed",
	.flags = COMMAND_DRAWS | COMMAND_DURING_SEARCH,
	.option = OPTION_LIST(WHAT_OPTIONS,
	    {NUMBER(width), "columns", 1, 1000, NULL, "",
		"default: that of the screen, at most 100"},
	    {NUMBER(height), "rows", 1, 1000, NULL, "",
		"default: that of the screen, at most 24"},
	    {CHOICE(charset), "auto ascii quadrants braille", "auto",
		"characters"}),
	.shared = {SHARED_RPM, SHARED_FEED, SHARED_MACHINE, SHARED_CUT},
	.text = "psd: feed, measured and predicted products; runs: every "
		"run, measured and by the model (dashed); parity: P20, P50, "
		"P80 predicted against measured; search: candidates of a "
		"search; convergence: the best and median; spread: where "
		"they lie within the bounds; residuals: predicted minus "
		"measured; selection: what share breaks (Eq 3); appearance: "
		"into what sizes (Eq 1); map: materials and loaded sites; "
		"sweep: products at several speeds; response: quantities "
		"against the tip speed; profile: the data on a parameter; "
		"correlation: about pairs; drift: control charts; energy: "
		"collision energies. > FILE.svg, .png or .pdf draws a "
		"figure, 'set figure_mm' wide.",
	.more =
	    "runs predicts each from its own feed, with speeds= also at speeds "
	    "that were not measured; parity has the held-out speeds of all "
	    "loaded sites. search shows how far the candidates of a generation "
	    "lie from each passing that is fitted, as a bar from the 10th to "
	    "the 90th percentile, the best as a mark, and the sampling noise; "
	    "convergence the best and the median candidate, in points RMS; "
	    "spread the candidates within the bounds of each parameter. "
	    "selection is how much of each size breaks, appearance the sizes "
	    "it breaks into. map is by rock type. response has the measured "
	    "values, the training speeds and, with limits=, the speeds that "
	    "meet them. profile shows one parameter, by its draws and by the "
	    "misfit with the others refitted; correlation the draws of all. "
	    "drift shows the charts of the command drift. With cut=, psd, "
	    "sweep and response show a screened fraction. Marks and dashes "
	    "distinguish the lines, with and without colour. charset=auto "
	    "draws with braille dots on a UTF-8 terminal, otherwise with ASCII "
	    "characters. A figure has the same ticks and lines, and letters of "
	    "6 to 11 points. 'set figure_mm 85' makes all figures as wide as "
	    "a column of a journal, 170 as wide as its page; below 209 the "
	    "legend is below the plot. width= and height= are those of text. "
	    "> FILE.csv and .json get the numbers, .txt the text.",
	.example = "load data/sites/tierp.csv\n"
		   "params set f_mat=2.18 e0_min=16.74 alpha=0.96\n"
		   "plot psd speed=74 at=2",
	.run = cmd_plot},
    {.name = "describe",
	.brief = "describe a plot in sentences",
	.operands = {"KIND", {PLOT_KINDS}, 1, 1},
	.bare = "speed",
	.flags = COMMAND_DURING_SEARCH,
	.option = OPTION_LIST(WHAT_OPTIONS,
	    {CHOICE(as), "words", "words", "for plot: words, no picture"}),
	.shared = {SHARED_RPM, SHARED_FEED, SHARED_MACHINE, SHARED_CUT},
	.text =
	    "Does the same as plot with as=words, for example plot psd "
	    "as=words: describes what plot would draw, for users of screen "
	    "readers: the axes, where each curve begins and ends and its P20, "
	    "P50 and P80, where curves differ most, the break size, and the "
	    "provenance of the data. The kinds and options are those of plot.",
	.example = "load data/sites/tierp.csv\n"
		   "params set f_mat=2.18 e0_min=16.74 alpha=0.96\n"
		   "describe psd speed=74",
	.run = cmd_describe},
    {.name = "screen",
	.brief = "make an image of full-screen mode",
	.flags = COMMAND_DRAWS | COMMAND_UNSAVED | COMMAND_DURING_SEARCH,
	.option = OPTION_LIST(
	    {NUMBER(width), "columns", 1, 1000, NULL, "",
		"default: that of full-screen mode if it is open, else 100"},
	    {NUMBER(height), "rows", 1, 1000, NULL, "",
		"default: that of full-screen mode if it is open, else 30"},
	    {CHOICE(page), SCREEN_PAGE_WORDS, "",
		"the page to show; default: the open page, else predict"},
	    {CHOICE(charset), "auto ascii quadrants braille", "auto",
		"characters"},
	    {CHOICE(colours), "auto 256 16 8 0", "auto",
		"number of colours; auto: those of the terminal, 256 in an "
		"image"},
	    {TEXT(keys), NULL, "",
		"keys to press first, named as in tipspeed-tui(1); Right*5: "
		"five times; 9999 in all"}),
	.text = "In full-screen mode: shows the screen as it is without the "
		"command line; a running calibration continues. Otherwise: "
		"shows the screen that tui would open on the site in use; no "
		"terminal is needed. After >, a file whose name ends in .svg, "
		".png or .pdf becomes an image with the colours of a dark "
		"terminal; without a file, and in .txt, it is text. keys= "
		"presses keys first, separated by spaces: keys=\"Left Left "
		"c\"; a word that is not the name of a key is typed if a line "
		"or a speed is being edited. Each key lets a calibration run "
		"for one generation. With --linear: prints the text of the "
		"screen row by row, then describes its plot.",
	.example = "load data/sites/tierp.csv\n"
		   "params set f_mat=2.18 e0_min=16.74 alpha=0.96\n"
		   "screen width=80 height=24",
	.run = cmd_screen},
    {.name = NULL}};

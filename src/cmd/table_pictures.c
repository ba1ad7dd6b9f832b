/* Commands that draw, as rows of the command table.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/table.h"

#include "cmd/plots.h"

#define WHAT_OPTIONS                                                       \
	{"speed", VALUE_NUMBER, "m/s", 1, 200, NULL, "",                   \
	    "rotor tip speed of psd and selection; the middle one"},       \
	    TABLE_FEED,                                                    \
	    {"other", VALUE_NUMBER, "m/s", 1, 200, NULL, "",               \
		"another speed beside it"},                                \
	    {"beside", VALUE_TEXT, "", 0, 0, "SITE", "",                   \
		"psd: the product of this loaded site beside it"},         \
	    {"speeds", VALUE_NUMBERS, "m/s", 1, 200, NULL, "",             \
		"tip speeds of sweep; 65..85:5, or as the runs want"},     \
	    {"band", VALUE_CHOICE, "", 0, 0, "off on", "off",              \
		"psd: shade what other fits that the data allow predict"}, \
	    {"at", VALUE_NUMBER, "mm", 1e-6, 1e4, NULL, "",                \
		"psd: a line at this size, and the passings there"},       \
	{                                                                  \
		"level", VALUE_NUMBER, "%", 0, 100, NULL, "50",            \
		    "psd with at=: and the sizes that so much passes"      \
	}

static const struct command_option PLOT_OPTIONS[] = {WHAT_OPTIONS,
    {"width", VALUE_NUMBER, "columns", 1, 1000, NULL, "",
	"as the screen, 100 at most; 78 elsewhere"},
    {"height", VALUE_NUMBER, "rows", 1, 1000, NULL, "",
	"as the screen, 24 at most"},
    {"charset", VALUE_CHOICE, "", 0, 0, "auto ascii quadrants braille", "auto",
	"what lines are drawn with"},
    {.name = NULL}};

static const struct command_option SCREEN_OPTIONS[] = {
    {"width", VALUE_NUMBER, "columns", 1, 1000, NULL, "",
	"as the full screen that is open; 100 elsewhere"},
    {"height", VALUE_NUMBER, "rows", 1, 1000, NULL, "",
	"as the full screen that is open; 30 elsewhere"},
    {"page", VALUE_CHOICE, "", 0, 0, "predict fit data parity sites", "",
	"the page that is shown; predict where none is open"},
    {"charset", VALUE_CHOICE, "", 0, 0, "auto ascii quadrants braille", "auto",
	"what lines are drawn with"},
    {"colours", VALUE_CHOICE, "", 0, 0, "auto 256 16 8 0", "auto",
	"how many; auto: as the terminal, 256 in a picture's file"},
    {"keys", VALUE_TEXT, "", 0, 0, NULL, "",
	"keys to press first, by their names in tipspeed-tui(1)"},
    {.name = NULL}};

static const struct command_option DESCRIBE_OPTIONS[] = {
    WHAT_OPTIONS, {.name = NULL}};

const struct command TABLE_PICTURES[] = {
    {.name = "plot",
	.brief = "draw a picture",
	.operands = {"KIND", {PLOT_KINDS}, 1, 1},
	.flags = COMMAND_DRAWS,
	.option = PLOT_OPTIONS,
	.text =
	    "psd: feed, measured and predicted products; parity: P20, P50 "
	    "and P80 predicted against measured, at the speeds held out "
	    "of all loaded sites; convergence: best and median misfit of "
	    "the search; spread: the candidates within the bounds of each "
	    "parameter; residuals: predicted less measured, sieve by "
	    "sieve; selection: how much of each size breaks (Eq 3); "
	    "appearance: the sizes it breaks into (Eq 1); map: the "
	    "materials of the store by rock; sweep: products of several "
	    "speeds. Lines are told apart by their marks and dashes, with "
	    "and without colour. charset=auto draws with braille dots on "
	    "a terminal with UTF-8, elsewhere with ASCII characters. Behind "
	    "> a file whose name ends in .svg, .png or .pdf becomes a "
	    "picture for a paper, with the same ticks and lines; .csv and "
	    ".json take the numbers, .txt the text.",
	.example = "load data/sites/tierp.csv\n"
		   "params set f_mat=2.18 e0_min=16.74 alpha=0.96\n"
		   "plot psd speed=74 at=2",
	.run = cmd_plot},
    {.name = "describe",
	.brief = "a picture in sentences",
	.operands = {"KIND", {PLOT_KINDS}, 1, 1},
	.option = DESCRIBE_OPTIONS,
	.text = "What plot would draw, for those who hear the screen or "
		"cannot see the picture: the axes, where each curve begins "
		"and ends and its P20, P50 and P80, where curves lie furthest "
		"apart, the break size, and where the data are from. The "
		"kinds and options are those of plot.",
	.example = "load data/sites/tierp.csv\n"
		   "params set f_mat=2.18 e0_min=16.74 alpha=0.96\n"
		   "describe psd speed=74",
	.run = cmd_describe},
    {.name = "screen",
	.brief = "a picture of the full screen",
	.flags = COMMAND_DRAWS | COMMAND_UNSAVED,
	.option = SCREEN_OPTIONS,
	.text = "Typed in the full screen: as it stands behind the command "
		"line; a calibration that runs goes on. Elsewhere: as tui "
		"would open on the site in use, drawn without a terminal by "
		"the same program. Behind > a file whose name ends in .svg, "
		".png or .pdf becomes a picture with the colours of a dark "
		"terminal; without a file, and in .txt, it is text. keys= "
		"has them pressed before, with a blank between two: "
		"keys=\"Left Left c\"; what is no name is typed where a "
		"line or a speed is being typed, and they do what they do "
		"in the full screen. One generation of a calibration passes "
		"with each key.",
	.example = "load data/sites/tierp.csv\n"
		   "params set f_mat=2.18 e0_min=16.74 alpha=0.96\n"
		   "screen width=80 height=24",
	.run = cmd_screen},
    {.name = NULL}};

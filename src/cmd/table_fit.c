/* Commands that calibrate, as rows of the command table.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/table.h"

#define PAUSE_OPTION                                           \
	{                                                      \
		"pause", VALUE_WHOLE, "", 1, 1e9, NULL, "",    \
		    "stop after this generation, as ^C does; " \
		    "steps of the polish count on"             \
	}

static const struct command_option CALIBRATE_OPTIONS[] = {
    {"seed", VALUE_WHOLE, "", 0, 9223372036854774784.0, NULL, "",
	"of the random numbers; else the session's"},
    {"population", VALUE_WHOLE, "", 8, 1e6, NULL, "8000",
	"candidates a generation"},
    {"generations", VALUE_WHOLE, "", 1, 1e6, NULL, "800", "at most"},
    {"tolerance", VALUE_NUMBER, "", 0, 1e3, NULL, "0.05",
	"stop when the median misfit is within this share of the best; 0: "
	"never"},
    {"stall", VALUE_WHOLE, "", 0, 1e6, NULL, "20",
	"stop after so many generations without 0.1 % gain; 0: never"},
    {"polish", VALUE_CHOICE, "", 0, 0, "on off", "on",
	"end with bounded least squares"},
    {"threads", VALUE_WHOLE, "", 1, 64, NULL, "",
	"threads; else the session's, one for each processor"},
    {"train", VALUE_NUMBERS, "m/s", 1, 200, NULL, "",
	"speeds to train on; else the slowest and the fastest"},
    {"weights", VALUE_CHOICE, "", 0, 0, "off sd", "off",
	"sd: divide by the sheet's standard deviations"},
    {"run_weights", VALUE_NUMBERS, "", 0.001, 1000, NULL, "",
	"weight of each training run's squares, slow to fast"},
    {"preset", VALUE_CHOICE, "", 0, 0, "best paper", "best",
	"paper: a textbook genetic algorithm, without polish"},
    PAUSE_OPTION, {.name = NULL}};

static const struct command_option HISTORY_OPTIONS[] = {
    {"every", VALUE_WHOLE, "", 1, 1e6, NULL, "",
	"show every N-th generation; else as many as fit a screen"},
    {.name = NULL}};
static const struct command_option CONTINUE_OPTIONS[] = {
    PAUSE_OPTION, {.name = NULL}};

const struct command TABLE_FIT[] = {
    {.name = "calibrate",
	.alias = "fit",
	.brief = "find the parameters that explain the runs",
	.operands = {"[all]", {"all"}, 0, 1},
	.flags = COMMAND_AT_SITE | COMMAND_CHANGES,
	.option = CALIBRATE_OPTIONS,
	.text = "A genetic algorithm searches within the bounds, then "
		"bounded least squares goes to the bottom of the valleys it "
		"found. The slowest and the fastest speed train; the others "
		"are held out for 'validate'. The misfit is the sum of squared "
		"differences of passing, as fractions.",
	.example = "load data/sites/tierp.csv\ncalibrate seed=1\nvalidate",
	.run = cmd_calibrate},
    {.name = "continue",
	.brief = "go on with a stopped calibration",
	.flags = COMMAND_CHANGES,
	.option = CONTINUE_OPTIONS,
	.text = "^C or pause= stopped it. The result is the same as if it "
		"had not been stopped; but bounds that were edited since hold "
		"from here on: candidates outside them are brought to them, "
		"and the result says after which generation.",
	.example = "load data/sites/tierp.csv\ncalibrate pause=10\ncontinue",
	.run = cmd_continue},
    {.name = "accept",
	.brief = "keep the best of a stopped calibration as it is",
	.text = "The parameters are in use already; this lets go of what "
		"'continue' would need.",
	.example = "load data/sites/tierp.csv\ncalibrate pause=10\naccept",
	.run = cmd_accept},
    {.name = "history",
	.brief = "how the last calibration came together",
	.flags = COMMAND_AT_SITE,
	.bare = "every",
	.option = HISTORY_OPTIONS,
	.text = "A row a generation of the site in use: the best and the "
		"median misfit, and the spread of each parameter, which is "
		"the middle 80 % of the population in per cent of the "
		"parameter's bounds. A spread that stays wide says that the "
		"data do not tell this parameter. csv and json have the 10 % "
		"and 90 % values themselves. The misfits are those of the "
		"search, which is coarser than the polish that follows.",
	.example = "load data/sites/tierp.csv\n"
		   "calibrate population=500 generations=40\nhistory",
	.run = cmd_history},
    {.name = NULL}};

/* Commands that calibrate, as rows of the command table.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/lang/rows.h"
#include "cmd/lang/table.h"

#define PAUSE                               \
	WHOLE(pause), "", 1, 1e9, NULL, "", \
	    "stop after this generation, as ^C does"

const struct command TABLE_FIT[] = {
    {.name = "calibrate",
	.alias = "fit",
	.brief = "find the parameters that fit the training runs",
	.operands = {"[all]", {"all"}, 0, 1},
	.flags = COMMAND_NEEDS_SITE | COMMAND_CHANGES | COMMAND_DAILY,
	.option = OPTION_LIST(
	    {WHOLE(seed), "", 0, 9223372036854774784.0, NULL, "",
		"seed of the random numbers; default: the session's"},
	    {WHOLE(population), "", 8, 1e6, NULL, "",
		"candidates a generation; default 8000, all: 2500"},
	    {WHOLE(generations), "", 1, 1e6, NULL, "800",
		"largest number of generations"},
	    {NUMBER(tolerance), "", 0, 1e3, NULL, "0.05",
		"stop when the median misfit is within this of the best; 0: "
		"never"},
	    {WHOLE(stall), "", 0, 1e6, NULL, "20",
		"stop after this many generations without gain; 0: never"},
	    {ON_OFF(polish), "on", "refine the best by bounded least squares"},
	    {WHOLE(threads), "", 1, 64, NULL, "",
		"threads; default: the session's"},
	    {NUMBERS(train), "m/s", 1, SITE_FASTEST, "all", "",
		"training speeds, or all; default: the slowest and the "
		"fastest"},
	    {CHOICE(weights), "off sd", "off",
		"sd: divide by the site file's standard deviations"},
	    {NUMBERS(run_weights), "", 0.001, 1000, NULL, "",
		"weight of each training run, slow to fast"},
	    {CHOICE(preset), "best paper", "best",
		"paper: the paper's search and bounds, no polish"},
	    {OFF_ON(detail), "off", "on: also show what 'show fit' has"},
	    {OFF_ON(watch), "off", "on: draw the best curves at a terminal"},
	    {TEXT(part), NULL, "",
		"I/N: every N-th of all sites, from the I-th on"},
	    {PAUSE}),
	.text =
	    "A genetic algorithm searches within the bounds; then bounded "
	    "least squares refines the best candidates (polish). The slowest "
	    "and the fastest speed are the training speeds, with every repeat; "
	    "the others are held out for 'validate'. train=all holds out none; "
	    "'validate holdout=each' then tests the model. The result says how "
	    "well the model fits; 'show fit' has the parameters with their "
	    "ranges, the bounds and the search, and so have csv and json.",
	.more =
	    "The misfit is the sum of squared residuals of passing, as "
	    "fractions; tolerance= is the median misfit divided by the best, "
	    "minus 1, and stall= ends a search that gains less than 0.1 % in "
	    "so many generations. preset=paper is the paper's run: a textbook "
	    "genetic algorithm, 8000 candidates, 800 generations without an "
	    "early stop, the bounds of its Table 2, no polish. pause= also "
	    "counts the steps of the polish. Without part=, the environment of "
	    "a Slurm job array or of mpirun sets it. With all, the sites share "
	    "the threads, and the results do not depend on how many there are; "
	    "'doubtful' is then decided by the fit alone, and 'why' for a site "
	    "also draws its ranges.",
	.example = "load data/sites/tierp.csv\ncalibrate seed=1\nvalidate",
	.run = cmd_calibrate},
    {.name = "validate",
	.brief = "compare predictions with the held-out runs",
	.operands = {"[all]", {"all"}, 0, 1},
	.flags = COMMAND_NEEDS_SITE | COMMAND_DAILY,
	.option = OPTION_LIST({CHOICE(holdout), "untrained each", "untrained",
				  "each: hold out each speed in turn and "
				  "calibrate on the others"},
	    {OFF_ON_NAMED("sieves", by_sieve), "off",
		"also compare sieve by sieve"},
	    {TEXT(part), NULL, "",
		"I/N: with all, every N-th site, as in 'calibrate all'"}),
	.text = "Shows the error of the passings on average (their root mean "
		"square, RMSE), P20, P50 and P80 at each held-out run, "
		"measured and predicted by the model, by the model corrected "
		"by the training runs, as 'predict' corrects it by all, and by "
		"three methods that need no model: the training products "
		"interpolated in speed squared (outside the training speeds, "
		"on the line through the two nearest), the product at the "
		"nearest training speed, and the feed unchanged. Reports which "
		"of them predicts best. holdout=each calibrates without each "
		"speed in turn, as 'calibrate' alone would, and predicts it; "
		"the fit in "
		"use stays. 'validate all' sums up the relative errors of P20, "
		"P50 and P80 over all calibrated sites: bias (mean), rms and "
		"R2; see VALIDATION in tipspeed-model(7). The sites share the "
		"threads; after 'set correction off' the corrected answer, "
		"which takes most of the time, is left out. A site that cannot "
		"be compared is listed at the end and excluded.",
	.example = "load data/sites/tierp.csv\ncalibrate\nvalidate\n"
		   "validate sieves=on\nvalidate holdout=each",
	.run = cmd_validate},
    {.name = "collect",
	.brief = "join the parts of 'calibrate all' or 'validate all'",
	.operands = {"FILE...", {"FILE"}, 1, OPERANDS - 1},
	.flags = COMMAND_FILES,
	.option = OPTION_LIST({OFF_ON(replace), "off",
	    "replace materials of the same name in the store in use"}),
	.text =
	    "Reads the JSON that several programs wrote with part=I/N, each "
	    "for one part of the sites, and gives the same answer, to the last "
	    "byte, as a single 'calibrate all' or 'validate all'. A file may "
	    "hold several parts, a line each. A part that is missing, present "
	    "twice, or from another version or build, other options, other "
	    "collision energies or other sites is refused. All programs must "
	    "load the same files in the same order. The parts of 'calibrate "
	    "all' can be followed by the stores of their programs, each filled "
	    "by 'remember all': their materials are put into the store in use, "
	    "unless one is missing, present twice or from another calibration.",
	.example = "synth data/table3.csv\n"
		   "calibrate all part=1/2 generations=30 > part1.json\n"
		   "calibrate all part=2/2 generations=30 > part2.json\n"
		   "collect part1.json part2.json",
	.run = cmd_collect},
    {.name = "continue",
	.alias = "calibrate continue",
	.brief = "continue a stopped calibration",
	.flags = COMMAND_CHANGES,
	.option = OPTION_LIST({PAUSE}),
	.text = "Continues after ^C or pause=. The result is the same as if "
		"the calibration had not been stopped. If bounds were edited "
		"since, they apply from here on: candidates outside them are "
		"moved to them, and the result states after which generation.",
	.example =
	    "load data/sites/tierp.csv\ncalibrate pause=10\ncalibrate continue",
	.run = cmd_continue},
    {.name = "accept",
	.alias = "calibrate accept",
	.brief = "keep the best of a stopped calibration as it is",
	.flags = COMMAND_CHANGES,
	.text = "A stopped calibration gives its site the best parameters so "
		"far, unless the site's earlier parameters fit the same runs "
		"better under the same settings. In that case the earlier ones "
		"stay, and accept takes those of the stopped calibration "
		"instead. After accept, 'continue' is no longer possible.",
	.example =
	    "load data/sites/tierp.csv\ncalibrate pause=10\ncalibrate accept",
	.run = cmd_accept},
    {.name = "history",
	.alias = "show search",
	.brief = "show how the last calibration converged",
	.flags = COMMAND_NEEDS_SITE,
	.bare = "every",
	.option = OPTION_LIST({WHOLE(every), "", 1, 1e6, NULL, "",
	    "show every N-th generation; default: as many as fit a screen"}),
	.text = "Shows the generations of the last calibration of the site in "
		"use, not the lines that were typed. Each row has the best and "
		"the median misfit and the spread of each parameter: the "
		"middle 80 % of the population, in per cent of the parameter's "
		"bounds. A spread that stays wide means that the data do not "
		"determine this parameter. csv and json have the 10 % and 90 % "
		"values. The misfits are those of the search, which is less "
		"exact than the polish that follows.",
	.example = "load data/sites/tierp.csv\n"
		   "calibrate population=500 generations=40\nshow search",
	.run = cmd_history},
    {.name = NULL}};

/* Commands that answer, as rows of the command table.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/table.h"

#define SPEED_OPTION                                            \
	{                                                       \
		"speed", VALUE_NUMBER, "m/s", 1, 200, NULL, "", \
		    "rotor tip speed; one held out, else 74"    \
	}

static const struct command_option PREDICT_OPTIONS[] = {SPEED_OPTION,
    TABLE_FEED,
    {"curve", VALUE_CHOICE, "", 0, 0, "off on", "off",
	"draw feed, measured and predicted as text"},
    {"interpolated", VALUE_CHOICE, "", 0, 0, "off on", "off",
	"add the measured products interpolated at this speed"},
    {"band", VALUE_CHOICE, "", 0, 0, "off on", "on",
	"show how far the data leave a calibrated product open"},
    {.name = NULL}};

static const struct command_option SWEEP_OPTIONS[] = {
    {"speeds", VALUE_NUMBERS, "m/s", 1, 200, NULL, "",
	"rotor tip speeds; 65..85:5, or as the runs want"},
    TABLE_FEED, {.name = NULL}};

static const struct command_option COMPARE_OPTIONS[] = {
    {"speed", VALUE_NUMBER, "m/s", 1, 200, NULL, "",
	"where sites meet; a speed held out, else 74"},
    TABLE_FEED, {.name = NULL}};

static const struct command_option FIND_OPTIONS[] = {
    {"p20", VALUE_NUMBER, "mm", 1e-6, 1e4, NULL, "", "wanted P20"},
    {"p50", VALUE_NUMBER, "mm", 1e-6, 1e4, NULL, "", "wanted P50"},
    {"p80", VALUE_NUMBER, "mm", 1e-6, 1e4, NULL, "", "wanted P80"},
    {"passing", VALUE_NUMBER, "%", 0, 100, NULL, "", "wanted passing"},
    {"at", VALUE_NUMBER, "mm", 1e-6, 1e4, NULL, "", "size of that passing"},
    {"spec", VALUE_FILE, "", 0, 0, NULL, "", "file of a grading envelope"},
    {"from", VALUE_NUMBER, "m/s", 1, 200, NULL, "",
	"slowest speed; 65, or as the runs want"},
    {"to", VALUE_NUMBER, "m/s", 1, 200, NULL, "",
	"fastest speed; 85, or as the runs want"},
    TABLE_FEED, {.name = NULL}};

/* Of why and spec. */
static const struct command_option AT_SPEED_OPTIONS[] = {
    SPEED_OPTION, TABLE_FEED, {.name = NULL}};

const struct command TABLE_ANSWERS[] = {
    {.name = "predict",
	.brief = "the product at a tip speed",
	.flags = COMMAND_AT_SITE | COMMAND_LATEST | COMMAND_DRAWS,
	.bare = "speed",
	.option = PREDICT_OPTIONS,
	.text = "Needs parameters: calibrate, or params set. Outside the "
		"trained speeds the answer is marked as extrapolated. "
		"interpolated=on puts beside it the products measured at the "
		"next lower and higher speed, interpolated in speed squared: "
		"the answer without a model. Where the parameters were "
		"found by calibrate, low and high are the band in which 80 % "
		"of the fits lie that the data allow; see UNCERTAINTY in "
		"tipspeed-model(7). Behind > a file whose name ends in .svg, "
		".png or .pdf gets the curves, as plot psd draws them.",
	.example = "load data/sites/tierp.csv\ncalibrate\npredict 74",
	.run = cmd_predict},
    {.name = "sweep",
	.brief = "products over a range of speeds",
	.flags = COMMAND_AT_SITE,
	.bare = "speeds",
	.option = SWEEP_OPTIONS,
	.text = "Up to seven speeds stand side by side, sieve by sieve; more "
		"are listed one a row. Without speeds it goes from 65 to 85 "
		"m/s and on to the runs beyond; where all of them are less "
		"than half or more than twice as fast, about them alone.",
	.example = "load data/sites/tierp.csv\ncalibrate\nsweep 65,74,85",
	.run = cmd_sweep},
    {.name = "compare",
	.brief = "two speeds or two sites side by side",
	.operands = {"SPEED SPEED | SITE SITE", {"SPEED SITE"}, 2, 2},
	.flags = COMMAND_AT_SITE,
	.option = COMPARE_OPTIONS,
	.text = "The predicted products of the site in use at two speeds, on "
		"one feed, or those of two loaded sites at one speed, each on "
		"its own: passing sieve by sieve and the difference, second "
		"less first; P20, P50 and P80; the fines; the break sizes. "
		"plot psd with other= or beside= draws both.",
	.example = "load data/sites/tierp.csv\n"
		   "params set f_mat=2.18 e0_min=16.74 alpha=0.96\n"
		   "compare 69 79",
	.run = cmd_compare},
    {.name = "find",
	.brief = "the speed that gives a wanted product",
	.flags = COMMAND_AT_SITE,
	.option = FIND_OPTIONS,
	.text = "The inverse of predict: the tip speed for a P20, P50 or P80, "
		"for a passing at a size, or the speeds at which the product "
		"keeps within a grading envelope, see tipspeed-spec(5). A "
		"faster rotor never makes a coarser product, so there is one "
		"answer or none; where there is none, the products at both "
		"ends, or the nearest speed and the sieve that fails, are "
		"shown. Without from= and to= the speeds are those of sweep. "
		"One feed serves for all speeds, that of the middle "
		"run unless feed= says otherwise.",
	.example = "load data/sites/tierp.csv\n"
		   "params set f_mat=2.18 e0_min=16.74 alpha=0.96\n"
		   "find p80=5\nfind passing=40 at=2\n"
		   "find spec=data/specs/en-12620-0-8.csv",
	.run = cmd_find},
    {.name = "spec",
	.brief = "the product against a grading envelope",
	.operands = {"FILE", {"FILE"}, 1, 1},
	.flags = COMMAND_AT_SITE | COMMAND_FILES,
	.option = AT_SPEED_OPTIONS,
	.text = "Each sieve of the envelope with its limits, the passing "
		"predicted at a speed, and ok, above or below. FILE is as "
		"tipspeed-spec(5) says; data/specs has some.",
	.example = "load data/sites/tierp.csv\n"
		   "params set f_mat=2.18 e0_min=16.74 alpha=0.96\n"
		   "spec data/specs/en-12620-0-8.csv speed=79",
	.run = cmd_spec},
    {.name = "validate",
	.brief = "compare with the speeds held out",
	.flags = COMMAND_AT_SITE,
	.text = "P20, P50 and P80 measured and predicted, the root mean "
		"square error and the worst sieve at each held-out speed, "
		"beside two answers that need no model: the feed itself, and "
		"the measured training products interpolated in speed "
		"squared. A model that loses to interpolation is told so.",
	.example = "load data/sites/tierp.csv\ncalibrate\nvalidate",
	.run = cmd_validate},
    {.name = "why",
	.brief = "why the numbers look the way they do",
	.flags = COMMAND_AT_SITE,
	.bare = "speed",
	.option = AT_SPEED_OPTIONS,
	.text = "Plain sentences about the site in use at a speed: what "
		"breaks, how much of the feed that is, how far the speed is "
		"from those trained on, how good the fit is, which parameters "
		"the data do not tell, where the data are from. What does not "
		"apply is not said.",
	.example = "load data/sites/tierp.csv\ncalibrate\nwhy 85",
	.run = cmd_why},
    {.name = NULL}};

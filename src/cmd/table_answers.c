/* Commands that answer, as rows of the command table.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/table.h"

#define SPEED_OPTION                                                      \
	{                                                                 \
		"speed", VALUE_NUMBER, "m/s", 1, 200, NULL, "",           \
		    "rotor tip speed; default: a held-out speed, else 74" \
	}

static const struct command_option PREDICT_OPTIONS[] = {SPEED_OPTION,
    TABLE_FEED,
    {"curve", VALUE_CHOICE, "", 0, 0, "off on", "off",
	"draw feed, measured and predicted as text"},
    {"interpolated", VALUE_CHOICE, "", 0, 0, "off on", "off",
	"add the measured products interpolated at this speed"},
    {"band", VALUE_CHOICE, "", 0, 0, "off on", "on",
	"show the uncertainty band of a calibrated product"},
    {"correction", VALUE_CHOICE, "", 0, 0, "all train off", "all",
	"runs that correct the model, for this prediction; default: as set"},
    {.name = NULL}};

static const struct command_option SWEEP_OPTIONS[] = {
    {"speeds", VALUE_NUMBERS, "m/s", 1, 200, NULL, "",
	"rotor tip speeds; default 65..85:5, extended or moved to cover the "
	"runs"},
    TABLE_FEED, {.name = NULL}};

static const struct command_option COMPARE_OPTIONS[] = {
    {"speed", VALUE_NUMBER, "m/s", 1, 200, NULL, "",
	"speed for two sites; default: a held-out speed, else 74"},
    TABLE_FEED, {.name = NULL}};

static const struct command_option FIND_OPTIONS[] = {
    {"p20", VALUE_NUMBER, "mm", 1e-6, 1e4, NULL, "", "wanted P20"},
    {"p50", VALUE_NUMBER, "mm", 1e-6, 1e4, NULL, "", "wanted P50"},
    {"p80", VALUE_NUMBER, "mm", 1e-6, 1e4, NULL, "", "wanted P80"},
    {"passing", VALUE_NUMBER, "%", 0, 100, NULL, "", "wanted passing"},
    {"at", VALUE_NUMBER, "mm", 1e-6, 1e4, NULL, "", "size for that passing"},
    {"spec", VALUE_FILE, "", 0, 0, NULL, "", "file of a grading envelope"},
    {"from", VALUE_NUMBER, "m/s", 1, 200, NULL, "",
	"slowest speed; default 65, or less to cover the runs"},
    {"to", VALUE_NUMBER, "m/s", 1, 200, NULL, "",
	"fastest speed; default 85, or more to cover the runs"},
    TABLE_FEED, {.name = NULL}};

static const struct command_option UNCERTAINTY_OPTIONS[] = {SPEED_OPTION,
    {"level", VALUE_CHOICE, "%", 0, 0, "80 90", "80",
	"probability of the bands; 'set level' sets it too"},
    {"noise", VALUE_NUMBER, "points", 0, 10, NULL, "0",
	"known standard deviation of a single passing around 50 %; 0: as the "
	"data show it"},
    {"n", VALUE_WHOLE, "", 1, 256, NULL, "200", "how many draws to write"},
    TABLE_FEED, {.name = NULL}};

static const struct command_option VALIDATE_OPTIONS[] = {
    {"holdout", VALUE_CHOICE, "", 0, 0, "untrained each", "untrained",
	"each: hold out each speed in turn and calibrate on the others"},
    {"sieves", VALUE_CHOICE, "", 0, 0, "off on", "off",
	"also compare sieve by sieve"},
    {.name = NULL}};

/* Of why and spec. */
static const struct command_option AT_SPEED_OPTIONS[] = {
    SPEED_OPTION, TABLE_FEED, {.name = NULL}};

const struct command TABLE_ANSWERS[] = {
    {.name = "predict",
	.brief = "the product at a tip speed",
	.flags = COMMAND_AT_SITE | COMMAND_LATEST | COMMAND_DRAWS,
	.bare = "speed",
	.option = PREDICT_OPTIONS,
	.text =
	    "Needs parameters: run calibrate or params set first. Outside the "
	    "training speeds the result is marked as extrapolated. "
	    "interpolated=on adds the products measured at the next lower and "
	    "higher speed, interpolated in speed squared: the prediction "
	    "without the model. If the parameters were found by calibrate, the "
	    "product is the model corrected by what the measured runs show it "
	    "to leave out, low and high are the uncertainty band, and the "
	    "model alone stands beside it; 'set correction' chooses the runs. "
	    "See UNCERTAINTY in tipspeed-model(7). After >, a file whose name "
	    "ends in .svg, .png "
	    "or .pdf gets the curves, as plot psd draws them.",
	.example = "load data/sites/tierp.csv\ncalibrate\npredict 74",
	.run = cmd_predict},
    {.name = "sweep",
	.brief = "products over a range of speeds",
	.flags = COMMAND_AT_SITE,
	.bare = "speeds",
	.option = SWEEP_OPTIONS,
	.text =
	    "Up to seven speeds are shown side by side, sieve by sieve; "
	    "more are listed one per row. Without speeds= it covers 65 to 85 "
	    "m/s and the runs outside that range; if all runs are below "
	    "32.5 or above 170 m/s, it covers only the range around them.",
	.example = "load data/sites/tierp.csv\ncalibrate\nsweep 65,74,85",
	.run = cmd_sweep},
    {.name = "compare",
	.brief = "two speeds or two sites side by side",
	.operands = {"SPEED SPEED | SITE SITE", {"SPEED SITE"}, 2, 2},
	.flags = COMMAND_AT_SITE,
	.option = COMPARE_OPTIONS,
	.text =
	    "Compares the predicted products of the site in use at two speeds, "
	    "with the same feed, or of two loaded sites at one speed, each "
	    "with its own feed: passing sieve by sieve and the difference "
	    "(second minus first), P20, P50 and P80, the fines and the break "
	    "sizes. plot psd with other= or beside= draws both.",
	.example = "load data/sites/tierp.csv\n"
		   "params set f_mat=2.18 e0_min=16.74 alpha=0.96\n"
		   "compare 69 79",
	.run = cmd_compare},
    {.name = "find",
	.brief = "find the speed that gives a wanted product",
	.flags = COMMAND_AT_SITE,
	.option = FIND_OPTIONS,
	.text =
	    "The inverse of predict: finds the tip speed for a P20, P50 or "
	    "P80, for a passing at a size, or the speeds at which the product "
	    "meets a grading envelope; see tipspeed-spec(5). A faster rotor "
	    "never makes a coarser product, so there is one answer or none. If "
	    "there is none, the products at both ends are shown, or the "
	    "nearest speed and the sieve that fails. Without from= and to= it "
	    "searches the speeds of sweep. The same feed is used for all "
	    "speeds: that of the middle run, unless feed= is given.",
	.example = "load data/sites/tierp.csv\n"
		   "params set f_mat=2.18 e0_min=16.74 alpha=0.96\n"
		   "find p80=5\nfind passing=40 at=2\n"
		   "find spec=data/specs/en-12620-0-8.csv",
	.run = cmd_find},
    {.name = "spec",
	.brief = "compare the product with a grading envelope",
	.operands = {"FILE", {"FILE"}, 1, 1},
	.flags = COMMAND_AT_SITE | COMMAND_FILES,
	.option = AT_SPEED_OPTIONS,
	.text = "Shows each sieve of the envelope with its limits, the passing "
		"predicted at a speed, and ok, above or below. "
		"tipspeed-spec(5) describes FILE; data/specs has examples.",
	.example = "load data/sites/tierp.csv\n"
		   "params set f_mat=2.18 e0_min=16.74 alpha=0.96\n"
		   "spec data/specs/en-12620-0-8.csv speed=79",
	.run = cmd_spec},
    {.name = "uncertainty",
	.brief = "what makes the answer uncertain, and its draws",
	.operands = {"[draws]", {"draws"}, 0, 1},
	.flags = COMMAND_AT_SITE | COMMAND_CHANGES | COMMAND_LOOKS,
	.option = UNCERTAINTY_OPTIONS,
	.text =
	    "Shows half the width of the uncertainty band at a speed, sieve by "
	    "sieve: of the model alone, which is what its parameters leave "
	    "open; of the answer, with what the model leaves out, which is the "
	    "band of predict; and of one more sample with its error, which is "
	    "where a new measurement is expected. Below it are the sizes of "
	    "these errors as the data show "
	    "them. level= and noise= are settings, kept for the commands that "
	    "follow. 'uncertainty draws > FILE.csv' writes the draws: "
	    "parameters, errors and product of each. See UNCERTAINTY in "
	    "tipspeed-model(7).",
	.example = "load data/sites/tierp.csv\ncalibrate\nuncertainty speed=85",
	.run = cmd_uncertainty},
    {.name = "advise",
	.brief = "which sample next narrows a band most",
	.operands = {"[QUANTITY] [SIZE]", {"p20 p50 p80 passing", ""}, 0, 2},
	.flags = COMMAND_AT_SITE,
	.option = AT_SPEED_OPTIONS,
	.text = "The quantity is p20, p50, p80 (the default), or passing and a "
		"size in mm, at a speed. For a repeat at each measured speed "
		"and a sample at each round one, it shows how wide the "
		"uncertainty band is expected to be after it; see UNCERTAINTY "
		"in tipspeed-model(7). Where the feed used was sampled with "
		"another run, it also shows what the feeds change.",
	.example = "load data/sites/tierp.csv\ncalibrate\nadvise p80\n"
		   "advise passing 2 speed=85",
	.run = cmd_advise},
    {.name = "validate",
	.brief = "compare predictions with the held-out runs",
	.operands = {"[all]", {"all"}, 0, 1},
	.flags = COMMAND_AT_SITE,
	.option = VALIDATE_OPTIONS,
	.text =
	    "Shows the root mean square error (RMSE), P20, P50 and P80 at each "
	    "held-out run, measured and predicted by the model and by three "
	    "that need no model: the training products interpolated in speed "
	    "squared (outside the training speeds, on the line through the two "
	    "nearest), the product at the nearest training speed, and the feed "
	    "unchanged. Reports who predicts best. holdout=each calibrates "
	    "without each speed in turn, as 'calibrate' alone would, and "
	    "predicts it; the fit in use stays. 'validate all' sums up the "
	    "relative errors of P20, P50 and P80 over all calibrated sites: "
	    "bias (mean), rms and R2; see VALIDATION in tipspeed-model(7).",
	.example = "load data/sites/tierp.csv\ncalibrate\nvalidate\n"
		   "validate sieves=on\nvalidate holdout=each",
	.run = cmd_validate},
    {.name = "league",
	.brief = "compare all breakage models on the site's runs",
	.operands = {"[all]", {"all"}, 0, 1},
	.flags = COMMAND_AT_SITE,
	.text =
	    "Calibrates each breakage model, with and without a bypass, on the "
	    "training runs, and shows for each the misfit, how many "
	    "parameters were free, AICc (lower is better) and the RMSE at the "
	    "held-out runs, beside predictions that need no model. If no run "
	    "is held out, each speed is held out in turn where there are three "
	    "or more. Reports which models the data rule out and whether they "
	    "can tell the models apart; see COMPARING MODELS in "
	    "tipspeed-model(7). The fit in use stays. 'league all' does it for "
	    "all loaded sites and adds up the results.",
	.example = "load data/sites/tierp.csv\nleague",
	.run = cmd_league},
    {.name = "identify",
	.brief = "what the data determine, and what they do not",
	.flags = COMMAND_AT_SITE,
	.text =
	    "Reads off the draws of the uncertainty which parameters the data "
	    "determine: the standard deviation of the draws in per cent of "
	    "that before the data (below 10: determined, below 50: poorly, "
	    "else they cannot be told), the break size at each measured "
	    "speed, the parameters that lie at a bound or compensate for each "
	    "other, and whether the threshold is bounded from above only. Ends "
	    "in one sentence. plot correlation and plot profile draw it; see "
	    "IDENTIFIABILITY in tipspeed-model(7).",
	.example = "load data/sites/tierp.csv\ncalibrate\nidentify",
	.run = cmd_identify},
    {.name = "why",
	.brief = "explain the numbers at a speed",
	.flags = COMMAND_AT_SITE,
	.bare = "speed",
	.option = AT_SPEED_OPTIONS,
	.text =
	    "Explains the site in use at a speed in sentences: what breaks, "
	    "how much of the feed that is, how far the speed is from the "
	    "training speeds, the light with each reason, which parameters the "
	    "data "
	    "do not determine, and where the data are from.",
	.example = "load data/sites/tierp.csv\ncalibrate\nwhy 85",
	.run = cmd_why},
    {.name = NULL}};

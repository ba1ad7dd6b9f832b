/* The command table.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/command.h"

#include "cmd/answers.h"
#include "cmd/assert.h"
#include "cmd/data.h"
#include "cmd/fit.h"
#include "cmd/info.h"
#include "cmd/job.h"
#include "cmd/model.h"

#define LAST_OPTION                                      \
	{                                                \
		NULL, VALUE_TEXT, "", 0, 0, NULL, "", "" \
	}

static const struct command_option SYNTH_OPTIONS[] = {
    {"site", VALUE_TEXT, "", 0, 0, NULL, "", "make only the sites so called"},
    {"n", VALUE_NUMBER, "", 0.05, 5, NULL, "1",
	"exponent of the feed below the top size"},
    {"noise", VALUE_NUMBER, "", 0, 10, NULL, "0.5",
	"standard deviation in points at 50 % passing"},
    {"seed", VALUE_WHOLE, "", 0, 9223372036854774784.0, NULL, "1",
	"of the noise"},
    {"speeds", VALUE_NUMBERS, "m/s", 1, 200, NULL, "69,74,79",
	"tip speeds, slow to fast"},
    LAST_OPTION};

static const struct command_option WRITE_OPTIONS[] = {
    {"replace", VALUE_CHOICE, "", 0, 0, "off on", "off",
	"write over files that are there"},
    LAST_OPTION};

static const struct command_option PARAMS_OPTIONS[] = {
    {"beta1", VALUE_NUMBER, "", -1e9, 1e9, NULL, "", "constant term"},
    {"beta2", VALUE_NUMBER, "", -1e9, 1e9, NULL, "", "term in u"},
    {"beta3", VALUE_NUMBER, "", -1e9, 1e9, NULL, "", "term in u squared"},
    {"beta4", VALUE_NUMBER, "", -1e9, 1e9, NULL, "", "term in u cubed"},
    {"f_mat", VALUE_NUMBER, "kg/(J m)", 0, 1e4, NULL, "", "material parameter"},
    {"e0_min", VALUE_NUMBER, "J m/kg", 0, 1e4, NULL, "", "threshold energy"},
    {"alpha", VALUE_NUMBER, "", 0, 1e2, NULL, "", "size dependency"},
    LAST_OPTION};

static const struct command_option SET_OPTIONS[] = {
    {"method", VALUE_CHOICE, "", 0, 0, "continuous classes", "",
	"how products are computed"},
    {"appearance", VALUE_CHOICE, "", 0, 0, "ratio progeny_mm parent_mm", "",
	"the size that Eq 1 is a function of"},
    {"k", VALUE_NUMBER, "", 0.001, 1000, NULL, "", "number of impacts"},
    {"threads", VALUE_WHOLE, "", 1, 64, NULL, "", "threads of a calibration"},
    {"isa", VALUE_CHOICE, "", 0, 0, "baseline avx2 avx512 best", "",
	"instruction set of a calibration; results are the same"},
    {"format", VALUE_CHOICE, "", 0, 0, "table csv json markdown", "",
	"form of the results"},
    LAST_OPTION};

static const struct command_option SEED_OPTIONS[] = {
    {"seed", VALUE_WHOLE, "", 0, 9223372036854774784.0, NULL, "",
	"seed of calibrations"},
    LAST_OPTION};

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
    {"pause", VALUE_WHOLE, "", 1, 1e6, NULL, "",
	"stop after this generation, as ^C does"},
    {"checkpoint", VALUE_TEXT, "", 0, 0, NULL, "",
	"file to write when the calibration is stopped"},
    {"resume", VALUE_TEXT, "", 0, 0, NULL, "",
	"checkpoint of this site and these options to go on from"},
    {"log", VALUE_TEXT, "", 0, 0, NULL, "",
	"file for every generation, as CSV"},
    LAST_OPTION};

#define FEED_OPTION                                            \
	{                                                      \
		"feed", VALUE_NUMBER, "m/s", 1, 200, NULL, "", \
		    "take the feed sampled at this speed"      \
	}

static const struct command_option PREDICT_OPTIONS[] = {
    {"speed", VALUE_NUMBER, "m/s", 1, 200, NULL, "74", "rotor tip speed"},
    FEED_OPTION,
    {"curve", VALUE_CHOICE, "", 0, 0, "off on", "off",
	"draw feed, measured and predicted as text"},
    LAST_OPTION};

static const struct command_option SWEEP_OPTIONS[] = {
    {"speeds", VALUE_NUMBERS, "m/s", 1, 200, NULL, "65..85:5",
	"rotor tip speeds"},
    FEED_OPTION, LAST_OPTION};

const struct command COMMANDS[] = {
    {.name = "load",
	.group = "data",
	.brief = "read site files",
	.operands = "FILE...",
	.least = 1,
	.most = OPERANDS - 1,
	.text = "Reads sieve sheets, see tipspeed-site(5), and makes the last "
		"one the site in use. A sheet with faults is refused with the "
		"place of each fault; the sites already loaded stay.",
	.example = "load data/sites/tierp.csv\nshow",
	.run = cmd_load},
    {.name = "sites",
	.group = "data",
	.brief = "list the loaded sites",
	.operands = "",
	.text = "The first column is what 'use' takes.",
	.example = "load data/sites/tierp.csv data/sites/bro.csv\nsites",
	.run = cmd_sites},
    {.name = "use",
	.group = "data",
	.brief = "choose the site to work on",
	.operands = "SITE",
	.least = 1,
	.most = 1,
	.need = NEED_SITE,
	.text = "Case and accents do not matter: borlange finds Borlänge. "
		"Sites of one name are told apart by their top size: "
		"gavle/4, gavle/11.2.",
	.example = "load data/sites/borlange.csv data/sites/tierp.csv\n"
		   "use borlange\nshow",
	.run = cmd_use},
    {.name = "check",
	.group = "data",
	.brief = "look for faults in sheets",
	.operands = "[SITE|all]",
	.most = 1,
	.need = NEED_SITE,
	.text = "Looks at the site in use, another one, or all. Reports "
		"products coarser than their feed, a faster run with a coarser "
		"product, runs where nothing breaks, sieves that cannot be "
		"compared, and twins: loaded sites with the very same numbers. "
		"Nothing is changed. A fault (not a remark) ends a script "
		"with exit status 1.",
	.example = "load data/sites/ubbarp.csv data/sites/gasgruvan.csv\n"
		   "check all",
	.run = cmd_check},
    {.name = "show",
	.group = "data",
	.brief = "show what a sheet says",
	.operands = "[site|feed|product]",
	.most = 1,
	.need = NEED_SITE,
	.text = "site: where the sheet is from and what it holds; feed and "
		"product: the measured curves.",
	.example = "load data/sites/tierp.csv\nshow product",
	.run = cmd_show},
    {.name = "synth",
	.group = "data",
	.brief = "make sites from material parameters",
	.operands = "FILE",
	.least = 1,
	.most = 1,
	.option = SYNTH_OPTIONS,
	.text = "FILE holds rows of parameters as data/table3.csv does. Each "
		"row becomes a site whose products are computed by the model, "
		"with sampling noise. Such sites say that they are not "
		"measured wherever they are shown.",
	.example = "synth data/table3.csv site=Tierp seed=9\nshow product",
	.run = cmd_synth},
    {.name = "write",
	.group = "data",
	.brief = "write site files",
	.operands = "FILE|FOLDER",
	.least = 1,
	.most = 1,
	.need = NEED_SITE,
	.option = WRITE_OPTIONS,
	.text = "Writes the site in use to FILE, or all loaded sites into an "
		"existing FOLDER under their own names. A file that is "
		"there is replaced with replace=on only. Sheets are "
		"written with commas and decimal points; results are saved "
		"by the shell: tipspeed --format=csv ... >FILE.",
	.example = "load data/sites/tierp.csv\nwrite tierp-copy.csv",
	.run = cmd_write},
    {.name = "params",
	.group = "model",
	.brief = "show or set the model's parameters",
	.operands = "[list|set]",
	.most = 1,
	.need = NEED_SITE,
	.option = PARAMS_OPTIONS,
	.text = "'params set' takes known parameters in place of a "
		"calibration; those not named keep their value, and beta "
		"starts from (0, 1, -1, 0.5).",
	.example = "load data/sites/tierp.csv\n"
		   "params set f_mat=2.18 e0_min=16.74 alpha=0.96\n"
		   "predict 74",
	.run = cmd_params},
    {.name = "bounds",
	.group = "model",
	.brief = "limits of the search",
	.operands = "[default | PARAMETER FROM..TO | PARAMETER VALUE]",
	.most = 2,
	.text = "Without operands shows them. One VALUE holds the parameter "
		"fixed. The defaults are those of the paper's Table 2.",
	.example = "bounds f_mat 1.2\nbounds alpha 0.8..1\nbounds",
	.run = cmd_bounds},
    {.name = "set",
	.group = "model",
	.brief = "show or change settings",
	.operands = "",
	.pairs = true,
	.option = SET_OPTIONS,
	.text = "Settings are written 'set method classes' or 'set "
		"method=classes'. The method classes is the paper to the "
		"letter; continuous, the default, is its limit for fine "
		"classes and does not depend on how the sieves lie. "
		"Appearances other than ratio work with classes only.",
	.example = "set method classes\nset",
	.run = cmd_set},
    {.name = "seed",
	.group = "model",
	.brief = "seed of calibrations",
	.operands = "",
	.bare = "seed",
	.option = SEED_OPTIONS,
	.text = "The same seed gives the same result to the last bit, with "
		"any number of threads.",
	.example = "seed 7",
	.run = cmd_seed},
    {.name = "calibrate",
	.alias = "fit",
	.group = "fit",
	.brief = "find the parameters that explain the runs",
	.operands = "[all]",
	.most = 1,
	.need = NEED_SITE,
	.option = CALIBRATE_OPTIONS,
	.text = "A genetic algorithm searches within the bounds, then "
		"bounded least squares goes to the bottom of the valleys it "
		"found. The slowest and the fastest speed train; the others "
		"are held out for 'validate'. The misfit is the sum of squared "
		"differences of passing, as fractions.",
	.example = "load data/sites/tierp.csv\ncalibrate seed=1\nvalidate",
	.run = cmd_calibrate},
    {.name = "continue",
	.group = "fit",
	.brief = "go on with a stopped calibration",
	.operands = "",
	.text = "^C or pause= stopped it. The result is the same as if it "
		"had not been stopped.",
	.example = "load data/sites/tierp.csv\ncalibrate pause=10\ncontinue",
	.run = cmd_continue},
    {.name = "accept",
	.group = "fit",
	.brief = "keep the best of a stopped calibration as it is",
	.operands = "",
	.text = "The parameters are in use already; this lets go of what "
		"'continue' would need.",
	.example = "load data/sites/tierp.csv\ncalibrate pause=10\naccept",
	.run = cmd_accept},
    {.name = "predict",
	.group = "answers",
	.brief = "the product at a tip speed",
	.operands = "",
	.need = NEED_SITE,
	.bare = "speed",
	.option = PREDICT_OPTIONS,
	.text = "Needs parameters: calibrate, or params set. Outside the "
		"trained speeds the answer is marked as extrapolated.",
	.example = "load data/sites/tierp.csv\ncalibrate\npredict 74",
	.run = cmd_predict},
    {.name = "sweep",
	.group = "answers",
	.brief = "products over a range of speeds",
	.operands = "",
	.need = NEED_SITE,
	.bare = "speeds",
	.option = SWEEP_OPTIONS,
	.text = "Up to seven speeds stand side by side, sieve by sieve; more "
		"are listed one a row.",
	.example = "load data/sites/tierp.csv\ncalibrate\nsweep 65,74,85",
	.run = cmd_sweep},
    {.name = "validate",
	.group = "answers",
	.brief = "compare with the speeds held out",
	.operands = "",
	.need = NEED_SITE,
	.text = "P20, P50 and P80 measured and predicted, the root mean "
		"square error and the worst sieve at each held-out speed, "
		"beside two answers that need no model: the feed itself, and "
		"the measured training products interpolated in speed "
		"squared. A model that loses to interpolation is told so.",
	.example = "load data/sites/tierp.csv\ncalibrate\nvalidate",
	.run = cmd_validate},
    {.name = "assert",
	.group = "session",
	.brief = "stop with status 1 unless an answer is as expected",
	.operands = "VALUE =|<|> VALUE [within NUMBER]",
	.least = 3,
	.most = 5,
	.text = "A value is a number or the newest answer: p20, p50, p80, "
		"break (mm), speed and extrapolated (1 or 0) of predict; "
		"misfit, rmse (points) and poor (1 or 0) of calibrate; "
		"holdout, the largest RMSE of validate (points). Another "
		"site, other parameters or a new calibration make them "
		"unknown. For plant checks that run by themselves, which "
		"should hold poor = 0 first.",
	.example = "load data/sites/tierp.csv\ncalibrate\npredict 74\n"
		   "assert p50 = 2.81 within 0.05\nvalidate\n"
		   "assert holdout < 1",
	.run = cmd_assert},
    {.name = "help",
	.group = "session",
	.brief = "what commands there are",
	.operands = "[COMMAND]",
	.most = 1,
	.text = "With a command's name: all about it.",
	.example = "help predict",
	.run = cmd_help},
    {.name = "version",
	.group = "session",
	.brief = "version of the program",
	.operands = "",
	.text = "With the libraries and instructions that numbers depend on.",
	.example = "version",
	.run = cmd_version},
    {.name = "quit",
	.alias = "exit",
	.group = "session",
	.brief = "leave the program",
	.operands = "",
	.text = "The rest of a script is not run.",
	.example = "quit",
	.run = cmd_quit},
    {.name = NULL}};

/* Commands that answer, as rows of the command table.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/table.h"

#include "cmd/answers.h"

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
    {"interpolated", VALUE_CHOICE, "", 0, 0, "off on", "off",
	"add the measured products interpolated at this speed"},
    LAST_OPTION};

static const struct command_option SWEEP_OPTIONS[] = {
    {"speeds", VALUE_NUMBERS, "m/s", 1, 200, NULL, "65..85:5",
	"rotor tip speeds"},
    FEED_OPTION, LAST_OPTION};

static const struct command_option COMPARE_OPTIONS[] = {
    {"speed", VALUE_NUMBER, "m/s", 1, 200, NULL, "74", "where sites meet"},
    FEED_OPTION, LAST_OPTION};

const struct command TABLE_ANSWERS[] = {
    {.name = "predict",
	.group = "answers",
	.brief = "the product at a tip speed",
	.operands = "",
	.need = NEED_SITE,
	.bare = "speed",
	.option = PREDICT_OPTIONS,
	.text = "Needs parameters: calibrate, or params set. Outside the "
		"trained speeds the answer is marked as extrapolated. "
		"interpolated=on puts beside it the products measured at the "
		"next lower and higher speed, interpolated in speed squared: "
		"the answer without a model.",
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
    {.name = "compare",
	.group = "answers",
	.brief = "two speeds or two sites side by side",
	.operands = "SPEED SPEED | SITE SITE",
	.least = 2,
	.most = 2,
	.need = NEED_SITE,
	.option = COMPARE_OPTIONS,
	.text = "The predicted products of the site in use at two speeds, on "
		"one feed, or those of two loaded sites at one speed, each on "
		"its own: passing sieve by sieve and the difference, second "
		"less first; P20, P50 and P80; the fines; the break sizes.",
	.example = "load data/sites/tierp.csv\n"
		   "params set f_mat=2.18 e0_min=16.74 alpha=0.96\n"
		   "compare 69 79",
	.run = cmd_compare},
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
    {.name = NULL}};

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
    LAST_OPTION};

static const struct command_option SWEEP_OPTIONS[] = {
    {"speeds", VALUE_NUMBERS, "m/s", 1, 200, NULL, "65..85:5",
	"rotor tip speeds"},
    FEED_OPTION, LAST_OPTION};

const struct command TABLE_ANSWERS[] = {
    {.name = "predict",
	.group = "answers",
	.brief = "the product at a tip speed",
	.operands = "",
	.need = NEED_SITE,
	.flags = COMMAND_LATEST,
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
    {.name = NULL}};

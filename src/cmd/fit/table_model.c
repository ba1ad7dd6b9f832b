/* Commands that set the model, as rows of the command table.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/session/screen_pages.h"
#include "cmd/session/session.h"
#include "cmd/lang/rows.h"
#include "cmd/lang/table.h"

#define SETTING(word, member, k) \
	.name = word, .offset = offsetof(struct settings, member), .kind = k

const struct command_option SETTINGS[] = {
    {SETTING("model", model.breakage, VALUE_CHOICE), "", 0, 0, NULL, "grunditz",
	"breakage model"},
    {SETTING("method", model.method, VALUE_CHOICE), "", 0, 0,
	"continuous classes", "continuous", "how to compute"},
    {SETTING("appearance", model.appearance, VALUE_CHOICE), "", 0, 0,
	"ratio progeny_mm parent_mm", "ratio", "sizes of Eq 1"},
    {SETTING("k", model.k, VALUE_NUMBER), "", 0.001, 1000, NULL, "1",
	"number of impacts"},
    {SETTING("energy", energy, VALUE_FILE), "", 0, 0, NULL, "off",
	"collision energies instead of one impact"},
    {SETTING("correction", correction, VALUE_CHOICE), "", 0, 0, "all train off",
	"all", "runs that correct the model"},
    {SETTING("level", level, VALUE_CHOICE), "%", 0, 0, "80 90", "80",
	"probability of the bands"},
    {SETTING("noise", noise, VALUE_NUMBER), "points", 0, 10, NULL, "0",
	"known standard deviation of a passing near 50 %; 0: as the data show "
	"it"},
    {SETTING("speed_sd", speed_sd, VALUE_NUMBER), "%", 0, 5, NULL, "0.5",
	"standard deviation of tip speeds"},
    {SETTING("draw_seed", draw_seed, VALUE_WHOLE), "", 0, 999999, NULL, "1",
	"seed of the draws of bands"},
    {SETTING("threads", threads, VALUE_WHOLE), "", 1, 64, NULL, "",
	"threads; default: one for each processor"},
    {SETTING("format", format, VALUE_CHOICE), "", 0, 0,
	"table csv json markdown", "table", "output format"},
    {SETTING("csv", semicolon, VALUE_CHOICE), "", 0, 0, "comma semicolon",
	"comma", "semicolon: decimal commas"},
    {SETTING("pager", unpaged, VALUE_CHOICE), "", 0, 0, "on off", "on",
	"show long results in the pager"},
    {SETTING("theme", theme, VALUE_CHOICE), "", 0, 0, "normal dark light",
	"normal", "colours"},
    {SETTING("figure_mm", figure_mm, VALUE_NUMBER), "mm", 60, 500, NULL, "209",
	"width of plots in image files"},
    {SETTING("feed", feed, VALUE_FEED), "m/s", 1, SITE_FASTEST, NULL, "mean",
	"feed that answers assume: mean, or one named as in feed="},
    {SETTING("slider", slider, VALUE_NUMBERS), "m/s", 1, SITE_FASTEST, "usual",
	"usual", "speeds that slider, find, window, sweep and card cover"},
    {SETTING("goal", goal, VALUE_TEXT), "", 0, 0, NULL, "none",
	"what is wanted: p80=5.4, \"passing 2 = 40..50\", an envelope"},
    {SETTING("quantity", quantity, VALUE_TEXT), "", 0, 0, NULL, "p80",
	"what full-screen mode shows above its track", .looks = true},
    {SETTING("page", page, VALUE_CHOICE), "", 0, 0, SCREEN_PAGE_WORDS,
	"predict", "page that full-screen mode opens on", .looks = true},
    {.name = NULL}};

const struct command TABLE_MODEL[] = {
    {.name = "params",
	.brief = "show, set or compare the model's parameters",
	.operands = {"[list | set | diff SITE | use SITE]",
	    {"list set diff use", "SITE"}, 0, 2},
	.flags = COMMAND_NEEDS_SITE | COMMAND_CHANGES | COMMAND_PARAMS,
	.text =
	    "'params set' sets known parameters of the current model "
	    "instead of a calibration; those not named keep their value, "
	    "and beta is (0, 1, -1, 0.5) at first. Only the direction of "
	    "beta matters: 'calibrate' scales it to max 1. 'params diff SITE' "
	    "compares them with those of another loaded site; 'params use "
	    "SITE' uses those of that site, and results then state it.",
	.example = "load data/sites/tierp.csv\n"
		   "params set f_mat=2.18 e0_min=16.74 alpha=0.96\n"
		   "predict 74",
	.run = cmd_params},
    {.name = "bounds",
	.alias = "params bounds",
	.brief = "show or set the search bounds",
	.operands = {"[default | PARAMETER FROM..TO | PARAMETER VALUE]",
	    {"default PARAMETER", ""}, 0, 2},
	.flags = COMMAND_CHANGES,
	.text = "Without operands, shows the lower and upper bounds. A single "
		"VALUE holds the parameter fixed. The defaults are those of "
		"Table 2 in the paper, for the paper's model.",
	.example = "params bounds f_mat 1.2\nparams bounds alpha 0.8..1\n"
		   "params bounds",
	.run = cmd_bounds},
    {.name = "set",
	.brief = "show or change settings",
	.flags = COMMAND_CHANGES | COMMAND_APPEARANCE | COMMAND_CONDITIONS |
		 COMMAND_SETTINGS,
	.option = SETTINGS,
	.text = "Write 'set method classes' or 'set method=classes'. classes "
		"follows the paper exactly; continuous is its limit for fine "
		"size classes.",
	.more = "speed_sd says how well tip speeds are known, those of the "
		"runs and the one asked about: the bands of all answers "
		"include it; with 0, speeds count as exact. The model is "
		"used for later calibrations; 'show models' lists "
		"the models. continuous does not depend on the choice of "
		"sieves. Choosing another model also sets its search bounds; "
		"parameters that a site already has keep their model. "
		"Appearance functions other than ratio work only with classes. "
		"The themes dark and light have high contrast. Another "
		"draw_seed shows how much answers and bands depend on chance.",
	.example = "set method classes",
	.run = cmd_set},
    {.name = "seed",
	.alias = "set seed",
	.brief = "seed of calibrations",
	.flags = COMMAND_CHANGES | COMMAND_APPEARANCE,
	.bare = "seed",
	.option = OPTION_LIST({WHOLE(seed), "", 0, 9223372036854775807.0, NULL,
	    "", "seed of calibrations"}),
	.text = "The same seed gives the same result to the last bit, with "
		"any number of threads.",
	.example = "set seed 7",
	.run = cmd_seed},
    {.name = NULL}};

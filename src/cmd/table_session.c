/* Commands about the session itself, as rows of the command table.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/table.h"

#include "cmd/assert.h"
#include "cmd/info.h"

static const struct command_option MAN_OPTIONS[] = {
    {"page", VALUE_CHOICE, "", 0, 0, "tipspeed site model", "tipspeed",
	"page of the manual"},
    LAST_OPTION};

const struct command TABLE_SESSION[] = {
    {.name = "assert",
	.group = "session",
	.brief = "stop with status 1 unless an answer is as expected",
	.operands = "VALUE =|<|> VALUE [within NUMBER]",
	.expect = {"ANSWER", "= < >", "ANSWER", "within", ""},
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
	.operands = "[COMMAND|GROUP] [example]",
	.expect = {"COMMAND GROUP", "example"},
	.most = 2,
	.text = "With a command's name: all about it; with a group's name: the "
		"commands of the group. 'help COMMAND example' prints an "
		"example that can be run as it stands.",
	.example = "help predict",
	.run = cmd_help},
    {.name = "apropos",
	.group = "session",
	.brief = "find commands by a word of their help",
	.operands = "WORD",
	.expect = {""},
	.least = 1,
	.most = 1,
	.text = "Searches names, help texts, options and their choices, "
		"without regard to case and accents.",
	.example = "apropos threads",
	.run = cmd_apropos},
    {.name = "man",
	.group = "session",
	.brief = "open the manual",
	.operands = "",
	.bare = "page",
	.option = MAN_OPTIONS,
	.text = "At the prompt man(1) shows the page. Elsewhere, and where "
		"there is no man(1), prints the list of commands.",
	.example = "man site",
	.run = cmd_man},
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

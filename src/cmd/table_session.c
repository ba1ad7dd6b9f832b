/* Commands about the session itself, as rows of the command table.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/table.h"

static const struct command_option SAVE_OPTIONS[] = {
    {"replace", VALUE_CHOICE, "", 0, 0, "off on", "off",
	"write over a file that is there"},
    {.name = NULL}};

static const struct command_option TIMING_OPTIONS[] = {
    {"state", VALUE_CHOICE, "", 0, 0, "on off", "on", "tell it or not"},
    {.name = NULL}};

static const struct command_option MAN_OPTIONS[] = {
    {"page", VALUE_CHOICE, "", 0, 0, "tipspeed tutorial tui site spec model",
	"tipspeed", "page of the manual"},
    {.name = NULL}};

const struct command TABLE_SESSION[] = {
    {.name = "undo",
	.brief = "take back the last change",
	.flags = COMMAND_UNSAVED,
	.text = "Of sites, the site in use, parameters, calibrations, bounds, "
		"settings and seed: 200 steps. A calibration is one step, and "
		"so is a script that was sourced. Files that were written "
		"stay as they are.",
	.example = "set k 2\nundo",
	.run = cmd_undo},
    {.name = "redo",
	.brief = "do again what undo took back",
	.flags = COMMAND_UNSAVED,
	.text = "Until something else is changed.",
	.example = "set k 2\nundo\nredo",
	.run = cmd_redo},
    {.name = "save",
	.brief = "write the session as a script",
	.operands = {"FILE.tip", {"FILE"}, 1, 1},
	.flags = COMMAND_FILES | COMMAND_UNSAVED,
	.option = SAVE_OPTIONS,
	.text = "The commands that made the session what it is and gave its "
		"results, without those that were undone. Of predictions in a "
		"row the last is kept; results that went to a file or a shell "
		"command are left out, and so are assertions and help. Run "
		"anywhere, the script gives the very same results, as long as "
		"the sheets are where they were and the store has what is "
		"recalled: a sheet or a material with other numbers is "
		"refused.",
	.example = "load data/sites/tierp.csv\ncalibrate\npredict 74\n"
		   "save plant.tip",
	.run = cmd_save},
    {.name = "restore",
	.brief = "put a saved session in the place of this one",
	.operands = {"[FILE.tip|last]", {"FILE last"}, 0, 1},
	.flags = COMMAND_CHANGES | COMMAND_FILES | COMMAND_UNSAVED,
	.text = "Forgets all, also what the command line set, and runs the "
		"script. One undo brings back what was there. A session at a "
		"terminal is kept until it is saved, whatever ends the "
		"program: 'restore last' has the newest back that was not "
		"saved, and 'restore' alone lists the last few. A file called "
		"last is ./last.",
	.example = "seed 7\nsave seven.tip\nreset\nrestore seven.tip",
	.run = cmd_restore},
    {.name = "reset",
	.brief = "forget all that was loaded and set",
	.flags = COMMAND_CHANGES | COMMAND_UNSAVED,
	.text = "As if the program had just been started; what the command "
		"line set (seed, format) is set again.",
	.example = "load data/sites/tierp.csv\nset method classes\nreset",
	.run = cmd_reset},
    {.name = "source",
	.brief = "run a script",
	.operands = {"FILE", {"FILE"}, 1, 1},
	.flags = COMMAND_CHANGES | COMMAND_FILES | COMMAND_UNSAVED,
	.text = "Runs the commands in FILE, which may source others, up to "
		"16 deep. The first error ends all of them; a prompt goes on. "
		"Names of files are relative to the working folder, not to "
		"the script's.",
	.example = "source data/sessions/tierp.tip",
	.run = cmd_source},
    {.name = "echo",
	.brief = "print words",
	.operands = {"[WORD]...", {""}, 0, OPERANDS - 1},
	.text = "A line among the results, with one blank between words; "
		"quotes keep others.",
	.example = "echo \"Tierp, at 74 m/s:\"",
	.run = cmd_echo},
    {.name = "timing",
	.brief = "tell how long each command takes",
	.flags = COMMAND_CHANGES,
	.bare = "state",
	.option = TIMING_OPTIONS,
	.text = "Seconds of wall clock, on standard error. A calibration is "
		"counted to its end, a script to its last line.",
	.example = "timing on\nversion\ntiming off",
	.run = cmd_timing},
    {.name = "assert",
	.brief = "stop with status 1 unless an answer is as expected",
	.operands = {"VALUE =|<|> VALUE [within NUMBER]",
	    {"ANSWER", "= < >", "ANSWER", "within", ""}, 3, 5},
	.flags = COMMAND_VERBATIM | COMMAND_UNSAVED,
	.text = "A value is a number or the newest answer: p20, p50, p80, "
		"break (mm), speed and extrapolated (1 or 0) of predict and "
		"find; inside (1 or 0) of spec and find spec=; "
		"misfit, rmse (points) and poor (1 or 0) of calibrate; "
		"holdout, the largest RMSE of validate (points). Any other "
		"number of an answer is COMMAND.FIELD, as json calls it: "
		"calibrate.generations, predict.params.alpha; of a list it is "
		"the largest; predict.warnings is how many there are. Another "
		"site, other parameters or a new calibration make them "
		"unknown. For plant checks that run by themselves, which "
		"should hold poor = 0 first.",
	.example = "load data/sites/tierp.csv\ncalibrate\npredict 74\n"
		   "assert p50 = 2.81 within 0.05\nvalidate\n"
		   "assert holdout < 1",
	.run = cmd_assert},
    {.name = "help",
	.brief = "what commands there are",
	.operands = {"[COMMAND|GROUP] [example]", {"COMMAND GROUP", "example"},
	    0, 2},
	.flags = COMMAND_UNSAVED,
	.text = "With a command's name: all about it; with a group's name: the "
		"commands of the group. 'help COMMAND example' prints an "
		"example that can be run as it stands.",
	.example = "help predict",
	.run = cmd_help},
    {.name = "apropos",
	.brief = "find commands by a word of their help",
	.operands = {"WORD", {""}, 1, 1},
	.flags = COMMAND_UNSAVED,
	.text = "Searches names, help texts, options and their choices, "
		"without regard to case and accents.",
	.example = "apropos threads",
	.run = cmd_apropos},
    {.name = "man",
	.brief = "open the manual",
	.flags = COMMAND_UNSAVED,
	.bare = "page",
	.option = MAN_OPTIONS,
	.text = "At the prompt man(1) shows the page. Elsewhere, and where "
		"there is no man(1), prints the list of commands.",
	.example = "man site",
	.run = cmd_man},
    {.name = "version",
	.brief = "version of the program",
	.flags = COMMAND_UNSAVED,
	.text = "With the libraries and instructions that numbers depend on.",
	.example = "version",
	.run = cmd_version},
    {.name = "tui",
	.brief = "open the full screen",
	.flags = COMMAND_UNSAVED,
	.text = "On the site in use, at the speed last predicted, else at the "
		"one held out, else at 74 m/s. The arrow keys move the speed "
		"by 0.1 m/s, ? lists the keys and q comes back. Needs a "
		"terminal.",
	.example = "help tui",
	.run = cmd_tui},
    {.name = "quit",
	.alias = "exit",
	.brief = "leave the program",
	.flags = COMMAND_UNSAVED,
	.text = "The rest of a script is not run.",
	.example = "quit",
	.run = cmd_quit},
    {.name = NULL}};

/* Commands about the session, as rows of the command table.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/lang/rows.h"
#include "cmd/lang/table.h"

const struct command TABLE_SESSION[] = {
    {.name = "undo",
	.brief = "undo the last change",
	.flags = COMMAND_UNSAVED,
	.text =
	    "Undoes changes to sites, the site in use, parameters, "
	    "calibrations, bounds, settings and seed: up to 200 steps. A "
	    "calibration is one step, even if it was stopped and continued, "
	    "and so is a sourced script. Written files are not changed.",
	.example = "set k 2\nundo",
	.run = cmd_undo},
    {.name = "redo",
	.brief = "redo what was undone",
	.flags = COMMAND_UNSAVED,
	.text = "Possible until something else is changed.",
	.example = "set k 2\nundo\nredo",
	.run = cmd_redo},
    {.name = "save",
	.brief = "save the session as a script",
	.operands = {"FILE.tip", {"FILE"}, 1, 1},
	.flags = COMMAND_FILES | COMMAND_UNSAVED | COMMAND_DAILY,
	.option =
	    OPTION_LIST({OFF_ON(replace), "off", "overwrite an existing file"}),
	.text =
	    "Writes the commands that produced the session and its results, "
	    "without those that were undone. Of consecutive predictions only "
	    "the last is kept. Assertions and help are left out; so are "
	    "commands whose results went to a file or a shell command, unless "
	    "later ones rest on them. The script gives identical results "
	    "anywhere, as long as it finds the site files and the store has "
	    "the recalled materials: a site file or a material with other "
	    "numbers is refused. Files in the folder of the script, or below "
	    "it, are named relative to it, so that the folder can be moved or "
	    "given away. Results are saved with > FILE after a command, not "
	    "with save. If the name has no ending, .tip is added. A file that "
	    "this session was saved to before is saved again without "
	    "replace=on.",
	.example = "load data/sites/tierp.csv\ncalibrate\npredict 74\n"
		   "save plant",
	.run = cmd_save},
    {.name = "restore",
	.brief = "replace this session with a saved one",
	.operands = {"[FILE.tip|last]", {"FILE last"}, 0, 1},
	.flags = COMMAND_CHANGES | COMMAND_FILES | COMMAND_UNSAVED,
	.text =
	    "Clears everything, including what the command line set, and runs "
	    "the script. One undo brings the old session back. A session at a "
	    "terminal is kept until it is saved, however the program ends: "
	    "'restore last' brings back the newest unsaved one, and 'restore' "
	    "alone lists the last few. Write ./last for a file called last.",
	.example = "seed 7\nsave seven.tip\nreset\nrestore seven.tip",
	.run = cmd_restore},
    {.name = "reset",
	.brief = "clear everything that was loaded and set",
	.flags = COMMAND_CHANGES | COMMAND_UNSAVED,
	.text = "Returns to the state at the start of the program, including "
		"what the command line set (seed, format).",
	.example = "load data/sites/tierp.csv\nset method classes\nreset",
	.run = cmd_reset},
    {.name = "source",
	.brief = "run a script",
	.operands = {"FILE", {"FILE"}, 1, 1},
	.flags = COMMAND_CHANGES | COMMAND_FILES | COMMAND_UNSAVED,
	.text =
	    "Runs the commands in FILE, which may source others, up to 16 "
	    "deep. The first error ends all of them; a prompt continues. "
	    "Relative names of files to read are looked up in the folder of "
	    "the script, then in the working folder, in which results are "
	    "written; one that the session has written is read from there.",
	.example = "source data/sessions/tierp.tip",
	.run = cmd_source},
    {.name = "echo",
	.brief = "print words",
	.operands = {"[WORD]...", {""}, 0, OPERANDS - 1},
	.flags = COMMAND_DURING_SEARCH,
	.text = "Prints a line among the results, with one space between "
		"words; use quotes to keep more.",
	.example = "echo \"Tierp, at 74 m/s:\"",
	.run = cmd_echo},
    {.name = "timing",
	.alias = "set timing",
	.brief = "show how long each command takes",
	.flags = COMMAND_CHANGES,
	.bare = "state",
	.option = OPTION_LIST({ON_OFF(state), "on", "show it or not"}),
	.text = "Prints seconds of wall-clock time on standard error, for a "
		"calibration to its end, for a script to its last line.",
	.example = "set timing on\nversion\nset timing off",
	.run = cmd_timing},
    {.name = "assert",
	.brief = "stop with status 1 unless a result is as expected",
	.operands = {"VALUE =|<|> VALUE [within NUMBER]",
	    {"ANSWER", "= < >", "ANSWER", "within", ""}, 3, 5},
	.flags = COMMAND_VERBATIM | COMMAND_UNSAVED,
	.text = "A value is a number or the latest result: p20, p50, p80, "
		"break (mm), speed and extrapolated (1 or 0) of predict and "
		"find; inside (1 or 0) of spec and find spec=; misfit, rmse "
		"(points) and poor (1 or 0) of calibrate; holdout, the "
		"largest RMSE of validate (points). Other numbers of a result "
		"are COMMAND.FIELD, with the names of json: "
		"calibrate.generations, predict.params.alpha; of a list it is "
		"the largest; predict.warnings is the number of warnings. "
		"A text is compared as it is: predict.trust = green. "
		"Another site, other parameters or a new calibration clear "
		"them. For automatic plant checks, which should assert poor = "
		"0 first. 'assert FILE is DIGEST', which save writes, stops "
		"if a file is not the one that was read.",
	.example = "load data/sites/tierp.csv\ncalibrate\npredict 74\n"
		   "assert p50 = 2.86 within 0.05\nvalidate\n"
		   "assert holdout < 1",
	.run = cmd_assert},
    {.name = "help",
	.brief = "list the commands or explain one",
	.operands = {"[COMMAND|GROUP|all|options|trust] [example]",
	    {"COMMAND GROUP all options trust", "example", ""}, 0, 3},
	.flags = COMMAND_UNSAVED | COMMAND_DURING_SEARCH,
	.text = "Alone, shows the commands of a day's work; with the name of a "
		"command, explains it; with the name of a group, or all, lists "
		"its commands; with options, explains those that many commands "
		"take; with trust, the light of answers. 'help COMMAND "
		"example' prints an example that can be run as printed.",
	.example = "help predict",
	.run = cmd_help},
    {.name = "apropos",
	.brief = "find commands by a word in their help",
	.operands = {"WORD", {""}, 1, 1},
	.flags = COMMAND_UNSAVED | COMMAND_DURING_SEARCH,
	.text = "Searches names, help texts, options and their choices; case "
		"and accents do not matter.",
	.example = "apropos threads",
	.run = cmd_apropos},
    {.name = "man",
	.alias = "help page",
	.brief = "show a page of the manual",
	.operands = {"[PAGE|COMMAND]",
	    {"tipspeed tutorial tui site spec model circuit COMMAND", ""}, 0,
	    1},
	.flags = COMMAND_UNSAVED | COMMAND_DURING_SEARCH,
	.option = OPTION_LIST(
	    {CHOICE(page), "tipspeed tutorial tui site spec model circuit",
		"tipspeed", "page of the manual"}),
	.text = "At the prompt, shows the page with man(1). Elsewhere, or "
		"without man(1), prints the list of commands. For a COMMAND "
		"without a page of its own it prints what help does.",
	.example = "help page find",
	.run = cmd_man},
    {.name = "version",
	.brief = "show the version of the program",
	.flags = COMMAND_UNSAVED | COMMAND_DURING_SEARCH,
	.text = "Also lists the libraries and the instruction set on which the "
		"numbers depend.",
	.example = "version",
	.run = cmd_version},
    {.name = "tui",
	.brief = "open full-screen mode: the product as the speed changes",
	.flags = COMMAND_UNSAVED | COMMAND_DAILY,
	.text =
	    "Opens on the site in use, at the speed last asked about, else at "
	    "a held-out speed, else at 74 m/s. The arrow keys change the speed "
	    "by 0.1 m/s, ? lists the keys and q returns. Needs a terminal.",
	.example = "help tui",
	.run = cmd_tui},
    {.name = "quit",
	.alias = "exit",
	.brief = "quit the program",
	.flags = COMMAND_UNSAVED,
	.text = "The rest of a script is not run. At the prompt, q also quits.",
	.example = "quit",
	.run = cmd_quit},
    {.name = NULL}};

/* Commands about the store, as rows of the command table.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/lang/rows.h"
#include "cmd/lang/table.h"

const struct command TABLE_STORE[] = {
    {.name = "materials",
	.alias = "store list",
	.brief = "list the materials of the store, or show one",
	.operands = {"[NAME]", {"MATERIAL"}, 0, 1},
	.flags = COMMAND_DURING_SEARCH,
	.option = OPTION_LIST(
	    {TEXT(rock), NULL, "",
		"only this rock type; case and accents do not matter"},
	    {NUMBER(top), "mm", 0.1, 1000, NULL, "",
		"only top sizes within 5 % of this one"},
	    {CHOICE(origin), "all table3 own", "all",
		"materials of the paper, your own, or both"},
	    {WHOLE(most), "", 0, 1e9, NULL, "1000",
		"list at most this many of your own, by name; 0: all"}),
	.text = "Lists your own calibrations and the rows of the paper's Table "
		"3, which are called table3/... and are read only. With NAME, "
		"shows everything stored about one, including its origin.",
	.example = "store list rock=granite top=11.2\n"
		   "store list table3/tierp",
	.run = cmd_materials},
    {.name = "recall",
	.brief = "bring back what was remembered, at any time",
	.operands = {"NAME [SITE]", {"MATERIAL", "SITE"}, 0, 2},
	.flags = COMMAND_CHANGES | COMMAND_DAILY,
	.option = OPTION_LIST({TEXT(digest), NULL, "",
	    "refuse a material that has changed; written by save"}),
	.text = "Brings back what 'remember' stored. Without a site, or with "
		"the sheet that it was calibrated on, answers, bands and light "
		"are those of that day under today's settings, and cuts that "
		"are added continue from there. Another site, in use or SITE, "
		"gets the parameters, and the runs that they were found on "
		"inform its answers, which state that they are not calibrated "
		"on the site. A name that is not one of yours is looked up in "
		"Table 3, which has parameters only.",
	.example = "load data/sites/borlange.csv\nrecall tierp\npredict 74",
	.run = cmd_recall},
    {.name = "remember",
	.brief = "keep the site and its calibration for later sessions",
	.operands = {"[NAME|all]", {"all"}, 0, 1},
	.flags = COMMAND_NEEDS_SITE | COMMAND_UNSAVED | COMMAND_DAILY,
	.option = OPTION_LIST(
	    {TEXT(date), NULL, "",
		"date to store with it, such as 2026-11-21; default: today"},
	    {TEXT(note), NULL, "", "text to store with it"},
	    {OFF_ON(replace), "off", "replace a material of the same name"}),
	.text = "Stores a calibration with all it rests on: the runs of the "
		"site, those added since, the provenance of its data, misfit, "
		"hold-out RMSE, seed and options; or parameters set by 'params "
		"set'. 'recall' brings it back. NAME is by default the name of "
		"the site in 'sites'; all: every site that was calibrated, by "
		"that name. At the prompt it asks before it replaces a "
		"material. When the result is printed, it is already on the "
		"disk.",
	.example = "load data/sites/tierp.csv\ncalibrate\n"
		   "remember date=2026-11-21 note=\"after new liners\"\n"
		   "store list origin=own",
	.run = cmd_remember},
    {.name = "forget",
	.alias = "store forget",
	.brief = "remove one of your materials from the store",
	.operands = {"NAME", {"MATERIAL"}, 1, 1},
	.flags = COMMAND_UNSAVED,
	.text = "Prints the line that brings its parameters back; its origin "
		"is lost, unless 'export' saved it. Table 3 stays.",
	.example = "load data/sites/tierp.csv\n"
		   "params set f_mat=2 e0_min=17 alpha=0.95\n"
		   "remember trial\nstore forget trial",
	.run = cmd_forget},
    {.name = "export",
	.alias = "store export",
	.brief = "write your materials to a CSV file",
	.operands = {"FILE", {"FILE"}, 1, 1},
	.flags = COMMAND_FILES | COMMAND_UNSAVED,
	.option =
	    OPTION_LIST({OFF_ON(replace), "off", "overwrite an existing file"}),
	.text = "Writes all of your own materials, with exact numbers, for "
		"'import' into another store; Table 3 is in every store. It "
		"does not export predictions: use > FILE after a command.",
	.example = "store export materials.csv",
	.run = cmd_export},
    {.name = "import",
	.alias = "store import",
	.brief = "read materials from a CSV file",
	.operands = {"FILE", {"FILE"}, 1, 1},
	.flags = COMMAND_FILES | COMMAND_UNSAVED,
	.option = OPTION_LIST({OFF_ON(replace), "off",
	    "replace materials that have the same names"}),
	.text = "Reads what 'export' wrote, or a spreadsheet made from it. "
		"Every fault is reported with its place, and if there is one, "
		"nothing is imported. Names that are already in the store are "
		"faults without replace=on.",
	.example = "load data/sites/tierp.csv\n"
		   "params set f_mat=2 e0_min=17 alpha=0.95\nremember trial\n"
		   "store export trial.csv\nstore import trial.csv replace=on",
	.run = cmd_import},
    {.name = "guess",
	.brief = "estimate the product of an uncalibrated site",
	.flags = COMMAND_NEEDS_SITE,
	.bare = "speed",
	.option = OPTION_LIST(
	    {TEXT(rock), NULL, "", "rock type; default: that of the site file"},
	    {NUMBER(top), "mm", 0.1, 1000, NULL, "",
		"top size; default: that of the site file"},
	    {LAST_OR_USUAL_SPEED},
	    {WHOLE(nearest), "", 1, 100, NULL, "",
		"number of nearest materials to estimate from; default: the "
		"number that errs least when one site is left out"}),
	.shared = {SHARED_FEED},
	.text =
	    "The estimate is the median of the products with each material; "
	    "low and high are an 80 % band. All materials are used, unless the "
	    "nearest alone (the same rock type first, then the ratio of top "
	    "sizes) give clearly smaller errors when each site of Table 3 is "
	    "estimated from the others. The site needs only a feed, and its "
	    "own materials are left out. The leave-one-site-out error is that "
	    "of these estimates, on reconstructed data. An estimate from other "
	    "quarries is not a calibration.",
	.example = "load data/sites/tierp.csv\nguess rock=granite top=11.2",
	.answer = cmd_guess},
    {.name = NULL}};

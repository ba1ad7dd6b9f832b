/* Commands about the store, as rows of the command table.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/lang/table.h"

static const struct command_option MATERIALS_OPTIONS[] = {
    {"rock", VALUE_TEXT, "", 0, 0, NULL, "",
	"only this rock type; case and accents do not matter"},
    {"top", VALUE_NUMBER, "mm", 0.1, 1000, NULL, "",
	"only top sizes within 5 % of this one"},
    {"origin", VALUE_CHOICE, "", 0, 0, "all table3 own", "all",
	"materials of the paper, your own, or both"},
    {"most", VALUE_WHOLE, "", 0, 1e9, NULL, "1000",
	"list at most so many of your own, by name; 0: all"},
    {.name = NULL}};

static const struct command_option RECALL_OPTIONS[] = {
    {"digest", VALUE_TEXT, "", 0, 0, NULL, "",
	"refuse a material that has changed; written by save"},
    {.name = NULL}};

static const struct command_option REMEMBER_OPTIONS[] = {
    {"date", VALUE_TEXT, "", 0, 0, NULL, "",
	"date to store with it, such as 2026-11-21; default: today"},
    {"note", VALUE_TEXT, "", 0, 0, NULL, "", "text to store with it"},
    {"replace", VALUE_CHOICE, "", 0, 0, "off on", "off",
	"replace a material of the same name"},
    {.name = NULL}};

static const struct command_option EXPORT_OPTIONS[] = {
    {"replace", VALUE_CHOICE, "", 0, 0, "off on", "off",
	"overwrite an existing file"},
    {.name = NULL}};

static const struct command_option IMPORT_OPTIONS[] = {
    {"replace", VALUE_CHOICE, "", 0, 0, "off on", "off",
	"replace materials of the same names"},
    {.name = NULL}};

static const struct command_option GUESS_OPTIONS[] = {
    {"rock", VALUE_TEXT, "", 0, 0, NULL, "",
	"rock type; default: that of the site file"},
    {"top", VALUE_NUMBER, "mm", 0.1, 1000, NULL, "",
	"top size; default: that of the site file"},
    {"speed", VALUE_NUMBER, "m/s", 1, SITE_FASTEST, NULL, "",
	"rotor tip speed; default: a held-out speed, else 74"},
    {"nearest", VALUE_WHOLE, "", 1, 100, NULL, "",
	"number of nearest materials to estimate from; default: the number "
	"that errs least when one site is left out"},
    {.name = NULL}};

const struct command TABLE_STORE[] = {
    {.name = "materials",
	.alias = "store list",
	.brief = "list the materials of the store, or show one",
	.operands = {"[NAME]", {"MATERIAL"}, 0, 1},
	.flags = COMMAND_BESIDE,
	.option = MATERIALS_OPTIONS,
	.text = "Lists your own calibrations and the rows of the paper's Table "
		"3, which are called table3/... and are read only. With NAME, "
		"shows everything stored about one, including its origin.",
	.example = "store list rock=granite top=11.2\n"
		   "store list table3/tierp",
	.run = cmd_materials},
    {.name = "recall",
	.brief = "bring back a calibration from the store",
	.operands = {"NAME [SITE]", {"MATERIAL", "SITE"}, 0, 2},
	.flags = COMMAND_CHANGES,
	.option = RECALL_OPTIONS,
	.text = "Brings back what 'remember' stored. Without a site, or with "
		"the sheet that it was calibrated on, answers, bands and light "
		"are those of that day, and cuts that are added continue from "
		"there. Another site, in use or SITE, gets the parameters, and "
		"the runs that they were found on inform its answers, which "
		"state that they are not calibrated on the site. A name that "
		"is not one of yours is looked up in Table 3, which has "
		"parameters only.",
	.example = "load data/sites/borlange.csv\nrecall tierp\npredict 74",
	.run = cmd_recall},
    {.name = "remember",
	.brief = "store the site's calibration",
	.operands = {"[NAME|all]", {"all"}, 0, 1},
	.flags = COMMAND_AT_SITE | COMMAND_UNSAVED,
	.option = REMEMBER_OPTIONS,
	.text = "Stores a calibration with all it rests on: the runs of the "
		"site, those added since, the provenance of its data, misfit, "
		"hold-out RMSE, seed and options; or parameters set by 'params "
		"set'. 'recall' brings it back. NAME is by default the name of "
		"the site in 'sites'; all: every site "
		"that was calibrated, by that name. When the result is "
		"printed, it is on the disk.",
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
	.option = EXPORT_OPTIONS,
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
	.option = IMPORT_OPTIONS,
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
	.flags = COMMAND_AT_SITE,
	.bare = "speed",
	.option = GUESS_OPTIONS,
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

/* Commands about the store, as rows of the command table.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/table.h"

static const struct command_option MATERIALS_OPTIONS[] = {
    {"rock", VALUE_TEXT, "", 0, 0, NULL, "",
	"only this rock, without regard to case and accents"},
    {"top", VALUE_NUMBER, "mm", 0.1, 1000, NULL, "",
	"only top sizes within 5 % of this one"},
    {"origin", VALUE_CHOICE, "", 0, 0, "all table3 own", "all",
	"the paper's, your own, or both"},
    {.name = NULL}};

static const struct command_option RECALL_OPTIONS[] = {
    {"digest", VALUE_TEXT, "", 0, 0, NULL, "",
	"refuse a material that has changed; as save writes it"},
    {.name = NULL}};

static const struct command_option REMEMBER_OPTIONS[] = {
    {"date", VALUE_TEXT, "", 0, 0, NULL, "",
	"day to keep with it, such as 2026-11-21; never taken from the clock"},
    {"note", VALUE_TEXT, "", 0, 0, NULL, "", "words to keep with it"},
    {"replace", VALUE_CHOICE, "", 0, 0, "off on", "off",
	"take the place of one of that name"},
    {.name = NULL}};

static const struct command_option EXPORT_OPTIONS[] = {
    {"replace", VALUE_CHOICE, "", 0, 0, "off on", "off",
	"write over a file that is there"},
    {.name = NULL}};

static const struct command_option IMPORT_OPTIONS[] = {
    {"replace", VALUE_CHOICE, "", 0, 0, "off on", "off",
	"take the place of materials of the same names"},
    {.name = NULL}};

static const struct command_option GUESS_OPTIONS[] = {
    {"rock", VALUE_TEXT, "", 0, 0, NULL, "", "kind of rock; else the sheet's"},
    {"top", VALUE_NUMBER, "mm", 0.1, 1000, NULL, "",
	"top size; else the sheet's"},
    {"speed", VALUE_NUMBER, "m/s", 1, 200, NULL, "",
	"rotor tip speed; one held out, else 74"},
    {"nearest", VALUE_WHOLE, "", 1, 100, NULL, "5", "materials to guess from"},
    TABLE_FEED, {.name = NULL}};

const struct command TABLE_STORE[] = {
    {.name = "materials",
	.brief = "list the materials of the store, or show one",
	.operands = {"[NAME]", {"MATERIAL"}, 0, 1},
	.option = MATERIALS_OPTIONS,
	.text = "Your own calibrations and the rows of the paper's Table 3, "
		"which are called table3/... and are read only. With a NAME: "
		"all that is known of one, its origin included.",
	.example = "materials rock=granite top=11.2\nmaterials table3/tierp",
	.run = cmd_materials},
    {.name = "recall",
	.brief = "take a material's parameters from the store",
	.operands = {"NAME [SITE]", {"MATERIAL", "SITE"}, 1, 2},
	.flags = COMMAND_AT_SITE | COMMAND_CHANGES,
	.option = RECALL_OPTIONS,
	.text = "Gives the site in use, or SITE, the parameters of a "
		"material; a name that is none of yours is looked for in "
		"Table 3. They are shown as coming from the store wherever "
		"they are used, and never as a fit of the site.",
	.example = "load data/sites/borlange.csv\nrecall tierp\npredict 74",
	.run = cmd_recall},
    {.name = "remember",
	.brief = "put the site's parameters into the store",
	.operands = {"[NAME]", {""}, 0, 1},
	.flags = COMMAND_AT_SITE | COMMAND_UNSAVED,
	.option = REMEMBER_OPTIONS,
	.text = "Keeps what a calibration found, or 'params set' said, with "
		"its origin: the site and where its data are from, misfit, "
		"hold-out error, seed and options. NAME is by default what "
		"'sites' calls the site. When the result is printed it is on "
		"the disk.",
	.example = "load data/sites/tierp.csv\ncalibrate\n"
		   "remember date=2026-11-21 note=\"after new liners\"\n"
		   "materials origin=own",
	.run = cmd_remember},
    {.name = "forget",
	.brief = "take one of your materials out of the store",
	.operands = {"NAME", {"MATERIAL"}, 1, 1},
	.flags = COMMAND_UNSAVED,
	.text = "Prints the line that brings its parameters back; its origin "
		"is gone, unless 'export' saved it. Table 3 stays.",
	.example = "load data/sites/tierp.csv\n"
		   "params set f_mat=2 e0_min=17 alpha=0.95\n"
		   "remember trial\nforget trial",
	.run = cmd_forget},
    {.name = "export",
	.brief = "write your materials to a CSV file",
	.operands = {"FILE", {"FILE"}, 1, 1},
	.flags = COMMAND_FILES | COMMAND_UNSAVED,
	.option = EXPORT_OPTIONS,
	.text = "All of your own, with exact numbers, for 'import' into "
		"another store. Table 3 is in every store already.",
	.example = "export materials.csv",
	.run = cmd_export},
    {.name = "import",
	.brief = "take materials from a CSV file",
	.operands = {"FILE", {"FILE"}, 1, 1},
	.flags = COMMAND_FILES | COMMAND_UNSAVED,
	.option = IMPORT_OPTIONS,
	.text = "Reads what 'export' wrote, or a spreadsheet made of it. Every "
		"fault is named by its place, and if there is one nothing is "
		"taken. Names that the store has already are faults without "
		"replace=on.",
	.example = "load data/sites/tierp.csv\n"
		   "params set f_mat=2 e0_min=17 alpha=0.95\nremember trial\n"
		   "export trial.csv\nimport trial.csv replace=on",
	.run = cmd_import},
    {.name = "guess",
	.brief = "a first product for a site with no calibration",
	.flags = COMMAND_AT_SITE,
	.bare = "speed",
	.option = GUESS_OPTIONS,
	.text = "Takes the materials nearest to the site: the same rock "
		"before any other, then the top size by its ratio. The guess "
		"is the median of the products with each of them; least and "
		"most are their spread. The site needs a feed only, and its "
		"own materials are left out. The error of such guesses is "
		"that of Table 3's sites, each guessed from the others, on "
		"reconstructed data. Tells what to expect from other "
		"quarries, and is no calibration.",
	.example = "load data/sites/tierp.csv\nguess rock=granite top=11.2",
	.run = cmd_guess},
    {.name = NULL}};

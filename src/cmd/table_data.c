/* Commands that read, show and write sheets, as rows of the command table.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/table.h"

static const struct command_option SHOW_OPTIONS[] = {
    {"speed", VALUE_NUMBER, "m/s", 1, 200, NULL, "",
	"of the selection; one held out, else 74"},
    {.name = NULL}};

static const struct command_option LOAD_OPTIONS[] = {
    {"digest", VALUE_TEXT, "", 0, 0, NULL, "",
	"refuse a sheet with other numbers; as save writes it"},
    {.name = NULL}};

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
    {.name = NULL}};

static const struct command_option WRITE_OPTIONS[] = {
    {"replace", VALUE_CHOICE, "", 0, 0, "off on", "off",
	"write over files that are there"},
    {.name = NULL}};

const struct command TABLE_DATA[] = {
    {.name = "load",
	.brief = "read site files",
	.operands = {"FILE...", {"FILE"}, 1, OPERANDS - 1},
	.flags = COMMAND_CHANGES | COMMAND_FILES | COMMAND_UNSAVED,
	.option = LOAD_OPTIONS,
	.text = "Reads sieve sheets, see tipspeed-site(5), and makes the last "
		"one the site in use: CSV of a spreadsheet (Excel, "
		"LibreOffice), with commas or with semicolons and decimal "
		"commas, in per cent or grams, at tip speeds in m/s and not "
		"in turns (rpm). A sheet with faults is refused with the "
		"place of each fault; the sites already loaded stay. A sheet "
		"that is loaded again takes the place of the former. A name "
		"with blanks stands in quotes.",
	.example = "load data/sites/tierp.csv\nshow",
	.run = cmd_load},
    {.name = "sites",
	.brief = "list the loaded sites",
	.text = "The first column is what 'use' takes.",
	.example = "load data/sites/tierp.csv data/sites/bro.csv\nsites",
	.run = cmd_sites},
    {.name = "use",
	.brief = "choose the site to work on",
	.operands = {"SITE", {"SITE"}, 1, 1},
	.flags = COMMAND_AT_SITE | COMMAND_CHANGES | COMMAND_LOOKS,
	.text = "Case and accents do not matter: borlange finds Borlänge. "
		"Sites of one name are told apart by their top size: "
		"gavle/4, gavle/11.2.",
	.example = "load data/sites/borlange.csv data/sites/tierp.csv\n"
		   "use borlange\nshow",
	.run = cmd_use},
    {.name = "drop",
	.brief = "forget a site",
	.operands = {"SITE", {"SITE"}, 1, 1},
	.flags = COMMAND_AT_SITE | COMMAND_CHANGES,
	.text = "Its file stays. If it was in use, the site loaded after it "
		"is next, or else the one before.",
	.example = "load data/sites/bro.csv data/sites/tierp.csv\ndrop bro",
	.run = cmd_drop},
    {.name = "check",
	.brief = "look for faults in sheets",
	.operands = {"[SITE|all]", {"SITE all"}, 0, 1},
	.flags = COMMAND_AT_SITE,
	.text = "Looks at the site in use, another one, or all. Tells how many "
		"sieves and columns were read and what was not, and reports "
		"products coarser than their feed, a faster run with a coarser "
		"product or the very same one, a passing that stands out from "
		"its neighbours as "
		"swapped digits do, or from what the site is calibrated to, "
		"runs where nothing breaks, sieves that "
		"cannot be compared, and twins: loaded sites with the very "
		"same numbers. "
		"Nothing is changed. A fault (not a remark) ends a script "
		"with exit status 1.",
	.example = "load data/sites/ubbarp.csv data/sites/gasgruvan.csv\n"
		   "check all",
	.run = cmd_check},
    {.name = "show",
	.brief = "show a site, and what the model makes of it",
	.operands = {"[site|feed|product|params|bounds|model|models|"
		     "selection|appearance|store]",
	    {"site feed product params bounds model models selection "
	     "appearance store"},
	    0, 1},
	.option = SHOW_OPTIONS,
	.text = "site: where the sheet is from and what it holds; feed and "
		"product: the measured curves; params and bounds: as those "
		"commands do; model: settings, energy and break size at each "
		"run's speed, and the equations with their numbers; models: "
		"the breakage models and their parameters; "
		"selection: how much of each size class breaks at a speed "
		"(Eq 3), and how much of the feed that is; appearance: into "
		"which classes a broken one falls, the matrix of the paper's "
		"Table 1; store: where remembered materials are kept.",
	.example = "load data/sites/tierp.csv\n"
		   "params set f_mat=2.18 e0_min=16.74 alpha=0.96\n"
		   "show model\nshow selection speed=79",
	.run = cmd_show},
    {.name = "synth",
	.brief = "make sites from material parameters",
	.operands = {"FILE", {"FILE"}, 1, 1},
	.flags = COMMAND_CHANGES | COMMAND_FILES,
	.option = SYNTH_OPTIONS,
	.text = "FILE holds rows of parameters as data/table3.csv does. Each "
		"row becomes a site whose products are computed by the model, "
		"with sampling noise. Such sites say that they are not "
		"measured wherever they are shown.",
	.example = "synth data/table3.csv site=Tierp seed=9\nshow product",
	.run = cmd_synth},
    {.name = "write",
	.brief = "write site files",
	.operands = {"FILE|FOLDER", {"FILE"}, 1, 1},
	.flags = COMMAND_AT_SITE | COMMAND_FILES | COMMAND_UNSAVED,
	.option = WRITE_OPTIONS,
	.text = "Writes the site in use to FILE, or all loaded sites into an "
		"existing FOLDER under their own names. A file that is "
		"there is replaced with replace=on only. Sheets are "
		"written with commas and decimal points; results are saved "
		"with > FILE behind the command that gives them.",
	.example = "load data/sites/tierp.csv\nwrite tierp-copy.csv",
	.run = cmd_write},
    {.name = NULL}};

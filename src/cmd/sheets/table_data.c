/* Commands that read, show and write sheets, as rows of the command table.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/lang/rows.h"
#include "cmd/lang/table.h"

/* Options of load and add, which both read sheets. */
#define SHEET_OPTIONS                                                       \
	{TEXT(columns), NULL, "",                                           \
	    "what the columns are, by number: \"1=sieve mm, 2=feed "        \
	    "retained_g, 4=product@70\"; others are left out"},             \
	    {TEXT(samples), NULL, "",                                       \
		"what samples are, by name: \"S01=feed, S02=@70\"; others " \
		"are left out"},                                            \
	    {TEXT(sheet), NULL, "", "sheet of a workbook"},                 \
	    {TEXT(range), NULL, "",                                         \
		"part of a sheet, such as A3:F20; default: all"},           \
	    {CHOICE(decimal), "point comma", "",                            \
		"decimal sign, if the numbers do not show which it is"},    \
	    {NUMBER(top), "mm", 1e-6, 1e4, NULL, "",                        \
		"size that all of the feed passes, an assumption"},         \
	{                                                                   \
		NUMBER(rotor_mm), "mm", 100, 5000, NULL, "",                \
		    "diameter of the rotor, for speeds in rpm"              \
	}

const struct command TABLE_DATA[] = {
    {.name = "load",
	.brief = "read the sieve sheets of a site",
	.operands = {"FILE|FOLDER|NAME...", {"FILE SHIPPED"}, 1, OPERANDS - 1},
	.flags =
	    COMMAND_CHANGES | COMMAND_FILES | COMMAND_UNSAVED | COMMAND_DAILY,
	.option = OPTION_LIST(SHEET_OPTIONS,
	    {CHOICE(as), "site log", "site",
		"log: the plant's log of rpm, kW and t/h, for 'add FILE@TIME'"},
	    {CHOICE(dates), "day-first month-first", "",
		"order in dates of a log such as 5/3/2026, if they do not show "
		"it"},
	    {OFF_ON(skip), "off",
		"on: files that cannot be read are listed and left out, and a "
		"script continues"},
	    {TEXT(digest), NULL, "",
		"refuse a file with other numbers; written by save"}),
	.text = "Reads workbooks (Excel, LibreOffice) and CSV in any of the "
		"forms of tipspeed-site(5), and makes the last site the one in "
		"use. Reports how it read each column, and asks about what a "
		"sheet leaves open; in a script that is an error, and the hint "
		"is a command that answers the question. Files form one site "
		"if a speed follows a name, or if none has both feed and "
		"product: load feed.csv cut1.csv@70 cut2.csv@1650rpm. A folder "
		"stands for the sheets in it; NAME is a site that comes with "
		"the program: load tierp. A sheet with faults is refused, each "
		"fault with its place; a site that is loaded again replaces "
		"the earlier one. Quote a name with spaces.",
	.more =
	    "The report says how sure the reading of each column is. If a "
	    "sheet has its sieves in columns, columns= takes the numbers of "
	    "lines. Results written by tipspeed are not read as sheets. A "
	    "file is loaded rather than a site of the program with the same "
	    "name. If a file is refused, the other files are still loaded, and "
	    "sites loaded before stay. The refused files are listed at the "
	    "end, where a script then stops unless skip=on. With as=log the "
	    "files are a plant's log for 'add': rows with date and time, and "
	    "columns headed rpm or m/s, kW (W, MW, hp) and t/h (kg/s, t/d); "
	    "its columns= are named time, rpm, m/s, kW, t/h.",
	.example = "load data/sites/tierp.csv\n"
		   "load data/sites/bro.csv columns=\"1=sieve mm, 2=feed, "
		   "3=product@69\"\nshow",
	.run = cmd_load},
    {.name = "add",
	.brief = "add belt cuts taken on later days to the site in use",
	.operands = {"FILE@SPEED...", {"FILE"}, 1, OPERANDS - 1},
	.flags = COMMAND_NEEDS_SITE | COMMAND_CHANGES | COMMAND_FILES |
		 COMMAND_DAILY,
	.option = OPTION_LIST(SHEET_OPTIONS,
	    {TEXT(date), NULL, "",
		"day of the cuts: 2026-05-03; default: as their sheet has it"},
	    {CHOICE(dates), "day-first month-first", "",
		"order in dates like 5/3/2026"},
	    {NUMBER(window), "min", 0.1, 600, NULL, "10",
		"minutes of the log, half before the time and half after it"},
	    {TEXT(digest), NULL, "",
		"refuse cuts that give the site other numbers; written by "
		"save"}),
	.text = "Reads samples of product, as load does, and adds each to the "
		"site in use as one more run: at the speed after @, or at that "
		"of the sheet. After 'load LOG as=log' it may be a time, as in "
		"cut.csv@2026-05-03T10:15: the speed is then the median of the "
		"log around it, and its power and feed rate are noted. A cut's "
		"day is in its line or heading or above the table; its feed is "
		"the site's unless its sheet has one. The parameters stay, and "
		"the cut is compared at once with what they predict; "
		"'calibrate train=all' also includes the cut. The site's own "
		"file stays as it is: 'write' saves the site with its cuts, "
		"and a line 'cut' for each. 'undo' takes the cuts out again.",
	.example = "load data/sites/tierp.csv\ncalibrate\n"
		   "add data/cuts/tierp-72.csv@72 date=2026-05-03\n"
		   "load data/cuts/log.csv as=log\n"
		   "add data/cuts/tierp-72.csv@2026-05-03T10:15 rotor_mm=900",
	.run = cmd_add},
    {.name = "sites",
	.alias = "show sites",
	.brief = "list the loaded sites",
	.flags = COMMAND_DURING_SEARCH,
	.text = "The first column has the names for 'use'.",
	.example = "load data/sites/tierp.csv data/sites/bro.csv\nshow sites",
	.run = cmd_sites},
    {.name = "use",
	.brief = "choose the site to work on",
	.operands = {"SITE", {"SITE"}, 1, 1},
	.flags = COMMAND_NEEDS_SITE | COMMAND_CHANGES | COMMAND_APPEARANCE,
	.text = "Case and accents do not matter: borlange finds Borlänge. "
		"Sites with the same name are distinguished by top size: "
		"gavle/4, gavle/11.2.",
	.example = "load data/sites/borlange.csv data/sites/tierp.csv\n"
		   "use borlange\nshow",
	.run = cmd_use},
    {.name = "drop",
	.brief = "unload a site",
	.operands = {"SITE", {"SITE"}, 1, 1},
	.flags = COMMAND_NEEDS_SITE | COMMAND_CHANGES,
	.text = "Its file stays. If it was in use, the site loaded after it "
		"comes into use, or else the one before.",
	.example = "load data/sites/bro.csv data/sites/tierp.csv\ndrop bro",
	.run = cmd_drop},
    {.name = "check",
	.brief = "look for faults in site files",
	.operands = {"[SITE|all]", {"SITE all"}, 0, 1},
	.flags = COMMAND_NEEDS_SITE | COMMAND_DAILY,
	.text =
	    "Checks the site in use, another one, or all. Reports how many "
	    "sieves and columns were read and what was left out; products "
	    "coarser than their feed; a faster run with a coarser or an "
	    "identical product; a passing that differs from its neighbours, as "
	    "transposed digits do, or, once calibrated, from what all other "
	    "passings make probable; runs where nothing breaks; sieves that "
	    "cannot be compared; and loaded sites with identical data. For the "
	    "site in use it proposes mends, numbered for the command mend. "
	    "Nothing is changed. A fault (not a remark) ends a script with "
	    "exit status 1.",
	.example = "load data/sites/ubbarp.csv data/sites/gasgruvan.csv\n"
		   "check all",
	.run = cmd_check},
    {.name = "mend",
	.brief = "mend a site file's data as check proposes",
	.operands = {"[N|COLUMN]", {"feed"}, 0, 1},
	.flags = COMMAND_NEEDS_SITE | COMMAND_CHANGES,
	.option = OPTION_LIST({NUMBER(sieve), "mm", 1e-6, 1e6, NULL, "",
				  "sieve of the passing to mend"},
	    {NUMBER_NAMED("value", mend_value), "%", 0, 100, NULL, "",
		"read the passing at sieve= as this"},
	    {CHOICE_NAMED("do", mend_do), "out swap up down drop", "",
		"leave the passing at sieve= out; swap a product with its "
		"feed; move a column to the next coarser (up) or finer sieves; "
		"drop a run"},
	    {TEXT(with), NULL, "", "exchange two products: product@79"},
	    {NUMBER(scale), "", 1e-6, 1e6, NULL, "",
		"multiply the column's sieve sizes, such as by 0.001"}),
	.text = "Applies mend N of the last check of the site in use, or lists "
		"them without N. A column (product@79, feed, feed@79) with "
		"options says in full what to do, as save writes it. The mend "
		"is added to the provenance, so that all results show it; "
		"parameters that were calibrated on the former numbers are "
		"dropped. The file stays as it is: write saves the mended "
		"sheet. undo reverses a mend. Nothing is mended unless you say "
		"so: look at the laboratory's sheet first.",
	.example = "load data/sites/tierp.csv\n"
		   "mend product@74 sieve=4 do=out\nundo",
	.run = cmd_mend},
    {.name = "show",
	.brief = "show a site and its model",
	.operands = {"[site | feed | product | params | fit | bounds | model | "
		     "models | selection | appearance | equations | claims | "
		     "search | store | log]",
	    {"site feed product params fit bounds model models selection "
	     "appearance equations claims search store log"},
	    0, 1},
	.flags = COMMAND_DURING_SEARCH,
	.option = OPTION_LIST({LAST_OR_USUAL_SPEED},
	    {WHOLE(every), "", 1, 1e6, NULL, "",
		"search: every N-th generation; default: as many as fit a "
		"screen"}),
	.shared = {SHARED_FEED},
	.text =
	    "site: the site file, its source and contents; feed and product: "
	    "the measured curves; params and bounds: as those commands print "
	    "them; fit: the last calibration: parameters and search; model: "
	    "settings, energy and break size at each run's speed, and the "
	    "equations with their numbers; models: the breakage models and "
	    "their parameters; selection: how much of each size class breaks "
	    "at a speed (selection function, Eq 3), and its share of the feed; "
	    "appearance: the size classes of the progeny of each broken class "
	    "(appearance function, Eq 1, the matrix of the paper's Table 1); "
	    "equations: Eqs 1 to 5 as printed and as used, and what the "
	    "printed forms would give at the site; claims: what the paper "
	    "concludes, compared with the calibrated sites; search: the "
	    "generations of the last calibration; store: where remembered "
	    "materials are kept; log: what the plant's log has.",
	.example = "load data/sites/tierp.csv\n"
		   "params set f_mat=2.18 e0_min=16.74 alpha=0.96\n"
		   "show model\nshow selection speed=79",
	.run = cmd_show},
    {.name = "synth",
	.brief = "make synthetic sites from material parameters",
	.operands = {"FILE", {"FILE table3"}, 1, 1},
	.flags = COMMAND_CHANGES | COMMAND_FILES,
	.option = OPTION_LIST(
	    {TEXT(site), NULL, "", "make only the sites with this name"},
	    {NUMBER_NAMED("n", exponent), "", 0.05, 5, NULL, "1",
		"exponent of the feed below the top size"},
	    {NUMBER(noise), "", 0, 10, NULL, "0.5",
		"standard deviation in points at 50 % passing"},
	    {WHOLE(seed), "", 0, 9223372036854774784.0, NULL, "1",
		"seed of the noise"},
	    {NUMBERS(speeds), "m/s", 1, SITE_FASTEST, NULL, "69,74,79",
		"tip speeds, slow to fast"}),
	.text = "FILE has rows of parameters like data/table3.csv; the word "
		"table3 stands for that table if there is no file of this "
		"name. Each row becomes a synthetic site whose products are "
		"computed by the model, with sampling error added. Such sites "
		"are marked as not measured wherever they are shown.",
	.example = "synth data/table3.csv site=Tierp seed=9\nshow product",
	.run = cmd_synth},
    {.name = "energy",
	.brief = "load and show collision energies",
	.operands = {"[load FILE | write FILE]", {"load write", "FILE"}, 0, 2},
	.flags = COMMAND_CHANGES | COMMAND_FILES,
	.option = OPTION_LIST(
	    {NUMBER_NAMED("cut", energy_cut), "J/kg", 0, 1e6, NULL, "",
		"impacts below it do not count; default: as loaded, else 10"},
	    {SPEED(speed), "load: tip speed of the simulation; else: scale the "
			   "energies to it by v^2"},
	    {TEXT(columns), NULL, "",
		"load: names of the columns in order, with commas between; - "
		"for one to skip"},
	    {CHOICE(unit), "j_kg m_s", "",
		"load: of a list of numbers without headings"},
	    {TEXT(note), NULL, "", "load: where the energies are from"}),
	.text =
	    "Collision energies of a discrete element simulation: how often "
	    "particles are hit and how hard, as in the paper's Figure 1. "
	    "'energy load FILE' reads a table of impacts by its column "
	    "headings, a list of energies (J/kg) or velocities (m/s), perhaps "
	    "with weights, or a binned spectrum (low, high and weight); "
	    "dem/merge makes such a table from a LIGGGHTS dump of contacts. "
	    "Without operands, shows impacts per particle, energies above the "
	    "cut, the share of the first impact and the k with which Eq 3 "
	    "would break as much. 'energy write FILE' writes the spectrum. "
	    "'set energy FILE' makes the model use it instead of one impact "
	    "at v^2/2.",
	.example = "energy load data/energy/vsi-69.csv\nenergy cut=100",
	.run = cmd_energy},
    {.name = "template",
	.brief = "show an empty site file to fill in",
	.option =
	    OPTION_LIST({NUMBERS(speeds), "m/s", 1, SITE_FASTEST, NULL, "69,79",
			    "tip speeds of the products, a column each"},
		{CHOICE(unit), "passing_pct retained_g", "passing_pct",
		    "what the numbers will be"},
		{NUMBERS(sieves), "mm", 0.001, 1000, NULL, "",
		    "sieves, a row each; default: the usual ones of EN 933"}),
	.text = "Remarks in it explain its lines and columns. Write it to a "
		"file (> FILE.csv or > FILE.xlsx), fill it in with a "
		"spreadsheet program, and load it.",
	.example = "template > my.csv\n"
		   "template speeds=60,65,70 unit=retained_g > lab.xlsx",
	.run = cmd_template},
    {.name = "write",
	.brief = "write site files",
	.operands = {"FILE|FOLDER", {"FILE"}, 1, 1},
	.flags = COMMAND_NEEDS_SITE | COMMAND_FILES | COMMAND_UNSAVED,
	.option =
	    OPTION_LIST({OFF_ON(replace), "off", "overwrite existing files"}),
	.text = "Writes the site file of the site in use to FILE, or those of "
		"all loaded sites into an existing FOLDER under their own "
		"names. Existing files are replaced only with replace=on. Site "
		"files have commas and decimal points. Results are saved with "
		"> FILE after a command, not with write.",
	.example = "load data/sites/tierp.csv\nwrite tierp-copy.csv",
	.run = cmd_write},
    {.name = NULL}};

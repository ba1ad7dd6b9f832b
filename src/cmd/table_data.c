/* Commands that read, show and write sheets, as rows of the command table.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/table.h"

#include "cmd/data.h"

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
    LAST_OPTION};

static const struct command_option WRITE_OPTIONS[] = {
    {"replace", VALUE_CHOICE, "", 0, 0, "off on", "off",
	"write over files that are there"},
    LAST_OPTION};

const struct command TABLE_DATA[] = {
    {.name = "load",
	.group = "data",
	.brief = "read site files",
	.operands = "FILE...",
	.expect = {"FILE"},
	.least = 1,
	.most = OPERANDS - 1,
	.text = "Reads sieve sheets, see tipspeed-site(5), and makes the last "
		"one the site in use. A sheet with faults is refused with the "
		"place of each fault; the sites already loaded stay.",
	.example = "load data/sites/tierp.csv\nshow",
	.run = cmd_load},
    {.name = "sites",
	.group = "data",
	.brief = "list the loaded sites",
	.operands = "",
	.text = "The first column is what 'use' takes.",
	.example = "load data/sites/tierp.csv data/sites/bro.csv\nsites",
	.run = cmd_sites},
    {.name = "use",
	.group = "data",
	.brief = "choose the site to work on",
	.operands = "SITE",
	.expect = {"SITE"},
	.least = 1,
	.most = 1,
	.need = NEED_SITE,
	.text = "Case and accents do not matter: borlange finds Borlänge. "
		"Sites of one name are told apart by their top size: "
		"gavle/4, gavle/11.2.",
	.example = "load data/sites/borlange.csv data/sites/tierp.csv\n"
		   "use borlange\nshow",
	.run = cmd_use},
    {.name = "check",
	.group = "data",
	.brief = "look for faults in sheets",
	.operands = "[SITE|all]",
	.expect = {"SITE all"},
	.most = 1,
	.need = NEED_SITE,
	.text = "Looks at the site in use, another one, or all. Reports "
		"products coarser than their feed, a faster run with a coarser "
		"product, runs where nothing breaks, sieves that cannot be "
		"compared, and twins: loaded sites with the very same numbers. "
		"Nothing is changed. A fault (not a remark) ends a script "
		"with exit status 1.",
	.example = "load data/sites/ubbarp.csv data/sites/gasgruvan.csv\n"
		   "check all",
	.run = cmd_check},
    {.name = "show",
	.group = "data",
	.brief = "show what a sheet says",
	.operands = "[site|feed|product]",
	.expect = {"site feed product"},
	.most = 1,
	.need = NEED_SITE,
	.text = "site: where the sheet is from and what it holds; feed and "
		"product: the measured curves.",
	.example = "load data/sites/tierp.csv\nshow product",
	.run = cmd_show},
    {.name = "synth",
	.group = "data",
	.brief = "make sites from material parameters",
	.operands = "FILE",
	.expect = {"FILE"},
	.least = 1,
	.most = 1,
	.option = SYNTH_OPTIONS,
	.text = "FILE holds rows of parameters as data/table3.csv does. Each "
		"row becomes a site whose products are computed by the model, "
		"with sampling noise. Such sites say that they are not "
		"measured wherever they are shown.",
	.example = "synth data/table3.csv site=Tierp seed=9\nshow product",
	.run = cmd_synth},
    {.name = "write",
	.group = "data",
	.brief = "write site files",
	.operands = "FILE|FOLDER",
	.expect = {"FILE"},
	.least = 1,
	.most = 1,
	.need = NEED_SITE,
	.option = WRITE_OPTIONS,
	.text = "Writes the site in use to FILE, or all loaded sites into an "
		"existing FOLDER under their own names. A file that is "
		"there is replaced with replace=on only. Sheets are "
		"written with commas and decimal points; results are saved "
		"by the shell: tipspeed --format=csv ... >FILE.",
	.example = "load data/sites/tierp.csv\nwrite tierp-copy.csv",
	.run = cmd_write},
    {.name = NULL}};

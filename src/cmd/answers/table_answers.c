/* Commands that answer questions, as rows of the command table.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/lang/rows.h"
#include "cmd/lang/table.h"

#define LAST_SPEED    \
	SPEED(speed), \
	    "rotor tip speed; default: that last asked about, with its feed"

/* The options of a crusher with its screens, which flow and card share; see
 * plant_from_args. */
#define FLOW_PARTS                                                          \
	{TEXT(fractions), NULL, "0/2,2/5,5/8,8/11.2",                       \
	    "fractions of the product, mm"},                                \
	    {TEXT(recycle), NULL, "",                                       \
		"fractions that go back to the crusher"},                   \
	    {PATH(circuit), "circuit file, instead of fractions"},          \
	    {TEXT(power), NULL, "",                                         \
		"motor power readings as m/s:kW:t/h, separated by commas; " \
		"default: "                                                 \
		"those of belt cuts"},                                      \
	    {TEXT(prices), NULL, "",                                        \
		"price per t of each product, such as 0/2:12,2/5:9"},       \
	{                                                                   \
		NUMBER(kwh), "", 0, 1e6, NULL, "0", "price per kWh"         \
	}

/* An image shows the range of speeds without it, too. */
#define BEST "best=on prices=0/2:12,2/5:9 >"

const struct command TABLE_ANSWERS[] = {
    {.name = "predict",
	.others = {"sweep", "figures", "card"},
	.brief = "the product at a tip speed",
	.flags = COMMAND_NEEDS_SITE | COMMAND_KEEPS_LAST | COMMAND_DRAWS |
		 COMMAND_DURING_SEARCH | COMMAND_DAILY | COMMAND_QUANTITIES,
	.bare = "speed",
	.option = OPTION_LIST({LAST_OR_USUAL_SPEED},
	    {OFF_ON(curve), "off", "draw feed, measured and predicted as text"},
	    {OFF_ON(interpolated), "off",
		"add the measured products interpolated at this speed"},
	    {OFF_ON(band), "on",
		"show the uncertainty band of a calibrated product"},
	    {OFF_ON(detail), "off",
		"on: show the model alone, specific energy and break size "
		"too"}),
	.shared = {SHARED_RPM, SHARED_FEED, SHARED_MACHINE, SHARED_SIEVES,
	    SHARED_CUT},
	.text =
	    "Needs parameters: run calibrate or params set first. Outside the "
	    "training speeds the result is marked as extrapolated. "
	    "interpolated=on adds the products measured at the next lower and "
	    "higher speed, interpolated in speed squared: the prediction "
	    "without the model. If the parameters were found by calibrate, the "
	    "product is the model corrected for what the measured runs show "
	    "that it leaves out; 'set correction' chooses the runs. low and "
	    "high are the uncertainty band: the true value lies between them "
	    "with the probability in the title. See UNCERTAINTY in "
	    "tipspeed-model(7). feed=FILE predicts with the feed of any sheet "
	    "that load reads, rpm= gives the speed in rpm, and rotor_mm=, "
	    "cascade= and k= ask about another machine; see OTHER FEEDS AND "
	    "MACHINES. After >, a file whose name ends in .svg, .png or .pdf "
	    "gets the curves, as plot psd draws them. With names of figures "
	    "after the speed, only these are shown: predict 72 passing 2 P80. "
	    "Several speeds are shown side by side: predict 65..85:5. The "
	    "options are then those of figures, sweep or card.",
	.example = "load data/sites/tierp.csv\ncalibrate\npredict 74\n"
		   "predict 72 passing 2 P80",
	.answer = cmd_predict},
    {.name = "blend",
	.brief = "mix feeds by mass, and predict the product",
	.operands = {"FILE=PART FILE=PART..", {"FILE"}, 2, 20},
	.flags = COMMAND_FILES,
	.option = OPTION_LIST({LAST_OR_USUAL_SPEED},
	    {PATH(out),
		"write the blended feed as a sheet, for load and feed="},
	    {OFF_ON(replace), "off", "overwrite an existing sheet"}),
	.text =
	    "Reads the feeds of several sheets (FILE@SPEED where a sheet has "
	    "one for each speed) and mixes them, in parts by mass that need "
	    "not sum to 100. The blend has the sieves of all feeds, as far "
	    "down as all were sieved; between sieves, passing is linear in log "
	    "size. If the site in use has parameters, the product of the blend "
	    "is predicted with its band and its light, as predict does with "
	    "feed=. out=FILE writes the blend as a sheet.",
	.example = "load data/sites/tierp.csv\n"
		   "params set f_mat=2.18 e0_min=16.74 alpha=0.96\n"
		   "blend data/sites/tierp.csv@69=60 data/sites/bro.csv@69=40",
	.run = cmd_blend},
    {.name = "sweep",
	.brief = "products over a range of speeds",
	.flags = COMMAND_NEEDS_SITE | COMMAND_NEEDS_PARAMS,
	.bare = "speeds",
	.option = OPTION_LIST({NUMBERS(speeds), "m/s", 1, SITE_FASTEST, NULL,
	    "", "rotor tip speeds; default: at most seven round ones"}),
	.shared = {SHARED_FEED, SHARED_MACHINE, SHARED_SIEVES, SHARED_CUT},
	.text =
	    "Predicts at several speeds, as predict 65..85:5 does. "
	    "Up to seven speeds are shown side by side, sieve by sieve; "
	    "more are listed one per row. Without speeds= it takes round "
	    "speeds, in rpm for a sheet in rpm, within 65 to 85 m/s and the "
	    "runs outside that range; if all runs are below 32.5 or above 170 "
	    "m/s, within the range around them only.",
	.example = "load data/sites/tierp.csv\ncalibrate\nsweep 65,74,85\n"
		   "predict 65..85:5",
	.answer = cmd_sweep},
    {.name = "card",
	.brief = "one page for the cabin: what each speed gives",
	.operands = {"[SPEED...] [FIGURE... | CONDITION...]", {""}, 0,
	    OPERANDS - 1},
	.flags = COMMAND_NEEDS_SITE | COMMAND_NEEDS_PARAMS |
		 COMMAND_CONDITIONS | COMMAND_QUANTITIES,
	.option = OPTION_LIST(
	    {NUMBERS(speeds), "m/s", 1, SITE_FASTEST, NULL, "",
		"rotor tip speeds; a range has the speeds measured in it too; "
		"default 65..85 by 1, or round rpm of a sheet in rpm, extended "
		"or moved to cover the runs, and the speed last asked about"},
	    {TEXT(of), NULL, "passing 2,fines",
		"figures beside P20, P50 and P80, see figures"},
	    {NUMBER(tph), "t/h", 0.001, 1e5, NULL, "",
		"new feed, for tonnes and kWh/t as in flow"},
	    FLOW_PARTS,
	    {SPEC(spec), "grading envelope: a name of 'spec list', or a file"}),
	.shared = {SHARED_FEED, SHARED_MACHINE, SHARED_CUT},
	.text = "One row for each speed, in m/s and, where the site states the "
		"rotor's diameter, in rpm: P20, P50 and P80, the figures that "
		"are named, the range of one of them and its measured value, "
		"tonnes of fractions, and the light. With the conditions of "
		"window, spec= or a goal that is set, it also shows how "
		"certain they are to be met. Below it: the date, the feed, the "
		"machine, the model, and whether each speed rests on "
		"measurements or on the model alone. In text, columns that do "
		"not fit into 80 characters are left out and named; files "
		"have all. 'card > card.pdf' makes a page to pin up.",
	.example = "load data/sites/tierp.csv\ncalibrate\n"
		   "card 65..85:5 0/2 fines tph=120 fractions=0/2,2/5,5/8\n"
		   "card 66..81:5 passing 2 >= 33",
	.answer = cmd_card},
    {.name = "compare",
	.brief = "two speeds or two sites side by side",
	.operands = {"SPEED SPEED | SITE SITE | pinned SPEED",
	    {"SPEED SITE pinned"}, 2, 2},
	.flags = COMMAND_NEEDS_SITE | COMMAND_DRAWS | COMMAND_QUANTITIES,
	.option = OPTION_LIST(
	    {SPEED(speed),
		"speed for two sites; default: that last asked about, else a "
		"held-out speed, else 74"},
	    {TEXT(of), NULL, "",
		"figures, see figures; default: the curves and sizes"}),
	.shared = {SHARED_FEED, SHARED_MACHINE, SHARED_SIEVES, SHARED_CUT},
	.text =
	    "Compares the predicted products of the site in use at two speeds, "
	    "with the same feed, or of two loaded sites at one speed, each "
	    "with its own feed: passing sieve by sieve and the difference "
	    "(second minus first), P20, P50, P80 and the break sizes; or the "
	    "figures that are named, and says where they are higher. 'pinned' "
	    "is what pin has kept, with its own site and feed; the difference "
	    "then has no band. > FILE.svg, .png or .pdf draws both.",
	.example = "load data/sites/tierp.csv\n"
		   "params set f_mat=2.18 e0_min=16.74 alpha=0.96\n"
		   "compare 69 79\ncompare 69 79 2/4 P80",
	.run = cmd_compare},
    {.name = "pin",
	.brief = "keep a prediction to compare others with",
	.operands = {"[off]", {"off"}, 0, 1},
	.flags = COMMAND_CHANGES | COMMAND_DURING_SEARCH,
	.bare = "speed",
	.option = OPTION_LIST({LAST_SPEED},
	    {FEED(feed), "m/s", 1, SITE_FASTEST, NULL, "",
		"take the feed sampled at this speed, or the mean"}),
	.text = "Keeps the product that is predicted now for the site in use "
		"at a speed, even if the site is calibrated again: full-screen "
		"mode shows it beside the prediction, and so do plot psd and "
		"describe psd with beside=pinned. 'pin off' unpins it.",
	.example = "load data/sites/tierp.csv\ncalibrate\npin 69\n"
		   "describe psd speed=74 beside=pinned",
	.run = cmd_pin},
    {.name = "figures",
	.brief = "sizes, moduli and shares of a product",
	.flags = COMMAND_NEEDS_SITE | COMMAND_NEEDS_PARAMS | COMMAND_QUANTITIES,
	.bare = "speed",
	.option = OPTION_LIST({LAST_OR_USUAL_SPEED},
	    {TEXT(of), NULL, "",
		"figures, with commas between: P80, passing 2, "
		"over 8, fm EN, 0/4, P50 of 0/4"}),
	.shared = {SHARED_RPM, SHARED_FEED, SHARED_MACHINE, SHARED_CUT},
	.text =
	    "Does the same as predict with the names of figures, predict 72 "
	    "passing 2 P80, or with of=, predict 72 of=fm,D10,0/2. Shows "
	    "single numbers of the product at a speed, with their bands: P or "
	    "D and a number, the size that this percentage passes; passing and "
	    "a size; fines, the passing at 0.063 mm; cu, D60/D10; cc, "
	    "D30^2/(D60 D10); fm and a standard, the fineness modulus on the "
	    "sieves of EN 12620, ASTM C136, IS 2386-1, DIN 1045-2 (the "
	    "k-value) or GB/T 14684; and a fraction such as 0/2, its share of "
	    "the product. 'of 0/4' after a figure, or cut=0/4 for all of them, "
	    "takes that screened fraction. Figures that the sieves do not "
	    "reach are left out, or missing. For each figure that is named, a "
	    "sentence gives the range in which a new belt cut may fall.",
	.example = "load data/sites/tierp.csv\ncalibrate\nfigures 72\n"
		   "figures 72 of=\"D10,fm EN of 0/4,0/2\"",
	.answer = cmd_figures},
    {.name = "find",
	.brief = "find the speed that gives a wanted product",
	.operands = {"[CONDITION...]", {""}, 0, OPERANDS - 1},
	.flags = COMMAND_NEEDS_SITE | COMMAND_NEEDS_PARAMS | COMMAND_DAILY |
		 COMMAND_CONDITIONS,
	.option = OPTION_LIST(
	    {NUMBER(p20), "mm", 1e-6, 1e4, NULL, "", "wanted P20"},
	    {NUMBER(p50), "mm", 1e-6, 1e4, NULL, "", "wanted P50"},
	    {NUMBER(p80), "mm", 1e-6, 1e4, NULL, "", "wanted P80"},
	    {NUMBER(passing), "%", 0, 100, NULL, "", "wanted passing",
		.needs = "at=2"},
	    {NUMBER(at), "mm", 1e-6, 1e4, NULL, "", "size for that passing",
		.needs = "passing=45"},
	    {SPEC(spec), "grading envelope: a name of 'spec list', or a file"},
	    {SPEED(from),
		"slowest speed; default 65, or less to cover the runs"},
	    {SPEED(to), "fastest speed; default 85, or more to cover the runs"},
	    {OFF_ON(detail), "off", "on: also other speeds and sizes found"}),
	.shared = {SHARED_FEED, SHARED_MACHINE, SHARED_CUT},
	.text =
	    "The inverse of predict: finds the tip speed for a P20, P50 or "
	    "P80, for a passing at a size, or the speeds at which the product "
	    "meets a grading envelope; see spec and tipspeed-spec(5). "
	    "Conditions are written as for window. The one with = and a single "
	    "number is the target; \"max passing 2\" or \"min P80\" asks for "
	    "the speed with the largest or smallest value instead. Other "
	    "conditions are checked at that speed, or limit the choice. The "
	    "default is 'set goal'. The first range of a speed is for the true "
	    "product, the second for what a belt cut may show.",
	.more =
	    "At a limit the condition holds with only about 50 % certainty, so "
	    "the best speed with 80 % certainty (set level) is also reported. "
	    "If several speeds give the value, those that meet the other "
	    "conditions come first, then the one inside the training speeds, "
	    "or nearest to them; the others are named. If no speed does, the "
	    "products at both ends are shown, or the nearest speed and what "
	    "fails. Without from= and to= it searches the range of sweep, all "
	    "with one feed: the mean of those sampled, unless feed= is given.",
	.example = "load data/sites/tierp.csv\n"
		   "params set f_mat=2.18 e0_min=16.74 alpha=0.96\n"
		   "find p80=5\nfind passing=40 at=2\n"
		   "find \"passing 2 = 33\" \"passing 0.063 < 6\"\n"
		   "find \"max passing 2\" \"P80 > 5\"\nfind \"max 2/4\"\n"
		   "find spec=data/specs/en-12620-0-8.csv\n"
		   "find spec=\"EN 12620 0/8\"",
	.answer = cmd_find},
    {.name = "flow",
	.brief = "tonnes of fractions, circulating load, power, earnings",
	.flags = COMMAND_NEEDS_SITE | COMMAND_NEEDS_PARAMS | COMMAND_DRAWS |
		 COMMAND_DAILY,
	.bare = "tph",
	.option = OPTION_LIST({NUMBER(tph), "t/h", 1e-3, 1e5, NULL, "",
				  "new feed; default: that of circuit="},
	    {LAST_SPEED}, FLOW_PARTS,
	    {OFF_ON(best), "off", "find the speed that earns most"},
	    {SPEED(from),
		"slowest speed of best=on; default 65, or less "
		"to cover the runs",
		.needs = BEST},
	    {SPEED(to),
		"fastest speed of best=on; default 85, or more to "
		"cover the runs",
		.needs = BEST}),
	.shared = {SHARED_RPM, SHARED_FEED, SHARED_MACHINE, SHARED_SCREENS},
	.text =
	    "Shows the tonnes per hour of each fraction into which screens "
	    "divide the product of a new feed, in steady state. Fractions of "
	    "recycle= return to the crusher: their tonnes are the circulating "
	    "load. Power is an engineering estimate, idle + c Q v2, from "
	    "readings of the motor. With prices, best=on "
	    "finds the speed that earns most and what it gains over speed=. "
	    "circuit= takes screens, splits and stockpiles from a file, see "
	    "tipspeed-circuit(5). > FILE.svg, .png or .pdf draws the tonnes "
	    "against the speed, from=..to=.",
	.more = "Material coarser or finer than all fractions, or between "
		"them, is also listed, and the error of the mass balance is "
		"shown with the circulating load. In the formula for power, c "
		"is at least 1 (Euler's turbine equation); readings of the "
		"empty crusher (0 t/h) at two speeds give its idle power. "
		"tipspeed-circuit(5) also says what is left out.",
	.example = "load data/sites/tierp.csv\ncalibrate\n"
		   "flow tph=120 recycle=8/11.2\n"
		   "flow tph=120 recycle=8/11.2 "
		   "power=69:206:118,79:279:121,66:24:0,78:37:0 "
		   "prices=0/2:12,2/5:9,5/8:7 kwh=0.15 best=on\n"
		   "flow circuit=data/circuits/two-decks.csv\n"
		   "flow tph=120 recycle=8/11.2 > flow.svg",
	.answer = cmd_flow},
    {.name = "window",
	.brief = "the speeds at which conditions hold",
	.operands = {"[CONDITION...]", {""}, 0, OPERANDS - 1},
	.flags = COMMAND_NEEDS_SITE | COMMAND_NEEDS_PARAMS | COMMAND_CONDITIONS,
	.option = OPTION_LIST(
	    {SPEC(spec), "grading envelope: a name of 'spec list', or a file"},
	    {SPEED(from),
		"slowest speed; default 65, or less to cover the runs"},
	    {SPEED(to), "fastest speed; default 85, or more to cover the runs"},
	    {OFF_ON(detail), "off",
		"on: also the other speeds that were found"}),
	.shared = {SHARED_FEED, SHARED_MACHINE, SHARED_CUT},
	.text =
	    "A condition is a quantity of figures and a limit, with quotes or "
	    "without: \"passing 2 = 40..50\", \"over 8 < 10\", \"P80 > 5\", "
	    "\"0/2 >= 30\", \"fm EN of 0/4 = 2.4..3.1\"; < and <= are the "
	    "same. Without quotes, a > between a quantity and a number is a "
	    "limit. spec= adds the limits of a grading envelope, including its "
	    "standard's limits on the fineness modulus and between two sieves; "
	    "cut= is the fraction for conditions that name none. The default "
	    "conditions are those of 'set goal'. Shows the speeds, to a tenth "
	    "of a m/s, at which the answer meets each condition, and the best "
	    "speed: the one at which all hold with the highest probability, "
	    "preferably between the measured speeds; of speeds within 2 % of "
	    "that probability, the one with the largest margin, in widths of "
	    "the band. detail=on adds the speeds at which the answer meets "
	    "all, what limits them, and the speed of least energy and wear: "
	    "the slowest measured one from which, up to the best, the "
	    "conditions hold with 95 % probability. Programs get margins as "
	    "passings, in points: for a P at the size that is its limit, for a "
	    "fineness modulus per sieve. Moduli and fractions rise and fall "
	    "with the speed, so there may be several windows. With the "
	    "uncertainty band, also says at which speeds all conditions hold "
	    "together with 80 % certainty (set level). If no speed meets them "
	    "all, the nearest one is shown, with the condition that limits it.",
	.example = "load data/sites/tierp.csv\n"
		   "params set f_mat=2.18 e0_min=16.74 alpha=0.96\n"
		   "window \"passing 2 = 30..36\" \"P80 > 5\"",
	.answer = cmd_window},
    {.name = "spec",
	.brief = "compare the product with a grading envelope",
	.operands = {"[use NAME|list [NAME|limits]|off|NAME|FILE]",
	    {"use list off SPEC FILE", "SPEC FILE", ""}, 0, 12},
	.flags = COMMAND_CHANGES | COMMAND_SPEC,
	.option = OPTION_LIST({LAST_OR_USUAL_SPEED}),
	.shared = {SHARED_RPM, SHARED_FEED, SHARED_MACHINE, SHARED_CUT},
	.text =
	    "'spec use NAME' chooses an envelope for the session: spec and "
	    "find then compare with it, and plots of size distributions draw "
	    "its limits; 'spec off' ends that. The envelopes of ASTM C33, BS "
	    "882, BS 1200, EN 12620, IS 383 and a Norwegian road base come "
	    "with the program, as second-hand copies to be checked against "
	    "your own. 'spec list' lists their names; a few words that fit "
	    "only one are enough. tipspeed-spec(5) describes FILE, an envelope "
	    "of your own. spec alone, or with a NAME or FILE, shows each sieve "
	    "with its limits, the passing predicted at a speed, and ok, above "
	    "or below. An envelope for a fraction, such as a sand, is compared "
	    "with that fraction of the product, by ideal screens unless "
	    "sharpness= is given; cut= takes another one, cut=off the product "
	    "as it is. The standard's limits on the fineness modulus and "
	    "between two sieves are also compared.",
	.example = "load data/sites/tierp.csv\n"
		   "params set f_mat=2.18 e0_min=16.74 alpha=0.96\n"
		   "spec use \"ASTM C33\"\nspec speed=79\n"
		   "spec data/specs/en-12620-0-8.csv speed=79",
	.run = cmd_spec},
    {.name = "uncertainty",
	.brief = "what makes the answer uncertain, and its draws",
	.operands = {"[SPEED] [draws|next]", {"SPEED draws next", "draws next"},
	    0, 2},
	.flags = COMMAND_NEEDS_SITE | COMMAND_NEEDS_PARAMS | COMMAND_CHANGES |
		 COMMAND_APPEARANCE | COMMAND_QUANTITIES,
	.option = OPTION_LIST({LAST_SPEED},
	    {TEXT(of), NULL, "",
		"figures, see figures; default: what passes 2 mm, P20, P50 and "
		"P80"},
	    {OFF_ON(detail), "off",
		"on: show each sieve, and the sizes of the errors"},
	    {ROW("level", probability, unsigned, VALUE_CHOICE), "%", 0, 0,
		"80 90", "80",
		"probability of the bands; 'set level' sets it too"},
	    {NUMBER(noise), "points", 0, 10, NULL, "0",
		"known standard deviation of a single passing around 50 %; 0: "
		"as the data show it"},
	    {NUMBER(speed_sd), "%", 0, 5, NULL, "0.5",
		"standard deviation of stated tip speeds: slip, worn tips, "
		"rounding; 0: exact"},
	    {WHOLE(n), "", 1, 256, NULL, "200", "how many draws to write",
		.needs = "draws"}),
	.shared = {SHARED_RPM, SHARED_FEED, SHARED_MACHINE, SHARED_SIEVES,
	    SHARED_CUT},
	.text =
	    "Shows what passes 2 mm, P20, P50 and P80 at a speed, or the "
	    "figures that are named, with the range in which the true value "
	    "lies and the one in which a new belt cut is expected; if several "
	    "runs have a feed sample, how far the product moves with the feed; "
	    "the effect of errors of the tip speeds; and which further sample "
	    "would help most, as 'advise' finds it. detail=on shows half the "
	    "width of the band sieve by sieve: of the model alone, which is "
	    "what its parameters leave open; of the answer, with what the "
	    "model leaves out, which is the band of predict; and of one more "
	    "sample with its error. Below it are the sizes of these errors as "
	    "the data show them. level=, noise= and speed_sd= are settings, "
	    "kept for the commands that follow. 'uncertainty draws > FILE.csv' "
	    "writes the draws: parameters, errors and product of each. See "
	    "UNCERTAINTY in tipspeed-model(7).",
	.example = "load data/sites/tierp.csv\ncalibrate\nuncertainty 72 P80\n"
		   "uncertainty 85 detail=on",
	.answer = cmd_uncertainty},
    {.name = "advise",
	.alias = "next",
	.brief = "which sample to take next, to narrow a band most",
	.bare = "speed",
	.flags = COMMAND_NEEDS_SITE | COMMAND_NEEDS_PARAMS | COMMAND_QUANTITIES,
	.option = OPTION_LIST({LAST_SPEED},
	    {TEXT(of), NULL, "", "figure, see figures; default: P80"}),
	.shared = {SHARED_RPM, SHARED_FEED, SHARED_MACHINE, SHARED_CUT},
	.text =
	    "For a repeat at each measured speed, and a sample at each round "
	    "speed, shows the expected width of the band of one figure of the "
	    "product at a speed; see UNCERTAINTY in tipspeed-model(7). If "
	    "several feeds were sampled, also shows what they change. "
	    "'uncertainty next' does the same.",
	.example = "load data/sites/tierp.csv\ncalibrate\nadvise p80\n"
		   "advise 85 passing 2",
	.answer = cmd_advise},
    {.name = "league",
	.brief = "compare all breakage models on the site's runs",
	.operands = {"[all]", {"all"}, 0, 1},
	.flags = COMMAND_NEEDS_SITE,
	.text =
	    "Calibrates each breakage model, with and without a bypass, on the "
	    "training runs, and shows for each the misfit, how many parameters "
	    "were free, AICc (lower is better) and the RMSE at the held-out "
	    "runs, beside predictions that need no model. If no run is held "
	    "out and there are three or more speeds, each is held out in turn. "
	    "The best model has the smallest error there; among models within "
	    "0.1 points, or if no run is held out, the lowest AICc; a model "
	    "that interpolation beats is not called best. If even the best "
	    "misses these runs by more than 2 points, and by more than "
	    "sampling explains, no model describes the rock. Reports which "
	    "models the data rule out, whether they can tell the models apart, "
	    "and how much each contributes to the answer between measured "
	    "speeds; see COMPARING MODELS in tipspeed-model(7). The fit in use "
	    "stays. 'league all' does it for all loaded sites and adds up the "
	    "results.",
	.example = "load data/sites/tierp.csv\nleague",
	.run = cmd_league},
    {.name = "identify",
	.alias = "uncertainty params",
	.brief = "what the data determine, and what they do not",
	.flags = COMMAND_NEEDS_SITE,
	.text = "Shows from the uncertainty draws which parameters the data "
		"determine: the standard deviation of the draws in per cent of "
		"that of the prior (below 10: determined, below 50: poorly "
		"determined, else not), the break size at each measured speed, "
		"the parameters that are at a bound or compensate for each "
		"other, and whether the data bound the threshold only from "
		"above. Ends in one sentence. plot correlation and plot "
		"profile draw it; see IDENTIFIABILITY in tipspeed-model(7).",
	.example = "load data/sites/tierp.csv\ncalibrate\nuncertainty params",
	.run = cmd_identify},
    {.name = "why",
	.brief = "explain the numbers at a speed, or from one to another",
	.operands = {"[SPEED]", {"SPEED"}, 0, 1},
	.flags = COMMAND_NEEDS_SITE | COMMAND_NEEDS_PARAMS,
	.bare = "speed",
	.option = OPTION_LIST({LAST_SPEED}),
	.shared = {SHARED_RPM, SHARED_FEED, SHARED_MACHINE, SHARED_CUT},
	.text =
	    "Explains the site in use at a speed in sentences: what breaks, "
	    "how much of the feed that is, how far the speed is from the "
	    "training speeds, the light with each reason, which parameters the "
	    "data do not determine, and where the data are from. With two "
	    "speeds it shows where the mass of the feed goes at each: for each "
	    "class of the feed's sieves what stays in it, what breaks and "
	    "leaves it, what comes from coarser ones, and the change of the "
	    "product; then in a sentence how much more breaks, and which "
	    "classes lose and gain most. With one speed and cut= it also gives "
	    "the share of that fraction, and how more speed changes it. All "
	    "columns are shares of the feed's mass and sum to 100 %.",
	.example = "load data/sites/tierp.csv\ncalibrate\nwhy 85\nwhy 69 79",
	.answer = cmd_why},
    {.name = "drift",
	.brief = "see whether later cuts drift from the prediction",
	.flags = COMMAND_NEEDS_SITE | COMMAND_DAILY,
	.option = OPTION_LIST({NUMBER(k), "sd", 0, 5, NULL, "0.5",
				  "allowance of the CUSUM: half of the shift "
				  "to be found soonest"},
	    {NUMBER(h), "sd", 0.1, 100, NULL, "5",
		"limit of the CUSUM: higher signals later and less often by "
		"chance"},
	    {OFF_ON(detail), "off",
		"on: show the numbers of the control charts too"}),
	.text =
	    "Compares each cut added after the calibration with a prediction "
	    "for its own speed and feed that does not use the cut. A row has "
	    "the mean of the residuals (answer minus measured, points: + "
	    "if the cut is coarser), the largest with its sieve, and what the "
	    "control charts say; with detail=on the charts themselves: EWMA "
	    "(weight 0.2) with its limit and CUSUM in both directions, of the "
	    "mean and of the tilt (coarse sieves minus fine ones). The limits "
	    "come from the draws of the uncertainty, or from 'set noise' if "
	    "there are none; see DRIFT in tipspeed-model(7). Reports how often "
	    "they signal by chance, what drifts, where to look and when to "
	    "calibrate anew. A signal makes the light of the site's answers "
	    "amber. plot drift draws it.",
	.example = "load data/sites/tierp.csv\ncalibrate\n"
		   "add data/cuts/tierp-may.csv\ndrift",
	.run = cmd_drift},
    {.name = "report",
	.brief = "write a report on the site in use to one file",
	.operands = {"[CONDITION...]", {""}, 0, OPERANDS - 1},
	.flags = COMMAND_NEEDS_SITE | COMMAND_DAILY | COMMAND_CONDITIONS |
		 COMMAND_UNSAVED,
	.bare = "speed",
	.option = OPTION_LIST(
	    {SPEED(speed), "rotor tip speed; default: the best one for the "
			   "conditions, else that last asked about, with its "
			   "feed"},
	    {NUMBER(tph), "t/h", 1e-3, 1e5, NULL, "",
		"new feed, for a section with its flow"},
	    {SPEC(spec), "grading envelope: a name of 'spec list', or a file"}),
	.shared = {SHARED_RPM, SHARED_FEED, SHARED_MACHINE, SHARED_CUT},
	.text =
	    "Write it with > FILE.html, for a browser, or > FILE.pdf, for "
	    "paper (A4). The file holds what other commands answer: the light "
	    "with its reasons, data, check and mends, the product with its "
	    "band, other speeds, the window of the conditions (see window), "
	    "the chosen envelope or that of spec=, the flow of tph=, the card, "
	    "routine cuts, validation, fit, plots, with several calibrated "
	    "sites their common errors, and the script that makes the report "
	    "again. With conditions it says first whether they are met, and at "
	    "which speeds. It needs no network and no other file. For a site "
	    "that is not calibrated the file has the parts that need no "
	    "calibration, and states what is missing.",
	.example = "load data/sites/tierp.csv\ncalibrate\n"
		   "report \"passing 2 = 30..36\" > tierp.html",
	.answer = cmd_report},
    {.name = NULL}};

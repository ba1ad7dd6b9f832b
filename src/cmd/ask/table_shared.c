/* Options that commands which ask questions (question.h) share, as rows of the
 * command table.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/lang/rows.h"
#include "core/psd/site.h"

const struct command_option SHARED_RPM[] = {
    {NUMBER(rpm), "rpm", 1, 20000, NULL, "",
	"rotor speed in rpm, instead of a tip speed"},
    {.name = NULL}};

const struct command_option SHARED_FEED[] = {
    {FEED(feed), "m/s", 1, SITE_FASTEST, NULL, "",
	"feed sampled at this speed; or that of a sheet, FILE or FILE@SPEED; "
	"or a blend such as a.csv*0.6+b.csv*0.4; or mean, of those sampled; "
	"default: as set, or else mean"},
    {.name = NULL}};

const struct command_option SHARED_MACHINE[] = {
    {NUMBER(rotor_mm), "mm", 100, 5000, NULL, "",
	"diameter of the rotor; default: that of the site"},
    {NUMBER(cascade), "%", 0, 90, NULL, "",
	"share of the feed that bypasses the rotor, in addition to that of the "
	"measured runs; assumed uncrushed, which gives the coarsest possible "
	"product"},
    {NUMBER(k), "", 0.001, 1000, NULL, "",
	"impacts per particle; default: as set by 'set k'"},
    {CHOICE(correction), "all train off", "",
	"runs that correct the model, for this answer; default: as set"},
    {.name = NULL}};

const struct command_option SHARED_SIEVES[] = {
    {NUMBERS(sieves), "mm", 1e-6, 1e4, NULL, "",
	"sieves to show; default: the site's"},
    {.name = NULL}};

/* Of screens, which cut a fraction or stand in a circuit. */
#define SCREENS                                                            \
	{NUMBER(sharpness), "", 0.1, 100, NULL, "",                        \
	    "sharpness of the screens (Whiten), 3 to 10; default: ideal"}, \
	{                                                                  \
		NUMBER(cut_size), "%", 10, 200, NULL, "100",               \
		    "size that half passes, relative to the opening"       \
	}

const struct command_option SHARED_CUT[] = {
    {TEXT(cut), NULL, "", "screened fraction in mm, such as 0/4"}, SCREENS,
    {.name = NULL}};

const struct command_option SHARED_SCREENS[] = {SCREENS, {.name = NULL}};

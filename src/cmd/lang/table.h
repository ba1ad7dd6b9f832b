/* What the rows of the command table run.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_LANG_TABLE_H
#define TIPSPEED_CMD_LANG_TABLE_H

#include "cmd/lang/command.h"
#include "core/psd/site.h"

command_run cmd_load, cmd_add, cmd_sites, cmd_use, cmd_drop, cmd_check,
    cmd_mend, cmd_show, cmd_synth, cmd_template, cmd_write;
command_run cmd_calibrate, cmd_collect, cmd_continue, cmd_accept, cmd_history;
command_run cmd_blend, cmd_compare, cmd_spec, cmd_validate, cmd_league,
    cmd_identify, cmd_drift, cmd_energy, cmd_pin;
command_answer cmd_predict, cmd_card, cmd_sweep, cmd_figures, cmd_find,
    cmd_uncertainty, cmd_window, cmd_advise, cmd_why, cmd_report, cmd_flow,
    cmd_guess;
command_run cmd_plot, cmd_describe, cmd_screen;
command_run cmd_materials, cmd_recall, cmd_remember, cmd_forget, cmd_export,
    cmd_import;
command_run cmd_params, cmd_bounds, cmd_set, cmd_seed;
command_run cmd_undo, cmd_redo, cmd_save, cmd_restore, cmd_reset,
    cmd_source, cmd_echo, cmd_timing, cmd_assert, cmd_help, cmd_apropos,
    cmd_man, cmd_version, cmd_tui, cmd_quit;

/* An option of commands that predict, see question_read. */
#define TABLE_FEED                                                        \
	{                                                                 \
		"feed", VALUE_FEED, "m/s", 1, SITE_FASTEST, NULL, "",     \
		    "take the feed sampled at this speed, or that of a "  \
		    "sheet, FILE or FILE@SPEED, or a blend such as "      \
		    "a.csv*0.6+b.csv*0.4, or the mean of those sampled; " \
		    "default: as set, the mean"                           \
	}

/* What all questions may be asked with: another feed or machine, and the runs
 * that inform the answer, see cmd/ask/question.h. */
#define TABLE_QUESTION                                                     \
	TABLE_FEED,                                                        \
	    {"rotor_mm", VALUE_NUMBER, "mm", 100, 5000, NULL, "",          \
		"diameter of the rotor; default: that of the site"},       \
	    {"cascade", VALUE_NUMBER, "%", 0, 90, NULL, "",                \
		"share of the feed led past the rotor, beside what the "   \
		"measured runs had"},                                      \
	    {"k", VALUE_NUMBER, "", 0.01, 100, NULL, "",                   \
		"impacts of a particle; default: as set, see 'set k'"},    \
	{                                                                  \
		"correction", VALUE_CHOICE, "", 0, 0, "all train off", "", \
		    "runs that correct the model, for this answer; "       \
		    "default: as set"                                      \
	}

/* A speed by the rotor's turns. */
#define TABLE_TURNS                                                    \
	{                                                              \
		"rpm", VALUE_NUMBER, "rpm", 1, 20000, NULL, "",        \
		    "turns of the rotor a minute, in place of a speed" \
	}

/* Sieves of one's own choice, see cmd/ask/question.h. */
#define TABLE_SIEVES                                                \
	{                                                           \
		"sieves", VALUE_NUMBERS, "mm", 1e-6, 1e4, NULL, "", \
		    "sieves to show; default: the site's"           \
	}

/* What screens are like. */
#define TABLE_SCREENS                                                  \
	{"sharpness", VALUE_NUMBER, "", 0.1, 100, NULL, "",            \
	    "sharpness of the screens (Whiten), 3 to 10; default: "    \
	    "ideal"},                                                  \
	{                                                              \
		"cut_size", VALUE_NUMBER, "%", 10, 200, NULL, "100",   \
		    "size of which half passes, of a screen's opening" \
	}

/* A screened fraction, see quantities_option. */
#define TABLE_CUT                                    \
	{"cut", VALUE_TEXT, "", 0, 0, NULL, "",      \
	    "screened fraction in mm, such as 0/4"}, \
	    TABLE_SCREENS

/* What show runs too. */
command_run show_params, show_bounds, show_fit, show_store, show_log,
    show_equations, show_claims;

#endif

/* What the rows of the command table run.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_TABLE_H
#define TIPSPEED_CMD_TABLE_H

#include "cmd/command.h"

command_run cmd_load, cmd_add, cmd_sites, cmd_use, cmd_drop, cmd_check,
    cmd_mend, cmd_show, cmd_synth, cmd_template, cmd_write;
command_run cmd_calibrate, cmd_continue, cmd_accept, cmd_history;
command_run cmd_predict, cmd_sweep, cmd_compare, cmd_find, cmd_spec,
    cmd_uncertainty, cmd_validate, cmd_league, cmd_identify, cmd_advise,
    cmd_why;
command_run cmd_plot, cmd_describe, cmd_screen;
command_run cmd_materials, cmd_recall, cmd_remember, cmd_forget, cmd_export,
    cmd_import, cmd_guess;
command_run cmd_params, cmd_bounds, cmd_set, cmd_seed;
command_run cmd_undo, cmd_redo, cmd_save, cmd_restore, cmd_reset, cmd_source,
    cmd_echo, cmd_timing, cmd_assert, cmd_help, cmd_apropos, cmd_man,
    cmd_version, cmd_tui, cmd_quit;

/* An option of commands that predict, see answers_feed. */
#define TABLE_FEED                                             \
	{                                                      \
		"feed", VALUE_NUMBER, "m/s", 1, 200, NULL, "", \
		    "take the feed sampled at this speed"      \
	}

/* What show runs too. */
command_run show_params, show_bounds, show_store, show_log;

#endif

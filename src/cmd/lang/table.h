/* The functions in the rows of the command table.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_LANG_TABLE_H
#define TIPSPEED_CMD_LANG_TABLE_H

#include "cmd/lang/command.h"

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
command_run cmd_undo, cmd_redo, cmd_save, cmd_restore, cmd_reset, cmd_source,
    cmd_echo, cmd_timing, cmd_assert, cmd_help, cmd_apropos, cmd_man,
    cmd_version, cmd_tui, cmd_quit;

/* Functions that other commands share with `show`. */
command_run show_params, show_param_bounds, show_fit, show_store_summary,
    show_plant_log, show_equations, show_claims;

#endif

/* Keys and the functions they run, each defined in the page or widget
 * concerned.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TUI_ACTS_H
#define TIPSPEED_TUI_ACTS_H

#include "cmd/session/screen_pages.h"

#define PAGE_NUMBER(NUMBER, name, heading, key) PAGE_##NUMBER,
enum page { SCREEN_PAGES(PAGE_NUMBER) PAGES };

/* Keys without a name in curses. */
enum { INTERRUPT = 3, SUSPEND = 26, ESCAPE = 27, DELETE = 127 };

/* Where a key acts, as bits: 1 << page, which is ON_FIT for PAGE_FIT.  The bits
 * FIRST_ON_.. are for a key that acts on all pages: the ? list of those pages
 * shows it first.  AT_SPEED: the key acts at the slider's speed; if n, p or N
 * is still waiting for the speeds of the goal (act_move_slider_to_goal_speed),
 * the slider goes there first.  CHANGES: the key changes results, the speed or
 * the band, see viewer.c.  RUNS_COMMAND: the key runs the command whose name is
 * its hint. */
#define PAGE_BIT(NUMBER, name, heading, key) ON_##NUMBER = 1 << PAGE_##NUMBER,
enum {
	SCREEN_PAGES(PAGE_BIT) ON_ALL = (1 << PAGES) - 1,
	FIRST_ON_PREDICT = ON_PREDICT << PAGES,
	FIRST_ON_FIT = ON_FIT << PAGES,
	FIRST_ON_LISTS = (ON_DATA | ON_SITES) << PAGES,
	AT_SPEED = 1 << 2 * PAGES,
	CHANGES = AT_SPEED << 1,
	RUNS_COMMAND = CHANGES << 1
};

struct tui;
struct key;
typedef void key_action(struct tui *t, const struct key *key);

/* code: the key code of ncurses.  name: the name shown, such as "Left, h" if h
 * does the same.  act: the function to run, which may use the amount.  what:
 * the effect in words.  brief: the same for a list that fits on one screen;
 * NULL if the key is listed with the previous one.  hint: the same for the row
 * of hints; NULL if brief serves. */
struct key {
	int code;
	const char *name;
	unsigned where;
	key_action *act;
	int amount;
	const char *what, *brief, *hint;
};

/* Amounts for act_move_list_or_slider, and for act_move_to_end. */
enum { STEP = 1, FAST = 10, FAR = 50 };
enum { TO_LEAST = -1, TO_MOST = 1 };

/* The first two move within the page or, if nothing there moves, the slider: by
 * the amount, or to an end.  The last moves up or down within the page only. */
key_action act_move_list_or_slider, act_move_to_end, act_move_in_list;

/* Move the slider.  act_type_speed begins a speed to go to.
 * act_move_slider_to_run_speed goes to the slowest run (amount -1), a middle
 * one (0) or the fastest (1).  act_move_slider_to_goal_speed goes to the next
 * limit of the goal or, without a goal, to the next run; for an amount of 0, to
 * the best speed of the goal.  It waits until these speeds are known. */
key_action act_type_speed, act_move_slider_to_run_speed,
    act_move_slider_to_goal_speed;

key_action act_open_page, act_go_back, act_open_row, act_open_filter_field;

/* Run the key's command, or `describe`; open the command line empty, with
 * `save`, or with a command that exports. */
key_action act_run_hint_command, act_describe_plot, act_open_command_line,
    act_propose_save, act_propose_export;

/* Control the calibration. */
key_action act_calibrate, act_toggle_calibration_pause, act_stop_fit,
    act_change_calibration_pace;

/* Change what is predicted and shown.  act_open_goal_field opens a field that
 * holds the goal or, without one, the quantity above the track.
 * act_toggle_goal_view shows the goal at full height, or no longer. */
key_action act_next_correction_setting, act_toggle_band, act_toggle_pin,
    act_toggle_crosshair, act_move_crosshair_passing, act_next_quantity,
    act_open_goal_field, act_toggle_goal_view;

/* Act on one page each. */
key_action act_toggle_all_runs_view, act_show_numbers_or_calibrate,
    act_next_plot, act_next_generation, act_open_bounds_command,
    act_correct_cell, act_next_doubtful_cell, act_sort_sites;

key_action act_open_file_picker, act_show_last_text, act_list_keys,
    act_toggle_mouse, act_redraw_screen, act_suspend_program, act_leave_screen;

#endif

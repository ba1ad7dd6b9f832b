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

/* Where a key acts: bits of 1 << page, ON_FIT for PAGE_FIT.  For a key that
 * acts on all pages, the same bits, shifted, name the pages that list it first.
 * AT_SPEED: it acts at the slider's speed; if n, p or N still waits for the
 * speeds of the goal (act_go_to_goal_speed), the slider goes there first.
 * CHANGES: it changes results, see viewer.c.  RUNS_COMMAND: its hint is the
 * name of the command that it runs. */
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

/* code: as in ncurses; name: as shown, such as "Left, h" if h does the same.
 * act: the function, which uses the amount.  what: the effect in words; brief:
 * the same for a list that fits on one screen, or NULL if it is listed with the
 * previous key; hint: the same in the row of hints, or NULL if as brief. */
struct key {
	int code;
	const char *name;
	unsigned where;
	key_action *act;
	int amount;
	const char *what, *brief, *hint;
};

/* Amounts of act_move_list_or_slider, and of act_move_to_end. */
enum { STEP = 1, FAST = 10, FAR = 50 };
enum { TO_LEAST = -1, TO_MOST = 1 };

/* Move within the page, or else the slider: by the amount, to an end; up and
 * down. */
key_action act_move_list_or_slider, act_move_to_end, act_move_in_list;

/* Move the slider to a typed speed; to a run (-1: slowest, 0: a middle one, 1:
 * fastest); to the next limit of the goal or, without a goal, the next run, or,
 * for an amount of 0, to the best speed of the goal.  The last waits until
 * these speeds are known. */
key_action act_type_speed, act_go_to_run_speed, act_go_to_goal_speed;

key_action act_open_page, act_go_back, act_open_row, act_type_filter;

/* Lines: run the key's command or describe; open the command line, empty, with
 * `save` or with a command to export. */
key_action act_run_hint_command, act_describe_plot, act_type_command,
    act_propose_save, act_export_prediction;

/* The calibration. */
key_action act_calibrate, act_toggle_pause, act_stop_fit,
    act_change_search_pace;

/* Change what is predicted and shown.  act_type_goal opens a field that starts
 * with the quantity above the track, act_toggle_goal_view shows the goal at
 * full height. */
key_action act_next_correcting_runs, act_toggle_band, act_toggle_pin,
    act_toggle_crosshair, act_move_crosshair_passing, act_next_quantity,
    act_type_goal, act_toggle_goal_view;

/* For single pages. */
key_action act_show_all_runs, act_show_all_numbers, act_next_plot,
    act_next_generation, act_type_bounds, act_mend_cell, act_next_doubtful_cell,
    act_sort_sites;

key_action act_open_files, act_show_last_text, act_list_keys, act_toggle_mouse,
    act_redraw_screen, act_suspend_program, act_leave_screen;

#endif

/* Keys, and the functions they run, each defined in the page or widget that it
 * concerns.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TUI_ACTS_H
#define TIPSPEED_TUI_ACTS_H

enum page { PAGE_PREDICT, PAGE_FIT, PAGE_DATA, PAGE_PARITY, PAGE_SITES, PAGES };

/* Keys without a name of curses. */
enum { INTERRUPT = 3, SUSPEND = 26, ESCAPE = 27, DELETE = 127 };

/* Where a key acts: bits of 1 << page.  For a key that acts on all pages the
 * same bits, shifted, name the pages that list it first.  AT_SPEED: it concerns
 * the speed of the slider, which is first made the one asked for.  CHANGES: it
 * changes what is calculated, see viewer.c.  RUNS_COMMAND: its hint is the name
 * of the command it runs. */
enum {
	ON_PREDICT = 1 << PAGE_PREDICT,
	ON_FIT = 1 << PAGE_FIT,
	ON_DATA = 1 << PAGE_DATA,
	ON_PARITY = 1 << PAGE_PARITY,
	ON_SITES = 1 << PAGE_SITES,
	ON_ALL = (1 << PAGES) - 1,
	FIRST_ON_PREDICT = ON_PREDICT << PAGES,
	FIRST_ON_FIT = ON_FIT << PAGES,
	FIRST_ON_LISTS = (ON_DATA | ON_SITES) << PAGES,
	AT_SPEED = 1 << 2 * PAGES,
	CHANGES = AT_SPEED << 1,
	RUNS_COMMAND = CHANGES << 1
};

struct tui;
struct key;
typedef void key_way(struct tui *t, const struct key *key);

/* code: as ncurses has it; name: as shown, "Left, h" where h does the same.
 * act: does it, with the amount.  what: what it does, in words; brief: the same
 * for a list that fits one screen, NULL: listed with the key before it; hint:
 * the same in the row of hints, NULL: as brief. */
struct key {
	int code;
	const char *name;
	unsigned where;
	key_way *act;
	int amount;
	const char *what, *brief, *hint;
};

/* Amounts of act_move, and of act_ends. */
enum { STEP = 1, FAST = 10, FAR = 50 };
enum { TO_LEAST = -1, TO_MOST = 1 };

/* In what the page has, else the slider: by the amount, to an end; up and
 * down. */
key_way act_move, act_ends, act_list;

/* Moves the slider to a run (-1 the slowest, 0 one in the middle, 1 the
 * fastest), to the next limit of the goal, or of a run where there is no goal,
 * or by an amount of 0 to the goal's best speed.  Until these speeds are known
 * the key waits. */
key_way act_speed, act_run_speed, act_limit;

key_way act_page, act_back, act_choose, act_filter;

/* Lines: the command of the key; the field of one, empty, with `save` or with
 * what is to be exported. */
key_way act_command, act_describe, act_type, act_save, act_export;

/* The calibration. */
key_way act_fit, act_pause, act_stop, act_pace;

/* What is predicted and shown; act_goal opens a field with the quantity above
 * the track in it. */
key_way act_correct, act_band, act_pin, act_cross, act_level, act_quantity,
    act_goal;

/* Of pages. */
key_way act_runs, act_numbers, act_picture, act_generation, act_bounds,
    act_mend, act_doubt, act_sort;

key_way act_files, act_again, act_help, act_mouse, act_redraw, act_suspend,
    act_leave;

#endif

/* Random keys, mouse, sizes and pasted text on the full screen: nothing may
 * break, and afterwards it still answers.  A second by default;
 * MONKEY_SECONDS=1800 for a night, MONKEY_SEED=N for one walk again.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <signal.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#include <curses.h>

#include "desk.h"

#include "base/text.h"
#include "tui/keymap.h"
#include "tui/control.h"
#include "tui/frame.h"
#include "tui/input.h"
#include "tui/pane.h"
#include "tui/screen.h"
#include "tui/script_terminal.h"
#include "tui/tui_state.h"
#include "tui/watch.h"
#include "tui/view.h"

/* SplitMix64: the same walk from the same seed everywhere. */
static uint64_t state_of;

static size_t
below(size_t n)
{
	uint64_t z = (state_of += 0x9E3779B97F4A7C15U);
	z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9U;
	z = (z ^ (z >> 27)) * 0x94D049BB133111EBU;
	return (size_t)((z ^ (z >> 31)) % n);
}

/* Lines that bring up what keys alone seldom do. */
static const char *const TYPED[] = {"load data/sites/bro.csv",
    "load data/sites/tierp.csv", "use tierp", "use bro", "calibrate",
    "help predict", "show params", "why", "spec data/specs/mine.csv",
    "find p80=5.4", "predict 999", "plot parity", "reset", "undo", "redo",
    "set k 2", "bounds e0_min 0..25", "describe psd", "check", "sweep",
    "calibrate all", "set correction off", "params",

    ("synth data/table3.csv "
     "site=Tierp seed=9 speeds=58,61,64,67,70,73,76,79"),
    "window", "guess", "screen", "screen page=sites width=200 height=60",
    "screen page=parity", "plot response", "continue", "accept",
    "load nothing.csv", "load data/sites/atle.csv", "drop", "quit",
    "set goal \"p80=5..5.3\"", "set goal \"p80=5.4, passing 2 > 30\"",
    "set goal \"EN 12620 0/4\"", "set goal none", "set quantity p50", "spec",
    "spec use EN 12620 0/4", "spec off", "pin speed=70", "pin speed=76 feed=69",
    "pin off", "compare pinned 74", "set page data", "set model vogel",
    "set model grunditz", "set theme light", "league", "validate",
    "validate holdout=each", "figures 72", "flow", "history", "uncertainty",
    "calibrate pause=3", "bounds default", "card", "report", "identify",
    "remember mine", "recall table3/tierp", "predict 76 feed=69",
    "source data/scripts/none.tip", "set correction all"};

/* A goal, typed into its field, and a speed; what is left open is given up by
 * the next. */
static const char *const GOALS[] = {"p80=5..5.3\n", "5.4\n", "<6\n",
    ",fines<9\n", "p50\n", "EN 12620 0/4\n", "passing 2 = 33..35, p80 > 5\n",
    "fm\n", "p80=1e9\n", "none\n", "\025\n", "p80=5", "cu<\t\n"};
static const char *const SPEEDS[] = {"72.3\n", "069\n", "85\n", "0200\n", "6.5",
    "55\n", "999\n", "7,4\n", "01\n", "9\177"};

static int
random_key(void)
{
	static const int OTHERS[] = {27, '\t', '\n', '\r', 127, '\b', 1, 3, 5,
	    11, 12, 21, 23, KEY_UP, KEY_DOWN, KEY_DC, KEY_F(1), KEY_F(5),
	    KEY_BTAB, KEY_ENTER, KEY_BACKSPACE, KEY_SLEFT, KEY_SRIGHT};
	size_t keys = 0;
	switch (below(4)) {
	case 0:
		return ' ' + (int)below(95);
	case 1:
		return OTHERS[below(ARRAY_LEN(OTHERS))];
	default:
		while (KEYS[keys].code != 0)
			keys++;
		return KEYS[below(keys)].code;
	}
}

/* The terminal that there was before, and the size of the one drawn aside. */
static struct display *before;
static int rows, columns;

static void
resize(void)
{
	static const int DEPTHS[] = {0, 8, 16, 256};
	static const int MOST[][2] = {{34, 110}, {5, 20}, {200, 400}};
	size_t size = below(8);
	const int *most = MOST[size < ARRAY_LEN(MOST) ? size : 0];
	rows = 1 + (int)below((size_t)most[0]);
	columns = 1 + (int)below((size_t)most[1]);
	canvas_free(screen_end_offscreen(before));
	before = screen_begin_offscreen(rows, columns, (enum charset)below(3),
	    DEPTHS[below(ARRAY_LEN(DEPTHS))]);
}

/* Any key, but none that hands over the program; the size may be another in the
 * midst of a question. */
static bool
answer(struct tui *t, int *code, bool *special)
{
	if (below(6) == 0)
		resize();
	frame_draw(t);
	*code = below(3) == 0 ? '\n' : below(3) == 0 ? 'y' : random_key();
	*special = *code > 255;
	/* A question that nothing else ends is given up. */
	if (below(8) == 0) {
		*code = 27;
		*special = false;
	}
	return true;
}

static const struct tui_callbacks WAYS = {.answer = answer};

static void
paste(struct tui *t)
{
	input_handle_paste(t, SCREEN_PASTE, true);
	for (size_t n = below(300); n > 0; n--)
		input_handle_paste(
		    t, (int)below(below(2) ? 127 : 0x3000), false);
	if (below(4) > 0)
		input_handle_paste(t, SCREEN_PASTED, true);
	else
		input_end_paste(t);
}

static void
type_text(struct tui *t, const char *text)
{
	while (*text != '\0')
		keymap_handle_key(t, (int)text_next_code_point(&text), false);
}

static void
type_line(struct tui *t)
{
	keymap_handle_key(t, 27, false);
	keymap_handle_key(t, ':', false);
	type_text(t, TYPED[below(ARRAY_LEN(TYPED))]);
	keymap_handle_key(t, below(5) > 0 ? '\n' : '\t', false);
}

/* Something is set and at once drawn beside: what both states know of it is
 * half worked out. */
static void
type_more(struct tui *t)
{
	type_text(t, "\033\0331");
	if (below(2) == 0) {
		type_text(t, SPEEDS[below(ARRAY_LEN(SPEEDS))]);
	} else {
		keymap_handle_key(t, 't', false);
		type_text(t, GOALS[below(ARRAY_LEN(GOALS))]);
	}
	for (size_t n = below(4); n > 0; n--)
		pages_update(t);
	if (below(2) == 0)
		type_text(t, "\033:screen\n");
}

static void
use_mouse(struct tui *t)
{
	enum hit_kind kind = (enum hit_kind)(1U << below(4));
	int row = (int)below((size_t)rows + 2) - 1,
	    column = (int)below((size_t)columns + 2) - 1;
	hits_dispatch_mouse(t, &t->hits, kind, row, column, keymap_handle_key);
	if (below(3) == 0)
		hits_end_drag(&t->hits);
}

/* All that the loop does between two keys. */
static void
go_on(struct tui *t)
{
	t->clock += (double)below(3) * 0.3;
	watch_run_due_fit_steps(t);
	view_update(t);
	frame_draw(t);
	t->leave = t->session->quit = t->session->wants_tui = false;
}

/* A key, a size, the mouse, or something typed. */
static void
one_step(struct tui *t)
{
	size_t what = below(40);
	int code = random_key();
	if (what == 0)
		resize();
	else if (what == 1)
		paste(t);
	else if (what == 2)
		type_line(t);
	else if (what == 3)
		type_more(t);
	else if (what < 10)
		use_mouse(t);
	else
		keymap_handle_key(t, code, code > 255);
}

/* Some hundred steps on a session of its own. */
static void
walk(uint64_t seed)
{
	enum { STEPS = 400 };
	void *open;
	struct tui t;
	rows = 24;
	columns = 80;
	state_of = seed;
	desk_open(&open);
	struct desk *desk = open;
	if (below(4) > 0)
		desk_expect(desk, "load data/sites/bro.csv "
				  "data/sites/ossjo.csv data/sites/tierp.csv");
	desk->session->hooks.draw_screen = script_draw_screen;
	/* From here on no file is written and no shell run. */
	desk->session->safe = true;
	before = screen_begin_offscreen(rows, columns, CHARSET_BRAILLE, 256);
	control_open_screen(&t, desk->session, &WAYS);
	/* On a terminal what takes long is worked out part by part. */
	t.aside = below(2) == 0;
	frame_draw(&t);
	for (int i = 0; i < STEPS; i++) {
		one_step(&t);
		/* Often more than one comes before a frame is drawn. */
		if (below(4) > 0)
			go_on(&t);
	}
	/* It still answers: from wherever it is, back, and on. */
	input_end_paste(&t);
	for (int i = 0; i < 12; i++)
		keymap_handle_key(&t, 27, false);
	go_on(&t);
	assert_false(t.line.active || t.filter.active || t.ui.crosshair);
	assert_null(t.viewer.text);
	assert_int_equal(t.ui.page, PAGE_PREDICT);
	keymap_handle_key(&t, 'q', false);
	keymap_run_delayed_key(&t);
	assert_true(t.leave);
	control_close_screen(&t);
	canvas_free(screen_end_offscreen(before));
	desk_close(&open);
}

static void
nothing_breaks(void **state)
{
	(void)state;
	const char *seconds = getenv("MONKEY_SECONDS"),
		   *seed = getenv("MONKEY_SEED");
	time_t end = time(NULL) + (seconds != NULL ? atol(seconds) : 1);
	uint64_t n = seed != NULL ? strtoull(seed, NULL, 10) : 1;
	signal(SIGTSTP, SIG_IGN); /* ^Z is among the keys */
	do {
		/* What breaks says which walk it was. */
		char line[64];
		int length = snprintf(line, sizeof line, "# MONKEY_SEED=%llu\n",
		    (unsigned long long)n);
		if (seconds != NULL && n % 50 == 0)
			assert_true(write(2, line, (size_t)length) == length);
		walk(n++);
	} while (seed == NULL && time(NULL) < end);
}

int
main(void)
{
	const struct CMUnitTest tests[] = {cmocka_unit_test(nothing_breaks)};
	chdir_to_source();
	return cmocka_run_group_tests(tests, NULL, NULL);
}

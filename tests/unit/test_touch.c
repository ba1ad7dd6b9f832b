/* What the mouse, Enter, Esc and a word after / do, and how many keys a
 * question takes.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <string.h>
#include <unistd.h>

#include <curses.h>

#include "desk.h"
#include "stage.h"

#include "base/text.h"
#include "tui/keymap.h"
#include "tui/control.h"
#include "tui/frame.h"
#include "tui/pane.h"
#include "tui/screen.h"
#include "tui/script_terminal.h"
#include "tui/tui_state.h"
#include "tui/view.h"

enum { ROWS = 30, COLUMNS = 100 };

static void
settle_at_stationary_point(struct stage *stage)
{
	struct tui *t = &stage->t;
	t->clock++;
	view_update(t);
	frame_draw(t);
}

static int
stage_open(void **state)
{
	struct stage *stage = stage_new(ROWS, COLUMNS, CHARSET_BRAILLE, 256,
	    "load data/sites/tierp.csv data/sites/bro.csv "
	    "data/sites/ossjo.csv; use tierp; calibrate population=200; "
	    "predict speed=74");
	settle_at_stationary_point(stage);
	*state = stage;
	return 0;
}

/* Keys by their names, or letters, with blanks between them. */
static void
press(struct stage *stage, const char *names)
{
	char *copy = xstrdup(names), *save = NULL;
	for (char *name = strtok_r(copy, " ", &save); name != NULL;
	     name = strtok_r(NULL, " ", &save)) {
		int code;
		bool named = keys_code_of_name(name, &code);
		const char *rest = name;
		do {
			if (!named)
				code = (int)text_next_code_point(&rest);
			keymap_handle_key(&stage->t, code, code > 255);
			stage->keys++;
		} while (!named && *rest != '\0');
		settle_at_stationary_point(stage);
	}
	free(copy);
}

/* Where text stands on the frame; the last place, as the hints are there. */
static bool
find_text(struct stage *stage, const char *text, int *row, int *column)
{
	struct canvas *frame = screen_end_offscreen(stage->was);
	bool found = false;
	for (int r = 0; r < frame->rows; r++) {
		char *line = xstrdup(""), code[5];
		for (int c = 0; c < frame->columns; c++) {
			uint32_t at = canvas_cell_at(frame, c, r)->code;
			/* One letter a cell, so that offsets are columns. */
			xappend(&line, "%s",
			    at > 0 && at < 128
				? canvas_encode_code_point(at, code)
				: "~");
		}
		for (char *p = strstr(line, text); p != NULL;
		     p = strstr(p + 1, text)) {
			*row = r;
			*column = (int)(p - line);
			found = true;
		}
		free(line);
	}
	canvas_free(frame);
	stage->was =
	    screen_begin_offscreen(ROWS, COLUMNS, CHARSET_BRAILLE, 256);
	frame_draw(&stage->t);
	return found;
}

static bool
mouse(struct stage *stage, enum hit_kind kind, int row, int column)
{
	struct tui *t = &stage->t;
	bool took = hits_dispatch_mouse(
	    t, &t->hits, kind, row, column, keymap_handle_key);
	hits_end_drag(&t->hits);
	settle_at_stationary_point(stage);
	return took;
}

static void
click(struct stage *stage, const char *text)
{
	int row = -1, column = -1;
	if (!find_text(stage, text, &row, &column))
		fail_msg("%s is not on the screen", text);
	if (!mouse(stage, HIT_PRESS, row, column))
		fail_msg("%s cannot be touched", text);
}

/* On every page, whatever its hints are: none names a key that is none. */
static void
hints_are_their_keys(void **state)
{
	struct stage *stage = *state;
	struct tui *t = &stage->t;
	for (int page = PAGE_PREDICT; page < PAGES; page++) {
		pages_go_to(t, (enum page)page);
		settle_at_stationary_point(stage);
		size_t keys = 0;
		for (size_t i = 0; i < t->hits.n; i++) {
			const struct hit *at = &t->hits.at[i];
			if (at->area.row != t->layout.hints.row ||
			    at->way != NULL)
				continue;
			assert_non_null(
			    keys_find_by_code(at->code, t->ui.page));
			keys++;
		}
		assert_in_range(keys, 3, 20);
	}
	pages_go_to(t, PAGE_PREDICT);
	settle_at_stationary_point(stage);
	click(stage, "? keys");
	assert_true(t->viewer.keys);
	click(stage, "^L");
	assert_null(t->viewer.text);
	click(stage, ": predict");
	assert_true(t->line.active);
	click(stage, "Esc give up");
	assert_false(t->line.active);
	click(stage, " 5 Sites");
	assert_int_equal(t->ui.page, PAGE_SITES);
	click(stage, "q quit");
	assert_true(t->leave);
}

static void
a_row_is_chosen_and_opened(void **state)
{
	struct stage *stage = *state;
	struct tui *t = &stage->t;
	press(stage, "5");
	click(stage, "ossjo");
	assert_int_equal(t->ui.list[PAGE_SITES].at, 2);
	assert_int_equal(t->ui.page, PAGE_SITES);
	click(stage, "ossjo");
	assert_int_equal(t->ui.page, PAGE_PREDICT);
	assert_string_equal(t->command, "use ossjo");
	press(stage, "5 g");
	assert_int_equal(t->ui.list[PAGE_SITES].at, 0);
	press(stage, "End");
	assert_int_equal(t->ui.list[PAGE_SITES].at, 2);
	press(stage, "Home Down Enter");
	assert_string_equal(t->command, "use bro");
	assert_int_equal(t->ui.page, PAGE_PREDICT);
}

static void
the_wheel_moves_what_is_under_it(void **state)
{
	struct stage *stage = *state;
	struct tui *t = &stage->t;
	const struct layout *l = &t->layout;
	int tenths = tui_slider_position(t);
	assert_true(mouse(stage, HIT_UP, l->plot.row + 2, 20));
	assert_int_equal(tui_slider_position(t), tenths + 1);
	assert_true(mouse(stage, HIT_DOWN, l->track.row, 20));
	assert_int_equal(tui_slider_position(t), tenths);
	assert_false(mouse(stage, HIT_UP, l->header.row, 1));
	assert_false(mouse(stage, HIT_UP, l->hints.row, 1));
	press(stage, "5");
	assert_true(mouse(stage, HIT_DOWN, l->body.row + 2, 20));
	assert_int_equal(t->ui.list[PAGE_SITES].at, 1);
	press(stage, "?");
	int at = t->viewer.at;
	assert_true(mouse(stage, HIT_DOWN, l->body.row + 2, 20));
	assert_int_equal(t->viewer.at, at + 1);
	press(stage, "Esc 3");
	click(stage, "79.77");
	assert_int_equal(t->ui.cell.at, 1);
	assert_int_equal(t->ui.cell.row, 4);
	assert_true(mouse(stage, HIT_DOWN, l->body.row + 2, 20));
	assert_int_equal(t->ui.cell.row, 5);
	assert_int_equal(tui_slider_position(t), tenths);
}

/* Every mark of a run that is drawn in the middle of the plot says what it is,
 * and the crosshair stands on its sieve. */
static void
a_click_on_the_plot_reads_it(void **state)
{
	struct stage *stage = *state;
	struct tui *t = &stage->t;
	const struct psd *p = &t->view.shown.product;
	const struct area *plot = &t->layout.plot;
	size_t read = 0, runs = 0, before = (size_t)-1;
	for (int column = plot->column; column < plot->columns; column++) {
		t->message[0] = '\0';
		bool took =
		    mouse(stage, HIT_PRESS, plot->row + plot->rows / 2, column);
		if (!took || !t->ui.crosshair)
			continue;
		assert_true(t->ui.crosshair_sieve < p->n);
		/* From the finest to the coarsest. */
		assert_true(t->ui.crosshair_sieve <= before);
		read += t->ui.crosshair_sieve != before;
		before = t->ui.crosshair_sieve;
		runs += strstr(t->message, "measured") != NULL;
	}
	assert_in_range(read, 8, p->n);
	assert_in_range(runs, 1, plot->columns);
	assert_true(t->ui.crosshair);
}

static void
escape_goes_back_one_step_and_never_quits(void **state)
{
	struct stage *stage = *state;
	struct tui *t = &stage->t;
	press(stage, "5 / oss");
	assert_true(t->filter.active);
	press(stage, "Esc");
	assert_false(t->filter.active);
	assert_int_equal(t->filter.n, 0);
	press(stage, "Esc");
	assert_int_equal(t->ui.page, PAGE_PREDICT);
	press(stage, "c ?");
	assert_true(t->ui.crosshair && t->viewer.keys);
	press(stage, "/ by Esc");
	assert_true(t->viewer.keys && t->viewer.word.n == 0);
	press(stage, "Esc");
	assert_true(t->ui.crosshair && t->viewer.text == NULL);
	press(stage, "Esc");
	assert_false(t->ui.crosshair);
	press(stage, "2 Esc");
	assert_int_equal(t->ui.page, PAGE_PREDICT);
	for (int i = 0; i < 3; i++) {
		press(stage, "Esc");
		assert_false(t->leave);
		assert_non_null(strstr(t->message, "q quits"));
	}
}

static void
a_word_filters_the_rows(void **state)
{
	struct stage *stage = *state;
	struct tui *t = &stage->t;
	int row, column;
	press(stage, "5 / bro");
	assert_int_equal(t->ui.list[PAGE_SITES].at, 1);
	assert_true(find_text(stage, "/bro  1 of 3", &row, &column));
	assert_false(find_text(stage, "  ossjo ", &row, &column));
	press(stage, "Enter End Down Up");
	assert_int_equal(t->ui.list[PAGE_SITES].at, 1);
	press(stage, "Enter");
	assert_string_equal(t->command, "use bro");
	/* It is the page's, and gone with it. */
	press(stage, "5");
	assert_int_equal(t->filter.n, 0);
	press(stage, "/ zzz");
	assert_true(find_text(stage, "0 of 3", &row, &column));
	press(stage, "Enter Enter");
	assert_int_equal(t->ui.page, PAGE_SITES);
	press(stage, "/ Backspace Backspace Backspace öSSJ");
	assert_string_equal(t->filter.text, "öSSJ");
	assert_true(find_text(stage, "SSJ  1 of 3", &row, &column));
	press(stage, "Enter");
	/* Without a row of hints the word is seen, too. */
	canvas_free(screen_end_offscreen(stage->was));
	stage->was = screen_begin_offscreen(6, 40, CHARSET_ASCII, 0);
	press(stage, "Esc / bro");
	assert_int_equal(t->layout.hints.rows, 0);
	assert_int_equal(t->cursor.column, 4);
	assert_true(find_text(stage, "/bro  1 of 3", &row, &column));
	press(stage, "Esc 1 /");
	assert_non_null(strstr(t->message, "no function"));
}

static void
a_text_is_searched(void **state)
{
	struct stage *stage = *state;
	struct tui *t = &stage->t;
	press(stage, ": help Space calibrate Enter");
	assert_non_null(t->viewer.text);
	press(stage, "/ seed Enter");
	int first = t->viewer.at;
	assert_in_range(first, 0, t->viewer.lines - 1);
	press(stage, "n");
	int next = t->viewer.at;
	assert_true(next > first);
	press(stage, "N");
	assert_int_equal(t->viewer.at, first);
	press(stage, "N n");
	assert_int_equal(t->viewer.at, first);
	press(stage, "G");
	assert_int_equal(
	    t->viewer.top, t->viewer.lines - t->layout.body.rows > 0
			       ? t->viewer.lines - t->layout.body.rows
			       : 0);
	press(stage, "Esc");
	assert_non_null(t->viewer.text);
	press(stage, "Esc");
	assert_null(t->viewer.text);
}

/* But one that would change what is calculated is asked for again. */
static void
a_key_that_closes_a_text_is_not_lost(void **state)
{
	struct stage *stage = *state;
	struct tui *t = &stage->t;
	press(stage, "? 2");
	assert_true(t->viewer.text == NULL && t->ui.page == PAGE_FIT);
	press(stage, ": seed ; Space help Enter");
	press(stage, "1 c");
	assert_true(t->ui.crosshair);
	press(stage, "? f");
	assert_null(t->viewer.text);
	assert_false(session_is_calibrating(t->session));
	assert_non_null(strstr(t->message, "f again"));
	press(stage, "? b");
	assert_false(t->ui.band);
	assert_non_null(strstr(t->message, "b again"));
	press(stage, "? p");
	assert_non_null(strstr(t->message, "p again: to the limit"));
	const double speed = tui_slider_speed(t);
	press(stage, "? Shift-Left H V L Shift-Right");
	assert_true(t->viewer.text != NULL && tui_slider_speed(t) == speed);
	press(stage, "q V / ä");
	assert_string_equal(t->viewer.word.text, "ä");
	press(stage, "Esc q ? / speed Left Shift-Right");
	assert_true(t->viewer.text != NULL && tui_slider_speed(t) == speed);
	press(stage, "Esc Esc ? q");
	assert_true(t->viewer.text == NULL && !t->leave);
	press(stage, "? ?");
	assert_null(t->viewer.text);
	int row, column;
	press(stage, "? / c");
	assert_true(find_text(stage, "Enter run it", &row, &column));
	press(stage, "qq");
	assert_false(find_text(stage, "Enter run it", &row, &column));
	press(stage, "Esc Esc");
	press(stage, "? 7 8 Enter");
	assert_int_equal(tui_slider_position(t), 780);
}

static void
a_click_in_the_list_of_keys_runs_it(void **state)
{
	struct stage *stage = *state;
	struct tui *t = &stage->t;
	press(stage, "?");
	click(stage, "crosshair");
	assert_true(t->ui.crosshair && t->viewer.text == NULL);
}

static void
offers_are_taken_by_a_click(void **state)
{
	struct stage *stage = *state;
	struct tui *t = &stage->t;
	press(stage, ": plot Space p Tab");
	assert_non_null(t->line.offers);
	click(stage, "parity");
	assert_string_equal(t->line.text, "plot parity ");
	/* The slider is not moved while a line is typed. */
	assert_false(mouse(stage, HIT_PRESS, t->layout.track.row, 20));
	int row, column;
	assert_true(find_text(stage, ":plot parity", &row, &column));
	assert_true(mouse(stage, HIT_PRESS, row, column + 3));
	press(stage, "X");
	assert_string_equal(t->line.text, "plXot parity ");
}

/* Ways to answer of their own: what the mouse presses at a place. */
static int asked_row, asked_column;

static void
note(struct tui *t, int code, bool special)
{
	t->put_back.is = true;
	t->put_back.code = code;
	t->put_back.special = special;
}

static bool
point(struct tui *t, int *code, bool *special)
{
	frame_draw(t);
	/* Of what lies below the question nothing answers. */
	hits_dispatch_mouse(t, &t->hits, HIT_PRESS, 0, 99, note);
	assert_false(t->put_back.is);
	const struct cursor *end = &t->cursor;
	hits_dispatch_mouse(t, &t->hits, HIT_PRESS, end->row + asked_row,
	    end->column + asked_column, note);
	assert_true(t->put_back.is);
	t->put_back.is = false;
	*code = t->put_back.code;
	*special = t->put_back.special;
	return true;
}

static void
a_question_is_answered_by_the_mouse(void **state)
{
	struct stage *stage = *state;
	static const struct tui_callbacks BY_MOUSE = {.answer = point};
	struct session *s = stage->t.session;
	stage->t.callbacks = &BY_MOUSE;
	asked_row = 0;
	asked_column = -3;
	assert_true(s->hooks.confirm(s, "shall it?", false));
	asked_column = -1;
	assert_false(s->hooks.confirm(s, "shall it?", false));
}

/* What a dozen questions cost, in keys, from the page that opens. */
static void
little_is_typed(void **state)
{
	struct stage *stage = *state;
	struct tui *t = &stage->t;
	static const struct {
		const char *what, *keys;
		size_t most;
	} ASKED[] = {{"read a sieve", "c Left Left", 3},
	    {"open another site", "5 Down Enter", 3},
	    {"open a site by its name", "5 / oss Enter Enter", 7},
	    {"export the answer", "e", 1},
	    {"find a key and run it", "? / band Enter", 8},
	    {"keep and compare", "x L", 2}};
	for (size_t i = 0; i < sizeof ASKED / sizeof ASKED[0]; i++) {
		stage->keys = 0;
		press(stage, ASKED[i].keys);
		if (stage->keys > ASKED[i].most)
			fail_msg(
			    "%s takes %zu keys", ASKED[i].what, stage->keys);
		bool done = i == 0   ? t->ui.crosshair
			    : i == 1 ? strcmp(t->command, "use bro") == 0
			    : i == 2 ? strcmp(t->command, "use ossjo") == 0
			    : i == 3 ? strstr(t->line.text, ".xlsx") != NULL
			    : i == 4 ? t->ui.band
				     : t->view.pinned.site[0] != '\0';
		if (!done)
			fail_msg("%s: not done", ASKED[i].what);
		press(stage, "Esc Esc Esc : use Space tierp Enter");
		t->ui.band = false;
	}
}

#define ON_STAGE(test) \
	cmocka_unit_test_setup_teardown(test, stage_open, stage_close)

int
main(void)
{
	const struct CMUnitTest tests[] = {
	    ON_STAGE(hints_are_their_keys),
	    ON_STAGE(a_row_is_chosen_and_opened),
	    ON_STAGE(the_wheel_moves_what_is_under_it),
	    ON_STAGE(a_click_on_the_plot_reads_it),
	    ON_STAGE(escape_goes_back_one_step_and_never_quits),
	    ON_STAGE(a_word_filters_the_rows),
	    ON_STAGE(a_text_is_searched),
	    ON_STAGE(a_key_that_closes_a_text_is_not_lost),
	    ON_STAGE(a_click_in_the_list_of_keys_runs_it),
	    ON_STAGE(offers_are_taken_by_a_click),
	    ON_STAGE(a_question_is_answered_by_the_mouse),
	    ON_STAGE(little_is_typed),
	};
	chdir_to_source();
	return cmocka_run_group_tests(tests, NULL, NULL);
}

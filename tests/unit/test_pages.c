/* The pages of the full screen that show sheets and sites.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <string.h>

#include <curses.h>

#include "desk.h"
#include "stage.h"

#include "base/text.h"
#include "cmd/ask/fit.h"
#include "tui/keymap.h"
#include "tui/control.h"
#include "tui/frame.h"
#include "tui/pane.h"
#include "tui/screen.h"
#include "tui/script_terminal.h"
#include "tui/cmdline.h"
#include "tui/watch.h"
#include "tui/view.h"
#include "tui/widgets/list.h"

static int
stage_open(void **state)
{
	struct stage *stage = stage_new(24, 80, CHARSET_ASCII, 0,
	    "load data/sites/tierp.csv; load data/sites/kiruna.csv; load "
	    "data/sites/gavle-11.2-2.csv");
	*state = stage;
	return 0;
}

/* What the loop does once. */
static void
turn(struct tui *t)
{
	watch_run_due_fit_steps(t);
	view_update(t);
	frame_draw(t);
}

/* Keys by their names, spaces between. */
static void
press(struct tui *t, const char *names)
{
	char *copy = xstrdup(names), *left;
	for (char *name = strtok_r(copy, " ", &left); name != NULL;
	     name = strtok_r(NULL, " ", &left)) {
		int code = 0;
		assert_true(keys_code_of_name(name, &code));
		keymap_handle_key(t, code, code > 255);
		view_update(t);
		frame_draw(t);
	}
	free(copy);
}

/* A row of the frame; the next one is drawn on the same terminal. */
static const char *
row_of(struct stage *stage, int row)
{
	static char text[400];
	int rows, columns;
	frame_draw(&stage->t);
	screen_size(&rows, &columns);
	struct canvas *frame = screen_end_offscreen(stage->was);
	for (int i = 0; i < columns; i++)
		text[i] = (char)canvas_cell_at(frame, i, row)->code;
	text[columns] = '\0';
	canvas_free(frame);
	stage->was = screen_begin_offscreen(rows, columns, CHARSET_ASCII, 0);
	frame_draw(&stage->t);
	return text;
}

static void
resize(struct stage *stage, int rows, int columns)
{
	canvas_free(screen_end_offscreen(stage->was));
	stage->was = screen_begin_offscreen(rows, columns, CHARSET_ASCII, 0);
	frame_draw(&stage->t);
}

/* Each has a key, which the list of keys has with its name, and is saved by that
 * name. */
static void
every_page_is_opened_and_saved(void **state)
{
	struct stage *stage = *state;
	struct tui *t = &stage->t;
	size_t words = 0, at;
	for (const char *p = SCREEN_PAGE_WORDS; *p != '\0'; p++)
		words += p[0] == ' ' || p[1] == '\0';
	assert_int_equal(words, PAGES);
	for (enum page page = PAGES; page-- > 0;) {
		FREED char *word =
		    text_fold_case_and_accents(PAGE_HEADINGS[page]);
		assert_true(
		    text_find_word_in_list(SCREEN_PAGE_WORDS, word, &at));
		assert_int_equal(at, page);
		int code = keys_code_of_page(page);
		FREED char *what = xasprintf("page %s", PAGE_HEADINGS[page]);
		assert_string_equal(
		    keys_find_by_code(code, PAGE_PREDICT)->what, what);
		keymap_handle_key(t, code, false);
		turn(t);
		assert_int_equal(t->ui.page, page);
		control_store_page_settings(t);
		assert_int_equal(t->session->set.page, page);
		assert_false(t->bad);
	}
}

/* ---- Sites ---- */

static void
all_sites_are_calibrated_while_keys_are_taken(void **state)
{
	struct stage *stage = *state;
	struct tui *t = &stage->t;
	const struct session *s = t->session;
	cmdline_run_line(t, "calibrate all");
	assert_true(session_is_calibrating(s));
	turn(t);
	assert_int_equal(t->ui.page, PAGE_SITES);
	assert_true(s->entry[0].has_fit);
	assert_true(session_is_calibrating(s));
	assert_int_equal(s->job.entry, 1);
	assert_non_null(strstr(row_of(stage, 2), "green"));
	assert_non_null(strstr(row_of(stage, 3), "gen 0 "));
	assert_non_null(strstr(row_of(stage, 4), "waiting"));
	press(t, "Space");
	turn(t);
	assert_non_null(strstr(row_of(stage, 3), "paused"));
	assert_int_equal(s->job.entry, 1);
	press(t, "Space");
	/* One does not open another meanwhile, nor calibrate one. */
	press(t, "Enter");
	assert_true(session_is_calibrating(s));
	press(t, "f");
	assert_non_null(strstr(t->message, "s stops them"));
	press(t, "1 Enter");
	assert_non_null(strstr(t->message, "until the calibration ends"));
	press(t, "5");
	assert_int_equal(s->job.entry, 1);
	turn(t);
	assert_true(s->entry[1].has_fit);
	press(t, "s");
	assert_false(session_is_calibrating(s));
	assert_false(s->entry[2].has_fit);
	assert_non_null(strstr(t->message, "keep their fits"));
	press(t, "u");
	assert_false(s->entry[0].has_fit);
}

static void
what_it_ends_with_is_what_calibrate_all_says(void **state)
{
	struct stage *stage = *state;
	struct tui *t = &stage->t;
	cmdline_run_line(t, "calibrate all");
	for (int i = 0; i < 3; i++)
		turn(t);
	assert_false(session_is_calibrating(t->session));
	assert_non_null(strstr(t->message, "all sites are calibrated"));
	struct fit found[3];
	for (int i = 0; i < 3; i++)
		found[i] = t->session->entry[i].fit;
	desk_expect(stage->desk, "calibrate all");
	for (int i = 0; i < 3; i++)
		assert_memory_equal(&found[i].params,
		    &t->session->entry[i].fit.params, sizeof found[i].params);
}

static void
sites_are_sorted_by_a_key_or_a_click(void **state)
{
	struct stage *stage = *state;
	struct tui *t = &stage->t;
	press(t, "5");
	assert_non_null(strstr(row_of(stage, 2), "tierp"));
	press(t, "o o");
	assert_non_null(strstr(row_of(stage, 1), "site^"));
	assert_non_null(strstr(row_of(stage, 2), "gavle"));
	assert_non_null(strstr(row_of(stage, 4), "tierp"));
	press(t, "O");
	assert_non_null(strstr(row_of(stage, 2), "tierp"));
	const char *head = row_of(stage, 1);
	int rock = (int)(strstr(head, "rock") - head);
	assert_true(hits_dispatch_mouse(
	    t, &t->hits, HIT_PRESS, 1, rock, keymap_handle_key));
	assert_non_null(strstr(row_of(stage, 1), "rock^"));
	assert_non_null(strstr(row_of(stage, 4), "Porphyry"));
	/* Down goes down on the screen. */
	t->ui.list[PAGE_SITES].at = t->view.row[0].entry;
	press(t, "Down Down");
	assert_int_equal(t->ui.list[PAGE_SITES].at, t->view.row[2].entry);
}

static void
sites_are_shown_before_they_are_judged(void **state)
{
	struct stage *stage = *state;
	struct tui *t = &stage->t;
	press(t, "5");
	assert_null(strstr(row_of(stage, 2), ".."));
	control_discard_outdated_state(t);
	frame_draw(t);
	assert_non_null(strstr(row_of(stage, 2), t->session->entry[0].key));
	assert_non_null(strstr(row_of(stage, 2), ".."));
	t->aside = false;
	do
		pages_update(t);
	while (t->view.rows_left);
	t->aside = true;
	frame_draw(t);
	assert_null(strstr(row_of(stage, 2), ".."));
}

static void
a_name_is_cut_when_nothing_else_is_left(void **state)
{
	struct stage *stage = *state;
	struct tui *t = &stage->t;
	const char *name = "a quarry with a name of fifty letters, no, of more";
	free(t->session->entry[0].key);
	t->session->entry[0].key = xstrdup(name);
	t->view.n_row = 0;
	press(t, "5");
	assert_non_null(strstr(row_of(stage, 2), name));
	assert_non_null(strstr(row_of(stage, 1), "light"));
	assert_null(strstr(row_of(stage, 1), "rock"));
	resize(stage, 24, 40);
	assert_non_null(strstr(row_of(stage, 2), "a quarry with a name"));
	assert_non_null(strstr(row_of(stage, 1), "light"));
}

/* ---- Data ---- */

static void
a_doubtful_cell_is_marked_and_mended_by_a_key(void **state)
{
	struct stage *stage = *state;
	struct tui *t = &stage->t;
	desk_expect(stage->desk, "use tierp");
	desk_expect(stage->desk, "mend product@74 sieve=1 value=15.82");
	desk_expect(stage->desk, "calibrate");
	control_discard_outdated_state(t);
	press(t, "3");
	const char *row = row_of(stage, 9);
	assert_non_null(strstr(row, "15.82!"));
	assert_int_equal(t->view.sheet.doctor.n, 1);
	press(t, "!");
	assert_true(t->ui.cell.on);
	assert_int_equal(t->ui.cell.row, 7);
	assert_int_equal(t->ui.cell.at, 3);
	bool said = false;
	for (int i = 12; i < 20; i++)
		said = said || strstr(row_of(stage, i), "product@74") != NULL;
	assert_true(said);
	press(t, "Enter");
	assert_string_equal(t->command, "mend product@74 sieve=1 value=18.52");
	assert_non_null(strstr(t->message, "f calibrates, "));
	assert_non_null(strstr(row_of(stage, 9), "18.52 "));
	press(t, "u");
	assert_non_null(strstr(row_of(stage, 9), "15.82!"));
}

static void
all_columns_of_a_sheet_can_be_reached(void **state)
{
	struct stage *stage = *state;
	struct tui *t = &stage->t;
	cmdline_run_line(t, "use tierp");
	resize(stage, 12, 40);
	press(t, "3");
	assert_non_null(strstr(row_of(stage, 1), "feed@69"));
	press(t, "Down End Right Right Right Right Right Right");
	assert_int_equal(t->ui.cell.at, 5);
	assert_non_null(strstr(row_of(stage, 1), "79*"));
	assert_null(strstr(row_of(stage, 1), "feed@69"));
	const char *row = row_of(stage, t->cursor.row);
	assert_non_null(strstr(row, "0.063"));
	/* The slider is there by its number. */
	press(t, "= 7 2 . 5 Enter");
	assert_int_equal(t->ui.cell.at, 5);
	assert_int_equal(tui_slider_position(t), 725);
}

/* ---- Parity ---- */

static void
parity_has_the_statistics_of_validate(void **state)
{
	struct stage *stage = *state;
	struct tui *t = &stage->t;
	press(t, "4");
	assert_non_null(strstr(row_of(stage, 6), "no loaded site has"));
	desk_expect(stage->desk, "calibrate all");
	desk_expect(stage->desk, "validate all");
	control_discard_outdated_state(t);
	press(t, "4");
	assert_int_equal(t->view.parity.runs.n, 3);
	const struct session *s = t->session;
	static const char *const PATHS[2][3] = {
	    {"p20.rms_pct", "p50.rms_pct", "p80.rms_pct"},
	    {"corrected.p20.rms_pct", "corrected.p50.rms_pct",
		"corrected.p80.rms_pct"}};
	for (size_t way = 0; way < 2; way++)
		for (size_t i = 0; i < PSD_SIZES; i++) {
			struct validate_score score = trials_score_at_size(
			    &t->view.parity.runs, (enum validate_way)way, i);
			assert_true(
			    fabs(100 * score.rms -
				 session_number_in_last_answer(
				     s, "validate", PATHS[way][i])) < 1e-12);
		}
	press(t, "Down Down");
	const struct chart *chart = t->view.parity.chart;
	struct chart_series **own = &chart->series[chart->n - 3];
	assert_int_equal(t->ui.list[PAGE_PARITY].at, 2);
	for (size_t i = 0; i < 3; i++) {
		const struct chart_series *of = chart->series[1 + i];
		assert_true(own[i]->y[0] == of->y[2] && own[i]->lifted);
		assert_int_equal(own[i]->mark, of->mark);
	}
	/* A word shows the runs that have it, and chooses one. */
	size_t chosen = t->ui.list[PAGE_PARITY].at == 0 ? 1 : 0;
	const char *key = s->entry[t->view.parity.runs.item[chosen].entry].key;
	press(t, "/");
	for (; *key != '\0'; key++)
		keymap_handle_key(t, *key, false);
	press(t, "Enter");
	assert_int_equal(list_count_matching_rows(t), 1);
	assert_int_equal(t->ui.list[PAGE_PARITY].at, chosen);
	press(t, "Esc");
	assert_int_equal(list_count_matching_rows(t), 3);
	/* A step of the slider compares nothing. */
	const struct trial *was = t->view.parity.runs.item;
	press(t, "= 7 2 Enter");
	assert_ptr_equal(t->view.parity.runs.item, was);
}

/* Of one run each size has the mark that the legend says. */
static void
one_run_has_a_mark_for_each_size(void **state)
{
	enum { PLOT = 40 };
	struct stage *stage = *state;
	struct tui *t = &stage->t;
	desk_expect(stage->desk, "reset");
	desk_expect(stage->desk, "load data/sites/tierp.csv");
	desk_expect(
	    stage->desk, "params set f_mat=2.18 e0_min=16.74 alpha=0.96");
	control_discard_outdated_state(t);
	press(t, "4");
	assert_int_equal(t->view.parity.runs.n, 1);
	size_t n = 0;
	for (int row = 2; row < 13; row++)
		for (const char *c = row_of(stage, row), *end = c + PLOT;
		     c < end; c++)
			n += *c == 'v' || *c == '^' ? 1U : *c == '#' ? 100U : 0;
	assert_int_equal(n, 2);
}

/* ---- Little room ---- */

static bool
frame_has(struct stage *stage, int rows, const char *text)
{
	for (int row = 0; row < rows; row++)
		if (strstr(row_of(stage, row), text) != NULL)
			return true;
	return false;
}

static void
small_screens_say_all_or_that_they_cut(void **state)
{
	struct stage *stage = *state;
	struct tui *t = &stage->t;
	desk_expect(
	    stage->desk, "use tierp; calibrate generations=20 population=100");
	control_discard_outdated_state(t);
	resize(stage, 12, 40);
	press(t, "1");
	assert_non_null(strstr(row_of(stage, 11), "? keys"));
	assert_non_null(strstr(row_of(stage, 10), "READY"));
	press(t, ": p");
	assert_non_null(strstr(row_of(stage, 11), "Tab complete"));
	press(t, "Tab");
	assert_non_null(strstr(row_of(stage, 11), "predict"));
	press(t, "Esc 2");
	assert_true(frame_has(stage, 12, "beta1="));
	assert_true(frame_has(stage, 12, "alpha="));
	assert_true(frame_has(stage, 12, "seed 1"));
	press(t, "5 g");
	assert_true(frame_has(stage, 12, "beta1="));
	assert_true(frame_has(stage, 12, ".."));
	resize(stage, 24, 80);
	assert_true(frame_has(stage, 24, "alpha="));
	press(t, "1 ? /");
	resize(stage, 12, 40);
	assert_non_null(strstr(row_of(stage, 2), "Shift-Left"));
	press(t, "b y");
	assert_non_null(strstr(row_of(stage, 2), " .."));
}

/* The mark of a value that is extrapolated is explained where it stands. */
static void
an_extrapolated_size_says_so(void **state)
{
	struct stage *stage = *state;
	struct tui *t = &stage->t;
	desk_expect(stage->desk, "use tierp");
	desk_expect(
	    stage->desk, "params set f_mat=2.18 e0_min=16.74 alpha=0.96");
	control_discard_outdated_state(t);
	t->ui.speed = 84;
	press(t, "5 g");
	assert_true(frame_has(stage, 24, "? extrapolated: 84.0 m/s"));
	t->ui.speed = 74;
	control_discard_outdated_state(t);
	press(t, "5");
	assert_false(frame_has(stage, 24, "? extrapolated:"));
}

/* Of sieves that there are rows for one is that which is asked about. */
static void
the_sieve_asked_about_has_a_row(void **state)
{
	struct stage *stage = *state;
	struct tui *t = &stage->t;
	desk_expect(stage->desk, "use tierp");
	desk_expect(
	    stage->desk, "params set f_mat=2.18 e0_min=16.74 alpha=0.96");
	control_discard_outdated_state(t);
	resize(stage, 30, 100);
	press(t, "1");
	for (size_t i = 1; i < 4; i++) {
		static const double MM[] = {0, 2, 1, 0.5};
		static const char *const ROW[] = {
		    "", "    2  15.4", "    1   7.6", "  0.5   3.7"};
		t->ui.quantity = (struct quantity){
		    .kind = QUANTITY_PASSING, .x = MM[i] / 1000};
		frame_draw(t);
		assert_true(frame_has(stage, 30, ROW[i]));
	}
}

/* With few rows the crosshair reads the run nearest to the slider, and the
 * status has the reason that the panel has no room for. */
static void
few_rows_have_what_matters_at_the_speed(void **state)
{
	struct stage *stage = *state;
	struct tui *t = &stage->t;
	desk_expect(stage->desk, "use tierp; calibrate population=200");
	control_discard_outdated_state(t);
	press(t, "1 c");
	assert_true(frame_has(stage, 24, "meas 74"));
	assert_false(frame_has(stage, 24, "meas 69"));
	press(t, "m ] c c");
	assert_true(frame_has(stage, 24, "meas 79"));
	press(t, "End ^L");
	assert_true(frame_has(stage, 24, "beyond measured speeds"));
	assert_non_null(strstr(row_of(stage, 22), "m/s beyond the measured"));
}

/* With another feed than that of the runs their products are not compared, and
 * the legend names both feeds. */
static void
another_feed_is_named_and_not_compared(void **state)
{
	struct stage *stage = *state;
	struct tui *t = &stage->t;
	desk_expect(stage->desk, "use tierp; calibrate population=200");
	control_discard_outdated_state(t);
	press(t, "1");
	assert_non_null(strstr(row_of(stage, 15), "held out"));
	assert_true(frame_has(stage, 24, "now vs 74"));
	cmdline_run_line(t, "set feed data/sites/kiruna.csv@69");
	press(t, "^L");
	assert_null(strstr(row_of(stage, 15), "held out"));
	assert_non_null(strstr(row_of(stage, 15), "feed kiruna.csv"));
	assert_false(frame_has(stage, 24, "now vs"));
	press(t, "c");
	assert_false(frame_has(stage, 24, "meas 74"));
	press(t, "c r");
	assert_non_null(strstr(row_of(stage, 15), "feed of the sheet"));
	resize(stage, 30, 100);
	assert_non_null(strstr(row_of(stage, 0), "Tierp, with feed"));
}

/* Every heading has room for the mark of the order, and rows that are not
 * drawn are marked. */
static void
the_order_and_further_rows_are_marked(void **state)
{
	struct stage *stage = *state;
	struct tui *t = &stage->t;
	press(t, "5");
	for (int i = 0; i < LIST_COLUMNS; i++) {
		press(t, "o");
		assert_true(
		    t->ui.sort == 0 || strchr(row_of(stage, 1), '^') != NULL);
	}
	assert_null(strstr(row_of(stage, 3), " v"));
	resize(stage, 9, 80);
	int rows = t->layout.body.rows + t->layout.legend.rows;
	assert_int_equal(rows, 3);
	press(t, "Home");
	assert_int_equal(row_of(stage, rows)[79], 'v');
	press(t, "End");
	assert_int_equal(row_of(stage, 2)[79], '^');
}

static void
what_keys_changed_is_said(void **state)
{
	struct stage *stage = *state;
	struct tui *t = &stage->t;
	press(t, "3");
	assert_true(frame_has(stage, 24, "f fit"));
	assert_false(frame_has(stage, 24, "PRED"));
	press(t, "+ + + + + + + +");
	assert_non_null(strstr(t->message, "pace: as many"));
	desk_expect(stage->desk, "use tierp; calibrate population=200");
	control_discard_outdated_state(t);
	press(t, "1 b");
	assert_non_null(strstr(t->message, "band on"));
	press(t, "b");
	assert_string_equal(t->message, "band off");
	/* The model alone has none, however often it is calibrated. */
	desk_expect(stage->desk, "set correction off");
	control_discard_outdated_state(t);
	press(t, "b b b");
	assert_non_null(strstr(t->message, "'set correction all' gives one"));
	assert_null(strstr(t->message, "f calibrates"));
	press(t, "3");
	assert_false(frame_has(stage, 24, "f fit"));
	assert_true(frame_has(stage, 24, "PRED"));
}

static void
a_stopped_search_says_how_good_the_fit_is_that_stays(void **state)
{
	struct stage *stage = *state;
	struct tui *t = &stage->t;
	desk_expect(stage->desk, "use tierp; calibrate population=200; "
				 "calibrate population=64 pause=1");
	control_discard_outdated_state(t);
	assert_true(t->session->job.held_back);
	press(t, "2");
	assert_true(frame_has(stage, 24, "stopped; this stays: good"));
}

#define ON_STAGE(test) \
	cmocka_unit_test_setup_teardown(test, stage_open, stage_close)

int
main(void)
{
	const struct CMUnitTest tests[] = {
	    ON_STAGE(every_page_is_opened_and_saved),
	    ON_STAGE(all_sites_are_calibrated_while_keys_are_taken),
	    ON_STAGE(what_it_ends_with_is_what_calibrate_all_says),
	    ON_STAGE(sites_are_sorted_by_a_key_or_a_click),
	    ON_STAGE(sites_are_shown_before_they_are_judged),
	    ON_STAGE(a_name_is_cut_when_nothing_else_is_left),
	    ON_STAGE(a_doubtful_cell_is_marked_and_mended_by_a_key),
	    ON_STAGE(all_columns_of_a_sheet_can_be_reached),
	    ON_STAGE(parity_has_the_statistics_of_validate),
	    ON_STAGE(one_run_has_a_mark_for_each_size),
	    ON_STAGE(small_screens_say_all_or_that_they_cut),
	    ON_STAGE(an_extrapolated_size_says_so),
	    ON_STAGE(the_sieve_asked_about_has_a_row),
	    ON_STAGE(few_rows_have_what_matters_at_the_speed),
	    ON_STAGE(another_feed_is_named_and_not_compared),
	    ON_STAGE(the_order_and_further_rows_are_marked),
	    ON_STAGE(what_keys_changed_is_said),
	    ON_STAGE(a_stopped_search_says_how_good_the_fit_is_that_stays),
	};
	chdir_to_source();
	return cmocka_run_group_tests(tests, NULL, NULL);
}

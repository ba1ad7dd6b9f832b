/* What keys do on the full screen, and in a line that is typed there.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <fcntl.h>
#include <math.h>
#include <signal.h>
#include <string.h>
#include <unistd.h>

#include <curses.h>

#include "desk.h"
#include "often.h"
#include "stage.h"

#include "base/text.h"
#include "cmd/session/journal.h"
#include "cmd/draw/plots_search.h"
#include "cmd/ask/pin.h"
#include "core/psd/rotor_speed.h"
#include "tui/widgets/response_strip.h"
#include "tui/keymap.h"
#include "tui/control.h"
#include "tui/frame.h"
#include "tui/widgets/goal.h"
#include "tui/widgets/list.h"
#include "tui/input.h"
#include "tui/pane.h"
#include "tui/screen.h"
#include "tui/script_terminal.h"
#include "tui/widgets/track.h"
#include "tui/tui_state.h"
#include "tui/watch.h"
#include "tui/word.h"
#include "tui/view.h"

static void
type(struct tui *t, const char *text)
{
	while (*text != '\0')
		keymap_handle_key(t, (int)text_next_code_point(&text), false);
}

/* Answers a key that asks before it replaces something. */
static bool
says_yes(struct session *s, const char *question, bool yes)
{
	(void)s, (void)question, (void)yes;
	return true;
}

static int
stage_open(void **state)
{
	struct stage *stage = stage_new(24, 80, CHARSET_ASCII, 0, NULL);
	frame_draw(&stage->t);
	*state = stage;
	return 0;
}

/* U+0157 has the number of the keypad's Enter. */
static void
every_letter_is_text_in_a_line(void **state)
{
	struct tui *t = &((struct stage *)*state)->t;
	type(t, ":\u0157\u0107");
	assert_true(t->line.active);
	assert_string_equal(t->line.text, "\u0157\u0107");
}

static void
what_is_completed_is_whole_letters(void **state)
{
	struct tui *t = &((struct stage *)*state)->t;
	char folder[] = "/tmp/tipspeed-act-XXXXXX", was[4096];
	assert_non_null(getcwd(was, sizeof was));
	assert_non_null(mkdtemp(folder));
	assert_int_equal(chdir(folder), 0);
	close(open("xå.csv", O_CREAT | O_WRONLY, 0600));
	close(open("xä.csv", O_CREAT | O_WRONLY, 0600));
	type(t, ":load x\t");
	unlink("xå.csv");
	unlink("xä.csv");
	assert_int_equal(chdir(was), 0);
	rmdir(folder);
	assert_string_equal(t->line.text, "load x");
}

static void
the_keypad_has_an_enter(void **state)
{
	struct tui *t = &((struct stage *)*state)->t;
	type(t, "72.3");
	keymap_handle_key(t, KEY_ENTER, true);
	assert_int_equal(tui_slider_position(t), 723);
	type(t, "?/up by 5");
	keymap_handle_key(t, KEY_ENTER, true);
	assert_int_equal(tui_slider_position(t), 773);
	type(t, ":set k 1");
	keymap_handle_key(t, KEY_ENTER, true);
	assert_false(t->line.active);
	assert_string_equal(t->command, "set k 1");
}

static void
a_speed_is_typed_with_its_unit(void **state)
{
	struct stage *stage = *state;
	struct tui *t = &stage->t;
	desk_expect(stage->desk, "load data/sites/tierp.csv");
	control_discard_outdated_state(t);
	type(t, "=1500 rpm\n");
	assert_non_null(strstr(t->message, "diameter is not known"));
	session_current_site_entry(t->session)->site->rotor = 0.9;
	type(t, "=1500 rpm\n");
	assert_int_equal(tui_slider_position(t), 707);
	/* Rpm come back as typed, and so do those that were measured. */
	assert_true(fabs(tui_slider_speed(t) - 70.69) < 1e-9);
	type(t, "=1501\n");
	assert_int_equal(tui_slider_position(t), 707);
	assert_true(fabs(tui_slider_speed(t) - 70.73) < 1e-9);
	type(t, "=72,5 m/s\n");
	assert_int_equal(tui_slider_position(t), 725);
	session_current_site_entry(t->session)->site->run[0].speed = 72.46;
	type(t, "=72,6 m/s\n");
	tui_set_slider_position(t, 725);
	assert_true(fabs(tui_slider_speed(t) - 72.46) < 1e-9);
	session_current_site_entry(t->session)->site->run[0].speed = 69;
	type(t, "=1500\n");
	assert_int_equal(tui_slider_position(t), 707);
	type(t, "=99999\n");
	assert_non_null(strstr(t->message, "expected a speed from 1"));
	assert_int_equal(tui_slider_position(t), 707);
	type(t, "=64.9\n");
	assert_non_null(strstr(t->message, ":set slider 64..85"));
	type(t, "=7.2.\n");
	assert_non_null(strstr(t->message, "expected a speed"));
	assert_int_equal(tui_slider_position(t), 707);
	/* What is no part of a speed is no key of the page either. */
	type(t, "=bc7c0b");
	assert_string_equal(t->speed.text, "=70");
	assert_false(t->ui.band || t->ui.crosshair);
	type(t, "\n");
	assert_int_equal(tui_slider_position(t), 700);
}

/* Steps are whole rpm, and what is run and kept says them. */
static void
a_sheet_in_rpm_is_stepped_in_rpm(void **state)
{
	struct stage *stage = *state;
	struct tui *t = &stage->t;
	desk_expect(stage->desk, TIERP_CALIBRATED);
	struct site *site = session_current_site_entry(t->session)->site;
	site->rotor = 0.9;
	for (size_t r = 0; r < site->n_run; r++)
		site->run[r].speed =
		    rotor_speed_from_rpm(1464 + 106 * (double)r, 0.9);
	control_discard_outdated_state(t);
	type(t, "=1650\nl");
	assert_int_equal(tui_slider_position(t), 1651);
	FREED char *where = tui_speed_and_feed_options(t);
	assert_string_equal(where, "speed=1651rpm");
	type(t, "L");
	assert_int_equal(tui_slider_position(t), 1661);
	assert_true(tui_slider_speed(t) == rotor_speed_from_rpm(1661, 0.9));
	type(t, "=1600 rpm\n");
	assert_int_equal(tui_slider_position(t), 1600);
	type(t, "=72\n");
	assert_true(fabs(tui_slider_speed(t) - 72) < 1e-9);
	type(t, "=1900\n");
	assert_non_null(strstr(t->message, ":set slider 1379..1900rpm"));
	type(t, ":set slider 1380..1900rpm\n=1900\n");
	assert_int_equal(tui_slider_position(t), 1900);
	/* A page that the first digit opens is left again by a quick second. */
	t->aside = false;
	type(t, "4");
	t->clock += 1;
	assert_int_equal(t->ui.page, PAGE_PARITY);
	type(t, "1450\n");
	assert_int_equal(t->ui.page, PAGE_PARITY);
	assert_int_equal(tui_slider_position(t), 1450);
	type(t, "1");
	t->clock += 1;
	type(t, "2");
	assert_int_equal(t->ui.page, PAGE_FIT);
	t->clock += 1;
	type(t, "1");
	t->aside = true;
	/* Another site is in m/s, and the slider stays at its speed. */
	double speed = tui_slider_speed(t);
	site->rotor = 0;
	type(t, ":set slider 20..120\n");
	assert_true(fabs(tui_slider_speed(t) - speed) < 0.05);
}

/* Speeds of crushers are from 60 to 99 m/s: no page may take their digits. */
static void
a_digit_that_is_no_page_begins_a_speed(void **state)
{
	struct stage *stage = *state;
	struct tui *t = &stage->t;
	desk_expect(
	    stage->desk, "load data/sites/tierp.csv; set slider 60..99");
	control_discard_outdated_state(t);
	for (int tens = 6; tens <= 9; tens++) {
		char typed[] = {(char)('0' + tens), '9', '\n', '\0'};
		type(t, typed);
		assert_int_equal(t->ui.page, PAGE_PREDICT);
		assert_int_equal(tui_slider_position(t), 100 * tens + 90);
	}
	type(t, "5");
	assert_int_equal(t->ui.page, PAGE_SITES);
	assert_int_equal(t->speed.n, 0);
}

static void
a_word_too_long_to_find_does_nothing_else(void **state)
{
	struct tui *t = &((struct stage *)*state)->t;
	type(t, ":help keys\n");
	assert_true(t->viewer.keys);
	type(t, "\033?/what is longer than the room there is for a word: q");
	assert_true(t->viewer.word.active);
	assert_int_equal(t->viewer.word.n, VIEWER_WORD);
	assert_false(t->leave);
}

/* A key by its name. */
static void
press(struct tui *t, const char *name)
{
	int code = 0;
	assert_true(keys_code_of_name(name, &code));
	keymap_handle_key(t, code, code > 255);
}

/* Enter would do what cannot be seen. */
static void
a_smaller_screen_shows_the_key_under_the_cursor(void **state)
{
	struct tui *t = &((struct stage *)*state)->t;
	const struct viewer *v = &t->viewer;
	type(t, "?");
	frame_draw(t);
	for (int i = 0; i < 18; i++)
		press(t, "Down");
	struct display *was = screen_begin_offscreen(6, 60, CHARSET_ASCII, 0);
	frame_draw(t);
	canvas_free(screen_end_offscreen(was));
	assert_int_equal(v->at, 18);
	assert_in_range(v->at - v->top, 0, t->layout.body.rows - 1);
	assert_in_range(v->top, 1, 21);
	frame_draw(t);
	type(t, "\033:help predict\n");
	frame_draw(t);
	press(t, "PgDn");
	press(t, "PgDn");
	assert_in_range(v->top, 1, v->lines);
	was = screen_begin_offscreen(100, 80, CHARSET_ASCII, 0);
	frame_draw(t);
	canvas_free(screen_end_offscreen(was));
	assert_int_equal(v->top, 0);
}

static void
text_wider_than_the_screen_is_read_to_its_end(void **state)
{
	struct tui *t = &((struct stage *)*state)->t;
	type(t, ":help predict\n");
	struct display *was = screen_begin_offscreen(12, 30, CHARSET_ASCII, 0);
	frame_draw(t);
	for (int i = 0; i < 9; i++)
		press(t, "Right");
	frame_draw(t);
	assert_non_null(t->viewer.text);
	assert_in_range(t->viewer.left, 30, 50);
	for (int i = 0; i < 9; i++)
		press(t, "Left");
	frame_draw(t);
	assert_int_equal(t->viewer.left, 0);
	canvas_free(screen_end_offscreen(was));
	type(t, "x");
	assert_null(t->viewer.text);
	assert_int_equal(t->view.pinned.site[0], '\0');
}

/* Else a pause would count as slow work, and what is taken up again as
 * quick. */
static void
a_pause_is_no_part_of_the_search(void **state)
{
	struct tui *t = &((struct stage *)*state)->t;
	type(t, ":load data/sites/tierp.csv\n");
	t->clock = 100;
	type(t, "f");
	t->clock = 103;
	watch_run_due_fit_steps(t);
	type(t, " ");
	t->clock = 160;
	assert_float_equal(tui_calibration_seconds(t), 3, 1e-9);
	type(t, " ");
	t->clock = 161;
	assert_float_equal(tui_calibration_seconds(t), 4, 1e-9);
	type(t, "s");
	t->clock = 200;
	type(t, " ");
	assert_true(session_is_calibrating(t->session));
	t->clock = 202;
	assert_float_equal(tui_calibration_seconds(t), 6, 1e-9);
	t->session->hooks.confirm = says_yes;
	type(t, "f");
	assert_float_equal(tui_calibration_seconds(t), 0, 1e-9);
}

static void
the_scrubber_has_the_keys_of_the_slider(void **state)
{
	struct tui *t = &((struct stage *)*state)->t;
	desk_expect(((struct stage *)*state)->desk, TIERP_CALIBRATED);
	type(t, "2");
	size_t n = tui_calibration_history(t).n;
	int tenths = tui_slider_position(t);
	press(t, "Home");
	assert_int_equal(tui_shown_unpolished_generation(t), 1);
	press(t, "L");
	assert_int_equal(tui_shown_unpolished_generation(t), 11);
	press(t, "PgUp");
	assert_int_equal(tui_shown_unpolished_generation(t), n < 61 ? n : 61);
	press(t, "End");
	assert_int_equal(tui_shown_unpolished_generation(t), n);
	press(t, "H");
	/* The polish is a step of its own behind the last. */
	assert_int_equal(tui_count_generations(t), n + 1);
	assert_int_equal(tui_shown_unpolished_generation(t), n - 9);
	assert_int_equal(tui_slider_position(t), tenths);
	type(t, "1");
	press(t, "Home");
	assert_int_equal(tui_shown_unpolished_generation(t), n - 9);
	assert_int_equal(tui_slider_position(t), tui_slider_range(t).least);
}

static bool
mouse(struct tui *t, enum hit_kind kind, int row, int column)
{
	return hits_dispatch_mouse(
	    t, &t->hits, kind, row, column, keymap_handle_key);
}

/* Works out all that is drawn and draws it, as the loop does. */
static void
draw_all(struct tui *t)
{
	view_update(t);
	frame_draw(t);
}

/* It is set for whatever site comes next. */
static void
a_goal_outlives_its_site(void **state)
{
	struct stage *stage = *state;
	struct tui *t = &stage->t;
	desk_expect(stage->desk,
	    "load data/sites/tierp.csv; params set f_mat=1 e0_min=16 alpha=1");
	control_discard_outdated_state(t);
	draw_all(t);
	type(t, "tp80=5.4\n");
	draw_all(t);
	assert_true(goal_is_search_done(t));
	type(t, ":drop tierp\n");
	draw_all(t);
	assert_string_equal(t->session->set.goal, "p80=5.4");
	assert_false(goal_is_search_done(t));
	type(t, ":load data/sites/tierp.csv\n");
	draw_all(t);
}

/* Also where a first search has some on their way. */
static void
an_envelope_waits_for_parameters(void **state)
{
	struct stage *stage = *state;
	struct tui *t = &stage->t;
	desk_expect(
	    stage->desk, "load data/sites/tierp.csv; spec use EN 12620 0/4");
	assert_false(desk_say(stage->desk, "spec"));
	assert_non_null(
	    strstr(stage->desk->error.text, "has no parameters yet"));
	assert_false(desk_say(stage->desk, "spec EN 12620 0/4"));
	control_discard_outdated_state(t);
	type(t, "f..:spec\n");
	draw_all(t);
	assert_false(t->failed && t->message[0] == '\0');
}

/* From the fitted start: t, the value, Enter; find must say the same. */
static void
a_goal_takes_five_keys_and_is_met_where_find_says(void **state)
{
	struct stage *stage = *state;
	struct tui *t = &stage->t;
	desk_expect(stage->desk, TIERP_CALIBRATED);
	control_discard_outdated_state(t);
	type(t, "t5.2\n");
	assert_false(t->line.active);
	assert_string_equal(t->session->set.goal, "p80=5.2");
	assert_string_equal(t->command, "set goal \"p80=5.2\"");
	assert_false(goal_is_search_done(t));
	char *words = goal_result_text(t, GOALS_FULL);
	assert_string_equal(words, "goal p80=5.2: being worked out");
	free(words);
	words = goal_result_text(t, GOALS_SHORT);
	assert_string_equal(words, "goal");
	free(words);
	draw_all(t);
	assert_true(goal_is_search_done(t));
	double best = goal_best_speed(t);
	type(t, "N");
	assert_int_equal(tui_slider_position(t),
	    slider_position_of_speed(tui_slider_range(t), best));
	view_predict_at_slider(t);
	assert_string_equal(t->message, "the goal is met at 75.6 m/s");
	assert_string_equal(t->command, "predict speed=75.6");
	type(t, ":find p80=5.2\n");
	assert_float_equal(
	    session_number_in_last_answer(t->session, "find", "speed"), best,
	    1e-6);
	words = goal_result_text(t, GOALS_SHORT);
	assert_string_equal(words, "goal at 75.6");
	free(words);
	words = goal_result_text(t, GOALS_FULL);
	assert_string_equal(words, "goal p80=5.2: met at 75.6 m/s");
	free(words);
}

/* Not to the next run, nor is it dropped: the slider follows, or whatever is
 * asked at its speed. */
static void
a_key_of_the_goal_waits_for_its_speeds(void **state)
{
	struct stage *stage = *state;
	struct tui *t = &stage->t;
	desk_expect(stage->desk, TIERP_CALIBRATED);
	control_discard_outdated_state(t);
	type(t, "tpassing 2 = 33..35\n");
	static const char *const AWAY[] = {"l", "\033", "073.1\n"};
	t->aside = false;
	for (size_t i = 0; i < ARRAY_LEN(AWAY); i++) {
		type(t, "074.1\nN");
		assert_non_null(strstr(t->message, "working out"));
		assert_int_equal(tui_slider_position(t), 741);
		type(t, AWAY[i]);
		int there = tui_slider_position(t);
		track_run_pending_key(t, true);
		assert_int_equal(tui_slider_position(t), there);
	}
	t->ui.speed = 74.1;
	type(t, "N");
	view_predict_at_slider(t);
	assert_int_equal(tui_slider_position(t), 741);
	t->aside = true;
	pages_update(t);
	assert_true(strip_seconds_to_wait(t) <= 0);
	view_predict_at_slider(t);
	int best =
	    slider_position_of_speed(tui_slider_range(t), goal_best_speed(t));
	assert_int_not_equal(best, 741);
	assert_int_equal(tui_slider_position(t), best);
	assert_non_null(strstr(t->message, "best speed of the goal"));
	/* Before that it is worked out for who will not wait. */
	type(t, ":set level 90\n");
	assert_false(goal_is_search_done(t));
	t->ui.speed = 74.1;
	t->aside = false;
	type(t, "Nx");
	keymap_run_delayed_key(t);
	t->aside = true;
	assert_int_equal(lround(10 * t->view.pinned.speed), best);
}

/* Nor is it worked out again for what changes nothing of it. */
static void
a_goal_stays_known_until_something_else_is_asked(void **state)
{
	struct stage *stage = *state;
	struct tui *t = &stage->t;
	static const char *const SAME[] = {":why\n\033", "c", "x", "c", "1",
	    ":validate\n\033", ":show fit\n\033"},
				 *const OTHER[] = {":set correction off\n",
				     ":set k 0.9\n", ":params set alpha=0.5\n",
				     ":set goal p80<5.1\n"};
	desk_expect(stage->desk, TIERP_CALIBRATED);
	control_discard_outdated_state(t);
	type(t, "tp80<5.2\n");
	draw_all(t);
	for (size_t i = 0; i < ARRAY_LEN(SAME); i++) {
		type(t, SAME[i]);
		if (!goal_is_search_done(t))
			fail_msg("forgotten by %s", SAME[i]);
	}
	for (size_t i = 0; i < ARRAY_LEN(OTHER); i++) {
		type(t, OTHER[i]);
		if (goal_is_search_done(t))
			fail_msg("still known after %s", OTHER[i]);
		draw_all(t);
	}
}

/* The search itself tells what it has. */
static void
a_goal_may_be_set_while_a_first_search_runs(void **state)
{
	struct tui *t = &((struct stage *)*state)->t;
	type(t, ":load data/sites/tierp.csv\nt");
	assert_false(t->line.active);
	type(t, "f");
	watch_run_due_fit_steps(t);
	draw_all(t);
	type(t, "tp80<5.2\n");
	assert_string_equal(t->session->set.goal, "p80<5.2");
	assert_true(session_is_calibrating(t->session));
	type(t, "N");
	assert_null(t->pending_key);
}

/* The key that was pressed as it opened has closed it. */
static void
a_report_that_was_closed_is_shown_again(void **state)
{
	struct stage *stage = *state;
	struct tui *t = &stage->t;
	desk_expect(stage->desk, TIERP_CALIBRATED);
	control_discard_outdated_state(t);
	draw_all(t);
	type(t, "V");
	assert_null(t->viewer.text);
	type(t, "2:validate holdout=each\n");
	assert_true(session_is_calibrating(t->session));
	FREED char *hints = keys_hint_row_text(page_fit.hints_now(t), PAGE_FIT);
	assert_non_null(strstr(hints, "Esc stop"));
	assert_null(strstr(hints, "generation"));
	while (session_is_calibrating(t->session))
		watch_run_due_fit_steps(t);
	assert_non_null(t->viewer.text);
	char *report = xstrdup(t->viewer.text);
	type(t, "1");
	draw_all(t);
	assert_null(t->viewer.text);
	assert_string_equal(t->message, "validate: done, V shows it again");
	type(t, "l");
	assert_string_equal(t->message, "");
	type(t, "?\033V");
	assert_string_equal(t->viewer.text, report);
	free(report);
}

static void
the_crosshair_goes_to_both_ends_of_the_sieves(void **state)
{
	struct stage *stage = *state;
	struct tui *t = &stage->t;
	desk_expect(stage->desk, TIERP_CALIBRATED);
	control_discard_outdated_state(t);
	draw_all(t);
	type(t, "c");
	int tenths = tui_slider_position(t);
	size_t n = t->view.shown.product.n;
	for (size_t i = 0; i <= n; i++)
		press(t, "Down");
	assert_int_equal(t->ui.crosshair_sieve, n - 1);
	for (size_t i = 0; i <= n; i++)
		press(t, "Up");
	assert_int_equal(t->ui.crosshair_sieve, 0);
	type(t, ">><");
	assert_int_equal(t->ui.crosshair_passing, 55);
	assert_int_equal(tui_slider_position(t), tenths);
	press(t, "Left");
	assert_int_equal(t->ui.crosshair_sieve, 0);
	assert_int_equal(tui_slider_position(t), tenths - 1);
}

/* What is near a bound of a wide range is not at it. */
static void
the_chosen_parameter_and_those_at_bounds_are_marked(void **state)
{
	enum { ALPHA = 7 };
	struct stage *stage = *state;
	struct tui *t = &stage->t;
	desk_expect(stage->desk,
	    "load data/sites/tierp.csv; bounds alpha 0..60; "
	    "calibrate generations=3");
	control_discard_outdated_state(t);
	type(t, "2");
	press(t, "Down");
	type(t, "\n\033");
	assert_int_equal(t->ui.param_at, 1);
	draw_all(t);
	char *text = NULL;
	size_t n = 0;
	FILE *out = text_open_memory(&text, &n);
	canvas_print(screen_last_frame(), 0, out);
	fclose(out);
	assert_non_null(strstr(text, "beta1 >"));
	assert_null(strstr(text, "beta2 >"));
	struct search_shown past = tui_calibration_history(t);
	struct param_span span =
	    param_span_of_generation(t->session, &past, 0, ALPHA - 1);
	assert_true(span.near && !span.at_bound);
	const char *alpha = strstr(text, "alpha ");
	assert_non_null(alpha);
	assert_null(memchr(alpha, '!', strcspn(alpha, "\n")));
	free(text);
	type(t, ":bounds alpha 0..2\n");
	t->ui.param_at = ALPHA;
	type(t, "\n");
	assert_non_null(strstr(t->message, "alpha: 0..2 now"));
}

/* The parts of the search are one window, as `window` gives it. */
static void
the_limits_of_a_window_are_where_n_and_p_go(void **state)
{
	struct stage *stage = *state;
	struct tui *t = &stage->t;
	double limit[8];
	desk_expect(stage->desk, TIERP_CALIBRATED);
	control_discard_outdated_state(t);
	type(t, "tpassing 2 = 33..35, p80 > 5\n");
	draw_all(t);
	assert_int_equal(goal_list_limit_speeds(t, limit, 8), 2);
	desk_expect(stage->desk, "window \"passing 2 = 33..35\" \"p80 > 5\"");
	const struct session *s = t->session;
	assert_float_equal(session_number_in_last_answer(s, "window", "best"),
	    goal_best_speed(t), 0);
	assert_int_equal(t->view.goal.found->n_inside, 1);
	t->ui.speed = 65;
	type(t, "n");
	assert_int_equal(tui_slider_position(t),
	    slider_position_of_speed(tui_slider_range(t), limit[0]));
	type(t, "n");
	assert_int_equal(tui_slider_position(t),
	    slider_position_of_speed(tui_slider_range(t), limit[1]));
	type(t, "n");
	assert_int_equal(tui_slider_position(t),
	    slider_position_of_speed(tui_slider_range(t), limit[1]));
	type(t, "p");
	assert_int_equal(tui_slider_position(t),
	    slider_position_of_speed(tui_slider_range(t), limit[0]));
	bool certain;
	assert_true(goal_is_met_between(t, limit[0], limit[1], &certain));
	assert_false(goal_is_met_between(t, 80, 85, &certain));
	/* Certain within the measured speeds, though met beyond them. */
	type(t, "t\025passing 2 = 30..36, p80 < 5.6\n");
	draw_all(t);
	FREED char *beyond = goal_result_text(t, GOALS_SPEEDS),
		   *within = goal_result_text(t, GOALS_PLAIN);
	assert_non_null(strstr(beyond, ", partly extrapolated"));
	assert_non_null(strstr(within, "certain 69.2 to 77.3"));
	assert_null(strstr(within, "extrapolated"));
	/* Nothing is wanted any more: runs are where they go. */
	type(t, "t\025\n");
	assert_string_equal(t->session->set.goal, "");
	t->ui.speed = 65;
	type(t, "nn");
	assert_int_equal(tui_slider_position(t), 740);
}

static void
what_is_no_goal_stays_in_its_field(void **state)
{
	struct stage *stage = *state;
	struct tui *t = &stage->t;
	type(t, "t");
	assert_false(t->line.active);
	assert_true(t->bad);
	desk_expect(stage->desk, TIERP_CALIBRATED);
	control_discard_outdated_state(t);
	static const char *const BAD[] = {"p80 = few", "p80=5,p50=2",
	    "passing 2 < 140", "no such envelope", "p80=-1"};
	for (size_t i = 0; i < ARRAY_LEN(BAD); i++) {
		type(t, "t");
		type(t, BAD[i]);
		type(t, "\n");
		assert_true(t->line.active && t->bad);
		assert_string_equal(t->line.text, BAD[i]);
		assert_string_equal(t->session->set.goal, "");
		type(t, "\033");
		assert_false(t->line.active);
	}
	/* What stands there already is only offered. */
	static const struct {
		const char *typed, *goal;
	} ANEW[] = {{"t5.2\n", "p80=5.2"}, {"t5.4\n", "p80=5.4"},
	    {"t<6\n", "p80<6"}, {"t,fines<9\n", "p80<6,fines<9"},
	    {"tnone\n", ""}, {"tp80=5\n", "p80=5"}, {"t\025\n", ""}};
	for (size_t i = 0; i < ARRAY_LEN(ANEW); i++) {
		t->ui.quantity =
		    (struct quantity){.kind = QUANTITY_SIZE, .x = 0.8};
		type(t, ANEW[i].typed);
		assert_string_equal(t->session->set.goal, ANEW[i].goal);
	}
	assert_non_null(strstr(t->message, "no goal any more"));
	/* A sign of its own; a quantity alone is shown, and the goal stays. */
	type(t, "t<6\n");
	assert_string_equal(t->session->set.goal, "p80<6");
	type(t, "tpassing 4\n");
	assert_string_equal(t->session->set.goal, "p80<6");
	assert_int_equal(t->ui.quantity.kind, QUANTITY_PASSING);
	type(t, "t\t");
	assert_string_equal(t->line.text, "p80<6");
	type(t, "\033tfin\t");
	assert_string_equal(t->line.text, "fines<");
	type(t, "6\n");
	draw_all(t);
	assert_true(goal_is_search_done(t));
	type(t, "t\025EN 12620 0/4\n");
	draw_all(t);
	assert_true(t->view.goal.list.n > 1);
}

/* Of an envelope that is shown which ends its window, and what stands there as
 * the window's end is inside. */
static void
an_envelope_shows_what_binds(void **state)
{
	struct stage *stage = *state;
	struct tui *t = &stage->t;
	desk_expect(stage->desk, TIERP_CALIBRATED);
	control_discard_outdated_state(t);
	type(t, "t\025EN 12620 0/4\n");
	while (goal_is_search_needed(t))
		goal_run_search_step(t);
	const struct goal *g = &t->view.goal;
	assert_true(g->n_value == 0 && g->found->n_inside == 1);
	assert_true(
	    quantity_is_same(&t->ui.quantity, &g->list.at[g->binds].quantity));
}

static void
y_goes_round_the_quantities_above_the_track(void **state)
{
	struct stage *stage = *state;
	struct tui *t = &stage->t;
	desk_expect(stage->desk, TIERP_CALIBRATED);
	control_discard_outdated_state(t);
	for (int i = 0; i < 8; i++) {
		assert_true((t->ui.quantity.kind == QUANTITY_SIZE &&
				t->ui.quantity.x == 0.8) == (i == 0));
		draw_all(t);
		type(t, "y");
	}
	assert_true(
	    t->ui.quantity.kind == QUANTITY_SIZE && t->ui.quantity.x == 0.8);
	type(t, "Y");
	assert_int_equal(t->ui.quantity.kind, QUANTITY_SHARE);
	type(t, "y");
	/* A press there is one on the track. */
	draw_all(t);
	struct area above = t->layout.strip;
	assert_true(mouse(
	    t, HIT_PRESS, above.row, layout_track_area(&t->layout).column));
	assert_int_equal(tui_slider_position(t), tui_slider_range(t).least);
	hits_end_drag(&t->hits);
}

/* As set, a run's feed is the slider's too, and it can be taken back. */
static void
a_feed_that_is_set_is_the_sliders(void **state)
{
	struct stage *stage = *state;
	struct tui *t = &stage->t;
	desk_expect(stage->desk, TIERP_CALIBRATED);
	control_discard_outdated_state(t);
	draw_all(t);
	double mean = t->view.shown.p50;
	type(t, ":set feed 79\n");
	draw_all(t);
	assert_true(t->view.shown.p50 != mean);
	assert_string_equal(t->command, "predict speed=74.0 feed=79");
	desk_expect(stage->desk, "predict 74");
	assert_true(session_number_in_last_answer(t->session, "predict",
			"p50_mm") == 1000 * t->view.shown.p50);
	type(t, ":set feed mean\n");
	draw_all(t);
	assert_true(t->view.shown.p50 == mean);
}

/* So is a sheet's: the numbers, the strip and the goal are of it, also after
 * another calibration. */
static void
a_sheet_that_is_set_feeds_the_slider(void **state)
{
	struct stage *stage = *state;
	struct tui *t = &stage->t;
	const struct strip *strip = &t->view.strip;
	desk_expect(stage->desk, TIERP_CALIBRATED);
	control_discard_outdated_state(t);
	draw_all(t);
	double mean = t->view.shown.p50;
	type(t, ":set feed data/sites/bro.csv@69\n");
	for (size_t i = 0; i < 2; i++) {
		draw_all(t);
		assert_true(fabs(t->view.shown.p50 - mean) > 1e-4);
		assert_int_equal(strip->n, STRIP_POINTS);
		desk_expect(stage->desk, "predict 74");
		assert_true(session_number_in_last_answer(t->session, "predict",
				"p50_mm") == 1000 * t->view.shown.p50);
		struct prediction p = forecast_whole_product(t->session,
		    tui_site_entry_for_prediction(t), strip->speed[0],
		    SITE_MEAN_FEED);
		assert_true(fabs(strip->value[0][0] - 1000 * p.p80) < 1e-9);
		prediction_free(&p);
		desk_expect(
		    stage->desk, "calibrate train=69,74,79 population=200");
		control_discard_outdated_state(t);
	}
	type(t, "tp50=2.66\n");
	draw_all(t);
	desk_expect(stage->desk, "find p50=2.66");
	assert_true(
	    fabs(session_number_in_last_answer(t->session, "find", "speed") -
		 goal_best_speed(t)) < 1e-9);
	type(t, ":set feed mean\n");
	draw_all(t);
	assert_true(t->view.shown.p50 != mean);
	assert_ptr_equal(
	    tui_site_entry_for_prediction(t), tui_current_site_entry(t));
}

/* Not only from the next step of the slider on. */
static void
a_band_is_of_the_level_that_is_set(void **state)
{
	struct stage *stage = *state;
	struct tui *t = &stage->t;
	desk_expect(stage->desk, TIERP_CALIBRATED);
	control_discard_outdated_state(t);
	draw_all(t);
	const double *range = t->view.shown.range[1];
	double width = range[1] - range[0];
	type(t, ":set level 90\n");
	draw_all(t);
	assert_true(range[1] - range[0] > 1.1 * width);
	assert_string_equal(t->command, "set level 90");
}

/* Of each speed what predict says there, with its band. */
static void
the_curve_above_the_track_is_what_predict_says(void **state)
{
	struct stage *stage = *state;
	struct tui *t = &stage->t;
	const struct strip *strip = &t->view.strip;
	desk_expect(stage->desk, TIERP_CALIBRATED);
	control_discard_outdated_state(t);
	draw_all(t);
	assert_int_equal(strip->n, STRIP_POINTS);
	for (size_t i = 0; i < strip->n; i++) {
		const double *value = strip->value[i];
		struct question q = question_of_whole_product(t->session,
		    tui_current_site_entry(t), tui_run_index_of_feed(t));
		struct prediction p =
		    forecast_product(t->session, &q, strip->speed[i]);
		assert_true(fabs(value[0] - 1000 * p.p80) < 1e-9);
		assert_true(fabs(value[1] - 1000 * p.range[2][0]) < 1e-9);
		assert_true(fabs(value[2] - 1000 * p.range[2][1]) < 1e-9);
		prediction_free(&p);
	}
}

static void
a_point_makes_one_generation(void **state)
{
	struct tui *t = &((struct stage *)*state)->t;
	desk_expect(
	    ((struct stage *)*state)->desk, "load data/sites/tierp.csv");
	control_discard_outdated_state(t);
	type(t, "f...");
	assert_true(t->held);
	assert_int_equal(tui_calibration_history(t).n, 3);
	/* A search that waits is not pumped. */
	t->clock = 1000;
	watch_run_due_fit_steps(t);
	assert_int_equal(tui_calibration_history(t).n, 3);
	while (session_is_calibrating(t->session))
		type(t, ".");
	assert_true(tui_current_site_entry(t)->has_fit);
	size_t steps = tui_count_generations(t);
	assert_int_equal(tui_shown_generation_number(t), steps);
	type(t, "\t");
	press(t, "Home");
	type(t, ".");
	assert_int_equal(tui_shown_generation_number(t), 2);
	tui_show_generation(t, steps);
	type(t, ".");
	assert_int_equal(tui_shown_generation_number(t), steps);
}

/* With the key of the page and Enter in eight. */
static void
bounds_are_typed_on_their_strip(void **state)
{
	struct tui *t = &((struct stage *)*state)->t;
	struct session *s = t->session;
	desk_expect(((struct stage *)*state)->desk,
	    "load data/sites/tierp.csv; calibrate population=100 "
	    "generations=9");
	control_discard_outdated_state(t);
	type(t, "2");
	press(t, "Down");
	press(t, "Enter");
	assert_true(t->line.active);
	assert_string_equal(t->line.text, "bounds beta1 ");
	type(t, "0..5\n");
	assert_string_equal(t->command, "bounds beta1 0..5");
	assert_true(s->set.bounds.lower[0] == 0 && s->set.bounds.upper[0] == 5);
	press(t, "Up");
	assert_int_equal(t->ui.param_at, 1);
	for (int i = 0; i < 20; i++)
		press(t, "Down");
	assert_int_equal(t->ui.param_at, 7);
	frame_draw(t);
	int row = t->layout.side.row;
	while (!t->line.active && row < 24)
		mouse(t, HIT_PRESS, row++, t->layout.side.column + 2);
	assert_string_equal(t->line.text, "bounds beta1 ");
	assert_non_null(strstr(t->message, "type low..high"));
	press(t, "Esc");
	assert_string_equal(t->message, "");
}

static void
generations_are_slow_while_the_best_gains(void **state)
{
	struct tui *t = &((struct stage *)*state)->t;
	desk_expect(
	    ((struct stage *)*state)->desk, "load data/sites/tierp.csv");
	control_discard_outdated_state(t);
	assert_int_equal(t->ui.pace, PACE_AUTO);
	type(t, "f");
	bool slow = false, quick = false;
	for (double clock = 0; tui_calibration_history(t).n < 40;
	     clock += 0.001) {
		size_t before = tui_calibration_history(t).n;
		t->clock = t->due = clock;
		watch_run_due_fit_steps(t);
		assert_int_equal(tui_calibration_history(t).n, before + 1);
		slow = slow || t->due - clock > 0.2;
		quick = quick || t->due - clock < 0.03;
	}
	assert_true(slow && quick);
	type(t, "+");
	assert_true(PACES[t->ui.pace] == 50);
	type(t, "------");
	assert_int_equal(t->ui.pace, PACE_AUTO);
}

static void
the_mouse_drags_the_scrubber_to_its_ends(void **state)
{
	struct stage *stage = *state;
	struct tui *t = &stage->t;
	desk_expect(stage->desk, TIERP_CALIBRATED);
	type(t, "2");
	frame_draw(t);
	size_t n = tui_calibration_history(t).n;
	const struct area s = t->layout.caption;
	int column = 30;
	assert_true(n > 1 && s.rows == 1);
	assert_false(mouse(t, HIT_DRAG, s.row, column));
	assert_true(mouse(t, HIT_PRESS, s.row, column));
	assert_in_range(tui_shown_unpolished_generation(t), 2, n - 1);
	assert_true(mouse(t, HIT_DRAG, 0, 0));
	assert_int_equal(tui_shown_unpolished_generation(t), 1);
	assert_true(mouse(t, HIT_DRAG, 0, 90));
	assert_int_equal(tui_shown_unpolished_generation(t), n);
	hits_end_drag(&t->hits);
	assert_false(mouse(t, HIT_DRAG, 0, 0));
	assert_true(mouse(t, HIT_PRESS, t->layout.header.row, 79));
	assert_true(t->viewer.keys);
}

static void
the_list_has_the_keys_of_other_pages(void **state)
{
	struct stage *stage = *state;
	struct tui *t = &stage->t;
	desk_expect(
	    stage->desk, "load data/sites/tierp.csv data/sites/bro.csv");
	control_discard_outdated_state(t);
	type(t, "5");
	t->ui.list[PAGE_SITES].at = 0;
	type(t, "?/use a site\n");
	assert_int_equal(stage->desk->session->current, 0);
	assert_string_equal(t->command, "use tierp");
	assert_int_equal(t->ui.page, PAGE_PREDICT);
	type(t, "?/next plot\n");
	assert_int_equal(t->ui.picture, PLOT_PSD);
	assert_int_equal(t->ui.page, PAGE_PREDICT);
	type(t, "?/down in a list\n");
	assert_false(t->leave);
}

static void
a_colon_begins_a_line_over_what_fills_the_screen(void **state)
{
	struct tui *t = &((struct stage *)*state)->t;
	type(t, ":help predict\n");
	assert_non_null(t->viewer.text);
	type(t, ":bounds");
	assert_null(t->viewer.text);
	assert_true(t->line.active);
	assert_string_equal(t->line.text, "bounds");
	type(t, "\033?:undo");
	assert_string_equal(t->line.text, "undo");
}

/* What is on the frame. */
static char *
frame_text(void)
{
	char *text = NULL;
	size_t n = 0;
	FILE *out = text_open_memory(&text, &n);
	canvas_print(screen_last_frame(), 0, out);
	fclose(out);
	while (n > 0 && text[n - 1] == '\n')
		text[--n] = '\0';
	return text;
}

static void
labels_are_evenly_apart_on_the_tallest_screen(void **state)
{
	struct stage *stage = *state;
	struct tui *t = &stage->t;
	double last = NAN, step = NAN;
	size_t n = 0;
	canvas_free(screen_end_offscreen(stage->was));
	stage->was = screen_begin_offscreen(1000, 100, CHARSET_ASCII, 0);
	desk_expect(stage->desk, "load data/sites/tierp.csv; calibrate");
	control_discard_outdated_state(t);
	draw_all(t);
	char *text = frame_text();
	int row = 0, from = t->layout.strip.row,
	    to = from + t->layout.strip.rows;
	assert_true(t->layout.strip.rows > 64);
	for (const char *line = text; *line != '\0';
	     line += strcspn(line, "\n"), line += *line == '\n', row++) {
		double value;
		char head[5];
		size_t length = strcspn(line, "\n");
		snprintf(head, sizeof head, "%.*s",
		    length < 4 ? (int)length : 4, line);
		char *word = text_trim(head);
		if (row < from || row >= to || !text_parse_number(word, &value))
			continue;
		if (n++ > 1)
			assert_true(fabs(last - value - step) < 1e-6);
		step = last - value;
		last = value;
	}
	assert_true(n > 20);
	free(text);
}

/* Each is drawn, so that no line may ask for any number of them. */
static void
so_many_keys_are_pressed_and_no_more(void **state)
{
	struct screen_request request = {.rows = 5, .columns = 20};
	struct stage *stage = *state;
	struct error error = {0};
	static const char *const MANY[] = {
	    "Right*10000", "Left*9000 Right*1000", "Up*99999999999999999999"};
	control_close_screen(&stage->t);
	for (size_t i = 0; i < ARRAY_LEN(MANY); i++) {
		request.keys = MANY[i];
		assert_null(
		    script_draw_screen(stage->desk->session, &request, &error));
		assert_non_null(strstr(error.text, "at most 9999 keys"));
	}
	request.keys = "Left*9000 Right*999";
	struct canvas *canvas =
	    script_draw_screen(stage->desk->session, &request, &error);
	assert_non_null(canvas);
	canvas_free(canvas);
	control_open_screen(&stage->t, stage->desk->session, &SCRIPT_CALLBACKS);
}

static void
a_picture_of_the_open_screen_owns_its_own(void **state)
{
	struct stage *stage = *state;
	struct tui *t = &stage->t;
	stage->desk->session->hooks.draw_screen = script_draw_screen;
	canvas_free(screen_end_offscreen(stage->was));
	stage->was = screen_begin_offscreen(50, 170, CHARSET_ASCII, 0);
	desk_expect(stage->desk,
	    "load data/sites/bro.csv data/sites/tierp.csv; calibrate; "
	    "pin speed=70; use bro; calibrate");
	t->session->hooks.confirm = says_yes;
	control_discard_outdated_state(t);
	draw_all(t);
	/* On a terminal a goal is worked out part by part. */
	t->aside = false;
	t->view.moved = -1e9;
	type(t, "tp80=5..5.3\n");
	for (size_t part = 0; goal_is_search_needed(t); part++) {
		if (part % often(16, 1) == 0) {
			type(t, ":screen\n");
			assert_non_null(t->viewer.text);
			type(t, "\033");
		}
		draw_all(t);
	}
	assert_true(goal_is_search_done(t));
	t->aside = true;
	type(t, ":spec use EN 12620 0/4\n");
	for (enum page page = 0; page < PAGES; page++) {
		keymap_handle_key(t, '1' + (int)page, false);
		type(t, ":screen\n:screen width=150 height=48\n\033");
		t->message[0] = '\0';
		draw_all(t);
		char *before = frame_text();
		type(t, ":screen\n");
		assert_string_equal(t->viewer.text, before);
		type(t, "\033");
		t->message[0] = '\0';
		draw_all(t);
		free(before);
	}
	/* Nothing that was drawn beside it has moved it. */
	type(t, "1:screen page=5\n\033");
	assert_int_equal(t->ui.page, PAGE_PREDICT);
}

/* The frame as it is drawn once the loop has gone round, but for the rows of
 * the last command and of what it said. */
static char *
shown(struct tui *t)
{
	char *text = NULL;
	size_t n = 0;
	t->message[0] = '\0';
	free(t->command);
	t->command = NULL;
	draw_all(t);
	FILE *memory = open_memstream(&text, &n);
	free(t->command);
	t->command = NULL;
	frame_draw(t);
	canvas_print(screen_last_frame(), 0, memory);
	fclose(memory);
	char *copy = xstrdup(text);
	free(text);
	return copy;
}

/* T; Down chooses a condition, whose curve is drawn; Esc, or T again: back. */
static void
the_goal_fills_the_page(void **state)
{
	struct stage *stage = *state;
	struct tui *t = &stage->t;
	desk_expect(stage->desk, TIERP_CALIBRATED);
	control_discard_outdated_state(t);
	type(t, "T");
	assert_non_null(strstr(t->message, "no goal yet"));
	assert_false(goal_is_viewed(t));
	type(t, "tpassing 2 = 32..36, fines<3\n");
	draw_all(t);
	type(t, "T");
	draw_all(t);
	assert_true(goal_is_viewed(t));
	assert_true(t->layout.strip.rows > 8);
	assert_float_equal(t->ui.quantity.x, 2e-3, 1e-9);
	char *screen = shown(t);
	assert_non_null(strstr(screen, "70.8 to 78.0 m/s"));
	assert_non_null(strstr(screen, "chance of all at 74.0 m/s: over 99 %"));
	free(screen);
	type(t, "]");
	draw_all(t);
	screen = shown(t);
	assert_non_null(strstr(screen, " NO"));
	assert_non_null(strstr(screen, "at 79.0 m/s: "));
	free(screen);
	t->ui.list[PAGE_PREDICT].at = 0;
	desk_expect(stage->desk, "set goal \"fines<3, p80=5.2\"");
	control_discard_outdated_state(t);
	draw_all(t);
	assert_float_equal(t->ui.quantity.x, 0.063e-3, 1e-9);
	list_handle_move_key(
	    t, &(struct key){.act = act_move_in_list, .amount = 1});
	draw_all(t);
	assert_float_equal(t->ui.quantity.x, 0.8, 1e-9);
	screen = shown(t);
	assert_non_null(strstr(screen, "75.6 m/s"));
	assert_non_null(strstr(screen, " NO"));
	free(screen);
	type(t, "N");
	draw_all(t);
	screen = shown(t);
	assert_null(strstr(screen, " NO"));
	free(screen);
	type(t, "\033");
	assert_false(goal_is_viewed(t));
	assert_int_equal(t->ui.page, PAGE_PREDICT);
	type(t, "TT");
	assert_false(goal_is_viewed(t));
}

/* Whether a screen on a new session shows the same by that script. */
static void
shows_in_another(struct tui *t, const char *file, const char *was)
{
	void *desk;
	desk_open(&desk);
	struct session *other = ((struct desk *)desk)->session;
	const struct numbers pin = t->view.pinned;
	enum page page = t->ui.page;
	control_close_screen(t);
	control_open_screen(t, other, &SCRIPT_CALLBACKS);
	char *line = xasprintf(":source %s\n", file);
	type(t, line);
	free(line);
	control_close_screen(t);
	control_open_screen(t, other, &SCRIPT_CALLBACKS);
	char *is = shown(t);
	assert_int_equal(t->ui.page, page);
	assert_float_equal(t->ui.quantity.x, 0.2, 1e-12);
	assert_int_equal(t->session->pin->p.feed_run, 0);
	assert_true(t->view.pinned.speed == 74);
	assert_memory_equal(t->view.pinned.size, pin.size, sizeof pin.size);
	assert_string_equal(is, was);
	free(is);
	control_close_screen(t);
	desk_close(&desk);
}

/* Goal, pinned prediction with its feed, quantity, correction and page are
 * commands, so that the script brings all of them back. */
static void
what_is_shown_is_saved_and_shown_again(void **state)
{
	struct stage *stage = *state;
	struct tui *t = &stage->t;
	char folder[] = "/tmp/tipspeed-act-XXXXXX";
	assert_non_null(mkdtemp(folder));
	static const char *const PAGES_OF[] = {"2", "1", "5"};
	size_t pages = often(1, ARRAY_LEN(PAGES_OF));
	desk_expect(stage->desk, TIERP_CALIBRATED);
	type(t, ":predict 74 feed=69\n");
	view_predict_at_slider(t);
	type(t, "xt5.2\n");
	t->ui.speed = 71.2;
	view_predict_at_slider(t);
	type(t, "yya");
	for (size_t i = 0; i < pages; i++) {
		/* What was read cannot be overwritten. */
		char *file = xasprintf("%s/%zu.tip", folder, i);
		type(t, PAGES_OF[i]);
		char *line = xasprintf(":save %s\n", file);
		type(t, line);
		assert_non_null(strstr(t->message, "wrote"));
		assert_null(strstr(t->message, "without"));
		free(line);
		char *was = shown(t);
		/* In a new session, and then in the screen that is open. */
		shows_in_another(t, file, was);
		control_open_screen(t, stage->desk->session, &SCRIPT_CALLBACKS);
		type(t, ":reset\n");
		assert_int_equal(t->ui.page, PAGE_PREDICT);
		assert_string_equal(t->session->set.goal, "");
		assert_int_equal(t->view.pinned.site[0], '\0');
		line = xasprintf(":restore %s\n", file);
		type(t, line);
		/* No text of what its commands said is to be closed. */
		assert_null(t->viewer.text);
		free(line);
		char *is = shown(t);
		assert_string_equal(is, was);
		free(is);
		free(was);
		unlink(file);
		free(file);
	}
	rmdir(folder);
}

/* q, and tui again; what the page is is nothing to undo. */
/* The slider's own line takes the place of a line like it only. */
static void
a_question_stays_when_the_slider_moves(void **state)
{
	struct stage *stage = *state;
	struct tui *t = &stage->t;
	desk_expect(stage->desk, TIERP_CALIBRATED);
	control_discard_outdated_state(t);
	static const char *const TYPED[] = {
	    ":predict 70 detail=on\n\033", "l", "l", ":predict 71\n", "l"};
	for (size_t i = 0; i < ARRAY_LEN(TYPED); i++) {
		type(t, TYPED[i]);
		view_predict_at_slider(t);
	}
	char *text = NULL;
	size_t n = 0;
	FILE *memory = open_memstream(&text, &n);
	journal_write_script(t->session, NULL, memory);
	fclose(memory);
	assert_non_null(
	    strstr(text, "\npredict 70 detail=on\npredict speed=71.1\n"));
	free(text);
}

static void
what_is_left_is_found_again(void **state)
{
	struct stage *stage = *state;
	struct tui *t = &stage->t;
	struct session *s = stage->desk->session;
	desk_expect(stage->desk, TIERP_CALIBRATED);
	control_discard_outdated_state(t);
	view_predict_at_slider(t);
	type(t, "xtp80<5.2\ny4");
	t->aside = false; /* as where somebody looks */
	control_close_screen(t);
	assert_string_equal(s->set.goal, "p80<5.2");
	control_open_screen(t, s, &SCRIPT_CALLBACKS);
	assert_int_equal(t->ui.page, PAGE_PARITY);
	assert_float_equal(t->ui.quantity.x, 0.5, 1e-12);
	assert_true(t->view.pinned.speed == 74);
	type(t, "1u");
	assert_string_equal(s->set.goal, "");
	assert_int_equal(t->ui.page, PAGE_PREDICT);
	type(t, "u");
	assert_int_equal(t->view.pinned.site[0], '\0');
	assert_true(tui_current_site_entry(t)->has_fit);
	type(t, "UU");
	assert_string_equal(s->set.goal, "p80<5.2");
	assert_true(t->view.pinned.speed == 74);
	/* A search goes on when a goal is set, which is saved nevertheless. */
	s->hooks.confirm = says_yes;
	type(t, "fy");
	watch_run_due_fit_steps(t);
	assert_true(session_is_calibrating(s));
	type(t, "tp80<5.3\n");
	assert_true(session_is_calibrating(s));
	tui_stop_fit(t);
	char *text = NULL;
	size_t n = 0;
	FILE *memory = open_memstream(&text, &n);
	journal_write_script(s, NULL, memory);
	fclose(memory);
	assert_non_null(strstr(text, "set goal p80<5.3\n"));
	free(text);
}

/* To its end, with the slider moved between its steps. */
static void
go_through(struct tui *t, const char *at)
{
	size_t frames = 0;
	for (; session_is_calibrating(t->session); frames++) {
		if (frames == 1) {
			char *frame = shown(t);
			assert_non_null(strstr(frame, at));
			free(frame);
		}
		if (frames % 10 < 2) {
			double p80 = t->view.current.size[2];
			type(t, frames % 2 == 0 ? "H" : "L");
			view_predict_at_slider(t);
			assert_true(t->view.current.size[2] != p80);
			assert_non_null(t->view.shown.low);
		}
		watch_run_due_fit_steps(t);
	}
	assert_in_range(frames, 3, 100000);
}

/* Long commands are stepped: keys are taken meanwhile, a line says how far it
 * is, the result is the same as at the prompt, and Esc stops. */
static void
long_commands_leave_the_screen_live(void **state)
{
	struct stage *stage = *state;
	struct tui *t = &stage->t;
	struct session *s = stage->desk->session;
	static const struct {
		const char *line, *at, *field, *stopped;
	} LONG[] = {{":validate holdout=each\n", "WORKING  validate: gavle",
			"overall.rmse_pct", "before all speeds"},
	    {":league\n", "WORKING  league: gavle, model", "models.aicc",
		"before all models"},
	    {":validate all holdout=each\n", "WORKING  validate: gavle",
		"p50.rms_pct", "before all speeds"}};
	/* Held parameters make each of the many searches short. */
	desk_expect(stage->desk,
	    "load data/sites/gavle-4.csv; bounds f_mat 0.6; "
	    "bounds e0_min 15; bounds alpha 1; calibrate");
	size_t lines = often(1, ARRAY_LEN(LONG));
	for (size_t i = 0; i < lines; i++) {
		const char *command = LONG[i].line + 1;
		char *plain = xstrndup(command, strcspn(command, "\n")),
		     *name = xstrndup(command, strcspn(command, " \n"));
		desk_expect(stage->desk, plain);
		double want =
		    session_number_in_last_answer(s, name, LONG[i].field);
		session_remove_answers(s);
		control_discard_outdated_state(t);
		draw_all(t);
		t->aside = false; /* as where somebody looks */
		type(t, LONG[i].line);
		assert_true(session_is_calibrating(s));
		go_through(t, LONG[i].at);
		assert_non_null(t->viewer.text);
		assert_null(strstr(t->viewer.text, "calibrating G"));
		assert_float_equal(
		    session_number_in_last_answer(s, name, LONG[i].field), want,
		    1e-12);
		assert_true(tui_current_site_entry(t)->has_fit);
		type(t, "\033");
		assert_null(t->viewer.text);
		type(t, LONG[i].line);
		watch_run_due_fit_steps(t);
		type(t, "\033");
		assert_false(session_is_calibrating(s));
		assert_non_null(strstr(t->message, LONG[i].stopped));
		assert_true(tui_current_site_entry(t)->has_fit);
		t->aside = true;
		free(plain);
		free(name);
	}
}

/* The draws behind the light are steps, too: keys are taken between them, and
 * the page says what happens. */
static void
the_draws_after_a_fit_can_be_watched(void **state)
{
	struct stage *stage = *state;
	struct tui *t = &stage->t;
	struct session *s = stage->desk->session;
	desk_expect(stage->desk, "load data/sites/tierp.csv");
	control_discard_outdated_state(t);
	t->aside = false; /* as where somebody looks */
	t->ui.pace = PACE_FULL;
	type(t, "f");
	keymap_run_delayed_key(t);
	size_t drawing = 0;
	while (session_is_calibrating(s)) {
		watch_run_due_fit_steps(t);
		if (!session_is_calibrating(s) ||
		    calibration_status(s->job.calibration).state <
			CALIBRATE_TOLERANCE)
			continue;
		drawing++;
		char *frame = shown(t);
		assert_non_null(strstr(frame, "posterior"));
		free(frame);
	}
	assert_in_range(drawing, 2, 10000);
	assert_true(tui_current_site_entry(t)->has_fit);
	t->aside = true;
}

static void
e_proposes_a_file(void **state)
{
	struct tui *t = &((struct stage *)*state)->t;
	desk_expect(((struct stage *)*state)->desk,
	    TIERP_CALIBRATED "; predict speed=74");
	type(t, "e");
	assert_string_equal(
	    t->line.text, "predict speed=74.0 > tierp-74.0.xlsx");
	type(t, "\033");
	view_predict_at_slider(t);
	type(t, "xe");
	assert_string_equal(
	    t->line.text, "compare pinned 74.0 > tierp-74.0.xlsx");
	type(t, "ab\bc");
	assert_string_equal(t->line.text, "compare pinned 74.0 > ac");
	type(t, "\033");
}

/* In words what is to be seen, and not something else. */
static void
d_tells_the_picture_of_the_page(void **state)
{
	struct tui *t = &((struct stage *)*state)->t;
	desk_expect(((struct stage *)*state)->desk,
	    TIERP_CALIBRATED "; predict speed=74");
	type(t, "d");
	assert_string_equal(t->command, "describe psd speed=74.0");
	type(t, "\0334d");
	assert_string_equal(t->command, "describe parity");
	type(t, "\0332d");
	assert_string_equal(t->command, "describe search");
	type(t, "\033\t");
	press(t, "Home");
	type(t, "d");
	assert_string_equal(t->command, "describe search generation=1");
	press(t, "Esc");
	press(t, "End");
	type(t, "\tvd");
	assert_string_equal(t->command, "describe psd speed=74.0");
	type(t, "\033vd");
	assert_string_equal(t->command, "describe convergence");
	type(t, "\033vd");
	assert_string_equal(t->command, "describe spread");
	type(t, "\0331");
	view_predict_at_slider(t);
	type(t, "cbx");
	type(t, "76\n");
	view_predict_at_slider(t);
	type(t, "d");
	assert_string_equal(t->command,
	    "describe psd speed=76.0 beside=pinned band=on at=5.6 level=50");
	assert_non_null(t->viewer.text);
	assert_non_null(strstr(t->viewer.text, "crosshair at 5.6 mm"));
}

/* The pinned answer is told and exported as it was shown, with its own feed,
 * whatever feed the slider's has. */
static void
a_pinned_answer_keeps_its_feed(void **state)
{
	struct tui *t = &((struct stage *)*state)->t;
	char want[40];
	desk_expect(((struct stage *)*state)->desk, TIERP_CALIBRATED);
	type(t, ":predict 74 feed=69\n");
	view_predict_at_slider(t);
	type(t, "x");
	assert_int_equal(t->session->pin->p.feed_run, 0);
	type(t, "\033");
	type(t, ":predict 79 feed=79\n");
	view_predict_at_slider(t);
	assert_int_equal(t->view.shown.feed_run, 2);
	type(t, "d");
	assert_non_null(strstr(t->command, "beside=pinned"));
	snprintf(want, sizeof want, "P50 %.2f mm, P80 %.2f mm",
	    t->view.pinned.size[1], t->view.pinned.size[2]);
	assert_non_null(strstr(t->viewer.text, want));
	type(t, "\033e");
	assert_string_equal(
	    t->line.text, "compare pinned 79.0 feed=79 > tierp-79.0.xlsx");
	type(t, "\033");
}

/* The answer on another sheet's feed is a text; what is below it keeps its own,
 * and says what would take the other one. */
static void
another_feed_than_that_of_the_pages_is_told(void **state)
{
	struct tui *t = &((struct stage *)*state)->t;
	desk_expect(((struct stage *)*state)->desk, TIERP_CALIBRATED);
	view_predict_at_slider(t);
	struct numbers before = t->view.current;
	type(t, ":predict 74 feed=data/sites/bro.csv@69\n");
	assert_non_null(t->viewer.text);
	assert_non_null(
	    strstr(t->message, ":set feed data/sites/bro.csv@69 makes"));
	type(t, "\033");
	view_predict_at_slider(t);
	assert_true(t->view.current.size[1] == before.size[1]);
	type(t, ":set feed data/sites/bro.csv@69\n");
	view_predict_at_slider(t);
	assert_true(t->view.current.size[1] != before.size[1]);
	type(t, ":predict 74 feed=data/sites/bro.csv@69\n");
	assert_string_equal(t->message, "");
	type(t, "\033");
}

/* The linker puts these in the place of what they count. */
struct prediction __real_predict_at_table_sieves(
    const struct site *, size_t, const struct fraction *, struct forecast *);
struct prediction __wrap_predict_at_table_sieves(
    const struct site *, size_t, const struct fraction *, struct forecast *);
static size_t predictions;

struct prediction
__wrap_predict_at_table_sieves(const struct site *site, size_t feed_run,
    const struct fraction *fraction, struct forecast *f)
{
	predictions++;
	return __real_predict_at_table_sieves(site, feed_run, fraction, f);
}

/* With all that the page can show: the band, the crosshair, what is kept
 * beside. The session knows what was predicted, and can be saved with it. */
static void
a_step_predicts_once_and_says_nothing(void **state)
{
	struct tui *t = &((struct stage *)*state)->t;
	struct session *s = t->session;
	char *text = NULL;
	size_t n = 0;
	desk_expect(((struct stage *)*state)->desk,
	    TIERP_CALIBRATED "; predict speed=74");
	view_predict_at_slider(t);
	type(t, "xbc");
	frame_draw(t); /* what was measured is moved to the feed once */
	FILE *said = s->out,
	     *heard = s->out = s->notes = text_open_memory(&text, &n);
	for (int i = 0; i < 30; i++) {
		int before = tui_slider_position(t);
		press(t, i < 20 ? "L" : "H");
		predictions = 0;
		view_predict_at_slider(t);
		frame_draw(t);
		assert_int_equal(predictions, tui_slider_position(t) != before);
		assert_true(
		    t->view.shown.speed == tui_slider_position(t) / 10.0);
		assert_true(session_number_in_last_answer(s, "predict",
				"speed") == tui_slider_position(t) / 10.0);
	}
	fflush(heard);
	assert_int_equal(n, 0);
	assert_string_equal(t->command, "predict speed=75.0");
	journal_write_script(s, NULL, heard);
	fflush(heard);
	assert_non_null(strstr(text, "\npredict speed=75.0\n"));
	assert_null(strstr(text, "speed=75.1"));
	s->out = s->notes = said;
	fclose(heard);
	free(text);
}

/* Legend and numbers change together. */
static void
a_shows_the_answer_of_the_correction(void **state)
{
	struct tui *t = &((struct stage *)*state)->t;
	desk_expect(((struct stage *)*state)->desk,
	    TIERP_CALIBRATED "; predict speed=74");
	draw_all(t);
	double all = t->view.current.size[1];
	type(t, "aa");
	draw_all(t);
	assert_null(t->view.shown.low);
	assert_true(fabs(t->view.current.size[1] - all) > 1e-6);
	type(t, "a");
	draw_all(t);
	assert_non_null(t->view.shown.low);
	assert_float_equal(t->view.current.size[1], all, 1e-9);
	/* Page Data takes its column from the same answer; so does undo. */
	type(t, "3aau");
	draw_all(t);
	assert_non_null(t->view.shown.low);
}

/* A text without the breaks between its lines; the caller frees. */
static char *
on_one_line(const char *text)
{
	char *line = xstrdup(text);
	for (char *c = line; *c != '\0'; c++)
		*c = *c == '\n' ? ' ' : *c;
	return line;
}

/* Sizes are read straight between the sieves wherever they stand (D20). */
static void
a_size_is_one_number_everywhere(void **state)
{
	struct tui *t = &((struct stage *)*state)->t;
	char words[64];
	double apart = 0;
	desk_expect(((struct stage *)*state)->desk,
	    TIERP_CALIBRATED "; predict speed=80");
	draw_all(t);
	type(t, "cb");
	for (int v = 70; v <= 84; v += 2) {
		t->ui.speed = v;
		draw_all(t);
		double p50 = t->view.current.size[1];
		apart = fmax(
		    apart, fabs(p50 - 1000 * psd_size_at_passing(
						 &t->view.shown.product, 0.5)));
		type(t, "d");
		assert_non_null(t->viewer.text);
		char *told = on_one_line(t->viewer.text), *at = told;
		snprintf(words, sizeof words, "predicted %d m/s: ", v);
		/* Of the curve, and of the prediction. */
		for (int n = 0; n < 2; n++, at++) {
			at = strstr(at, words);
			assert_non_null(at);
			assert_float_equal(
			    strtod(strstr(at, "P50 ") + 4, NULL), p50, 0.0051);
		}
		at = strstr(told, "50 % pass:");
		assert_non_null(at);
		snprintf(words, sizeof words, "predicted %d m/s ", v);
		at = strstr(at, words) + strlen(words);
		assert_float_equal(strtod(at, NULL), p50, 0.0051);
		snprintf(words, sizeof words, "(%.2f to %.2f)",
		    1000 * t->view.shown.range[1][0],
		    1000 * t->view.shown.range[1][1]);
		assert_non_null(strstr(at, words));
		free(told);
		type(t, "\033");
	}
	assert_true(apart < 1e-9);
}

static bool
has_hint(const struct tui *t, const char *hint)
{
	FREED char *hints =
	    keys_hint_row_text(pages_current(t)->hints_now(t), t->ui.page);
	return strstr(hints, hint) != NULL;
}

static void
undo_says_what_it_took_and_how_it_comes_back(void **state)
{
	struct tui *t = &((struct stage *)*state)->t;
	desk_expect(((struct stage *)*state)->desk,
	    TIERP_CALIBRATED "; predict speed=74");
	draw_all(t);
	press(t, "Right");
	draw_all(t);
	assert_false(has_hint(t, "U redo"));
	type(t, "u");
	assert_false(tui_current_site_entry(t)->has_fit);
	assert_non_null(strstr(t->message, "population=200; U brings"));
	assert_true(has_hint(t, "U redo") && !has_hint(t, "x pin"));
	type(t, "U");
	assert_true(tui_current_site_entry(t)->has_fit);
	assert_null(strstr(t->message, "U brings"));
	while (!t->failed)
		type(t, "u");
	assert_false(has_hint(t, "U redo"));
}

/* One stray x loses nothing: as in "/x" where there is no list to search. */
static void
what_was_unpinned_can_be_pinned_again(void **state)
{
	struct tui *t = &((struct stage *)*state)->t;
	desk_expect(((struct stage *)*state)->desk,
	    TIERP_CALIBRATED "; predict speed=74");
	draw_all(t);
	type(t, "x");
	double p50 = t->view.pinned.size[1];
	for (int i = 0; i < 30; i++)
		press(t, "Right");
	draw_all(t);
	type(t, "/x");
	assert_int_equal(t->view.pinned.site[0], '\0');
	assert_non_null(strstr(t->message, "unpinned tierp at 74.0 m/s: u"));
	draw_all(t);
	type(t, "u");
	assert_true(
	    t->view.pinned.speed == 74 && t->view.pinned.size[1] == p50);
	assert_true(
	    t->session->pin->p.speed == 74 && t->session->pin->p.product.n > 0);
	assert_true(tui_current_site_entry(t)->has_fit);
	draw_all(t);
	/* x again pins what is shown; each is a step of undo. */
	type(t, "xx");
	assert_true(t->view.pinned.speed == 77);
	type(t, "x:set k 2\nuuuuu");
	assert_int_equal(t->view.pinned.site[0], '\0');
	assert_true(tui_current_site_entry(t)->has_fit);
	type(t, "u");
	assert_false(tui_current_site_entry(t)->has_fit);
}

/* What only reads leaves a search alone; what stops it tells. */
static void
a_line_stops_no_search_unsaid(void **state)
{
	struct tui *t = &((struct stage *)*state)->t;
	struct session *s = t->session;
	desk_expect(((struct stage *)*state)->desk,
	    TIERP_CALIBRATED "; predict speed=74");
	t->session->hooks.confirm = says_yes;
	control_discard_outdated_state(t);
	const double best = tui_current_site_entry(t)->fit.misfit;
	type(t, "f.. ");
	static const char *const BESIDE[] = {":help\n\033", ":hlep\n", "d\033",
	    ":bounds\n\033", ":predict 75 \n", ":show\n\033"};
	for (size_t i = 0; i < ARRAY_LEN(BESIDE); i++) {
		type(t, BESIDE[i]);
		assert_true(session_is_calibrating(s) && !t->held);
		assert_int_equal(tui_calibration_history(t).n, 2);
	}
	type(t, ":version\n");
	assert_non_null(t->viewer.text);
	type(t, "\033:set k 1\n");
	assert_false(session_is_calibrating(s));
	assert_non_null(strstr(t->message, "was stopped"));
	assert_non_null(strstr(t->message, ":accept"));
	assert_true(tui_current_site_entry(t)->fit.misfit == best);
	type(t, " ");
	assert_true(session_is_calibrating(s));
	type(t, ":window passing 2 = 32..36\n");
	assert_true(session_is_calibrating(s));
	assert_non_null(strstr(t->message, "when the calibration ends"));
	type(t, ":accept\n\033");
	assert_true(tui_current_site_entry(t)->fit.misfit > best);
	type(t, "u");
	assert_true(tui_current_site_entry(t)->fit.misfit == best);
}

/* A re-fit that is half done replaces no better one, whatever stops it. */
static void
no_way_to_stop_a_search_loses_a_better_fit(void **state)
{
	struct stage *stage = *state;
	struct tui *t = &stage->t;
	struct session *s = t->session;
	desk_expect(stage->desk,
	    "load data/sites/bro.csv data/sites/tierp.csv; calibrate; "
	    "predict speed=74");
	t->session->hooks.confirm = says_yes;
	control_discard_outdated_state(t);
	draw_all(t);
	const double best = tui_current_site_entry(t)->fit.misfit;
	/* "55" is Sites, and no speed; Enter there uses the site: the one in
	 * use is only looked at. */
	t->ui.list[PAGE_SITES].at = s->current;
	type(t, "f..55\n");
	assert_true(session_is_calibrating(s) && t->ui.page == PAGE_PREDICT);
	t->ui.list[PAGE_SITES].at = 0;
	static const char *const WAYS[] = {"s", "\003", "55\n", "5\n", "f\003",
	    ":use bro\n", ":find p80=5\n\033", ":sweep\n\033",
	    ":load data/sites/ossjo.csv\n", ":set k 2\nu", ":hlep; use bro\n",
	    ":validate\n\033", ":league\ns", ":continue\ns", ":calibrate\ns",
	    ":calibrate all pause=2\n"};
	for (size_t i = 0; i < ARRAY_LEN(WAYS); i++) {
		type(t, "1f..");
		assert_true(session_is_calibrating(s));
		type(t, WAYS[i]);
		for (int step = 0; step < 9 && session_is_calibrating(s);
		     step++)
			watch_run_fit_step(t);
		if (session_is_calibrating(s))
			type(t, "s");
		type(t, ":use tierp\n");
		draw_all(t);
		assert_string_equal(tui_current_site_entry(t)->key, "tierp");
		assert_true(tui_current_site_entry(t)->fit.misfit == best);
	}
	/* The last way is to quit, or a signal. */
	type(t, "1f..");
	control_close_screen(t);
	assert_false(session_is_calibrating(s));
	assert_true(session_current_site_entry(s)->fit.misfit == best);
	control_open_screen(t, s, &SCRIPT_CALLBACKS);
}

/* With a better fit before, nothing is taken, undone or brought back. */
static void
what_stops_a_search_says_so(void **state)
{
	struct stage *stage = *state;
	struct tui *t = &stage->t;
	desk_expect(stage->desk,
	    "load data/sites/bro.csv data/sites/tierp.csv; calibrate");
	t->session->hooks.confirm = says_yes;
	control_discard_outdated_state(t);
	type(t, "1f..u");
	assert_non_null(strstr(t->message, "cannot be continued"));
	assert_null(strstr(t->message, "U brings"));
	type(t, "1f..5");
	t->ui.list[PAGE_SITES].at = 0;
	type(t, "\n");
	assert_string_equal(t->command, "use bro");
	assert_non_null(strstr(t->message, "the calibration was stopped"));
	type(t, ":use tierp\n1f..onews\n");
	assert_non_null(strstr(t->message, "the calibration was stopped"));
	press(t, "Esc");
	press(t, "Esc");
}

static volatile sig_atomic_t stops;

static void
on_stop(int signal)
{
	stops += signal == SIGTSTP;
}

/* Keys that come at once are taken between two frames. */
static void
an_answer_is_measured_by_the_screen_and_not_by_the_text_before(void **state)
{
	struct tui *t = &((struct stage *)*state)->t;
	type(t, "?");
	frame_draw(t);
	type(t, "\033:predict 99999\n");
	assert_true(t->bad);
	assert_null(t->viewer.text);
}

static void
control_z_stops_wherever_it_is_typed(void **state)
{
	struct tui *t = &((struct stage *)*state)->t;
	struct sigaction action = {.sa_handler = on_stop}, was;
	sigemptyset(&action.sa_mask);
	sigaction(SIGTSTP, &action, &was);
	type(t, ":help\032");
	assert_int_equal(stops, 1);
	assert_string_equal(t->line.text, "help");
	type(t, "\n\032");
	assert_int_equal(stops, 2);
	assert_non_null(t->viewer.text);
	type(t, "\03371\032");
	assert_int_equal(stops, 3);
	assert_string_equal(t->speed.text, "71");
	type(t, "\033?/by\032");
	assert_int_equal(stops, 4);
	assert_string_equal(t->viewer.word.text, "by");
	sigaction(SIGTSTP, &was, NULL);
}

/* Letters of a word come faster than keys: of those before it the slider has
 * forgotten what they did. */
static void
a_word_begins_a_line(void **state)
{
	static const char *const WORDS[] = {"calibrate", "load", "help", "quit",
	    "undo", "find", "save", "export", "uncertainty"};
	struct stage *stage = *state;
	struct tui *t = &stage->t;
	desk_expect(stage->desk, TIERP_CALIBRATED);
	control_discard_outdated_state(t);
	t->aside = false;
	for (size_t i = 0; i < ARRAY_LEN(WORDS); i++) {
		t->clock += 5;
		for (const char *c = WORDS[i]; *c != '\0'; c++) {
			t->clock += 0.15;
			keymap_handle_key(t, *c, false);
		}
		assert_string_equal(t->line.text, WORDS[i]);
		assert_true(t->line.active);
		type(t, "\033");
		assert_int_equal(tui_slider_position(t), 740);
		assert_false(t->ui.crosshair || t->leave || t->picker.on);
	}
	t->aside = true;
}

static void
single_letters_are_keys(void **state)
{
	struct stage *stage = *state;
	struct tui *t = &stage->t;
	desk_expect(stage->desk, TIERP_CALIBRATED);
	control_discard_outdated_state(t);
	view_predict_at_slider(t);
	t->aside = false;
	type(t, "l");
	assert_int_equal(tui_slider_position(t), 741);
	t->clock += 0.5;
	type(t, "c");
	assert_false(t->ui.crosshair);
	assert_true(word_key_delay_seconds_left(t) > 0.2);
	t->clock += 0.5;
	assert_true(word_key_delay_seconds_left(t) == 0);
	keymap_run_delayed_key(t);
	assert_true(t->ui.crosshair);
	t->clock += 0.5;
	type(t, "a");
	assert_false(t->line.active);
	t->aside = true;
}

/* What it took to find is not lost by a letter. */
static void
f_asks_before_it_replaces_parameters(void **state)
{
	struct stage *stage = *state;
	struct tui *t = &stage->t;
	desk_expect(stage->desk, TIERP_CALIBRATED);
	control_discard_outdated_state(t);
	const struct origin *origin = t->session->entry[0].origin;
	type(t, "f");
	assert_string_equal(
	    t->message, "not calibrated again: the parameters stay");
	assert_false(session_is_calibrating(t->session));
	assert_ptr_equal(t->session->entry[0].origin, origin);
	type(t, "a");
	assert_int_equal(t->session->set.correction, CORRECTION_TRAIN);
	assert_non_null(strstr(t->message, "u undoes this"));
	type(t, "u");
	assert_int_equal(t->session->set.correction, CORRECTION_ALL);
}

/* As a terminal hands on what is pasted into it. */
static void
paste(struct tui *t, const char *text)
{
	input_handle_paste(t, SCREEN_PASTE, true);
	while (*text != '\0')
		assert_true(input_handle_paste(
		    t, (int)text_next_code_point(&text), false));
	input_handle_paste(t, SCREEN_PASTED, true);
	assert_false(input_handle_paste(t, 'q', false));
}

static void
what_is_pasted_is_no_keys(void **state)
{
	struct tui *t = &((struct stage *)*state)->t;
	paste(t, ":quit\n79\nq\003\032");
	assert_false(t->leave || t->session->quit);
	assert_string_equal(t->line.text, "quit");
	assert_non_null(strstr(t->message, "only part of the pasted text"));
	type(t, "\033");
	/* Keys with a name, as a hostile text may have them. */
	input_handle_paste(t, SCREEN_PASTE, true);
	assert_true(input_handle_paste(t, KEY_PPAGE, true));
	input_end_paste(t);
	assert_int_equal(tui_slider_position(t), 740);
}

static void
what_is_pasted_goes_into_an_open_line_up_to_its_end(void **state)
{
	struct tui *t = &((struct stage *)*state)->t;
	type(t, ":set k\t");
	paste(t, "\n 1\t\033[A5\302\233å\r\n");
	assert_string_equal(t->line.text, "set k  1 [A5å");
	assert_string_equal(t->message, "");
	paste(t, "9\nsecond");
	assert_string_equal(t->line.text, "set k  1 [A5å9");
	assert_non_null(strstr(t->message, "only part"));
	assert_true(t->line.active);
	type(t, "\0337");
	paste(t, "q1.5\n");
	assert_string_equal(t->speed.text, "71.5");
	type(t, "\033?");
	paste(t, "q");
	assert_non_null(t->viewer.text);
	type(t, "/");
	paste(t, "by\nq");
	assert_string_equal(t->viewer.word.text, "by");
}

static void
ten_megabytes_are_pasted(void **state)
{
	struct tui *t = &((struct stage *)*state)->t;
	for (int open = 0; open < 3; open++) {
		type(t, open == 0 ? ":" : open == 1 ? "\033?/" : "\033\0337");
		input_handle_paste(t, SCREEN_PASTE, true);
		for (int i = 0; i < 10000000; i++)
			input_handle_paste(t, '5', false);
		input_end_paste(t);
	}
	assert_string_equal(t->speed.text, "755555555555");
}

static void
a_question_is_answered_by_y_alone(void **state)
{
	struct tui *t = &((struct stage *)*state)->t;
	struct session *s = t->session;
	assert_false(s->hooks.confirm(s, "shall it?", false));
	assert_null(t->question);
	/* It stands on the frame that was drawn. */
	struct canvas *frame =
	    screen_end_offscreen(((struct stage *)*state)->was);
	assert_int_equal(canvas_cell_at(frame, 0, 23)->code, 's');
	assert_int_equal(canvas_cell_at(frame, 12, 23)->code, 'n');
	canvas_free(frame);
	((struct stage *)*state)->was =
	    screen_begin_offscreen(5, 20, CHARSET_ASCII, 0);
}

/* r; again or Esc: back. */
static void
all_runs_are_a_key_of_the_page(void **state)
{
	struct stage *stage = *state;
	struct tui *t = &stage->t;
	desk_expect(stage->desk, TIERP_CALIBRATED);
	frame_draw(t);
	static const char *const BACK[] = {"r", "Esc"};
	for (size_t i = 0; i < ARRAY_LEN(BACK); i++) {
		press(t, "r");
		frame_draw(t);
		assert_int_equal(t->drawn[0].kind, PLOT_RUNS);
		char *words = page_predict.words(t);
		assert_string_equal(words, "runs");
		free(words);
		press(t, BACK[i]);
		frame_draw(t);
		if (t->drawn[0].kind != PLOT_PSD)
			fail_msg("%s does not lead back", BACK[i]);
	}
}

#define ON_STAGE(test) \
	cmocka_unit_test_setup_teardown(test, stage_open, stage_close)

static const struct CMUnitTest TESTS[] = {
    ON_STAGE(all_runs_are_a_key_of_the_page),
    ON_STAGE(a_step_predicts_once_and_says_nothing),
    ON_STAGE(a_shows_the_answer_of_the_correction),
    ON_STAGE(a_line_stops_no_search_unsaid),
    ON_STAGE(no_way_to_stop_a_search_loses_a_better_fit),
    ON_STAGE(what_stops_a_search_says_so),
    ON_STAGE(a_size_is_one_number_everywhere),
    ON_STAGE(undo_says_what_it_took_and_how_it_comes_back),
    ON_STAGE(what_was_unpinned_can_be_pinned_again),
    ON_STAGE(an_envelope_waits_for_parameters),
    ON_STAGE(a_goal_outlives_its_site),
    ON_STAGE(a_goal_takes_five_keys_and_is_met_where_find_says),
    ON_STAGE(the_goal_fills_the_page),
    ON_STAGE(a_key_of_the_goal_waits_for_its_speeds),
    ON_STAGE(a_goal_stays_known_until_something_else_is_asked),
    ON_STAGE(a_goal_may_be_set_while_a_first_search_runs),
    ON_STAGE(a_report_that_was_closed_is_shown_again),
    ON_STAGE(the_crosshair_goes_to_both_ends_of_the_sieves),
    ON_STAGE(the_chosen_parameter_and_those_at_bounds_are_marked),
    ON_STAGE(the_limits_of_a_window_are_where_n_and_p_go),
    ON_STAGE(what_is_no_goal_stays_in_its_field),
    ON_STAGE(an_envelope_shows_what_binds),
    ON_STAGE(y_goes_round_the_quantities_above_the_track),
    ON_STAGE(the_curve_above_the_track_is_what_predict_says),
    ON_STAGE(a_feed_that_is_set_is_the_sliders),
    ON_STAGE(a_sheet_that_is_set_feeds_the_slider),
    ON_STAGE(a_band_is_of_the_level_that_is_set),
    ON_STAGE(every_letter_is_text_in_a_line),
    ON_STAGE(what_is_completed_is_whole_letters),
    ON_STAGE(the_keypad_has_an_enter),
    ON_STAGE(a_speed_is_typed_with_its_unit),
    ON_STAGE(a_sheet_in_rpm_is_stepped_in_rpm),
    ON_STAGE(a_digit_that_is_no_page_begins_a_speed),
    ON_STAGE(a_word_too_long_to_find_does_nothing_else),
    ON_STAGE(a_smaller_screen_shows_the_key_under_the_cursor),
    ON_STAGE(text_wider_than_the_screen_is_read_to_its_end),
    ON_STAGE(a_pause_is_no_part_of_the_search),
    ON_STAGE(the_scrubber_has_the_keys_of_the_slider),
    ON_STAGE(a_point_makes_one_generation),
    ON_STAGE(bounds_are_typed_on_their_strip),
    ON_STAGE(generations_are_slow_while_the_best_gains),
    ON_STAGE(the_mouse_drags_the_scrubber_to_its_ends),
    ON_STAGE(the_list_has_the_keys_of_other_pages),
    ON_STAGE(a_colon_begins_a_line_over_what_fills_the_screen),
    ON_STAGE(labels_are_evenly_apart_on_the_tallest_screen),
    ON_STAGE(so_many_keys_are_pressed_and_no_more),
    ON_STAGE(a_picture_of_the_open_screen_owns_its_own),
    ON_STAGE(what_is_shown_is_saved_and_shown_again),
    ON_STAGE(a_question_stays_when_the_slider_moves),
    ON_STAGE(what_is_left_is_found_again),
    ON_STAGE(long_commands_leave_the_screen_live),
    ON_STAGE(the_draws_after_a_fit_can_be_watched),
    ON_STAGE(e_proposes_a_file),
    ON_STAGE(a_pinned_answer_keeps_its_feed),
    ON_STAGE(another_feed_than_that_of_the_pages_is_told),
    ON_STAGE(d_tells_the_picture_of_the_page),
    ON_STAGE(an_answer_is_measured_by_the_screen_and_not_by_the_text_before),
    ON_STAGE(control_z_stops_wherever_it_is_typed),
    ON_STAGE(a_word_begins_a_line),
    ON_STAGE(single_letters_are_keys),
    ON_STAGE(f_asks_before_it_replaces_parameters),
    ON_STAGE(what_is_pasted_is_no_keys),
    ON_STAGE(what_is_pasted_goes_into_an_open_line_up_to_its_end),
    ON_STAGE(ten_megabytes_are_pasted),
    ON_STAGE(a_question_is_answered_by_y_alone),
};

int
main(void)
{
	chdir_to_source();
	return cmocka_run_group_tests(TESTS, NULL, NULL);
}

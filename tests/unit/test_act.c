/* What keys do on the full screen, and in a line that is typed there.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <fcntl.h>
#include <signal.h>
#include <string.h>
#include <unistd.h>

#include <curses.h>

#include "desk.h"

#include "base/text.h"
#include "cmd/journal.h"
#include "ui/act.h"
#include "ui/control.h"
#include "ui/frame.h"
#include "ui/input.h"
#include "ui/pane.h"
#include "ui/screen.h"
#include "ui/shot.h"
#include "ui/tui_state.h"

static void
type(struct tui *t, const char *text)
{
	while (*text != '\0')
		act_key(t, (int)text_next(&text), false);
}

/* A full screen on the session of a desk, drawn aside. */
struct stage {
	struct tui t;
	struct desk *desk;
	struct display *was;
};

static int
stage_open(void **state)
{
	struct stage *stage = xcalloc(1, sizeof *stage);
	void *desk;
	desk_open(&desk);
	stage->desk = desk;
	stage->was = screen_aside(24, 80, CHARSET_ASCII, 0);
	control_begin(&stage->t, stage->desk->session, &SHOT_WAYS);
	frame_draw(&stage->t);
	*state = stage;
	return 0;
}

static int
stage_close(void **state)
{
	struct stage *stage = *state;
	void *desk = stage->desk;
	control_end(&stage->t);
	canvas_free(screen_back(stage->was));
	free(stage);
	return desk_close(&desk);
}

/* U+0157 has the number of the keypad's Enter. */
static void
every_letter_is_text_in_a_line(void **state)
{
	struct tui *t = &((struct stage *)*state)->t;
	type(t, ":\u0157\u0107");
	assert_true(t->typing.active);
	assert_string_equal(t->typing.text, "\u0157\u0107");
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
	assert_string_equal(t->typing.text, "load x");
}

static void
the_keypad_has_an_enter(void **state)
{
	struct tui *t = &((struct stage *)*state)->t;
	type(t, "72.3");
	act_key(t, KEY_ENTER, true);
	assert_int_equal(t->tenths, 723);
	type(t, "?/up by 5");
	act_key(t, KEY_ENTER, true);
	assert_int_equal(t->tenths, 773);
	type(t, ":set k 1");
	act_key(t, KEY_ENTER, true);
	assert_false(t->typing.active);
	assert_string_equal(t->command, "set k 1");
}

static void
a_word_too_long_to_find_does_nothing_else(void **state)
{
	struct tui *t = &((struct stage *)*state)->t;
	type(t, "?/what is longer than the room there is for a word: q");
	assert_true(t->viewer.word.active);
	assert_int_equal(t->viewer.word.n, VIEWER_WORD);
	assert_false(t->leave);
}

/* A key by its name. */
static void
press(struct tui *t, const char *name)
{
	int code = 0;
	assert_true(keys_code(name, &code));
	act_key(t, code, code > 255);
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
	struct display *was = screen_aside(6, 60, CHARSET_ASCII, 0);
	frame_draw(t);
	canvas_free(screen_back(was));
	assert_int_equal(v->at, 18);
	assert_in_range(v->at - v->top, 0, t->places.body.rows - 1);
	assert_in_range(v->top, 1, 18);
	frame_draw(t);
	type(t, "\033:help predict\n");
	frame_draw(t);
	press(t, "PgDn");
	press(t, "PgDn");
	assert_in_range(v->top, 1, v->lines);
	was = screen_aside(100, 80, CHARSET_ASCII, 0);
	frame_draw(t);
	canvas_free(screen_back(was));
	assert_int_equal(v->top, 0);
}

static void
text_wider_than_the_screen_is_read_to_its_end(void **state)
{
	struct tui *t = &((struct stage *)*state)->t;
	type(t, ":help predict\n");
	struct display *was = screen_aside(12, 30, CHARSET_ASCII, 0);
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
	canvas_free(screen_back(was));
	type(t, "x");
	assert_null(t->viewer.text);
	assert_int_equal(t->pin.site[0], '\0');
}

/* Else a pause would count as slow work, and what is taken up again as quick. */
static void
a_pause_is_no_part_of_the_search(void **state)
{
	struct tui *t = &((struct stage *)*state)->t;
	type(t, ":load data/sites/tierp.csv\n");
	t->clock = 100;
	type(t, "f");
	t->clock = 103;
	control_pump(t);
	type(t, " ");
	t->clock = 160;
	assert_float_equal(tui_searched(t), 3, 1e-9);
	type(t, " ");
	t->clock = 161;
	assert_float_equal(tui_searched(t), 4, 1e-9);
	type(t, "s");
	t->clock = 200;
	type(t, " ");
	assert_true(session_busy(t->session));
	t->clock = 202;
	assert_float_equal(tui_searched(t), 6, 1e-9);
	type(t, "f");
	assert_float_equal(tui_searched(t), 0, 1e-9);
}

static void
the_scrubber_has_the_keys_of_the_slider(void **state)
{
	struct tui *t = &((struct stage *)*state)->t;
	desk_expect(((struct stage *)*state)->desk,
	    "load data/sites/tierp.csv; calibrate");
	type(t, "2\t");
	size_t n = tui_past(t).n;
	int tenths = t->tenths;
	assert_true(t->focus == &page_fit);
	press(t, "Home");
	assert_int_equal(tui_generation(t), 1);
	press(t, "L");
	assert_int_equal(tui_generation(t), 11);
	press(t, "PgUp");
	assert_int_equal(tui_generation(t), n < 61 ? n : 61);
	press(t, "End");
	assert_int_equal(tui_generation(t), n);
	press(t, "H");
	assert_int_equal(tui_generation(t), n - 10);
	assert_int_equal(t->tenths, tenths);
	type(t, "\t");
	press(t, "Home");
	assert_int_equal(tui_generation(t), n - 10);
	assert_int_equal(t->tenths, tui_range(t).least);
}

/* The letters of a command would each have done something. */

static void
the_mouse_drags_the_scrubber_to_its_ends(void **state)
{
	struct stage *stage = *state;
	struct tui *t = &stage->t;
	desk_expect(stage->desk, "load data/sites/tierp.csv; calibrate");
	type(t, "2");
	frame_draw(t);
	size_t n = tui_past(t).n;
	const struct area s = t->scrubber;
	assert_true(n > 1 && s.rows == 1);
	assert_false(page_fit.mouse(t, s.row + 1, s.column, true));
	assert_null(t->focus);
	assert_false(page_fit.mouse(t, s.row, s.column, false));
	assert_true(page_fit.mouse(t, s.row, s.column, true));
	assert_true(t->focus == &page_fit);
	assert_int_equal(tui_generation(t), 1);
	assert_true(page_fit.mouse(t, 0, s.column + s.columns / 2, false));
	assert_in_range(tui_generation(t), 2, n - 1);
	assert_true(page_fit.mouse(t, 0, s.column + s.columns + 9, false));
	assert_int_equal(tui_generation(t), n);
}

static void
the_list_has_the_keys_of_other_pages(void **state)
{
	struct stage *stage = *state;
	struct tui *t = &stage->t;
	desk_expect(
	    stage->desk, "load data/sites/tierp.csv data/sites/bro.csv");
	control_look(t);
	t->site_at = 0;
	type(t, "?/use this site\n");
	assert_int_equal(stage->desk->session->current, 0);
	assert_string_equal(t->command, "use tierp");
	type(t, "?/next plot\n");
	assert_int_equal(t->picture, PLOT_CONVERGENCE);
	assert_int_equal(t->page, PAGE_PREDICT);
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
	assert_true(t->typing.active);
	assert_string_equal(t->typing.text, "bounds");
	type(t, "\033?:undo");
	assert_string_equal(t->typing.text, "undo");
}

static void
e_proposes_a_file(void **state)
{
	struct tui *t = &((struct stage *)*state)->t;
	desk_expect(((struct stage *)*state)->desk,
	    "load data/sites/tierp.csv; calibrate; predict speed=74");
	type(t, "e");
	assert_string_equal(
	    t->typing.text, "predict speed=74.0 > tierp-74.0.csv");
	type(t, "\033");
	control_predict(t);
	type(t, "xe");
	assert_non_null(strstr(t->typing.text, "beside=tierp"));
	assert_non_null(strstr(t->typing.text, " > tierp-74.0.svg"));
}

/* In words what is to be seen, and not something else. */
static void
d_tells_the_picture_of_the_page(void **state)
{
	struct tui *t = &((struct stage *)*state)->t;
	desk_expect(((struct stage *)*state)->desk,
	    "load data/sites/tierp.csv; calibrate; predict speed=74");
	type(t, "d");
	assert_string_equal(t->command, "describe psd speed=74.0");
	type(t, "\0334d");
	assert_string_equal(t->command, "describe parity");
	type(t, "\0332d");
	assert_string_equal(t->command, "describe psd speed=74.0");
	type(t, "\033vd");
	assert_string_equal(t->command, "describe convergence");
	type(t, "\033vd");
	assert_string_equal(t->command, "describe spread");
	type(t, "\0331");
	control_predict(t);
	type(t, "cbx");
	type(t, "76\n");
	control_predict(t);
	type(t, "d");
	assert_string_equal(t->command,
	    "describe psd speed=76.0 beside=tierp other=74.0 band=on at=5.6 "
	    "level=50");
	assert_non_null(t->viewer.text);
	assert_non_null(strstr(t->viewer.text, "crosshair at 5.6 mm"));
}

/* The linker puts these in the place of what they count. */
struct prediction __real_predict(const struct site *, const struct params *,
    struct model_settings, double, size_t);
struct prediction __wrap_predict(const struct site *, const struct params *,
    struct model_settings, double, size_t);
static size_t predictions;

struct prediction
__wrap_predict(const struct site *site, const struct params *p,
    struct model_settings settings, double speed, size_t feed_run)
{
	predictions++;
	return __real_predict(site, p, settings, speed, feed_run);
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
	    "load data/sites/tierp.csv; calibrate; predict speed=74");
	control_predict(t);
	type(t, "xbc");
	FILE *said = s->out,
	     *heard = s->out = s->notes = text_memory(&text, &n);
	for (int i = 0; i < 30; i++) {
		int before = t->tenths;
		press(t, i < 20 ? "L" : "H");
		predictions = 0;
		control_predict(t);
		frame_draw(t);
		assert_int_equal(predictions, t->tenths != before);
		assert_true(t->shown.speed == t->tenths / 10.0);
		assert_true(
		    session_known(s, "predict", "speed") == t->tenths / 10.0);
	}
	fflush(heard);
	assert_int_equal(n, 0);
	assert_string_equal(t->command, "predict speed=75.0");
	journal_put(s, heard);
	fflush(heard);
	assert_non_null(strstr(text, "\npredict speed=75.0\n"));
	assert_null(strstr(text, "speed=75.1"));
	s->out = s->notes = said;
	fclose(heard);
	free(text);
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
	assert_string_equal(t->typing.text, "help");
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

/* As a terminal hands on what is pasted into it. */
static void
paste(struct tui *t, const char *text)
{
	input_paste(t, SCREEN_PASTE, true);
	while (*text != '\0')
		assert_true(input_paste(t, (int)text_next(&text), false));
	input_paste(t, SCREEN_PASTED, true);
	assert_false(input_paste(t, 'q', false));
}

static void
what_is_pasted_is_no_keys(void **state)
{
	struct tui *t = &((struct stage *)*state)->t;
	paste(t, ":quit\n79\nq\003\032");
	assert_false(t->typing.active || t->leave || t->session->quit);
	assert_non_null(strstr(t->message, "pasted text was ignored"));
	/* Keys with a name, as a hostile text may have them. */
	input_paste(t, SCREEN_PASTE, true);
	assert_true(input_paste(t, KEY_PPAGE, true));
	input_end_paste(t);
	assert_int_equal(t->tenths, 740);
}

static void
what_is_pasted_goes_into_an_open_line_up_to_its_end(void **state)
{
	struct tui *t = &((struct stage *)*state)->t;
	type(t, ":set k\t");
	paste(t, "\n 1\t\033[A5\302\233å\r\n");
	assert_string_equal(t->typing.text, "set k  1 [A5å");
	assert_string_equal(t->message, "");
	paste(t, "9\nsecond");
	assert_string_equal(t->typing.text, "set k  1 [A5å9");
	assert_non_null(strstr(t->message, "only part"));
	assert_true(t->typing.active);
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
		input_paste(t, SCREEN_PASTE, true);
		for (int i = 0; i < 10000000; i++)
			input_paste(t, '5', false);
		input_end_paste(t);
	}
	assert_string_equal(t->speed.text, "7555555");
}

static void
a_question_is_answered_by_y_alone(void **state)
{
	struct tui *t = &((struct stage *)*state)->t;
	struct session *s = t->session;
	assert_false(s->hooks.confirm(s, "shall it?"));
	assert_null(t->question);
	/* It stands on the frame that was drawn. */
	struct canvas *frame = screen_back(((struct stage *)*state)->was);
	assert_int_equal(canvas_at(frame, 0, 23)->code, 's');
	assert_int_equal(canvas_at(frame, 12, 23)->code, 'n');
	canvas_free(frame);
	((struct stage *)*state)->was = screen_aside(5, 20, CHARSET_ASCII, 0);
}

#define ON_STAGE(test) \
	cmocka_unit_test_setup_teardown(test, stage_open, stage_close)

int
main(void)
{
	const struct CMUnitTest tests[] = {
	    ON_STAGE(a_step_predicts_once_and_says_nothing),
	    ON_STAGE(every_letter_is_text_in_a_line),
	    ON_STAGE(what_is_completed_is_whole_letters),
	    ON_STAGE(the_keypad_has_an_enter),
	    ON_STAGE(a_word_too_long_to_find_does_nothing_else),
	    ON_STAGE(a_smaller_screen_shows_the_key_under_the_cursor),
	    ON_STAGE(text_wider_than_the_screen_is_read_to_its_end),
	    ON_STAGE(a_pause_is_no_part_of_the_search),
	    ON_STAGE(the_scrubber_has_the_keys_of_the_slider),
	    ON_STAGE(the_mouse_drags_the_scrubber_to_its_ends),
	    ON_STAGE(the_list_has_the_keys_of_other_pages),
	    ON_STAGE(a_colon_begins_a_line_over_what_fills_the_screen),
	    ON_STAGE(e_proposes_a_file),
	    ON_STAGE(d_tells_the_picture_of_the_page),
	    ON_STAGE(
		an_answer_is_measured_by_the_screen_and_not_by_the_text_before),
	    ON_STAGE(control_z_stops_wherever_it_is_typed),
	    ON_STAGE(what_is_pasted_is_no_keys),
	    ON_STAGE(what_is_pasted_goes_into_an_open_line_up_to_its_end),
	    ON_STAGE(ten_megabytes_are_pasted),
	    ON_STAGE(a_question_is_answered_by_y_alone),
	};
	chdir_to_source();
	return cmocka_run_group_tests(tests, NULL, NULL);
}

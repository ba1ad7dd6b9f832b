/* The panel of verdicts and the second plot, at sizes.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <string.h>

#include "desk.h"

#include "base/text.h"
#include "core/answer/forecast.h"
#include "tui/keymap.h"
#include "tui/control.h"
#include "tui/frame.h"
#include "tui/widgets/envelope_check.h"
#include "tui/pane.h"
#include "tui/screen.h"
#include "tui/script_terminal.h"
#include "tui/watch.h"
#include "tui/view.h"

/* A full screen on the session of a desk. */
struct stage {
	struct tui t;
	struct desk *desk;
};

static int
stage_open(void **state)
{
	struct stage *stage = xcalloc(1, sizeof *stage);
	void *desk;
	desk_open(&desk);
	stage->desk = desk;
	desk_expect(stage->desk, TIERP_CALIBRATED "; predict speed=74");
	struct display *was = screen_begin_offscreen(24, 80, CHARSET_ASCII, 0);
	control_open_screen(&stage->t, stage->desk->session, &SCRIPT_CALLBACKS);
	canvas_free(screen_end_offscreen(was));
	view_predict_at_slider(&stage->t);
	*state = stage;
	return 0;
}

static int
stage_close(void **state)
{
	struct stage *stage = *state;
	void *desk = stage->desk;
	control_close_screen(&stage->t);
	free(stage);
	return desk_close(&desk);
}

/* The page at a size, as lines; the caller frees. */
static char *
page(struct tui *t, int rows, int columns)
{
	struct display *was =
	    screen_begin_offscreen(rows, columns, CHARSET_ASCII, 0);
	char *text = NULL;
	size_t n = 0;
	view_update(t);
	frame_draw(t);
	struct canvas *canvas = screen_end_offscreen(was);
	FILE *out = text_open_memory(&text, &n);
	canvas_print(canvas, 0, out);
	fclose(out);
	canvas_free(canvas);
	return text;
}

static void
expect(struct tui *t, int rows, int columns, const char *words)
{
	char *text = page(t, rows, columns);
	if (strstr(text, words) == NULL)
		fail_msg("expected '%s', got\n%s", words, text);
	free(text);
}

static void
expect_none(struct tui *t, int rows, int columns, const char *words)
{
	char *text = page(t, rows, columns);
	if (strstr(text, words) != NULL)
		fail_msg("did not expect '%s' in\n%s", words, text);
	free(text);
}

static void
press(struct tui *t, const char *keys)
{
	while (*keys != '\0')
		keymap_handle_key(t, (int)text_next_code_point(&keys), false);
	view_update(t);
}

/* The most wanted where there is little room; with more of it the bands, the
 * sieves, and all there is. */
static void
the_panel_is_filled_by_height_and_width(void **state)
{
	struct tui *t = &((struct stage *)*state)->t;
	expect(t, 24, 80, "|P80    5.24+-0.04");
	expect(t, 24, 80, "|trust green");
	expect(t, 24, 80, "|<4 mm  65.4+-0.7%");
	expect_none(t, 24, 80, "5.21..5.28");
	expect(t, 30, 100, "| P80    5.24 mm  5.21..5.29");
	expect(t, 30, 100, "| <4 mm  65.4 %   64.6..66.1");
	expect(t, 50, 160, "|     4  31.3  65.4  -0.2  #");
	expect(t, 50, 160, "fit 0.30, held out 0.42 points");
	expect(t, 50, 160, "| 0.125   0.9   2.2  -0.1");
	expect(t, 20, 34, "P80 5.24");
	for (int rows = 1; rows < 60; rows += 7)
		for (int columns = 1; columns < 250; columns += 13)
			free(page(t, rows, columns));
}

static void
changes_are_those_against_what_is_pinned(void **state)
{
	struct tui *t = &((struct stage *)*state)->t;
	press(t, "x");
	press(t, "LLL");
	expect(t, 30, 100, "77.0 m/s  vs pinned 74.0");
	expect(t, 30, 100, "| P80    5.17 mm  5.12..5.21   -0.08");
	expect(t, 30, 100, "now vs pin");
	expect(t, 30, 100, "+2.5");
}

/* What `spec` says at every speed, though a step does not move the draws. */
static void
a_verdict_is_that_of_the_envelope(void **state)
{
	struct tui *t = &((struct stage *)*state)->t;
	size_t in_all = 0, all = 0;
	press(t, ":spec use ASTM C33 fine aggregate\n\033");
	struct slider_range range = tui_slider_range(t);
	for (int at = range.least; at <= range.most; at++) {
		tui_set_slider_position(t, at);
		view_update(t);
		const struct grading *g = envelope_check_at_slider(t);
		assert_non_null(g);
		struct grading own;
		struct error error = {0};
		assert_true(envelope_open_chosen_forecast(t->session,
		    tui_current_site_entry(t), tui_run_index_of_feed(t), &own,
		    &error));
		assert_in_range(g->limits.n, 1, 32);
		forecast_set_speed(
		    own.conditions.forecast, tui_slider_speed(t));
		for (size_t i = 0; i < g->limits.n; i++, all++) {
			bool in = conditions_are_met(&g->conditions, i);
			assert_int_equal(
			    in, conditions_are_met(&own.conditions, i));
			in_all += in;
		}
		assert_float_equal(
		    forecast_value_with_band(g->conditions.forecast, 3).value,
		    forecast_value_with_band(own.conditions.forecast, 3).value,
		    0);
		envelope_close(&own);
	}
	assert_in_range(in_all, 1, all - 1);
	t->ui.speed = 74;
	expect(t, 30, 100, "| 0/4.75 ASTM C33 fine aggregate");
	expect(t, 30, 100, "OUT");
	expect(t, 50, 160, "| FM");
	press(t, ":spec off\n");
	assert_null(envelope_check_at_slider(t));
}

static void
tonnes_are_those_of_the_feed_that_flow_was_told(void **state)
{
	struct tui *t = &((struct stage *)*state)->t;
	expect_none(t, 50, 160, "t/h");
	press(t, ":flow tph=120\n\033");
	expect(t, 50, 160, "| of 120 t/h");
	expect(t, 50, 160, "| <2 mm  40.6 t/h 40.1..41.2");
	press(t, ":flow tph=120 recycle=8/11.2\n\033");
	expect(t, 50, 160, " go back");
	expect_none(t, 50, 160, "of 120 t/h");
	press(t, ":load data/sites/bro.csv\n\033:calibrate\n\033");
	for (; session_is_calibrating(t->session); t->clock++)
		watch_run_due_fit_steps(t);
	press(t, "1");
	expect_none(t, 50, 160, "t/h");
}

/* The first row of a frame that has the words. */
static int
row_of(struct canvas *canvas, const char *words)
{
	for (int row = 0; row < canvas->rows; row++) {
		char line[101] = "";
		for (int column = 0; column < 100; column++)
			line[column] =
			    (char)canvas_cell_at(canvas, column, row)->code;
		if (strstr(line, words) != NULL)
			return row;
	}
	fail_msg("no row has '%s'", words);
	return 0;
}

/* A press on the row of the panel that has the words. */
static void
touch(struct tui *t, const char *words)
{
	struct display *was = screen_begin_offscreen(30, 100, CHARSET_ASCII, 0);
	frame_draw(t);
	struct canvas *canvas = screen_end_offscreen(was);
	int row = row_of(canvas, words);
	canvas_free(canvas);
	was = screen_begin_offscreen(30, 100, CHARSET_ASCII, 0);
	assert_true(hits_dispatch_mouse(t, &t->hits, HIT_PRESS, row,
	    t->layout.side.column + 1, keymap_handle_key));
	hits_end_drag(&t->hits);
	canvas_free(screen_end_offscreen(was));
}

static void
rows_of_the_panel_can_be_touched(void **state)
{
	struct tui *t = &((struct stage *)*state)->t;
	touch(t, "|   5.6");
	assert_true(t->ui.crosshair);
	assert_float_equal(
	    t->view.shown.product.size[t->ui.crosshair_sieve], 5.6e-3, 1e-9);
	touch(t, "| P80");
	assert_int_equal(t->ui.crosshair_passing, 80);
	assert_float_equal(
	    t->view.shown.product.size[t->ui.crosshair_sieve], 5.6e-3, 1e-9);
	touch(t, "| <2 mm");
	assert_float_equal(
	    t->view.shown.product.size[t->ui.crosshair_sieve], 2e-3, 1e-9);
	press(t, ":spec use ASTM C33 fine aggregate\n\033");
	touch(t, "| 0/4.75 ASTM C33");
	assert_non_null(strstr(t->viewer.text, "ASTM C33 fine aggregate"));
	press(t, "\033");
	touch(t, "| trust");
	assert_non_null(t->viewer.text);
	assert_string_equal(t->command, "why speed=74.0");
}

static void
a_light_tells_its_first_reason(void **state)
{
	struct tui *t = &((struct stage *)*state)->t;
	press(t, ":params set beta1=1 f_mat=1 e0_min=10 alpha=0.5\n\033");
	expect(t, 24, 80, "|trust red");
	expect(t, 24, 80, "parameters set");
}

#define ON_STAGE(test) \
	cmocka_unit_test_setup_teardown(test, stage_open, stage_close)

int
main(void)
{
	const struct CMUnitTest tests[] = {
	    ON_STAGE(the_panel_is_filled_by_height_and_width),
	    ON_STAGE(changes_are_those_against_what_is_pinned),
	    ON_STAGE(a_verdict_is_that_of_the_envelope),
	    ON_STAGE(tonnes_are_those_of_the_feed_that_flow_was_told),
	    ON_STAGE(rows_of_the_panel_can_be_touched),
	    ON_STAGE(a_light_tells_its_first_reason),
	};
	chdir_to_source();
	return cmocka_run_group_tests(tests, NULL, NULL);
}

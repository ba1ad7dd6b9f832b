/* The slider: values, columns and the track.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "base/xalloc.h"
#include "ui/slider.h"

static const struct slider_mark MARKS[] = {
    {690, true}, {740, false}, {790, true}};

static void
speeds_become_tenths_exactly(void **state)
{
	(void)state;
	for (int tenths = SLIDER_LEAST; tenths <= SLIDER_MOST; tenths++)
		assert_int_equal(slider_tenths(tenths / 10.0), tenths);
	assert_int_equal(slider_tenths(12), SLIDER_LEAST);
	assert_int_equal(slider_tenths(1e6), SLIDER_MOST);
	assert_int_equal(slider_clamp(SLIDER_MOST + 1), SLIDER_MOST);
}

static void
typed_speeds_are_read_within_the_range(void **state)
{
	(void)state;
	int tenths = 0;
	assert_true(slider_read("72.3", &tenths));
	assert_int_equal(tenths, 723);
	assert_true(slider_read("85", &tenths));
	assert_false(slider_read("64.9", &tenths));
	assert_false(slider_read("86", &tenths));
	assert_false(slider_read("7.", &tenths) && tenths != 850);
	assert_false(slider_read("", &tenths));
	assert_int_equal(tenths, 850);
}

/* On a track of 201 columns each value has a column of its own. */
static void
a_column_and_its_value_agree(void **state)
{
	(void)state;
	enum { WIDTH = SLIDER_MOST - SLIDER_LEAST + 1 };
	for (int c = 0; c < WIDTH; c++) {
		assert_int_equal(slider_at(c, WIDTH), SLIDER_LEAST + c);
		assert_int_equal(slider_column(SLIDER_LEAST + c, WIDTH), c);
	}
	for (int width = 2; width < 300; width++)
		for (int c = 0; c < width; c++)
			if (width <= WIDTH)
				assert_int_equal(
				    slider_column(slider_at(c, width), width),
				    c);
	assert_int_equal(slider_at(-5, 40), SLIDER_LEAST);
	assert_int_equal(slider_at(900, 40), SLIDER_MOST);
	assert_int_equal(slider_at(3, 1), SLIDER_LEAST);
}

static void
the_track_shows_zones_runs_and_value(void **state)
{
	(void)state;
	char text[128];
	int at = slider_draw(text, 41, 650, MARKS, ARRAY_LEN(MARKS));
	assert_int_equal(at, 0);
	assert_string_equal(text, "[65.0]xx|69-------o74-------|79xxxxxxxxxx");
	slider_draw(text, 41, 740, MARKS, ARRAY_LEN(MARKS));
	assert_string_equal(text, "xxxxxxxx|69----[74.0]-------|79xxxxxxxxxx");
	/* The handle covers a label whole. */
	slider_draw(text, 41, 680, MARKS, ARRAY_LEN(MARKS));
	assert_string_equal(text, "xxx[68.0]---------o74-------|79xxxxxxxxxx");
	slider_draw(text, 41, 850, MARKS, ARRAY_LEN(MARKS));
	assert_string_equal(text + 35, "[85.0]");
	slider_draw(text, 101, 760, MARKS, ARRAY_LEN(MARKS));
	assert_string_equal(text,
	    "xxxxxxxxxxxxxxxxxxxx|69 m/s 2380 J/kg--------o74-"
	    "---[76.0]------------|79 m/s 3120 J/kgxxxxxxxxxxxxxx");
	slider_draw(text, 41, 850, NULL, 0);
	assert_int_equal(text[0], 'x');
}

static void
any_width_is_drawn(void **state)
{
	(void)state;
	char text[400];
	for (int width = 0; width < 400; width++)
		for (int tenths = SLIDER_LEAST; tenths <= SLIDER_MOST;
		     tenths += 7) {
			int at = slider_draw(
			    text, width, tenths, MARKS, ARRAY_LEN(MARKS));
			assert_int_equal(strlen(text), width);
			assert_true(at >= 0 && (at < width || width == 0));
		}
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(speeds_become_tenths_exactly),
	    cmocka_unit_test(typed_speeds_are_read_within_the_range),
	    cmocka_unit_test(a_column_and_its_value_agree),
	    cmocka_unit_test(the_track_shows_zones_runs_and_value),
	    cmocka_unit_test(any_width_is_drawn),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}

/* The slider: values, columns and the track.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "base/xalloc.h"
#include "core/psd/site.h"
#include "tui/widgets/slider.h"

enum { SLIDER_LEAST = 650, SLIDER_MOST = 850 };
static const struct slider_range ALL = {SLIDER_LEAST, SLIDER_MOST, 0};

static const struct slider_mark MARKS[] = {
    {690, true}, {740, false}, {790, true}};

static struct slider_range
range_of(const struct site *site)
{
	double from, to;
	site_default_speed_range(site, &from, &to);
	return slider_range(from, to, 0);
}

/* The signs of the track as text. */
static int
draw(char *text, int width, struct slider_range range, int tenths,
    const struct slider_mark *mark, size_t n, const bool *kept,
    const char *beyond)
{
	struct slider_cell cell[401];
	int at = slider_fill_cells(
	    cell, width, range, tenths, mark, n, kept, beyond);
	for (int c = 0; c < width; c++)
		text[c] = cell[c].sign;
	text[width] = '\0';
	return at;
}

static void
speeds_become_tenths_exactly(void **state)
{
	(void)state;
	for (int tenths = SLIDER_LEAST; tenths <= SLIDER_MOST; tenths++)
		assert_int_equal(
		    slider_position_of_speed(ALL, tenths / 10.0), tenths);
	assert_int_equal(slider_position_of_speed(ALL, 12), SLIDER_LEAST);
	assert_int_equal(slider_position_of_speed(ALL, 1e6), SLIDER_MOST);
	assert_int_equal(
	    slider_clamped_position(ALL, SLIDER_MOST + 1), SLIDER_MOST);
}

/* On a track of 201 columns each value has a column of its own. */
static void
a_column_and_its_value_agree(void **state)
{
	(void)state;
	enum { WIDTH = SLIDER_MOST - SLIDER_LEAST + 1 };
	for (int c = 0; c < WIDTH; c++) {
		assert_int_equal(
		    slider_position_at_column(ALL, c, WIDTH), SLIDER_LEAST + c);
		assert_int_equal(
		    slider_column_of_position(ALL, SLIDER_LEAST + c, WIDTH), c);
	}
	for (int width = 2; width < 300; width++)
		for (int c = 0; c < width; c++)
			if (width <= WIDTH)
				assert_int_equal(slider_column_of_position(ALL,
						     slider_position_at_column(
							 ALL, c, width),
						     width),
				    c);
	assert_int_equal(slider_position_at_column(ALL, -5, 40), SLIDER_LEAST);
	assert_int_equal(slider_position_at_column(ALL, 900, 40), SLIDER_MOST);
	assert_int_equal(slider_position_at_column(ALL, 3, 1), SLIDER_LEAST);
}

static void
the_track_shows_zones_runs_and_value(void **state)
{
	(void)state;
	char text[128];
	int at = draw(text, 41, ALL, 650, MARKS, ARRAY_LEN(MARKS), NULL, "");
	assert_int_equal(at, 0);
	assert_string_equal(text, "[65.0]xx|69-------o74-------|79 xxxxxxxxx");
	draw(text, 41, ALL, 740, MARKS, ARRAY_LEN(MARKS), NULL, "");
	assert_string_equal(text, "xxxxxxxx|69----[74.0]-------|79 xxxxxxxxx");
	/* The handle covers a label whole. */
	draw(text, 41, ALL, 680, MARKS, ARRAY_LEN(MARKS), NULL, "");
	assert_string_equal(text, "xxx[68.0]---------o74-------|79 xxxxxxxxx");
	draw(text, 41, ALL, 850, MARKS, ARRAY_LEN(MARKS), NULL, "");
	assert_string_equal(text + 35, "[85.0]");
	draw(text, 101, ALL, 760, MARKS, ARRAY_LEN(MARKS), NULL, "");
	assert_string_equal(text,
	    "xxxxxxxxxxxxxxxxxxxx|69 m/s 2380 J/kg--------o74-"
	    "---[76.0]------------|79 m/s 3120 J/kg xxxxxxxxxxxxx");
	draw(text, 41, ALL, 850, NULL, 0, NULL, "");
	assert_int_equal(text[0], 'x');
}

/* Runs at 62.4 and 88 m/s: a slider that ended at 65 would show the slower one
 * as trained there, and could not go to it. */
static void
the_range_holds_the_runs_of_the_site(void **state)
{
	(void)state;
	struct run runs[] = {{.speed = 62.4}, {.speed = 88}};
	struct site site = {.run = runs, .n_run = 2};
	struct slider_range range = range_of(&site);
	assert_int_equal(range.least, 620);
	assert_int_equal(range.most, 880);
	assert_int_equal(slider_position_of_speed(range, 62.4), 624);
	assert_true(slider_has_speed(range, 62.4));
	assert_false(slider_has_speed(range, 61.9));
	static const struct slider_mark marks[] = {{624, true}, {880, true}};
	char text[64];
	draw(text, 27, range, 740, marks, 2, NULL, "");
	assert_string_equal(text, "|62.4----[74.0]-----------|");
	runs[0].speed = 0; /* a feed for any speed */
	runs[1].speed = 74;
	range = range_of(&site);
	assert_int_equal(range.least, SLIDER_LEAST);
	assert_int_equal(range.most, SLIDER_MOST);
	range = range_of(NULL);
	assert_int_equal(range.most, SLIDER_MOST);
}

/* The window begins in column 10 and ends in 18: behind a label it would begin
 * later, and before one end earlier. */
static void
no_label_covers_the_ends_of_a_window(void **state)
{
	(void)state;
	char text[128];
	bool kept[101] = {[9] = true, [18] = true};
	draw(text, 41, ALL, 800, MARKS, ARRAY_LEN(MARKS), kept, "");
	assert_string_equal(text, "xxxxxxxx|---------o74------[80.0]xxxxxxxx");
	kept[9] = kept[18] = false;
	kept[60] = true;
	draw(text, 101, ALL, 650, MARKS, ARRAY_LEN(MARKS), kept, "");
	assert_string_equal(text + 20,
	    "|69----------------------o74----------------------|79"
	    " xxxxxxxxxxxxxxxxxxxxxxxxxxx");
}

/* A mill that runs at a tenth of the speed: of a track up to 85 m/s its runs
 * would have three columns. */
/* Where the handle stands on it there is none. */
static void
a_word_says_what_is_beyond(void **state)
{
	(void)state;
	char text[128];
	draw(
	    text, 101, ALL, 740, MARKS, ARRAY_LEN(MARKS), NULL, "extrapolated");
	assert_memory_equal(text, "xxx extrapolated xxx|69 m/s", 27);
	draw(
	    text, 101, ALL, 670, MARKS, ARRAY_LEN(MARKS), NULL, "extrapolated");
	assert_memory_equal(text, "xxxxxxx[67.0]xxxxxxx|69 m/s", 27);
	draw(text, 41, ALL, 740, MARKS, ARRAY_LEN(MARKS), NULL, "extrapolated");
	assert_memory_equal(text, "xxxxxxxx|69", 11);
}

static void
a_slow_machine_has_a_track_of_its_own(void **state)
{
	(void)state;
	struct run runs[] = {{.speed = 6.5}, {.speed = 8.2}, {.speed = 9.8}};
	struct site site = {.run = runs, .n_run = 3};
	struct slider_range range = range_of(&site);
	assert_int_equal(range.least, 40);
	assert_int_equal(range.most, 120);
	site.n_run = 1;
	range = range_of(&site);
	assert_true(range.least >= 10 && range.least < 65);
	assert_true(range.most > 65 && range.most <= 140);
	runs[0].speed = 40; /* slow for such a crusher, but one */
	range = range_of(&site);
	assert_int_equal(range.least, 400);
	assert_int_equal(range.most, SLIDER_MOST);
	runs[0].speed = 390; /* no speed above 400 m/s can be asked for */
	range = range_of(&site);
	assert_int_equal(range.most, 10 * SITE_FASTEST);
}

/* A sheet in rpm: each end is that of a run there. */
static void
a_sheet_in_rpm_has_a_track_in_rpm(void **state)
{
	(void)state;
	enum { WIDTH = 60 };
	char text[WIDTH + 1];
	const double rotor = 0.9;
	struct slider_range range = slider_range(65, 85, rotor);
	assert_int_equal(range.least, 1379);
	assert_int_equal(range.most, 1804);
	for (int rpm = range.least; rpm <= range.most; rpm++) {
		double v = slider_speed_of_position(range, rpm);
		assert_int_equal(slider_position_of_speed(range, v), rpm);
		assert_true(slider_has_speed(range, v));
		struct slider_range from = slider_range(v, 85, rotor);
		struct slider_range to = slider_range(65, v, rotor);
		assert_int_equal(from.least, rpm);
		assert_int_equal(to.most, rpm);
	}
	const struct slider_mark mark[] = {{1380, true}, {1600, true}};
	draw(text, WIDTH, range, 1500, mark, 2, NULL, "extrapolated");
	assert_string_equal(text,
	    "|1380---------[1500]-----------|1600 rpm 2843 "
	    "J/kg xxxxxxxxx");
}

static void
any_width_is_drawn(void **state)
{
	(void)state;
	char text[400];
	for (int width = 0; width < 400; width++)
		for (int tenths = SLIDER_LEAST; tenths <= SLIDER_MOST;
		     tenths += 7) {
			int at = draw(text, width, ALL, tenths, MARKS,
			    ARRAY_LEN(MARKS), NULL, "");
			assert_int_equal(strlen(text), width);
			assert_true(at >= 0 && (at < width || width == 0));
		}
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(speeds_become_tenths_exactly),
	    cmocka_unit_test(a_column_and_its_value_agree),
	    cmocka_unit_test(the_track_shows_zones_runs_and_value),
	    cmocka_unit_test(a_word_says_what_is_beyond),
	    cmocka_unit_test(no_label_covers_the_ends_of_a_window),
	    cmocka_unit_test(the_range_holds_the_runs_of_the_site),
	    cmocka_unit_test(a_slow_machine_has_a_track_of_its_own),
	    cmocka_unit_test(a_sheet_in_rpm_has_a_track_in_rpm),
	    cmocka_unit_test(any_width_is_drawn),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}

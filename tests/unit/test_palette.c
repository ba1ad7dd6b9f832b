/* The colours as people see them who lack red or green receptors: distances in
 * CIE Lab, contrast on dark and light grounds.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "plot/palette.h"

/* Least distance of any two, and least contrast to the ground: 3 to 1 is what
 * WCAG 2.1 asks of graphics, 2.2 is what a colour for both grounds has of it. */
#define APART 14.0
#define ANY_GROUND 2.2
#define ON_BLACK 4.5
#define HIGH 4.1

static const unsigned DARK = 0x161B22, LIGHT = 0xFFFFFF;

/* Eyes with all receptors, without those for red, without those for green:
 * Machado, Oliveira and Fernandes 2009, severity 1, of linear RGB. */
static const double EYES[][3][3] = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
    {{0.152286, 1.052583, -0.204868}, {0.114503, 0.786281, 0.099216},
	{-0.003882, -0.048116, 1.051998}},
    {{0.367322, 0.860646, -0.227968}, {0.280085, 0.672501, 0.047413},
	{-0.011820, 0.042940, 0.968881}}};
enum { EYES_N = sizeof EYES / sizeof EYES[0] };

static double
dot(const double *a, const double *b)
{
	return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void
linear(unsigned rgb, double out[static 3])
{
	for (int i = 0; i < 3; i++) {
		double c = (rgb >> (8 * (2 - i)) & 0xFF) / 255.0;
		out[i] =
		    c <= 0.04045 ? c / 12.92 : pow((c + 0.055) / 1.055, 2.4);
	}
}

static double
bent(double t)
{
	return t > 216.0 / 24389 ? cbrt(t) : (24389.0 / 27 * t + 16) / 116;
}

/* CIE L*a*b* under daylight. */
static void
lab(unsigned rgb, const double eye[3][3], double out[static 3])
{
	static const double X[] = {0.4124, 0.3576, 0.1805},
			    Y[] = {0.2126, 0.7152, 0.0722},
			    Z[] = {0.0193, 0.1192, 0.9505};
	double in[3], seen[3];
	linear(rgb, in);
	for (int i = 0; i < 3; i++)
		seen[i] = fmin(1, fmax(0, dot(eye[i], in)));
	double x = bent(dot(X, seen) / 0.95047), y = bent(dot(Y, seen));
	double z = bent(dot(Z, seen) / 1.08883);
	out[0] = 116 * y - 16;
	out[1] = 500 * (x - y);
	out[2] = 200 * (y - z);
}

static double
distance(unsigned a, unsigned b, const double eye[3][3])
{
	double p[3], q[3];
	lab(a, eye, p);
	lab(b, eye, q);
	return hypot(hypot(p[0] - q[0], p[1] - q[1]), p[2] - q[2]);
}

static double
contrast(unsigned a, unsigned b)
{
	static const double Y[] = {0.2126, 0.7152, 0.0722};
	double p[3], q[3];
	linear(a, p);
	linear(b, q);
	double light = dot(Y, p) + 0.05, dark = dot(Y, q) + 0.05;
	return fmax(light, dark) / fmin(light, dark);
}

static const enum series LINES[] = {SERIES_FEED, SERIES_MEASURED_1,
    SERIES_MEASURED_2, SERIES_MEASURED_3, SERIES_MEASURED_4, SERIES_KIND_1,
    SERIES_KIND_2, SERIES_KIND_3, SERIES_KIND_4, SERIES_PREDICTED, SERIES_OTHER,
    SERIES_BREAK};
enum { LINES_N = sizeof LINES / sizeof LINES[0] };

static unsigned
rgb_of(size_t i, enum theme theme)
{
	return palette_colour_to_rgb(
	    palette_colour_of_series(LINES[i], 256, theme));
}

static void
the_distance_is_that_of_the_books(void **state)
{
	(void)state;
	/* Black to white is 100; red and green meet without red receptors. */
	assert_true(fabs(distance(0, 0xFFFFFF, EYES[0]) - 100) < 0.1);
	assert_true(fabs(contrast(0, 0xFFFFFF) - 21) < 0.1);
	assert_true(distance(0xA04040, 0x5F5F40, EYES[0]) > 40);
	assert_true(distance(0xA04040, 0x5F5F40, EYES[1]) < 12);
}

static void
colours_are_told_apart_by_any_eye(void **state)
{
	(void)state;
	for (int theme = 0; theme < THEMES; theme++)
		for (size_t eye = 0; eye < EYES_N; eye++)
			for (size_t i = 0; i < LINES_N; i++)
				for (size_t j = 0; j < i; j++)
					assert_true(
					    distance(
						rgb_of(i, (enum theme)theme),
						rgb_of(j, (enum theme)theme),
						EYES[eye]) > APART);
}

static void
colours_stand_out_from_their_ground(void **state)
{
	(void)state;
	for (size_t i = 0; i < LINES_N; i++) {
		unsigned any = rgb_of(i, THEME_NORMAL);
		assert_true(contrast(any, DARK) > ANY_GROUND);
		assert_true(contrast(any, LIGHT) > ANY_GROUND);
		/* Most terminals are black; these are read on page Predict. */
		if (LINES[i] < SERIES_KIND_1 || LINES[i] > SERIES_KIND_4)
			assert_true(contrast(any, 0) > ON_BLACK);
		assert_true(contrast(rgb_of(i, THEME_DARK), DARK) > HIGH);
		assert_true(contrast(rgb_of(i, THEME_LIGHT), LIGHT) > HIGH);
	}
}

/* A picture has the very colours of the screen. */
static void
paper_and_screen_have_the_same_colours(void **state)
{
	(void)state;
	for (size_t i = 0; i < LINES_N; i++)
		assert_int_equal(
		    palette_series_rgb_on_white(LINES[i], THEME_NORMAL),
		    rgb_of(i, THEME_NORMAL));
	assert_int_equal(palette_colour_to_rgb(231), 0xFFFFFF);
	assert_int_equal(palette_colour_to_rgb(243), 0x767676);
	assert_int_equal(palette_colour_to_rgb(202), 0xFF5F00);
	assert_int_equal(
	    palette_series_rgb_on_white(SERIES_TEXT, THEME_DARK), 0);
}

/* With few colours those of the text's are told by their shape. */
static void
few_colours_are_not_used_twice(void **state)
{
	(void)state;
	for (int k = 0; k < 2 * THEMES; k++)
		for (size_t i = 0; i < LINES_N; i++)
			for (size_t j = 0; j < i; j++) {
				int depth = k % 2 == 0 ? 8 : 16;
				enum theme theme = (enum theme)(k / 2);
				int a = palette_colour_of_series(
				    LINES[i], depth, theme);
				assert_true(a == -1 ||
					    a != palette_colour_of_series(
						     LINES[j], depth, theme));
				assert_int_not_equal(a, 8);
			}
	assert_int_equal(
	    palette_colour_of_series(SERIES_PREDICTED, 0, THEME_NORMAL), -1);
}

/* Yellow and bright colours are not read on white. */
static void
few_colours_on_white_are_dark(void **state)
{
	(void)state;
	for (int depth = 8; depth <= 16; depth += 8)
		for (int i = 0; i < SERIES_COUNT; i++) {
			int a = palette_colour_of_series(
			    (enum series)i, depth, THEME_LIGHT);
			assert_true(a == -1 ||
				    contrast(palette_colour_to_rgb(a), LIGHT) >
					ANY_GROUND);
		}
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(the_distance_is_that_of_the_books),
	    cmocka_unit_test(colours_are_told_apart_by_any_eye),
	    cmocka_unit_test(colours_stand_out_from_their_ground),
	    cmocka_unit_test(paper_and_screen_have_the_same_colours),
	    cmocka_unit_test(few_colours_are_not_used_twice),
	    cmocka_unit_test(few_colours_on_white_are_dark),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}

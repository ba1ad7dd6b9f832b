/* Cells as a picture: what is text, what is shape, where they stand.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <locale.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "plot/picture.h"

/* The SVG of a canvas, which is freed; the caller frees the text. */
static char *
drawn(struct canvas *canvas, int depth)
{
	char *text = NULL;
	size_t n = 0;
	FILE *out = open_memstream(&text, &n);
	assert_true(picture_write_screen(
	    canvas, depth, PICTURE_SVG, "a <title>", "about & so on", out));
	fclose(out);
	canvas_free(canvas);
	return text;
}

static size_t
count(const char *text, const char *what)
{
	size_t n = 0;
	for (; (text = strstr(text, what)) != NULL; text++)
		n++;
	return n;
}

static void
a_run_of_text_is_as_long_as_its_cells(void **state)
{
	(void)state;
	struct canvas *c = canvas_new(30, 2);
	canvas_draw_text(c, 1, 0, "two words  apart", SERIES_TEXT, 0);
	canvas_draw_text(c, 0, 1, "\u5c71<", SERIES_TEXT, 0);
	char *svg = drawn(c, 0);
	assert_int_equal(count(svg, "<text "), 3);
	assert_non_null(strstr(svg, "textLength=\"54\">two words<"));
	assert_non_null(strstr(svg, "textLength=\"30\">apart<"));
	assert_non_null(strstr(svg, "textLength=\"18\">\u5c71&lt;<"));
	assert_non_null(strstr(svg, "<title>a &lt;title&gt;</title>"));
	assert_non_null(strstr(svg, "<desc>about &amp; so on</desc>"));
	free(svg);
}

static void
every_dot_of_braille_is_drawn(void **state)
{
	(void)state;
	struct canvas *c = canvas_new(3, 1);
	canvas_draw_text(c, 0, 0, "\u28ff\u2801\u2800", SERIES_FEED, 0);
	char *svg = drawn(c, 256);
	assert_int_equal(count(svg, "<text "), 0);
	assert_int_equal(count(svg, "h0"), 9);
	assert_int_equal(count(svg, "stroke=\"#767676\""), 1);
	free(svg);
}

static void
quarters_fill_their_part(void **state)
{
	(void)state;
	/* A full cell, then its lower right quarter. */
	struct canvas *c = canvas_new(2, 1);
	canvas_draw_text(c, 0, 0, "\u2588\u2597", SERIES_FEED, 0);
	char *svg = drawn(c, 0);
	assert_non_null(strstr(svg, "stroke-width=\"6\""));
	assert_non_null(strstr(svg, "\"M8 11h6M8 17h6M17 17h3\""));
	free(svg);
}

static void
lines_join_and_corners_are_square(void **state)
{
	(void)state;
	struct canvas *c = canvas_new(4, 2);
	canvas_draw_text(c, 0, 0, "\u2502", SERIES_TEXT, 0);
	canvas_draw_text(c, 0, 1, "\u2514\u2500\u2500\u2500", SERIES_TEXT, 0);
	char *svg = drawn(c, 0);
	assert_non_null(strstr(svg, "\"M11 8L11 20M11 20L11 26M11 26h21\""));
	free(svg);
}

static void
reverse_has_a_ground(void **state)
{
	(void)state;
	struct canvas *c = canvas_new(3, 1);
	canvas_draw_text(c, 0, 0, " a ", SERIES_TEXT, CELL_REVERSE | CELL_BOLD);
	char *svg = drawn(c, 0);
	assert_non_null(strstr(svg, "stroke-width=\"12\" d=\"M8 14h18\""));
	assert_non_null(strstr(svg, "fill=\"#161b22\" textLength=\"6\""));
	assert_int_equal(count(svg, "font-weight=\"bold\""), 1);
	free(svg);
}

static void
dim_is_faint_where_terminals_have_it(void **state)
{
	(void)state;
	for (int depth = 0; depth <= 256; depth += 256) {
		struct canvas *c = canvas_new(2, 1);
		canvas_draw_text(c, 0, 0, "a\u2500", SERIES_TEXT, CELL_DIM);
		char *svg = drawn(c, depth);
		assert_int_equal(count(svg, "-opacity="), depth > 0 ? 2 : 0);
		free(svg);
	}
}

int
main(void)
{
	setlocale(LC_CTYPE, "C.UTF-8");
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(a_run_of_text_is_as_long_as_its_cells),
	    cmocka_unit_test(every_dot_of_braille_is_drawn),
	    cmocka_unit_test(quarters_fill_their_part),
	    cmocka_unit_test(lines_join_and_corners_are_square),
	    cmocka_unit_test(reverse_has_a_ground),
	    cmocka_unit_test(dim_is_faint_where_terminals_have_it),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}

/* The grid of cells: text, widths, escape sequences.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <locale.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "plot/canvas.h"

/* What is printed; the caller frees. */
static char *
printed(const struct canvas *canvas, int depth)
{
	char *text = NULL;
	size_t n = 0;
	FILE *out = open_memstream(&text, &n);
	canvas_print(canvas, depth, out);
	fclose(out);
	return text;
}

static void
expect(const struct canvas *canvas, int depth, const char *want)
{
	char *text = printed(canvas, depth);
	assert_string_equal(text, want);
	free(text);
}

static void
text_is_cut_at_every_edge(void **state)
{
	(void)state;
	struct canvas *c = canvas_new(5, 2);
	canvas_draw_text(c, 3, 0, "abc", SERIES_TEXT, 0);
	canvas_draw_text(c, -1, 1, "xyz", SERIES_TEXT, 0);
	canvas_draw_text(c, 0, 2, "below", SERIES_TEXT, 0);
	canvas_draw_text(c, 0, -1, "above", SERIES_TEXT, 0);
	expect(c, 0, "   ab\nyz\n");
	canvas_free(c);
}

static void
every_length_of_utf8_comes_back(void **state)
{
	(void)state;
	struct canvas *c = canvas_new(6, 1);
	canvas_draw_text(c, 0, 0, "aö\u2588\U0001D465", SERIES_TEXT, 0);
	assert_int_equal(canvas_cell_at(c, 1, 0)->code, 0xF6);
	assert_int_equal(canvas_cell_at(c, 2, 0)->code, 0x2588);
	expect(c, 0, "aö\u2588\U0001D465\n");
	canvas_free(c);
}

static void
broken_utf8_and_controls_harm_nothing(void **state)
{
	(void)state;
	struct canvas *c = canvas_new(22, 1);
	canvas_draw_text(c, 0, 0, "a\xFF\xE2\x82\nb\u202E", SERIES_TEXT, 0);
	expect(c, 0, "a\\xff\\xe2\\x82\\x0ab\\u20\n");
	canvas_free(c);
}

static void
wide_characters_take_two_cells_or_none(void **state)
{
	(void)state;
	if (setlocale(LC_CTYPE, "C.UTF-8") == NULL)
		skip();
	struct canvas *c = canvas_new(4, 1);
	canvas_draw_text(c, 0, 0, "a\u77F3b\u77F3", SERIES_TEXT, 0);
	assert_int_equal(canvas_cell_at(c, 2, 0)->code, 0);
	expect(c, 0, "a\u77F3b\n");
	canvas_free(c);
}

static void
no_depth_no_escapes(void **state)
{
	(void)state;
	struct canvas *c = canvas_new(9, 1);
	canvas_draw_text(c, 0, 0, "feed", SERIES_FEED, CELL_BOLD);
	canvas_draw_text(c, 5, 0, "text", SERIES_TEXT, 0);
	expect(c, 0, "feed text\n");
	expect(c, 8, "\033[0;1mfeed\033[0m text\n");
	expect(c, 256, "\033[0;1;38;5;243mfeed\033[0m text\n");
	canvas_draw_text(c, 0, 0, "pred", SERIES_PREDICTED, 0);
	expect(c, 16, "\033[0;91mpred\033[0m text\n");
	canvas_draw_text(c, 0, 0, "meas", SERIES_MEASURED_1, CELL_DIM);
	expect(c, 8, "\033[0;1;34mmeas\033[0m text\n");
	expect(c, 16, "\033[0;94mmeas\033[0m text\n");
	expect(c, 256, "\033[0;2;38;5;32mmeas\033[0m text\n");
	c->theme = THEME_DARK; /* nothing is faint */
	expect(c, 256, "\033[0;38;5;111mmeas\033[0m text\n");
	canvas_free(c);
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(text_is_cut_at_every_edge),
	    cmocka_unit_test(every_length_of_utf8_comes_back),
	    cmocka_unit_test(broken_utf8_and_controls_harm_nothing),
	    cmocka_unit_test(wide_characters_take_two_cells_or_none),
	    cmocka_unit_test(no_depth_no_escapes),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}

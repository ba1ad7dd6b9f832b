/* What of somebody else's text a terminal is given.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <setjmp.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "base/text.h"
#include "base/xalloc.h"

static void
what_a_terminal_acts_on_is_shown(void **state)
{
	(void)state;
	static const char *const SHOWN[][2] = {{"Össjö, 11.2 mm", NULL},
	    {"\\x1b", NULL}, {"\u77F3\u5C71 \U0001D465", NULL},
	    {"\u0645\u06CC\u200C\u0634\u0648\u062F", NULL}, {"\uFFFD", NULL},
	    {"\x1B[31m", "\\x1b[31m"},
	    {"a\tb\nc\r\x7F", "a\\x09b\\x0ac\\x0d\\x7f"},
	    {"\xC2\x9B"
	     "31m",
		"\\u009b31m"},
	    {"\x9B\xFF", "\\x9b\\xff"},
	    {"\u202Ecba\u202C", "\\u202ecba\\u202c"},
	    {"\u2066\u200F\u061C\u2028\u2029\u200B\uFEFF",
		"\\u2066\\u200f\\u061c\\u2028\\u2029\\u200b\\ufeff"},
	    {"\xEF\xBF\xBE\xEF\xBF\xBF", "\\ufffe\\uffff"},
	    {"\U000E0041", "\\U000e0041"}, {"\xED\xA0\x80", "\\xed\\xa0\\x80"}};
	for (size_t i = 0; i < ARRAY_LEN(SHOWN); i++) {
		const char *wanted =
		    SHOWN[i][1] != NULL ? SHOWN[i][1] : SHOWN[i][0];
		char *shown = text_with_control_escaped(SHOWN[i][0]),
		     *put = NULL;
		size_t n = 0;
		FILE *out = text_open_memory(&put, &n);
		text_print_escaped(SHOWN[i][0], out);
		fclose(out);
		assert_string_equal(shown, wanted);
		assert_string_equal(put, wanted);
		assert_int_equal(text_width_in_columns(SHOWN[i][0]),
		    text_width_in_columns(wanted));
		free(shown);
		free(put);
	}
}

/* Of any bytes: valid UTF-8 that XML may hold, and the same shown twice. */
static void
any_bytes_are_shown_as_text(void **state)
{
	(void)state;
	uint32_t seed = 1;
	for (int round = 0; round < 20000; round++) {
		char bytes[9] = "";
		for (size_t i = 0; i < 8; i++) {
			seed = seed * 1664525 + 1013904223;
			bytes[i] = (char)(seed >> 24);
		}
		char *once = text_with_control_escaped(bytes),
		     *twice = text_with_control_escaped(once);
		assert_true(text_is_utf8(once, strlen(once)));
		assert_string_equal(once, twice);
		for (const char *p = once; *p != '\0';) {
			uint32_t code = text_next_code_point(&p);
			assert_true(code >= 0x20 && code != 0x7F &&
				    !(code >= 0x80 && code < 0xA0) &&
				    !(code >= 0x202A && code <= 0x202E) &&
				    code != 0xFFFE && code != 0xFFFF);
		}
		free(once);
		free(twice);
	}
}

static void
keys_hold_nothing_a_terminal_acts_on(void **state)
{
	(void)state;
	char *slug = text_slug("Q\xC2\x9B\u061C\uFEFF\xFF\U000E0041Össjö");
	assert_string_equal(slug, "q-ossjo");
	free(slug);
}

/* What is written behind an apostrophe is read without it. */
static void
formulas_are_told_from_numbers_and_words(void **state)
{
	(void)state;
	static const char *const FORMULAS[] = {"=1", "+A1", "-x", "@SUM(1)",
	    "\t=1", "\r=1", "--", "'=1", "''@", "'-5", "-5 mm", "-1,06"};
	static const char *const OTHERS[] = {"", "-", "-1.06", "+5", "-1e-3",
	    "a=b", "'", "'tis", "Össjö", " ", "#1", "5"};
	for (size_t i = 0; i < ARRAY_LEN(FORMULAS); i++)
		assert_true(text_may_be_formula(FORMULAS[i]));
	for (size_t i = 0; i < ARRAY_LEN(OTHERS); i++)
		assert_false(text_may_be_formula(OTHERS[i]));
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(what_a_terminal_acts_on_is_shown),
	    cmocka_unit_test(any_bytes_are_shown_as_text),
	    cmocka_unit_test(keys_hold_nothing_a_terminal_acts_on),
	    cmocka_unit_test(formulas_are_told_from_numbers_and_words),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}

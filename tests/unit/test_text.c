/* Text: numbers, names, widths and digests, the same in every locale; and the
 * list of errors.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#define _GNU_SOURCE /* fopencookie */
#include <locale.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "base/error.h"
#include "base/text.h"
#include "base/xalloc.h"
#include "core/numeric/rng.h"

/* Of these the ones that are installed; the program sets LC_CTYPE only. */
static const char *const LOCALES[] = {"C", "C.UTF-8", "sv_SE.UTF-8",
    "sv_SE.ISO-8859-1", "tr_TR.UTF-8", "tr_TR.ISO-8859-9"};

static void
in_each_locale(void (*check)(void))
{
	for (size_t i = 0; i < ARRAY_LEN(LOCALES); i++)
		if (setlocale(LC_CTYPE, LOCALES[i]) != NULL)
			check();
	setlocale(LC_CTYPE, "C");
}

static const struct {
	const char *text;
	double value; /* NAN: no number */
} NUMBERS[] = {{"11.2", 11.2}, {"1e-3", 1e-3}, {" 74\t", 74}, {"-0.5", -0.5},
    {"+5", 5}, {".5", 0.5}, {"5.", 5}, {"1E3", 1000}, {"007", 7},
    {"1e308", 1e308}, {"0.1", 0.1}, {"11,2", NAN}, {"", NAN}, {" ", NAN},
    {"1 2", NAN}, {"1e", NAN}, {"e5", NAN}, {".", NAN}, {"--1", NAN},
    {"1.2.3", NAN}, {"0x10", NAN}, {"inf", NAN}, {"nan", NAN}, {"1e400", NAN},
    {"-1e400", NAN}, {"12a", NAN}, {"1'000", NAN},
    {"\xC2\xA0"
     "1",
	NAN}};

static void
check_numbers(void)
{
	for (size_t i = 0; i < ARRAY_LEN(NUMBERS); i++) {
		double v = -7;
		bool is = text_parse_number(NUMBERS[i].text, &v);
		if (is != !isnan(NUMBERS[i].value))
			fail_msg("'%s' %s read", NUMBERS[i].text,
			    is ? "was" : "was not");
		if (is && v != NUMBERS[i].value)
			fail_msg("'%s' read as %.17g", NUMBERS[i].text, v);
	}
}

static void
numbers_have_a_point_in_every_locale(void **state)
{
	(void)state;
	in_each_locale(check_numbers);
}

static void
check_letters(void)
{
	assert_true(text_is_same_but_case("FINES", "fines", SIZE_MAX));
	assert_true(text_is_same_but_case("fines", "FIne", 4));
	assert_true(text_is_same_but_case("", "", 3));
	assert_false(text_is_same_but_case("fine", "fines", SIZE_MAX));
	assert_false(text_is_same_but_case("fines", "fine", 5));
	assert_false(text_is_same_but_case("\xC3\xA5", "\xC3\x85", 2));
}

static void
letters_are_those_of_ascii_in_every_locale(void **state)
{
	(void)state;
	in_each_locale(check_letters);
}

/* Gives 60 bytes, and then an error. */
static ssize_t
read_and_fail(void *left, char *to, size_t n)
{
	size_t *more = left;
	if (*more == 0)
		return -1;
	n = n < *more ? n : *more;
	memset(to, 'x', n);
	*more -= n;
	return (ssize_t)n;
}

static void
a_line_that_cannot_be_read_to_its_end_has_one(void **state)
{
	size_t left = 60, n = 0, room = 100;
	char *text = xcalloc(room, 1);
	(void)state;
	memset(text, 'y', room);
	FILE *in = fopencookie(
	    &left, "r", (cookie_io_functions_t){.read = read_and_fail});
	assert_int_equal(text_read_line(&text, &n, &room, in), TEXT_END);
	assert_int_equal(n, 60);
	assert_int_equal(text[60], '\0');
	fclose(in);
	free(text);
}

static void
whole_numbers_go_to_2_to_the_64(void **state)
{
	(void)state;
	static const struct {
		const char *text;
		bool is;
		uint64_t value;
	} whole[] = {{"0", true, 0}, {"42", true, 42}, {"007", true, 7},
	    {"18446744073709551615", true, UINT64_MAX},
	    {"18446744073709551616", false, 0}, {"-1", false, 0},
	    {"+1", false, 0}, {"1.0", false, 0}, {"1e3", false, 0},
	    {"", false, 0}, {" 1", false, 0}, {"1 ", false, 0},
	    {"0x10", false, 0}};
	for (size_t i = 0; i < ARRAY_LEN(whole); i++) {
		uint64_t v = 99;
		if (text_parse_whole_number(whole[i].text, &v) != whole[i].is)
			fail_msg("'%s'", whole[i].text);
		assert_true(!whole[i].is || v == whole[i].value);
	}
}

static void
check_round_trip(void)
{
	struct rng_key key = rng_make_key(1, 2, 3);
	char buf[32];
	for (uint32_t i = 0; i < 4000; i++) {
		uint64_t bits = (uint64_t)rng_random_bits(key, 2 * i) << 32 |
				rng_random_bits(key, 2 * i + 1);
		double value, back;
		memcpy(&value, &bits, sizeof value);
		if (!isfinite(value))
			continue;
		assert_true(text_parse_number(
		    text_shortest_exact_number(value, buf), &back));
		if (memcmp(&value, &back, sizeof value) != 0)
			fail_msg("%.17g became %s", value, buf);
	}
}

static void
any_double_comes_back_to_the_bit(void **state)
{
	(void)state;
	in_each_locale(check_round_trip);
}

static void
exact_is_as_short_as_can_be(void **state)
{
	(void)state;
	static const struct {
		double value;
		const char *text;
	} exact[] = {{0, "0"}, {-0.0, "-0"}, {0.1, "0.1"}, {11.2, "11.2"},
	    {74, "74"}, {1e-9, "1e-09"}, {1234567, "1234567"},
	    {1.0 / 3, "0.3333333333333333"}, {0.1 + 0.2, "0.30000000000000004"},
	    {80.123456789012, "80.123456789012"}};
	char buf[32];
	for (size_t i = 0; i < ARRAY_LEN(exact); i++)
		assert_string_equal(
		    text_shortest_exact_number(exact[i].value, buf),
		    exact[i].text);
}

/* What was typed stays; what was worked out has no more digits than it takes to
 * see that it is not the other. */
static void
a_number_apart_from_another(void **state)
{
	(void)state;
	static const struct {
		double value, other;
		const char *text;
	} pairs[] = {{96.702355913035, 100, "96.7"}, {62, 71, "62"},
	    {62.125, 71, "62.125"}, {99.99968, 100, "99.99968"},
	    {99.999683217, 100, "99.9997"},
	    {62.123456789, 62.123456, "62.1234568"}, {100, 99.5, "100"},
	    {0.353553391, 0.5, "0.3536"}, {-3.0000000001, 5, "-3"},
	    {1e-6, 0, "1e-06"}, {1.0 / 3, 1.0 / 3, "0.3333333333333333"}};
	char buf[32];
	for (size_t i = 0; i < ARRAY_LEN(pairs); i++)
		assert_string_equal(text_number_distinct_from(
					pairs[i].value, pairs[i].other, buf),
		    pairs[i].text);
}

static const struct {
	const char *name, *folded, *slug;
} NAMES[] = {{"Borlänge", "borlange", "borlange"}, {"Össjö", "ossjo", "ossjo"},
    {"Gåsgruvan", "gasgruvan", "gasgruvan"}, {"UMEÅ", "umea", "umea"},
    {"Kållered  2", "kallered  2", "kallered-2"},
    {"Gävle 11.2", "gavle 11.2", "gavle-11.2"},
    {" Ærø / æÐ! ", " aro / ad! ", "aro-ad"}, {"ÿÝçñß", "yycns", "yycns"},
    {"3×4÷2", "3×4÷2", "3-4-2"}, {"TITLE I", "title i", "title-i"},
    {"łódź", "lodz", "lodz"}, {"ПРОХОД", "проход", "проход"},
    {"Borla\xCC\x88nge", "borlange", "borlange"},
    {"採石場 2", "採石場 2", "採石場-2"}, {"a–b·c", "a–b·c", "a-b-c"},
    {"採\xE3\x80\x80場", "採\xE3\x80\x80場", "採-場"}, {"", "", ""},
    {"--", "--", ""},
    {"Hallbrook_grams2", "hallbrook_grams2", "hallbrook_grams2"},
    {"a _b", "a _b", "a-_b"}, {"→", "→", ""}};

static void
check_names(void)
{
	for (size_t i = 0; i < ARRAY_LEN(NAMES); i++) {
		char *folded = text_fold_case_and_accents(NAMES[i].name);
		char *slug = text_slug(NAMES[i].name);
		assert_string_equal(folded, NAMES[i].folded);
		assert_string_equal(slug, NAMES[i].slug);
		assert_true(text_is_same_folded(NAMES[i].name, folded));
		free(folded);
		free(slug);
	}
	assert_false(text_is_same_folded("Umeå", "Ume"));
	assert_true(text_contains_folded("Kvarnby, Malmö", "MALMO"));
	assert_false(text_contains_folded("Malmö", "Malmoe"));
	assert_false(text_is_same_folded("Bro", "Bru"));
}

static void
names_lose_case_and_accents_in_every_locale(void **state)
{
	(void)state;
	in_each_locale(check_names);
}

static void
check_trim(void)
{
	static const char *const words[][2] = {{"  a b \t\n", "a b"}, {"", ""},
	    {" \t ", ""}, {"Å", "Å"}, {" Å ", "Å"}, {"Ä Å", "Ä Å"},
	    {" à", "à"}};
	for (size_t i = 0; i < ARRAY_LEN(words); i++) {
		char *copy = xstrdup(words[i][0]);
		assert_string_equal(text_trim(copy), words[i][1]);
		free(copy);
	}
}

static void
trimming_takes_blanks_and_no_letters(void **state)
{
	(void)state;
	in_each_locale(check_trim);
}

static void
quotes_come_and_go(void **state)
{
	static const char *const PAIRS[][2] = {{"", "\"\""},
	    {"pit 4", "\"pit 4\""}, {"4\" rock", "\"4\"\" rock\""},
	    {"\"", "\"\"\"\""}};
	(void)state;
	for (size_t i = 0; i < ARRAY_LEN(PAIRS); i++) {
		char *quoted = text_add_quotes(PAIRS[i][0]);
		char *back = text_without_quotes(quoted, strlen(quoted));
		assert_string_equal(quoted, PAIRS[i][1]);
		assert_string_equal(back, PAIRS[i][0]);
		free(quoted);
		free(back);
	}
}

static void
distance_counts_edits(void **state)
{
	(void)state;
	static const struct {
		const char *a, *b;
		size_t edits;
	} pairs[] = {{"", "", 0}, {"predict", "predict", 0}, {"", "abc", 3},
	    {"predict", "predcit", 1}, {"predict", "predit", 1},
	    {"predict", "prediict", 1}, {"predict", "pradict", 1},
	    {"ab", "ba", 1}, {"kitten", "sitting", 3}, {"use", "load", 4}};
	for (size_t i = 0; i < ARRAY_LEN(pairs); i++) {
		size_t there = text_edit_distance(pairs[i].a, pairs[i].b);
		assert_int_equal(there, pairs[i].edits);
		assert_int_equal(
		    text_edit_distance(pairs[i].b, pairs[i].a), there);
	}
}

static void
a_long_word_is_no_edits_from_itself(void **state)
{
	(void)state;
	const char *word = "a-word-that-is-longer-than-any-command-of-this";
	assert_int_equal(text_edit_distance(word, word), 0);
}

static void
width_counts_characters(void **state)
{
	(void)state;
	static const struct {
		const char *text;
		int width;
	} width[] = {{"", 0}, {"mm", 2}, {"Borlänge", 8}, {"β1 · α", 6},
	    {"\xF0\x9F\xAA\xA8", 1}, {"a\xFFz", 6}, {"\xC3", 4},
	    {"\xE2\x82", 8}, {"\x1B[m", 6}, {"\u202Etip", 9}};
	for (size_t i = 0; i < ARRAY_LEN(width); i++)
		assert_int_equal(
		    text_width_in_columns(width[i].text), width[i].width);
}

/* As the canvas sets them: tables and prompts would not line up else. */
static void
width_is_that_of_the_terminal(void **state)
{
	(void)state;
	if (setlocale(LC_CTYPE, "C.UTF-8") == NULL)
		skip();
	assert_int_equal(text_width_in_columns("\u77F3\u5C71"), 4);
	assert_int_equal(text_width_in_columns("Ga\u0308vle"), 5);
	setlocale(LC_CTYPE, "C");
}

static void
characters_are_read_one_by_one(void **state)
{
	(void)state;
	static const uint32_t WANTED[] = {
	    'a', 0xE5, 0x20AC, 0x1D465, 0xFFFD, 0xFFFD, 'z'};
	const char *p = "aå\u20AC\U0001D465\xE2\x82z";
	for (size_t i = 0; i < ARRAY_LEN(WANTED); i++)
		assert_int_equal(text_next_code_point(&p), WANTED[i]);
	assert_int_equal(*p, '\0');
}

static const struct {
	const char *text;
	size_t n;
	bool is;
} BYTES[] = {{"", 0, true}, {"plain", 5, true}, {"\xC3\xA5", 2, true},
    {"\xE2\x82\xAC", 3, true}, {"\xED\x9F\xBF", 3, true},
    {"\xEE\x80\x80", 3, true}, {"\xF0\x90\x80\x80", 4, true},
    {"\xF4\x8F\xBF\xBF", 4, true}, {"\xC3", 1, false}, {"\xC3\x28", 2, false},
    {"\xA5", 1, false}, {"\xE2\x82", 2, false}, {"\xF0\x9F\x98", 3, false},
    {"\xC0\xAF", 2, false}, {"\xC1\xBF", 2, false},
    {"\xF5\x80\x80\x80", 4, false}, {"\xFF", 1, false}, {"a\0b", 3, false},
    {"\xE5ngstr\xF6m", 8, false}};

static void
bytes_that_are_no_utf_8_are_found(void **state)
{
	(void)state;
	for (size_t i = 0; i < ARRAY_LEN(BYTES); i++)
		if (text_is_utf8(BYTES[i].text, BYTES[i].n) != BYTES[i].is)
			fail_msg("row %zu", i);
}

/* Unicode Standard, table 3-7: these are not well-formed. */
static void
overlong_and_surrogate_forms_are_no_utf_8(void **state)
{
	(void)state;
	assert_false(text_is_utf8("\xE0\x80\xAF", 3));
	assert_false(text_is_utf8("\xE0\x9F\xBF", 3));
	assert_false(text_is_utf8("\xED\xA0\x80", 3));
	assert_false(text_is_utf8("\xF0\x80\x80\xAF", 4));
	assert_false(text_is_utf8("\xF4\x90\x80\x80", 4));
}

static void
text_wraps_between_words(void **state)
{
	(void)state;
	char *text = NULL;
	size_t n = 0;
	FILE *out = open_memstream(&text, &n);
	text_print_wrapped("Åäö åäö one two", 2, 9, out);
	text_print_wrapped("  in a-word-too-long", 1, 9, out);
	fclose(out);
	assert_string_equal(
	    text, "  Åäö åäö\n  one two\n   in\n   a-word-too-long\n");
	free(text);
}

static void
digest_is_fnv_1a(void **state)
{
	(void)state;
	uint64_t h = TEXT_DIGEST_START;
	assert_true(text_fnv1a_digest(h, "", 0) == h);
	assert_true(
	    text_fnv1a_digest(h, "a", 1) == UINT64_C(0xaf63dc4c8601ec8c));
	assert_true(
	    text_fnv1a_digest(h, "foobar", 6) == UINT64_C(0x85944171f73967e8));
	assert_true(text_fnv1a_digest(text_fnv1a_digest(h, "foo", 3), "bar",
			3) == UINT64_C(0x85944171f73967e8));
}

static void
a_full_error_list_counts_the_rest(void **state)
{
	(void)state;
	struct error_list list = {0};
	size_t room = ARRAY_LEN(list.item);
	for (size_t i = 0; i < room + 7; i++) {
		struct error *e = error_list_add_item(&list);
		assert_non_null(e);
		error_set_at(
		    e, ERROR_DATA, "x.csv", (int)i + 1, 2, "fault %zu", i);
		error_set_hint(e, "mend %zu", i);
	}
	assert_int_equal(list.n, room);
	assert_int_equal(list.more, 7);
	for (size_t i = 0; i < room; i++)
		assert_int_equal(list.item[i].line, i + 1);
	assert_string_equal(list.item[room - 1].hint, "mend 19");
}

static char *
printed(const struct error *e)
{
	char *text = NULL;
	size_t n = 0;
	FILE *out = open_memstream(&text, &n);
	error_print(e, out);
	fclose(out);
	return text;
}

static void
errors_print_their_place_and_hint(void **state)
{
	(void)state;
	struct error e = {0};
	assert_false(
	    error_set_at(&e, ERROR_DATA, "a.csv", 14, 9, "wanted %d", 1));
	assert_false(error_set_hint(&e, "do %s", "this"));
	char *text = printed(&e);
	assert_string_equal(text, "a.csv:14:9: wanted 1\n  hint: do this\n");
	free(text);
	assert_false(error_set(&e, ERROR_USAGE, "none"));
	text = printed(&e);
	assert_string_equal(text, "tipspeed: none\n");
	free(text);
	assert_int_equal(e.kind, ERROR_USAGE);
	/* The lines are those of the format, not of what is put into it. */
	error_set(&e, ERROR_USAGE, "no %s\nload %s", "a\nb", "c");
	assert_string_equal(e.text, "no a\nb");
	assert_string_equal(e.hint, "load c");
	assert_false(error_set(NULL, ERROR_USAGE, "kept nowhere"));
	assert_false(error_set_hint(NULL, "kept nowhere"));
}

/* Whole words, of a word its beginning, of a number nothing. */
static void
what_does_not_fit_is_cut_between_words(void **state)
{
	(void)state;
	static const struct {
		const char *text;
		int columns;
		const char *fitted;
	} CASES[] = {{"fit good", 8, "fit good"}, {"fit good", 7, "fit .."},
	    {"fit good   ", 8, "fit good   "}, {"Granite", 6, "Gran.."},
	    {"Granite", 3, ""}, {"* vastra-gotaland", 12, "* vastra-g.."},
	    {"   99.45", 7, ""}, {"-0.25", 4, ""}, {"99.45 %", 6, ""},
	    {"P50 2.85 mm", 11, "P50 2.85 mm"}, {"P50 2.85 mm", 10, "P50 .."},
	    {"Ume\u00e5 \u00e5", 6, "Ume\u00e5 \u00e5"},
	    {"Ume\u00e5 \u00e5", 5, "Ume.."}, {"", 0, ""}, {"x", 0, ""},
	    {"* 74.25", 6, ""}, {"P20 1.10  P50 2.85", 15, "P20 1.10 .."},
	    {"ab\033[2J", 8, "ab\033.."}, {"ab\033[2J", 7, "ab.."}};
	for (size_t i = 0; i < ARRAY_LEN(CASES); i++) {
		char *fitted =
		    text_cut_to_width(CASES[i].text, CASES[i].columns);
		assert_string_equal(fitted, CASES[i].fitted);
		free(fitted);
	}
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(numbers_have_a_point_in_every_locale),
	    cmocka_unit_test(letters_are_those_of_ascii_in_every_locale),
	    cmocka_unit_test(a_line_that_cannot_be_read_to_its_end_has_one),
	    cmocka_unit_test(whole_numbers_go_to_2_to_the_64),
	    cmocka_unit_test(any_double_comes_back_to_the_bit),
	    cmocka_unit_test(exact_is_as_short_as_can_be),
	    cmocka_unit_test(a_number_apart_from_another),
	    cmocka_unit_test(names_lose_case_and_accents_in_every_locale),
	    cmocka_unit_test(trimming_takes_blanks_and_no_letters),
	    cmocka_unit_test(quotes_come_and_go),
	    cmocka_unit_test(distance_counts_edits),
	    cmocka_unit_test(a_long_word_is_no_edits_from_itself),
	    cmocka_unit_test(width_counts_characters),
	    cmocka_unit_test(width_is_that_of_the_terminal),
	    cmocka_unit_test(characters_are_read_one_by_one),
	    cmocka_unit_test(bytes_that_are_no_utf_8_are_found),
	    cmocka_unit_test(overlong_and_surrogate_forms_are_no_utf_8),
	    cmocka_unit_test(text_wraps_between_words),
	    cmocka_unit_test(digest_is_fnv_1a),
	    cmocka_unit_test(a_full_error_list_counts_the_rest),
	    cmocka_unit_test(errors_print_their_place_and_hint),
	    cmocka_unit_test(what_does_not_fit_is_cut_between_words),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}

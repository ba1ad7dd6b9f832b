/* Text comes out as people typed it, however it was coded.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/cells/encoding.h"
#include "sheets.h"

#include "io/cells/source.h"

static void
expect(const char *bytes, size_t n, enum encoding encoding, const char *text)
{
	struct decoded d = encoding_decode(bytes, n);
	assert_null(d.wrong);
	assert_int_equal(d.encoding, encoding);
	assert_string_equal(d.text, text);
	assert_int_equal(d.n, strlen(text));
	free(d.text);
}

static void
each_encoding_is_known(void **state)
{
	(void)state;
	expect("\xC3\xA5", 2, ENCODING_UTF8, "å");
	expect("\xEF\xBB\xBF\xC3\xA5", 5, ENCODING_UTF8, "å");
	expect("", 0, ENCODING_UTF8, "");
	expect("\xFF\xFE\xE5\0\x3C\xD8\x0D\xDF", 8, ENCODING_UTF16, "å🌍");
	expect("\xFE\xFF\0\xE5\xD8\x3C\xDF\x0D", 8, ENCODING_UTF16, "å🌍");
	expect("a\0\xE5\0", 4, ENCODING_UTF16, "aå");
	expect("\0a\0\xE5", 4, ENCODING_UTF16, "aå");
	expect("\xB5m \xE5 \x80 \x96 \x9F", 10, ENCODING_1252, "µm å € – Ÿ");
}

static void
what_no_encoding_has_is_told_with_its_place(void **state)
{
	(void)state;
	static const struct {
		const char *bytes;
		size_t n, bad;
	} wrong[] = {{"\xE5\x81", 2, 2}, {"\x8D", 1, 0}, {"\x8F", 1, 0},
	    {"\x90", 1, 0}, {"\x9D", 1, 0}, {"\xC3\xA5 \xE5", 4, 3},
	    {"\xFF\xFE\xE5\0\x3C\xD8", 6, 2}, {"\xFF\xFE\xE5\0\x3C", 5, 2},
	    {"\xFF\xFE\x0D\xDF", 4, 0}};
	for (size_t i = 0; i < ARRAY_LEN(wrong); i++) {
		struct decoded d = encoding_decode(wrong[i].bytes, wrong[i].n);
		assert_non_null(d.wrong);
		assert_int_equal(d.bad, wrong[i].bad);
		free(d.text);
	}
}

static void
letters_and_their_accents_are_one(void **state)
{
	(void)state;
	static const char *const pairs[][2] = {{"a\u030A", "å"},
	    {"O\u0308sjo\u0308", "Ösjö"}, {"\u212B", "Å"}, {"µ", "µ"},
	    {"plain", "plain"}, {"\u0301", "\u0301"}};
	for (size_t i = 0; i < ARRAY_LEN(pairs); i++) {
		char *composed = encoding_to_nfc(pairs[i][0]);
		assert_string_equal(composed, pairs[i][1]);
		free(composed);
	}
	/* Accents without end would take as long. */
	enum { N = 3000000 };
	char *many = xcalloc(2 * N + 2, 1);
	many[0] = 'a';
	for (size_t i = 0; i < N; i++)
		memcpy(
		    many + 1 + 2 * i, i % 2 == 0 ? "\xCC\x81" : "\xCC\xA3", 2);
	char *same = encoding_to_nfc(many);
	assert_string_equal(same, many);
	free(same);
	free(many);
}

static void
a_guess_is_noted(void **state)
{
	(void)state;
	static const struct {
		const char *text;
		bool noted;
	} texts[] = {{"rock,gr\xE5\n", true}, {"rock,grå\n", false},
	    {"rock,gra\n", false}};
	for (size_t i = 0; i < ARRAY_LEN(texts); i++) {
		struct error_list errors = {0};
		struct source source;
		const char *path =
		    put_sheet(texts[i].text, strlen(texts[i].text));
		assert_true(source_read_sheets(path, &errors, &source));
		assert_int_equal(source.note[0] != '\0', texts[i].noted);
		assert_true(!texts[i].noted ||
			    strstr(source.note, "Windows-1252") != NULL);
		source_free(&source);
	}
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(each_encoding_is_known),
	    cmocka_unit_test(what_no_encoding_has_is_told_with_its_place),
	    cmocka_unit_test(letters_and_their_accents_are_one),
	    cmocka_unit_test(a_guess_is_noted)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}

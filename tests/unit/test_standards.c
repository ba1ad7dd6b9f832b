/* The envelopes that come with the program are all there, have the fraction
 * they describe, and are found by what people call them.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/formats/standards.h"

#include <math.h>

#include "sheets.h"

static void
all_are_there_and_in_order(void **state)
{
	(void)state;
	struct standards *all = standards_read_built_in();
	size_t rows = 0;
	assert_int_equal(all->n, 25);
	assert_int_equal(all->n_limit, 24);
	for (size_t i = 0; i < all->n; i++) {
		const struct spec *s = all->spec[i];
		rows += s->n;
		assert_true(s->n > 0 && s->cut[1] > s->cut[0]);
		assert_non_null(strstr(s->source, "second-hand copy"));
		for (size_t k = 0; k < s->n; k++) {
			assert_true(s->least[k] <= s->most[k]);
			assert_true(k == 0 || s->size[k] < s->size[k - 1]);
			assert_true(k == 0 || s->most[k] <= s->most[k - 1]);
		}
	}
	assert_true(rows > 95);
	standards_free(all);
}

static void
a_name_in_brackets_goes_on_from_the_one_before(void **state)
{
	(void)state;
	struct standards *all = standards_read_built_in();
	struct error error = {0};
	const struct spec *base =
	    standards_find_envelope(all, "astm c33", &error);
	assert_non_null(base);
	assert_string_equal(base->name, "ASTM C33 fine aggregate");
	assert_int_equal(base->n, 7);
	assert_true(base->cut[0] == 0 && base->cut[1] == 0.00475);
	const struct spec *dust =
	    standards_find_envelope(all, "c33 abrasion", &error);
	assert_non_null(dust);
	assert_int_equal(dust->n, 8);
	assert_true(dust->size[7] == 0.075e-3 && dust->most[7] == 0.05);
	const struct spec *stone =
	    standards_find_envelope(all, "IS zone II crushed", &error);
	assert_non_null(stone);
	assert_int_equal(stone->n, 7);
	assert_true(stone->size[6] == 0.15e-3 && stone->most[6] == 0.2);
	standards_free(all);
}

static void
names_are_found_by_their_words(void **state)
{
	(void)state;
	static const struct {
		const char *words, *name;
	} FOUND[] = {{"IS 383 zone I", "IS 383:2016 zone I"},
	    {"zone ii", "IS 383:2016 zone II"}, {"bs 882 m", "BS 882:1992 M"},
	    {"EN 0/4", "EN 12620 GF85 0/4"}, {"gng", "EN 12620 GNG90 0/8"},
	    {"mortar", "BS 1200:1976 mortar sand"},
	    {"crushed gravel", "NO Hb 018 crushed gravel 0/32 road base"}};
	struct standards *all = standards_read_built_in();
	for (size_t i = 0; i < ARRAY_LEN(FOUND); i++) {
		struct error error = {0};
		const struct spec *s =
		    standards_find_envelope(all, FOUND[i].words, &error);
		if (s == NULL)
			fail_msg("%s: %s", FOUND[i].words, error.text);
		assert_string_equal(s->name, FOUND[i].name);
	}
	standards_free(all);
}

static void
what_is_none_or_several_says_so(void **state)
{
	(void)state;
	struct standards *all = standards_read_built_in();
	struct error error = {0};
	assert_null(standards_find_envelope(all, "BS 882", &error));
	assert_string_equal(error.text, "'BS 882' matches 5 envelopes");
	assert_non_null(strstr(error.hint, "BS 882:1992 M"));
	assert_null(standards_find_envelope(all, "zone", &error));
	assert_null(standards_find_envelope(all, "ASTM", &error));
	assert_string_equal(error.text, "'ASTM' matches 3 envelopes");
	assert_null(standards_find_envelope(all, "ASTM C34", &error));
	assert_non_null(
	    strstr(error.hint, "did you mean 'ASTM C33 fine aggregate'?"));
	standards_free(all);
}

static void
paths_are_no_names(void **state)
{
	(void)state;
	static const char *const PATHS[] = {
	    "plant.csv", "./plant", "/etc/plant", "../plant", "x.ods"};
	for (size_t i = 0; i < ARRAY_LEN(PATHS); i++)
		assert_true(standards_is_file_path(PATHS[i]));
	assert_false(standards_is_file_path("EN 12620 GF85 0/4"));
	assert_false(standards_is_file_path("ASTM C33"));
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(all_are_there_and_in_order),
	    cmocka_unit_test(a_name_in_brackets_goes_on_from_the_one_before),
	    cmocka_unit_test(names_are_found_by_their_words),
	    cmocka_unit_test(what_is_none_or_several_says_so),
	    cmocka_unit_test(paths_are_no_names),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}

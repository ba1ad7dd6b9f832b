/* Grading envelopes are read, or refused with the place of each fault.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/formats/spec.h"

#include <math.h>

#include "sheets.h"

static struct spec *
read_spec(const char *text, struct error_list *errors)
{
	*errors = (struct error_list){0};
	return spec_read_file(put_sheet(text, strlen(text)), errors);
}

static void
limits_and_their_gaps_are_read(void **state)
{
	(void)state;
	static const char *const same[] = {
	    "spec,A\nsource,\"b, "
	    "c\"\nsize_mm,min_pct,max_pct\n8,85,99\n4,,40\n",
	    "# x\nSpec;A\nsource;b, c\nnote;d\nsize_um;max_pct;min_pct\n"
	    "8000;99,0;85\n4000;40;-\n",
	    "spec,A\nsource,\"b, c\"\n# 3 to 5\nsize_mm,min_pct,max_pct\n"
	    "5/16 in,85,99\n#5,,40\n# end\n",
	    "spec,A\nsource,\"b, c\"\nSieve (mm),Max. passing %,Lower limit\n"
	    "8,99 %,85%\n4,40%,\n"};
	for (size_t i = 0; i < ARRAY_LEN(same); i++) {
		struct error_list errors;
		struct spec *spec = read_spec(same[i], &errors);
		assert_non_null(spec);
		assert_int_equal(errors.n, 0);
		assert_string_equal(spec->name, "A");
		assert_string_equal(spec->source, "b, c");
		assert_int_equal(spec->n, 2);
		assert_true(spec->size[0] == 0.008 && spec->size[1] == 0.004);
		assert_true(spec->least[0] == 0.85 && isnan(spec->least[1]));
		assert_true(spec->most[0] == 0.99 && spec->most[1] == 0.4);
		spec_free(spec);
	}
}

static void
limits_of_the_fines_alone_may_be_small(void **state)
{
	(void)state;
	struct error_list errors;
	struct spec *spec = read_spec(
	    "size_mm,min_pct,max_pct\n8,,\n4,,\n0.063,0,1\n", &errors);
	assert_non_null(spec);
	assert_true(spec->most[2] == 0.01);
	spec_free(spec);
	assert_null(
	    read_spec("size_mm,max_pct\n8,1\n4,0.85\n0.063,0.05\n", &errors));
}

static void
a_cut_says_which_fraction_it_is_for(void **state)
{
	(void)state;
	struct error_list errors;
	struct spec *spec =
	    read_spec("cut,0/4\nsize_mm,max_pct\n4,50\n", &errors);
	assert_non_null(spec);
	assert_true(spec->cut[0] == 0 && spec->cut[1] == 0.004);
	spec_free(spec);
	spec = read_spec("Fraction mm,0/4\nsize_mm,max_pct\n4,50\n", &errors);
	assert_non_null(spec);
	assert_true(spec->cut[1] == 0.004);
	spec_free(spec);
	spec = read_spec("size_mm,max_pct\n4,50\n", &errors);
	assert_non_null(spec);
	assert_true(spec->cut[0] == 0 && spec->cut[1] == 0);
	spec_free(spec);
	static const char *const wrong[] = {"4/0", "x", "0/4/8", "-1/4", "4/"};
	for (size_t i = 0; i < ARRAY_LEN(wrong); i++) {
		char *text =
		    xasprintf("cut,%s\nsize_mm,max_pct\n4,50\n", wrong[i]);
		assert_null(read_spec(text, &errors));
		assert_non_null(strstr(errors.item[0].text,
		    "expected a fraction in mm such as 0/4"));
		free(text);
	}
}

static void
a_spec_without_a_name_has_that_of_its_file(void **state)
{
	(void)state;
	struct error_list errors;
	struct spec *spec = read_spec("size_mm,max_pct\n4,50\n", &errors);
	assert_non_null(spec);
	assert_string_equal(spec->name, "here/tierp.csv");
	assert_string_equal(spec->source, "");
	assert_true(isnan(spec->least[0]));
	spec_free(spec);
}

static void
faults_have_their_place(void **state)
{
	(void)state;
	static const struct {
		const char *text;
		int line, column;
	} rows[] = {{"", 1, 1}, {"spec,A\n", 1, 1}, {"size_mm\n4\n", 1, 1},
	    {"size_mm,min_pct\n", 1, 1}, {"size_mm,feed\n4,1\n", 1, 9},
	    {"size_mm,max_pct,max_pct\n4,1,1\n", 1, 17},
	    {"size_mm,max_pct\n4,101\n", 2, 3},
	    {"size_mm,max_pct\n4,x\n", 2, 3},
	    {"size_mm,min_pct,max_pct\n4,9,8\n", 2, 1},
	    {"size_mm,max_pct\n4,50\n2,60\n", 3, 3},
	    {"size_mm,max_pct\n4,50\npan,0\n", 3, 1},

	    {"size_mm,max_pct\n4,50,1\n", 2, 6},
	    {"size_mm,min_pct,max_pct\n4,,\n2,-,\n", 1, 1},
	    {"size_mm,min_pct,max_pct\n4,0.9,1\n2,0.5,0.7\n1,,0.4\n", 1, 1},
	    {"size_mm,Min retained %\n4,1\n2,30\n", 1, 9},
	    {"size_mm,max_pct\n4,50\n2,30\n\nsize_mm,max_pct\n4,60\n2,40\n", 5,
		1},
	    {"size_mm,max_pct,,size_mm,max_pct\n4,50,,4,60\n2,30,,2,40\n", 1,
		18}};
	for (size_t i = 0; i < ARRAY_LEN(rows); i++) {
		struct error_list errors;
		assert_null(read_spec(rows[i].text, &errors));
		assert_true(errors.n >= 1);
		if (errors.item[0].line != rows[i].line ||
		    errors.item[0].column != rows[i].column)
			fail_msg("%s: %d:%d: %s", rows[i].text,
			    errors.item[0].line, errors.item[0].column,
			    errors.item[0].text);
		assert_int_equal(errors.item[0].kind, ERROR_DATA);
		assert_true(errors.item[0].hint[0] != '\0');
	}
}

static void
a_file_that_is_not_there_is_the_systems(void **state)
{
	(void)state;
	struct error_list errors = {0};
	assert_null(spec_read_file("/nonexistent/spec.csv", &errors));
	assert_int_equal(errors.item[0].kind, ERROR_SYSTEM);
}

/* No text makes the reader crash. */
static void
cut_and_changed_texts_are_read_or_refused(void **state)
{
	(void)state;
	const char *text = "spec,\"A\"\nsize_mm;min_pct;max_pct\n8;85,5;99\n"
			   "4;;40\n";
	for (size_t n = 0; n <= strlen(text); n++)
		for (const char *c = "\",;\n\xFFpan"; *c != '\0'; c++) {
			char *copy = xstrdup(text);
			if (n < strlen(text))
				copy[n] = *c;
			struct error_list errors;
			struct spec *spec = read_spec(copy, &errors);
			assert_true((spec == NULL) == (errors.n > 0));
			spec_free(spec);
			free(copy);
		}
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(limits_and_their_gaps_are_read),
	    cmocka_unit_test(limits_of_the_fines_alone_may_be_small),
	    cmocka_unit_test(a_cut_says_which_fraction_it_is_for),
	    cmocka_unit_test(a_spec_without_a_name_has_that_of_its_file),
	    cmocka_unit_test(faults_have_their_place),
	    cmocka_unit_test(a_file_that_is_not_there_is_the_systems),
	    cmocka_unit_test(cut_and_changed_texts_are_read_or_refused),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}

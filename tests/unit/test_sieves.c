/* Sieves with names, rotors, and what of a sheet was not read.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/sitefile/sieve_size.h"

#include <math.h>

#include "io/sitefile/rotor_size.h"
#include "sheets.h"

/* ASTM E11-20, the numbers at either end and where people err. */
static void
a_sieve_has_its_name_in_many_spellings(void **state)
{
	(void)state;
	static const struct {
		const char *name;
		double mm;
	} NAMES[] = {{"#4", 4.75}, {"# 4", 4.75}, {"No. 4", 4.75},
	    {"No 200", 0.075}, {"no.200", 0.075}, {"N\u00BA 4", 4.75},
	    {"N\u00B0 10", 2}, {" #5 ", 4}, {"#6", 3.35}, {"#7", 2.8},
	    {"#8", 2.36}, {"#18", 1}, {"No. 3 1/2", 5.6}, {"#3.5", 5.6},
	    {"#635", 0.02}, {"#325", 0.045}, {"3/8 in", 9.5}, {"1/2\"", 12.5},
	    {"1 1/2 inch", 37.5}, {"1.5 in.", 37.5}, {"3 in", 75},
	    {"0.530 in", 13.2}, {"5/8 Inches", 16}, {"4", 0}, {"3/8", 0},
	    {"22.4", 0}, {"# 4 cells", 0}, {"#", 0}, {"note 4", 0}, {"", 0},
	    {"#4/0", 0}, {"#0", 0}, {"#3", NAN}, {"#9", NAN}, {"#1000", NAN},
	    {"0.9 in", NAN}};
	for (size_t i = 0; i < ARRAY_LEN(NAMES); i++) {
		double mm = sieve_mm_of_name(NAMES[i].name, SIEVE_NONE);
		if (mm != NAMES[i].mm && !(isnan(mm) && isnan(NAMES[i].mm)))
			fail_msg("%s is %g mm", NAMES[i].name, mm);
	}
	static const char *const NEAREST[][2] = {
	    {"#3", "1/4 in (6.3 mm) and No. 3 1/2 (5.6 mm)"},
	    {"#9", "No. 8 (2.36 mm) and No. 10 (2 mm)"},
	    {"#1000", "No. 635 (0.02 mm)"}, {"9 in", "5 in (125 mm)"},
	    {"0.1 in", "1/4 in (6.3 mm) and No. 3 1/2 (5.6 mm)"}};
	for (size_t i = 0; i < ARRAY_LEN(NEAREST); i++) {
		char *nearest = sieve_nearest_names(NEAREST[i][0]);
		assert_string_equal(nearest, NEAREST[i][1]);
		free(nearest);
	}
}

/* The coarsest row was lost without a word, and 2-1/2 was read as 1.5. */
static void
a_mixed_fraction_is_a_sieve_in_any_row(void **state)
{
	(void)state;
	static const struct {
		const char *head, *name[4];
		double mm[4];
	} SHEETS[] = {
	    {"Sieve (in)", {"1 1/2", "1", "3/4", "1/2"}, {37.5, 25, 19, 12.5}},
	    {"in", {"1-1/2", "1 1/4", "1", "1/4"}, {37.5, 31.5, 25, 6.3}},
	    {"Sieve", {"2-1/2 in", "2 in", "1  1/2 in", "1 in"},
		{63, 50, 37.5, 25}},
	    {"Tyler mesh", {"2 1/2", "3", "3 1/2", "4"}, {8, 6.7, 5.6, 4.75}},
	    {"BS mesh", {"3 1/2", "4", "5", "6"}, {4.75, 4, 3.35, 2.8}},
	    {"US sieve", {"1 1/2", "3/4", "4", "8"}, {37.5, 19, 4.75, 2.36}},
	    {"No.", {"3 1/2", "4", "8", "16"}, {NAN, 4.75, 2.36, 1.18}}};
	for (size_t i = 0; i < ARRAY_LEN(SHEETS); i++) {
		const char *const *name = SHEETS[i].name;
		const double *mm = SHEETS[i].mm;
		FREED char *sheet = xasprintf(
		    "%s,Feed,69 m/s,79 m/s\n%s,100,100,100\n%s,80,90,95\n"
		    "%s,40,60,70\n%s,10,20,30\n",
		    SHEETS[i].head, name[0], name[1], name[2], name[3]);
		if (isnan(mm[0])) {
			struct error_list errors;
			assert_null(read_string(sheet, &errors));
			assert_non_null(strstr(errors.item[0].text,
			    "expected a sieve of ASTM E11, got "));
			continue;
		}
		struct site *site = accept(sheet);
		size_t n;
		FREED double *size = site_all_sieves(site, &n);
		assert_int_equal(n, 4);
		for (size_t k = 0; k < n; k++)
			assert_true(fabs(1000 * size[k] - mm[k]) < 1e-12);
		site_free(site);
	}
}

/* These rows were taken for comments, and 2 sieves of 9 calibrated on. */
static void
a_numbered_sieve_is_never_a_comment(void **state)
{
	(void)state;
	static const char *const SHEETS[] = {
	    ("# 4 samples, dried\n# 5\n" TOP "3/8 in,100,100,100\n"
	     "#4,60,80,90\n  # 16,30,40,50\n\"#200\",10,20,30\n"),
	    (TOP "9.5,100,100,100\nNo. 4,60,80,90\nN\u00BA 16,30,40,50\n"
		 "No 200,10,20,30\n"),
	    ("size_um;feed;product@69;product@79\n9500;100;100;100\n"
	     "#4;60,0;80,0;90,0\n#16;30,0;40;50\n#200;10;20;30\n")};
	static const double mm[] = {9.5, 4.75, 1.18, 0.075};
	for (size_t i = 0; i < ARRAY_LEN(SHEETS); i++) {
		struct site *site = accept(SHEETS[i]);
		size_t n;
		double *size = site_all_sieves(site, &n);
		assert_int_equal(n, ARRAY_LEN(mm));
		for (size_t k = 0; k < n; k++)
			assert_true(fabs(1000 * size[k] - mm[k]) < 1e-12);
		assert_true(site->run[1].product.passing[1] == 0.9);
		assert_int_equal(site->n_left_out, 0);
		free(size);
		site_free(site);
	}
}

static void
what_was_passed_over_is_told(void **state)
{
	(void)state;
	static const struct {
		const char *sheet, *told;
	} SHEETS[] = {{"# c\n" TOP "\n" ROWS, ""},
	    {TOP "8,100,100,100\n# 4 is torn\n4,60,80,90\n1,10,20,30\n",
		"line 3: a comment: # 4 is torn; "},
	    {TOP ROWS "Summa,170,200,220\nSignatur ÅÄÖ\n",
		"line 5: Summa: sums are checked for grams only; "
		"line 6: remark below the table: Signatur ÅÄÖ; "},
	    {"size_mm,feed_retained_g,retained_g@69,retained_g@79\n8,0,0,0\n"
	     "4,80,2,10\n1,100,4,60\npan,20,1,30\nsum,200,7,100\n",
		""},
	    {TOP "8,100,100,100\n5.6\n4,60,80,90\n1,10,20,30\n",
		"line 3: the sieve 5.6 has no numbers; "},
	    {"size_mm,feed,sd@69,product@69,product@79\n8,100,,100,100\n"
	     "4,60,,80,90\n",
		""},
	    {"size_mm,feed,product@69,product@74,product@79\n"
	     "8,100,100,,100\n4,60,80,,90\n",
		"column 4: it is empty; "}};
	for (size_t i = 0; i < ARRAY_LEN(SHEETS); i++) {
		struct site *site = accept(SHEETS[i].sheet);
		char *told = xstrdup("");
		for (size_t k = 0; k < site->n_left_out; k++)
			xappend(&told, "%s: %s; ", site->left_out[k].key,
			    site->left_out[k].value);
		assert_string_equal(told, SHEETS[i].told);
		free(told);
		site_free(site);
	}
}

/* Lines of titles and remarks, in the languages of heads. */
static void
a_rotor_is_measured_in_words(void **state)
{
	static const struct {
		const char *text;
		double mm;
	} SAID[] = {{"VSI, rotor 840 mm, 1560 rpm", 840},
	    {"Rotor diameter 840 mm", 840}, {"rotor 0.84 m", 840},
	    {"rotor 0,84 m, 69 m/s", 840}, {"VSI, \u00D8 840, 1560 rpm", 840},
	    {"VSI \u2300840 mm", 840}, {"Rotor \u00D8=840mm", 840},
	    {"rotor (mm): 840", 840}, {"840 mm rotor, 1560 rpm", 840},
	    {"rotor 84 cm", 840}, {"rotor 33 in", 838.2},
	    {"rotor 1,050 mm", 1050}, {"Rotordurchmesser 840 mm", 840},
	    {"Rotor, Durchmesser 840 mm", 840},
	    {"rotorns diameter 840 mm, kross 2", 840},
	    {"roottorin halkaisija 840 mm", 840},
	    {"rotor di\u00E1metro 840 mm", 840},
	    {"VSI, diam\u00E8tre 840 mm", 840},
	    {"rotor 840 mm, later rotor 840 mm", 840},
	    {"rotor 840 mm, later rotor 900 mm", -1},
	    /* Something else is measured. */
	    {"VSI, rotor at 1560 rpm", 0}, {"rotor speed 60 m/s", 0},
	    {"VSI, rotor 1560", 0}, {"rotor 1560 1/min", 0},
	    {"rotor 60 m/s, sieves 200 mm", 0}, {"sieves \u00D8 200 mm", 0},
	    {"VSI, sieves of diameter 200 mm", 0}, {"\u00D8 200 mm", 0},
	    {"Feed 8/16 mm, rotor 1560 rpm", 0}, {"rotor tip 300 mm", 0},
	    {"sieve 200 mm - rotor 1560 rpm", 0}, {"\u00D8 840-900, VSI", 0}};
	(void)state;
	for (size_t i = 0; i < sizeof SAID / sizeof *SAID; i++) {
		double mm = rotor_diameter_mm_in_text(SAID[i].text, false);
		if (fabs(mm - SAID[i].mm) > 1e-9)
			fail_msg("%s: %g", SAID[i].text, mm);
	}
	/* What a machine is called needs no unit. */
	assert_true(rotor_diameter_mm_in_text("VSI 4, rotor 840", true) == 840);
	assert_true(
	    rotor_diameter_mm_in_text("VSI 4, rotor 1560 rpm", true) == 0);
	assert_true(
	    rotor_diameter_mm_in_text("VSI, rotor 1560 1/min", true) == 0);
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(a_sieve_has_its_name_in_many_spellings),
	    cmocka_unit_test(a_mixed_fraction_is_a_sieve_in_any_row),
	    cmocka_unit_test(a_numbered_sieve_is_never_a_comment),
	    cmocka_unit_test(what_was_passed_over_is_told),
	    cmocka_unit_test(a_rotor_is_measured_in_words),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}

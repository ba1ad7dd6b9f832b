/* Export, import, Table 3 and what a material's words may be.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "shelf.h"

#include "io/cells/datetime.h"
#include "io/store/store_csv.h"

static void
export_and_import_go_round(void **state)
{
	struct shelf *shelf = *state;
	struct error_list errors = {0};
	put(shelf, full("b"));
	put(shelf, sparse("a"));
	struct material_list all = list(shelf), again = {0};
	assert_true(store_csv_write_file(&all, shelf->csv, &shelf->error));
	char *first = contents(shelf->csv);
	if (!store_csv_read_file(shelf->csv, NULL, &again, &errors))
		fail_msg("%s", errors.item[0].text);
	assert_int_equal(again.n, 2);
	expect_same(&all.item[0], &again.item[0]);
	expect_same(&all.item[1], &again.item[1]);
	assert_true(store_csv_write_file(&again, shelf->csv, &shelf->error));
	char *second = contents(shelf->csv);
	assert_string_equal(first, second);
	free(first);
	free(second);
	material_list_free(&all);
	material_list_free(&again);
}

/* 12,000 materials, of which 500 have a note of 25,000 letters: 15 MB. */
static void
a_large_export_is_imported(void **state)
{
	enum { MANY = 12000, LONG = 500, LETTERS = 25000 };
	struct shelf *shelf = *state;
	struct error_list errors = {0};
	struct material_list all = {0}, again = {0};
	char *note = xcalloc(LETTERS + 1, 1), name[16];
	memset(note, 'a', LETTERS);
	for (size_t i = 0; i < MANY; i++) {
		snprintf(name, sizeof name, "m%zu", i);
		struct material m = sparse(name);
		if (i < LONG)
			put_text(&m, "note", note);
		material_list_add(&all, m);
	}
	assert_true(store_csv_write_file(&all, shelf->csv, &shelf->error));
	if (!store_csv_read_file(shelf->csv, NULL, &again, &errors))
		fail_msg("%s", errors.item[0].text);
	assert_int_equal(again.n, MANY);
	expect_same(&all.item[0], &again.item[0]);
	expect_same(&all.item[MANY - 1], &again.item[MANY - 1]);
	free(note);
	material_list_free(&all);
	material_list_free(&again);
}

/* Head and one row of an export, with a word of the row replaced. */
static void
expect_fault(struct shelf *shelf, const char *old, const char *new, int line,
    int column, const char *words)
{
	struct material_list all = {0}, read = {0};
	struct error_list errors = {0};
	bool there = strstr(words, "the store already has") != NULL;
	material_list_add(&all, sparse("a"));
	assert_true(store_csv_write_file(&all, shelf->csv, &shelf->error));
	char *text = contents(shelf->csv), *at = strstr(text, old);
	assert_non_null(at);
	*at = '\0';
	char *changed = xasprintf("%s%s%s", text, new, at + strlen(old));
	write_file(shelf->csv, 0, changed, strlen(changed));
	assert_false(store_csv_read_file(
	    shelf->csv, there ? &all : NULL, &read, &errors));
	const struct error *e = &errors.item[0];
	if (e->line != line || e->column != column || errors.n == 0 ||
	    strstr(e->text, words) == NULL)
		fail_msg("%d:%d: %s", e->line, e->column, e->text);
	free(changed);
	free(text);
	material_list_free(&all);
	material_list_free(&read);
}

static void
faults_of_an_import_have_their_place(void **state)
{
	struct shelf *shelf = *state;
	static const struct {
		const char *old, *new;
		int line, column;
		const char *words;
	} faults[] = {{"2.18", "many", 2, 41, "a number from 0 to 10000"},
	    {"2.18", "-1", 2, 41, "a number from 0 to 10000"},
	    {"2.18", "", 2, 41, "f_mat, got"},
	    {"hand", "magic", 2, 16, "one of: fit hand"},
	    {"\na,", "\n,", 2, 1, "name, got"},
	    {"\na,", "\ntable3/a,", 2, 1, "# or table3/"},
	    {"\na,", "\nA,", 2, 1, "the store already has 'A'"},
	    {"alpha", "delta", 1, 109, "the name of a column"},
	    {"continuous", "exact", 2, 57, "one of: continuous classes"},
	    {"continuous,ratio,1,,,,,,,,,", "continuous,ratio,1,,,,-3,,,,,", 2,
		79, "a whole number"},
	    {"continuous,ratio,1,,,,,,,,,",
		"continuous,ratio,1,,,,,,,,,2026-02-30", 2, 84, "a date"}};
	for (size_t i = 0; i < ARRAY_LEN(faults); i++)
		expect_fault(shelf, faults[i].old, faults[i].new,
		    faults[i].line, faults[i].column, faults[i].words);
}

static void
table_3_is_in_the_program(void **state)
{
	(void)state;
	struct material_list all = {0};
	material_add_table3_to_list(&all);
	assert_int_equal(all.n, 19);
	for (size_t i = 0; i < all.n; i++) {
		struct params p = made_params(&TABLE_3[i]);
		assert_string_equal(all.item[i].site, TABLE_3[i].site);
		assert_memory_equal(&all.item[i].params, &p, sizeof p);
		assert_true(all.item[i].top_size_mm == TABLE_3[i].top_mm);
		assert_true(material_is_table3(&all.item[i]));
	}
	assert_non_null(material_find(&all, "table3/borlange"));
	assert_non_null(material_find(&all, "table3/GÄVLE/11.2/2"));
	material_list_free(&all);
}

static void
dates_are_days_of_the_calendar(void **state)
{
	(void)state;
	static const char *const good[] = {
	    "2026-11-21", "2024-02-29", "2000-02-29", "1999-12-31"};
	static const char *const bad[] = {"", "2026-11-31", "2023-02-29",
	    "1900-02-29", "2026-00-10", "2026-13-01", "2026-1-01", "26-11-21",
	    "2026-11-21 ", "2026/11/21", "2026-11-00", "+026-11-21"};
	for (size_t i = 0; i < ARRAY_LEN(good); i++)
		assert_true(datetime_is_iso_date(good[i]));
	for (size_t i = 0; i < ARRAY_LEN(bad); i++)
		assert_false(datetime_is_iso_date(bad[i]));
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(export_and_import_go_round),
	    cmocka_unit_test(a_large_export_is_imported),
	    cmocka_unit_test(faults_of_an_import_have_their_place),
	    cmocka_unit_test(table_3_is_in_the_program),
	    cmocka_unit_test(dates_are_days_of_the_calendar),
	};
	return shelf_run(tests, ARRAY_LEN(tests));
}

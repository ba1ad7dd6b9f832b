/* The store: what is put comes back to the last bit, and a file that is none,
 * damaged, old, new or locked is told from a good one.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "shelf.h"

#include "base/text.h"

/* Every call fails with this kind of error, and the words and a hint. */
static void
expect_refusal(struct shelf *shelf, enum error_kind kind, const char *words)
{
	struct material_list all = {0};
	assert_false(store_list_materials(shelf->store, &all, &shelf->error));
	material_list_free(&all);
	assert_int_equal(shelf->error.kind, kind);
	assert_string_equal(shelf->error.file, shelf->path);
	assert_true(shelf->error.hint[0] != '\0');
	if (strstr(shelf->error.text, words) == NULL)
		fail_msg("%s: no %s", shelf->error.text, words);
	struct material m = sparse("late");
	assert_false(
	    store_save_materials(shelf->store, &m, 1, true, &shelf->error));
	assert_int_equal(shelf->error.kind, kind);
	material_free(&m);
}

/* SQL behind the store's back. */
static void
meddle(struct shelf *shelf, const char *sql)
{
	sqlite3 *db = NULL;
	assert_int_equal(sqlite3_open(shelf->path, &db), SQLITE_OK);
	if (sqlite3_exec(db, sql, NULL, NULL, NULL) != SQLITE_OK)
		fail_msg("%s: %s", sql, sqlite3_errmsg(db));
	sqlite3_close(db);
}

static void
what_is_put_comes_back_to_the_bit(void **state)
{
	struct shelf *shelf = *state;
	put(shelf, full("tierp"));
	put(shelf, sparse("Åre/4"));
	struct material_list all = list(shelf);
	struct material a = sparse("Åre/4"), b = full("tierp");
	assert_int_equal(all.n, 2);
	expect_same(&all.item[0], &a);
	expect_same(&all.item[1], &b);
	material_free(&a);
	material_free(&b);
	material_list_free(&all);
}

static void
to_read_makes_no_file(void **state)
{
	struct shelf *shelf = *state;
	expect_names(shelf, "");
	assert_false(store_remove_material(shelf->store, "x", &shelf->error));
	assert_int_equal(shelf->error.kind, ERROR_USAGE);
	assert_int_not_equal(access(shelf->path, F_OK), 0);
}

static void
a_name_is_taken_once(void **state)
{
	struct shelf *shelf = *state;
	put(shelf, full("Gävle"));
	struct material two[2] = {sparse("new"), sparse("GAVLE")};
	assert_false(
	    store_save_materials(shelf->store, two, 2, false, &shelf->error));
	assert_int_equal(shelf->error.kind, ERROR_USAGE);
	assert_non_null(strstr(shelf->error.text, "'GAVLE'"));
	/* All or nothing. */
	expect_names(shelf, "Gävle");
	assert_true(
	    store_save_materials(shelf->store, two, 2, true, &shelf->error));
	expect_names(shelf, "GAVLE new");
	assert_true(
	    store_remove_material(shelf->store, "gävle", &shelf->error));
	assert_false(
	    store_remove_material(shelf->store, "gävle", &shelf->error));
	expect_names(shelf, "new");
	material_free(&two[0]);
	material_free(&two[1]);
}

static void
memory_leaves_no_trace(void **state)
{
	struct shelf *shelf = *state;
	assert_int_equal(chdir(shelf->folder), 0);
	store_free(shelf->store);
	shelf->store = store_new(":memory:");
	put(shelf, full("a"));
	put(shelf, full("b"));
	expect_names(shelf, "a b");
	assert_int_equal(rmdir(shelf->folder), 0);
	assert_int_equal(mkdir(shelf->folder, 0700), 0);
}

static void
the_default_place_is_made_for_this_user_alone(void **state)
{
	struct shelf *shelf = *state;
	struct stat about;
	store_free(shelf->store);
	setenv("XDG_DATA_HOME", shelf->folder, 1);
	shelf->store = store_new(NULL);
	put(shelf, full("a"));
	char *folder = xasprintf("%s/tipspeed", shelf->folder);
	char *file = xasprintf("%s/store.db", folder);
	assert_string_equal(store_path(shelf->store), file);
	assert_int_equal(stat(folder, &about), 0);
	assert_int_equal(about.st_mode & 0777, 0700);
	assert_int_equal(access(file, R_OK), 0);
	free(folder);
	free(file);
}

/* A file as an earlier program left it: its schema, its row, its digest. */
static void
make_schema_1(struct shelf *shelf)
{
	struct material m = sparse("old");
	char *row = sqlite3_mprintf(
	    "INSERT INTO about VALUES ('tipspeed 0.0.9');"
	    "INSERT INTO material (fold, digest, name, site, origin, beta1,"
	    " beta2, beta3, beta4, f_mat, e0_min, alpha, method, appearance, k)"
	    " VALUES ('old', '%016llx', 'old', 'Nowhere', 'hand', 0, 1, -1,"
	    " 0.5, 2.18, 16.74, 0.96, 'continuous', 'ratio', 1);"
	    "PRAGMA application_id = %d; PRAGMA user_version = 1",
	    (long long)material_compute_digest(&m), (int)SCHEMA_APPLICATION);
	meddle(shelf, SCHEMA_STEPS[0]);
	meddle(shelf, row);
	sqlite3_free(row);
	material_free(&m);
}

static void
an_older_schema_is_brought_up_to_date(void **state)
{
	struct shelf *shelf = *state;
	make_schema_1(shelf);
	put(shelf, full("new"));
	struct material_list all = list(shelf);
	struct material old = sparse("old"), new = full("new");
	assert_int_equal(all.n, 2);
	expect_same(&all.item[0], &new);
	expect_same(&all.item[1], &old);
	material_free(&old);
	material_free(&new);
	material_list_free(&all);
}

/* A store that 0.1.0 made at schema 2: a digest that no longer holds would make
 * reading it fail. */
static void
a_store_of_0_1_0_is_brought_up_to_date(void **state)
{
	struct shelf *shelf = *state;
	char *path = xasprintf("%s/tests/golden/store-2.sql", getenv("srcdir"));
	char *sql = contents(path);
	meddle(shelf, sql);
	struct material_list all = list(shelf);
	assert_int_equal(all.n, 2);
	const struct params *hand = &all.item[0].params;
	assert_string_equal(all.item[1].name, "Tierp, May");
	assert_string_equal(all.item[1].note, "from 0.1.0");
	assert_int_equal(hand->breakage, 0);
	assert_true(hand->beta[1] == 1.0 / 3 && hand->beta[3] == 1e-17);
	assert_true(hand->f_mat == 2.18 && hand->alpha == 0.1 * 3);
	material_list_free(&all);
	free(sql);
	free(path);
}

/* One that was made at schema 3, before runs were kept. */
static void
a_store_without_runs_is_brought_up_to_date(void **state)
{
	struct shelf *shelf = *state;
	char *path = xasprintf("%s/tests/golden/store-3.sql", getenv("srcdir"));
	char *sql = contents(path);
	meddle(shelf, sql);
	put(shelf, full("new"));
	struct material_list all = list(shelf);
	assert_int_equal(all.n, 3);
	assert_string_equal(all.item[0].name, "hand");
	assert_string_equal(all.item[2].name, "Tierp, May");
	assert_string_equal(all.item[2].date, "2026-05-03");
	assert_string_equal(all.item[2].basis, "");
	assert_true(params_value_by_name(&all.item[2].params, "beta3") ==
		    -0.8797051575992627);
	material_list_free(&all);
	free(sql);
	free(path);
}

/* A step that fails leaves the file as it was. */
static void
a_failed_migration_changes_nothing(void **state)
{
	struct shelf *shelf = *state;
	make_schema_1(shelf);
	meddle(shelf, "ALTER TABLE material ADD COLUMN train_mps REAL");
	struct material_list all = {0};
	assert_false(store_list_materials(shelf->store, &all, &shelf->error));
	assert_int_equal(shelf->error.kind, ERROR_SYSTEM);
	sqlite3 *db = NULL;
	sqlite3_stmt *stmt = NULL;
	sqlite3_open(shelf->path, &db);
	sqlite3_prepare_v2(db, "SELECT program FROM about", -1, &stmt, NULL);
	assert_int_equal(sqlite3_step(stmt), SQLITE_ROW);
	assert_string_equal(
	    (const char *)sqlite3_column_text(stmt, 0), "tipspeed 0.0.9");
	sqlite3_finalize(stmt);
	sqlite3_close(db);
}

static void
a_newer_schema_is_refused(void **state)
{
	struct shelf *shelf = *state;
	put(shelf, full("a"));
	meddle(shelf, "UPDATE about SET program = 'tipspeed 9.9.9';"
		      "PRAGMA user_version = 99");
	expect_refusal(shelf, ERROR_DATA, "tipspeed 9.9.9 (schema 99)");
	char *ours = xasprintf("PRAGMA user_version = %d", (int)STORE_SCHEMA);
	meddle(shelf, ours);
	free(ours);
	expect_names(shelf, "a");
}

static void
another_programs_database_is_refused(void **state)
{
	struct shelf *shelf = *state;
	meddle(shelf, "CREATE TABLE places (url TEXT)");
	expect_refusal(shelf, ERROR_DATA, "another program");
}

static void
a_file_that_is_none_is_refused(void **state)
{
	struct shelf *shelf = *state;
	char text[2000];
	memset(text, 'x', sizeof text);
	write_file(shelf->path, 0, text, sizeof text);
	expect_refusal(shelf, ERROR_DATA, "not a store of tipspeed");
}

static void
a_damaged_file_is_refused(void **state)
{
	struct shelf *shelf = *state;
	for (int i = 0; i < 40; i++) {
		char name[20];
		snprintf(name, sizeof name, "m%d", i);
		put(shelf, full(name));
	}
	struct stat about;
	assert_int_equal(stat(shelf->path, &about), 0);
	char noise[3000];
	for (size_t i = 0; i < sizeof noise; i++)
		noise[i] = (char)(int)(rng_uniform(
					   rng_make_key(7, 0, 0), (uint32_t)i) *
				       255);
	write_file(shelf->path, about.st_size / 2, noise, sizeof noise);
	expect_refusal(shelf, ERROR_DATA, "damaged");
	assert_int_equal(truncate(shelf->path, about.st_size / 3), 0);
	expect_refusal(shelf, ERROR_DATA, "damaged");
}

/* A number changed on the disk makes no broken page, but another material. */
static void
a_changed_number_is_noticed(void **state)
{
	struct shelf *shelf = *state;
	put(shelf, full("a"));
	put(shelf, full("b"));
	meddle(shelf, "UPDATE material SET params = replace(params, 'f_mat=2', "
		      "'f_mat=1') WHERE name = 'b'");
	struct material_list all = {0};
	assert_false(store_list_materials(shelf->store, &all, &shelf->error));
	material_list_free(&all);
	assert_int_equal(shelf->error.kind, ERROR_DATA);
	assert_non_null(strstr(shelf->error.text, "'b'"));
	assert_true(store_remove_material(shelf->store, "b", &shelf->error));
	expect_names(shelf, "a");
}

/* A row as somebody else may make one: what SET says is of m too, and the digest
 * is right. */
static void
forge(struct shelf *shelf, const struct material *m, const char *set)
{
	char *sql = xasprintf("UPDATE material SET digest = '%016llx', %s "
			      "WHERE fold = 'b'",
	    (unsigned long long)material_compute_digest(m), set);
	put(shelf, full("b"));
	meddle(shelf, sql);
	free(sql);
}

/* The row is refused with these words, and can be taken out as the hint says. */
static void
expect_forged(struct shelf *shelf, const char *words, const char *name)
{
	struct material_list all = {0};
	assert_false(store_list_materials(shelf->store, &all, &shelf->error));
	material_list_free(&all);
	assert_int_equal(shelf->error.kind, ERROR_DATA);
	assert_string_equal(shelf->error.file, shelf->path);
	char *hint = xasprintf("run 'forget \"%s\"', then", name);
	if (strstr(shelf->error.text, words) == NULL ||
	    strstr(shelf->error.hint, hint) == NULL)
		fail_msg("%s\n%s", shelf->error.text, shelf->error.hint);
	free(hint);
	assert_true(store_remove_material(shelf->store, name, &shelf->error));
	expect_names(shelf, "a");
}

static void
rows_are_checked_as_an_import_is(void **state)
{
	struct shelf *shelf = *state;
	static const struct {
		const char *field, *value, *words;
	} ROWS[] = {
	    {"params", "replace(params, 'f_mat=2.18', 'f_mat=1e308')",
		"expected a number from 0 to 10000 for f_mat, got '1e+308'"},
	    {"params", "replace(params, 'alpha=', 'alpha=-')",
		"expected a number from 0 to 100 for alpha"},
	    {"params", "'beta1=0'",
		"expected a number from -1e+09 to 1e+09 for beta2, got 'nan'"},
	    {"model", "'magic'", "expected one of: grunditz grunditz-energy"},
	    {"k", "9e999", "expected a number from 0.001 to 1000 for k"},
	    {"method", "'magic'", "expected one of: continuous classes, got"},
	    {"method", "''", "'b', field method: expected one of"},
	    {"date", "'2026-02-30'", "expected a date such as 2026-11-21"},
	    {"rock", "'a' || char(27) || '[31m'",
		"field rock: expected text without control"},
	    {"note", "'a' || char(10)", "expected text without control"},
	    {"site", "CAST(x'FF' AS TEXT)", "expected text without control"},
	    {"seed", "-7", "expected a whole number below 2^63"}};
	put(shelf, full("a"));
	for (size_t i = 0; i < ARRAY_LEN(ROWS); i++) {
		char *set = xasprintf("%s = %s", ROWS[i].field, ROWS[i].value);
		struct material m = full("b");
		forge(shelf, &m, set);
		material_free(&m);
		expect_forged(shelf, ROWS[i].words, "b");
		free(set);
	}
}

/* What is right in itself and forged whole is still no name. */
static void
a_name_that_is_none_can_be_forgotten_as_it_is_shown(void **state)
{
	struct shelf *shelf = *state;
	static const char *const NAMES[][2] = {
	    {"x\x1B[31mred", "x\\x1b[31mred"}, {"table3/tierp", "table3/tierp"},
	    {"#b", "#b"}, {"\"b\"", "'b'"}, {"\xFF", "\\xff"},
	    {"0123456789012345678901234567890123456789012345678901234567å789",
		"0123456789012345678901234567890123456789012345678901234567å"}};
	put(shelf, full("a"));
	for (size_t i = 0; i < ARRAY_LEN(NAMES); i++) {
		struct material m = full(NAMES[i][0]);
		char *fold = text_fold_case_and_accents(m.name),
		     set[400] = "fold = CAST(x'";
		for (const char *p = fold; *p != '\0'; p++)
			snprintf(set + strlen(set), 3, "%02x",
			    (unsigned)(unsigned char)*p);
		strcat(set, "' AS TEXT), name = CAST(x'");
		for (const char *p = m.name; *p != '\0'; p++)
			snprintf(set + strlen(set), 3, "%02x",
			    (unsigned)(unsigned char)*p);
		strcat(set, "' AS TEXT)");
		forge(shelf, &m, set);
		expect_forged(
		    shelf, "field name: expected a name", NAMES[i][1]);
		free(fold);
		material_free(&m);
	}
	struct material m = full("c");
	forge(shelf, &m, "name = 'c'");
	material_free(&m);
	expect_forged(shelf, "'c' is not what was remembered", "c");
}

static void
what_cannot_be_read_back_is_not_put(void **state)
{
	struct shelf *shelf = *state;
	struct material m = full("b");
	put(shelf, full("a"));
	m.params.alpha = 500;
	assert_false(
	    store_save_materials(shelf->store, &m, 1, false, &shelf->error));
	assert_non_null(strstr(shelf->error.text, "0 to 100 for alpha"));
	expect_names(shelf, "a");
	material_free(&m);
}

static void
a_locked_store_is_waited_for_and_then_told(void **state)
{
	struct shelf *shelf = *state;
	put(shelf, full("a"));
	sqlite3 *db = NULL;
	sqlite3_open(shelf->path, &db);
	sqlite3_exec(db, "BEGIN IMMEDIATE", NULL, NULL, NULL);
	struct material m = full("b");
	assert_false(
	    store_save_materials(shelf->store, &m, 1, false, &shelf->error));
	assert_int_equal(shelf->error.kind, ERROR_SYSTEM);
	assert_non_null(strstr(shelf->error.text, "another program"));
	/* To read, nobody waits. */
	expect_names(shelf, "a");
	sqlite3_exec(db, "ROLLBACK", NULL, NULL, NULL);
	sqlite3_close(db);
	assert_true(
	    store_save_materials(shelf->store, &m, 1, false, &shelf->error));
	material_free(&m);
	expect_names(shelf, "a b");
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(what_is_put_comes_back_to_the_bit),
	    cmocka_unit_test(to_read_makes_no_file),
	    cmocka_unit_test(a_name_is_taken_once),
	    cmocka_unit_test(memory_leaves_no_trace),
	    cmocka_unit_test(the_default_place_is_made_for_this_user_alone),
	    cmocka_unit_test(an_older_schema_is_brought_up_to_date),
	    cmocka_unit_test(a_store_without_runs_is_brought_up_to_date),
	    cmocka_unit_test(a_failed_migration_changes_nothing),
	    cmocka_unit_test(a_store_of_0_1_0_is_brought_up_to_date),
	    cmocka_unit_test(a_newer_schema_is_refused),
	    cmocka_unit_test(another_programs_database_is_refused),
	    cmocka_unit_test(a_file_that_is_none_is_refused),
	    cmocka_unit_test(a_damaged_file_is_refused),
	    cmocka_unit_test(a_changed_number_is_noticed),
	    cmocka_unit_test(rows_are_checked_as_an_import_is),
	    cmocka_unit_test(
		a_name_that_is_none_can_be_forgotten_as_it_is_shown),
	    cmocka_unit_test(what_cannot_be_read_back_is_not_put),
	    cmocka_unit_test(a_locked_store_is_waited_for_and_then_told),
	};
	return shelf_run(tests, ARRAY_LEN(tests));
}

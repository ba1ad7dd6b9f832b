/* A store in a folder of its own, and materials to put in it.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TESTS_SHELF_H
#define TIPSPEED_TESTS_SHELF_H

#include <sqlite3.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "made.h"

#include "io/store/store.h"

/* A folder of the test's own, and a store in it. */
struct shelf {
	char folder[64], *path, *csv;
	struct store *store;
	struct error error;
};

static inline int
open_shelf(void **state)
{
	struct shelf *shelf = xcalloc(1, sizeof *shelf);
	strcpy(shelf->folder, "/tmp/tipspeed-store-XXXXXX");
	assert_non_null(mkdtemp(shelf->folder));
	shelf->path = xasprintf("%s/my store%%?.db", shelf->folder);
	shelf->csv = xasprintf("%s/out.csv", shelf->folder);
	shelf->store = store_new(shelf->path);
	*state = shelf;
	return 0;
}

static inline int
close_shelf(void **state)
{
	struct shelf *shelf = *state;
	assert_int_equal(chdir("/"), 0);
	char *remove = xasprintf("rm -rf '%s'", shelf->folder);
	store_free(shelf->store);
	assert_int_equal(system(remove), 0);
	free(remove);
	free(shelf->path);
	free(shelf->csv);
	free(shelf);
	return 0;
}

static inline char *
contents(const char *path)
{
	char *text = xcalloc(100000, 1);
	FILE *file = fopen(path, "r");
	assert_non_null(file);
	assert_true(fread(text, 1, 99999, file) > 0);
	fclose(file);
	return text;
}

static inline void
put_text(struct material *m, const char *name, const char *text)
{
	size_t i = 0;
	while (strcmp(FIELDS[i].name, name) != 0)
		assert_true(++i < FIELD_COUNT);
	material_set_field(m, &FIELDS[i], text);
}

/* A calibration with all there is to know of one. */
static inline struct material
full(const char *name)
{
	struct material m = material_make_empty();
	put_text(&m, "name", name);
	put_text(&m, "site", "Gävle, \"södra\"");
	put_text(&m, "rock", "Granite");
	put_text(&m, "machine", "Barmac");
	put_text(&m, "provenance", "reconstructed, not measured; seed 9");
	put_text(&m, "site_digest", "0123456789abcdef");
	put_text(&m, "origin", "fit");
	put_text(&m, "method", "classes");
	put_text(&m, "appearance", "progeny_mm");
	put_text(&m, "options", "population=8000; bounds alpha 0.8..1");
	put_text(&m, "stop", "tolerance");
	put_text(&m, "train_mps", "69,79");
	put_text(&m, "date", "2026-11-21");
	put_text(&m, "note", "wet; # rain, \"heavy\"");
	put_text(&m, "version", "0.1.0");
	put_text(&m, "basis", "rmse=0.1 \\nsite,\"a, b\"");
	m.top_size_mm = 11.2;
	m.k = 1;
	m.misfit = 0.1 + 0.2;
	m.rmse_pct = 1.0 / 3;
	m.holdout_pct = 5e-324;
	m.seed = INT64_MAX;
	m.generations = 800;
	m.params = (struct params){
	    .at = {-1.0 / 3, 1, -0.7391650217314, 1e-17, 2.18, 16.74, 0.1 * 3}};
	return m;
}

/* Only what every one has. */
static inline struct material
sparse(const char *name)
{
	struct material m = material_make_empty();
	put_text(&m, "name", name);
	put_text(&m, "site", "Nowhere");
	put_text(&m, "origin", "hand");
	put_text(&m, "method", "continuous");
	put_text(&m, "appearance", "ratio");
	m.k = 1;
	m.params = made_params(&TABLE_3[TIERP]);
	return m;
}

static inline void
expect_same(const struct material *a, const struct material *b)
{
	for (size_t i = 0; i < FIELD_COUNT; i++) {
		char *p = material_field_to_text(a, &FIELDS[i]);
		char *q = material_field_to_text(b, &FIELDS[i]);
		assert_string_equal(p, q);
		free(p);
		free(q);
	}
	assert_memory_equal(&a->params, &b->params, sizeof a->params);
	assert_memory_equal(&a->misfit, &b->misfit, sizeof a->misfit);
}

static inline void
put(struct shelf *shelf, struct material m)
{
	if (!store_save_materials(shelf->store, &m, 1, false, &shelf->error))
		fail_msg("%s: %s", m.name, shelf->error.text);
	material_free(&m);
}

static inline struct material_list
list(struct shelf *shelf)
{
	struct material_list all = {0};
	if (!store_list_materials(shelf->store, &all, &shelf->error))
		fail_msg("%s", shelf->error.text);
	return all;
}

static inline void
expect_names(struct shelf *shelf, const char *names)
{
	char words[256] = "";
	struct material_list all = list(shelf);
	for (size_t i = 0; i < all.n; i++) {
		strcat(words, i > 0 ? " " : "");
		strcat(words, all.item[i].name);
	}
	assert_string_equal(words, names);
	material_list_free(&all);
}

static inline void
write_file(const char *path, long offset, const char *bytes, size_t n)
{
	FILE *file = fopen(path, offset > 0 ? "r+" : "w");
	assert_non_null(file);
	assert_int_equal(fseek(file, offset, SEEK_SET), 0);
	assert_int_equal(fwrite(bytes, 1, n, file), n);
	assert_int_equal(fclose(file), 0);
}

/* The tests, each with a shelf of its own. */
static inline int
shelf_run(const struct CMUnitTest *tests, size_t n)
{
	/* Each test ends in another folder. */
	const char *srcdir = getenv("srcdir");
	char here[4096];
	assert_non_null(getcwd(here, sizeof here));
	char *absolute =
	    srcdir != NULL && srcdir[0] == '/'
		? xstrdup(srcdir)
		: xasprintf("%s/%s", here, srcdir != NULL ? srcdir : ".");
	setenv("srcdir", absolute, 1);
	free(absolute);
	struct CMUnitTest *own = xcalloc(n, sizeof *own);
	for (size_t i = 0; i < n; i++)
		own[i] = (struct CMUnitTest){tests[i].name, tests[i].test_func,
		    open_shelf, close_shelf, NULL};
	int failed = _cmocka_run_group_tests("shelf", own, n, NULL, NULL);
	free(own);
	return failed;
}

#endif

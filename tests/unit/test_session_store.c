/* The store as a session uses it: what fails costs nothing, what is recalled for
 * another site never passes for a fit, and a site itself is as it was.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <string.h>

#include "cmd/session/sites.h"
#include "desk.h"
#include "often.h"
#include "made.h"

static const char CALIBRATE[] =
    "calibrate population=200 generations=20 seed=3 train=69,79";

static int
open_with_site(void **state)
{
	desk_open(state);
	struct desk *desk = *state;
	struct site *site = made_site(&TABLE_3[TIERP], 0.005, 9);
	free(site->name);
	free(site->provenance);
	site->name = xstrdup("Tierp");
	site->provenance = xstrdup("reconstructed, not measured");
	session_add_site(desk->session, site);
	return 0;
}

static struct material_list
own(struct desk *desk)
{
	struct material_list list = {0};
	assert_true(
	    store_list_materials(desk->session->store, &list, &desk->error));
	return list;
}

static void
a_fit_is_remembered_with_its_origin(void **state)
{
	struct desk *desk = *state;
	desk_expect(desk, "bounds alpha 0.5..0.9");
	desk_expect(desk, CALIBRATE);
	desk_expect(desk, "remember pit date=2026-11-21 note=\"wet feed\"");
	const struct entry *entry = session_current_site_entry(desk->session);
	struct material_list list = own(desk);
	assert_int_equal(list.n, 1);
	const struct material *m = &list.item[0];
	assert_memory_equal(&m->params, &entry->params, sizeof m->params);
	assert_true(m->misfit == entry->fit.misfit);
	assert_true(m->rmse_pct == 100 * entry->fit.rmse);
	assert_true(m->holdout_pct > 0 && m->holdout_pct < 20);
	assert_int_equal(m->seed, 3);
	assert_int_equal(m->generations, entry->fit.generations);
	assert_string_equal(m->origin, "fit");
	assert_string_equal(m->provenance, "reconstructed, not measured");
	assert_string_equal(m->train_mps, "69,79");
	assert_string_equal(m->date, "2026-11-21");
	assert_string_equal(m->note, "wet feed");
	assert_non_null(strstr(m->options, "population=200"));
	assert_non_null(strstr(m->options, "bounds alpha 0.5..0.9"));
	material_list_free(&list);
}

static void
a_store_that_fails_costs_nothing(void **state)
{
	struct desk *desk = *state;
	struct session *s = desk->session;
	desk_expect(desk, CALIBRATE);
	struct params before = session_current_site_entry(s)->params;
	store_free(s->store);
	s->store = store_new("/no/such/folder/s.db");
	assert_false(desk_say(desk, "remember pit"));
	assert_int_equal(desk->error.kind, ERROR_SYSTEM);
	assert_true(session_current_site_entry(s)->has_fit);
	assert_memory_equal(
	    &session_current_site_entry(s)->params, &before, sizeof before);
	store_free(s->store);
	s->store = store_new(":memory:");
	desk_expect(desk, "remember pit");
	struct material_list list = own(desk);
	assert_int_equal(list.n, 1);
	material_list_free(&list);
}

static void
what_is_recalled_is_no_fit(void **state)
{
	struct desk *desk = *state;
	const struct entry *entry = session_current_site_entry(desk->session);
	desk_expect(desk, CALIBRATE);
	desk_expect(desk, "recall Kiruna");
	assert_true(entry->has_params && !entry->has_fit);
	assert_true(origin_is_from_store(entry->origin));
	assert_string_equal(entry->origin->from, "table3/kiruna");
	assert_true(entry->params.f_mat == 0.39);
	desk_expect(desk, "params");
	assert_non_null(strstr(desk->out, "from store: table3/kiruna"));
	assert_false(desk_say(desk, "remember mine"));
	assert_int_equal(desk->error.kind, ERROR_USAGE);
	/* Whatever else sets the parameters takes the origin away. */
	desk_expect(desk, "params set alpha=0.9");
	assert_false(origin_is_from_store(entry->origin));
	desk_expect(desk, "remember mine; recall mine");
	assert_string_equal(entry->origin->from, "mine");
	desk_expect(desk, CALIBRATE);
	assert_false(origin_is_from_store(entry->origin));
	assert_true(entry->has_fit);
}

/* The line that forget prints. */
static void
what_is_forgotten_can_be_brought_back(void **state)
{
	struct desk *desk = *state;
	desk_expect(desk, CALIBRATE);
	desk_expect(desk, "remember \"my pit\"; set format csv");
	struct material_list before = own(desk);
	desk_expect(desk, "forget \"my pit\"");
	char *line = xstrdup(strstr(desk->out, "params set"));
	for (char *p = line, *q = line;; p++) {
		/* CSV doubles the quotes and puts one round the cell. */
		if (p[0] == '"' && (p[1] == '"' || p[1] == '\n'))
			p++;
		*q++ = *p == '\n' ? '\0' : *p;
		if (*p == '\0' || *p == '\n')
			break;
	}
	desk_expect(desk, line);
	free(line);
	struct material_list after = own(desk);
	assert_int_equal(after.n, 1);
	assert_string_equal(after.item[0].origin, "hand");
	assert_memory_equal(&after.item[0].params, &before.item[0].params,
	    sizeof(struct params));
	material_list_free(&before);
	material_list_free(&after);
}

/* What predict says at 71.5 m/s and the state of drift, without the words on
 * where it is from. */
static char *
said(struct desk *desk, const char *line)
{
	static const char *const FROM[] = {"\"recalled\":\"", "\"origin\":\""};
	size_t before = desk->n_out;
	desk_expect(desk, line);
	char *text = xstrdup(desk->out + before);
	for (size_t i = 0; i < ARRAY_LEN(FROM); i++) {
		char *at = strstr(text, FROM[i]);
		if (at == NULL)
			continue;
		char *end = strchr(at + strlen(FROM[i]), '"') + 1;
		end += *end == ',';
		memmove(at, end, strlen(end) + 1);
	}
	return text;
}

/* Another session at the store of this one, with what was typed first. */
static struct desk *
next_day(struct desk *desk, const char *line)
{
	void *state;
	desk_open(&state);
	struct desk *next = state;
	store_free(next->session->store);
	next->session->store = store_new(store_path(desk->session->store));
	desk_expect(next, line);
	return next;
}

static const char ASK[] = "set format json; predict 71.5";

static void
expect_alike(
    struct desk *desk, const char *line, const char *ask, const char *wanted)
{
	struct desk *next = next_day(desk, line);
	char *text = said(next, ask);
	assert_string_equal(text, wanted);
	free(text);
	void *state = next;
	desk_close(&state);
}

static int
open_with_file(void **state)
{
	char folder[] = "/tmp/tipspeed-store-XXXXXX";
	assert_non_null(mkdtemp(folder));
	char *path = xasprintf("%s/s.db", folder);
	desk_open(state);
	struct desk *desk = *state;
	store_free(desk->session->store);
	desk->session->store = store_new(path);
	free(path);
	return 0;
}

static int
close_with_file(void **state)
{
	struct desk *desk = *state;
	char *folder = xstrdup(store_path(desk->session->store));
	*strrchr(folder, '/') = '\0';
	char *remove = xasprintf("rm -r '%s'", folder);
	assert_int_equal(system(remove), 0);
	free(remove);
	free(folder);
	return desk_close(state);
}

/* Individual feeds, one feed, a break size of 0, weights, other bounds and
 * another model. */
static void
what_was_remembered_answers_alike(void **state)
{
	static const struct {
		const char *site, *fit;
	} CASES[] = {{"umea", "bounds alpha 0.5..0.9; calibrate population=200 "
			      "train=69,74 run_weights=1,2"},
	    {"tierp", "set model grunditz-energy; calibrate population=200"},
	    {"tierp", "calibrate population=200"},
	    {"gavle-4", "calibrate population=200"},
	    {"ossjo", "calibrate population=200"}};
	size_t cases = often(2, ARRAY_LEN(CASES));
	for (size_t i = 0; i < cases; i++) {
		struct desk *desk = *state;
		char *load = xasprintf("load data/sites/%s.csv", CASES[i].site);
		char *again = xasprintf("%s; recall site", load);
		desk_expect(desk, load);
		desk_expect(desk, CASES[i].fit);
		char *wanted = said(desk, ASK);
		desk_expect(desk, "set format table; remember site replace=on");
		expect_alike(desk, "recall site", ASK, wanted);
		expect_alike(desk, again, ASK, wanted);
		free(again);
		free(load);
		free(wanted);
	}
}

/* The sheet of the first day, of which the store knows more; and what is added
 * on the next day goes on from there. */
static void
cuts_since_are_remembered(void **state)
{
	static const char CUT[] = "add data/cuts/tierp-may.csv";
	static const char DRIFT[] = "set format json; drift; predict 71.5";
	struct desk *desk = *state;
	char *again = xasprintf("load data/sites/tierp.csv; recall pit");
	char *then = xasprintf("recall early; %s", CUT);
	desk_expect(desk, TIERP_CALIBRATED);
	desk_expect(desk, "remember early");
	desk_expect(desk, CUT);
	char *wanted = said(desk, DRIFT);
	assert_non_null(strstr(wanted, "2026-05-0"));
	desk_expect(desk, "set format table; remember pit");
	expect_alike(desk, "recall pit", DRIFT, wanted);
	expect_alike(desk, again, DRIFT, wanted);
	expect_alike(desk, then, DRIFT, wanted);
	free(again);
	free(then);
	free(wanted);
}

/* As 'params use' has it of a site that is loaded beside it. */
static void
another_sheet_learns_from_the_runs(void **state)
{
	static const char FIGURES[] = "set format csv; figures 72";
	struct desk *desk = *state;
	desk_expect(desk, TIERP_CALIBRATED);
	desk_expect(desk, "remember pit; load data/sites/kiruna.csv");
	desk_expect(desk, "params use tierp");
	char *wanted = said(desk, FIGURES);
	assert_non_null(strstr(wanted, ",low"));
	expect_alike(
	    desk, "load data/sites/kiruna.csv; recall pit", FIGURES, wanted);
	free(wanted);
}

/* A store may be anybody's. */
static void
runs_that_cannot_be_are_refused(void **state)
{
	struct desk *desk = *state;
	struct store *store = desk->session->store;
	size_t refused = 0, n = often(30, 200);
	uint32_t x = 1;
	desk_expect(desk, TIERP_CALIBRATED);
	desk_expect(desk, "remember pit; reset");
	struct material_list list = own(desk);
	char *good = xstrdup(list.item[0].basis);
	for (size_t i = 0; i < n; i++) {
		char *bad = list.item[0].basis;
		strcpy(bad, good);
		for (int k = 0; k < 3; k++) {
			x = x * 1664525 + 1013904223;
			size_t at = x % strlen(good);
			bad[at] = "0-9.,=\\ne@"[(x >> 8) % 10];
		}
		assert_true(store_save_materials(
		    store, list.item, 1, true, &desk->error));
		if (!desk_say(desk, "recall pit")) {
			assert_int_equal(desk->error.kind, ERROR_DATA);
			refused++;
		} else if (i % 8 == 0) {
			desk_say(desk, "set draw_seed 2; predict 72");
		}
		if (desk->session->n_entry > 0)
			desk_expect(desk, "reset");
	}
	assert_true(refused > n / 4);
	free(good);
	material_list_free(&list);
}

int
main(void)
{
	chdir_to_source();
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test_setup_teardown(a_fit_is_remembered_with_its_origin,
		open_with_site, desk_close),
	    cmocka_unit_test_setup_teardown(
		a_store_that_fails_costs_nothing, open_with_site, desk_close),
	    cmocka_unit_test_setup_teardown(
		what_is_recalled_is_no_fit, open_with_site, desk_close),
	    cmocka_unit_test_setup_teardown(
		what_is_forgotten_can_be_brought_back, open_with_site,
		desk_close),
	    cmocka_unit_test_setup_teardown(what_was_remembered_answers_alike,
		open_with_file, close_with_file),
	    cmocka_unit_test_setup_teardown(
		cuts_since_are_remembered, open_with_file, close_with_file),
	    cmocka_unit_test_setup_teardown(another_sheet_learns_from_the_runs,
		open_with_file, close_with_file),
	    cmocka_unit_test_setup_teardown(runs_that_cannot_be_are_refused,
		open_with_file, close_with_file),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}

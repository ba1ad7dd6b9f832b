/* The store as a session uses it: what fails costs nothing, and what is recalled
 * never passes for a fit.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <string.h>

#include "cmd/session/sites.h"
#include "desk.h"
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
	session_add(desk->session, site);
	return 0;
}

static struct stored_list
own(struct desk *desk)
{
	struct stored_list list = {0};
	assert_true(store_list(desk->session->store, &list, &desk->error));
	return list;
}

static void
a_fit_is_remembered_with_its_origin(void **state)
{
	struct desk *desk = *state;
	desk_expect(desk, "bounds alpha 0.5..0.9");
	desk_expect(desk, CALIBRATE);
	desk_expect(desk, "remember pit date=2026-11-21 note=\"wet feed\"");
	const struct entry *entry = session_entry(desk->session);
	struct stored_list list = own(desk);
	assert_int_equal(list.n, 1);
	const struct stored *m = &list.item[0];
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
	stored_list_free(&list);
}

static void
a_store_that_fails_costs_nothing(void **state)
{
	struct desk *desk = *state;
	struct session *s = desk->session;
	desk_expect(desk, CALIBRATE);
	struct params before = session_entry(s)->params;
	store_free(s->store);
	s->store = store_new("/no/such/folder/s.db");
	assert_false(desk_say(desk, "remember pit"));
	assert_int_equal(desk->error.kind, ERROR_SYSTEM);
	assert_true(session_entry(s)->has_fit);
	assert_memory_equal(&session_entry(s)->params, &before, sizeof before);
	store_free(s->store);
	s->store = store_new(":memory:");
	desk_expect(desk, "remember pit");
	struct stored_list list = own(desk);
	assert_int_equal(list.n, 1);
	stored_list_free(&list);
}

static void
what_is_recalled_is_no_fit(void **state)
{
	struct desk *desk = *state;
	const struct entry *entry = session_entry(desk->session);
	desk_expect(desk, CALIBRATE);
	desk_expect(desk, "recall Kiruna");
	assert_true(entry->has_params && !entry->has_fit);
	assert_true(entry->origin->stored);
	assert_string_equal(entry->origin->whose, "table3/kiruna");
	assert_true(entry->params.f_mat == 0.39);
	desk_expect(desk, "params");
	assert_non_null(strstr(desk->out, "from store: table3/kiruna"));
	assert_false(desk_say(desk, "remember mine"));
	assert_int_equal(desk->error.kind, ERROR_USAGE);
	/* Whatever else sets the parameters takes the origin away. */
	desk_expect(desk, "params set alpha=0.9");
	assert_false(entry->origin->stored);
	desk_expect(desk, "remember mine; recall mine");
	assert_string_equal(entry->origin->whose, "mine");
	desk_expect(desk, CALIBRATE);
	assert_false(entry->origin->stored);
	assert_true(entry->has_fit);
}

/* The line that forget prints. */
static void
what_is_forgotten_can_be_brought_back(void **state)
{
	struct desk *desk = *state;
	desk_expect(desk, CALIBRATE);
	desk_expect(desk, "remember \"my pit\"; set format csv");
	struct stored_list before = own(desk);
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
	struct stored_list after = own(desk);
	assert_int_equal(after.n, 1);
	assert_string_equal(after.item[0].origin, "hand");
	assert_memory_equal(&after.item[0].params, &before.item[0].params,
	    sizeof(struct params));
	stored_list_free(&before);
	stored_list_free(&after);
}

int
main(void)
{
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
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}

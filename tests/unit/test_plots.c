/* Plots of a session: every kind at every size, and what they are made from.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "desk.h"

#include <math.h>
#include <string.h>
#include <unistd.h>

#include "cmd/answers.h"
#include "cmd/outlook.h"
#include "cmd/plots.h"
#include "cmd/invocation.h"

static const char PARAMS_SET[] =
    "params set f_mat=2.18 e0_min=16.74 alpha=0.96";
static const char SEARCH[] =
    "calibrate seed=3 population=60 generations=30 tolerance=0 stall=0";
enum { KINDS = PLOT_SWEEP + 1 };

static int
open_with_site(void **state)
{
	desk_open(state);
	desk_expect(*state, "load data/sites/tierp.csv");
	return 0;
}

static struct chart *
chart_of(struct desk *desk, const struct plot_request *request)
{
	desk->error = (struct error){0};
	struct chart *chart = plots_chart(desk->session, request, &desk->error);
	if (chart == NULL)
		fail_msg("%s", desk->error.text);
	return chart;
}

static void
every_kind_fits_every_size(void **state)
{
	static const int sizes[][2] = {{20, 5}, {80, 24}, {300, 100}, {1, 1}};
	struct desk *desk = *state;
	desk_expect(desk, SEARCH);
	for (int kind = 0; kind < KINDS; kind++)
		for (size_t i = 0; i < 12; i++) {
			struct plot_request q =
			    plots_request((enum plot_kind)kind);
			const int *size = sizes[i % 4];
			q.charset = (enum charset)(i / 4);
			q.other_speed = 60;
			q.crosshair_mm = 3;
			q.band = true;
			struct canvas *c = plots_draw(
			    desk->session, &q, size[0], size[1], &desk->error);
			assert_non_null(c);
			assert_int_equal(c->columns, size[0]);
			assert_int_equal(c->rows, size[1]);
			canvas_free(c);
		}
}

/* Without colour: by mark, or by line where there are none; in ASCII a line has
 * its character. */
static bool
look_alike(const struct chart_series *a, const struct chart_series *b)
{
	if (a->mark != b->mark)
		return false;
	return a->mark != 0 || a->line == b->line || a->ascii == b->ascii;
}

static void
no_two_series_look_alike(void **state)
{
	struct desk *desk = *state;
	desk_expect(desk, SEARCH);
	for (int kind = 0; kind < KINDS; kind++) {
		struct plot_request q = plots_request((enum plot_kind)kind);
		q.other_speed = 80;
		struct chart *c = chart_of(desk, &q);
		assert_true(c->n > 0);
		for (size_t i = 0; i < c->n; i++)
			for (size_t j = 0; j < i; j++)
				assert_false(
				    look_alike(&c->series[i], &c->series[j]));
		chart_free(c);
	}
}

static void
every_sieve_of_the_sheet_is_a_tick(void **state)
{
	struct desk *desk = *state;
	const struct site *site = session_entry(desk->session)->site;
	struct plot_request q = plots_request(PLOT_PSD);
	struct chart *c = chart_of(desk, &q);
	const struct psd *psd = &site->run[0].product;
	assert_int_equal(c->x.n, psd->n);
	for (size_t i = 0; i < psd->n; i++)
		assert_true(fabs(c->x.tick[psd->n - 1 - i].at -
				 1000 * psd->size[i]) < 1e-9);
	chart_free(c);
}

static void
a_running_search_shows_its_best_so_far(void **state)
{
	struct desk *desk = *state;
	struct session *s = desk->session;
	size_t next = 0;
	desk_expect(desk, PARAMS_SET);
	assert_true(session_line(s, SEARCH, 0, "t", 1, &next, &desk->error));
	for (int i = 0; i < 5; i++)
		session_step(s);
	struct plot_request q = plots_request(PLOT_CONVERGENCE);
	struct chart *c = chart_of(desk, &q);
	assert_int_equal(c->series[0].n, 5);
	chart_free(c);
	struct params p, best = calibration_status(s->job.calibration).params;
	q = plots_request(PLOT_PSD);
	assert_true(plots_params(s, &q, &p, &desk->error));
	assert_memory_equal(&p, &best, sizeof p);
	while (session_busy(s))
		session_step(s);
	assert_true(session_settle(s, true, &desk->error));
	assert_true(plots_params(s, &q, &p, &desk->error));
	assert_memory_equal(&p, &session_entry(s)->params, sizeof p);
}

static void
a_generation_shows_its_own_best(void **state)
{
	struct desk *desk = *state;
	desk_expect(desk, SEARCH);
	const struct history *h = session_entry(desk->session)->history;
	struct plot_request q = plots_request(PLOT_PSD);
	struct params p = {0};
	q.generation = 7;
	assert_true(plots_params(desk->session, &q, &p, &desk->error));
	assert_memory_equal(&p, &h->generation[6].params, sizeof p);
	q.kind = PLOT_CONVERGENCE;
	struct chart *c = chart_of(desk, &q);
	assert_int_equal(c->series[0].n, 7);
	chart_free(c);
	q.generation = h->n + 1;
	for (int kind = PLOT_PSD; kind <= PLOT_SPREAD; kind++) {
		q.kind = (enum plot_kind)kind;
		if (kind != PLOT_PARITY)
			assert_null(
			    plots_chart(desk->session, &q, &desk->error));
	}
}

static void
a_band_holds_the_prediction_of_a_fit(void **state)
{
	struct desk *desk = *state;
	struct plot_request q = plots_request(PLOT_PSD);
	q.band = true;
	desk_expect(desk, PARAMS_SET);
	struct chart *c = chart_of(desk, &q);
	assert_null(c->series[c->n - 1].low);
	chart_free(c);
	desk_expect(desk, SEARCH);
	c = chart_of(desk, &q);
	const struct chart_series *s = &c->series[c->n - 1];
	assert_non_null(s->low);
	for (size_t i = 0; i < s->n; i++)
		assert_true(s->low[i] <= s->y[i] && s->y[i] <= s->high[i]);
	chart_free(c);
}

/* Of another site beside, made now or kept from before. */
static void
a_second_site_has_a_curve_of_its_own(void **state)
{
	struct desk *desk = *state;
	struct session *s = desk->session;
	struct plot_request q = plots_request(PLOT_PSD);
	q.speed = 74;
	q.other_speed = 70;
	q.beside = "tierp";
	desk_expect(desk, PARAMS_SET);
	const struct entry *entry = session_entry(s);
	struct prediction kept =
	    outlook_predict(s, entry, 70, site_run_nearest(entry->site, 70));
	desk_expect(desk, "load data/sites/bro.csv");
	for (int way = 0; way < 2; way++) {
		struct chart *c = chart_of(desk, &q);
		size_t last = c->n - 1; /* bro has no parameters yet */
		assert_string_equal(c->series[last].name,
		    way == 0 ? "predicted tierp 70 m/s" : "pin tierp 70 m/s");
		assert_int_equal(c->series[last].n, kept.product.n);
		for (size_t i = 0; i < kept.product.n; i++)
			assert_true(fabs(c->series[last].y[i] -
					 100 * kept.product.passing[i]) < 1e-9);
		assert_int_equal(c->n_rule, 1);
		assert_memory_equal(c->rule[0].name, "tierp: break size ", 18);
		chart_free(c);
		q.kept = &kept;
	}
	/* What is kept outlives its site. */
	desk_expect(desk, "drop tierp");
	chart_free(chart_of(desk, &q));
	q.kept = NULL;
	assert_null(plots_chart(s, &q, &desk->error));
	prediction_free(&kept);
}

static void
what_is_missing_is_said(void **state)
{
	struct desk *desk = *state;
	for (int kind = PLOT_PARITY; kind < KINDS; kind++) {
		struct plot_request q = plots_request((enum plot_kind)kind);
		desk->error = (struct error){0};
		struct chart *c = plots_chart(desk->session, &q, &desk->error);
		assert_int_equal(c != NULL, kind == PLOT_MAP);
		if (c == NULL)
			assert_true(desk->error.text[0] != '\0' &&
				    desk->error.hint[0] != '\0');
		chart_free(c);
	}
}

/* An axis of one sieve, a feed that is all fines, a speed that breaks nothing. */
static void
odd_sheets_are_drawn(void **state)
{
	static const char *const products[] = {"8,100,100,100\n4,100,100,100\n",
	    "8,100,100,100\n", "8,100,100,100\n4,0,0,0\n"};
	struct desk *desk = *state;
	for (size_t i = 0; i < 3; i++) {
		char path[] = "/tmp/plots-XXXXXX";
		int fd = mkstemp(path);
		assert_true(fd >= 0);
		dprintf(
		    fd, "size_mm,feed,product@69,product@79\n%s", products[i]);
		close(fd);
		char *load = xasprintf("load %s", path);
		bool loaded = desk_say(desk, load);
		free(load);
		unlink(path);
		if (!loaded)
			continue;
		desk_expect(desk, PARAMS_SET);
		desk_expect(desk, "plot psd speed=1 other=200 width=50");
		desk_expect(desk, "plot residuals");
		desk_expect(desk, "plot selection speed=1");
		desk_expect(desk, "describe psd; describe selection speed=1");
	}
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test_setup_teardown(
		every_kind_fits_every_size, open_with_site, desk_close),
	    cmocka_unit_test_setup_teardown(
		no_two_series_look_alike, open_with_site, desk_close),
	    cmocka_unit_test_setup_teardown(
		every_sieve_of_the_sheet_is_a_tick, open_with_site, desk_close),
	    cmocka_unit_test_setup_teardown(
		a_running_search_shows_its_best_so_far, open_with_site,
		desk_close),
	    cmocka_unit_test_setup_teardown(
		a_generation_shows_its_own_best, open_with_site, desk_close),
	    cmocka_unit_test_setup_teardown(
		a_band_holds_the_prediction_of_a_fit, open_with_site,
		desk_close),
	    cmocka_unit_test_setup_teardown(
		a_second_site_has_a_curve_of_its_own, open_with_site,
		desk_close),
	    cmocka_unit_test_setup_teardown(
		what_is_missing_is_said, open_with_site, desk_close),
	    cmocka_unit_test_setup_teardown(
		odd_sheets_are_drawn, open_with_site, desk_close),
	};
	chdir_to_source();
	return cmocka_run_group_tests(tests, NULL, NULL);
}

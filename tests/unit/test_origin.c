/* Where data and parameters are from, wherever they go.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <string.h>

#include "cmd/ask/answers.h"
#include "cmd/ask/forecast.h"
#include "cmd/ask/outlook.h"
#include "cmd/ask/trust_light.h"
#include "desk.h"

/* Whether the newest results have the text, and the former ones forgotten. */
static bool
says(struct desk *desk, const char *line, const char *text)
{
	fflush(desk->out_file);
	size_t before = desk->n_out;
	desk_expect(desk, line);
	return strstr(desk->out + before, text) != NULL;
}

static void
data_are_what_the_sheet_says(void **state)
{
	(void)state;
	static const char *const KINDS[][2] = {{"", "not stated"},
	    {" ", "not stated"}, {"belt cuts of 3 May", "measured"},
	    {"measured", "measured"}, {"not made up at all", "measured"},
	    {"reconstructed from Table 3", "reconstructed"},
	    {"Made up, by hand", "made up"}, {"SIMULATED", "simulated"},
	    {"synthetic; seed 9", "synthetic"}};
	for (size_t i = 0; i < ARRAY_LEN(KINDS); i++)
		assert_string_equal(site_data_kind(KINDS[i][0]), KINDS[i][1]);
}

/* README's own sheet was told that it is not from a plant's sieves. */
static void
why_takes_the_sheet_at_its_word(void **state)
{
	struct desk *desk = *state;
	struct session *s = desk->session;
	desk_expect(desk, "load data/sites/tierp.csv; "
			  "params set f_mat=2 e0_min=16 alpha=1");
	assert_true(says(desk, "why", "not measured at a plant: recon"));
	char *own = session_current_site_entry(s)->site->provenance;
	session_current_site_entry(s)->site->provenance =
	    xstrdup("belt cuts of 3 May; wet");
	assert_true(says(desk, "why",
	    "The site file states the provenance of its data: belt cuts of "
	    "3 May."));
	assert_true(says(desk, "sites", "measured"));
	session_current_site_entry(s)->site->provenance[0] = '\0';
	assert_true(
	    says(desk, "why", "does not state where its data are from"));
	free(session_current_site_entry(s)->site->provenance);
	session_current_site_entry(s)->site->provenance = own;
}

static void
a_guess_beyond_its_materials_says_so(void **state)
{
	struct desk *desk = *state;
	desk_expect(desk, "load data/sites/tierp.csv");
	assert_true(says(desk, "guess speed=90", "90.0 m/s is outside"));
	assert_false(says(desk, "guess speed=74", "extrapolated"));
}

/* Tierp is calibrated, and Bro has its parameters. */
static void
use_of_another(struct desk *desk)
{
	desk_expect(desk, "load data/sites/tierp.csv data/sites/bro.csv; "
			  "use tierp; calibrate population=200; use bro; "
			  "params use tierp");
}

static void
parameters_keep_their_origin_in_use_by_another(void **state)
{
	struct desk *desk = *state;
	struct session *s = desk->session;
	use_of_another(desk);
	const struct entry *tierp = &s->entry[0],
			   *bro = session_current_site_entry(s);
	assert_string_equal(bro->origin->from, "tierp");
	assert_int_equal(bro->origin->n_speed, 2);
	assert_true(bro->origin->speed[1] == 79);
	assert_string_equal(bro->origin->provenance, tierp->site->provenance);
	assert_true(answers_is_speed_extrapolated(bro, 80));
	assert_false(answers_is_speed_extrapolated(bro, 70));
	assert_ptr_equal(posterior_even_if_correction_off(s, bro),
	    posterior_even_if_correction_off(s, tierp));
	/* From hand to hand they stay Tierp's. */
	desk_expect(desk, "load data/sites/umea.csv; params use bro");
	assert_string_equal(
	    session_current_site_entry(s)->origin->from, "tierp");
	assert_true(says(desk, "predict 90",
	    "parameters from tierp (trained at 69 and 79 m/s; reconstructed, "
	    "not"));
}

/* The band of one site was kept for the next that asked at the same speed. */
static void
a_shared_fit_has_a_band_for_each_site(void **state)
{
	struct desk *desk = *state;
	struct session *s = desk->session;
	use_of_another(desk);
	double low[2][2];
	for (int i = 0; i < 4; i++) {
		desk_expect(desk, i % 2 == 0 ? "use tierp; predict 74"
					     : "use bro; predict 74");
		const struct entry *entry = session_current_site_entry(s);
		struct prediction p = forecast_whole_product(
		    s, entry, 74, site_run_at_speed(entry->site, 74));
		assert_non_null(p.low);
		if (i < 2)
			low[i][0] = p.low[4];
		low[i % 2][1] = p.low[4];
		prediction_free(&p);
	}
	assert_true(low[0][0] == low[0][1] && low[1][0] == low[1][1]);
	assert_true(low[0][0] != low[1][0]);
}

/* The last band is kept: not for another feed at the same speed. */
static void
each_feed_has_its_own_band(void **state)
{
	struct desk *desk = *state;
	struct session *s = desk->session;
	desk_expect(desk, "synth data/table3.csv site=Umea seed=3; calibrate");
	const struct entry *entry = session_current_site_entry(s);
	for (size_t feed = 0; feed < entry->site->n_run; feed++) {
		struct prediction p =
		    forecast_whole_product(s, entry, 74, feed);
		for (size_t i = 0; i < p.product.n; i++)
			assert_true(p.low[i] <= p.product.passing[i] &&
				    p.product.passing[i] <= p.high[i]);
		prediction_free(&p);
	}
}

static void
undo_and_redo_carry_the_origin(void **state)
{
	struct desk *desk = *state;
	struct session *s = desk->session;
	use_of_another(desk);
	desk_expect(desk, "params set f_mat=1");
	assert_string_equal(
	    session_current_site_entry(s)->origin->words, "set by hand");
	assert_null(
	    posterior_even_if_correction_off(s, session_current_site_entry(s)));
	desk_expect(desk, "undo");
	assert_string_equal(
	    session_current_site_entry(s)->origin->from, "tierp");
	assert_non_null(
	    posterior_even_if_correction_off(s, session_current_site_entry(s)));
	desk_expect(desk, "undo");
	assert_null(session_current_site_entry(s)->origin);
	desk_expect(desk, "redo; drop tierp; predict 90");
	assert_string_equal(
	    session_current_site_entry(s)->origin->from, "tierp");
	/* Equal numbers of other origin are a change. */
	desk_expect(desk, "recall ubbarp; recall gasgruvan");
	assert_string_equal(
	    session_current_site_entry(s)->origin->from, "table3/gasgruvan");
	desk_expect(desk, "undo");
	assert_string_equal(
	    session_current_site_entry(s)->origin->from, "table3/ubbarp");
}

static void
a_fit_of_few_cells_is_not_judged(void **state)
{
	struct desk *desk = *state;
	struct session *s = desk->session;
	desk_expect(desk, "load data/sites/tierp.csv; "
			  "calibrate population=200 train=69");
	const struct entry *entry = session_current_site_entry(s);
	assert_int_equal(entry->fit.n_residual, 12);
	assert_int_equal(entry->fit.parameters, 7);
	assert_non_null(posterior_even_if_correction_off(s, entry));
	assert_int_equal(entry->fit.cells, 11);
	/* One passing more than parameters is enough, as many are not; that of
	 * the coarsest sieve is 100 % whatever is done. */
	struct run *run = entry->site->run;
	for (size_t n = 8; n >= 7; n--) {
		run[0].product.n = n + 1;
		desk_expect(desk, "calibrate population=200 train=69");
		assert_int_equal(entry->fit.n_residual, n + 1);
		assert_int_equal(entry->fit.cells, n);
		assert_int_equal(posterior_even_if_correction_off(
				     s, session_current_site_entry(s)) != NULL,
		    n > 7);
	}
	assert_string_equal(verdict_on_fit(entry, LIGHT_GREEN), "too few data");
	assert_false(desk_say(desk, "assert poor = 0"));
	assert_int_equal(desk->error.kind, ERROR_CHECK);
	desk_expect(desk, "bounds alpha 0.9; "
			  "calibrate population=200 train=69");
	assert_int_equal(entry->fit.parameters, 6);
	assert_true(says(desk, "predict", "low %"));
}

/* For the time of the command only, even where it fails. */
static void
another_feed_leaves_the_session_as_it_was(void **state)
{
	struct desk *desk = *state;
	static const char *const LINE[] = {
	    "predict 74 feed=data/sites/bro.csv@69 cascade=10",
	    "why 69 79 feed=data/sites/bro.csv@69 k=2",
	    "blend data/sites/bro.csv@69=1 data/sites/bro.csv@79=2",
	    "find p80=5 p50=2 feed=data/sites/bro.csv@69",
	    "predict 74 feed=nothing.csv"};
	desk_expect(desk, "load data/sites/tierp.csv");
	desk_expect(desk, "params set f_mat=2.18 e0_min=16.74 alpha=0.96");
	struct session *s = desk->session;
	const struct entry was = s->entry[0];
	desk_expect(desk, "predict 74");
	double own = session_number_in_last_answer(s, "predict", "p50_mm");
	for (size_t i = 0; i < ARRAY_LEN(LINE); i++) {
		assert_true(desk_say(desk, LINE[i]) == (i < 3));
		assert_memory_equal(&s->entry[0], &was, sizeof was);
		assert_int_equal(was.site->n_run, 3);
	}
	assert_true(fabs(session_number_in_last_answer(s, "predict", "p50_mm") -
			 own) > 1e-4);
	desk_expect(desk, "predict 74");
	assert_true(
	    session_number_in_last_answer(s, "predict", "p50_mm") == own);
}

static bool
at_once(void)
{
	return true;
}

/* Who judges an answer keeps the evidence while another part of the judgement
 * brings the draws to their end, which were stopped before. */
static void
evidence_stays_where_it_is(void **state)
{
	struct desk *desk = *state;
	struct session *s = desk->session;
	desk_expect(
	    desk, "load data/sites/tierp.csv; calibrate population=200");
	struct entry *entry = &s->entry[0];
	struct history *h = entry->origin->history;
	history_reset_posteriors(h, &s->set);
	s->hooks.stop = at_once;
	const struct evidence *e = trust_evidence_of_calibration(s, entry);
	assert_true(isnan(e->discrepancy));
	s->hooks.stop = NULL;
	assert_ptr_equal(trust_evidence_of_calibration(s, entry), e);
	assert_true(isfinite(e->discrepancy));
}

int
main(void)
{
#define at_desk(test) \
	cmocka_unit_test_setup_teardown(test, desk_open, desk_close)
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(data_are_what_the_sheet_says),
	    at_desk(why_takes_the_sheet_at_its_word),
	    at_desk(a_guess_beyond_its_materials_says_so),
	    at_desk(parameters_keep_their_origin_in_use_by_another),
	    at_desk(a_shared_fit_has_a_band_for_each_site),
	    at_desk(each_feed_has_its_own_band),
	    at_desk(another_feed_leaves_the_session_as_it_was),
	    at_desk(undo_and_redo_carry_the_origin),
	    at_desk(a_fit_of_few_cells_is_not_judged),
	    at_desk(evidence_stays_where_it_is),
	};
	chdir_to_source();
	return cmocka_run_group_tests(tests, NULL, NULL);
}

/* Jobs: stopping, going on, all sites at once, and that no way of driving one
 * changes a bit of its result.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "desk.h"
#include "often.h"
#include "paper.h"

#include <math.h>
#include <string.h>
#include <unistd.h>

#include "core/numeric/isa.h"
#include "core/check/validate.h"

static const char LOAD[] = "synth data/table3.csv site=Tierp seed=9";
/* Fewer to find, and sooner found. */
static const char HELD[] = "bounds f_mat 2.1; bounds e0_min 16; bounds alpha 1";
static const char SEARCH[] =
    "calibrate seed=3 population=600 generations=40 tolerance=0 stall=0";

static void
start(struct desk *desk, const char *line)
{
	size_t next = 0;
	desk->error = (struct error){0};
	assert_true(session_run_line(
	    desk->session, line, 0, "script.tip", 1, &next, &desk->error));
	assert_true(session_is_calibrating(desk->session));
}

static void
steps(struct desk *desk, int n)
{
	while (n-- > 0 && session_is_calibrating(desk->session))
		session_step_job(desk->session);
}

static void
expect_same(const struct fit *a, const struct fit *b)
{
	assert_memory_equal(&a->params, &b->params, sizeof a->params);
	assert_memory_equal(&a->misfit, &b->misfit, sizeof a->misfit);
	assert_int_equal(a->generations, b->generations);
	assert_int_equal(a->evaluations, b->evaluations);
	assert_int_equal(a->stop, b->stop);
}

/* The fit of an undisturbed search. */
static struct fit
whole(struct desk *desk)
{
	assert_true(desk_say(desk, SEARCH));
	return session_current_site_entry(desk->session)->fit;
}

static int
open_with_site(void **state)
{
	desk_open(state);
	assert_true(desk_say(*state, LOAD));
	return 0;
}

static void
a_stopped_calibration_goes_on_to_the_same_bits(void **state)
{
	struct desk *desk = *state;
	struct fit want = whole(desk);
	static const int at[] = {1, 15, 40, 43};
	for (size_t i = 0; i < ARRAY_LEN(at); i++) {
		/* Without a fit the stopped one is taken. */
		desk_expect(desk, "undo");
		start(desk, SEARCH);
		steps(desk, at[i]);
		session_stop_job_for_user(desk->session);
		assert_false(session_is_calibrating(desk->session));
		struct fit half =
		    session_current_site_entry(desk->session)->fit;
		assert_int_equal(half.stop, CALIBRATE_STOPPED);
		assert_true(half.misfit >= want.misfit);
		assert_true(desk_say(desk, "continue"));
		expect_same(
		    &session_current_site_entry(desk->session)->fit, &want);
	}
}

static void
threads_and_instruction_sets_change_no_bit(void **state)
{
	struct desk *desk = *state;
	struct fit want = whole(desk);
	for (unsigned i = 0; i < 5; i++) {
		desk->session->set.threads = i < 2 ? 2 + 6 * i : 1;
		desk->session->isa = i < 2 ? ISA_BEST : (enum isa)(i - 2);
		struct fit got = whole(desk);
		expect_same(&got, &want);
	}
}

static void
run_weights_pull_the_fit_to_a_run(void **state)
{
	struct desk *desk = *state;
	const struct entry *entry = session_current_site_entry(desk->session);
	double rmse[2];
	static const char *const lines[] = {
	    "calibrate seed=1 population=600 run_weights=100,1",
	    "calibrate seed=1 population=600 run_weights=1,100"};
	for (size_t i = 0; i < 2; i++) {
		assert_true(desk_say(desk, lines[i]));
		rmse[i] = validate_run(entry->site, 0, entry->train,
		    &entry->params, model_settings_default())
			      .rmse[VALIDATE_MODEL];
	}
	assert_true(rmse[0] < rmse[1]);
	assert_false(desk_say(desk, "calibrate run_weights=1,2,3"));
	assert_non_null(strstr(desk->error.text, "expected 2 numbers"));
}

/* RMSE at a run of what the site has been calibrated to. */
static double
rmse_at(struct desk *desk, size_t run)
{
	const struct entry *entry = session_current_site_entry(desk->session);
	return validate_run(entry->site, run, entry->train, &entry->params,
	    model_settings_default())
	    .rmse[VALIDATE_MODEL];
}

static void
each_speed_is_predicted_from_the_others(void **state)
{
	struct desk *desk = *state;
	struct session *s = desk->session;
	static const char *const lines[] = {"calibrate train=74,79",
	    "calibrate train=69,79", "calibrate train=69,74"};
	double largest = 0, sum = 0;
	desk_expect(desk, HELD);
	for (size_t run = 0; run < 3; run++) {
		assert_true(desk_say(desk, lines[run]));
		largest = fmax(largest, rmse_at(desk, run));
		sum += pow(rmse_at(desk, run), 2);
	}
	struct params before = session_current_site_entry(s)->params;
	assert_true(desk_say(desk, "validate holdout=each"));
	assert_memory_equal(
	    &session_current_site_entry(s)->params, &before, sizeof before);
	assert_true(session_number_in_last_answer(
			s, "validate", "holdout.rmse_pct") == 100 * largest);
	assert_true(fabs(session_number_in_last_answer(
			     s, "validate", "overall.rmse_pct") -
			 100 * sqrt(sum / 3)) < 1e-12);
	assert_true(session_current_site_entry(s)->train[0] &&
		    session_current_site_entry(s)->train[1]);
	assert_null(s->job.calibration);
}

static void
a_validation_needs_three_speeds_and_no_fit(void **state)
{
	struct desk *desk = *state;
	struct session *s = desk->session;
	desk_expect(desk, HELD);
	start(desk, "validate holdout=each");
	steps(desk, 5);
	session_stop_job_for_user(s);
	assert_false(session_is_calibrating(s) ||
		     session_current_site_entry(s)->has_params);
	assert_null(s->job.calibration);
	assert_false(desk_say(desk, "continue"));
	assert_true(desk_say(desk, "validate holdout=each"));
	assert_false(session_current_site_entry(s)->has_params);
	assert_true(
	    desk_say(desk, "synth data/table3.csv site=Bro speeds=69,79"));
	assert_false(desk_say(desk, "validate holdout=each"));
	assert_non_null(strstr(desk->error.text, "three or more speeds"));
	assert_true(desk_say(desk, "validate all holdout=each"));
	assert_true(session_number_in_last_answer(s, "validate", "sites") == 1);
	assert_true(session_number_in_last_answer(s, "validate", "runs") == 3);
	assert_false(desk_say(desk, "validate all"));
	assert_non_null(strstr(desk->error.text, "held-out run"));
}

static void
calibrated_sites_are_compared_step_by_step(void **state)
{
	struct desk *desk = *state;
	struct session *s = desk->session;
	desk_expect(desk, "synth data/table3.csv site=Bro");
	desk_expect(desk, "calibrate all population=100 generations=5");
	start(desk, "validate all");
	steps(desk, 1);
	assert_true(session_is_calibrating(s));
	session_stop_job_for_user(s);
	assert_false(session_is_calibrating(s));
	assert_non_null(strstr(desk->notes, "before all sites"));
	start(desk, "validate all");
	steps(desk, 2);
	assert_false(session_is_calibrating(s));
	assert_true(session_number_in_last_answer(s, "validate", "runs") == 2);
}

static void
a_paused_calibration_can_be_accepted(void **state)
{
	struct desk *desk = *state;
	start(desk, SEARCH);
	steps(desk, 5);
	session_stop_job_for_user(desk->session);
	struct fit half = session_current_site_entry(desk->session)->fit;
	assert_true(desk_say(desk, "accept"));
	expect_same(&session_current_site_entry(desk->session)->fit, &half);
	assert_false(desk_say(desk, "continue"));
	assert_non_null(strstr(desk->error.text, "no calibration"));
	assert_false(desk_say(desk, "accept"));
}

static void
a_pause_before_the_first_generation_keeps_nothing(void **state)
{
	struct desk *desk = *state;
	start(desk, SEARCH);
	session_stop_job_for_user(desk->session);
	assert_false(session_current_site_entry(desk->session)->has_fit);
	assert_false(desk_say(desk, "continue"));
}

static void
a_new_calibration_replaces_a_paused_one(void **state)
{
	struct desk *desk = *state;
	struct fit want = whole(desk);
	start(desk, "calibrate seed=8 population=600");
	steps(desk, 5);
	session_stop_job_for_user(desk->session);
	struct fit got = whole(desk);
	expect_same(&got, &want);
}

static void
all_sites_give_what_each_gives_alone(void **state)
{
	struct desk *desk = *state;
	struct session *s = desk->session;
	struct fit want = whole(desk);
	assert_true(desk_say(desk, "synth data/table3.csv site=Bro seed=9"));
	assert_true(desk_say(desk, "calibrate all seed=3 population=600 "
				   "generations=40 tolerance=0 stall=0"));
	expect_same(&s->entry[0].fit, &want);
	assert_true(s->entry[1].has_fit);
	fflush(s->out);
	assert_non_null(strstr(desk->out, "all sites, calibrated"));
	assert_non_null(strstr(desk->out, "  tierp "));
	assert_non_null(strstr(desk->out, "  bro "));
}

static void
the_paper_preset_is_another_search_without_polish(void **state)
{
	struct desk *desk = *state;
	struct fit best = whole(desk);
	assert_true(desk_say(desk, "calibrate preset=paper seed=3 "
				   "population=600 generations=40 "
				   "tolerance=0 stall=0"));
	const struct fit *plain =
	    &session_current_site_entry(desk->session)->fit;
	assert_int_equal(plain->evaluations, 600 * 40);
	assert_true(plain->misfit > best.misfit);
}

/* No stop but its tolerance, Table 2's bounds whatever the session's are; what a
 * polished search finds from the same options is said, and a search that ends
 * far above it is no good fit. */
static void
the_paper_preset_says_what_it_leaves(void **state)
{
	struct desk *desk = *state;
	assert_true(desk_say(desk, "bounds alpha 0.5"));
	assert_true(desk_say(desk, "calibrate preset=paper seed=3 "
				   "population=600 generations=120"));
	const struct fit *fit = &session_current_site_entry(desk->session)->fit;
	assert_int_equal(fit->generations, 120);
	assert_int_equal(fit->stop, CALIBRATE_GENERATIONS);
	assert_true(fit->params.at[PARAM_ALPHA] != 0.5);
	double lowest = fit->lowest, above = 100 * (fit->misfit / lowest - 1);
	char wanted[80];
	snprintf(wanted, sizeof wanted, "ends %.*f %% above the lowest misfit",
	    above < 10 ? 1 : 0, above);
	fflush(desk->session->out);
	assert_non_null(strstr(desk->out, wanted));
	assert_true(above > 10);
	assert_null(strstr(desk->out, "good fit"));
	assert_non_null(strstr(desk->out, "trust: amber: the search ended"));
	assert_true(desk_say(desk, "bounds default"));
	assert_true(desk_say(desk, "calibrate seed=3 population=600"));
	assert_true(fabs(fit->misfit / lowest - 1) < 1e-9);
	assert_true(fit->lowest == 0);
}

static void
a_flat_direction_raises_the_misfit_by_a_tenth(void **state)
{
	struct desk *desk = *state;
	assert_true(desk_say(desk, "calibrate seed=1"));
	const struct entry *entry = session_current_site_entry(desk->session);
	struct misfit *m = misfit_new(
	    entry->site, entry->train, NULL, false, model_settings_default());
	/* 0.2 of the way is 0.04 of the rise, to second order; the mean of both
	 * ways is so to third. */
	double rise = 0;
	for (int way = -1; way <= 1; way += 2) {
		struct params p = entry->fit.params;
		for (size_t j = 0; j < PARAM_COUNT; j++)
			p.at[j] += way * 0.2 * entry->fit.flat.part[j] *
				   (j < PARAM_F_MAT
					   ? 2
					   : PARAMS[j].upper - PARAMS[j].lower);
		rise += (misfit_of_params(m, &p) / entry->fit.misfit - 1) / 2;
	}
	if (!(fabs(rise - 0.004) < 0.0004))
		fail_msg("the misfit rises by %g of itself", rise);
	misfit_free(m);
}

/* Without them for every training run it is refused. */
static void
standard_deviations_weigh_when_asked_for(void **state)
{
	struct desk *desk = *state;
	const struct entry *entry = session_current_site_entry(desk->session);
	assert_false(desk_say(desk, "calibrate weights=sd"));
	assert_non_null(strstr(desk->error.text, "has none at 69 m/s"));
	for (size_t r = 0; r < entry->site->n_run; r++) {
		struct run *run = &entry->site->run[r];
		run->product_sd = xcalloc_doubles(run->product.n);
		for (size_t i = 0; i < run->product.n; i++)
			run->product_sd[i] = 0.004 + 0.001 * (double)i;
	}
	static const char *const lines[] = {
	    "calibrate population=600 weights=off",
	    "calibrate population=600 weights=sd"};
	for (size_t i = 0; i < 2; i++) {
		assert_true(desk_say(desk, lines[i]));
		struct misfit *m = misfit_new(entry->site, entry->train, NULL,
		    i == 1, model_settings_default());
		double misfit = misfit_of_params(m, &entry->fit.params);
		assert_true(fabs(entry->fit.misfit / misfit - 1) < 1e-6);
		misfit_free(m);
	}
}

static void
edited_bounds_are_told(void **state)
{
	struct desk *desk = *state;
	const struct entry *entry = session_current_site_entry(desk->session);
	whole(desk);
	assert_null(strstr(entry->options, "edited"));
	desk_expect(desk, "undo");
	entry = session_current_site_entry(desk->session);
	start(desk, SEARCH);
	steps(desk, 5);
	session_stop_job_for_user(desk->session);
	desk_expect(desk, "bounds f_mat 0.5..0.6; continue pause=9; "
			  "bounds f_mat 0.5..0.7; continue pause=12");
	assert_true(entry->fit.params.f_mat <= 0.7);
	assert_non_null(strstr(entry->options,
	    "; bounds edited after generation 9 and before; "
	    "bounds f_mat 0.5..0.7"));
}

/* While its light is drawn the search is over. */
static void
bounds_come_too_late_for_what_has_ended(void **state)
{
	struct desk *desk = *state;
	struct session *s = desk->session;
	start(desk, "calibrate population=600");
	while (
	    calibration_status(s->job.calibration).state < CALIBRATE_TOLERANCE)
		session_step_job(s);
	assert_true(session_is_calibrating(s));
	assert_int_equal(session_stop_job_for_user(s), STOPPED_TAKEN);
	struct fit want = session_current_site_entry(s)->fit;
	desk_expect(desk, "bounds e0_min 0..9; continue");
	expect_same(&session_current_site_entry(s)->fit, &want);
	assert_non_null(strstr(desk->notes, "begins within the edited"));
}

/* A line's notes, as one line. */
static const char *
noted(struct desk *desk, const char *line)
{
	size_t before = desk->n_notes;
	desk_expect(desk, line);
	for (char *p = desk->notes + before; *p != '\0'; p++)
		*p = *p == '\n' ? ' ' : *p;
	return desk->notes + before;
}

static void
a_stop_leaves_a_better_fit_until_it_is_accepted(void **state)
{
	struct desk *desk = *state;
	const struct entry *entry;
	static const char worse[] = "fit better",
			  line[] = "calibrate population=64 seed=3 pause=2";
	struct fit want = whole(desk);
	size_t printed = desk->n_out;
	const char *notes = noted(desk, line);
	assert_non_null(strstr(notes, worse));
	assert_non_null(strstr(notes, "'accept' takes the stopped ones"));
	assert_int_equal(desk->n_out, printed);
	expect_same(&session_current_site_entry(desk->session)->fit, &want);
	desk_expect(desk, "accept");
	entry = session_current_site_entry(desk->session);
	assert_int_equal(entry->fit.stop, CALIBRATE_STOPPED);
	assert_int_equal(entry->fit.generations, 2);
	assert_true(entry->fit.misfit > want.misfit);
	assert_true(desk->n_out > printed);
	desk_expect(desk, "undo");
	expect_same(&session_current_site_entry(desk->session)->fit, &want);
	/* One that goes on to its end was asked for. */
	notes = noted(desk, "calibrate population=64 seed=3 generations=3 "
			    "polish=off pause=2; continue");
	assert_non_null(strstr(notes, worse));
	entry = session_current_site_entry(desk->session);
	assert_int_equal(entry->fit.stop, CALIBRATE_GENERATIONS);
	assert_true(entry->fit.misfit > want.misfit);
	desk_expect(desk, "undo");
	expect_same(&session_current_site_entry(desk->session)->fit, &want);
	/* Without one the stopped best is better than nothing. */
	desk_expect(desk, "undo");
	notes = noted(desk, line);
	assert_null(strstr(notes, worse));
	assert_non_null(strstr(notes, "undo or calibrate again"));
	assert_true(session_current_site_entry(desk->session)->has_fit);
}

/* Better by what the calibration goes by, wherever the parameters are from. */
static void
what_is_better_is_said_by_the_job(void **state)
{
	struct desk *desk = *state;
	const struct session *s = desk->session;
	static const char worse[] = "fit better";
	desk_expect(desk, "params set f_mat=0.9 e0_min=20 alpha=0.5");
	assert_null(
	    strstr(noted(desk, "calibrate population=64 pause=5"), worse));
	assert_true(session_current_site_entry(desk->session)->has_fit);
	/* The fit of all runs, on the ends; of another model. */
	desk_expect(desk, "calibrate population=600 train=all");
	struct fit want = session_current_site_entry(desk->session)->fit;
	assert_non_null(
	    strstr(noted(desk, "calibrate population=64 pause=1"), worse));
	expect_same(&session_current_site_entry(desk->session)->fit, &want);
	assert_non_null(strstr(noted(desk, "set model vogel; calibrate "
					   "population=64 pause=1"),
	    worse));
	expect_same(&session_current_site_entry(desk->session)->fit, &want);
	assert_true(s->job.paused && s->job.held_back);
	/* With as many impacts that fit is nothing worth. */
	assert_null(strstr(noted(desk, "set model grunditz; set k 5; calibrate "
				       "population=600 pause=8"),
	    worse));
	assert_int_equal(session_current_site_entry(desk->session)->fit.stop,
	    CALIBRATE_STOPPED);
}

/* Sites that were done are; the one under way keeps what is better. */
static void
all_that_are_stopped_keep_a_better_fit(void **state)
{
	struct desk *desk = *state;
	struct session *s = desk->session;
	desk_expect(desk, "load data/sites/bro.csv; calibrate all "
			  "population=600");
	struct fit first = s->entry[0].fit, second = s->entry[1].fit;
	start(desk, "calibrate all population=64 generations=3 polish=off");
	while (s->job.entry == 0)
		session_step_job(s);
	steps(desk, 2);
	assert_int_equal(session_stop_job_for_user(s), STOPPED_WORSE);
	fflush(desk->notes_file);
	assert_non_null(strstr(desk->notes, "bro: stopped at generation 2"));
	assert_true(s->entry[0].fit.misfit > first.misfit);
	expect_same(&s->entry[1].fit, &second);
	assert_false(session_is_calibrating(s));
	assert_null(s->job.calibration);
}

/* What is named as poorly determined can be changed so: not past a bound, but
 * for its rounding. */
static void
a_step_is_named_that_the_bounds_allow(void **state)
{
	struct desk *desk = *state;
	static const double most[] = {12, 13, 14, 15, 16, 20, 30};
	size_t named = 0, one_way = 0;
	size_t stride = often(3, 1);
	for (size_t i = 0; i < ARRAY_LEN(most); i += stride) {
		char *line = xasprintf("bounds e0_min 8..%g; bounds alpha "
				       "0.9..1; calibrate population=200 "
				       "detail=on",
		    most[i]);
		size_t before = desk->n_out;
		desk_expect(desk, line);
		free(line);
		for (char *p = desk->out + before; *p != '\0'; p++)
			*p = *p == '\n' ? ' ' : *p;
		const char *step = strstr(desk->out + before, "e0_min by ");
		if (step == NULL)
			continue;
		const struct fit *fit =
		    &session_current_site_entry(desk->session)->fit;
		double by = strtod(step + strlen("e0_min by "), NULL);
		double x = fit->params.e0_min, room = 0.06 * fabs(by);
		bool both = strstr(step, "reverse") != NULL;
		assert_true(x + by >= 8 - room && x + by <= most[i] + room);
		assert_true(
		    !both || (x - by >= 8 - room && x - by <= most[i] + room));
		named++;
		one_way += !both;
	}
	assert_true(named > 0 && one_way > 0);
}

#define WITH_SITE(f) \
	cmocka_unit_test_setup_teardown(f, open_with_site, desk_close)

/* The job is gone, its generations are not; each site has its own. */
static void
the_generations_stay_with_their_site(void **state)
{
	struct desk *desk = *state;
	struct session *s = desk->session;
	desk_expect(desk, "load data/sites/bro.csv; bounds alpha 0.5..1; "
			  "calibrate population=64 generations=7 stall=0 "
			  "tolerance=0; bounds default");
	const struct history *h = session_current_site_entry(s)->history;
	assert_false(session_is_calibrating(s));
	assert_int_equal(h->n, 7);
	assert_true(h->bounds.lower[PARAM_ALPHA] == 0.5);
	for (size_t i = 1; i < h->n; i++)
		assert_true(h->generation[i].best <= h->generation[i - 1].best);
	assert_null(s->entry[0].history);
	desk_expect(desk, "params set f_mat=1; history; calibrate "
			  "population=64 generations=3; history");
	assert_int_equal(session_current_site_entry(s)->history->n, 3);
	desk_expect(desk, "undo; history");
	assert_int_equal(session_current_site_entry(s)->history->n, 7);
	s->current = 0;
	assert_false(desk_say(desk, "history"));
	assert_non_null(strstr(desk->error.text, "not been calibrated"));
}

/* Its models are no fits of the site, whether it ends or is stopped. */
static void
a_league_leaves_the_fit_alone(void **state)
{
	struct desk *desk = *state;
	struct session *s = desk->session;
	desk_expect(desk, HELD);
	struct fit want = whole(desk);
	start(desk, "league");
	steps(desk, 70);
	assert_true(session_is_calibrating(s));
	session_stop_job_for_user(s);
	assert_false(session_is_calibrating(s));
	assert_null(s->job.calibration);
	fflush(desk->notes_file);
	assert_non_null(
	    strstr(desk->notes, "stopped before all models were calibrated"));
	assert_true(
	    isnan(session_number_in_last_answer(s, "league", "can_tell")));
	expect_same(&session_current_site_entry(s)->fit, &want);
	assert_true(desk_say(desk, "league"));
	expect_same(&session_current_site_entry(s)->fit, &want);
	assert_true(
	    session_number_in_last_answer(s, "league", "can_tell") == 1);
	assert_false(desk_say(desk, "continue"));
}

static bool
stop_at_once(void)
{
	return true;
}

/* Neither half an answer nor an empty file takes the place of a whole one. */
static void
what_is_interrupted_shows_and_writes_nothing(void **state)
{
	static const char *const LINES[] = {"predict 74 > test-job.csv",
	    "advise > test-job.csv", "report > test-job.html", "predict 74",
	    "find p80=5"};
	struct desk *desk = *state;
	struct session *s = desk->session;
	whole(desk);
	desk_expect(desk, "set draw_seed 2"); /* none are drawn yet */
	size_t before = desk->n_out;
	for (size_t i = 0; i < ARRAY_LEN(LINES); i++) {
		s->hooks.stop = stop_at_once;
		assert_false(desk_say(desk, LINES[i]));
		s->hooks.stop = NULL;
		assert_int_equal(desk->error.kind, ERROR_STOPPED);
		fflush(desk->out_file);
		assert_int_equal(desk->n_out, before);
	}
	start(desk, "league > test-job.csv");
	steps(desk, 70);
	session_stop_job_for_user(s);
	desk_expect(desk, "predict 74");
	assert_int_not_equal(access("test-job.csv", F_OK), 0);
	assert_int_not_equal(access("test-job.html", F_OK), 0);
	desk_expect(desk, "set goal \"passing 2 = 30..36\"");
	s->hooks.stop = stop_at_once;
	assert_false(desk_say(desk, "describe psd > test-job.txt"));
	s->hooks.stop = NULL;
	assert_int_not_equal(access("test-job.txt", F_OK), 0);
	assert_non_null(strstr(desk->out + before, "80 % band"));
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
	    WITH_SITE(a_stopped_calibration_goes_on_to_the_same_bits),
	    WITH_SITE(threads_and_instruction_sets_change_no_bit),
	    WITH_SITE(run_weights_pull_the_fit_to_a_run),
	    WITH_SITE(each_speed_is_predicted_from_the_others),
	    WITH_SITE(a_validation_needs_three_speeds_and_no_fit),
	    WITH_SITE(calibrated_sites_are_compared_step_by_step),
	    WITH_SITE(a_paused_calibration_can_be_accepted),
	    WITH_SITE(a_pause_before_the_first_generation_keeps_nothing),
	    WITH_SITE(a_new_calibration_replaces_a_paused_one),
	    WITH_SITE(all_sites_give_what_each_gives_alone),
	    WITH_SITE(the_paper_preset_is_another_search_without_polish),
	    WITH_SITE(the_paper_preset_says_what_it_leaves),
	    WITH_SITE(a_flat_direction_raises_the_misfit_by_a_tenth),
	    WITH_SITE(standard_deviations_weigh_when_asked_for),
	    WITH_SITE(edited_bounds_are_told),
	    WITH_SITE(a_stop_leaves_a_better_fit_until_it_is_accepted),
	    WITH_SITE(bounds_come_too_late_for_what_has_ended),
	    WITH_SITE(what_is_better_is_said_by_the_job),
	    WITH_SITE(all_that_are_stopped_keep_a_better_fit),
	    WITH_SITE(a_step_is_named_that_the_bounds_allow),
	    WITH_SITE(the_generations_stay_with_their_site),
	    WITH_SITE(a_league_leaves_the_fit_alone),
	    WITH_SITE(what_is_interrupted_shows_and_writes_nothing),
	};
	chdir_to_source();
	return cmocka_run_group_tests(tests, NULL, NULL);
}

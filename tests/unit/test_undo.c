/* Every change can be taken back and done again; nothing else makes a step.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <string.h>
#include <unistd.h>

#include "cmd/session/settings.h"
#include "cmd/lang/table.h"
#include "cmd/session/invocation.h"
#include "cmd/session/undo.h"
#include "desk.h"

static int
open_with_sites(void **state)
{
	desk_open(state);
	desk_expect(*state, "load data/sites/bro.csv data/sites/tierp.csv");
	return 0;
}

static bool
is_as(const struct session *s, struct snapshot *then)
{
	bool same = !snapshot_differs(then, s);
	snapshot_free(then);
	return same;
}

static void
every_change_is_undone_and_done_again(void **state)
{
	struct desk *desk = *state;
	struct session *s = desk->session;
	static const char *const lines[] = {"use bro", "use tierp",
	    "params set f_mat=2 e0_min=16 alpha=1",
	    "calibrate population=64 generations=2",
	    "calibrate population=64 generations=3 train=69,74",
	    "calibrate all population=64 generations=2", "bounds alpha 0.5",
	    "bounds default", "set method classes", "set k 2 threads 3",
	    "set format csv csv semicolon", "set pager off", "timing on",
	    "seed 5", "load data/sites/gavle-4.csv data/sites/gavle-11.2.csv",
	    "synth data/table3.csv site=Bro", "load data/sites/tierp.csv",
	    "drop gavle/4", "drop tierp", "reset"};
	for (size_t i = 0; i < ARRAY_LEN(lines); i++) {
		struct snapshot *before = snapshot_take_session(s);
		size_t depth = undo_count_steps(s);
		desk_expect(desk, lines[i]);
		struct snapshot *after = snapshot_take_session(s);
		if (undo_count_steps(s) != depth + 1)
			fail_msg("%s made no step", lines[i]);
		desk_expect(desk, "undo");
		assert_non_null(strstr(desk->notes, lines[i]));
		if (!is_as(s, before))
			fail_msg("%s was not undone", lines[i]);
		desk_expect(desk, "redo");
		if (!is_as(s, after))
			fail_msg("%s was not done again", lines[i]);
	}
	while (undo_count_steps(s) > 0)
		desk_expect(desk, "undo");
	assert_int_equal(s->n_entry, 0);
	while (desk_say(desk, "redo"))
		;
	assert_string_equal(desk->error.text, "nothing to redo");
	assert_int_equal(undo_count_steps(s), ARRAY_LEN(lines) + 1);
}

static void
what_changes_nothing_makes_no_step(void **state)
{
	struct desk *desk = *state;
	desk_expect(desk, "params set f_mat=2 e0_min=16 alpha=1");
	size_t depth = undo_count_steps(desk->session);
	desk_expect(desk, "predict 74; sweep 70..75; show; sites; set; seed; "
			  "params; bounds; use tierp; seed 1; echo a; check");
	assert_false(desk_say(desk, "bounds alpha 3..1"));
	assert_false(desk_say(desk, "set level=90 goal=nonsense"));
	assert_false(desk_say(desk, "set level=90 energy=none.csv"));
	assert_false(desk_say(desk, "use nobody"));
	assert_int_equal(undo_count_steps(desk->session), depth);
}

static void
a_hundred_steps_can_be_undone(void **state)
{
	struct desk *desk = *state;
	for (int i = 0; i < 500; i++) {
		char *line = xasprintf("seed %d", 1000 + i);
		desk_expect(desk, line);
		free(line);
	}
	for (int i = 0; i < 100; i++)
		desk_expect(desk, "undo");
	assert_int_equal(desk->session->set.seed, 1399);
	while (desk_say(desk, "undo"))
		;
	assert_string_equal(desk->error.text, "nothing to undo");
	assert_true(desk->session->set.seed < 1399);
}

static void
a_new_change_empties_redo(void **state)
{
	struct desk *desk = *state;
	desk_expect(desk, "seed 2; seed 3; undo; seed");
	desk_expect(desk, "redo; undo; seed 4");
	assert_false(desk_say(desk, "redo"));
	desk_expect(desk, "undo");
	assert_int_equal(desk->session->set.seed, 2);
}

/* The pager and the clock were outside: undo then took back what was before. */
static void
undo_takes_back_the_newest_setting(void **state)
{
	struct desk *desk = *state;
	desk_expect(desk, "seed 7; set pager off; undo");
	assert_int_equal(desk->session->set.seed, 7);
	assert_int_equal(desk->session->set.unpaged, 0);
	desk_expect(desk, "set pager off; timing on; reset");
	assert_int_equal(desk->session->set.unpaged, 0);
	assert_false(desk->session->set.timing);
}

static void
expect_setting(const struct desk *desk, const struct command_option *row,
    const char *want, const char *after)
{
	char *text = settings_value_text(row, &desk->session->set);
	if (strcmp(text, want) != 0)
		fail_msg("%s is %s after %s", row->name, text, after);
	free(text);
}

/* A value of a setting that is not its first. */
static char *
other_value(const struct command_option *o)
{
	switch (o->kind) {
	case VALUE_CHOICE:
		return xstrdup(strrchr(option_choices(o), ' ') + 1);
	case VALUE_FILE:
		return xstrdup("data/energy/vsi-79.csv");
	case VALUE_NUMBERS:
		return xasprintf("%g..%g", o->least, o->most);
	case VALUE_TEXT:
		return xstrdup(strcmp(o->name, "goal") == 0 ? "p80=5" : "p50");
	default:
		return xasprintf("%g", o->most);
	}
}

/* What is of the looks only is no change that is undone. */
static void
every_setting_is_set_undone_and_reset(void **state)
{
	struct desk *desk = *state;
	desk_expect(desk, "version");
	for (const struct command_option *r = SETTINGS; r->name != NULL; r++) {
		const struct command_option *o = r;
		char *first = settings_value_text(r, desk->session->initial);
		char *other = other_value(o);
		char *line = xasprintf("set %s %s", o->name, other);
		assert_string_not_equal(first, other);
		desk_expect(desk, line);
		expect_setting(desk, r, other, "set");
		if (!r->looks) {
			desk_expect(desk, "undo");
			expect_setting(desk, r, first, "undo");
			desk_expect(desk, "redo");
			expect_setting(desk, r, other, "redo");
		}
		desk_expect(desk, "reset");
		expect_setting(desk, r, first, "reset");
		if (o->fallback[0] != '\0')
			assert_string_equal(o->fallback, first);
		free(first);
		free(other);
		free(line);
	}
}

static void
a_load_that_fails_half_way_is_one_step(void **state)
{
	struct desk *desk = *state;
	struct snapshot *before = snapshot_take_session(desk->session);
	assert_false(desk_say(desk, "load data/sites/ubbarp.csv none.csv"));
	assert_int_equal(desk->session->n_entry, 3);
	desk_expect(desk, "undo");
	assert_true(is_as(desk->session, before));
}

static void
undo_gives_back_the_former_fit(void **state)
{
	struct desk *desk = *state;
	desk_expect(desk, "calibrate seed=1 population=64 generations=3");
	struct fit first = session_current_site_entry(desk->session)->fit;
	desk_expect(desk, "calibrate seed=2 population=64 generations=3");
	assert_false(fits_are_equal(
	    &session_current_site_entry(desk->session)->fit, &first));
	desk_expect(desk, "undo");
	assert_true(fits_are_equal(
	    &session_current_site_entry(desk->session)->fit, &first));
	assert_non_null(strstr(desk->notes, "undone: calibrate seed=2"));
}

/* However often it was stopped, a fit is one step; bounds edited on the way are
 * one of their own. */
static void
a_continued_fit_is_one_step(void **state)
{
	struct desk *desk = *state;
	struct session *s = desk->session;
	size_t depth = undo_count_steps(s);
	desk_expect(desk, "calibrate population=64 generations=30 pause=3; "
			  "continue pause=5; predict 74; continue");
	size_t done = session_current_site_entry(s)->fit.generations;
	assert_int_equal(undo_count_steps(s), depth + 1);
	desk_expect(desk, "undo");
	assert_non_null(strstr(desk->notes, "undone: calibrate"));
	assert_false(session_current_site_entry(s)->has_fit);
	desk_expect(desk, "redo");
	assert_int_equal(session_current_site_entry(s)->fit.generations, done);
	desk_expect(desk, "undo; calibrate population=64 pause=3; "
			  "bounds alpha 0.8..1; continue pause=5");
	assert_int_equal(undo_count_steps(s), depth + 3);
}

/* It goes on only where its site and the fit it left are still there. */
static void
undo_lets_go_of_a_stopped_calibration(void **state)
{
	struct desk *desk = *state;
	desk_expect(desk, "calibrate population=64 generations=9 pause=3; "
			  "seed 3; use bro; undo; undo; continue; undo; seed");
	assert_false(desk_say(desk, "continue"));
	assert_int_equal(
	    session_current_site_entry(desk->session)->fit.generations, 3);
	static const char *const gone[] = {
	    "undo; undo", "drop tierp", "load data/sites/tierp.csv", "reset"};
	for (size_t i = 0; i < ARRAY_LEN(gone); i++) {
		desk_expect(desk, "reset; load data/sites/tierp.csv; seed 3; "
				  "calibrate population=64 pause=3");
		desk_expect(desk, gone[i]);
		if (desk_say(desk, "continue"))
			fail_msg("went on after %s", gone[i]);
		assert_non_null(strstr(desk->notes, "it cannot be continued"));
	}
}

/* A worse one that was stopped left everything as it was. */
static void
undo_discards_a_stopped_calibration_that_was_held_back(void **state)
{
	struct desk *desk = *state;
	struct session *s = desk->session;
	desk_expect(desk, "calibrate population=64; "
			  "calibrate population=64 seed=2 pause=1");
	struct fit fit = session_current_site_entry(s)->fit;
	size_t steps = undo_count_steps(s);
	desk_expect(desk, "undo");
	assert_non_null(strstr(desk->notes, "it cannot be continued"));
	assert_true(fits_are_equal(&session_current_site_entry(s)->fit, &fit));
	assert_int_equal(undo_count_steps(s), steps);
	desk_expect(desk, "calibrate population=64 seed=2 pause=1; seed 3; "
			  "undo; undo; undo");
	assert_false(session_current_site_entry(s)->has_fit);
}

/* As a driver may do between two steps. */
static void
undo_ends_a_running_calibration(void **state)
{
	struct desk *desk = *state;
	struct session *s = desk->session;
	const char *line = "calibrate population=64 generations=9";
	size_t next;
	desk_expect(desk, "seed 3");
	size_t depth = undo_count_steps(s), lines = journal_current_place(s).n;
	assert_true(session_run_line(s, line, 0, "x", 1, &next, &desk->error));
	session_step_job(s);
	assert_true(
	    session_run_line(s, "seed", 0, "x", 1, &next, &desk->error));
	assert_true(
	    session_run_line(s, "undo", 0, "x", 1, &next, &desk->error));
	assert_false(session_is_calibrating(s));
	assert_int_equal(s->set.seed, 1);
	assert_false(session_current_site_entry(s)->has_fit);
	assert_true(session_end_finished_commands(s, true, &desk->error));
	assert_int_equal(undo_count_steps(s), depth - 1);
	/* What was asked since "seed 3" went with it. */
	assert_int_equal(journal_current_place(s).n, lines - 1);
}

static void
undo_forgets_the_answers(void **state)
{
	struct desk *desk = *state;
	desk_expect(desk, "params set f_mat=2 e0_min=16 alpha=1; predict 74; "
			  "assert p50 > 0; params set f_mat=1; predict; undo");
	assert_false(desk_say(desk, "assert p50 > 0"));
}

/* As the keys of screens that a script draws do, whose lines make no step. */
static void
steps_within_lines_that_make_none_push_out_the_oldest(void **state)
{
	struct desk *desk = *state;
	struct session *s = desk->session;
	enum { MANY = 1000 };
	size_t deepest = 0;
	for (int i = 0; i < MANY; i++) {
		size_t depth = undo_count_steps(s);
		undo_push_step(
		    s, snapshot_take_session(s), depth, depth, "pin");
		deepest = depth > deepest ? depth : deepest;
	}
	assert_int_equal(undo_count_steps(s), deepest);
	while (undo_count_steps(s) > 1)
		assert_string_equal(undo_last_step(s), "pin");
}

int
main(void)
{
#define at_desk(test) \
	cmocka_unit_test_setup_teardown(test, open_with_sites, desk_close)
	const struct CMUnitTest tests[] = {
	    at_desk(every_change_is_undone_and_done_again),
	    at_desk(what_changes_nothing_makes_no_step),
	    at_desk(a_hundred_steps_can_be_undone),
	    at_desk(a_new_change_empties_redo),
	    at_desk(undo_takes_back_the_newest_setting),
	    at_desk(every_setting_is_set_undone_and_reset),
	    at_desk(a_load_that_fails_half_way_is_one_step),
	    at_desk(undo_gives_back_the_former_fit),
	    at_desk(a_continued_fit_is_one_step),
	    at_desk(undo_lets_go_of_a_stopped_calibration),
	    at_desk(undo_discards_a_stopped_calibration_that_was_held_back),
	    at_desk(undo_ends_a_running_calibration),
	    at_desk(undo_forgets_the_answers),
	    at_desk(steps_within_lines_that_make_none_push_out_the_oldest),
	};
	chdir_to_source();
	return cmocka_run_group_tests(tests, NULL, NULL);
}

/* A session as a script sees it: sites by name, errors with their place, jobs,
 * and what is left after an error.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <unistd.h>

#include "call.h"
#include "desk.h"
#include "paper.h"
#include "made.h"

#include "cmd/lang/command.h"
#include "cmd/session/files.h"
#include "cmd/session/sites.h"
#include "cmd/fit/job.h"
#include "io/store/material.h"

/* A row of Table 3 under its own name. */
static void
add(struct desk *desk, size_t row)
{
	struct site *site = made_site(&TABLE_3[row], 0.005, 9);
	free(site->name);
	site->name = xstrdup(TABLE_3[row].site);
	session_add_site(desk->session, site);
}

enum { BORLANGE = 1, OSSJO = 5, GAVLE_4 = 9, GAVLE = 10, GAVLE_2 = 11 };

static bool
find(struct desk *desk, const char *name, size_t *index)
{
	return session_find_site(desk->session, name, index, &desk->error);
}

static void
sites_are_found_without_case_and_accents(void **state)
{
	struct desk *desk = *state;
	static const struct {
		const char *name;
		size_t index;
	} names[] = {{"borlange", 0}, {"BORLÄNGE", 0}, {"Borlänge", 0},
	    {"Össjö", 1}, {"ossjo", 1}, {"ÖSSJÖ", 1}, {"gåsgruvan", 2},
	    {"Gasgruvan", 2}, {"borlange/11.2", 0}, {"ossjo/4", 1}};
	add(desk, BORLANGE);
	add(desk, OSSJO);
	add(desk, 18);
	for (size_t i = 0; i < ARRAY_LEN(names); i++) {
		size_t index = 99;
		assert_true(find(desk, names[i].name, &index));
		assert_int_equal(index, names[i].index);
	}
}

/* Names in letters other than Latin ones, or in none at all. */
static void
sites_of_any_name_have_keys_of_their_own(void **state)
{
	struct desk *desk = *state;
	static const char *const names[] = {
	    "採石場", "محجر", "Łódź", "→", "→ 2"};
	static const char *const keys[] = {
	    "採石場", "محجر", "lodz", "unnamed", "2"};
	for (size_t i = 0; i < ARRAY_LEN(names); i++) {
		struct site *site = made_site(&TABLE_3[0], 0.005, 9);
		free(site->name);
		site->name = xstrdup(names[i]);
		session_add_site(desk->session, site);
		assert_string_equal(desk->session->entry[i].key, keys[i]);
	}
	for (size_t i = 0; i < ARRAY_LEN(names); i++) {
		size_t index = 99;
		assert_true(find(desk, names[i], &index));
		assert_int_equal(index, i);
		assert_true(find(desk, keys[i], &index));
		assert_int_equal(index, i);
	}
}

/* The key of a site is its name, underscores and all; who types '-' for one
 * reaches it where no other site has that name. */
static void
an_underscore_stays_in_a_key(void **state)
{
	struct desk *desk = *state;
	static const char *const names[] = {"Wash_plant 2", "pit_3", "pit-3"};
	static const char *const keys[] = {"wash_plant-2", "pit_3", "pit-3"};
	size_t index = 99;
	for (size_t i = 0; i < ARRAY_LEN(names); i++) {
		struct site *site = made_site(&TABLE_3[0], 0.005, 9);
		free(site->name);
		site->name = xstrdup(names[i]);
		session_add_site(desk->session, site);
		assert_string_equal(desk->session->entry[i].key, keys[i]);
		assert_true(find(desk, keys[i], &index));
		assert_int_equal(index, i);
	}
	assert_true(find(desk, "pit_3", &index));
	assert_int_equal(index, 1);
	assert_true(find(desk, "wash-plant-2", &index));
	assert_int_equal(index, 0);
}

static void
an_unknown_site_lists_what_is_loaded(void **state)
{
	struct desk *desk = *state;
	size_t index = 99;
	assert_false(find(desk, "bro", &index));
	assert_non_null(strstr(desk->error.hint, "load"));
	add(desk, BORLANGE);
	add(desk, OSSJO);
	assert_false(find(desk, "bro", &index));
	assert_int_equal(desk->error.kind, ERROR_USAGE);
	assert_non_null(strstr(desk->error.text, "'bro'"));
	assert_non_null(strstr(desk->error.hint, "borlange, ossjo"));
	assert_int_equal(index, 99);
}

static void
an_ambiguous_name_lists_the_keys(void **state)
{
	struct desk *desk = *state;
	size_t index;
	add(desk, GAVLE_4);
	add(desk, GAVLE);
	add(desk, GAVLE_2);
	assert_false(find(desk, "Gävle", &index));
	assert_non_null(strstr(desk->error.text, "'Gävle'"));
	for (size_t i = 0; i < 3; i++)
		assert_non_null(
		    strstr(desk->error.hint, desk->session->entry[i].key));
	assert_true(find(desk, "gävle/4", &index));
	assert_int_equal(index, 0);
	assert_true(find(desk, "gavle/11.2/2", &index));
	assert_int_equal(index, 2);
}

/* Whatever is loaded, each site can be reached by the key that lists it. */
static void
every_key_reaches_its_site(void **state)
{
	struct desk *desk = *state;
	add(desk, GAVLE);
	add(desk, GAVLE_2);
	add(desk, GAVLE_4);
	add(desk, GAVLE);
	add(desk, TIERP);
	add(desk, TIERP);
	for (int i = 0; i < 2; i++) { /* sheets that state no top size */
		struct site *site = made_site(&TABLE_3[0], 0, 1);
		site->top_size = 0;
		session_add_site(desk->session, site);
	}
	for (size_t i = 0; i < desk->session->n_entry; i++) {
		const char *key = desk->session->entry[i].key;
		size_t index = 99;
		if (!find(desk, key, &index))
			fail_msg("use %s: %s (%s)", key, desk->error.text,
			    desk->error.hint);
		assert_int_equal(index, i);
	}
}

static void
a_use_that_fails_changes_nothing(void **state)
{
	struct desk *desk = *state;
	add(desk, GAVLE_4);
	add(desk, GAVLE);
	add(desk, TIERP);
	desk_expect(desk, "use tierp");
	assert_false(desk_say(desk, "use bro"));
	assert_int_equal(desk->session->current, 2);
	assert_false(desk_say(desk, "use gavle"));
	assert_int_equal(desk->session->current, 2);
}

static void
commands_that_need_a_site_say_so(void **state)
{
	struct desk *desk = *state;
	size_t n = 0;
	for (const struct command *c = NULL; (c = command_next(c)) != NULL;) {
		if (!(c->flags & COMMAND_NEEDS_SITE))
			continue;
		char *line =
		    xasprintf("seed 1; %s %s", c->name, call_operands(c));
		assert_false(desk_say(desk, line));
		assert_int_equal(desk->error.kind, ERROR_USAGE);
		assert_non_null(strstr(desk->error.text, c->name));
		assert_non_null(strstr(desk->error.text, "site"));
		assert_non_null(strstr(desk->error.hint, "load"));
		assert_string_equal(desk->error.file, "script.tip");
		assert_int_equal(desk->error.line, 12);
		assert_int_equal(desk->error.column, 9);
		free(line);
		n++;
	}
	assert_true(n >= 8);
}

/* Without a site and with nonsense they succeed or are refused; the nonsense is
 * in a folder that is not there, so that no file is written. */
static void
all_other_commands_do_without_one(void **state)
{
	struct desk *desk = *state;
	for (const struct command *c = NULL; (c = command_next(c)) != NULL;) {
		if ((c->flags & COMMAND_NEEDS_SITE) ||
		    strcmp(c->name, "tui") == 0 ||
		    strcmp(c->name, "screen") == 0)
			continue;
		char *line = xasprintf("%s%s", c->name,
		    c->operands.least == 1  ? " none/none"
		    : c->operands.least > 1 ? " 1 = 1"
					    : "");
		if (!desk_say(desk, line))
			assert_true(desk->error.text[0] != '\0');
		desk->session->quit = false;
		free(line);
	}
	assert_int_equal(desk->session->n_entry, 0);
}

static void
errors_carry_file_line_and_column(void **state)
{
	struct desk *desk = *state;
	static const struct {
		const char *line;
		int column;
	} rows[] = {{"seed 1; seed x", 14}, {"use tierp; foo", 12},
	    {"use åäö", 1}, {"use tierp; predict 74", 12},
	    {"use tierp; predict åäö", 20}, {"  bounds f 1", 3},
	    {"use tierp; params set alpha=1", 12}};
	add(desk, TIERP);
	for (size_t i = 0; i < ARRAY_LEN(rows); i++) {
		assert_false(desk_say(desk, rows[i].line));
		assert_string_equal(desk->error.file, "script.tip");
		assert_int_equal(desk->error.line, 12);
		if (desk->error.column != rows[i].column)
			fail_msg(
			    "%s: column %d", rows[i].line, desk->error.column);
	}
}

static void
a_faulty_sheet_is_told_by_its_own_place(void **state)
{
	struct desk *desk = *state;
	char path[] = "/tmp/tipspeed-test-XXXXXX";
	int fd = mkstemp(path);
	FILE *file = fdopen(fd, "w");
	assert_non_null(file);
	fputs("size_mm,feed,product@69,product@79\n8,100,x,100\n4,60,80,y\n",
	    file);
	fclose(file);
	char *line = xasprintf("seed 3; load %s", path);
	assert_false(desk_say(desk, line));
	fflush(desk->notes_file);
	assert_int_equal(desk->error.kind, ERROR_DATA);
	assert_string_equal(desk->error.file, path);
	/* Each fault once: in the notes or as the error. */
	char *places[] = {
	    xasprintf("%s:2:7:", path), xasprintf("%s:3:6:", path)};
	for (int i = 0; i < 2; i++) {
		bool noted = strstr(desk->notes, places[i]) != NULL;
		assert_true(noted != (desk->error.line == 2 + i));
		free(places[i]);
	}
	assert_int_equal(desk->session->n_entry, 0);
	unlink(path);
	assert_false(desk_say(desk, line));
	assert_int_equal(desk->error.kind, ERROR_SYSTEM);
	free(line);
}

static void
a_line_stops_at_its_first_error(void **state)
{
	struct desk *desk = *state;
	assert_false(desk_say(desk, "seed 5; foo; seed 6"));
	assert_int_equal(desk->session->set.seed, 5);
	desk_expect(desk, "seed 7; quit; seed 8");
	assert_int_equal(desk->session->set.seed, 7);
	assert_true(desk->session->quit);
}

static void
a_session_survives_errors(void **state)
{
	struct desk *desk = *state;
	static const char *const wrong[] = {"foo", "predict", "use none",
	    "set method x", "bounds f_mat 3..1", "bounds f_mat", "load",
	    "load /nonexistent/x.csv", "params set f_mat=1", "params throw",
	    "show it", "write /nonexistent/x.csv", "calibrate train=71",
	    "synth /nonexistent", "validate", "sweep 85..65", "help zzz",
	    "use \"", "predict feed=74"};
	add(desk, TIERP);
	desk_expect(desk, "seed 4; set k 2; bounds alpha 0.5..0.9");
	for (size_t i = 0; i < ARRAY_LEN(wrong); i++) {
		if (desk_say(desk, wrong[i]))
			fail_msg("accepted: %s", wrong[i]);
		assert_true(desk->error.kind != ERROR_NONE);
		assert_true(desk->error.text[0] != '\0');
	}
	assert_int_equal(desk->session->set.seed, 4);
	assert_true(desk->session->set.model.k == 2);
	assert_true(desk->session->set.bounds.lower[PARAM_ALPHA] == 0.5);
	assert_int_equal(desk->session->n_entry, 1);
	assert_false(session_current_site_entry(desk->session)->has_params);
	desk_expect(desk, "set k 1; bounds default; "
			  "params set f_mat=2.18 e0_min=16.74 alpha=0.96; "
			  "predict 74 detail=on; validate");
	assert_non_null(strstr(desk->out, "4.94"));
}

static void
a_calibration_is_a_job_in_the_midst_of_a_line(void **state)
{
	struct desk *desk = *state;
	struct session *s = desk->session;
	const char *line = "calibrate population=64 generations=3 seed=5; "
			   "seed 9";
	size_t next = 0;
	add(desk, TIERP);
	assert_true(session_run_line(s, line, 0, "x", 1, &next, &desk->error));
	assert_true(session_is_calibrating(s) && s->set.seed == 1);
	assert_string_equal(line + next, " seed 9");
	while (session_is_calibrating(s))
		session_step_job(s);
	const struct entry *entry = session_current_site_entry(s);
	assert_true(entry->has_fit && entry->has_params);
	assert_int_equal(entry->fit.seed, 5);
	assert_memory_equal(
	    &entry->fit.params, &entry->params, sizeof entry->params);
	assert_true(
	    session_run_line(s, line, next, "x", 1, &next, &desk->error));
	assert_true(s->set.seed == 9 && next == 0);
	desk_expect(desk, "predict 74; params set f_mat=1");
	assert_false(session_current_site_entry(s)->has_fit);
	assert_true(session_current_site_entry(s)->params.f_mat == 1);
}

static void
a_stopped_job_is_kept_or_dropped(void **state)
{
	struct desk *desk = *state;
	struct session *s = desk->session;
	size_t next;
	add(desk, TIERP);
	for (int keep = 0; keep < 2; keep++) {
		assert_true(session_run_line(s, "calibrate population=64", 0,
		    "x", 1, &next, &desk->error));
		session_step_job(s);
		session_step_job(s);
		if (keep == 1)
			session_stop_job_for_user(s);
		else
			session_abort_job(s);
		assert_false(session_is_calibrating(s));
		assert_true(
		    session_current_site_entry(s)->has_fit == (keep == 1));
	}
	const struct fit *fit = &session_current_site_entry(s)->fit;
	assert_int_equal(fit->stop, CALIBRATE_STOPPED);
	assert_int_equal(fit->generations, 2);
}

/* A file that is read again is the same use of it, at a later time. */
static void
a_file_that_is_read_twice_is_noted_once(void **state)
{
	struct desk *desk = *state;
	struct session *s = desk->session;
	const char *path = "Makefile";
	uint64_t digest, found;
	assert_true(files_compute_digest(path, &digest));
	files_record_read(s, path);
	files_record_written(s, path);
	files_record_read(s, path);
	assert_int_equal(files_count_all_uses(s), 3);
	assert_null(files_path_of_nth_read(s, 0, &found));
	assert_null(files_path_of_nth_read(s, 1, &found));
	assert_string_equal(files_path_of_nth_read(s, 2, &found), path);
	assert_true(found == digest);
}

/* The seed of a result is the seed that was given, to the last digit. */
static void
the_seed_in_json_is_the_seed_given(void **state)
{
	struct desk *desk = *state;
	static const char *const seeds[] = {"1", "9007199254740993",
	    "9223372036854775807", "9223372036854775808",
	    "18000000000000000000"};
	add(desk, TIERP);
	desk_expect(desk, "set format json");
	for (size_t i = 0; i < ARRAY_LEN(seeds); i++) {
		char *line = xasprintf("calibrate population=8 generations=1 "
				       "polish=off seed=%s",
		    seeds[i]);
		char *wanted = xasprintf("\"seed\":%s,", seeds[i]);
		/* Refused is well, too. */
		if (desk_say(desk, line) && strstr(desk->out, wanted) == NULL)
			fail_msg("no %s", wanted);
		free(line);
		free(wanted);
	}
}

/* Either it sets or it is refused. */
static void
parameters_without_set_are_not_passed_over(void **state)
{
	struct desk *desk = *state;
	add(desk, TIERP);
	desk_expect(desk, "params set f_mat=1 e0_min=10 alpha=1");
	bool ok = desk_say(desk, "params f_mat=2");
	assert_true(
	    !ok ||
	    session_current_site_entry(desk->session)->params.f_mat == 2);
	ok = desk_say(desk, "params list f_mat=2");
	assert_true(
	    !ok ||
	    session_current_site_entry(desk->session)->params.f_mat == 2);
}

static void
expect_limits(struct desk *desk, const struct param_info *info, double v)
{
	char *bounds = xasprintf("bounds %s %.9g", info->name, v);
	char *set = xasprintf("params set %s=%.9g", info->name, v);
	bool inside = v >= info->least && v <= info->most;
	assert_int_equal(desk_say(desk, bounds), inside);
	assert_int_equal(desk_say(desk, set), inside);
	free(bounds);
	free(set);
}

/* What bounds, params set, the store and its sheets take of a parameter was
 * once four opinions. */
static void
every_command_has_the_same_limits_of_a_parameter(void **state)
{
	struct desk *desk = *state;
	static const double beyond[] = {-1.001, 0, 1, 1.001};
	add(desk, TIERP);
	for (size_t m = 0; m < breakage_count_models(); m++) {
		const struct breakage *of = BREAKAGES[m];
		char *first = xasprintf("set model %s; params set", of->name);
		for (size_t j = 0; j < of->n; j++)
			xappend(&first, " %s=%.9g", of->parameter[j].name,
			    of->parameter[j].most);
		desk_expect(desk, first);
		free(first);
		for (size_t j = 0; j < of->n; j++)
			for (size_t i = 0; i < ARRAY_LEN(beyond); i++)
				expect_limits(desk, &of->parameter[j],
				    beyond[i] * of->parameter[j].most);
	}
	desk_expect(desk, "bounds default");
	assert_false(desk_say(desk, "bounds alpha 0..500"));
	assert_string_equal(desk->error.text,
	    "expected bounds of alpha from 0 to 100, got 0..500");
}

int
main(void)
{
#define at_desk(test) \
	cmocka_unit_test_setup_teardown(test, desk_open, desk_close)
	const struct CMUnitTest tests[] = {
	    at_desk(sites_are_found_without_case_and_accents),
	    at_desk(sites_of_any_name_have_keys_of_their_own),
	    at_desk(an_underscore_stays_in_a_key),
	    at_desk(an_unknown_site_lists_what_is_loaded),
	    at_desk(an_ambiguous_name_lists_the_keys),
	    at_desk(every_key_reaches_its_site),
	    at_desk(a_use_that_fails_changes_nothing),
	    at_desk(commands_that_need_a_site_say_so),
	    at_desk(all_other_commands_do_without_one),
	    at_desk(errors_carry_file_line_and_column),
	    at_desk(a_faulty_sheet_is_told_by_its_own_place),
	    at_desk(a_line_stops_at_its_first_error),
	    at_desk(a_session_survives_errors),
	    at_desk(a_calibration_is_a_job_in_the_midst_of_a_line),
	    at_desk(a_stopped_job_is_kept_or_dropped),
	    at_desk(the_seed_in_json_is_the_seed_given),
	    at_desk(a_file_that_is_read_twice_is_noted_once),
	    at_desk(parameters_without_set_are_not_passed_over),
	    at_desk(every_command_has_the_same_limits_of_a_parameter),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}

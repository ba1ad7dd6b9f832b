/* Completion: what is legal next, from the table, the session and the folder.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <ctype.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "desk.h"
#include "made.h"

#include "cmd/lang/command.h"
#include "cmd/run/complete.h"
#include "cmd/session/sites.h"

/* The candidates at the end of a line, each with what follows it, between
 * bars: "off |on ".  The caller frees. */
static char *
offered(struct desk *desk, const char *line, size_t *start)
{
	struct completion *c =
	    find_completions_at_cursor(desk->session, line, strlen(line));
	char *list = xstrdup("");
	for (size_t i = 0; i < c->n; i++) {
		char after[2] = {c->candidate[i].append, '\0'};
		char *longer = xasprintf("%s%s%s%s", list, i > 0 ? "|" : "",
		    c->candidate[i].text, after);
		free(list);
		list = longer;
	}
	*start = c->start;
	completion_free(c);
	return list;
}

static void
expect(struct desk *desk, const char *line, size_t start, const char *wanted)
{
	size_t at;
	char *list = offered(desk, line, &at);
	if (strcmp(list, wanted) != 0 || at != start)
		fail_msg("%s: at %zu: %s", line, at, list);
	free(list);
}

/* True when the word is among the candidates. */
static bool
offers(struct desk *desk, const char *line, const char *word)
{
	size_t at;
	char *list = offered(desk, line, &at);
	char *barred = xasprintf("|%s|", list);
	char *wanted = xasprintf("|%s|", word);
	bool found = strstr(barred, wanted) != NULL;
	free(list);
	free(barred);
	free(wanted);
	return found;
}

/* A row of Table 3 under its own name. */
static void
add(struct desk *desk, size_t row)
{
	struct site *site = made_site(&TABLE_3[row], 0.005, 9);
	free(site->name);
	site->name = xstrdup(TABLE_3[row].site);
	session_add_site(desk->session, site);
}

static void
every_command_is_offered_by_name_and_alias(void **state)
{
	struct desk *desk = *state;
	for (const struct command *c = NULL; (c = command_next(c)) != NULL;) {
		char *name = xasprintf("%s ", c->name);
		assert_true(offers(desk, "", name));
		assert_true(offers(desk, "seed 1; ", name));
		assert_true(offers(desk, c->name, name));
		free(name);
		if (c->alias == NULL)
			continue;
		char *alias =
		    xasprintf("%.*s ", (int)strcspn(c->alias, " "), c->alias);
		assert_true(offers(desk, "", alias));
		free(alias);
	}
	expect(desk, "sto", 0, "store ");
	expect(desk, "store ", 6, "export |forget |import |list ");
	expect(desk, "store li", 6, "list ");
	expect(desk, "store list ori", 11, "origin=");
	expect(desk, "predi", 0, "predict ");
	expect(desk, "  predi", 2, "predict ");
	expect(desk, "sites;predi", 6, "predict ");
	expect(desk, "nosuch", 0, "");
	expect(desk, "nosuch x", 7, "");
}

static void
every_option_is_offered_once(void **state)
{
	struct desk *desk = *state;
	for (const struct command *c = NULL; (c = command_next(c)) != NULL;) {
		const struct command_option *o;
		for (size_t i = 0; (o = command_option_at(c, i)) != NULL; i++) {
			char *line = xasprintf("%s ", c->name);
			char *given = xasprintf("%s %s=1 ", c->name, o->name);
			bool pair = (c->flags & COMMAND_SETTINGS) != 0;
			char *wanted =
			    xasprintf("%s%s", o->name, pair ? " " : "=");
			assert_true(offers(desk, line, wanted));
			assert_false(offers(desk, given, wanted));
			free(line);
			free(given);
			free(wanted);
		}
	}
	expect(desk, "predict sp", 8, "speed=");
	expect(desk, "predict 74 sp", 11, "");
	expect(desk, "predict 74 ba", 11, "band=");
	expect(desk, "predict 65..85 ba", 15, "");
}

static void
every_choice_is_offered(void **state)
{
	struct desk *desk = *state;
	for (const struct command *c = NULL; (c = command_next(c)) != NULL;) {
		const struct command_option *o;
		for (size_t i = 0; (o = command_option_at(c, i)) != NULL; i++) {
			if (o->kind != VALUE_CHOICE)
				continue;
			char *line = xasprintf("%s %s=", c->name, o->name);
			char *copy = xstrdup(option_choices(o)), *save = NULL;
			char *one = strtok_r(copy, " ", &save);
			for (; one != NULL; one = strtok_r(NULL, " ", &save)) {
				char *wanted = xasprintf("%s ", one);
				assert_true(offers(desk, line, wanted));
				free(wanted);
			}
			free(copy);
			free(line);
		}
	}
	expect(desk, "calibrate polish=", 17, "off |on ");
	expect(desk, "calibrate polish=of", 17, "off ");
	expect(desk, "set method ", 11, "classes |continuous ");
	expect(desk, "set method cl", 11, "classes ");
	expect(desk, "set method=cl", 11, "classes ");
	expect(desk, "set k 1 form", 8, "format ");
}

/* Also checks that each word in capitals of the table is a known kind. */
static void
every_operand_has_words_to_expect(void **state)
{
	struct desk *desk = *state;
	add(desk, TIERP);
	for (const struct command *c = NULL; (c = command_next(c)) != NULL;) {
		size_t most =
		    c->operands.most < EXPECTS ? c->operands.most : EXPECTS;
		char *line = xasprintf("%s ", c->name);
		if ((c->operands.most > 0) != (c->operands.expect[0] != NULL))
			fail_msg("%s: operands and expect", c->name);
		for (size_t i = 0; i < most; i++) {
			size_t at;
			free(offered(desk, line, &at));
			char *longer = xasprintf("%sx ", line);
			free(line);
			line = longer;
		}
		free(line);
	}
}

static void
operands_follow_the_table(void **state)
{
	struct desk *desk = *state;
	expect(desk, "bounds d", 7, "default ");
	expect(desk, "bounds e", 7, "e0_min ");
	expect(desk, "bounds e0_min ", 14, "");
	expect(desk, "assert p5", 7, "p50 ");
	expect(desk, "assert p50 ", 11, "< |= |> ");
	expect(desk, "assert p50 = 3 ", 15, "within ");
	expect(desk, "assert p50 = 3 within ", 22, "");
	expect(desk, "help predi", 5, "predict ");
	expect(desk, "help predict ", 13, "example ");
	expect(desk, "help store ex", 11, "example |export ");
	expect(desk, "help load example ", 18, "");
	expect(desk, "version ", 8, "");
}

static void
sites_are_offered_without_case_and_accents(void **state)
{
	struct desk *desk = *state;
	expect(desk, "use ", 4, "");
	add(desk, TIERP);
	add(desk, 1);  /* Borlänge */
	add(desk, 9);  /* Gävle, 4 mm */
	add(desk, 10); /* Gävle, 11.2 mm */
	expect(desk, "use borl", 4, "borlange ");
	expect(desk, "use BORL\xC3\x84", 4, "borlange ");
	expect(desk, "use G\xC3\xA4v", 4, "gavle/11.2 |gavle/4 ");
	expect(desk, "use tierp ", 10, "");
	expect(desk, "plot psd beside=borl", 16, "borlange ");
	assert_true(offers(desk, "check ", "all "));
	assert_true(offers(desk, "check ", "tierp "));
}

static void
speeds_are_those_of_the_site_in_use(void **state)
{
	struct desk *desk = *state;
	expect(desk, "predict speed=", 14, "");
	add(desk, TIERP);
	expect(desk, "predict speed=", 14, "69 |74 |79 ");
	expect(desk, "predict 6", 8, "69 ");
	expect(desk, "sweep speeds=69,7", 16, "74 |79 ");
	expect(desk, "sweep 69,7", 9, "74 |79 ");
	expect(desk, "calibrate train=", 16, "69 |74 |79 |all ");
	expect(desk, "calibrate train=69,", 19, "69 |74 |79 ");
}

static void
nothing_in_a_comment(void **state)
{
	struct desk *desk = *state;
	expect(desk, "# pre", 5, "");
	expect(desk, "version # pre", 13, "");
	expect(desk, "version;# pre", 13, "");
}

static void
only_what_is_before_the_cursor_counts(void **state)
{
	struct desk *desk = *state;
	struct completion *c =
	    find_completions_at_cursor(desk->session, "predi speed=74", 5);
	assert_int_equal(c->n, 1);
	assert_string_equal(c->candidate[0].text, "predict");
	completion_free(c);
	c = find_completions_at_cursor(
	    desk->session, "calibrate polish=\"off\"", 17);
	assert_int_equal(c->n, 2);
	completion_free(c);
}

static void
touch(const char *path)
{
	FILE *file = fopen(path, "w");
	assert_non_null(file);
	fclose(file);
}

static void
files_and_folders(void **state)
{
	struct desk *desk = *state;
	char folder[] = "/tmp/tipspeed-test-XXXXXX", was[4096];
	assert_non_null(getcwd(was, sizeof was));
	assert_non_null(mkdtemp(folder));
	assert_int_equal(chdir(folder), 0);
	static const char *const names[] = {"bro.csv", "my quarry.csv",
	    "semi;colon", ".hidden", "quo\"te", "new\nline", "sheets/tierp.csv",
	    "two words/a.csv", "a=b,c"};
	assert_int_equal(mkdir("sheets", 0700), 0);
	assert_int_equal(mkdir("two words", 0700), 0);
	for (size_t i = 0; i < ARRAY_LEN(names); i++)
		touch(names[i]);
	expect(desk, "load b", 5, "bro.csv ");
	expect(desk, "load bro.csv b", 13, "bro.csv ");
	expect(desk, "load my", 5, "\"my quarry.csv\" ");
	expect(desk, "load \"my q", 5, "\"my quarry.csv\" ");
	expect(desk, "load \"b", 5, "\"bro.csv\" ");
	expect(desk, "load sem", 5, "\"semi;colon\" ");
	expect(desk, "load .", 5, ".hidden ");
	expect(
	    desk, "load s", 5, "\"semi;colon\" |samples=|sheet=|sheets/|skip=");
	expect(desk, "load sheets/", 5, "sheets/tierp.csv ");
	expect(desk, "load two", 5, "\"two words/");
	expect(desk, "load \"two words/", 5, "\"two words/a.csv\" ");
	expect(desk, "load quo", 5, "");
	/* A terminal would act on the first, and not show the second. */
	touch("c1\xC2\x9B.csv");
	touch("c1\u202E.csv");
	expect(desk, "load c1", 5, "");
	desk->session->safe = true;
	expect(desk, "load b", 5, "");
	expect(desk, "version > b", 10, "");
	desk->session->safe = false;
	expect(desk, "load new", 5, "");
	expect(desk, "load nowhere/", 5, "");
	expect(desk, "find spec=br", 10, "bro.csv ");
	expect(desk, "find spec=mo", 10, "");
	expect(desk, "find spec=\"en 12620 gn", 10, "\"EN 12620 GNG90 0/8\" ");
	expect(desk, "find spec=\"my q", 10, "\"my quarry.csv\" ");
	expect(desk, "find spec=a=", 10, "a=b,c ");
	expect(desk, "write replace=on b", 17, "bro.csv ");
	for (size_t i = 0; i < ARRAY_LEN(names); i++)
		unlink(names[i]);
	rmdir("sheets");
	rmdir("two words");
	assert_int_equal(chdir(was), 0);
	rmdir(folder);
}

/* Sites that come with the program, where no file begins so. */
static void
shipped_sites(void **state)
{
	struct desk *desk = *state;
	char folder[] = "/tmp/tipspeed-test-XXXXXX", was[4096];
	assert_non_null(getcwd(was, sizeof was));
	assert_non_null(mkdtemp(folder));
	assert_int_equal(chdir(folder), 0);
	assert_int_equal(mkdir("data", 0700), 0);
	assert_int_equal(mkdir("data/sites", 0700), 0);
	touch("data/sites/tierp.csv");
	touch("data/sites/sky.csv");
	touch("data/sites/notes.txt");
	expect(desk, "load tie", 5, "tierp ");
	expect(desk, "load Ti", 5, "tierp ");
	expect(desk, "load sky s", 9, "samples=|sheet=|skip=|sky ");
	expect(desk, "load no", 5, "");
	expect(desk, "load dat", 5, "data/|dates=");
	expect(desk, "add tie", 4, "");
	desk->session->safe = true;
	expect(desk, "load tie", 5, "");
	desk->session->safe = false;
	touch("tie.csv");
	expect(desk, "load tie", 5, "tie.csv ");
	unlink("tie.csv");
	unlink("data/sites/tierp.csv");
	unlink("data/sites/sky.csv");
	unlink("data/sites/notes.txt");
	rmdir("data/sites");
	rmdir("data");
	assert_int_equal(chdir(was), 0);
	rmdir(folder);
}

/* Whatever is typed, at whatever place: no crash, and in order. */
static void
any_line_at_any_cursor(void **state)
{
	struct desk *desk = *state;
	static const char *const lines[] = {
	    "load \"x\"y; set method=cl k 2;;use =", "sweep 69,,74 speeds=,\"",
	    "params set alpha=\"1 beta1", "= = =;#;\"#;\"", "set set set set",
	    "assert \xC3\xA5 \xFF < ;calibrate polish==on"};
	add(desk, TIERP);
	for (size_t i = 0; i < ARRAY_LEN(lines); i++)
		for (size_t at = 0; at <= strlen(lines[i]); at++) {
			struct completion *c = find_completions_at_cursor(
			    desk->session, lines[i], at);
			assert_true(c->start <= at);
			for (size_t j = 1; j < c->n; j++)
				assert_true(strcmp(c->candidate[j - 1].text,
						c->candidate[j].text) < 0);
			completion_free(c);
		}
}

int
main(void)
{
#define at_desk(test) \
	cmocka_unit_test_setup_teardown(test, desk_open, desk_close)
	const struct CMUnitTest tests[] = {
	    at_desk(every_command_is_offered_by_name_and_alias),
	    at_desk(every_option_is_offered_once),
	    at_desk(every_choice_is_offered),
	    at_desk(every_operand_has_words_to_expect),
	    at_desk(operands_follow_the_table),
	    at_desk(sites_are_offered_without_case_and_accents),
	    at_desk(speeds_are_those_of_the_site_in_use),
	    at_desk(nothing_in_a_comment),
	    at_desk(only_what_is_before_the_cursor_counts),
	    at_desk(files_and_folders),
	    at_desk(shipped_sites),
	    at_desk(any_line_at_any_cursor),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}

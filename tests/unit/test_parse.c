/* From a line of text to a call: words, options, values, and what is refused.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "call.h"

/* A line, its words joined by |, and where the next command begins. */
static const struct {
	const char *line, *words;
	size_t next;
	int last_column;
} LINES[] = {{"predict 74", "predict|74", 10, 9},
    {"  predict\t 74  ", "predict|74", 15, 12}, {"", "", 0, 0},
    {"# all of it", "", 11, 0}, {"seed 1 # rest", "seed|1", 13, 6},
    {"seed 1;seed 2", "seed|1", 7, 6}, {"seed 1 ; seed 2", "seed|1", 8, 6},
    {";seed 2", "", 1, 0}, {"use \"Gävle 4\" x", "use|Gävle 4|x", 16, 15},
    {"use Gåsgruvan å ö", "use|Gåsgruvan|å|ö", 20, 17},
    {"load \"a;b #c.csv\"", "load|a;b #c.csv", 17, 6},
    {"load a#b", "load|a#b", 8, 6}, {"load a\" \"b", "load|a b", 10, 6},
    {"use \"a \"\"b\"\"\"", "use|a \"b\"", 13, 5},
    {"predict 74>a; x", "predict|74", 13, 9},
    {"predict \">\" | a; b # c", "predict|>", 22, 9},
    {"assert p50 > 3 | 2", "assert|p50|>|3|||2", 18, 18},
    {"use \"\"", "use|", 6, 5}, {"a=\"b c\"d", "a=b cd", 8, 1}};

static void
lines_are_split_into_words(void **state)
{
	(void)state;
	for (size_t i = 0; i < ARRAY_LEN(LINES); i++) {
		struct words words;
		struct error error = {0};
		char *joined = xstrdup("");
		assert_true(words_split_line(
		    LINES[i].line, 0, CALL_PLACE, &words, &error));
		for (size_t w = 0; w < words.n; w++) {
			char *more = xasprintf(
			    "%s%s%s", joined, w > 0 ? "|" : "", words.text[w]);
			free(joined);
			joined = more;
		}
		assert_string_equal(joined, LINES[i].words);
		assert_int_equal(words.next, LINES[i].next);
		if (words.n > 0)
			assert_int_equal(
			    words.column[words.n - 1], LINES[i].last_column);
		free(joined);
		words_free(&words);
	}
}

static void
a_line_can_be_taken_up_in_its_midst(void **state)
{
	(void)state;
	struct words words;
	struct error error = {0};
	const char *line = "use å; use Borlänge; seed 3";
	assert_true(words_split_line(line, 7, CALL_PLACE, &words, &error));
	assert_string_equal(words.text[1], "Borlänge");
	assert_int_equal(words.column[0], 8);
	assert_int_equal(words.column[1], 12);
	size_t next = words.next;
	words_free(&words);
	assert_true(words_split_line(line, next, CALL_PLACE, &words, &error));
	assert_string_equal(words.text[0], "seed");
	assert_int_equal(words.column[0], 22);
	words_free(&words);
}

/* What is refused: where, and parts of text and hint. */
static const struct {
	const char *line;
	int column; /* 0: anywhere in the line */
	const char *text, *hint;
} FAULTS[] = {{"frobnicate", 1, "no command 'frobnicate'", "help"},
    {"goal passing 2 >= 30", 1, "no command 'goal'", "'set goal'"},
    {"predct 74", 1, "no command 'predct'", "'predict'"},
    {"cal", 1, "no command 'cal'", "'calibrate'"},
    {"  predict spede=74", 11, "no option 'spede'", "'speed'"},
    {"use \"Å\" Öster", 9, "unexpected word 'Öster'", "usage: use SITE"},
    {"calibrate wheels=4", 11, "no option 'wheels'", "usage: calibrate"},
    {"predict speed=74 speed=75", 18, "speed is given twice",
	"leave out one of the two"},
    {"predict 74 speed=75", 12, "speed is given twice",
	"leave out one of the two"},
    {"predict 74 75", 12, "got 74 and 75", "predict speed=75"},
    {"seed 1 2", 8, "unexpected word '2'", "usage: set seed"},
    {"set method", 5, "method: expected a value", ""},
    {"use", 1, "use: expected SITE", "usage: use SITE"},
    {"predict speed=1,074", 9, "1,074", "use a decimal point"},
    {"predict 7,450", 9, "expected a number", "use a decimal point: 7.450"},
    {"predict 7,450m/s", 9, "expected a number", "use a decimal point: 7.450"},
    {"predict 74,5,6", 9, "expected a number", "use a decimal point: 11.2"},
    {"predict 69 kg", 12, "unexpected word 'kg'", "usage"},
    {"sweep 55-75", 7, "got '55-75'", "write a range with two points: 55..75"},
    {"sweep 55-75m/s", 7, "got '55-75m/s'", "55..75"},
    {"sweep a-b", 7, "got 'a-b'", ""},
    {"set method=", 5, "method: expected a value: continuous, classes", ""},
    {"set method = classes", 5, "got '='", "one word: method=classes"},
    {"set method= classes", 5, "expected a value", "one word: method=classes"},
    {"predict speed = 74", 9, "got 'speed'", "one word: speed=74"},
    {"predict speed =74", 9, "got 'speed'", "one word: speed=74"},
    {"calibrate seed =", 16, "unexpected", "one word: seed="},
    {"set method Clases", 5, "got 'Clases'", "'classes'"},
    {"predict speed=fast", 9, "got 'fast'", ""},
    {"predict speed=", 9, "speed: expected a number", ""},
    {"predict speed=74km/h", 9, "'74km/h'", ""},
    {"predict speed=nan", 9, "got 'nan'", ""},
    {"predict speed=500", 9, "1 to 400 m/s", ""},
    {"predict -74", 9, "1 to 400 m/s", ""},
    {"calibrate population=7", 11, "8 to 1000000", ""},
    {"calibrate population=1e3", 11, "whole number", ""},
    {"calibrate seed=-1", 11, "whole number", ""},
    {"calibrate polish=maybe", 11, "got 'maybe'", ""},
    {"calibrate polish=o", 11, "got 'o'", ""},
    {"calibrate polish=", 11, "on", ""},
    {"synth x site=", 9, "site: expected a value", ""},
    {"set method quantum", 5, "continuous", ""},
    {"set metod classes", 5, "no option 'metod'", "'method'"},
    {"sweep 85..65", 7, "from low to high", ""},
    {"sweep 65..85:0", 7, "got 0", ""},
    {"sweep 65..85:0.002", 7, "at most 2000 steps, got 10000", "larger step"},
    {"sweep 65..", 7, "got ''", ""}, {"sweep 65..500", 7, "1 to 400 m/s", ""},
    {"sweep 65,x", 7, "got 'x'", ""}, {"sweep ,", 7, "speeds: expected", ""},
    {"sweep 65,,75", 7, "got ''", ""}, {"sweep 65,75,", 7, "got ''", ""},
    {"use \"Borl", 5, "quote", "closing"},
    {"predict >", 9, "expected a file name after >", "product.csv"},
    {"predict >> ; seed", 9, "expected a file name after >>", ""},
    {"> a", 1, "expected a command before >", ""},
    {"åä | ", 4, "expected a shell command", "sweep | less"},
    {"predict || a", 9, "expected a shell command", ""},
    {"predict > a b", 13, "nothing after the file 'a'", "quote a name"},
    {"predict > a | b", 13, "nothing after the file 'a'", "one >"},
    {"predict > \"a", 11, "quote", "closing"},
    {"åäö \"Borl", 5, "quote", "closing"}};

/* As many as a range may have. */
static void
a_list_of_numbers_has_an_end(void **state)
{
	(void)state;
	char *line = xstrdup("sweep 65");
	for (size_t n = 1; n < 2000; n++)
		xappend(&line, ",65");
	struct call *call = call_parse(line);
	assert_non_null(call->command);
	call_free(call);
	xappend(&line, ",65");
	call = call_parse(line);
	assert_null(call->command);
	assert_non_null(
	    strstr(call->error.text, "at most 2000 numbers, got 2001"));
	call_free(call);
	free(line);
}

static void
faults_are_told_with_their_place(void **state)
{
	(void)state;
	for (size_t i = 0; i < ARRAY_LEN(FAULTS); i++) {
		struct call *call = call_parse(FAULTS[i].line);
		const struct error *e = &call->error;
		if (call->command != NULL)
			fail_msg("accepted: %s", FAULTS[i].line);
		if (strstr(e->text, FAULTS[i].text) == NULL ||
		    strstr(e->hint, FAULTS[i].hint) == NULL)
			fail_msg(
			    "%s: %s (%s)", FAULTS[i].line, e->text, e->hint);
		assert_int_equal(e->kind, ERROR_USAGE);
		assert_string_equal(e->file, "script.tip");
		assert_int_equal(e->line, 3);
		assert_true(e->column > 0);
		if (FAULTS[i].column > 0 && e->column != FAULTS[i].column)
			fail_msg("%s: column %d", FAULTS[i].line, e->column);
		call_free(call);
	}
}

static void
results_go_where_the_line_says(void **state)
{
	(void)state;
	static const struct {
		const char *line;
		enum target to;
		const char *target;
		int column;
	} lines[] = {{"seed>a", TO_FILE, "a", 5},
	    {"seed >> \"å b\" # c", TO_APPEND, "å b", 6},
	    {"å | sort -k 2; wc > \"x\" ", TO_PIPE, "sort -k 2; wc > \"x\"",
		3}};
	for (size_t i = 0; i < ARRAY_LEN(lines); i++) {
		struct words words;
		struct error error = {0};
		assert_true(words_split_line(
		    lines[i].line, 0, CALL_PLACE, &words, &error));
		assert_int_equal(words.n, 1);
		assert_int_equal(words.to, lines[i].to);
		assert_string_equal(words.target, lines[i].target);
		assert_int_equal(words.to_column, lines[i].column);
		words_free(&words);
	}
}

static void
a_setting_is_given_once(void **state)
{
	(void)state;
	static const char *const twice[] = {"set method=classes method=classes",
	    "set method=classes method continuous",
	    "set method classes method continuous"};
	for (size_t i = 0; i < ARRAY_LEN(twice); i++) {
		struct call *call = call_parse(twice[i]);
		if (call->command != NULL)
			fail_msg("accepted: %s", twice[i]);
		assert_non_null(strstr(call->error.text, "given twice"));
		call_free(call);
	}
}

static void
too_many_words_are_refused(void **state)
{
	(void)state;
	char line[4 * OPERANDS] = "load";
	for (int i = 0; i < OPERANDS - 1; i++)
		strcat(line, " x");
	call_free(call_accept(line));
	strcat(line, " x");
	struct call *call = call_parse(line);
	assert_null(call->command);
	assert_int_equal(call->error.kind, ERROR_USAGE);
	call_free(call);
}

/* Lists and ranges of sweep's speeds. */
static const struct {
	const char *line;
	size_t n;
	double first, step;
} LISTS[] = {{"sweep 74", 1, 74, 0}, {"sweep 65..85:5", 5, 65, 5},
    {"sweep 65..67", 3, 65, 1}, {"sweep 65,75,85", 3, 65, 10},
    {"sweep 65m/s,75m/s", 2, 65, 10}, {"sweep 65..66:0.1", 11, 65, 0.1},
    {"sweep speeds=65..85:0.1", 201, 65, 0.1}, {"sweep 65..69:3", 2, 65, 3},
    {"sweep 70..70", 1, 70, 0}, {"sweep \"65, 70, 75\"", 3, 65, 5},
    {"sweep 65m/s..75m/s:5m/s", 3, 65, 5},
    {"sweep speeds=65..70 m/s", 6, 65, 1}, {"sweep", 0, 0, 0}};

static void
lists_and_ranges_become_numbers(void **state)
{
	(void)state;
	for (size_t i = 0; i < ARRAY_LEN(LISTS); i++) {
		struct call *call = call_accept(LISTS[i].line);
		const struct value *v = call_value(call, "speeds");
		if (v->n != LISTS[i].n)
			fail_msg("%s: %zu numbers", LISTS[i].line, v->n);
		for (size_t k = 0; k < v->n; k++) {
			double want =
			    LISTS[i].first + LISTS[i].step * (double)k;
			if (!(fabs(v->list[k] - want) < 1e-12))
				fail_msg(
				    "%s: %.17g", LISTS[i].line, v->list[k]);
			assert_true(v->list[k] >= 1 && v->list[k] <= 400);
		}
		call_free(call);
	}
}

static void
values_are_read_as_typed(void **state)
{
	(void)state;
	static const char *const speeds[] = {"predict 74.5",
	    "predict speed=74.5", "predict 74.5m/s", "predict \"74.5 m/s\"",
	    "predict curve=off 74.5", "predict speed=7.45e1", "predict 74,5",
	    "predict speed=74,50 m/s", "predict 74,5m/s"};
	for (size_t i = 0; i < ARRAY_LEN(speeds); i++) {
		struct call *call = call_accept(speeds[i]);
		assert_true(call_value(call, "speed")->given);
		assert_true(call_value(call, "speed")->number == 74.5);
		call_free(call);
	}
	struct call *call = call_accept("set k 2 method=classes format json");
	assert_true(call_value(call, "k")->number == 2);
	assert_int_equal(call_value(call, "method")->choice, 1);
	assert_int_equal(call_value(call, "format")->choice, 2);
	assert_false(call_value(call, "threads")->given);
	call_free(call);
	call = call_accept("synth \"my file=1.csv\" site=\"Gävle 4\" seed=18");
	assert_string_equal(call->args.operand[0], "my file=1.csv");
	assert_string_equal(call_value(call, "site")->text, "Gävle 4");
	assert_true(call_value(call, "seed")->whole == 18);
	call_free(call);
	call = call_accept("fit seed=7");
	assert_string_equal(call->command->name, "calibrate");
	call_free(call);
}

/* As commands read them; of an option that is not given the fallback. */
static void
values_are_members_of_the_call(void **state)
{
	(void)state;
	struct call *call = call_accept("calibrate seed=0 train=69,79 "
					"weights=sd polish=off part=1/2");
	const struct args *args = &call->args;
	assert_true(args->seed == 0 && args_is_given(args, &args->seed));
	assert_true(args->stall == 20 && !args_is_given(args, &args->stall));
	assert_true(args->tolerance == 0.05);
	assert_int_equal(args->train.n, 2);
	assert_true(args->train.at[1] == 79);
	assert_int_equal(args->weights, 1);
	assert_false(args->polish || args->detail);
	assert_string_equal(args->part, "1/2");
	assert_true(args->tph == 0 && !args_is_given(args, &args->tph));
	call_free(call);
	call = call_accept("calibrate detail=on");
	assert_true(call->args.polish && call->args.detail);
	assert_null(call->args.part);
	call_free(call);
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(lines_are_split_into_words),
	    cmocka_unit_test(a_line_can_be_taken_up_in_its_midst),
	    cmocka_unit_test(a_list_of_numbers_has_an_end),
	    cmocka_unit_test(faults_are_told_with_their_place),
	    cmocka_unit_test(results_go_where_the_line_says),
	    cmocka_unit_test(a_setting_is_given_once),
	    cmocka_unit_test(too_many_words_are_refused),
	    cmocka_unit_test(lists_and_ranges_become_numbers),
	    cmocka_unit_test(values_are_read_as_typed),
	    cmocka_unit_test(values_are_members_of_the_call),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}

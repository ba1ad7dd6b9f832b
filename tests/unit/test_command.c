/* The command table: everything that is read from it can rely on this.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <ctype.h>
#include <string.h>

#include "call.h"

static size_t
count_named(const char *name)
{
	size_t n = 0;
	for (const struct command *c = NULL; (c = command_next(c)) != NULL;) {
		n += strcmp(c->name, name) == 0;
		n += c->alias != NULL && strcmp(c->alias, name) == 0;
	}
	return n;
}

static void
names_and_aliases_are_unique(void **state)
{
	(void)state;
	for (const struct command *c = NULL; (c = command_next(c)) != NULL;) {
		assert_int_equal(count_named(c->name), 1);
		assert_ptr_equal(command_find(c->name), c);
		if (c->alias == NULL)
			continue;
		assert_int_equal(count_named(c->alias), 1);
		assert_ptr_equal(command_find(c->alias), c);
	}
	assert_null(command_find("no-such"));
}

/* Lower case, no full stop; sentences end with one. */
static void
words_for_people_are_there(void **state)
{
	(void)state;
	for (const struct command *c = NULL; (c = command_next(c)) != NULL;) {
		size_t n = strlen(c->brief), end = strlen(c->text);
		assert_true(n > 0 && c->brief[n - 1] != '.');
		assert_false(isupper((unsigned char)c->brief[0]));
		assert_true(end > 0 && c->text[end - 1] == '.');
		assert_true(c->example[0] != '\0');
		assert_non_null(strstr(c->example, command_shown_name(c)));
		assert_true(c->operands.least <= c->operands.most &&
			    c->operands.most < OPERANDS);
		assert_true(
		    (c->operands.most > 0) == (c->operands.usage != NULL));
		assert_true((c->run != NULL) != (c->answer != NULL));
		const struct command_option *o;
		for (size_t i = 0; (o = command_option_at(c, i)) != NULL; i++)
			assert_true(o->brief[0] != '\0' &&
				    o->brief[strlen(o->brief) - 1] != '.');
	}
}

static void
options_are_in_order(void **state)
{
	(void)state;
	for (const struct command *c = NULL; (c = command_next(c)) != NULL;) {
		size_t n = 0;
		const struct command_option *o;
		for (; (o = command_option_at(c, n)) != NULL; n++) {
			assert_int_equal(command_option_index(c, o->name), n);
			bool choice = o->kind == VALUE_CHOICE;
			bool words = option_choices(o) != NULL;
			assert_true(choice ? words
					   : !words || o->kind == VALUE_TEXT ||
						 o->kind == VALUE_NUMBERS);
			bool limits = !choice && o->kind < VALUE_FILE;
			assert_true(!limits || o->least < o->most);
			assert_non_null(o->unit);
			bool elsewhere = (c->flags & COMMAND_SETTINGS) != 0 ||
					 (c->flags & COMMAND_PARAMS) != 0;
			assert_true(elsewhere || o->offset > 0);
			for (size_t i = 0; i < n && !elsewhere; i++)
				assert_true(command_option_at(c, i)->offset !=
					    o->offset);
		}
		assert_true(n <= OPTIONS);
		assert_int_equal(command_option_index(c, "none"), OPTIONS);
		if (c->bare != NULL)
			assert_true(command_option_index(c, c->bare) < OPTIONS);
	}
}

/* Each fallback is a value that could be typed, within the limits. */
static void
fallbacks_are_valid(void **state)
{
	(void)state;
	for (const struct command *c = NULL; (c = command_next(c)) != NULL;) {
		const struct command_option *o;
		for (size_t i = 0; (o = command_option_at(c, i)) != NULL; i++) {
			if (o->fallback[0] == '\0')
				continue;
			const char *operands = call_operands(c);
			char *typed = xasprintf("%s %s %s=\"%s\" %s", c->name,
			    operands, o->name, o->fallback,
			    o->needs != NULL ? o->needs : "");
			char *bare = xasprintf("%s %s", c->name, operands);
			struct call *a = call_accept(typed),
				    *b = call_accept(bare);
			const struct value *u = call_value(a, o->name);
			const struct value *v = call_value(b, o->name);
			assert_true(u->given && !v->given);
			assert_string_equal(v->text, o->fallback);
			assert_true(u->number == v->number);
			assert_true(u->whole == v->whole && u->n == v->n);
			assert_int_equal(u->choice, v->choice);
			call_free(a);
			call_free(b);
			free(typed);
			free(bare);
		}
	}
}

/* --safe goes by the flag; the usage shows what it stands for. */
static void
commands_on_files_are_marked(void **state)
{
	(void)state;
	for (const struct command *c = NULL; (c = command_next(c)) != NULL;) {
		bool shows = c->operands.usage != NULL &&
			     strstr(c->operands.usage, "FILE") != NULL;
		bool marked = (c->flags & (COMMAND_FILES | COMMAND_SPEC)) != 0;
		if (shows != marked)
			fail_msg("%s: FILE and its flag", c->name);
	}
}

static void
names_may_be_cut_short_at_a_prompt(void **state)
{
	(void)state;
	static const char *const called[][2] = {{"pred", "predict"},
	    {"PREDICT", "predict"}, {"SeE", "seed"}, {"set", "set"},
	    {"fit", "calibrate"}, {"exi", "quit"}, {"qu", "quit"},
	    {"q", "quit"}};
	for (size_t i = 0; i < ARRAY_LEN(called); i++)
		assert_string_equal(
		    command_find_abbreviated(called[i][0], true)->name,
		    called[i][1]);
	static const char *const none[] = {"", "s", "se", "predicts", "x"};
	for (size_t i = 0; i < ARRAY_LEN(none); i++)
		assert_null(command_find_abbreviated(none[i], true));
	assert_null(command_find_abbreviated("pred", false));
	assert_null(command_find_abbreviated("PREDICT", false));
	char *names = command_names_beginning_with("SE");
	assert_string_equal(names, "set, seed");
	free(names);
}

static void
examples_parse(void **state)
{
	(void)state;
	for (const struct command *c = NULL; (c = command_next(c)) != NULL;) {
		char *copy = xstrdup(c->example), *save = NULL;
		char *line = strtok_r(copy, "\n", &save);
		for (; line != NULL; line = strtok_r(NULL, "\n", &save))
			call_free(call_accept(line));
		free(copy);
	}
}

static void
usage_names_operands_and_options(void **state)
{
	(void)state;
	for (const struct command *c = NULL; (c = command_next(c)) != NULL;) {
		char *usage = command_usage_text(c);
		assert_true(strncmp(usage, command_shown_name(c),
				strlen(command_shown_name(c))) == 0);
		if (c->operands.usage != NULL)
			assert_non_null(strstr(usage, c->operands.usage));
		const struct command_option *o;
		for (size_t i = 0; (o = command_own_option_at(c, i)) != NULL;
		     i++) {
			char *key = xasprintf("[%s=", o->name);
			assert_non_null(strstr(usage, key));
			free(key);
		}
		free(usage);
	}
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(names_and_aliases_are_unique),
	    cmocka_unit_test(words_for_people_are_there),
	    cmocka_unit_test(options_are_in_order),
	    cmocka_unit_test(fallbacks_are_valid),
	    cmocka_unit_test(commands_on_files_are_marked),
	    cmocka_unit_test(names_may_be_cut_short_at_a_prompt),
	    cmocka_unit_test(examples_parse),
	    cmocka_unit_test(usage_names_operands_and_options),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}

/* What a condition says, however it is written, and what is answered to one
 * that says nothing.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/ask/condition.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "call.h"
#include "cmd/ask/goals.h"
#include "cmd/ask/quantity_words.h"
#include "io/formats/standards.h"

static const struct fraction WHOLE = {.partition = {0, 1}};

static void
a_condition_says_the_same_in_other_words(void **state)
{
	static const struct {
		const char *text;
		double least, most;
	} CASES[] = {{"passing 2 = 38..42", 38, 42},
	    {"passing 2 mm = 38..42", 38, 42}, {"passing 2=38-42", 38, 42},
	    {"passing 2 = 38 - 42 %", 38, 42},
	    {"passing 2 = 38\xE2\x80\x93"
	     "42",
		38, 42},
	    {"passing 2 mm = 38 to 42", 38, 42},
	    {"passing 2 mm between 38 and 42", 38, 42},
	    {"passing 2 at most 42", NAN, 42}, {"p80 at least 6.5", 6.5, NAN},
	    {"58 % passes 2 mm", 58, 58}, {"58,5 % passing 2 mm", 58.5, 58.5},
	    {"34 % passing 2 of 0/4", 34, 34}, {"34 % passing", NAN, NAN},
	    {"36 % < 2 mm", 36, 36}, {"36 < 2 mm", NAN, NAN},
	    {"<2 mm = 30", 30, 30}, {"2 mm >= 30", 30, NAN},
	    {"2 mm at least 30", 30, NAN}, {"2 mm at most 30 %", NAN, 30},
	    {"at most 30 % under 2 mm", NAN, 30},
	    {"At least 30 % passing 2 mm", 30, NAN},
	    {"at least 30 finer than 2", 30, NAN}, {"30 % below 2 mm", 30, 30},
	    {"at least 30 % over 2 mm", NAN, 70}, {"over 2 < 10", 90, NAN},
	    {"over 2 mm = 5..10 %", 90, 95}, {"7 % coarser than 2", 93, 93},
	    {"over 2 < 110", NAN, NAN}, {"max 2 mm", NAN, NAN},
	    {"2 mm = 30..32", 30, 32}, {"2 = 30", NAN, NAN},
	    {"P80=6.5 mm", 6.5, 6.5}, {"p80 = 6e-1", 0.6, 0.6},
	    {"0/2 of 0/4 >= 30", NAN, NAN}, {"P80 < 10001", NAN, NAN},
	    {"passing 2 < 101", NAN, NAN}, {"cu < 10001", NAN, 10001}};
	(void)state;
	for (size_t i = 0; i < ARRAY_LEN(CASES); i++) {
		struct condition c;
		struct error error = {0};
		bool ok =
		    conditions_parse_one(CASES[i].text, &WHOLE, &c, &error);
		bool any = !isnan(CASES[i].least) || !isnan(CASES[i].most);
		assert_int_equal(ok, any);
		const double got[] = {c.least, c.most},
			     want[] = {CASES[i].least, CASES[i].most};
		for (size_t k = 0; ok && k < 2; k++)
			if (isnan(want[k]))
				assert_true(isnan(got[k]));
			else
				assert_true(fabs(quantities_value_in_shown_unit(
						     &c.quantity, got[k]) -
						 want[k]) < 1e-9);
	}
}

static void
what_to_write_is_said(void **state)
{
	static const struct {
		const char *text, *hint;
	} CASES[] = {{"P80=6,500", "use a decimal point: 6.500"},
	    {"P80 = 5,2..1,640", "use a decimal point: 1.640"},
	    {"0/2 >= 30, P80=6,500", "use a decimal point: 6.500"},
	    {"p80 6.5", "write: p80 = 6.5"}, {"p80 6.5 mm", "write: p80 = 6.5"},
	    {"passing 2 mm 38-42", "write: passing 2 mm = 38..42"},
	    {"P50 of 0/4 2", "write: P50 of 0/4 = 2"},
	    {"max 2 mm", "write: find \"max passing 2 mm\""}};
	(void)state;
	for (size_t i = 0; i < ARRAY_LEN(CASES); i++) {
		struct condition_list list = {0};
		struct error error = {0};
		assert_false(conditions_parse_list(
		    CASES[i].text, &WHOLE, &list, &error));
		assert_string_equal(error.hint, CASES[i].hint);
		conditions_free(&list);
	}
}

static void
a_comma_between_conditions_is_no_decimal_one(void **state)
{
	(void)state;
	struct condition_list list = {0};
	struct error error = {0};
	assert_true(conditions_parse_list(
	    "P80=6,0/2>=30,passing 2=40..50; cu<7", &WHOLE, &list, &error));
	assert_int_equal(list.n, 4);
	conditions_free(&list);
	list = (struct condition_list){0};
	assert_true(conditions_parse_list(
	    "P80=6,5,passing 0,063 = 40,5..42, cu<7", &WHOLE, &list, &error));
	assert_int_equal(list.n, 3);
	assert_float_equal(list.at[0].least, 6.5e-3, 1e-12);
	assert_float_equal(list.at[1].least, 0.405, 1e-12);
	conditions_free(&list);
}

static void
a_quantity_is_no_envelope_and_no_envelope_a_quantity(void **state)
{
	static const char *const QUANTITIES[] = {"P80", "p80 6.5", "D10 1",
	    "passing 2 mm between 38 and 42", "passing", "fines 6", "fm EN 2.7",
	    "cu 5", "0/2 30", "share 0/2 30", "2 mm at least 30",
	    "at least 30 passing 2", "max 2 mm", "max P80"};
	struct standards *all = standards_read_built_in();
	(void)state;
	assert_true(all->n > 10);
	for (size_t i = 0; i < all->n; i++)
		assert_false(goals_is_condition_text(all->spec[i]->name));
	for (size_t i = 0; i < ARRAY_LEN(QUANTITIES); i++)
		assert_true(goals_is_condition_text(QUANTITIES[i]));
	assert_false(goals_is_condition_text("p80.csv"));
	assert_false(goals_is_condition_text("fines.csv"));
	standards_free(all);
}

/* Offer n as a whole quantity: "p80" of "p80=", "passing 2 mm" of "passing ".
 * The caller frees it. */
static char *
offered(size_t n)
{
	char *text = xstrdup(quantities_nth_completion(n));
	text[strcspn(text, "<>=")] = '\0';
	if (text[strlen(text) - 1] == ' ')
		xappend(&text, "2 mm");
	return text;
}

static struct quantity
read_as_typed(const char *text)
{
	struct quantity q;
	struct error error = {0};
	if (!quantities_parse_one(text, &WHOLE.partition, &q, &error))
		fail_msg("%s: %s", text, error.text);
	FREED char *typed = quantities_text_to_type(&q);
	assert_string_equal(typed, text);
	return q;
}

static void
every_kind_is_offered_and_typed_as_it_is_read(void **state)
{
	static const char IN_KEYS[] =
	    "abcdefghijklmnopqrstuvwxyz_0123456789.EN";
	bool seen[QUANTITY_STEP] = {false};
	(void)state;
	for (size_t n = 0; quantities_nth_completion(n) != NULL; n++) {
		FREED char *text = offered(n);
		struct quantity q = read_as_typed(text);
		seen[q.kind] = true;
		assert_true(quantities_is_beginning_of_text(
		    quantities_nth_completion(n)));
		assert_true(goals_is_condition_text(text));
		FREED char *key = quantities_field_name(&q);
		assert_int_equal(strspn(key, IN_KEYS), strlen(key));
		FREED char *of = xasprintf("%s of 0/4", text);
		if (q.kind != QUANTITY_SHARE)
			read_as_typed(of);
		for (size_t i = 0; i < n; i++) {
			FREED char *before = offered(i);
			struct quantity other = read_as_typed(before);
			assert_false(quantity_is_same(&q, &other));
		}
	}
	for (size_t kind = 0; kind < QUANTITY_STEP; kind++)
		assert_true(seen[kind]);
}

/* As often as there are kinds, not in the same words: P80, passing 2. */
static void
what_is_no_quantity_is_answered_with_every_kind(void **state)
{
	struct quantity q;
	struct error error = {0};
	bool named[QUANTITY_STEP] = {false};
	(void)state;
	assert_false(
	    quantities_parse_one("much", &WHOLE.partition, &q, &error));
	for (char *at = strchr(error.hint, ':'), *end; at != NULL; at = end) {
		at += strspn(at, ":;, ");
		end = strpbrk(at, ",;");
		FREED char *one =
		    end != NULL ? xstrndup(at, (size_t)(end - at)) : NULL;
		if (one != NULL &&
		    quantities_parse_one(one, &WHOLE.partition, &q, NULL))
			named[q.kind] = true;
	}
	for (size_t kind = 0; kind < QUANTITY_STEP; kind++)
		assert_true(named[kind]);
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(a_condition_says_the_same_in_other_words),
	    cmocka_unit_test(what_to_write_is_said),
	    cmocka_unit_test(a_comma_between_conditions_is_no_decimal_one),
	    cmocka_unit_test(every_kind_is_offered_and_typed_as_it_is_read),
	    cmocka_unit_test(what_is_no_quantity_is_answered_with_every_kind),
	    cmocka_unit_test(
		a_quantity_is_no_envelope_and_no_envelope_a_quantity),
	};
	return cmocka_run_group_tests_name("conditions", tests, NULL, NULL);
}

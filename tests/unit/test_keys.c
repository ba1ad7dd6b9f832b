/* The table of keys: each means one thing on a page.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "tui/keys.h"

static void
no_key_means_two_things(void **state)
{
	(void)state;
	for (const struct key *a = KEYS; a->code != 0; a++)
		for (const struct key *b = KEYS; b != a; b++)
			assert_false(a->code == b->code &&
				     (a->where & b->where & ON_ALL));
}

static void
every_key_is_found_on_its_pages_only(void **state)
{
	(void)state;
	for (const struct key *k = KEYS; k->code != 0; k++)
		for (int page = 0; page < PAGES; page++)
			if (k->where & (1U << page))
				assert_ptr_equal(
				    keys_find_by_code(k->code, (enum page)page),
				    k);
	assert_null(keys_find_by_code('v', PAGE_DATA));
	assert_null(keys_find_by_code('v', PAGE_PREDICT));
	assert_non_null(keys_find_by_code('v', PAGE_FIT));
	assert_ptr_equal(keys_find_by_code('\r', PAGE_SITES),
	    keys_find_by_code('\n', PAGE_SITES));
	assert_null(keys_find_by_code(1, PAGE_FIT));
}

/* A second way to press a key does what the row above does. */
static void
second_ways_do_the_same(void **state)
{
	(void)state;
	for (const struct key *k = KEYS + 1; k->code != 0; k++)
		if (k->name == NULL) {
			assert_true(k->act == k[-1].act);
			assert_int_equal(k->amount, k[-1].amount);
		} else {
			assert_non_null(k->what);
		}
}

static void
the_list_has_every_name(void **state)
{
	(void)state;
	char *text = NULL;
	size_t n = 0;
	FILE *out = open_memstream(&text, &n);
	assert_non_null(out);
	keys_print_list(PAGE_FIT, "", false, out);
	fclose(out);
	for (const struct key *k = KEYS; k->code != 0; k++)
		if (k->brief != NULL && (k->where & (1U << PAGE_FIT)) != 0)
			assert_non_null(strstr(text, k->brief));
	/* Each key is found by what it does, on any page. */
	for (const struct key *k = KEYS; k->code != 0; k++)
		if (k->name != NULL)
			assert_true(keys_count_listed(PAGE_FIT, k->what) > 0);
	/* Two columns of it are on a screen of 80. */
	for (const char *p = text; *p != '\0'; p += strcspn(p, "\n") + 1)
		assert_true(strcspn(p, "\n") <= 40);
	free(text);
	/* So they are where speeds are in rpm. */
	out = open_memstream(&text, &n);
	assert_non_null(out);
	keys_print_list(PAGE_PREDICT, "", true, out);
	fclose(out);
	assert_null(strstr(text, "m/s"));
	assert_non_null(strstr(text, "=1450"));
	for (const char *p = text; *p != '\0'; p += strcspn(p, "\n") + 1)
		assert_true(strcspn(p, "\n") <= 40);
	free(text);
	assert_string_equal(keys_text_for_speed_unit(
				keys_find_by_code('=', PAGE_FIT)->what, false),
	    keys_find_by_code('=', PAGE_FIT)->what);
	assert_int_equal(
	    keys_nth_listed(PAGE_FIT, "CALIBRATE, or", 0)->code, 'f');
	assert_null(keys_nth_listed(PAGE_FIT, "no such word", 0));
	out = open_memstream(&text, &n);
	assert_non_null(out);
	keys_print_list(PAGE_FIT, "grading", false, out);
	fclose(out);
	assert_non_null(strstr(text, "no key for 'grading'"));
	assert_non_null(strstr(text, ":apropos grading"));
	free(text);
}

/* What only that page has or does most, then the keys of all; none of another
 * page. */
static void
the_keys_of_the_open_page_come_first(void **state)
{
	(void)state;
	static const struct {
		enum page page;
		int first, other, none;
	} OF[] = {{PAGE_PREDICT, 'c', 'q', 'v'}, {PAGE_FIT, 'v', 'q', 'r'},
	    {PAGE_SITES, '/', 'q', 'v'}};
	for (size_t i = 0; i < sizeof OF / sizeof OF[0]; i++) {
		size_t n = keys_count_listed(OF[i].page, ""), first = n,
		       other = n;
		for (size_t k = 0; k < n; k++) {
			int code = keys_nth_listed(OF[i].page, "", k)->code;
			first = code == OF[i].first ? k : first;
			other = code == OF[i].other ? k : other;
			assert_int_not_equal(code, OF[i].none);
		}
		assert_true(first < other && other < n);
		assert_null(keys_nth_listed(OF[i].page, "", n));
	}
}

/* A page's list says what its keys do there, and has no key without a function
 * there. */
static void
lists_say_what_keys_do_on_the_page(void **state)
{
	(void)state;
	char *text = NULL;
	size_t n = 0;
	FILE *out = open_memstream(&text, &n);
	assert_non_null(out);
	keys_print_list(PAGE_DATA, "", false, out);
	fclose(out);
	assert_non_null(strstr(text, "by five columns"));
	assert_non_null(strstr(text, "a screen of rows"));
	assert_null(strstr(text, "by 5 m/s"));
	assert_null(strstr(text, "find a word"));
	assert_null(strstr(text, "t T"));
	free(text);
}

static void
keys_are_called_by_every_name(void **state)
{
	(void)state;
	int code;
	for (const struct key *k = KEYS; k->code != 0; k++) {
		if (k->name == NULL)
			continue;
		char *names = strdup(k->name), *save = NULL;
		for (char *name = strtok_r(names, ",", &save); name != NULL;
		     name = strtok_r(NULL, ",", &save)) {
			name += name[0] == ' ';
			assert_true(keys_code_of_name(name, &code));
			enum page page = PAGE_PREDICT;
			while (!(k->where & (1U << page)))
				page++;
			const struct key *found = keys_find_by_code(code, page);
			assert_non_null(found);
			assert_true(found->act == k->act);
			assert_int_equal(found->amount, k->amount);
		}
		free(names);
	}
	assert_true(keys_code_of_name("Esc", &code) && code == 27);
	assert_true(keys_code_of_name("x", &code) && code == 'x');
	assert_false(keys_code_of_name("Rigth", &code));
	assert_false(keys_code_of_name("", &code));
	assert_false(keys_code_of_name("\u00e5", &code));
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(no_key_means_two_things),
	    cmocka_unit_test(every_key_is_found_on_its_pages_only),
	    cmocka_unit_test(second_ways_do_the_same),
	    cmocka_unit_test(the_list_has_every_name),
	    cmocka_unit_test(the_keys_of_the_open_page_come_first),
	    cmocka_unit_test(lists_say_what_keys_do_on_the_page),
	    cmocka_unit_test(keys_are_called_by_every_name),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}

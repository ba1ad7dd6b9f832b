/* One answer in all its forms, and what is known of it.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <math.h>
#include <stdlib.h>

#include "base/text.h"
#include "base/xalloc.h"
#include "io/formats/answer.h"

/* Prints the answer and compares; frees nothing. */
static void
prints(const struct answer *a, enum answer_format format, size_t rows,
    const char *expected)
{
	char *text = NULL;
	size_t n = 0;
	FILE *memory = text_open_memory(&text, &n);
	assert_int_equal(ANSWER_FORMATS[format].print(a, false, memory), rows);
	fclose(memory);
	assert_string_equal(text, expected);
	free(text);
}

static struct answer *
two_sieves(void)
{
	struct answer *a = answer_new("try");
	answer_set_title(a, "a try");
	answer_set_site(a, "Bro", "measured; in May");
	answer_add_columns(a, "sieve_mm: sieve mm, passing_pct: passing %%");
	answer_add_cells(a, "%g %.1f", 4.0, 31.25);
	answer_add_cells(a, "%g %.1f", 2.0, NAN);
	answer_note(a, "P50 %.2f mm", 5.5);
	return a;
}

static void
rows_are_what_a_table_is_to_all(void **state)
{
	(void)state;
	struct answer *a = two_sieves();
	prints(a, ANSWER_TABLE, 2,
	    "a try\ndata: measured\n  sieve mm  passing %\n"
	    "         4       31.2\n         2          -\nP50 5.50 mm\n");
	prints(a, ANSWER_CSV, 2,
	    "command,site,provenance,sieve_mm,passing_pct\n"
	    "try,Bro,measured,4,31.25\ntry,Bro,measured,2,\n");
	prints(a, ANSWER_JSON, 2,
	    "{\"command\":\"try\",\"site\":\"Bro\",\"rows\":["
	    "{\"sieve_mm\":4.0,\"passing_pct\":31.25},"
	    "{\"sieve_mm\":2.0,\"passing_pct\":null}],"
	    "\"provenance\":\"measured; in May\"}\n");
	answer_free(a);
}

static void
fields_keep_their_order_and_kinds(void **state)
{
	(void)state;
	struct answer *a = two_sieves();
	struct fields *o = answer_json_fields(a);
	fields_put_values(o,
	    "speed %g outside %d .poor %g n %zu name %s none %g", 74.0, true,
	    1.0, (size_t)3, "x\"y", NAN);
	answer_add_columns_to_json_fields(a, "passing_pct");
	struct fields *runs = fields_add_list(o, "runs");
	fields_put_values(runs, "%g %g", 69.0, 79.0);
	fields_put_values(fields_add_object(o, "params"), "f_mat %g", 2.5);
	prints(a, ANSWER_JSON, 2,
	    "{\"command\":\"try\",\"site\":\"Bro\",\"speed\":74.0,"
	    "\"outside\":true,\"n\":3,\"name\":\"x\\\"y\",\"none\":null,"
	    "\"passing_pct\":[31.25,null],\"runs\":[69.0,79.0],"
	    "\"params\":{\"f_mat\":2.5},\"provenance\":\"measured; in May\"}"
	    "\n");
	assert_true(answer_find_json_number(a, "poor") == 1);
	answer_free(a);
}

static void
fields_are_found_by_their_paths(void **state)
{
	(void)state;
	struct answer *a = answer_new("try");
	assert_false(answer_has_json_fields(a));
	struct fields *o = answer_json_fields(a);
	fields_put_values(o, "ok %d verdict %s n %zu", true, "good", (size_t)7);
	struct fields *list = fields_add_list(o, "holdout");
	fields_put_values(fields_add_object(list, NULL), "rmse_pct %g", 0.25);
	fields_put_values(fields_add_object(list, NULL), "rmse_pct %g", 0.75);
	fields_put_values(fields_add_object(list, NULL), "rmse_pct %g", NAN);
	fields_put_values(
	    fields_add_object(fields_add_object(o, "a"), "b"), "c %g", -2.0);
	assert_true(answer_has_json_fields(a));
	assert_true(answer_find_json_number(a, "ok") == 1);
	assert_true(answer_find_json_number(a, "n") == 7);
	assert_true(answer_find_json_number(a, "holdout.rmse_pct") == 0.75);
	assert_true(answer_find_json_number(a, "a.b.c") == -2);
	assert_true(isnan(answer_find_json_number(a, "a.b")));
	assert_true(isnan(answer_find_json_number(a, "verdict")));
	assert_true(isnan(answer_find_json_number(a, "o")));
	answer_free(a);
}

/* Without a table the sentences are what was asked for. */
static void
sentences_alone_are_told_to_all(void **state)
{
	(void)state;
	struct answer *a = answer_new("why");
	answer_note(a, "It breaks");
	answer_add_sentence(a, ANSWER_WARNING, "It is far");
	prints(a, ANSWER_TABLE, 0, "Warning: It is far.\nIt breaks.\n");
	prints(
	    a, ANSWER_MARKDOWN, 0, "\nWarning: It is far.\n\nIt breaks.\n\n");
	prints(a, ANSWER_CSV, 2,
	    "command,sentence\nwhy,It breaks\nwhy,It is far\n");
	prints(a, ANSWER_JSON, 0,
	    "{\"command\":\"why\",\"sentences\":[\"It breaks\",\"It is far\"]}"
	    "\n");
	answer_free(a);
}

static void
programs_may_have_a_table_of_their_own(void **state)
{
	(void)state;
	struct answer *a = answer_new("try");
	answer_add_columns(a, "what, at");
	answer_add_keyed_cell(a, "p50_mm", "P50 mm");
	answer_add_cells(a, "%g", 3.0);
	prints(a, ANSWER_CSV, 1, "command,what,at\ntry,p50_mm,3\n");
	answer_begin_table_for_programs(a);
	answer_add_columns(a, "x");
	answer_add_cells(a, "%g %g", 1.0, 2.0);
	prints(a, ANSWER_TABLE, 1, "  what    at\n  P50 mm   3\n");
	prints(a, ANSWER_CSV, 2, "command,x\ntry,1\ntry,2\n");
	answer_free(a);
}

static void
warnings_are_counted(void **state)
{
	(void)state;
	struct answer *a = answer_new("try");
	assert_true(isnan(answer_find_json_number(a, "warnings")));
	answer_add_sentence(
	    a, ANSWER_REMARK, "the feed is that of %g m/s", 74.0);
	assert_true(answer_find_json_number(a, "warnings") == 0);
	answer_add_sentence(a, ANSWER_WARNING, "extrapolated");
	assert_true(answer_find_json_number(a, "warnings") == 1);
	answer_free(a);
}

/* + where it is asked for, but none for what is 0 as shown or missing. */
static void
differences_have_a_sign(void **state)
{
	(void)state;
	struct answer *a = answer_new("try");
	answer_add_columns(a, "difference");
	answer_add_cells(a, "%+.1f %+.1f", 1.25, -1.25);
	answer_add_cells(a, "%+.1f %+.1f", 0.01, -0.01);
	answer_set_missing_text(a, "");
	answer_add_cells(a, "%+.1f %.1f", NAN, -0.01);
	prints(a, ANSWER_CSV, 6,
	    "command,difference\ntry,1.25\ntry,-1.25\n"
	    "try,0.01\ntry,-0.01\ntry,\ntry,-0.01\n");
	prints(a, ANSWER_TABLE, 6,
	    "  difference\n        +1.2\n        -1.2\n         0.0\n"
	    "         0.0\n  \n         0.0\n");
	answer_free(a);
}

/* Text has room for the columns that are needed and for the first of the two
 * that are not; a sentence about the other goes with it.  Files have both. */
static void
text_leaves_out_columns_that_can_be_spared(void **state)
{
	(void)state;
	enum { WIDE = 36 };
	static const char FIRST[] = "first", SECOND[] = "second";
	struct answer *a = answer_new("try");
	FREED char *wide = xcalloc(WIDE + 1, 1);
	for (int i = 0; i < WIDE; i++)
		wide[i] = 'w';
	answer_add_optional_column(a, SECOND, SECOND, 2);
	answer_add_optional_column(a, FIRST, FIRST, 1);
	answer_add_optional_column(a, "needed", "needed", 0);
	answer_add_cells(a, "%s %s %g", wide, wide, 1.0);
	answer_note_on_column(a, SECOND, "of the second");
	answer_note_on_column(a, FIRST, "of the first");
	FREED char *text = xasprintf("  first%*s  needed\n  %s       1\n"
				     "left out for lack of room: second\n"
				     "of the first\n",
	    WIDE - 5, "", wide);
	prints(a, ANSWER_TABLE, 1, text);
	struct answer *copy = answer_copy_escaped(a);
	struct answer_view v = answer_view(copy);
	assert_int_equal(v.n_column, 3);
	assert_int_equal(v.n_sentence, 2);
	answer_free(copy);
	answer_free(a);
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(rows_are_what_a_table_is_to_all),
	    cmocka_unit_test(text_leaves_out_columns_that_can_be_spared),
	    cmocka_unit_test(fields_keep_their_order_and_kinds),
	    cmocka_unit_test(fields_are_found_by_their_paths),
	    cmocka_unit_test(sentences_alone_are_told_to_all),
	    cmocka_unit_test(programs_may_have_a_table_of_their_own),
	    cmocka_unit_test(warnings_are_counted),
	    cmocka_unit_test(differences_have_a_sign),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}

/* The reader of circuits: what a file says, and where its faults are.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/formats/circuit_file.h"

#include <math.h>

#include "sheets.h"

static struct circuit *
read_circuit(const char *text, struct error_list *errors)
{
	*errors = (struct error_list){0};
	return circuit_file_read(put_sheet(text, strlen(text)), NULL, errors);
}

static void
a_circuit_is_what_its_lines_say(void **state)
{
	(void)state;
	/* In two dialects, and in any order of the lines. */
	static const char *const LIKE[] = {
	    "circuit,A\nfeed,new,120.5\n"
	    "crusher,new + back,out,cascade=7.5,speed=70\n"
	    "screen,out,8,over,under,sharpness=6,cut_size=95\n"
	    "split,over,sold=30.5,back\nstockpile,sold,8/11,price=-2.5\n"
	    "stockpile,under\n",
	    "# b\nstockpile;sold;8/11;Price = -2,5\nstockpile;under;\n"
	    "split;over;sold = 30,5;back=69,5\n"
	    "screen;out;8,0;over;under;cut_size=95;sharpness=6;\n"
	    "crusher;new+back;out;speed=70;cascade=7,5\nfeed;new;120,5\n"
	    "circuit;A\n"};
	for (size_t i = 0; i < ARRAY_LEN(LIKE); i++) {
		struct error_list errors;
		struct circuit *c = read_circuit(LIKE[i], &errors);
		assert_non_null(c);
		assert_string_equal(c->name, "A");
		assert_true(c->tph == 120.5);
		assert_int_equal(c->n_stream, 6);
		assert_int_equal(c->n_unit, 6);
		const struct unit *made = c->unit;
		while (made->kind != UNIT_SPLIT)
			made++;
		assert_int_equal(
		    made->out[1], circuit_find_or_add_stream(c, "back"));
		assert_true(fabs(made->share[0] - 0.305) < 1e-15 &&
			    fabs(made->share[1] - 0.695) < 1e-15);
		made = &c->unit[circuit_destination_of_stream(
		    c, circuit_find_or_add_stream(c, "back"))];
		assert_true(made->kind == UNIT_CRUSHER && made->n_in == 2);
		assert_true(made->cascade == 0.075 && made->speed == 70);
		made = &c->unit[circuit_destination_of_stream(
		    c, circuit_find_or_add_stream(c, "out"))];
		assert_true(made->kind == UNIT_SCREEN &&
			    made->opening == 0.008 &&
			    made->partition.sharpness == 6 &&
			    made->partition.cut_size == 0.95);
		made = &c->unit[circuit_destination_of_stream(
		    c, circuit_find_or_add_stream(c, "sold"))];
		assert_true(made->price == -2.5);
		assert_string_equal(made->name, "8/11");
		made = &c->unit[circuit_destination_of_stream(
		    c, circuit_find_or_add_stream(c, "under"))];
		assert_true(isnan(made->price));
		assert_string_equal(made->name, "under");
		circuit_free(c);
	}
}

#define FEED "feed,a,1\n"

static void
faults_have_their_place(void **state)
{
	(void)state;
	static const struct {
		const char *text;
		int line, column;
		const char *says;
	} rows[] = {{"# c\n", 1, 1, "a line that begins with feed"},
	    {"mill,a,b\n", 1, 1, "circuit, feed, crusher"},
	    {FEED "stockpile,a + b\n", 2, 15, "a stream that a unit makes"},
	    {FEED, 1, 6, "a stream that a unit takes"},
	    {FEED "feed,b\nstockpile,a + b\n", 2, 1, "one feed"},
	    {FEED "stockpile,a\nstockpile,a\n", 3, 11, "one use of 'a'"},
	    {FEED "crusher,a,a\n", 2, 11, "one source of 'a'"},
	    {FEED "crusher,a + b,b\n", 1, 6, "a loop that never empties"},
	    {FEED "stockpile,a\ncrusher,b,b\n", 3, 1, "to this crusher"},
	    {FEED "split,a,b=60,c=30\n", 2, 9, "sum to 100 %, got 90 %"},
	    {FEED "split,a,b,c\n", 2, 9, "the rest twice"},
	    {FEED "split,a,b\n", 2, 1, "2 to 16 streams"},
	    {FEED "split,a,b=x,c\n", 2, 11, "a share from 0"},
	    {FEED "screen,a,wide,b,c\n", 2, 10, "an opening in mm"},
	    {FEED "screen,a,4,b,c,sharpnes=3\n", 2, 16, "a setting"},
	    {FEED "crusher,a,b,cascade=95\n", 2, 21, "0 to 90 %"},
	    {FEED "crusher,a +,b\n", 2, 12, "name of a stream"},
	    {"feed,a,0\n", 1, 8, "a feed above 0"},
	    {"feed;a;1.250\n", 1, 8, "read in one way"}};
	for (size_t i = 0; i < ARRAY_LEN(rows); i++) {
		struct error_list errors;
		assert_null(read_circuit(rows[i].text, &errors));
		assert_true(errors.n >= 1);
		const struct error *e = &errors.item[0];
		if (e->line != rows[i].line || e->column != rows[i].column ||
		    strstr(e->text, rows[i].says) == NULL)
			fail_msg("%s: %d:%d: %s", rows[i].text, e->line,
			    e->column, e->text);
		assert_int_equal(e->kind, ERROR_DATA);
		assert_true(e->hint[0] != '\0');
	}
}

static void
too_much_is_refused(void **state)
{
	(void)state;
	struct error_list errors;
	char *text = xstrdup(FEED);
	for (int i = 0; i < CIRCUIT_UNITS; i++)
		xappend(&text, "stockpile,s%d\n", i);
	assert_null(read_circuit(text, &errors));
	assert_non_null(strstr(errors.item[0].text, "at most 64 units"));
	free(text);
	text = xstrdup("feed,a,1\nstockpile,a");
	for (int i = 0; i < UNIT_STREAMS; i++)
		xappend(&text, "+s%d", i);
	assert_null(read_circuit(text, &errors));
	assert_non_null(strstr(errors.item[0].text, "at most 16 streams"));
	free(text);
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(a_circuit_is_what_its_lines_say),
	    cmocka_unit_test(faults_have_their_place),
	    cmocka_unit_test(too_much_is_refused),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}

/* The layout: at every size all that is there lies on the screen, and nothing
 * on top of another.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "base/xalloc.h"
#include "tui/layout.h"

static void
expect_apart(const struct layout *l, int rows, int columns)
{
	const struct area *areas[] = {&l->header, &l->plot, &l->side,
	    &l->legend, &l->differences, &l->numbers, &l->caption, &l->strip,
	    &l->track, &l->command, &l->status, &l->hints};
	for (size_t i = 0; i < ARRAY_LEN(areas); i++) {
		const struct area *a = areas[i];
		if (a->rows == 0)
			continue;
		assert_true(a->rows > 0 && a->columns > 0);
		assert_true(a->row >= 0 && a->row + a->rows <= rows);
		assert_true(
		    a->column >= 0 && a->column + a->columns <= columns);
		for (size_t j = 0; j < i; j++) {
			const struct area *b = areas[j];
			bool beside = a->column >= b->column + b->columns ||
				      b->column >= a->column + a->columns;
			assert_true(b->rows == 0 || beside ||
				    a->row >= b->row + b->rows ||
				    b->row >= a->row + a->rows);
		}
	}
}

static void
expect_all(int rows, int columns, struct layout_ask ask)
{
	struct layout l = layout_make(rows, columns, ask);
	expect_apart(&l, rows, columns);
	assert_int_equal(l.track.rows, 1);
	assert_true(rows < 2 || l.numbers.rows == 1 || l.side.rows > 0);
	/* The same columns as the track, right above it. */
	if (l.strip.rows > 0)
		assert_int_equal(l.strip.row + l.strip.rows, l.track.row);
	assert_int_equal(
	    l.strip.rows, !ask.strip || rows < 24 ? 0 : 3 + (rows - 24) / 10);
	assert_true(!ask.strip || rows < 24 || l.plot.rows >= 8);
}

static void
no_size_is_refused(void **state)
{
	(void)state;
	static const int sides[] = {0, 24, 38, 50};
	for (int rows = 1; rows <= 100; rows++)
		for (int columns = 1; columns <= 300; columns += 3)
			for (size_t i = 0; i < ARRAY_LEN(sides); i++)
				expect_all(rows, columns,
				    (struct layout_ask){
					.side_columns = sides[i],
					.differences = i % 2 == 0,
					.strip = i > 1});
}

static void
panels_drop_in_their_order(void **state)
{
	(void)state;
	struct layout l =
	    layout_make(24, 80, (struct layout_ask){.side_columns = 24});
	assert_true(l.plot.rows >= 14 && l.side.columns == 24);
	assert_int_equal(l.legend.rows, 1);
	l = layout_make(
	    24, 80, (struct layout_ask){.side_columns = 24, .strip = true});
	assert_int_equal(l.strip.rows, 3);
	assert_true(l.plot.rows >= 12);
	l = layout_make(
	    24, 80, (struct layout_ask){.strip = true, .list_rows = 4});
	assert_int_equal(l.body.rows, 4);
	assert_int_equal(l.certainty.row + 1, l.track.row);
	assert_int_equal(l.strip.row + l.strip.rows, l.certainty.row);
	assert_true(l.strip.rows >= 10 && l.legend.rows == 0);
	l = layout_make(18, 80, (struct layout_ask){.side_columns = 24});
	assert_int_equal(l.legend.rows, 0);
	assert_true(l.side.rows > 0);
	l = layout_make(12, 40, (struct layout_ask){.side_columns = 24});
	assert_int_equal(l.side.rows, 0);
	assert_true(l.plot.rows > 0);
	assert_int_equal(l.numbers.rows, 1);
	/* Keys are named; the state has the row of the command. */
	assert_int_equal(l.hints.row, 11);
	assert_int_equal(l.status.rows, 0);
	assert_int_equal(l.wall, -1);
	l = layout_make(30, 100, (struct layout_ask){.side_columns = 34});
	assert_int_equal(l.side.column, l.wall + 2);
	assert_int_equal(l.side.column + l.side.columns, 100);
	assert_int_equal(l.plot.columns, l.wall);
	l = layout_make(9, 33, (struct layout_ask){.side_columns = 24});
	assert_int_equal(l.plot.rows, 0);
	assert_int_equal(l.side.rows, 3);
	assert_int_equal(l.side.columns, 33);
	assert_int_equal(
	    layout_make(9, 20, (struct layout_ask){.side_columns = 24})
		.side.rows,
	    0);
	assert_int_equal(
	    layout_make(9, 33, (struct layout_ask){.side_columns = 0})
		.side.rows,
	    0);
	l = layout_make(5, 20, (struct layout_ask){.side_columns = 24});
	assert_int_equal(l.plot.rows, 0);
	assert_int_equal(l.numbers.rows, 1);
	l = layout_make(1, 20, (struct layout_ask){.side_columns = 24});
	assert_int_equal(l.numbers.rows, 0);
	assert_int_equal(l.track.row, 0);
}

static void
text_has_the_room_at_any_size(void **state)
{
	(void)state;
	for (int rows = 1; rows <= 100; rows++) {
		struct layout l = layout_make_for_text(rows, 80);
		int taken = l.header.rows + l.hints.rows;
		assert_int_equal(l.body.rows + taken, rows);
		assert_int_equal(l.body.row, l.header.rows);
		assert_true(l.body.rows >= 1 && taken <= 2);
		assert_true(l.hints.rows == 0 || l.hints.row == rows - 1);
	}
	assert_int_equal(layout_make_for_text(24, 80).body.rows, 22);
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(no_size_is_refused),
	    cmocka_unit_test(panels_drop_in_their_order),
	    cmocka_unit_test(text_has_the_room_at_any_size),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}

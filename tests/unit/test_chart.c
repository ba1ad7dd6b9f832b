/* Charts on a canvas: exact size, ticks, lines that stay inside and differ.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "plot/draw.h"

static const double SIEVES[] = {
    22.4, 16, 11.2, 8, 5.6, 4, 2, 1, 0.5, 0.25, 0.125, 0.063};
static const double PASSING[] = {100, 99, 97, 92, 83, 66, 34, 18, 9, 5, 2, 1};
enum { N = sizeof SIEVES / sizeof SIEVES[0] };

static const enum charset CHARSETS[] = {
    CHARSET_ASCII, CHARSET_QUADRANTS, CHARSET_BRAILLE};

static struct chart *
empty(void)
{
	return chart_new("title", "made up",
	    axis_new_sieves("size, mm", SIEVES, N),
	    axis_new_percent("passing, %"));
}

/* One curve of the sheet. */
static struct chart *
with(struct chart_series look)
{
	struct chart *chart = empty();
	struct chart_series *s = chart_append_series(chart, look, N, "curve");
	memcpy(s->x, SIEVES, sizeof SIEVES);
	memcpy(s->y, PASSING, sizeof PASSING);
	return chart;
}

static const struct chart_series SOLID = {.series = SERIES_MEASURED_1,
    .line = CHART_SOLID,
    .ascii = '=',
    .mark = 'v'};

static void
any_size_is_exact_and_safe(void **state)
{
	(void)state;
	static const int sizes[][2] = {{20, 5}, {300, 100}, {1, 1}, {2, 3},
	    {40, 12}, {80, 24}, {7, 40}, {300, 3}, {11, 6}};
	struct chart *chart = with(SOLID);
	series_allocate_band(chart->series[0]);
	chart_add_vertical_rule(chart, SERIES_BREAK, 5, "break");
	chart_add_note(chart, "a note of some words that are wrapped");
	for (size_t i = 0; i < sizeof sizes / sizeof sizes[0]; i++)
		for (size_t c = 0; c < 6; c++) {
			struct canvas *canvas = chart_draw(chart, sizes[i][0],
			    sizes[i][1], CHARSETS[c % 3], c < 3);
			assert_int_equal(canvas->columns, sizes[i][0]);
			assert_int_equal(canvas->rows, sizes[i][1]);
			canvas_free(canvas);
		}
	chart_free(chart);
}

/* Cells of a series whose character is `code`, or any for 0. */
static int
count(struct canvas *canvas, enum series series, uint32_t code)
{
	int n = 0;
	for (int i = 0; i < canvas->columns * canvas->rows; i++)
		n += canvas->cell[i].series == series &&
		     canvas->cell[i].code != ' ' &&
		     (code == 0 || canvas->cell[i].code == code);
	return n;
}

/* The row with the most '+', which is the x axis; its ticks by column. */
static int
axis_row(struct canvas *canvas)
{
	int row = 0, most = 0;
	for (int r = 0; r < canvas->rows; r++) {
		int n = 0;
		for (int c = 0; c < canvas->columns; c++)
			n += canvas_cell_at(canvas, c, r)->code == '+';
		if (n > most) {
			most = n;
			row = r;
		}
	}
	return row;
}

static void
every_sieve_has_a_tick_where_it_belongs(void **state)
{
	(void)state;
	struct chart *chart = with(SOLID);
	for (int columns = 60; columns <= 120; columns += 20) {
		struct canvas *c =
		    chart_draw(chart, columns, 24, CHARSET_ASCII, CHART_ALL);
		int row = axis_row(c), left = 4;
		for (size_t i = 0; i < N; i++) {
			double t = log(SIEVES[i] / 0.063) / log(22.4 / 0.063);
			int n = columns - left;
			int at = left + (t < 1 ? (int)(t * n + 1e-9) : n - 1);
			assert_int_equal(canvas_cell_at(c, at, row)->code, '+');
		}
		canvas_free(c);
	}
	chart_free(chart);
}

static void
labels_go_by_rank_and_into_a_second_row(void **state)
{
	(void)state;
	struct axis a = axis_new_sieves("size, mm", SIEVES, N);
	int column[N], row[N];
	assert_int_equal(axis_place_labels(&a, 200, 2, column, row), 1);
	for (size_t i = 0; i < a.n; i++)
		assert_int_equal(row[i], 0);
	assert_int_equal(axis_place_labels(&a, 36, 2, column, row), 2);
	assert_int_equal(row[0], 0);
	assert_int_equal(row[N - 1], 0);
	for (size_t i = 0; i < a.n; i++)
		if (row[i] != AXIS_DROPPED)
			assert_in_range(column[i] + 36 * row[i], 36 * row[i],
			    36 * row[i] + 36 - (int)strlen(a.tick[i].label));
	/* 5.6 and 11.2 give way to 4 and 8. */
	assert_string_equal(a.tick[7].label, "5.6");
	assert_string_equal(a.tick[8].label, "8");
	assert_true(row[8] == 0 && row[7] == 1);
	axis_free(&a);
}

static void
round_axes_cover_what_they_are_asked(void **state)
{
	(void)state;
	static const double ends[][2] = {
	    {0, 1}, {-0.9, 0.8}, {1, 400}, {3, 3}, {0, 0}, {14.8, 29.2}};
	for (size_t i = 0; i < sizeof ends / sizeof ends[0]; i++) {
		struct axis a = axis_new_linear("x", ends[i][0], ends[i][1]);
		assert_true(a.low <= ends[i][0] && a.high >= ends[i][1]);
		assert_in_range(a.n, 2, 9);
		axis_free(&a);
		double low = 0.01 + fabs(ends[i][0]);
		double high = low + fabs(ends[i][1]);
		a = axis_new_log("x", low, high);
		assert_true(a.low <= low && a.high >= high * (1 - 1e-9));
		assert_true(a.n >= 2 && a.low < a.high);
		axis_free(&a);
	}
}

/* Row of a label of the y axis, or -1. */
static int
label_row(struct canvas *c, const char *label)
{
	for (int row = 0; row < c->rows; row++) {
		char text[5] = "";
		for (int i = 0; i < 4; i++)
			text[i] = (char)canvas_cell_at(c, i, row)->code;
		text[strcspn(text, "|+")] = '\0';
		if (strcmp(text + strspn(text, " "), label) == 0)
			return row;
	}
	return -1;
}

/* Whatever the height, a label stands in the row that holds its value or
 * nowhere; the data have all rows but that of the title of the axis and, where
 * there is room, the axis and its labels. */
static void
a_label_stands_where_its_value_is(void **state)
{
	(void)state;
	static const double TICKS[] = {0, 20, 50, 80, 100};
	struct chart *chart = with(SOLID);
	for (int rows = 5; rows <= 40; rows++) {
		struct canvas *c =
		    chart_draw(chart, 60, rows, CHARSET_ASCII, 0);
		int top = canvas_cell_at(c, 0, 0)->code == 'p', seen = 0;
		int height = axis_row(c) > top ? axis_row(c) - top : rows - top;
		for (size_t i = 0; i < sizeof TICKS / sizeof TICKS[0]; i++) {
			char label[24];
			snprintf(label, sizeof label, "%g", TICKS[i]);
			int row = label_row(c, label) - top;
			if (row < 0 || row >= height)
				continue;
			seen++;
			double high = 100 - 100.0 * row / height;
			assert_true(TICKS[i] <= high + 1e-9);
			assert_true(TICKS[i] >= high - 100.0 / height - 1e-9);
		}
		assert_true(seen >= 2);
		canvas_free(c);
	}
	chart_free(chart);
}

/* Of 19.7 and 36.2 % both stood at "50" in a plot of four rows. */
static void
a_mark_has_the_one_cell_of_its_value(void **state)
{
	(void)state;
	for (int rows = 4; rows < 40; rows += 5)
		for (double y = 1.7; y < 100; y += 5.9) {
			struct chart *chart = empty();
			struct chart_series *s = chart_append_series(chart,
			    (struct chart_series){.series = SERIES_MEASURED_1,
				.line = CHART_MARKS,
				.mark = '+',
				.fine = true},
			    1, "mark");
			s->x[0] = 1;
			s->y[0] = y;
			struct canvas *c =
			    chart_draw(chart, 60, rows, CHARSET_BRAILLE, 0);
			int top = canvas_cell_at(c, 0, 0)->code == 'p',
			    foot = rows;
			while (canvas_cell_at(c, 3, foot - 1)->code != 0x2502 &&
			       canvas_cell_at(c, 3, foot - 1)->code != 0x2524)
				foot--;
			int want = (int)((100 - y) / 100 * (foot - top)), n = 0;
			for (int i = 0; i < c->columns * c->rows; i++) {
				if (c->cell[i].series != SERIES_MEASURED_1)
					continue;
				assert_int_equal(i / c->columns - top, want);
				assert_int_equal(c->cell[i].code, 0x25CF);
				n++;
			}
			assert_int_equal(n, 1);
			canvas_free(c);
			chart_free(chart);
		}
}

/* A line that rises to the right: seen from the left, no cell of a column lies
 * wholly below all cells of the column before. */
/* Evenly within the straight part, by factors beyond, alike on both sides. */
static void
a_symmetric_axis_magnifies_what_is_near_0(void **state)
{
	(void)state;
	struct axis a = axis_new_symlog("x", 0.1, 100);
	assert_true(fabs(axis_relative_position(&a, 0) - (0.5)) < 1e-9);
	assert_true(fabs(axis_relative_position(&a, -100) - (0)) < 1e-9);
	assert_true(fabs(axis_relative_position(&a, 1e6) - (1)) < 1e-9);
	double straight = axis_relative_position(&a, 0.1) - 0.5;
	assert_true(fabs(axis_relative_position(&a, 0.05) - 0.5 -
			 (straight / 2)) < 1e-9);
	double decade =
	    axis_relative_position(&a, 1) - axis_relative_position(&a, 0.1);
	assert_true(fabs(decade - (straight * log(10))) < 1e-9);
	for (double x = 0.01; x < 100; x *= 1.3) {
		assert_true(fabs(axis_relative_position(&a, x) +
				 axis_relative_position(&a, -x) - (1)) < 1e-9);
		assert_true(axis_relative_position(&a, 1.3 * x) >
			    axis_relative_position(&a, x));
	}
	for (size_t i = 0; i < a.n; i++)
		assert_true(
		    fabs(atof(a.tick[i].label) - (a.tick[i].at)) < 1e-9);
	axis_free(&a);
}

/* A bar stands in its cell and the one beside it stays free. */
static void
bars_stand_side_by_side(void **state)
{
	(void)state;
	for (size_t c = 0; c < 3; c++) {
		struct chart *chart = empty();
		struct chart_series look = {.series = SERIES_MEASURED_1,
		    .line = CHART_SOLID,
		    .ascii = '|',
		    .bars = true};
		for (int k = 0; k < 2; k++) {
			look.beside = k;
			look.series = (enum series)(SERIES_MEASURED_1 + k);
			struct chart_series *s =
			    chart_append_series(chart, look, 1, "bar %d", k);
			series_allocate_band(s);
			s->x[0] = 1;
			s->low[0] = 20;
			s->high[0] = 80;
		}
		struct canvas *canvas =
		    chart_draw(chart, 60, 24, CHARSETS[c], 0);
		int rows[2] = {0};
		for (int k = 0; k < 60 * 24; k++)
			for (int i = 0; i < 2; i++)
				rows[i] += canvas->cell[k].series ==
					   SERIES_MEASURED_1 + i;
		assert_in_range(rows[0], 12, 15);
		assert_int_equal(rows[0], rows[1]);
		canvas_free(canvas);
		chart_free(chart);
	}
}

/* A mark in a bar, in reverse, with a free cell above and below. */
static void
a_lifted_mark_stands_out_of_its_bar(void **state)
{
	(void)state;
	for (size_t k = 0; k < 3; k++) {
		struct chart *chart = empty();
		struct chart_series *bar = chart_append_series(chart,
		    (struct chart_series){.series = SERIES_MEASURED_1,
			.line = CHART_LONG,
			.ascii = '#',
			.bars = true},
		    1, "bar");
		series_allocate_band(bar);
		struct chart_series *best = chart_append_series(chart,
		    (struct chart_series){.series = SERIES_PREDICTED,
			.mark = 'v',
			.lifted = true},
		    1, "best");
		bar->x[0] = best->x[0] = 2;
		bar->high[0] = 95;
		bar->y[0] = best->y[0] = 50;
		struct canvas *c = chart_draw(chart, 60, 24, CHARSETS[k], 0);
		int n = 0;
		for (int row = 1; row + 1 < c->rows; row++)
			for (int column = 5; column < c->columns; column++) {
				const struct canvas_cell *at =
				    canvas_cell_at(c, column, row);
				if (at->code != 'v')
					continue;
				n++;
				assert_true(at->attribute & CELL_REVERSE);
				for (int by = -1; by <= 1; by += 2) {
					assert_int_equal(
					    canvas_cell_at(c, column, row + by)
						->code,
					    ' ');
					assert_int_equal(
					    canvas_cell_at(
						c, column, row + 2 * by)
						->series,
					    SERIES_MEASURED_1);
				}
			}
		assert_int_equal(n, 1);
		canvas_free(c);
		chart_free(chart);
	}
}

static void
a_rising_curve_rises_in_every_charset(void **state)
{
	(void)state;
	struct chart_series look = SOLID;
	look.mark = 0;
	struct chart *chart = with(look);
	for (size_t k = 0; k < 3; k++) {
		struct canvas *c =
		    chart_draw(chart, 78, 24, CHARSETS[k], CHART_TITLE);
		int before = c->rows, seen = 0;
		for (int x = 0; x < c->columns; x++) {
			int top = c->rows;
			for (int y = c->rows - 1; y >= 0; y--)
				if (canvas_cell_at(c, x, y)->series ==
				    look.series)
					top = y;
			if (top == c->rows)
				continue;
			assert_true(top <= before);
			before = top;
			seen++;
		}
		assert_true(seen >= 73);
		canvas_free(c);
	}
	chart_free(chart);
}

static void
points_outside_stay_off_the_axes(void **state)
{
	(void)state;
	struct chart *chart = with(SOLID);
	chart->series[0]->y[0] = 1e9;
	chart->series[0]->y[N - 1] = -1e9;
	chart->series[0]->y[5] = NAN;
	struct canvas *c =
	    chart_draw(chart, 78, 24, CHARSET_ASCII, CHART_TITLE);
	int row = axis_row(c);
	for (int x = 0; x < c->columns; x++)
		for (int y = row; y < c->rows; y++)
			assert_int_equal(
			    canvas_cell_at(c, x, y)->series, SERIES_TEXT);
	canvas_free(c);
	chart_free(chart);
}

/* Dots of a line in braille. */
static int
ink(enum chart_line line)
{
	int n = 0;
	struct chart *chart =
	    with((struct chart_series){.series = SERIES_OTHER, .line = line});
	struct canvas *c =
	    chart_draw(chart, 200, 60, CHARSET_BRAILLE, CHART_TITLE);
	for (int i = 0; i < c->columns * c->rows; i++)
		if (c->cell[i].series == SERIES_OTHER)
			n += __builtin_popcount(c->cell[i].code & 0xFF);
	canvas_free(c);
	chart_free(chart);
	return n;
}

static void
line_styles_differ_without_colour(void **state)
{
	(void)state;
	assert_true(ink(CHART_SOLID) > ink(CHART_LONG) * 5 / 4);
	assert_true(ink(CHART_LONG) > ink(CHART_DASHED) * 5 / 4);
	assert_true(ink(CHART_DASHED) > ink(CHART_DOTTED) * 5 / 4);
	assert_true(ink(CHART_DOTTED) > 100);
	assert_int_equal(ink(CHART_MARKS), 0);
}

static void
a_mark_stands_at_every_point(void **state)
{
	(void)state;
	struct chart *chart = with(SOLID);
	for (size_t k = 0; k < 3; k++) {
		struct canvas *c =
		    chart_draw(chart, 100, 30, CHARSETS[k], CHART_TITLE);
		assert_int_equal(count(c, SERIES_MEASURED_1, 'v'), N);
		canvas_free(c);
	}
	chart_free(chart);
}

/* Of runs at the same places the one that was held out, whichever is added
 * last. */
static void
a_hollow_mark_is_seen_in_front(void **state)
{
	(void)state;
	for (int k = 0; k < 2; k++) {
		struct chart *chart = empty();
		for (int i = 0; i < 2; i++) {
			struct chart_series *s = chart_append_series(chart,
			    (struct chart_series){.line = CHART_MARKS,
				.series = (enum series)(SERIES_MEASURED_1 + i),
				.mark = k == i ? 'O' : '+',
				.fine = true},
			    N, "run %d", i);
			memcpy(s->x, SIEVES, sizeof SIEVES);
			memcpy(s->y, PASSING, sizeof PASSING);
		}
		for (size_t i = 0; i < 3; i++) {
			struct canvas *c =
			    chart_draw(chart, 75, 18, CHARSETS[i], 0);
			assert_in_range(
			    count(c, (enum series)(SERIES_MEASURED_1 + k),
				CHARSETS[i] == CHARSET_ASCII ? 'O' : 0x25A1),
			    5, 1000);
			assert_int_equal(
			    count(
				c, (enum series)(SERIES_MEASURED_1 + 1 - k), 0),
			    0);
			canvas_free(c);
		}
		chart_free(chart);
	}
}

/* Cells of a band of so many points around the line. */
static int
banded(enum charset charset, double points, uint32_t code)
{
	struct chart_series look = SOLID;
	look.series = SERIES_PREDICTED;
	struct chart *chart = with(look);
	struct chart_series *s = chart->series[0];
	series_allocate_band(s);
	for (size_t i = 0; i < N; i++) {
		s->low[i] = fmax(0, s->y[i] - points);
		s->high[i] = fmin(100, s->y[i] + points);
	}
	struct canvas *c = chart_draw(chart, 78, 24, charset, CHART_TITLE);
	assert_true(count(c, SERIES_PREDICTED, 0) >= 70);
	int n = count(c, SERIES_PREDICTED, code);
	canvas_free(c);
	chart_free(chart);
	return n;
}

/* A row has 5 points: a band of 2 fills none. One of 20 is filled, with dots where
 * these are small. */
static void
a_band_is_no_thicker_than_it_is(void **state)
{
	(void)state;
	assert_in_range(
	    banded(CHARSET_BRAILLE, 10, 0) - banded(CHARSET_BRAILLE, 1, 0), 78,
	    1000);
	assert_in_range(banded(CHARSET_QUADRANTS, 10, 0x2591), 78, 1000);
	assert_in_range(banded(CHARSET_ASCII, 10, ','), 78, 1000);
	for (size_t i = 0; i < 3; i++) {
		assert_int_equal(banded(CHARSETS[i], 1, 0x2591), 0);
		assert_int_equal(banded(CHARSETS[i], 1, ','), 0);
	}
	assert_in_range(banded(CHARSET_BRAILLE, 4, 0), 20, 1000);
}

/* A strip takes its rows from the chart above it, whose axis it shares, and
 * gives way where that becomes too low. */
static void
a_strip_lies_below_its_chart(void **state)
{
	(void)state;
	struct chart *chart = with(SOLID);
	chart->below = with(SOLID);
	chart->below->strip = 4;
	free(chart->below->title);
	chart->below->title = strdup("strip");
	for (int rows = 5; rows < 30; rows++) {
		struct canvas *c =
		    chart_draw(chart, 60, rows, CHARSET_ASCII, 0);
		bool there = rows >= 12;
		assert_int_equal(
		    canvas_cell_at(c, 0, there ? rows - 4 : 0)->code == 's',
		    there);
		assert_int_equal(
		    canvas_cell_at(c, 4, rows - 1)->code == '|' ||
			canvas_cell_at(c, 4, rows - 1)->code == '+',
		    there);
		canvas_free(c);
	}
	chart_free(chart);
}

static void
values_are_read_off_straight_on_the_log(void **state)
{
	(void)state;
	struct chart *chart = with(SOLID);
	const struct chart_series *s = chart->series[0];
	assert_true(
	    fabs(chart_series_y_at_x(chart, s, sqrt(2 * 4)) - 50) < 1e-9);
	assert_true(
	    fabs(chart_series_x_at_y(chart, s, 50) - sqrt(2 * 4)) < 1e-9);
	assert_true(fabs(chart_series_y_at_x(chart, s, 22.4) - 100) < 1e-9);
	assert_true(isnan(chart_series_y_at_x(chart, s, 30)));
	assert_true(isnan(chart_series_x_at_y(chart, s, 0.5)));
	chart_free(chart);
}

/* A line on a log axis is straight there, as it is drawn: half way from 1 to 100
 * it is at 10. */
static void
values_are_read_off_a_log_axis_as_drawn(void **state)
{
	(void)state;
	struct chart *chart = chart_new("search", "",
	    axis_new_linear("x", 0, 2), axis_new_log("y", 0.1, 100));
	struct chart_series *s = chart_append_series(chart, SOLID, 2, "curve");
	const double x[] = {0, 1}, y[] = {100, 1};
	memcpy(s->x, x, sizeof x);
	memcpy(s->y, y, sizeof y);
	assert_true(fabs(chart_series_y_at_x(chart, s, 0.5) - 10) < 1e-9);
	assert_true(fabs(chart_series_x_at_y(chart, s, 10) - 0.5) < 1e-9);
	chart_free(chart);
}

/* Two fields side by side: shaded by the size of their values, labelled. */
static void
fields_are_shaded_and_labelled(void **state)
{
	(void)state;
	struct axis x = {.title = strdup("a"), .low = 0.5, .high = 2.5},
		    y = {.title = strdup("b"), .low = 0.5, .high = 1.5};
	struct chart *chart = chart_new("title", "made up", x, y);
	struct chart_series *s = chart_append_series(
	    chart, (struct chart_series){.mark = '+'}, 2, "fields");
	s->field = calloc(2, sizeof *s->field);
	for (size_t i = 0; i < 2; i++) {
		s->x[i] = (double)i + 1;
		s->y[i] = 1;
		s->field[i].value = i == 0 ? -0.95 : 0.3;
		s->field[i].label = strdup(i == 0 ? "-0.95" : "+0.30");
	}
	struct canvas *c = chart_draw(chart, 40, 9, CHARSET_ASCII, 0);
	char *text = NULL;
	size_t n = 0;
	FILE *memory = open_memstream(&text, &n);
	canvas_print(c, 0, memory);
	fclose(memory);
	assert_non_null(strstr(text, "#######-0.95#######"));
	assert_non_null(strstr(text, "   +0.30"));
	assert_null(strchr(text, ':'));
	free(text);
	canvas_free(c);
	/* Where there is no room the shade alone is left. */
	c = chart_draw(chart, 12, 4, CHARSET_ASCII, 0);
	memory = open_memstream(&text, &n);
	canvas_print(c, 0, memory);
	fclose(memory);
	assert_null(strstr(text, "0.95"));
	assert_non_null(strstr(text, "####"));
	free(text);
	canvas_free(c);
	chart_free(chart);
}

/* Where the ends of both axes are the middles of cells at the edge. */
static void
bare_data_have_all_cells(void **state)
{
	(void)state;
	struct axis x = {.title = strdup("a"), .low = 0.5, .high = 4.5},
		    y = axis_new_linear("b", 0, 2);
	struct chart *chart = chart_new("title", "made up", x, y);
	struct chart_series *s = chart_append_series(chart, SOLID, 4, "curve");
	for (size_t i = 0; i < 4; i++) {
		s->x[i] = (double)i + 1;
		s->y[i] = i < 2 ? 0 : 2;
	}
	struct canvas *c = chart_draw(chart, 4, 2, CHARSET_ASCII, CHART_BARE);
	char *text = NULL;
	size_t n = 0;
	FILE *memory = open_memstream(&text, &n);
	canvas_print(c, 0, memory);
	fclose(memory);
	assert_string_equal(text, "  vv\nvv\n");
	free(text);
	canvas_free(c);
	chart_free(chart);
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(any_size_is_exact_and_safe),
	    cmocka_unit_test(every_sieve_has_a_tick_where_it_belongs),
	    cmocka_unit_test(a_label_stands_where_its_value_is),
	    cmocka_unit_test(a_mark_has_the_one_cell_of_its_value),
	    cmocka_unit_test(labels_go_by_rank_and_into_a_second_row),
	    cmocka_unit_test(round_axes_cover_what_they_are_asked),
	    cmocka_unit_test(a_symmetric_axis_magnifies_what_is_near_0),
	    cmocka_unit_test(bars_stand_side_by_side),
	    cmocka_unit_test(a_lifted_mark_stands_out_of_its_bar),
	    cmocka_unit_test(a_rising_curve_rises_in_every_charset),
	    cmocka_unit_test(points_outside_stay_off_the_axes),
	    cmocka_unit_test(line_styles_differ_without_colour),
	    cmocka_unit_test(a_mark_stands_at_every_point),
	    cmocka_unit_test(a_hollow_mark_is_seen_in_front),
	    cmocka_unit_test(a_band_is_no_thicker_than_it_is),
	    cmocka_unit_test(a_strip_lies_below_its_chart),
	    cmocka_unit_test(values_are_read_off_straight_on_the_log),
	    cmocka_unit_test(values_are_read_off_a_log_axis_as_drawn),
	    cmocka_unit_test(fields_are_shaded_and_labelled),
	    cmocka_unit_test(bare_data_have_all_cells)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}

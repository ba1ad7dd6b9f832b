/* Makes the ticks of axes: sieves, round numbers, decades; places labels by
 * rank.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "plot/axis.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/xalloc.h"

/* Returns true if two sizes are the same but for rounding. */
static bool
are_sieve_sizes_equal(double a, double b)
{
	return fabs(a - b) <= 1e-6 * fabs(b);
}

static bool
is_of_doubling_series(double size)
{
	static const double SERIES[] = {0.063, 0.125, 0.25, 0.5};
	for (size_t i = 0; i < ARRAY_LEN(SERIES); i++)
		if (are_sieve_sizes_equal(size, SERIES[i]))
			return true;
	double power = log2(size);
	return power >= -1e-6 && fabs(power - round(power)) < 1e-6;
}

/* Returns the rank of a sieve's label: 1 for the doubling series, 2 for 5.6,
 * 11.2, 22.4 and 2.8, 1.4, 3 for all others. */
static int
sieve_label_priority(double size)
{
	double power = log2(size / 1.4);
	return is_of_doubling_series(size)                         ? 1
	       : power > -0.5 && fabs(power - round(power)) < 1e-6 ? 2
								   : 3;
}

void
axis_add_tick(struct axis *axis, double at, const char *label, int rank)
{
	axis->tick = xrealloc(axis->tick, axis->n + 1, sizeof *axis->tick);
	struct axis_tick *t = &axis->tick[axis->n++];
	*t = (struct axis_tick){.at = at, .rank = rank};
	snprintf(t->label, sizeof t->label, "%s", label);
}

static void
axis_add_number_tick(struct axis *axis, double at, int rank)
{
	char label[24];
	snprintf(label, sizeof label, "%g", at);
	axis_add_tick(axis, at, label, rank);
}

void
axis_add_signed_number(struct axis *axis, double at, int rank)
{
	char label[24];
	snprintf(label, sizeof label, at == 0 ? "%g" : "%+g", at);
	axis_add_tick(axis, at, label, rank);
	axis->tick[axis->n - 1].guide = at == 0;
}

static int
compare_ticks(const void *a, const void *b)
{
	double x = ((const struct axis_tick *)a)->at;
	double y = ((const struct axis_tick *)b)->at;
	return (x > y) - (x < y);
}

static bool
axis_has_tick_at(const struct axis *axis, double at)
{
	for (size_t i = 0; i < axis->n; i++)
		if (are_sieve_sizes_equal(axis->tick[i].at, at))
			return true;
	return false;
}

struct axis
axis_new_sieves(const char *title, const double *size, size_t n)
{
	struct axis a = {.title = xstrdup(title), .log = true};
	for (size_t i = 0; i < n; i++)
		if (!axis_has_tick_at(&a, size[i]))
			axis_add_number_tick(
			    &a, size[i], sieve_label_priority(size[i]));
	if (a.n == 0)
		axis_add_number_tick(&a, 1, 0);
	qsort(a.tick, a.n, sizeof *a.tick, compare_ticks);
	a.tick[0].rank = a.tick[a.n - 1].rank = 0;
	a.low = a.tick[0].at / (a.n > 1 ? 1 : 2);
	a.high = a.tick[a.n - 1].at * (a.n > 1 ? 1 : 2);
	return a;
}

struct axis
axis_new_percent(const char *title)
{
	static const double TICKS[] = {0, 20, 50, 80, 100};
	struct axis a = {.title = xstrdup(title), .high = 100};
	for (size_t i = 0; i < ARRAY_LEN(TICKS); i++) {
		bool guide = i > 0 && i + 1 < ARRAY_LEN(TICKS);
		axis_add_number_tick(&a, TICKS[i], guide ? 2 - (i == 2) : 0);
		a.tick[i].guide = guide;
	}
	return a;
}

/* Returns 1, 2 or 5 times a power of ten, which goes into range some four
 * times. */
static double
choose_round_axis_step(double range)
{
	double power = pow(10, floor(log10(range / 4)));
	double part = range / 4 / power;
	return power * (part < 1.5 ? 1 : part < 3.5 ? 2 : part < 7.5 ? 5 : 10);
}

struct axis
axis_new_linear(const char *title, double low, double high)
{
	struct axis a = {.title = xstrdup(title)};
	if (!(high > low)) {
		low -= low == 0 ? 1 : fabs(low) / 10;
		high += high == 0 ? 1 : fabs(high) / 10;
	}
	double step = choose_round_axis_step(high - low);
	a.low = floor(low / step + 1e-9) * step;
	a.high = ceil(high / step - 1e-9) * step;
	long n = lround((a.high - a.low) / step);
	for (long i = 0; i <= n; i++) {
		double at = a.low + (double)i * step;
		axis_add_number_tick(&a, fabs(at) < step / 1000 ? 0 : at,
		    i == 0 || i == n ? 0 : 1);
	}
	return a;
}

/* Returns step i of ..., 1, 2, 5, 10, 20, ...; step 0 is 1. */
static double
nth_1_2_5_step(int i)
{
	static const double STEPS[] = {1, 2, 5};
	int decade = (int)floor(i / 3.0);
	return STEPS[i - 3 * decade] * pow(10, decade);
}

struct axis
axis_new_log(const char *title, double low, double high)
{
	struct axis a = {.title = xstrdup(title), .log = true};
	int first = 3 * (int)floor(log10(low));
	while (nth_1_2_5_step(first + 1) <= low * (1 + 1e-9))
		first++;
	int last = first + 1;
	while (nth_1_2_5_step(last) < high * (1 - 1e-9))
		last++;
	for (int i = first; i <= last; i++)
		axis_add_number_tick(&a, nth_1_2_5_step(i),
		    i == first || i == last ? 0
		    : i % 3 == 0            ? 1
					    : 2);
	a.low = a.tick[0].at;
	a.high = a.tick[a.n - 1].at;
	return a;
}

struct axis
axis_new_symlog(const char *title, double straight, double most)
{
	struct axis a = {.title = xstrdup(title),
	    .straight = straight,
	    .low = -most,
	    .high = most};
	axis_add_signed_number(&a, 0, 0);
	for (double decade = straight; decade <= most * 1.001; decade *= 10)
		for (int i = 0; i < 2; i++) {
			double at = i == 0 ? decade : 3 * decade;
			int rank = are_sieve_sizes_equal(at, most) ? 0 : 2 - i;
			if (at > most * 1.001)
				break;
			axis_add_signed_number(&a, at, rank);
			axis_add_signed_number(&a, -at, rank);
		}
	return a;
}

void
axis_free(struct axis *axis)
{
	free(axis->title);
	free(axis->tick);
}

/* Returns a value on the scale of the axis.  On a symmetric one, slopes are
 * equal where the straight part ends. */
static double
axis_scaled_value(const struct axis *axis, double value)
{
	double part = value / axis->straight;
	if (axis->log)
		return log(value);
	if (!(axis->straight > 0))
		return value;
	return fabs(part) <= 1 ? part : copysign(1 + log(fabs(part)), part);
}

const char *
axis_unit_suffix(const struct axis *axis)
{
	const char *unit =
	    axis->title != NULL ? strrchr(axis->title, ',') : NULL;
	return unit == NULL || strcmp(unit, ", -") == 0 ? "" : unit + 1;
}

double
axis_relative_position(const struct axis *axis, double value)
{
	double low = axis_scaled_value(axis, axis->low);
	double high = axis_scaled_value(axis, axis->high);
	if (axis->log && !(value > 0))
		return 0;
	double t = (axis_scaled_value(axis, value) - low) / (high - low);
	return fmin(fmax(t, 0), 1);
}

/* A position on a border, or just before it by rounding, is in the later
 * part. */
int
axis_cell_at_position(double share, int n)
{
	int i = (int)(share * n + 1e-9);
	return i < n ? i : n - 1;
}

/* Returns true if the cells of a row from `from` on are free, with one on
 * either side. */
static bool
is_row_free_for_label(const char *taken, int columns, int from, int length)
{
	for (int i = from - 1; i <= from + length; i++)
		if (i >= 0 && i < columns && taken[i])
			return false;
	return true;
}

static bool
place_axis_label(const struct axis_tick *tick, double share, int columns,
    int rows, char *taken, int *column, int *row)
{
	int length = (int)strlen(tick->label);
	int middle = axis_cell_at_position(share, columns);
	int from = middle - length / 2;
	if (from + length > columns)
		from = columns - length;
	if (from < 0)
		from = 0;
	for (int r = 0; r < rows && length <= columns; r++) {
		char *cells = taken + (size_t)r * (size_t)columns;
		if (!is_row_free_for_label(cells, columns, from, length))
			continue;
		memset(cells + from, 1, (size_t)length);
		*column = from;
		*row = r;
		return true;
	}
	*row = AXIS_DROPPED;
	return false;
}

int
axis_place_labels(
    const struct axis *axis, int columns, int rows, int *column, int *row)
{
	enum { RANKS = 4 };
	int used = 0;
	FREED char *taken = xcalloc((size_t)columns, (size_t)rows + 1);
	for (int rank = 0; rank < RANKS; rank++)
		for (size_t i = 0; i < axis->n; i++) {
			const struct axis_tick *t = &axis->tick[i];
			if (t->rank == rank &&
			    place_axis_label(t,
				axis_relative_position(axis, t->at), columns,
				rows, taken, &column[i], &row[i]) &&
			    row[i] + 1 > used)
				used = row[i] + 1;
		}
	return used;
}

/* Axes: positions of ticks, and the choice of labels to show.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_PLOT_AXIS_H
#define TIPSPEED_PLOT_AXIS_H

#include <stdbool.h>
#include <stddef.h>

/* rank: labels with the lowest rank are placed first.  guide: a faint line is
 * drawn across the plot, if there is room. */
struct axis_tick {
	double at;
	char label[24];
	int rank;
	bool guide;
};

/* An axis from low to high.  log: logarithmic scale.  straight: if positive,
 * the scale is logarithmic on both sides of 0 and linear within +-straight.
 * title: with the unit, "size, mm".  names: ticks are names, not numbers. */
struct axis {
	char *title;
	bool log, names;
	double straight, low, high;
	size_t n;
	struct axis_tick *tick;
};

/* Returns an axis with a tick at every sieve of size [n], mm, in any order and
 * possibly repeated.  The label is the number as given.  Ranks: first the ends,
 * then the doubling series (0.063, 0.125 .. 16), then 5.6, 11.2 and the like,
 * then all others.  There should be two different sizes; a single one gets a
 * range around it. */
struct axis axis_new_sieves(const char *title, const double *size, size_t n);

/* Returns an axis from 0 to 100 %, with guides at 20, 50 and 80 for reading
 * P20, P50 and P80. */
struct axis axis_new_percent(const char *title);

/* Returns an axis with ticks at round numbers, which covers low to high; these
 * may be equal. */
struct axis axis_new_linear(const char *title, double low, double high);

/* As axis_new_linear, but logarithmic, in steps of 1, 2 and 5; low > 0. */
struct axis axis_new_log(const char *title, double low, double high);

/* Returns an axis from -most to +most on a symmetric log scale, with ticks in
 * 1-3-10 steps and a guide at 0; most > straight > 0. */
struct axis axis_new_symlog(const char *title, double straight, double most);

/* axis_add_tick adds a tick; axis_add_signed_number adds one with the label
 * "+3", "-3" or "0", and a guide at 0. */
void axis_add_tick(struct axis *axis, double at, const char *label, int rank);
void axis_add_signed_number(struct axis *axis, double at, int rank);

void axis_free(struct axis *axis);

/* Returns the unit in the title: " mm" for "size, mm", or "". */
const char *axis_unit_suffix(const struct axis *axis);

/* Returns the position of a value, 0 at low and 1 at high, clamped to these. */
double axis_relative_position(const struct axis *axis, double value);

/* Returns which of n equal parts contains a position from 0 to 1. */
int axis_cell_at_position(double share, int n);

enum { AXIS_DROPPED = -1 };

/* Places the labels of an axis across `columns`, equal parts of the axis: by
 * rank, centred, with a space between labels, in at most `rows` rows.  column,
 * row [axis->n]: receive the first column and the row of each label; the row is
 * AXIS_DROPPED if there is no room.  Returns the number of rows used. */
int axis_place_labels(
    const struct axis *axis, int columns, int rows, int *column, int *row);

#endif

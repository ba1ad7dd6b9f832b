/* Sieve curves as plain text.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_PLOT_CURVE_H
#define TIPSPEED_PLOT_CURVE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

/* One curve: size [n] in mm, coarsest first; passing [n] in %; drawn with mark,
 * which is what tells it from the others. */
struct curve {
	const char *name;
	char mark;
	bool points; /* marks at the sieves only, no line */
	size_t n;
	double *size, *passing;
};

/* Prints a plot of passing (0..100 %) against log size, width columns and
 * height rows in all, legend below it: ASCII only. Later curves lie on top. A
 * tick stands at every sieve of the first curve. break_mm: a column of ':' at
 * this size where it lies within the axis; 0: none. */
void curve_print(const struct curve *curve, size_t n, double break_mm,
    int width, int height, FILE *out);

#endif

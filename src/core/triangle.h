/* What discrepancy.c has compiled for each instruction set.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_TRIANGLE_H
#define TIPSPEED_CORE_TRIANGLE_H

#include <stdint.h>

#include "core/discrepancy.h"

/* n cells in columns.  size, run: their numbers; term: as discrepancy_terms
 * has them.  log_size: of the sizes; f, error: room for a number of each;
 * own: the variance of an independent error. */
struct cells {
	size_t n, sizes;
	int64_t *size, *run;
	double own;
	double *h, *term[DISCREPANCY_TERMS];
	double *log_size, *f, *error;
};

/* U [n * n]: the upper half of a symmetric matrix, by rows. */
struct triangle {
	void (*covariance)(const struct cells *c,
	    const double hyper[static HYPERS], double *U);
	void (*cholesky)(double *U, size_t n);
	void (*forward)(const double *U, size_t n, double *d);
};
extern const struct triangle TRIANGLE_BASE, TRIANGLE_AVX2, TRIANGLE_AVX512;

#endif

/* Singular value decomposition, with the same bits on every machine.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_NUMERIC_SVD_H
#define TIPSPEED_CORE_NUMERIC_SVD_H

#include <stddef.h>

/* Computes A = U diag(sigma) V^T.  A [n * rows], column by column and of any
 * shape, is replaced with U, whose columns are orthonormal, or 0 where sigma is
 * 0.  Sets V [n * n], column by column, so that the largest element of each
 * column (the first, if several are equal) is positive, and sigma [n], largest
 * first.  Method: one-sided Jacobi.  Source: Hestenes 1958; Golub and Van Loan,
 * Matrix Computations, section 8.6.  Cannot fail. */
void svd_decompose(double *A, size_t rows, size_t n, double *V, double *sigma);

#endif

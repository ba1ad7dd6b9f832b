/* Polish: from a good candidate to the minimum near it.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_SEARCH_POLISH_H
#define TIPSPEED_CORE_SEARCH_POLISH_H

#include <stdbool.h>

#include "core/search/misfit.h"
#include "core/model/params.h"

struct polish;

/* A workspace for polishing on this misfit, which must outlive it. */
struct polish *polish_new(struct misfit *m);
void polish_free(struct polish *polish);

struct polish_result {
	double misfit;
	int evaluations; /* of the misfit, derivatives included */
	bool converged;  /* at rest: a restart would gain less than 1e-11 */
	bool stopped;    /* by the misfit, on the way */
};

/* The best result so far, which a polish must improve on. */
struct polish_rival {
	double misfit;
	double gains; /* as many times its last gain it may still gain */
};

/* Lowers the misfit from *p within the bounds, with about `most` evaluations;
 * *p moves to the best found and never gets worse.  Gives up where it would
 * come to rest above the rival, or is within 1e-9 of it; NULL for no rival.
 *
 * Bounded least squares by Levenberg and Marquardt: parameters whose bound
 * stands in the way of descent are held, the rest take the damped Gauss-Newton
 * step (QR of the stacked Jacobian), cut off at the bounds.  Where that is
 * slow, a secant method (BFGS) in the coordinates of that QR goes on from
 * there.  Source: More, J. J. (1978), The Levenberg-Marquardt algorithm, in
 * Numerical Analysis, LNM 630; Kanzow, Yamashita, Fukushima (2004), J. Comput.
 * Appl. Math. 172; Lewis, Overton (2013), Nonsmooth optimization via
 * quasi-Newton methods, Math. Program. 141. */
struct polish_result polish_run(struct polish *polish,
    const struct bounds *bounds, int most, const struct polish_rival *rival,
    struct params *p);

#endif

/* Polish: local refinement of a good candidate to the nearby minimum.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_SEARCH_POLISH_H
#define TIPSPEED_CORE_SEARCH_POLISH_H

#include <stdbool.h>

#include "core/search/misfit.h"
#include "core/model/params.h"

struct polish;

/* Returns a workspace for minimising the misfit.  The misfit must outlive the
 * workspace. */
struct polish *polish_new(struct misfit *m);
void polish_free(struct polish *polish);

struct polish_result {
	double misfit;
	int evaluations; /* of the misfit and its derivatives */
	bool converged;  /* a restart would gain less than 1e-11 */
	bool stopped;    /* by misfit_should_stop, before the end */
};

/* The best result so far, which a polish must improve on. */
struct polish_rival {
	double misfit;
	double gains; /* the most that a polish is expected to gain yet, in
		       * multiples of its last gain */
};

/* Lowers the misfit from *p within the bounds, with about `most` evaluations;
 * *p becomes the best point found, never a worse one.  Gives up if it would
 * converge above the rival or to within 1e-9 of it; rival may be NULL.
 *
 * Method: bounded least squares by Levenberg and Marquardt.  Parameters whose
 * bound blocks the descent are held; the others take the damped Gauss-Newton
 * step (QR of the stacked Jacobian), truncated at the bounds.  If that is slow,
 * a secant method (BFGS) in the coordinates of that QR takes over.  Source:
 * More, J. J. (1978), The Levenberg-Marquardt algorithm, in Numerical Analysis,
 * LNM 630; Kanzow, Yamashita, Fukushima (2004), J. Comput. Appl. Math. 172;
 * Lewis, Overton (2013), Nonsmooth optimization via quasi-Newton methods, Math.
 * Program. 141. */
struct polish_result polish_minimise_misfit(struct polish *polish,
    const struct bounds *bounds, int most, const struct polish_rival *rival,
    struct params *p);

#endif

/* Polish: from a good candidate to the bottom of its valley.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_POLISH_H
#define TIPSPEED_CORE_POLISH_H

#include <stdbool.h>

#include "core/misfit.h"
#include "core/params.h"

struct polish;

/* Room for polishing on this misfit, which must outlive it. */
struct polish *polish_new(struct misfit *m);
void polish_free(struct polish *polish);

struct polish_result {
	double misfit;
	int evaluations; /* of the misfit, derivatives included */
	bool converged;  /* no step lowers it by more than 1e-13 of itself */
	bool stopped;    /* by the misfit, on the way */
};

/* What a polish has to be better than, or it is of no use. */
struct polish_rival {
	double misfit;
	double gains; /* as many times its last gain it may still gain */
};

/* Lowers the misfit from *p within the bounds, at most max_steps steps;
 * *p moves to the best found and never gets worse.  Gives up where it would
 * come to rest above the rival, or is within 1e-9 of it; NULL for no rival.
 *
 * Bounded least squares by Levenberg and Marquardt: parameters whose bound
 * stands in the way of descent are held, the rest take the damped Gauss-Newton
 * step (QR of the stacked Jacobian, GSL), cut off at the bounds. Source: More,
 * J. J. (1978), The Levenberg-Marquardt algorithm, in Numerical Analysis, LNM
 * 630; Kanzow, Yamashita, Fukushima (2004), J. Comput. Appl. Math. 172. */
struct polish_result polish_run(struct polish *polish,
    const struct bounds *bounds, int max_steps,
    const struct polish_rival *rival, struct params *p);

#endif

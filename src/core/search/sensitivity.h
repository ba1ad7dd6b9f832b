/* The sensitivity of a fit's products to its parameters.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_SEARCH_SENSITIVITY_H
#define TIPSPEED_CORE_SEARCH_SENSITIVITY_H

#include "core/search/misfit.h"
#include "core/model/params.h"

/* The singular values of the Jacobian of the differences, its columns scaled by
 * the search ranges.  In the gauge, where only the direction matters (D4), the
 * largest parameter is held, and the ranges of the others are twice its size.
 *   column [n]        parameters that may move
 *   range             the change of each parameter that counts as 1
 *   sigma [n]         singular values, largest first
 *   direction [i][c]  share of column c in the direction of sigma i */
struct sensitivity {
	size_t n, column[PARAMS_MOST];
	double range[PARAMS_MOST];
	double misfit;
	double sigma[PARAMS_MOST];
	double direction[PARAMS_MOST][PARAMS_MOST];
};

/* True if a parameter is not fixed and is nearer to a bound than a millionth of
 * its range.  Always false for a parameter of the gauge, whose bounds only
 * limit the scale. */
bool sensitivity_is_param_on_bound(
    const struct bounds *bounds, const struct params *p, size_t j);

/* inward: parameters on a bound may move too; fixed ones never do.  If basis
 * [m->n_residual * PARAMS_MOST] is not NULL, sets its row i to the shift of
 * difference i along each direction; its columns are orthonormal, or 0 where
 * sigma is negligible.  Cannot fail. */
struct sensitivity sensitivity_of_misfit(struct misfit *m,
    const struct params *p, const struct bounds *bounds, bool inward,
    double *basis);

/* The direction in which the misfit at a fitted point rises least, to second
 * order.  part [PARAMS_MOST]: the steps of the parameters, as shares of their
 * search ranges, that together raise the misfit by 10 %; 0 for parameters fixed
 * or on a bound.  reach: the largest absolute step. */
struct flat_direction {
	double part[PARAMS_MOST];
	double reach;
};

/* Cannot fail. */
struct flat_direction sensitivity_flattest_direction(
    struct misfit *m, const struct params *p, const struct bounds *bounds);

#endif

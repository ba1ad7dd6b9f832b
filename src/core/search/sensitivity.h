/* The sensitivity of the products of a fit to its parameters.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_SEARCH_SENSITIVITY_H
#define TIPSPEED_CORE_SEARCH_SENSITIVITY_H

#include "core/search/misfit.h"
#include "core/model/params.h"

/* The singular values of the Jacobian of the differences, its columns scaled by
 * the search ranges; of the parameters in the gauge the largest is held, as
 * only their direction counts (D4), and the others count in shares of twice its
 * size.
 *   column [n]        parameters that may move
 *   range             the size of a share of 1 of each
 *   sigma [n]         singular values, the largest first
 *   direction [i][c]  share of column c in the direction of sigma i */
struct sensitivity {
	size_t n, column[PARAMS_MOST];
	double range[PARAMS_MOST];
	double misfit;
	double sigma[PARAMS_MOST];
	double direction[PARAMS_MOST][PARAMS_MOST];
};

/* On a bound: nearer to it than a millionth of the range, and free to move.  A
 * bound of a parameter in the gauge only limits the scale. */
bool sensitivity_on_bound(
    const struct bounds *bounds, const struct params *p, size_t j);

/* inward: parameters on a bound count among those that may move.  Fixed ones
 * never do.  basis [m->n_residual * PARAMS_MOST] out, or NULL: in row i, how
 * far difference i moves along each direction; columns of length 1 at right
 * angles, 0 where sigma is next to nothing.  Cannot fail. */
struct sensitivity sensitivity_of(struct misfit *m, const struct params *p,
    const struct bounds *bounds, bool inward, double *basis);

/* The direction in which the misfit rises least at a fitted point, to second
 * order.  part [PARAMS_MOST]: how far each parameter moves along it, in shares
 * of its search range, for a rise of a tenth of the misfit; 0 for parameters
 * that are fixed or on a bound.  reach: the longest of these steps. */
struct flat {
	double part[PARAMS_MOST];
	double reach;
};

/* Cannot fail. */
struct flat sensitivity_flat(
    struct misfit *m, const struct params *p, const struct bounds *bounds);

#endif

/* Selection (Eq 3): the fraction of each size that breaks.  The search and the
 * draws of the answer use the vector version in kernel_body.h; test_kernel
 * compares the two.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_MODEL_SELECTION_H
#define TIPSPEED_CORE_MODEL_SELECTION_H

#include <stdbool.h>

#include "core/model/breakage.h"
#include "core/numeric/elementary.h"

/* S, and its derivatives with respect to f_mat, e0_min and alpha. */
enum { SHAPES = 4 };

/* Computes the selection at n sizes: the fraction of each that breaks in k
 * impacts.
 *   S = 1 - exp(-f_mat k (x^alpha E - E0_min)), 0 where the bracket is negative
 * q: f_mat, e0_min, alpha; k: number of impacts, >= 0; E: specific energy,
 * J/kg; log_x [n]: ln of the sizes in m.  shape [4 * n] receives a row of S, in
 * [0, 1], then three rows of its derivatives with respect to q.  Compilers can
 * vectorise the loop.
 * Cannot fail.   Source: paper Eq 3.
 * D1: the printed equation lacks the minus sign and the floor at 0.
 * D2: x is in metres; in millimetres S would be 1 for every class. */
static inline void
selection_shares_at_sizes(const double q[static 3], double k, double E,
    size_t n, const double *log_x, double *shape)
{
	double f = q[0] * k;
	for (size_t i = 0; i < n; i++) {
		double w = el_exp(q[2] * log_x[i]), over = w * E - q[1];
		double lost = el_expm1(-f * over), kept = 1 + lost;
		bool breaks = over > 0;
		shape[i] = breaks ? -lost : 0;
		shape[n + i] = breaks ? k * over * kept : 0;
		shape[2 * n + i] = breaks ? -f * kept : 0;
		shape[3 * n + i] = breaks ? f * E * w * log_x[i] * kept : 0;
	}
}

/* Returns S at one size and adds its derivatives to d [3], if d is not NULL. */
static inline double
selection_share_at_size(
    const double q[static 3], double k, double E, double log_x, double *d)
{
	double shape[4];
	selection_shares_at_sizes(q, k, E, 1, &log_x, shape);
	for (size_t i = 0; i < 3 && d != NULL; i++)
		d[i] += shape[1 + i];
	return shape[0];
}

/* As selection_share_at_size, but with a spectrum of impacts, if there is one,
 * instead of the single impact (D15; see spectrum.h). */
static inline double
selection_share_by_impacts(const struct impacts *impacts,
    const double q[static 3], double k, double E, double log_x, double *d)
{
	if (impacts->n == 0)
		return selection_share_at_size(q, k, E, log_x, d);
	double kept = 0, sum[3] = {0, 0, 0};
	for (size_t j = 0; j < impacts->n; j++) {
		double each[3] = {0, 0, 0}, share = impacts->share[j];
		kept += share * (1 - selection_share_at_size(q, k,
					 impacts->ratio[j] * E, log_x,
					 d != NULL ? each : NULL));
		for (size_t i = 0; i < 3; i++)
			sum[i] += share * each[i];
	}
	if (!(kept > 1e-300))
		return 1;
	double left = el_exp(impacts->number * el_log(kept));
	for (size_t i = 0; d != NULL && i < 3; i++)
		d[i] += impacts->number * left / kept * sum[i];
	return 1 - left;
}

/* As selection_shares_at_sizes, with the breaker's parameters, and with a
 * spectrum of impacts if it has one. */
static inline void
selection_shares_by_impacts(
    const struct breaker *b, size_t n, const double *log_x, double *shape)
{
	const double *q = b->p.at + b->model->strength;
	if (b->impacts.n == 0) {
		selection_shares_at_sizes(q, b->k, b->E, n, log_x, shape);
		return;
	}
	for (size_t i = 0; i < n; i++) {
		double d[SHAPES] = {0};
		d[0] = selection_share_by_impacts(
		    &b->impacts, q, b->k, b->E, log_x[i], d + 1);
		for (size_t s = 0; s < SHAPES; s++)
			shape[s * n + i] = d[s];
	}
}

/* The parameters of Eq 3, in the order of q above.  lower, upper: from Table 2
 * of the paper, whose text counts six variables where there are seven (D7). */
#define SELECTION_PARAMETERS                                 \
	{"f_mat", "kg/(J m)", 0.001, 3, 0, F_MAT_MOST, NAN,  \
	    "material: a higher one breaks more", 0},        \
	    {"e0_min", "J m/kg", 0, 30, 0, E0_MIN_MOST, NAN, \
		"threshold energy for breakage", 0},         \
	{                                                    \
		"alpha", "-", 0, 1, 0, ALPHA_MOST, NAN,      \
		    "size dependency of breakage", 0         \
	}

/* Returns S at ln x, x in m. */
double selection_share_at_log_size(const struct breaker *b, double log_x);

/* Returns the ln x at which -ln(1 - S) equals `exponent`, for the ends of
 * panels in integrals of S.  It rises with the exponent; at 0 it is ln of the
 * break size.  Returns -1000 or 1000 if no size has this exponent. */
double selection_log_size_at_exponent(const struct breaker *b, double exponent);

/* Returns the size, m, where S begins: 0 if every size breaks, INFINITY if none
 * does, as with alpha = 0 and E <= E0_min.
 *   x* = (E0_min / E)^(1 / alpha)
 * Source: Eq 3 at S = 0. */
double selection_break_size_at_energy(const struct params *p, double E);

/* Returns the break size x*, m: the smallest size that can break at tip speed
 * v, m/s, by the strongest of the impacts in the settings, in the parameters'
 * model; 0 if every size breaks, INFINITY if none does. */
double params_break_size_by_impacts(
    const struct params *p, const struct model_settings *settings, double v);

/* Returns Eq 3 as text with the numbers filled in.  The caller frees it. */
char *selection_formula_text(
    const struct params *p, const struct model_settings *settings);

#endif

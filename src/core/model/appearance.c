/* Eq 1: the progeny distribution as a curve.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "core/model/appearance.h"

#include <math.h>

#include "core/numeric/elementary.h"

static double
evaluate_polynomial(const double beta[static 4], double u)
{
	return beta[0] + u * (beta[1] + u * (beta[2] + u * beta[3]));
}

double
appearance_density(const double beta[static 4], double u)
{
	double p = evaluate_polynomial(beta, u);
	return p > 0 ? p : 0;
}

/* Returns the antiderivative of the unclipped polynomial with respect to ln
 * u. */
static double
polynomial_integral(const double beta[static 4], double u)
{
	return beta[0] * el_log(u) +
	       u * (beta[1] + u * (beta[2] / 2 + u * beta[3] / 3));
}

/* Finds where the polynomial turns: the roots of its derivative strictly within
 * [2^-10, 1], in rising order.  Returns their number. */
static size_t
find_turning_points_of_cubic(const double beta[static 4], double at[2])
{
	double c = beta[1], d = 2 * beta[2], e = 3 * beta[3];
	double discriminant = d * d - 4 * e * c;
	if (discriminant < 0)
		return 0;
	double q = -(d + copysign(sqrt(discriminant), d)) / 2;
	double root[2] = {e != 0 ? q / e : NAN, q != 0 ? c / q : NAN};
	if (root[1] < root[0]) {
		double swap = root[0];
		root[0] = root[1];
		root[1] = swap;
	}
	size_t n = 0;
	for (size_t i = 0; i < 2; i++)
		if (root[i] > APPEARANCE_FINEST && root[i] < 1)
			at[n++] = root[i];
	return n;
}

/* Returns the root between a and b, where the polynomial is monotone and
 * changes sign.  Bisects down to neighbouring doubles. */
static double
polynomial_root_between(const double beta[static 4], double a, double b)
{
	int rising = evaluate_polynomial(beta, b) > 0;
	for (;;) {
		double middle = a + (b - a) / 2;
		if (middle <= a || middle >= b)
			return middle;
		if ((evaluate_polynomial(beta, middle) > 0) == rising)
			b = middle;
		else
			a = middle;
	}
}

/* Sets edge to the ends of the intervals of one sign within [2^-10, 1],
 * including both ends.  Returns their number. */
static size_t
find_polynomial_sign_changes(const double beta[static 4], double edge[static 5])
{
	double turn[2], stop[4];
	size_t n_turn = find_turning_points_of_cubic(beta, turn);
	size_t n_stop = 0, n = 0;
	stop[n_stop++] = APPEARANCE_FINEST;
	for (size_t i = 0; i < n_turn; i++)
		stop[n_stop++] = turn[i];
	stop[n_stop++] = 1;
	edge[n++] = stop[0];
	for (size_t i = 1; i < n_stop; i++) {
		double a = evaluate_polynomial(beta, stop[i - 1]);
		double b = evaluate_polynomial(beta, stop[i]);
		if ((a > 0) != (b > 0))
			edge[n++] =
			    polynomial_root_between(beta, stop[i - 1], stop[i]);
	}
	edge[n++] = 1;
	return n;
}

static void
cumulate_piece_integrals(struct appearance *a)
{
	for (size_t i = 0; i < a->n; i++) {
		a->log_lower[i] = el_log(a->lower[i]);
		a->log_upper[i] = el_log(a->upper[i]);
		for (size_t b = 0; b < 4; b++) {
			double before = i > 0 ? a->full[i - 1][b] : 0;
			double from = appearance_power_integral(
			    b, a->log_lower[i], a->lower[i]);
			double to = appearance_power_integral(
			    b, a->log_upper[i], a->upper[i]);
			a->base[i][b] = before - from;
			a->full[i][b] = a->base[i][b] + to;
			a->whole[b] += to - from;
		}
	}
}

struct appearance
appearance_from_beta(const double beta[static 4])
{
	struct appearance a = {.beta = {beta[0], beta[1], beta[2], beta[3]}};
	double edge[5];
	size_t n = find_polynomial_sign_changes(beta, edge);
	for (size_t i = 1; i < n; i++) {
		double middle = edge[i - 1] + (edge[i] - edge[i - 1]) / 2;
		if (!(evaluate_polynomial(beta, middle) > 0))
			continue;
		double share = polynomial_integral(beta, edge[i]) -
			       polynomial_integral(beta, edge[i - 1]);
		a.lower[a.n] = edge[i - 1];
		a.upper[a.n] = edge[i];
		a.total += share > 0 ? share : 0;
		a.n++;
	}
	if (!isfinite(a.total) || !(a.total > 0)) {
		a.total = 0;
		a.n = 0;
	}
	cumulate_piece_integrals(&a);
	return a;
}

double
appearance_argument(enum appearance_form form, double parent, double daughter)
{
	switch (form) {
	case APPEARANCE_PROGENY_MM:
		return daughter * 1000;
	case APPEARANCE_PARENT_MM:
		return parent * 1000;
	default:
		return daughter / parent;
	}
}

void
appearance_power_integrals_up_to(
    const struct appearance *a, double log_u, double parts[static 4])
{
	size_t i = a->n;
	while (i > 0 && log_u <= a->log_lower[i - 1])
		i--;
	if (i == 0 || log_u >= a->log_upper[i - 1]) {
		for (size_t b = 0; b < 4; b++)
			parts[b] = i > 0 ? a->full[i - 1][b] : 0;
		return;
	}
	double u = el_exp(log_u), u2 = u * u;
	const double *base = a->base[i - 1];
	parts[0] = base[0] + log_u;
	parts[1] = base[1] + u;
	parts[2] = base[2] + u2 / 2;
	parts[3] = base[3] + u2 * u / 3;
}

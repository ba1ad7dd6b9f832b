/* Eq 3, its inverse, the break size, and Eq 3 as text.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "core/model/selection.h"

#include <math.h>

#include "base/xalloc.h"

double
selection_share_at_log_size(const struct breaker *b, double log_x)
{
	return selection_share_by_impacts(
	    &b->impacts, b->p.at + b->model->strength, b->k, b->E, log_x, NULL);
}

double
selection_log_size_at_exponent(const struct breaker *b, double exponent)
{
	const double beyond = 1e3, *q = b->p.at + b->model->strength;
	double f = q[0] * b->k;
	double ratio = (exponent / f + q[1]) / b->E;
	if (!(ratio > 0))
		return -beyond;
	if (!(ratio < 1e300))
		return beyond;
	double log_ratio = el_log(ratio);
	if (fabs(log_ratio) >= q[2] * beyond)
		return log_ratio < 0 ? -beyond : beyond;
	return log_ratio / q[2];
}

double
selection_break_size_at_energy(const struct params *p, double E)
{
	const double *q = p->at + breakage_model_of_params(p)->strength;
	if (q[1] <= 0)
		return E > 0 ? 0 : INFINITY;
	if (E <= 0)
		return INFINITY;
	double log_ratio = el_log(q[1] / E);
	if (q[2] * 700 <= fabs(log_ratio))
		return log_ratio < 0 ? 0 : INFINITY;
	return el_exp(log_ratio / q[2]);
}

double
params_break_size_by_impacts(
    const struct params *p, const struct model_settings *settings, double v)
{
	const struct impacts *i = &settings->impacts;
	double most = i->n > 0 ? i->ratio[i->n - 1] : 1;
	return selection_break_size_at_energy(
	    p, most * specific_energy_at_speed(v));
}

char *
selection_formula_text(
    const struct params *p, const struct model_settings *settings)
{
	const double *q = p->at + breakage_model_of_params(p)->strength;
	const struct impacts *impacts = &settings->impacts;
	double k = settings->k;
	if (impacts->n > 0)
		return xasprintf(
		    "S(x) = 1 - (sum of share_j exp(-%.4g (x^%.4g ratio_j E - "
		    "%.4g)))^%.4g over %zu groups of impacts (D15), x in m; "
		    "each bracket 0 where negative",
		    q[0] * k, q[2], q[1], impacts->number, impacts->n);
	return xasprintf("S(x) = 1 - exp(-%.4g (x^%.4g E - %.4g)), x in m; 0 "
			 "where the bracket is negative",
	    q[0] * k, q[2], q[1]);
}

/* Refits all other parameters by a polish at each value of one parameter;
 * estimates densities of draws with a Gaussian kernel (Silverman 1986).
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "core/posterior/profile.h"

#include <gsl/gsl_statistics_double.h>
#include <math.h>

#include "core/search/polish.h"

/* Evaluations in one polish, which starts where its neighbour's ended. */
enum { STEPS = 60 };

/* Fixes the largest parameter of the gauge and limits the others to its
 * size. */
static void
bounds_fix_largest_beta(struct bounds *b, const struct params *p)
{
	size_t gauge = breakage_model_of_params(p)->gauge;
	size_t largest = params_index_of_largest_beta(p);
	for (size_t i = 0; i < gauge; i++) {
		double size = fabs(p->at[largest]);
		b->lower[i] = i == largest ? p->at[i] : -size;
		b->upper[i] = i == largest ? p->at[i] : size;
	}
}

void
profile_misfit(struct misfit *m, const struct params *fit,
    const struct bounds *bounds, size_t j, const double *x, size_t n,
    double *misfit)
{
	struct polish *polish = polish_new(m);
	struct bounds b = *bounds;
	size_t first = 0;
	if (j < breakage_model_of_params(fit)->gauge)
		bounds_fix_largest_beta(&b, fit);
	while (first + 1 < n && x[first] < fit->at[j])
		first++;
	for (int up = 0; up < 2; up++) {
		struct params p = *fit;
		for (size_t i = up ? first : first - 1; i < n;
		     i += up ? 1 : SIZE_MAX) {
			b.lower[j] = b.upper[j] = p.at[j] = x[i];
			misfit[i] =
			    polish_minimise_misfit(polish, &b, STEPS, NULL, &p)
				.misfit;
		}
	}
	polish_free(polish);
}

static double
gauss_kernel(double z)
{
	return exp(-z * z / 2);
}

double
profile_kde_of_draws(
    const double *draw, size_t n, double lower, double upper, double x)
{
	double sd = gsl_stats_sd(draw, 1, n), sum = 0;
	double h = 0.9 * sd * pow((double)n, -0.2);
	for (size_t i = 0; i < n && h > 0; i++)
		sum += gauss_kernel((x - draw[i]) / h) +
		       gauss_kernel((x - 2 * lower + draw[i]) / h) +
		       gauss_kernel((x - 2 * upper + draw[i]) / h);
	return h > 0 ? sum / ((double)n * h * sqrt(2 * acos(-1))) : 0;
}

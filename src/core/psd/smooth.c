/* Distances of points from the line between their neighbours, on log size,
 * compared between curves.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "core/psd/smooth.h"

#include <math.h>

#include "core/numeric/elementary.h"

double
smooth_bend(const struct psd *psd, size_t i)
{
	if (i == 0 || i + 1 >= psd->n)
		return NAN;
	const double *x = psd->size + i, *p = psd->passing + i;
	double t = el_log(x[0] / x[1]) / el_log(x[-1] / x[1]);
	return p[0] - (p[1] + t * (p[-1] - p[1]));
}

/* The bend of a curve at sieve i of another; NAN where it has not the same
 * three sieves side by side. */
static double
bend_of_other(const struct psd *curve, const struct psd *of, size_t i)
{
	for (size_t j = 1; j + 1 < curve->n; j++)
		if (curve->size[j - 1] == of->size[i - 1] &&
		    curve->size[j] == of->size[i] &&
		    curve->size[j + 1] == of->size[i + 1])
			return smooth_bend(curve, j);
	return NAN;
}

/* Bend of curve c at its sieve i less the mean bend of the others there. */
static struct smooth_outlier
compare_bend(const struct psd *const *curve, size_t n, size_t c, size_t i)
{
	struct smooth_outlier out = {.curve = c, .sieve = i};
	double sum = 0;
	for (size_t o = 0; o < n; o++) {
		double bend =
		    o == c ? NAN : bend_of_other(curve[o], curve[c], i);
		if (isnan(bend))
			continue;
		out.others++;
		sum += bend;
	}
	out.off = smooth_bend(curve[c], i);
	if (out.others > 0)
		out.off -= sum / (double)out.others;
	return out;
}

struct smooth_outlier
smooth_outlier(const struct psd *const *curve, size_t n)
{
	struct smooth_outlier worst = {0};
	double bend = 0;
	for (size_t c = 0; c < n; c++)
		for (size_t i = 1; i + 1 < curve[c]->n; i++) {
			struct smooth_outlier o = compare_bend(curve, n, c, i);
			double own = fabs(smooth_bend(curve[c], i));
			double more = fabs(o.off) - fabs(worst.off);
			if (more < -1e-9 || (more < 1e-9 && own <= bend))
				continue;
			worst = o;
			bend = own;
		}
	return worst;
}

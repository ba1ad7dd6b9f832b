/* Sieve curves: passing at a size and size at a passing, interpolated in log
 * size, and the most unusual point of several curves.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "core/psd/psd.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/xalloc.h"
#include "core/numeric/elementary.h"

const double PSD_PASSING[PSD_SIZES] = {0.2, 0.5, 0.8};
const char *const PSD_NAME[PSD_SIZES] = {"P20", "P50", "P80"};
const char *const PSD_KEY[PSD_SIZES] = {"p20", "p50", "p80"};

struct psd
psd_new(size_t n)
{
	return (struct psd){n, xcalloc_doubles(n), xcalloc_doubles(n)};
}

struct psd
psd_copy(const struct psd *psd)
{
	struct psd copy = psd_new(psd->n);
	if (psd->n > 0) {
		memcpy(copy.size, psd->size, psd->n * sizeof *copy.size);
		memcpy(
		    copy.passing, psd->passing, psd->n * sizeof *copy.passing);
	}
	return copy;
}

void
psd_free(struct psd *psd)
{
	free(psd->size);
	free(psd->passing);
	*psd = (struct psd){0, NULL, NULL};
}

double
psd_passing(const struct psd *psd, double x)
{
	assert(psd->n >= 1 && x > 0);
	if (x >= psd->size[0])
		return psd->passing[0];
	for (size_t i = 1; i < psd->n; i++) {
		if (x < psd->size[i])
			continue;
		double coarse = psd->size[i - 1], fine = psd->size[i];
		double t = el_log(x / fine) / el_log(coarse / fine);
		return psd->passing[i] +
		       t * (psd->passing[i - 1] - psd->passing[i]);
	}
	return psd->passing[psd->n - 1];
}

/* Returns the number of half octaves between two sizes, rounded, at least 1. */
static size_t
count_half_octaves(double coarse, double fine)
{
	double n = 2 * el_log(coarse / fine) / el_log(2);
	return n < 1.5 ? 1 : (size_t)(n + 0.5);
}

/* Returns the slope of the straight line from sieve i to the next, in ln of
 * size. */
static double
chord_slope(const double *x, const double *P, size_t i)
{
	return (P[i] - P[i + 1]) / (x[i] - x[i + 1]);
}

/* Returns the slope of the smooth curve at sieve i, limited so that the curve
 * is monotone between sieves. */
static double
smooth_slope_at_sieve(const double *x, const double *P, size_t n, size_t i)
{
	if (i == 0 || i + 1 == n)
		return chord_slope(x, P, i == 0 ? 0 : i - 1);
	double coarser = chord_slope(x, P, i - 1), finer = chord_slope(x, P, i);
	double above = x[i - 1] - x[i], below = x[i] - x[i + 1];
	double middle = (finer * above + coarser * below) / (below + above);
	double sign = (finer < 0 ? -1 : 1) + (coarser < 0 ? -1 : 1);
	return sign *
	       fmin(fabs(finer), fmin(fabs(coarser), 0.5 * fabs(middle)));
}

/* Returns the passing of the smooth curve at a size between sieves i and i + 1;
 * `at` is ln of the size.  Source: Steffen, Astronomy and Astrophysics 239
 * (1990) 443. */
static double
interpolate_smooth_passing(
    const double *x, const double *P, size_t n, size_t i, double at)
{
	double h = x[i] - x[i + 1], d = at - x[i + 1];
	double s = chord_slope(x, P, i);
	double fine = smooth_slope_at_sieve(x, P, n, i + 1),
	       coarse = smooth_slope_at_sieve(x, P, n, i);
	double a = (fine + coarse - 2 * s) / h / h;
	double b = (3 * s - 2 * fine - coarse) / h;
	return P[i + 1] + d * (fine + d * (b + d * a));
}

struct psd
psd_add_points_on_cubic(const struct psd *psd)
{
	size_t n = psd->n, points = n;
	if (n < 3)
		return psd_copy(psd);
	FREED double *x = xcalloc_doubles(n);
	for (size_t i = 0; i < n; i++)
		x[i] = el_log(psd->size[i]);
	for (size_t i = 0; i + 1 < n; i++)
		points +=
		    count_half_octaves(psd->size[i], psd->size[i + 1]) - 1;
	struct psd curve = psd_new(points);
	curve.n = 0;
	for (size_t i = 0; i < n; i++) {
		curve.size[curve.n] = psd->size[i];
		curve.passing[curve.n++] = psd->passing[i];
		if (i + 1 == n)
			break;
		size_t parts =
		    count_half_octaves(psd->size[i], psd->size[i + 1]);
		for (size_t j = 1; j < parts; j++) {
			double share = (double)j / (double)parts;
			double at = x[i] + share * (x[i + 1] - x[i]);
			curve.size[curve.n] = el_exp(at);
			curve.passing[curve.n++] = interpolate_smooth_passing(
			    x, psd->passing, n, i, at);
		}
	}
	return curve;
}

struct psd
psd_new_with_sizes_between(const double *size, size_t n)
{
	const double coarse = 0.0953, fine = 0.14; /* in ln x */
	double span = el_log(size[0] / size[n - 1]);
	struct psd psd = psd_new(n + (size_t)(span / coarse));
	psd.n = 0;
	for (size_t i = 0; i < n; i++) {
		psd.size[psd.n++] = size[i];
		if (i + 1 == n)
			break;
		double gap = el_log(size[i] / size[i + 1]);
		double apart = size[i] > size[0] / 10 ? coarse : fine;
		double parts = floor(gap / apart) + 1;
		for (double k = 1; k < parts; k++)
			psd.size[psd.n++] = size[i] * el_exp(-gap * k / parts);
	}
	return psd;
}

bool
psd_is_same(const struct psd *a, const struct psd *b)
{
	size_t i = 0;
	while (i < a->n && i < b->n && a->size[i] == b->size[i] &&
	       a->passing[i] == b->passing[i])
		i++;
	return a->n > 0 && i == a->n && i == b->n;
}

double
psd_passing_at_sieve(const struct psd *psd, double x)
{
	for (size_t i = 0; i < psd->n; i++)
		if (psd->size[i] == x)
			return psd->passing[i];
	return NAN;
}

double
psd_size_at_passing(const struct psd *psd, double passing)
{
	if (psd->n == 0 || passing > psd->passing[0])
		return NAN;
	for (size_t i = 1; i < psd->n; i++) {
		double above = psd->passing[i - 1], below = psd->passing[i];
		if (passing < below)
			continue;
		/* Where the curve is level, any size would do: take the first
		 * interval's finer end. */
		double t =
		    above > below ? (passing - below) / (above - below) : 0;
		double coarse = psd->size[i - 1], fine = psd->size[i];
		return fine * el_exp(t * el_log(coarse / fine));
	}
	bool only = psd->n == 1 && passing >= psd->passing[0];
	return only ? psd->size[0] : NAN;
}

size_t
psd_sieve_above_widest_gap(const struct psd *psd)
{
	const double factor = 2.5, least = 0.05;
	size_t widest = psd->n;
	double most = factor;
	for (size_t i = 0; i + 1 < psd->n; i++) {
		double ratio = psd->size[i] / psd->size[i + 1];
		if (psd->passing[i] - psd->passing[i + 1] > least &&
		    ratio > most * (1 + 1e-9)) {
			widest = i;
			most = ratio;
		}
	}
	return widest;
}

bool
psd_covers_size(const struct psd *psd, double x)
{
	if (psd->n == 0)
		return false;
	size_t finest = psd->n - 1;
	return x >= psd->size[finest] || psd->passing[finest] <= 0;
}

static int
compare_descending(const void *a, const void *b)
{
	double x = *(const double *)a, y = *(const double *)b;
	return (x < y) - (x > y);
}

size_t
psd_sort_distinct_sizes(double *x, size_t n, double apart)
{
	size_t kept = 0;
	qsort(x, n, sizeof *x, compare_descending);
	for (size_t i = 0; i < n; i++)
		if (kept == 0 || x[kept - 1] - x[i] > apart)
			x[kept++] = x[i];
	return kept;
}

double
psd_rms_difference(const double *a, const double *b, size_t n, size_t *worst)
{
	double sum = 0, largest = -1;
	for (size_t i = 0; i < n; i++) {
		double d = fabs(a[i] - b[i]);
		sum += d * d;
		if (d > largest && worst != NULL) {
			largest = d;
			*worst = i;
		}
	}
	return n > 0 ? sqrt(sum / (double)n) : NAN;
}

double
psd_deviation_from_chord(const struct psd *psd, size_t i)
{
	if (i == 0 || i + 1 >= psd->n)
		return NAN;
	const double *x = psd->size + i, *p = psd->passing + i;
	double t = el_log(x[0] / x[1]) / el_log(x[-1] / x[1]);
	return p[0] - (p[1] + t * (p[-1] - p[1]));
}

/* Returns the bend of a curve at sieve i of another curve, or NAN if it does
 * not have the same three sieves side by side. */
static double
curve_bend_at_same_sieves(
    const struct psd *curve, const struct psd *of, size_t i)
{
	for (size_t j = 1; j + 1 < curve->n; j++)
		if (curve->size[j - 1] == of->size[i - 1] &&
		    curve->size[j] == of->size[i] &&
		    curve->size[j + 1] == of->size[i + 1])
			return psd_deviation_from_chord(curve, j);
	return NAN;
}

/* Returns the bend of curve c at its sieve i minus the mean bend of the others
 * there. */
static struct psd_outlier
curve_bend_minus_mean_of_others(
    const struct psd *const *curve, size_t n, size_t c, size_t i)
{
	struct psd_outlier out = {.curve = c, .sieve = i};
	double sum = 0;
	for (size_t o = 0; o < n; o++) {
		double bend =
		    o == c ? NAN
			   : curve_bend_at_same_sieves(curve[o], curve[c], i);
		if (isnan(bend))
			continue;
		out.others++;
		sum += bend;
	}
	out.off = psd_deviation_from_chord(curve[c], i);
	if (out.others > 0)
		out.off -= sum / (double)out.others;
	return out;
}

struct psd_outlier
psd_find_outlier(const struct psd *const *curve, size_t n)
{
	struct psd_outlier worst = {0};
	double bend = 0;
	for (size_t c = 0; c < n; c++)
		for (size_t i = 1; i + 1 < curve[c]->n; i++) {
			struct psd_outlier o =
			    curve_bend_minus_mean_of_others(curve, n, c, i);
			double own =
			    fabs(psd_deviation_from_chord(curve[c], i));
			double more = fabs(o.off) - fabs(worst.off);
			if (more < -1e-9 || (more < 1e-9 && own <= bend))
				continue;
			worst = o;
			bend = own;
		}
	return worst;
}

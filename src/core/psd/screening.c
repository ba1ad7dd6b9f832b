/* Whiten's efficiency curve, averaged over size classes by Gauss-Legendre
 * quadrature (Napier-Munn et al. 1996, ch. 9).
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "core/psd/screening.h"

#include <math.h>

#include "base/xalloc.h"
#include "core/numeric/elementary.h"

const struct partition PARTITION_IDEAL = {0, 1};

double
partition_share_to_oversize(const struct partition *p, double opening, double d)
{
	double ratio = d / (opening * (p->cut_size > 0 ? p->cut_size : 1));
	if (!(p->sharpness > 0))
		return ratio > 1;
	/* Both are divided by e^a to avoid overflow. */
	double far = el_exp(-p->sharpness);
	double rest =
	    (1 - far) /
	    (el_exp(fmin(p->sharpness * (ratio - 1), 700)) + 1 - 2 * far);
	return 1 - rest;
}

bool
fraction_is_screened(const struct fraction *fraction)
{
	return fraction->fine > 0 || fraction->coarse > 0;
}

/* Returns the mean over a class, by four Gauss points in ln d for every third
 * of an octave or less; for an ideal screen, the part of the class above the
 * cut. */
static double
mean_oversize_share_of_class(
    const struct partition *p, double opening, double coarse, double fine)
{
	static const double AT[2] = {0.3399810435848563, 0.8611363115940526},
			    WEIGHT[2] = {
				0.6521451548625461, 0.3478548451374538};
	double width = el_log(coarse / fine), sum = 0;
	if (!(p->sharpness > 0)) {
		double cut = opening * (p->cut_size > 0 ? p->cut_size : 1);
		double above = el_log(coarse / cut) / width;
		return fmin(fmax(above, 0), 1);
	}
	double parts = floor(width / 0.25) + 1, half = width / parts / 2;
	for (double k = 0; k < parts; k++) {
		double middle = el_log(fine) + (2 * k + 1) * half;
		for (size_t i = 0; i < 2; i++)
			for (double sign = -1; sign <= 1; sign += 2)
				sum +=
				    WEIGHT[i] / 2 *
				    partition_share_to_oversize(p, opening,
					el_exp(middle + sign * half * AT[i]));
	}
	return sum / parts;
}

void
partition_oversize_of_classes(const struct partition *p, double opening,
    const double *size, size_t n, double *out)
{
	for (size_t i = 0; i + 1 < n; i++)
		out[i] = mean_oversize_share_of_class(
		    p, opening, size[i], size[i + 1]);
	out[n - 1] = partition_share_to_oversize(p, opening, size[n - 1] / 2);
}

void
fraction_share_of_each_class(
    const struct fraction *fraction, const double *size, size_t n, double *out)
{
	FREED double *over = xcalloc_doubles(n);
	for (size_t i = 0; i < n; i++)
		out[i] = 1;
	if (fraction->coarse > 0)
		partition_oversize_of_classes(
		    &fraction->partition, fraction->coarse, size, n, over);
	for (size_t i = 0; i < n && fraction->coarse > 0; i++)
		out[i] = 1 - over[i];
	if (fraction->fine > 0)
		partition_oversize_of_classes(
		    &fraction->partition, fraction->fine, size, n, over);
	for (size_t i = 0; i < n && fraction->fine > 0; i++)
		out[i] *= over[i];
}

double
screening_compute_kept_part(
    const struct psd *product, const double *kept, struct psd *part)
{
	size_t n = product->n;
	const double *P = product->passing;
	double below = 0;
	for (size_t i = n; i-- > 0;) {
		double finer = i + 1 < n ? P[i + 1] : 0;
		below += kept[i] * (P[i] - finer);
		part->passing[i] = below;
	}
	double share = below + kept[0] * (1 - P[0]);
	for (size_t i = 0; i < n && share > 0; i++)
		part->passing[i] = fmin(part->passing[i] / share, 1);
	return share;
}

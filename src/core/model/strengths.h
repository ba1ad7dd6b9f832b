/* Rock of two strengths.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_MODEL_STRENGTHS_H
#define TIPSPEED_CORE_MODEL_STRENGTHS_H

/* D16: a share of the rock has a higher threshold in Eq 3 than the rest,
 *   product = (1 - share) product of softer e0_min
 *	     + share product of harder e0_min
 * where e0_min is the geometric mean of the two, weighted by their shares:
 * softer^(1 - share) harder^share = 1.  With one strength, share is 0 and both
 * factors are 1. */
struct strengths {
	double share, softer, harder;
};

/* Returns the share of the softer rock beside the harder; 0 where there is only
 * one strength. */
static inline double
strengths_softer(const struct strengths *rock)
{
	return rock->share > 0 ? 1 - rock->share : 0;
}

/* The strengths at coordinates whose prior is normal, about 0 with a standard
 * deviation of 1 each: 0.4 times the first is the logarithm of harder over
 * softer, and where it is negative, in half of all cases, there is one
 * strength; the second is the logit of the share. */
enum { STRENGTHS_COORDINATES = 2 };
struct strengths strengths_at(const double x[static STRENGTHS_COORDINATES]);

#endif

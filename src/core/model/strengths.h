/* Rock of two strengths.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_MODEL_STRENGTHS_H
#define TIPSPEED_CORE_MODEL_STRENGTHS_H

/* D16: a share of the rock has a higher threshold in Eq 3 than the rest,
 *   product = (1 - share) product of softer e0_min
 * 	     + share product of harder e0_min
 * where e0_min is the geometric mean of both thresholds, weighted by their
 * shares: softer^(1 - share) harder^share = 1.  With one strength, share is 0
 * and both factors are 1. */
struct strengths {
	double share, softer, harder;
};

/* Returns the share of the softer rock, or 0 if there is only one strength. */
static inline double
strengths_softer_share(const struct strengths *rock)
{
	return rock->share > 0 ? 1 - rock->share : 0;
}

/* Returns the strengths for two coordinates, each with a standard normal prior.
 * 0.4 times the first is the logarithm of harder over softer; if the first is
 * negative, as in half of all cases, there is one strength.  The second is the
 * logit of the share. */
enum { STRENGTHS_COORDINATES = 2 };
struct strengths strengths_from_coordinates(
    const double x[static STRENGTHS_COORDINATES]);

#endif

/* Computes rock of two strengths from two normal coordinates (D16).
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "core/model/strengths.h"

#include "core/numeric/elementary.h"

/* Standard deviation of the logarithm of harder over softer; see
 * doc/decisions/two-strengths.md. */
static const double SPREAD = 0.4;

struct strengths
strengths_from_coordinates(const double x[static STRENGTHS_COORDINATES])
{
	if (!(x[0] > 0))
		return (struct strengths){0, 1, 1};
	double log_ratio = SPREAD * x[0], share = 1 / (1 + el_exp(-x[1]));
	return (struct strengths){.share = share,
	    .softer = el_exp(-share * log_ratio),
	    .harder = el_exp((1 - share) * log_ratio)};
}

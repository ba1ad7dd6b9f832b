/* Conversions between SI and the units shown to users: mm and per cent.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_SITEFILE_UNITS_H
#define TIPSPEED_IO_SITEFILE_UNITS_H

/* Limits for the sizes of sieves and feeds.  Sizes outside are typing
 * errors. */
#define SIZE_LEAST_MM 1e-6
#define SIZE_MOST_MM 1e4

#include <math.h>

/* Converts a size from m to mm.  A size from a sheet comes back as the number
 * in the sheet (0.063, not 0.063000000000000000001), exact to 1e-9 mm. */
static inline double
units_m_to_mm(double m)
{
	return isfinite(m) ? round(m * 1e12) / 1e9 : m;
}

/* Converts a passing from 0..1 to per cent; exact for sheets with up to 12
 * decimals. */
static inline double
units_fraction_to_pct(double passing)
{
	return isfinite(passing) ? round(passing * 1e14) / 1e12 : passing;
}

/* Returns the number of decimals to show a speed in m/s with: those that it
 * has, up to the four that are kept of a sheet's, else one. */
static inline int
units_speed_decimals(double v)
{
	double ten = v;
	for (int n = 0; n <= 4; n++, ten *= 10)
		if (fabs(ten - round(ten)) < 1e-6)
			return n > 1 ? n : 1;
	return 1;
}

#endif

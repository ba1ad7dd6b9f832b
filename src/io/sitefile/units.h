/* Converts between SI and what people read: mm, per cent, revolutions.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_SITEFILE_UNITS_H
#define TIPSPEED_IO_SITEFILE_UNITS_H

/* Limits of sizes of sieves and feeds; others are typing errors. */
#define SIZE_LEAST_MM 1e-6
#define SIZE_MOST_MM 1e4

#include <math.h>

/* mm of a size in m; a size that came from a sheet gives its number back
 * (0.063, not 0.063000000000000000001), true to a picometre. */
static inline double
units_mm(double m)
{
	return isfinite(m) ? round(m * 1e12) / 1e9 : m;
}

/* Per cent of a passing, 0..1; exact for sheets with up to 12 decimals. */
static inline double
units_pct(double passing)
{
	return isfinite(passing) ? round(passing * 1e14) / 1e12 : passing;
}

/* Revolutions a minute of a rotor of this diameter in m, at a tip speed in m/s,
 * and back.  (C11 has no pi.) */
static inline double
units_rpm(double v, double rotor)
{
	return 60 * v / (3.14159265358979323846 * rotor);
}

static inline double
units_mps(double rpm, double rotor)
{
	return 3.14159265358979323846 * rotor * rpm / 60;
}

#endif

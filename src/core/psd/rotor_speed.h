/* Rotor speeds in rpm and as tip speeds: v = pi D n / 60.  diameter: of the
 * rotor, m; 0 if not stated.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_PSD_ROTOR_SPEED_H
#define TIPSPEED_CORE_PSD_ROTOR_SPEED_H

#include <math.h>

/* Converts a tip speed, m/s, to rpm.  (C11 has no pi.) */
static inline double
rotor_speed_to_rpm(double v, double diameter)
{
	return 60 * v / (3.14159265358979323846 * diameter);
}

/* Converts rpm to a tip speed, m/s, rounded to a hundredth: rpm are known to
 * one in a thousand. */
static inline double
rotor_speed_from_rpm(double rpm, double diameter)
{
	double v = 3.14159265358979323846 * diameter * rpm / 60;
	return round(100 * v) / 100;
}

/* Returns " (1376 rpm)" or, for a range of tip speeds, " (1329 to 1425 rpm)",
 * to follow m/s in a sentence; "" without a diameter.  high: NAN for one speed.
 * The caller frees it. */
char *rotor_speed_rpm_text(double diameter, double low, double high);

#endif

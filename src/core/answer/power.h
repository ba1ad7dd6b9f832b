/* Power of a crusher's motor: an engineering estimate.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_ANSWER_POWER_H
#define TIPSPEED_CORE_ANSWER_POWER_H

#include <stdbool.h>
#include <stddef.h>

/* What a motor took: tip speed, m/s; kW; t/h through the rotor. */
struct reading {
	double speed, kw, tph;
};

/* What throwing alone takes, kW: 1/2 v^2 Q, the kinetic energy of what leaves
 * the rotor. */
double power_kinetic(double speed, double tph);

/* P = idle + factor 1/2 v^2 Q, by least squares on n readings.  With one, or
 * where all have the same kinetic power, or idle would be below 0, idle is 0
 * (no_idle); with none the factor is 1, which is the least there can be.
 * rms: what the readings miss by, kW; spread: their standard deviation from the
 * line, NAN where they are as few as the unknowns.  mean, squares: of the
 * readings' kinetic powers, and the sum of their squares about it. */
struct power {
	size_t n;
	bool no_idle;
	double idle, factor, rms, spread, mean, squares;
};
struct power power_fit(const struct reading *reading, size_t n);

/* Whether of readings with alike tonnages one with a clearly higher speed takes
 * less: no motor does so, and no line through them holds. */
bool power_falls(const struct reading *reading, size_t n);

double power_at(const struct power *p, double speed, double tph);

/* Half of the middle `level` of what the motor takes, by the scatter of the
 * readings (Student's t); NAN where it is not known. */
double power_half(
    const struct power *p, double speed, double tph, double level);

#endif

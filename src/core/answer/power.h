/* Power of a crusher's motor: an engineering estimate.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_ANSWER_POWER_H
#define TIPSPEED_CORE_ANSWER_POWER_H

#include <stdbool.h>
#include <stddef.h>

enum { POWER_DRAWS = 256 };

/* A reading of the motor: tip speed, m/s; kW; t/h through the rotor, 0:
 * empty. */
struct reading {
	double speed, kw, tph;
};

/* Returns the power to accelerate the rock, kW: Q v^2.  A rotor that brings a
 * mass flow Q from rest to the speed of its rim turns it with the torque Q v r
 * (Euler); half of that power leaves as kinetic energy, half is lost on the way
 * out. */
double power_kinetic(double speed, double tph);

/* P = idle (v / at)^exponent + factor Q v^2: draws consistent with readings
 * that err by 2 % each, or by their scatter where it is larger.  Uniform
 * priors: idle from 0 up, exponent from 1 (friction) to 3 (air), factor from 1
 * up to what leaves no idle.  least: no reading is of a loaded crusher, so that
 * the factor is 1, its least; below: all readings are below Q v^2, so that no
 * factor from 1 up fits and the largest is taken.  at: mean speed of the
 * readings.  rms: their residuals about the mean, kW. */
struct power {
	size_t n;
	bool least, below;
	double at, rms;
	struct power_draw {
		double idle, exponent, factor;
	} draw[POWER_DRAWS];
};
struct power power_fit(const struct reading *reading, size_t n);

/* True if, of two readings with similar tonnages, the clearly faster one shows
 * less power: no motor does so, and no estimate from such readings holds. */
bool power_falls_with_speed(const struct reading *reading, size_t n);

/* Return the power in a draw, kW, and its idle part.  draw may be any number;
 * it is used modulo POWER_DRAWS. */
double power_at(const struct power *p, size_t draw, double speed, double tph);
double power_idle(const struct power *p, size_t draw, double speed);

#endif

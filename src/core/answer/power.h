/* The power of a crusher's motor: an engineering estimate.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_ANSWER_POWER_H
#define TIPSPEED_CORE_ANSWER_POWER_H

#include <stdbool.h>
#include <stddef.h>

enum { POWER_DRAWS = 256 };

/* A reading of the motor: tip speed, m/s; power, kW; throughput of the rotor,
 * t/h (0: empty). */
struct reading {
	double speed, kw, tph;
};

/* Returns the power that accelerates the rock, kW: Q v^2.  A rotor of radius r
 * that brings a mass flow Q from rest to its tip speed needs the torque Q v r
 * (Euler).  Half of that power leaves as kinetic energy; half is lost inside
 * the rotor. */
double power_to_accelerate_rock(double speed, double tph);

/* P = idle (v / at)^exponent + factor Q v^2.  The draws are consistent with
 * readings whose errors are 2 %, or their scatter if larger.  Priors are
 * uniform: idle from 0 up, exponent from 1 (friction) to 3 (air), factor from 1
 * to the value that leaves no idle power.  least: no reading is of a loaded
 * crusher, so the factor is 1, its minimum.  below: all readings are below Q
 * v^2, so that no factor of 1 or more fits, and the largest that leaves some
 * idle power is used.  at: mean speed of the readings.  rms: RMS residual about
 * the mean of the draws, kW. */
struct power {
	size_t n;
	bool least, below;
	double at, rms;
	struct power_draw {
		double idle, exponent, factor;
	} draw[POWER_DRAWS];
};
struct power power_fit_readings(const struct reading *reading, size_t n);

/* True if, of two readings at similar tonnages, the clearly faster one shows
 * less power.  A motor cannot do that, so an estimate from such readings is not
 * valid. */
bool power_is_falling_with_speed(const struct reading *reading, size_t n);

/* Return the power in a draw, kW, and the idle part of it.  draw is taken
 * modulo POWER_DRAWS. */
double power_kw_of_posterior_draw(
    const struct power *p, size_t draw, double speed, double tph);
double power_idle_kw_of_draw(const struct power *p, size_t draw, double speed);

#endif

/* Power of a crusher's motor: an engineering estimate.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_ANSWER_POWER_H
#define TIPSPEED_CORE_ANSWER_POWER_H

#include <stdbool.h>
#include <stddef.h>

enum { POWER_DRAWS = 256 };

/* What a motor took: tip speed, m/s; kW; t/h through the rotor, 0: empty. */
struct reading {
	double speed, kw, tph;
};

/* What throwing alone takes, kW: Q v^2.  A rotor that brings a mass flow Q from
 * rest to the speed of its rim turns it with the torque Q v r (Euler); half of
 * that power leaves as kinetic energy, half is lost on the way out. */
double power_thrown(double speed, double tph);

/* P = idle (v / at)^exponent + factor Q v^2: what is consistent with readings
 * that err by 2 % each, or by their scatter where that is more: idle from 0 up
 * and exponent from 1 (friction) to 3 (air) alike beforehand, factor from 1 up
 * to what leaves no idle.  Where no reading is of a loaded crusher the factor
 * is 1, which is the least there can be (least); where all take less than
 * Q v^2 no factor from 1 up fits, and the largest is taken (below).
 * at: mean speed of the readings.  rms: what these miss the mean by, kW. */
struct power {
	size_t n;
	bool least, below;
	double at, rms;
	struct power_draw {
		double idle, exponent, factor;
	} draw[POWER_DRAWS];
};
struct power power_fit(const struct reading *reading, size_t n);

/* Whether of readings with alike tonnages one with a clearly higher speed takes
 * less: no motor does so, and no estimate from them holds. */
bool power_falls(const struct reading *reading, size_t n);

/* Of a draw, taken round after round: what the motor takes, and of that what it
 * takes empty, kW. */
double power_at(const struct power *p, size_t draw, double speed, double tph);
double power_idle(const struct power *p, size_t draw, double speed);

#endif

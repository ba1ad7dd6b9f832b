/* Checks the power that flow estimates from readings of the motor, for machines
 * whose idle power grows as a power of the speed, and readings with errors.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>

#include "core/answer/power.h"
#include "core/numeric/rng.h"
#include "core/posterior/ensemble.h"
#include "counts.h"

enum { READINGS = 5 };

/* The readings taken: m/s and t/h. */
static const struct plan {
	const char *name;
	size_t n;
	double at[READINGS][2];
} PLANS[] = {
    {"one", 1, {{72, 120}}},
    {"two, like tonnes", 2, {{69, 118}, {77, 121}}},
    {"three, like tonnes", 3, {{69, 118}, {74, 120}, {79, 121}}},
    {"three, 90 to 130 t/h", 3, {{69, 90}, {74, 130}, {79, 110}}},
    {"one and two empty", 3, {{72, 120}, {66, 0}, {78, 0}}},
    {"three and two empty", 5,
	{{69, 118}, {74, 120}, {79, 121}, {66, 0}, {78, 0}}},
};

/* The questions: m/s and t/h. */
static const double ASKED[2][2] = {{82, 120}, {74, 90}};

/* idle: the idle power at 72 m/s. */
struct machine {
	double idle, exponent, factor;
};

static double
taken(const struct machine *m, const double at[2])
{
	return m->idle * pow(at[0] / 72, m->exponent) +
	       m->factor * power_to_accelerate_rock(at[0], at[1]);
}

/* Returns the power from a constant idle power and a factor by least squares,
 * without idle if it would be negative.  The estimate is compared with this. */
static double
constant_idle(const struct reading *r, size_t n, const double at[2])
{
	double x = 0, y = 0, xx = 0, xy = 0, all = (double)n;
	for (size_t i = 0; i < n; i++) {
		double t = power_to_accelerate_rock(r[i].speed, r[i].tph);
		x += t / all;
		y += r[i].kw / all;
		xx += t * t / all;
		xy += t * r[i].kw / all;
	}
	double slope = (xy - x * y) / (xx - x * x), idle = y - slope * x;
	if (!(idle >= 0) || !(slope > 0)) {
		slope = xy / xx;
		idle = 0;
	}
	return idle + slope * power_to_accelerate_rock(at[0], at[1]);
}

struct sums {
	size_t inside;
	double error, other, width;
};

static void
count_machine(const struct plan *plan, uint64_t number, struct sums sums[2])
{
	struct rng_key key = rng_make_key(number, 0, 90);
	struct machine m = {20 + 60 * rng_uniform(key, 0),
	    0.5 + 2.5 * rng_uniform(key, 1), 1 + 0.5 * rng_uniform(key, 2)};
	struct reading r[READINGS];
	for (size_t i = 0; i < plan->n; i++)
		r[i] = (struct reading){plan->at[i][0],
		    taken(&m, plan->at[i]) *
			(1 + 0.02 * rng_normal(key, (uint32_t)(10 + i))),
		    plan->at[i][1]};
	struct power p = power_fit_readings(r, plan->n);
	for (size_t q = 0; q < 2; q++) {
		double draw[POWER_DRAWS], mean = 0, range[2];
		double truth = taken(&m, ASKED[q]);
		for (size_t d = 0; d < POWER_DRAWS; d++) {
			draw[d] = power_kw_of_posterior_draw(
			    &p, d, ASKED[q][0], ASKED[q][1]);
			mean += draw[d] / POWER_DRAWS;
		}
		ensemble_interval_around_answer(draw, 0.8, mean, range);
		double off = mean / truth - 1,
		       other = constant_idle(r, plan->n, ASKED[q]) / truth - 1;
		sums[q].inside += range[0] <= truth && truth <= range[1];
		sums[q].error += off * off;
		sums[q].other += other * other;
		sums[q].width += (range[1] - range[0]) / truth;
	}
}

bool
count_power(size_t n)
{
	bool ok = true;
	printf("%-22s %s\n%-22s %s\n", "",
	    "        82 m/s, 120 t/h                74 m/s, 90 t/h", "readings",
	    "   held %    error %  constant  width    held %    error %  "
	    "constant  width");
	for (size_t k = 0; k < sizeof PLANS / sizeof *PLANS; k++) {
		struct sums sums[2] = {{0}};
		for (size_t i = 0; i < n; i++)
			count_machine(&PLANS[k], i + 1, sums);
		printf("%-22s", PLANS[k].name);
		for (size_t q = 0; q < 2; q++) {
			const struct sums *s = &sums[q];
			ok = counts_share(s->inside, n, 0.72, 1) && ok;
			printf(" %8.1f %9.1f %6.1f ",
			    100 * sqrt(s->error / (double)n),
			    100 * sqrt(s->other / (double)n),
			    100 * s->width / (double)n);
		}
		printf("\n");
	}
	return ok;
}

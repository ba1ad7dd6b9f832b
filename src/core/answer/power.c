/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "core/answer/power.h"

#include <math.h>

#include <gsl/gsl_cdf.h>

double
power_kinetic(double speed, double tph)
{
	/* m2/s2 times t/h, which are 1 / 3.6 kg/s; W to kW. */
	return speed * speed * tph / 2 / 3.6 / 1000;
}

/* A line through 0. */
static void
fit_factor(struct power *p, const struct reading *reading)
{
	double xx = 0, xy = 0;
	for (size_t i = 0; i < p->n; i++) {
		double x = power_kinetic(reading[i].speed, reading[i].tph);
		xx += x * x;
		xy += x * reading[i].kw;
	}
	p->no_idle = true;
	p->idle = 0;
	p->factor = xy / xx;
	p->mean = 0;
	p->squares = xx;
}

static void
fit_both(struct power *p, const struct reading *reading)
{
	double y = 0, xy = 0, n = (double)p->n;
	for (size_t i = 0; i < p->n; i++) {
		p->mean += power_kinetic(reading[i].speed, reading[i].tph) / n;
		y += reading[i].kw / n;
	}
	for (size_t i = 0; i < p->n; i++) {
		double x =
		    power_kinetic(reading[i].speed, reading[i].tph) - p->mean;
		p->squares += x * x;
		xy += x * (reading[i].kw - y);
	}
	p->factor = xy / p->squares;
	p->idle = y - p->factor * p->mean;
}

struct power
power_fit(const struct reading *reading, size_t n)
{
	struct power p = {.n = n, .factor = 1, .rms = NAN, .spread = NAN};
	const double alike = 1e-6;
	if (n == 0) {
		p.no_idle = true;
		return p;
	}
	if (n > 1)
		fit_both(&p, reading);
	if (n == 1 || !(p.squares > alike * p.mean * p.mean) ||
	    !(p.idle >= 0) || !(p.factor > 0))
		fit_factor(&p, reading);
	double sum = 0;
	for (size_t i = 0; i < n; i++) {
		double off = reading[i].kw -
			     power_at(&p, reading[i].speed, reading[i].tph);
		sum += off * off;
	}
	size_t unknowns = p.no_idle ? 1 : 2;
	p.rms = sqrt(sum / (double)n);
	if (n > unknowns)
		p.spread = sqrt(sum / (double)(n - unknowns));
	return p;
}

bool
power_falls(const struct reading *reading, size_t n)
{
	const double faster = 1.03, alike = 0.05;
	for (size_t i = 0; i < n; i++)
		for (size_t k = 0; k < n; k++)
			if (reading[k].speed > faster * reading[i].speed &&
			    reading[k].kw < reading[i].kw &&
			    reading[k].tph > (1 - alike) * reading[i].tph)
				return true;
	return false;
}

double
power_at(const struct power *p, double speed, double tph)
{
	return p->idle + p->factor * power_kinetic(speed, tph);
}

double
power_half(const struct power *p, double speed, double tph, double level)
{
	if (!isfinite(p->spread))
		return NAN;
	double unknowns = p->no_idle ? 1 : 2;
	double x = power_kinetic(speed, tph) - p->mean;
	double mean = p->no_idle ? 0 : 1 / (double)p->n;
	double share = mean + x * x / p->squares;
	return gsl_cdf_tdist_Pinv((1 + level) / 2, (double)p->n - unknowns) *
	       p->spread * sqrt(share);
}

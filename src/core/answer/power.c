/* Weights a grid of exponents and factors by their least-squares fit to the
 * readings, each with a normal distribution of the idle power that is truncated
 * at 0, and takes draws at even steps of the cumulative weight.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "core/answer/power.h"

#include <math.h>

#include <gsl/gsl_cdf.h>

static const double READING_ERROR = 0.02;

/* The numbers of exponents and factors that are tried. */
enum { EXPONENTS = 17, FACTORS = 64, TRIED = EXPONENTS * FACTORS };

double
power_to_accelerate_rock(double speed, double tph)
{
	/* 1 t/h is 1 / 3.6 kg/s; converts W to kW. */
	return speed * speed * tph / 3.6 / 1000;
}

/* An exponent and a factor, with the idle power that fits best, its standard
 * deviation, and the sum of squares there, in errors of a reading.  The idle
 * power is limited so that the tail of its normal distribution does not
 * underflow. */
struct trial {
	double exponent, factor, idle, sd, squares;
};

static void
fit_trial_idle_power(
    struct trial *t, const struct power *p, const struct reading *reading)
{
	double xx = 0, xy = 0, yy = 0;
	for (size_t i = 0; i < p->n; i++) {
		const struct reading *r = &reading[i];
		double sd = READING_ERROR * r->kw,
		       x = pow(r->speed / p->at, t->exponent) / sd,
		       y = (r->kw - t->factor * power_to_accelerate_rock(
						    r->speed, r->tph)) /
			   sd;
		xx += x * x;
		xy += x * y;
		yy += y * y;
	}
	t->sd = 1 / sqrt(xx);
	t->idle = fmax(xy / xx, -8 * t->sd);
	t->squares = yy - 2 * t->idle * xy + t->idle * t->idle * xx;
}

/* Finds the range of factors to try: from 1 to the largest of any reading
 * without idle power. */
static void
set_speed_and_find_factor_range(
    struct power *p, const struct reading *reading, double range[2])
{
	double top = 0;
	for (size_t i = 0; i < p->n; i++) {
		p->at += reading[i].speed / (double)p->n;
		if (reading[i].tph > 0)
			top =
			    fmax(top, reading[i].kw / power_to_accelerate_rock(
							  reading[i].speed,
							  reading[i].tph));
	}
	p->least = !(top > 0);
	p->below = !p->least && top < 1;
	range[0] = p->below ? top : 1;
	range[1] =
	    p->least || p->below ? range[0] : top * (1 + 3 * READING_ERROR);
}

/* Computes weight [TRIED]: the probability of each trial given the readings,
 * integrated over its idle power; the weights add up to 1. */
static void
weigh_idle_power_trials(const struct power *p, struct trial *t, double *weight)
{
	double least = INFINITY, sum = 0;
	for (size_t k = 0; k < TRIED; k++)
		least = fmin(least, t[k].squares);
	/* The factor by which the variance of the readings exceeds the stated
	 * one. */
	double wider = p->n > 3 ? fmax(1, least / (double)(p->n - 3)) : 1;
	for (size_t k = 0; k < TRIED; k++) {
		t[k].sd *= sqrt(wider);
		weight[k] = exp((least - t[k].squares) / 2 / wider) * t[k].sd *
			    gsl_cdf_ugaussian_P(t[k].idle / t[k].sd);
		sum += weight[k];
	}
	for (size_t k = 0; k < TRIED; k++)
		weight[k] /= sum;
}

/* Takes draws at even steps of the cumulative weight.  The idle power is taken
 * at quantiles spaced by the golden section, so that each call gives the same
 * draws. */
static void
fill_power_draws_from_trials(
    struct power *p, const struct trial *t, const double *weight)
{
	const double golden = 0.6180339887498949;
	double until = weight[0];
	for (size_t d = 0, k = 0; d < POWER_DRAWS; d++) {
		while (until < ((double)d + 0.5) / POWER_DRAWS && k + 1 < TRIED)
			until += weight[++k];
		double u = fmod(((double)d + 0.5) * golden, 1),
		       above = gsl_cdf_ugaussian_P(t[k].idle / t[k].sd);
		p->draw[d] = (struct power_draw){
		    fmax(0, t[k].idle +
				t[k].sd * gsl_cdf_ugaussian_Qinv(u * above)),
		    t[k].exponent, t[k].factor};
	}
}

static void
fit_power_draws_to_readings(struct power *p, const struct reading *reading)
{
	struct trial t[TRIED];
	double range[2], weight[TRIED];
	set_speed_and_find_factor_range(p, reading, range);
	for (size_t k = 0; k < TRIED; k++) {
		double e = (double)(k / FACTORS) / (EXPONENTS - 1),
		       f = ((double)(k % FACTORS) + 0.5) / FACTORS;
		t[k].exponent = 1 + 2 * e;
		t[k].factor = range[0] + f * (range[1] - range[0]);
		fit_trial_idle_power(&t[k], p, reading);
	}
	weigh_idle_power_trials(p, t, weight);
	fill_power_draws_from_trials(p, t, weight);
}

struct power
power_fit_readings(const struct reading *reading, size_t n)
{
	struct power p = {.n = n, .least = true};
	if (n > 0)
		fit_power_draws_to_readings(&p, reading);
	else
		for (size_t d = 0; d < POWER_DRAWS; d++)
			p.draw[d].factor = 1;
	for (size_t i = 0; i < n; i++) {
		double off = reading[i].kw;
		for (size_t d = 0; d < POWER_DRAWS; d++)
			off -= power_kw_of_posterior_draw(
				   &p, d, reading[i].speed, reading[i].tph) /
			       POWER_DRAWS;
		p.rms += off * off / (double)n;
	}
	p.rms = sqrt(p.rms);
	return p;
}

bool
power_is_falling_with_speed(const struct reading *reading, size_t n)
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
power_idle_kw_of_draw(const struct power *p, size_t draw, double speed)
{
	const struct power_draw *d = &p->draw[draw % POWER_DRAWS];
	return d->idle > 0 ? d->idle * pow(speed / p->at, d->exponent) : 0;
}

double
power_kw_of_posterior_draw(
    const struct power *p, size_t draw, double speed, double tph)
{
	return power_idle_kw_of_draw(p, draw, speed) +
	       p->draw[draw % POWER_DRAWS].factor *
		   power_to_accelerate_rock(speed, tph);
}

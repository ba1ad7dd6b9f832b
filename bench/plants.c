/* Laws of breakage for synthetic plants, and the sheets of such plants.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "plants.h"

#include <math.h>
#include <string.h>

#include "base/xalloc.h"
#include "core/numeric/rng.h"

enum { TABLE = PLANT_TABLE, CLASSES = 300 };

const char *const LAW_NAME[ALL_LAWS] = {"Eqs 1 to 3", "finer by energy",
    "finer and spread", "shared errors", "bypass", "feed drifts", "t10",
    "two strengths", "six sieves", "five runs", "two runs", "individual feeds",
    "scatter of 2 points", "no law", "Weibull", "logistic", "parent's size",
    "attrition", "second mode", "slower than the tip", "bent",
    "three times bent"};

struct dice {
	struct rng_key key;
	uint32_t at;
};

static double
uniform(struct dice *d, double from, double to)
{
	return from + (to - from) * rng_uniform(d->key, d->at++);
}

static double
normal(struct dice *d)
{
	d->at = (d->at + 12) / 12 * 12;
	double z = rng_normal(d->key, d->at / 12);
	d->at += 12;
	return z;
}

double
plant_feed(const struct plant *p, double x, double n)
{
	double d = x / p->top;
	if (d >= 1)
		return fmin(0.9 + 0.1 * log2(d), 1);
	return 0.9 * pow(d, n);
}

static double
cubic_B(const struct plant *p, double u)
{
	double at = -log2(u) / 10 * (TABLE - 1);
	size_t i = (size_t)at;
	if (u >= 1)
		return 1;
	if (i + 1 >= TABLE)
		return 0;
	return p->B[i] + (at - (double)i) * (p->B[i + 1] - p->B[i]);
}

/* Returns the share, of the material of size x that breaks with energy E, that
 * is finer than u x. */
static double
finer(const struct plant *p, double u, double x, double E)
{
	if (p->law == T10) {
		double Ecs = E / 3600; /* kWh/t */
		double t10 =
		    0.55 *
		    (1 - exp(-p->f_mat * Ecs * pow(x / p->top, p->alpha)));
		double n = fmax(1 / u, 1 + 1e-9);
		return 1 - pow(1 - t10, pow(9 / (n - 1), 0.75));
	}
	if (p->law == PARENT)
		return pow(cubic_B(p, u), pow(x / p->top, p->other));
	if (p->law == TWO_MODES) {
		double fines = p->other * E / p->e_ref;
		return (1 - fines) * cubic_B(p, u) +
		       fines * fmin(pow(20 * u, 0.8), 1);
	}
	if (p->law == FINER || p->law == STRONG)
		return u >= 1 ? 1 : pow(u, 0.7 * pow(E / p->e_ref, -p->gamma));
	return cubic_B(p, u);
}

static double
breaks(const struct plant *p, double x, double E)
{
	double y = pow(x, p->alpha) * E, part[2];
	if (p->law == T10)
		return 1;
	if (p->law == WEIBULL)
		return 1 - exp(-pow(y / (1.5 * p->e0), p->other));
	if (p->law == LOGISTIC)
		return 1 / (1 + pow(y / (1.5 * p->e0), -p->other));
	for (size_t i = 0; i < 2; i++) {
		double e0 = p->e0 * (i == 0 ? 1 : p->hard);
		part[i] = y > e0 ? 1 - exp(-p->f_mat * (y - e0)) : 0;
	}
	return p->share * part[0] + (1 - p->share) * part[1];
}

/* Returns the specific energy of rock at tip speed v, J/kg. */
static double
energy(const struct plant *p, double v)
{
	double hit = p->law == SLOWER ? v - p->other : v, E = hit * hit / 2;
	if (p->law == BENT || p->law == BENT_MORE)
		E *= exp(p->other * pow(log(E / p->e_ref), 2));
	return E;
}

/* Returns the share of a particle of size x, one that does not break, that
 * attrition turns into material finer than s. */
static double
worn(const struct plant *p, double s, double x)
{
	return p->other * fmin(sqrt(10 * s / x), 1);
}

/* A feed with an exponent, plus `more` at the plant's sieves, linear in ln x
 * between them; NULL: 0. */
struct feed {
	double n;
	const double *more;
};

static double
feed_passing(const struct plant *p, const struct feed *feed, double x)
{
	double P = plant_feed(p, x, feed->n);
	const double *size = p->sieve;
	size_t i = 0;
	if (feed->more == NULL || x >= size[0])
		return P;
	while (i < p->n_sieve && size[i] > x)
		i++;
	if (i == p->n_sieve)
		return P;
	double t = log(x / size[i]) / log(size[i - 1] / size[i]);
	return P + feed->more[i] + t * (feed->more[i - 1] - feed->more[i]);
}

/* A Rosin-Rammler curve that does not depend on breakage: its size falls as a
 * power of the speed.  Where the feed is finer, the product is the feed. */
static double
no_law(const struct plant *p, const struct feed *feed, double v, double s)
{
	double x63 = p->x63 * pow(v / 74, -p->finer);
	double P = 1 - exp(-pow(s / x63, p->spread));
	return fmax(P, feed_passing(p, feed, s));
}

static double
product(const struct plant *p, const struct feed *feed, double v, double s)
{
	if (p->law == NO_LAW)
		return no_law(p, feed, v, s);
	static const double SPREAD[5] = {0.55, 0.8, 1, 1.2, 1.45};
	double E = energy(p, v), P = feed_passing(p, feed, s);
	size_t spread = p->law == STRONG ? 5 : 1;
	double top = log(2 * p->top), width = (top - log(s)) / CLASSES;
	for (size_t c = 0; c < CLASSES; c++) {
		double a = exp(top - width * (double)c);
		double b = exp(top - width * (double)(c + 1));
		double x = sqrt(a * b);
		double mass =
		    feed_passing(p, feed, a) - feed_passing(p, feed, b);
		for (size_t i = 0; i < spread; i++) {
			double e = spread > 1 ? E * SPREAD[i] : E;
			double broken = breaks(p, x, e);
			P += mass * broken * finer(p, s / x, x, e) /
			     (double)spread;
			if (p->law == ATTRITION)
				P += mass * (1 - broken) * worn(p, s, x);
		}
	}
	return (1 - p->bypass) * P + p->bypass * feed_passing(p, feed, s);
}

double
plant_product(const struct plant *p, double n, double v, double s)
{
	return product(p, &(struct feed){n, NULL}, v, s);
}

double
plant_truth(const struct plant *p, const double *asked, double v, double s)
{
	double more[PLANT_SIEVES], sum = 0, n_run = (double)p->n_run;
	if (p->law != INDIVIDUAL)
		return plant_product(p, p->feed_n, v, s);
	for (size_t i = 0; i < p->n_sieve; i++) {
		more[i] = asked[i];
		for (size_t r = 0; r < p->n_run; r++)
			more[i] -=
			    plant_feed(p, p->sieve[i], p->run_n[r]) / n_run;
	}
	for (size_t r = 0; r < p->n_run; r++)
		sum += product(p, &(struct feed){p->run_n[r], more}, v, s);
	return sum / n_run;
}

static void
make_cubic(struct plant *p, struct dice *d)
{
	double beta[4] = {0.15 * fabs(normal(d)), 1, -1 + 0.4 * normal(d),
	    0.5 + 0.4 * normal(d)};
	double total = 0;
	p->B[TABLE - 1] = 0;
	for (size_t i = TABLE - 1; i-- > 0;) {
		double u = exp2(-10 * ((double)i + 0.5) / (TABLE - 1));
		total += fmax(0, beta[0] + beta[1] * u + beta[2] * u * u +
				     beta[3] * u * u * u);
		p->B[i] = total;
	}
	for (size_t i = 0; i < TABLE; i++)
		p->B[i] /= total;
}

struct plant
plant_of(enum law law, uint64_t number)
{
	static const double SIEVES[] = {2, 1.42, 1, 0.714, 0.5, 0.357, 0.18,
	    0.09, 0.045, 0.0223, 0.0112, 0.0056};
	static const double FEW_SIEVES[] = {2, 1, 0.5, 0.18, 0.045, 0.0112};
	static const double TIPS[6] = {69, 74, 79, 66, 82, 0};
	struct dice d = {rng_make_key(number, law, 77), 0};
	struct plant p = {.law = law,
	    .top = uniform(&d, 0.008, 0.022),
	    .feed_n = uniform(&d, 0.6, 1.3),
	    .f_mat = uniform(&d, 0.3, 2.5),
	    .alpha = uniform(&d, 0.75, 1),
	    .e_ref = 74 * 74 / 2.0,
	    .share = 1,
	    .hard = 1,
	    .own = 0.005,
	    .n_run = 3};
	double break_size = p.top * uniform(&d, 0.25, 0.6);
	p.e0 = pow(break_size, p.alpha) * p.e_ref;
	make_cubic(&p, &d);
	if (law == FINER)
		p.gamma = 0.4;
	if (law == STRONG)
		p.gamma = 0.8;
	if (law == SHARED) {
		p.own = 0.002;
		p.shared = 0.007;
	}
	if (law == BYPASS)
		p.bypass = uniform(&d, 0.05, 0.25);
	if (law == T10) {
		p.f_mat = uniform(&d, 0.5, 1.5);
		p.alpha = uniform(&d, 0.2, 0.6);
	}
	if (law == MIXED) {
		p.share = uniform(&d, 0.3, 0.7);
		p.hard = uniform(&d, 1.4, 2);
	}
	if (law == SCATTER)
		p.own = 0.02;
	if (law == NO_LAW) {
		p.feed_n = uniform(&d, 1.5, 4);
		p.x63 = p.top * uniform(&d, 0.15, 0.5);
		p.finer = uniform(&d, 0.3, 1.2);
		p.spread = uniform(&d, 0.7, 1.3);
	}
	if (law == WEIBULL)
		p.other = uniform(&d, 2, 4);
	if (law == LOGISTIC)
		p.other = uniform(&d, 3, 6);
	if (law == PARENT)
		p.other = uniform(&d, -0.4, 0.4);
	if (law == ATTRITION)
		p.other = uniform(&d, 0.01, 0.04);
	if (law == TWO_MODES)
		p.other = uniform(&d, 0.05, 0.15);
	if (law == SLOWER)
		p.other = 8;
	if (law == BENT || law == BENT_MORE)
		p.other = law == BENT ? 0.5 : 1.5;
	p.n_sieve = law == FEW ? ARRAY_LEN(FEW_SIEVES) : ARRAY_LEN(SIEVES);
	for (size_t i = 0; i < p.n_sieve; i++)
		p.sieve[i] = p.top * (law == FEW ? FEW_SIEVES[i] : SIEVES[i]);
	p.n_run = law == FIVE ? 5 : law == TWO ? 2 : 3;
	memcpy(p.speed, TIPS, sizeof TIPS);
	if (law == TWO)
		p.speed[1] = 79;
	if (law == FIVE) {
		static const double MORE[5] = {66, 69, 74, 79, 82};
		memcpy(p.speed, MORE, sizeof MORE);
	}
	struct dice feeds = {rng_make_key(number, law, 80), 0};
	for (size_t r = 0; r < PLANT_RUNS; r++)
		p.run_n[r] = law == INDIVIDUAL
				 ? p.feed_n * (1 + 0.06 * normal(&feeds))
				 : p.feed_n;
	return p;
}

void
plant_measure(struct plant *p, size_t n_run)
{
	p->n_run = n_run;
	for (size_t r = 0; r < n_run; r++)
		p->speed[r] = 66 + 18 * (double)r / (double)(n_run - 1);
}

/* Adds errors to a curve: independent ones, and one shared along it. */
static void
add_errors(
    const struct plant *p, double own, double along, struct dice *d, double *P)
{
	double smooth[4], before = 1;
	for (size_t i = 0; i < 4; i++)
		smooth[i] = normal(d);
	for (size_t i = 0; i < p->n_sieve; i++) {
		double h = 2 * sqrt(fmax(P[i] * (1 - P[i]), 0));
		double t = log(p->top / p->sieve[i]), shared = 0;
		for (size_t k = 0; k < 4; k++)
			shared +=
			    smooth[k] *
			    cos(t * (0.3 + 0.4 * (double)k) + 1.3 * (double)k) /
			    sqrt(2);
		P[i] += h * (own * normal(d) + along * shared);
		P[i] = fmin(fmax(round(P[i] * 1e4) / 1e4, 0), before);
		before = P[i];
	}
}

struct site *
plant_site(const struct plant *p, uint64_t number)
{
	struct site *site = site_new(p->n_run);
	struct dice d = {rng_make_key(number, p->law, 78), 0};
	struct dice other = {rng_make_key(number, p->law, 79), 0};
	double feed[PLANT_SIEVES];
	site->top_size = p->top;
	for (size_t i = 0; i < p->n_sieve; i++)
		feed[i] = plant_feed(p, p->sieve[i], p->feed_n);
	if (p->feed_own > 0)
		add_errors(p, p->feed_own, 0, &other, feed);
	for (size_t r = 0; r < p->n_run; r++) {
		struct run *run = &site->run[r];
		double n = p->run_n[r];
		if (p->law == DRIFT)
			n *= 1 + 0.04 * normal(&d);
		run->speed = p->speed[r];
		run->feed = psd_new(p->n_sieve);
		run->product = psd_new(p->n_sieve);
		for (size_t i = 0; i < p->n_sieve; i++) {
			double s = p->sieve[i];
			run->feed.size[i] = run->product.size[i] = s;
			run->feed.passing[i] =
			    round(plant_feed(p, s, p->run_n[r]) * 1e4) / 1e4;
			run->product.passing[i] =
			    i == 0 ? 1 : plant_product(p, n, run->speed, s);
		}
		add_errors(p, p->own, p->shared, &d, run->product.passing);
		if (p->law == INDIVIDUAL)
			add_errors(p, p->own, 0, &other, run->feed.passing);
		if (p->feed_own > 0)
			memcpy(
			    run->feed.passing, feed, p->n_sieve * sizeof *feed);
	}
	site_update_digest_and_mean_feed(site);
	return site;
}

double
plant_speed_error(uint64_t number, size_t k)
{
	return rng_normal(rng_make_key(number, 0, 93), (uint32_t)k);
}

struct site *
plant_site_with_speed_errors(const struct plant *p, uint64_t number, double sd)
{
	struct plant runs = *p;
	for (size_t r = 0; r < p->n_run; r++)
		runs.speed[r] *= 1 + sd * plant_speed_error(number, r);
	struct site *site = plant_site(&runs, number);
	for (size_t r = 0; r < p->n_run; r++)
		site->run[r].speed = p->speed[r];
	site_update_digest_and_mean_feed(site);
	return site;
}

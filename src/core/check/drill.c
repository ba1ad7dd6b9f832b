/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "core/check/drill.h"

#include <math.h>
#include <stdlib.h>

#include "core/model/breakage.h"
#include "core/model/product.h"
#include "core/numeric/rng.h"

enum { USE_PLANT = 1 << 23, TRIES = 1000 };

/* The sieves of the conditions, m: of what is wanted, and of fines. */
static const double WANTED = 2e-3, FINES = 0.5e-3;

/* From low to high, by number i of the stream. */
static double
between(struct rng_key key, uint32_t i, double low, double high)
{
	return low + (high - low) * rng_uniform(key, i);
}

/* Parameters as the rocks of Table 3 have them, beta about its default. */
static struct params
make_params(struct rng_key key, bool hard)
{
	struct params p = params_start(hard ? 1 : 0);
	const struct breakage *of = breakage_of(&p);
	const double beta[] = {0, 1, -1, 0.5};
	for (size_t j = 0; j < 4; j++)
		p.beta[j] = beta[j] + (j == 0 ? 0 : 0.1) *
					  rng_normal(key, (uint32_t)(20 + j));
	p.f_mat = between(key, 1, 0.5, 2.4);
	p.e0_min = between(key, 2, 14, 24);
	p.alpha = between(key, 3, 0.82, 0.97);
	if (!hard)
		return p;
	p.at[breakage_parameter(of, "gamma")] = between(key, 4, 0.1, 0.5);
	p.at[of->reference] = energy_specific(74);
	return p;
}

void
drill_truth(const struct drill_plant *plant, double speed, const double *size,
    size_t n, double *passing)
{
	struct site *site = drill_feed(plant);
	struct model *model =
	    model_new(&site->run[0].feed, size, n, model_settings_default());
	model_set(model, &plant->made.params);
	model_product(model, speed, passing);
	model_free(model);
	site_free(site);
}

static double
passing_at(const struct drill_plant *plant, double speed, double size)
{
	double passing;
	drill_truth(plant, speed, &size, 1, &passing);
	return passing;
}

/* The speed at which so much passes a size, by halving. */
static double
speed_of(const struct drill_plant *plant, const struct drill_condition *c)
{
	double low = DRILL_SLOWEST, high = DRILL_FASTEST;
	for (int i = 0; i < 40; i++) {
		double middle = (low + high) / 2;
		if (passing_at(plant, middle, c->size) < c->passing)
			low = middle;
		else
			high = middle;
	}
	return (low + high) / 2;
}

/* Whether the plant makes a drill: conditions that hold over a range of speeds
 * which lies within those there are, and a product that the speed changes. */
static bool
make_conditions(struct drill_plant *p, double middle)
{
	double half = p->hard ? 1.5 : 3;
	double least = passing_at(p, middle - half, WANTED);
	double most = passing_at(p, middle + half, FINES);
	p->condition[0] =
	    (struct drill_condition){WANTED, ceil(1000 * least) / 1000, false};
	p->condition[1] =
	    (struct drill_condition){FINES, floor(1000 * most) / 1000, true};
	p->slowest = speed_of(p, &p->condition[0]);
	p->fastest = speed_of(p, &p->condition[1]);
	double rise = passing_at(p, middle + half, WANTED) - least;
	return rise > 0.008 * half && p->fastest - p->slowest > half &&
	       p->slowest > DRILL_SLOWEST + 1 && p->fastest < DRILL_FASTEST - 1;
}

struct drill_plant
drill_plant(uint64_t seed, bool hard)
{
	static const double TOP[] = {0.008, 0.0112, 0.016};
	struct drill_plant p = {.seed = seed, .hard = hard};
	for (uint64_t i = 0; i < TRIES; i++) {
		struct rng_key key = rng_key(seed, i, USE_PLANT + hard);
		p.made = (struct synth){
		    .top_size = TOP[rng_bits(key, 5) % 3],
		    .params = make_params(key, hard),
		    .n = between(key, 6, 0.9, 1.2),
		    .noise = hard ? 0.008 : 0.004,
		};
		if (make_conditions(&p, between(key, 7, 66, 82)))
			break;
	}
	return p;
}

/* One run, with its product. */
static struct site *
make(const struct drill_plant *plant, double speed, size_t n)
{
	struct synth made = plant->made;
	made.seed = rng_mix(plant->seed) + n;
	made.n_speed = 1;
	made.speed = &speed;
	return synth_site(&made);
}

struct site *
drill_feed(const struct drill_plant *plant)
{
	struct site *made = make(plant, 74, 0), *site = site_new(1);
	site->top_size = plant->made.top_size;
	site->run[0].feed = psd_copy(&made->run[0].feed);
	site_settle(site);
	site_free(made);
	return site;
}

struct site *
drill_sample(const struct drill_plant *plant, double speed, size_t n)
{
	struct site *site = make(plant, speed, n + 1);
	psd_free(&site->run[0].feed);
	site->run[0].feed = (struct psd){0};
	return site;
}

double
drill_margin(const struct drill_plant *plant, double speed)
{
	return fmin(speed - plant->slowest, plant->fastest - speed);
}

/* What several tests share: the rows of Table 3, made-up feeds and parameters,
 * and comparing numbers.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TESTS_MADE_H
#define TIPSPEED_TESTS_MADE_H

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "base/xalloc.h"
#include "core/model/product.h"
#include "core/psd/psd.h"
#include "core/numeric/rng.h"
#include "core/model/synth.h"
#include "paper.h"

/* A row of Table 3, as printed. */
struct table_row {
	const char *site;
	double top_mm, f_mat, e0_min, alpha;
	bool individual_feeds;
};

static const struct table_row TABLE_3[19] = {
    {"Ubbarp", 19, 0.25, 21.04, 0.94, false},
    {"Borlänge", 11.2, 0.75, 16.29, 0.94, false},
    {"Glanshamar", 11.2, 1.3, 14.83, 0.91, true},
    {"Umeå", 19, 0.8, 18.61, 0.92, true}, {"Atle", 19, 0.68, 22.8, 0.88, false},
    {"Össjö", 4, 1.73, 29.22, 0.99, false},
    {"Skyttorp", 11.2, 1.7, 15.79, 0.93, false},
    {"Önnestad", 11.2, 1.32, 26.54, 0.86, false},
    {"Tierp", 11.2, 2.18, 16.74, 0.96, true},
    {"Gävle", 4, 1.45, 20.48, 0.92, true},
    {"Gävle", 11.2, 2.08, 19.39, 0.9, true},
    {"Gävle", 11.2, 1.63, 17.91, 0.82, true},
    {"Kållered", 16, 1.36, 15.45, 0.85, true},
    {"Enhörna", 19, 2.02, 15.48, 0.91, false},
    {"Bro", 10, 0.06, 28.02, 0.81, true},
    {"Sunderbyn", 11.2, 1.92, 23.48, 0.95, true},
    {"Forsby", 19, 2.35, 25.22, 0.82, false},
    {"Kiruna", 10, 0.39, 16.83, 0.88, true},
    {"Gåsgruvan", 19, 0.25, 21.04, 0.94, false}};

enum { TIERP = 8 };

static inline struct params
made_params(const struct table_row *row)
{
	struct params p = params_start_values(0);
	p.f_mat = row->f_mat;
	p.e0_min = row->e0_min;
	p.alpha = row->alpha;
	return p;
}

/* Fails unless got lies within tolerance of want; NaN fails. */
static inline void
expect_near(const char *what, double got, double want, double tolerance)
{
	if (!(fabs(got - want) <= tolerance))
		fail_msg("%s: %.17g was wanted, to %g, found %.17g", what, want,
		    tolerance, got);
}

/* A stream of numbers that is drawn from in order. */
struct draw {
	struct rng_key key;
	uint32_t n;
};

static inline struct draw
draw_start(uint64_t seed)
{
	return (struct draw){rng_make_key(seed, 0, 0), 0};
}

static inline double
draw_between(struct draw *draw, double low, double high)
{
	return low + (high - low) * rng_uniform(draw->key, draw->n++);
}

static inline double
draw_log(struct draw *draw, double low, double high)
{
	return exp(draw_between(draw, log(low), log(high)));
}

/* Parameters from the box of Table 2.  p(u) is clipped for most, and 0 everywhere
 * for a few. */
static inline struct params
made_any_params(struct draw *draw)
{
	struct params p = {0};
	for (size_t i = 0; i < PARAM_COUNT; i++)
		p.at[i] = draw_between(draw, PARAMS[i].lower, PARAMS[i].upper);
	return p;
}

/* A feed of 2 to 14 sieves, steep, flat and level stretches among them; 100 %
 * passes its coarsest, and in one of three 0 % its finest. */
static inline struct psd
made_any_feed(struct draw *draw)
{
	struct psd feed = psd_new((size_t)draw_between(draw, 2, 15));
	double size = draw_log(draw, 8e-3, 60e-3), passing = 1;
	for (size_t i = 0; i < feed.n; i++) {
		feed.size[i] = size;
		feed.passing[i] = passing;
		size /= draw_between(draw, 1.1, 2.5);
		if (draw_between(draw, 0, 1) < 0.8)
			passing *= draw_between(draw, 0.3, 1);
	}
	if (draw_between(draw, 0, 1) < 1.0 / 3)
		feed.passing[feed.n - 1] = 0;
	return feed;
}

/* The row's runs at 69, 74 and 79 m/s, see synth.h. */
static inline struct site *
made_site(const struct table_row *row, double noise, uint64_t seed)
{
	static const double SPEED[3] = {69, 74, 79};
	struct synth synth = {.top_size = row->top_mm / 1000,
	    .params = made_params(row),
	    .individual_feeds = row->individual_feeds,
	    .n = 1,
	    .noise = noise,
	    .seed = seed,
	    .n_speed = 3,
	    .speed = SPEED};
	return synth_make_site(&synth);
}

/* The model's product of a run's feed on the sieves of its product. */
static inline void
made_product(const struct run *run, const struct params *p, double *passing)
{
	struct model *model = model_new(&run->feed, run->product.size,
	    run->product.n, model_settings_default());
	model_set_params(model, p);
	model_compute_product(model, run->speed, passing);
	model_free(model);
}

#endif

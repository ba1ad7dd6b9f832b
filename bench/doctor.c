/* Wrong cells, counted: sheets of made-up plants, half of them with one passing
 * changed, are checked before and after they are calibrated.  Prints a row for
 * each law and size of the error; bench/README.md says how to read it.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/pool.h"
#include "base/xalloc.h"
#include "core/calibrate.h"
#include "core/leave_out.h"
#include "core/rng.h"
#include "measure.h"
#include "plants.h"

/* The cell that was made wrong; off 0: none. */
struct wrong {
	bool feed;
	size_t run, sieve;
	double off;
	size_t refused; /* tries that no sheet can be read with */
};

struct outcome {
	struct leave_out_shift before, after;
	struct leave_out_cell cell_before, cell_after;
	struct wrong wrong;
	double seconds;
};

/* Puts `off` into a cell of the site, up or down, where the sheet can still be
 * read. */
static struct wrong
make_wrong(struct site *site, uint64_t number, double off, bool feed)
{
	struct rng_key key = rng_key(number, feed, 80);
	struct wrong w = {.feed = feed};
	for (uint32_t at = 0; at < 3000; at += 3) {
		w.run = (size_t)(rng_uniform(key, at) * (double)site->n_run);
		struct run *run = &site->run[w.run];
		struct psd *psd = feed ? &run->feed : &run->product;
		w.sieve = (size_t)(rng_uniform(key, at + 1) * (double)psd->n);
		w.off = rng_uniform(key, at + 2) < 0.5 ? off : -off;
		double P = psd->passing[w.sieve] + w.off;
		double most = w.sieve > 0 ? psd->passing[w.sieve - 1] : 1;
		double least =
		    w.sieve + 1 < psd->n ? psd->passing[w.sieve + 1] : 0;
		if (P > most || P < least || w.sieve == 0) {
			w.refused++;
			continue;
		}
		for (size_t r = 0; r < site->n_run; r++)
			if (r == w.run || feed)
				(feed ? site->run[r].feed
				      : site->run[r].product)
				    .passing[w.sieve] = P;
		site->digest = site_digest(site);
		return w;
	}
	return (struct wrong){0};
}

struct task {
	enum law law;
	size_t first;
	double off, feed_own;
	bool feed;
	struct outcome *outcome;
};

static struct posterior *
calibrated(const struct site *site, uint64_t seed)
{
	bool use[6] = {true, true, true, true, true, true};
	struct calibrate_options o = calibrate_options_default();
	o.seed = seed;
	struct calibration *c = calibration_new(site, &o);
	while (calibration_step(c) <= CALIBRATE_POLISHING)
		;
	struct fit fit = calibration_fit(c);
	calibration_free(c);
	return posterior_new(site, &fit.params,
	    &(struct posterior_options){.use = use,
		.settings = fit.settings,
		.bounds = o.bounds,
		.seed = seed,
		.threads = 1,
		.isa = ISA_BEST});
}

static void
one_sheet(void *data, size_t piece, unsigned thread)
{
	struct task *task = data;
	struct outcome *o = &task->outcome[piece];
	uint64_t number = task->first + piece;
	struct plant p = plant_of(task->law, number);
	p.feed_own = task->feed_own;
	struct site *site = plant_site(&p, number);
	(void)thread;
	if (task->off > 0)
		o->wrong = make_wrong(site, number, task->off, task->feed);
	struct leave_out *l = leave_out_new(site, NULL, 0);
	o->before = leave_out_worst(l);
	o->cell_before = leave_out_cell(l, o->before.cell);
	leave_out_free(l);
	struct posterior *posterior = calibrated(site, number);
	double began = measure_now();
	l = leave_out_new(site, posterior, 0);
	o->after = leave_out_worst(l);
	o->cell_after = leave_out_cell(l, o->after.cell);
	leave_out_free(l);
	o->seconds = measure_now() - began;
	posterior_free(posterior);
	site_free(site);
}

static bool
is_right(const struct outcome *o, const struct leave_out_cell *c)
{
	return c->feed == o->wrong.feed && c->sieve == o->wrong.sieve &&
	       (c->feed || c->run == o->wrong.run);
}

int
main(int argc, char **argv)
{
	size_t n = argc > 1 ? (size_t)atoi(argv[1]) : 20;
	const char *laws = argc > 2 ? argv[2] : "abcdefghijk";
	double off = argc > 3 ? atof(argv[3]) / 100 : 0;
	bool feed = argc > 4 && argv[4][0] == 'f';
	double own = argc > 5 ? atof(argv[5]) / 100 : 0.003;
	size_t first = argc > 6 ? (size_t)atoi(argv[6]) : 1;
	struct pool *pool = pool_new(measure_threads());
	for (enum law law = 0; law < LAWS; law++) {
		if (strchr(laws, 'a' + (int)law) == NULL)
			continue;
		struct task task = {law, first, off, own, feed,
		    xcalloc(n, sizeof(struct outcome))};
		pool_run(pool, n, one_sheet, &task);
		for (size_t i = 0; i < n; i++) {
			const struct outcome *o = &task.outcome[i];
			printf("%c %zu wrong %d %zu %zu %.3f refused %zu | %d "
			       "z %.2f gain %.2f "
			       "exp %.4f %.4f cell %d %zu %zu| %d z %.2f gain "
			       "%.2f exp "
			       "%.4f %.4f cell %d %zu %zu | %.3f\n",
			    'a' + (int)law, i, o->wrong.feed, o->wrong.run,
			    o->wrong.sieve, o->wrong.off, o->wrong.refused,
			    is_right(o, &o->cell_before), o->before.z,
			    o->before.gain, o->before.expected, o->before.sd,
			    o->cell_before.feed, o->cell_before.run,
			    o->cell_before.sieve, is_right(o, &o->cell_after),
			    o->after.z, o->after.gain, o->after.expected,
			    o->after.sd, o->cell_after.feed, o->cell_after.run,
			    o->cell_after.sieve, o->seconds);
		}
		free(task.outcome);
	}
	pool_free(pool);
	return 0;
}

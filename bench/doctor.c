/* Wrong cells, counted: sheets of made-up plants, as they are and with one
 * passing changed, are checked before and after they are calibrated.  Prints a
 * row a law; bench/README.md says how to read it.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/pool.h"
#include "base/xalloc.h"
#include "core/search/calibrate.h"
#include "core/check/outliers.h"
#include "core/numeric/rng.h"
#include "measure.h"
#include "plants.h"

/* Errors of one passing, in a product or in the feed; the first is none. */
enum { KINDS = 7, TWICE = 2 };
static const struct {
	bool feed;
	double off;
} KIND[KINDS] = {{false, 0}, {false, 0.03}, {false, 0.05}, {false, 0.08},
    {true, 0.03}, {true, 0.05}, {true, 0.08}};

/* Error of the feed as the sheet has it. */
static const double FEED_OWN = 0.003;

/* The cell that was made wrong; off 0: none. */
struct wrong {
	bool feed;
	size_t run, sieve;
	double off;
	size_t refused; /* tries that no sheet can be read with */
};

/* Of a sheet, before and after it was calibrated: the wrong cell was named, or
 * another one. */
struct outcome {
	bool made, found[TWICE], other[TWICE];
	size_t refused;
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
		site_settle(site);
		return w;
	}
	return (struct wrong){0};
}

/* outcome [sheets * KINDS] */
struct task {
	enum law law;
	size_t first;
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
look(const struct site *site, const struct posterior *posterior,
    const struct wrong *w, bool *found, bool *other)
{
	struct doctor d = doctor_look(site, posterior, 0);
	for (size_t i = 0; i < d.n; i++) {
		const struct mend *m = &d.finding[i].mend;
		const struct run *run = &site->run[w->run];
		const struct psd *psd = w->feed ? &run->feed : &run->product;
		bool right = w->off != 0 && m->feed == w->feed &&
			     (m->feed || m->run == w->run) &&
			     m->size == psd->size[w->sieve];
		*found = *found || right;
		*other = *other || !right;
	}
	doctor_free(&d);
}

static void
one_sheet(void *data, size_t piece, unsigned thread)
{
	struct task *task = data;
	struct outcome *o = &task->outcome[piece];
	size_t kind = piece % KINDS;
	uint64_t number = task->first + piece / KINDS;
	struct plant p = plant_of(task->law, number);
	p.feed_own = FEED_OWN;
	struct site *site = plant_site(&p, number);
	struct wrong w = {.off = 0};
	(void)thread;
	if (kind > 0)
		w = make_wrong(site, number, KIND[kind].off, KIND[kind].feed);
	o->made = kind == 0 || w.off != 0;
	o->refused = w.refused;
	if (o->made) {
		struct posterior *posterior = calibrated(site, number);
		look(site, NULL, &w, &o->found[0], &o->other[0]);
		look(site, posterior, &w, &o->found[1], &o->other[1]);
		posterior_free(posterior);
	}
	site_free(site);
}

/* Of all sheets of a kind of error. */
struct count {
	size_t made, refused, found[TWICE], other[TWICE];
};

static void
add_up(const struct outcome *o, size_t n, struct count sum[static KINDS])
{
	for (size_t i = 0; i < n * KINDS; i++) {
		struct count *to = &sum[i % KINDS];
		to->made += o[i].made;
		to->refused += o[i].refused;
		for (size_t k = 0; k < TWICE; k++) {
			to->found[k] += o[i].found[k];
			to->other[k] += o[i].other[k];
		}
	}
}

static double
share(size_t n, const struct count *of)
{
	return 100 * (double)n / fmax((double)of->made, 1);
}

/* Alarms in sheets without an error; then wrong cells named, and sheets in
 * which others were; each before and after. */
static void
print_row(const char *name, const struct count sum[static KINDS])
{
	printf("%-32s%4.0f%4.0f", name, share(sum[0].other[0], &sum[0]),
	    share(sum[0].other[1], &sum[0]));
	for (size_t k = 1; k < KINDS; k++)
		printf(" |%4.0f%4.0f%4.0f%4.0f",
		    share(sum[k].found[0], &sum[k]),
		    share(sum[k].found[1], &sum[k]),
		    share(sum[k].other[0], &sum[k]),
		    share(sum[k].other[1], &sum[k]));
	printf("\n");
	fflush(stdout);
}

static void
print_head(void)
{
	printf("%-32s%8s", "law", "clean");
	for (size_t k = 1; k < KINDS; k++)
		printf(" |%10s %1.0f pt ", KIND[k].feed ? "feed" : "product",
		    100 * KIND[k].off);
	printf("\n");
}

static void
print_refused(const struct count sum[static KINDS])
{
	for (size_t k = 1; k < KINDS; k++)
		printf("%s by %g points: %zu made; %zu more broke the order, "
		       "which the reader refuses\n",
		    KIND[k].feed ? "feed" : "product", 100 * KIND[k].off,
		    sum[k].made, sum[k].refused);
}

/* doctor [PLANTS [LAWS [FIRST]]]: as coverage has them. */
int
main(int argc, char **argv)
{
	size_t n = argc > 1 ? (size_t)atoi(argv[1]) : 40;
	size_t first = argc > 3 ? (size_t)atoi(argv[3]) : 1;
	struct pool *pool = pool_new(measure_threads());
	struct count all[KINDS] = {{0}};
	print_head();
	for (enum law law = 0; law < LAWS; law++) {
		if (argc > 2 && strchr(argv[2], 'a' + (int)law) == NULL)
			continue;
		struct task task = {
		    law, first, xcalloc(n * KINDS, sizeof *task.outcome)};
		struct count own[KINDS] = {{0}};
		pool_run(pool, n * KINDS, one_sheet, &task);
		add_up(task.outcome, n, own);
		add_up(task.outcome, n, all);
		print_row(LAW_NAME[law], own);
		free(task.outcome);
	}
	print_row("all", all);
	print_refused(all);
	pool_free(pool);
	return 0;
}

/* Counts the wrong cells that check finds in sheets as they are and with one
 * passing changed, before and after calibration.
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
#include "core/check/trust.h"
#include "core/numeric/rng.h"
#include "counts.h"
#include "measure.h"
#include "plants.h"

/* Errors put into one passing, of a product or of the feed; the first is no
 * error. */
enum { KINDS = 7, TWICE = 2 };
static const struct {
	bool feed;
	double off;
} KIND[KINDS] = {{false, 0}, {false, 0.03}, {false, 0.05}, {false, 0.08},
    {true, 0.03}, {true, 0.05}, {true, 0.08}};

/* Sampling error of the feed in the sheet. */
static const double FEED_OWN = 0.003;

/* The cell that was changed; off 0: no cell. */
struct wrong {
	bool feed;
	size_t run, sieve;
	double off;
	size_t refused; /* tries that gave sheets that cannot be read */
};

/* The result for a sheet, before and after calibration: whether the wrong cell
 * was named, and whether another one was.  doubted: whether a cell is so far
 * from a fit to the outer speeds that the light is amber. */
struct outcome {
	bool made, found[TWICE], other[TWICE], doubted;
	size_t refused;
};

/* Changes a cell of the site by `off`, up or down, so that the sheet can still
 * be read. */
static struct wrong
make_wrong(struct site *site, uint64_t number, double off, bool feed)
{
	struct rng_key key = rng_make_key(number, feed, 80);
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
		site_update_digest_and_mean_feed(site);
		return w;
	}
	return (struct wrong){0};
}

/* outcome [sheets * KINDS] */
struct task {
	struct outcome *outcome;
};

static void
look(const struct site *site, const struct posterior *posterior,
    const struct wrong *w, bool *found, bool *other)
{
	struct outlier_findings d = outliers_find(site, posterior, 0);
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
	outliers_free(&d);
}

static bool
is_cell_doubted_by_light(const struct site *site, uint64_t number)
{
	bool *train = xcalloc(site->n_run, sizeof *train);
	misfit_mark_default_training(site, train);
	struct calibrate_options o = calibrate_options_default();
	o.train = train;
	o.seed = number;
	struct fit fit = counts_fit(site, &o);
	struct validation v = trust_find_outlier_cell(site, train, &fit);
	free(train);
	return v.worst_difference != 0;
}

static void
one_sheet(void *data, size_t piece, unsigned thread)
{
	struct task *task = data;
	struct outcome *o = &task->outcome[piece];
	size_t kind = piece % KINDS;
	uint64_t number;
	struct plant p = counts_plant(piece / KINDS, &number);
	p.feed_own = FEED_OWN;
	struct site *site = plant_site(&p, number);
	struct wrong w = {.off = 0};
	(void)thread;
	if (kind > 0)
		w = make_wrong(site, number, KIND[kind].off, KIND[kind].feed);
	o->made = kind == 0 || w.off != 0;
	o->refused = w.refused;
	if (o->made) {
		struct fit fit;
		struct posterior *posterior =
		    counts_calibrate(site, number, &fit);
		look(site, NULL, &w, &o->found[0], &o->other[0]);
		look(site, posterior, &w, &o->found[1], &o->other[1]);
		posterior_free(posterior);
		o->doubted = is_cell_doubted_by_light(site, number);
	}
	site_free(site);
}

/* Prints the results for the sheets with an error of this kind.  Returns false
 * if they are outside the limits. */
static bool
print_kind(const struct outcome *o, size_t n, size_t kind)
{
	struct counts_mean found[TWICE] = {{0}}, other[TWICE] = {{0}},
			   doubted = {0};
	size_t refused = 0;
	for (size_t i = 0; i < n; i++, o += KINDS) {
		refused += o[kind].refused;
		if (o[kind].made)
			counts_add(&doubted, o[kind].doubted);
		for (size_t k = 0; k < TWICE && o[kind].made; k++) {
			counts_add(&found[k], o[kind].found[k]);
			counts_add(&other[k], o[kind].other[k]);
		}
	}
	if (kind == 0)
		printf("%-22s", "nothing");
	else
		printf("%g points in a %-7s ", 100 * KIND[kind].off,
		    KIND[kind].feed ? "feed" : "product");
	printf("%5.0f %5zu", found[0].n, refused);
	for (size_t k = 0; k < TWICE; k++) {
		counts_print(&found[k], 100);
		counts_print(&other[k], 100);
	}
	counts_print(&doubted, 100);
	printf("\n");
	if (kind == 0)
		return counts_between(&other[1], 0, 0.1);
	return KIND[kind].feed || counts_between(&found[1], 0.75, 1);
}

/* light: of those doubted by the light; else of those that check named. */
static void
print_accused(const struct outcome *o, size_t n, bool light)
{
	size_t accused[LAWS] = {0};
	for (size_t i = 0; i < n; i++)
		accused[i % LAWS] +=
		    light ? o[i * KINDS].doubted : o[i * KINDS].other[1];
	printf("sheets without a wrong cell in which one %s:",
	    light ? "makes the light amber" : "was named");
	for (size_t law = 0; law < LAWS; law++)
		if (accused[law] > 0)
			printf(" %zu of %s", accused[law], LAW_NAME[law]);
	printf("\n");
}

bool
count_doctor(size_t n)
{
	struct pool *pool = pool_new(measure_threads());
	struct task task = {xcalloc(n * KINDS, sizeof *task.outcome)};
	bool ok = true;
	pool_run(pool, n * KINDS, one_sheet, &task);
	pool_free(pool);
	printf("%-22s%5s %5s%28s%28s\n%-34s%14s%14s%14s%14s%14s\n", "wrong by",
	    "made", "(ref.)", "before a calibration", "after", "", "named %",
	    "another %", "named %", "another %", "amber %");
	for (size_t kind = 0; kind < KINDS; kind++)
		ok = print_kind(task.outcome, n, kind) && ok;
	print_accused(task.outcome, n, false);
	print_accused(task.outcome, n, true);
	free(task.outcome);
	return ok;
}

/* Checks the speeds that window gives: counts how often the true product meets
 * the conditions there.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/xalloc.h"
#include "core/numeric/rng.h"
#include "counts.h"
#include "measure.h"
#include "plants.h"

/* Two conditions: the least passing at one sieve and the most at another.  They
 * are the passings of the plant's product at two speeds, rounded as people type
 * them. */
struct conditions {
	const struct plant *plant;
	double asked[PLANT_SIEVES]; /* the feed */
	size_t sieve[2];
	double limit[2]; /* passing 0..1 */
};

static double
truth(const struct conditions *c, double v, size_t sieve)
{
	return plant_truth(c->plant, c->asked, v, c->plant->sieve[sieve]);
}

static bool
meets(const struct conditions *c, double v)
{
	return truth(c, v, c->sieve[0]) >= c->limit[0] - 1e-9 &&
	       truth(c, v, c->sieve[1]) <= c->limit[1] + 1e-9;
}

/* Returns a sieve, coarser than the finest, at which 10 m/s change the passing
 * by over two points. */
static size_t
sieve_for(const struct conditions *c, struct rng_key key, uint32_t at)
{
	for (uint32_t tries = 0; tries < 200; tries++) {
		size_t i = (size_t)(rng_uniform(key, at + tries) *
				    (double)(c->plant->n_sieve - 1));
		if (truth(c, 79, i) - truth(c, 69, i) > 0.02)
			return i;
	}
	return SIZE_MAX;
}

static bool
conditions_make(struct conditions *c, const struct site *site, uint64_t number)
{
	struct rng_key key = rng_make_key(number, c->plant->law, 94);
	const struct psd *feed = site_feed_of_run(site, SITE_MEAN_FEED);
	for (size_t i = 0; i < c->plant->n_sieve; i++)
		c->asked[i] = psd_passing(feed, c->plant->sieve[i]);
	double speed[2];
	speed[0] = 66 + 8 * rng_uniform(key, 0);
	speed[1] = speed[0] + 2 + 7 * rng_uniform(key, 1);
	for (size_t k = 0; k < 2; k++) {
		c->sieve[k] = sieve_for(c, key, (uint32_t)(10 + 300 * k));
		if (c->sieve[k] == SIZE_MAX)
			return false;
		double P = truth(c, speed[k], c->sieve[k]);
		c->limit[k] = round(1000 * P) / 1000;
	}
	return true;
}

/* Over plants: the share of the speeds at which the true product meets the
 * conditions, in the window and in the part of it that is 80 % certain; the
 * share of plants that meet them at the best speed, with the certainty stated
 * for it, and at either end; off [ends]: how far the ends are from the true
 * ones, m/s. */
struct score {
	struct counts_mean inside, certain, best, said, end, sure_end;
	size_t ends, none;
	double *off;
};

/* Returns the share of the speeds from..to, by tenths, at which the conditions
 * are met. */
static double
part_met(const struct conditions *c, double from, double to)
{
	double met = 0, all = 0;
	for (double v = from; v < to + 0.05; v += 0.1, all++)
		met += meets(c, v);
	return met / all;
}

/* Scores an end that condition k sets.  The true end is where this condition is
 * just met. */
static void
score_end(const struct conditions *c, double v, size_t k, struct score *s)
{
	double low = 40, high = 120;
	for (size_t i = 0; i < 30; i++) {
		double middle = (low + high) / 2;
		if (truth(c, middle, c->sieve[k]) < c->limit[k])
			low = middle;
		else
			high = middle;
	}
	counts_add(&s->end, meets(c, v));
	s->off = xrealloc(s->off, s->ends + 1, sizeof *s->off);
	s->off[s->ends++] = fabs(v - low);
}

/* Reads the pair "a,b" after a key. */
static bool
read_pair(const char *text, const char *key, double pair[2])
{
	const char *at = text != NULL ? strstr(text, key) : NULL;
	return at != NULL &&
	       sscanf(at + strlen(key), "%lf,%lf", &pair[0], &pair[1]) == 2;
}

static void
score_answer(const struct conditions *c, const char *text, struct score *s)
{
	double in[2], sure[2], best = counts_number(text, "\"best\":");
	if (!read_pair(text, "\"inside\":[[", in)) {
		s->none++;
		return;
	}
	counts_add(&s->inside, part_met(c, in[0], in[1]));
	counts_add(&s->best, meets(c, best));
	counts_add(&s->said, counts_number(text, "\"certainty_pct\":") / 100);
	if (strstr(text, "\"binds_low\":null") == NULL)
		score_end(c, in[0], 0, s);
	if (strstr(text, "\"binds_high\":null") == NULL)
		score_end(c, in[1], 1, s);
	if (!read_pair(text, "\"certain\":[", sure))
		return;
	counts_add(&s->certain, part_met(c, sure[0], sure[1]));
	for (size_t k = 0; k < 2; k++)
		if (sure[k] > 65.05 && sure[k] < 84.95)
			counts_add(&s->sure_end, meets(c, sure[k]));
}

static void
count_plant(size_t i, struct score *s)
{
	uint64_t number;
	struct plant p = counts_plant(i, &number);
	struct site *site = plant_site(&p, number);
	struct conditions c = {.plant = &p};
	if (!conditions_make(&c, site, number)) {
		site_free(site);
		return;
	}
	struct counts_talk *talk = counts_talk(site);
	FREED char *line =
	    xasprintf("window \"passing %.9g >= %.1f\" \"passing %.9g <= "
		      "%.1f\"",
		1000 * p.sieve[c.sieve[0]], 100 * c.limit[0],
		1000 * p.sieve[c.sieve[1]], 100 * c.limit[1]);
	counts_say(talk, "calibrate");
	score_answer(&c, counts_say(talk, line), s);
	counts_talk_end(talk);
}

bool
count_window(size_t n)
{
	struct score s = {.none = 0};
	for (size_t i = 0; i < n; i++)
		count_plant(i, &s);
	printf("%% of speeds, or plants, at which the true product meets the "
	       "conditions\n%-28s",
	    "in the window");
	counts_print(&s.inside, 100);
	printf("\n%-28s", "at its ends");
	counts_print(&s.end, 100);
	printf("   off by %.2f m/s\n%-28s", measure_median(s.off, s.ends),
	    "at the best speed");
	counts_print(&s.best, 100);
	printf("\n%-28s", "  said to be certain by");
	counts_print(&s.said, 100);
	printf("\n%-28s", "where 80 % certain");
	counts_print(&s.certain, 100);
	printf("\n%-28s", "  at the ends of that");
	counts_print(&s.sure_end, 100);
	printf("\n%zu plants had no window\n", s.none);
	free(s.off);
	return counts_between(&s.best, 0.85, 1) &&
	       counts_between(&s.certain, 0.85, 1) &&
	       counts_between(&s.sure_end, 0.7, 1);
}

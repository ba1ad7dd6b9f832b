/* Counts how often the model that league ranks first is the law that made the
 * plant, and compares its error at speeds that were not measured with that of
 * the best model.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/xalloc.h"
#include "core/model/breakage.h"
#include "core/model/product.h"
#include "core/search/misfit.h"
#include "counts.h"
#include "plants.h"

enum { ASKED = 3, MODELS_MOST = 16 };

static const double ASKED_SPEED[ASKED] = {65, 72, 85};

/* Returns the name of the model that a law is, or NULL. */
static const char *
model_of(enum law law)
{
	switch (law) {
	case RIGHT:
	case SHARED:
	case FEW:
	case FIVE:
	case TWO:
	case SCATTER:
		return "grunditz";
	case BYPASS:
		return "grunditz+bypass";
	default:
		return NULL;
	}
}

/* Returns the RMSE, passing 0..1, of the model alone at the speeds asked,
 * calibrated as `calibrate` does. */
static double
error_of(const struct plant *p, const struct site *site, size_t model)
{
	double squares = 0, cells = 0, asked[PLANT_SIEVES], P[PLANT_SIEVES];
	const struct psd *feed = site_feed_of_run(site, SITE_MEAN_FEED);
	bool train[PLANT_RUNS] = {false};
	struct calibrate_options o = calibrate_options_default();
	misfit_mark_default_training(site, train);
	o.train = train;
	o.settings.breakage = (unsigned)model;
	o.bounds = bounds_default(model);
	struct fit fit = counts_fit(site, &o);
	struct model *m = model_new(feed, p->sieve, p->n_sieve, fit.settings);
	model_set_params(m, &fit.params);
	for (size_t i = 0; i < p->n_sieve; i++)
		asked[i] = psd_passing(feed, p->sieve[i]);
	for (size_t k = 0; k < ASKED; k++) {
		model_compute_product(m, ASKED_SPEED[k], P);
		for (size_t i = 0; i < p->n_sieve; i++) {
			if (plant_feed(p, p->sieve[i], p->feed_n) >= 1)
				continue;
			double off = P[i] - plant_truth(p, asked,
						ASKED_SPEED[k], p->sieve[i]);
			squares += off * off;
			cells++;
		}
	}
	model_free(m);
	return sqrt(squares / cells);
}

/* Over plants.  made: the law that made the plant is ranked first; open: it is
 * not ruled out; told: league says that the data can tell the models apart;
 * right: and names this law; first, best, usual: errors in points. */
struct score {
	struct counts_mean made, open, told, right, first, best, usual;
};

/* Returns the standing of a model in the answer: "best", "possible" or
 * "out..". */
static const char *
standing_of(const char *text, const char *model)
{
	FREED char *key = xasprintf("\"model\":\"%s\"", model);
	const char *at = strstr(text, key);
	at = at != NULL ? strstr(at, "\"standing\":\"") : NULL;
	return at != NULL ? at + strlen("\"standing\":\"") : "";
}

static size_t
first_of(const char *text)
{
	for (size_t m = 0; m < breakage_count_models(); m++) {
		FREED char *key =
		    xasprintf("\"best\":\"%s\"", BREAKAGES[m]->name);
		if (strstr(text, key) != NULL)
			return m;
	}
	return SIZE_MAX;
}

static void
count_plant(size_t i, struct score *score)
{
	uint64_t number;
	struct plant p = counts_plant(i, &number);
	const char *maker = model_of(p.law);
	struct site *site = plant_site(&p, number);
	struct counts_talk *talk = counts_talk(site_copy(site));
	const char *text = counts_say(talk, "league");
	size_t first = first_of(text), models = breakage_count_models();
	double error[MODELS_MOST], best = INFINITY;
	for (size_t m = 0; m < models && m < MODELS_MOST; m++) {
		error[m] = error_of(&p, site, m);
		best = fmin(best, error[m]);
	}
	bool tells = strstr(text, "\"can_tell\":true") != NULL;
	FREED char *simplest =
	    xasprintf("\"simplest\":\"%s\"", maker != NULL ? maker : "");
	counts_add(&score->told, tells);
	if (tells && maker != NULL)
		counts_add(&score->right, strstr(text, simplest) != NULL);
	if (maker != NULL) {
		const char *standing = standing_of(text, maker);
		counts_add(&score->made,
		    first < models &&
			strcmp(BREAKAGES[first]->name, maker) == 0);
		counts_add(&score->open, strncmp(standing, "out", 3) != 0);
	}
	if (first < models) {
		counts_add(&score->first, 100 * error[first]);
		counts_add(&score->best, 100 * best);
		counts_add(&score->usual, 100 * error[0]);
	}
	counts_talk_end(talk);
	site_free(site);
}

bool
count_league(size_t n)
{
	struct score score = {.made = {0}};
	for (size_t i = 0; i < n; i++)
		count_plant(i, &score);
	printf("law that made the plant, %%, of %.0f by a law of the league\n"
	       "%-36s",
	    score.made.n, "ranked first");
	counts_print(&score.made, 100);
	printf("\n%-36s", "not ruled out");
	counts_print(&score.open, 100);
	printf("\nnamed, of %2.0f that can be told apart ", score.right.n);
	counts_print(&score.right, 100);
	printf("\nall %zu plants\n%-36s", n, "said to tell them apart, %");
	counts_print(&score.told, 100);
	printf("\n%-36s", "error of the first, points");
	counts_print(&score.first, 1);
	printf("\n%-36s", "of the paper's model");
	counts_print(&score.usual, 1);
	printf("\n%-36s", "of the best, whichever it is");
	counts_print(&score.best, 1);
	printf("\n");
	return counts_between(&score.open, 0.85, 1);
}

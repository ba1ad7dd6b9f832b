/* Counts bands where the stated tip speeds err: of plants that follow Eqs 1 to
 * 3, alone and with what uncertainty says that the speeds move.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "core/numeric/rng.h"
#include "core/posterior/ensemble.h"
#include "counts.h"
#include "plants.h"

enum { ASKED = 3, DRAWS = POSTERIOR_DRAWS };
static const double SPEED[ASKED] = {65, 72, 85};

/* Shares of the passings of a plant that were held, summed over plants. */
struct held {
	double band, squares, with, with_squares, error;
	size_t cells;
};

static void
means_at(struct ensemble *e, double v, double *mean)
{
	ensemble_set_speed(e, v);
	ensemble_mean_answer(e, mean);
}

/* v as it is stated, where it is v (1 + off). */
static void
ask(const struct plant *p, const struct site *site, struct ensemble *e,
    double v, double off, double sd, struct held *held)
{
	double low[PLANT_SIEVES], high[PLANT_SIEVES], mean[3][PLANT_SIEVES],
	    in = 0, with = 0, cells = 0;
	const double step = 0.005;
	means_at(e, v * (1 - step), mean[1]);
	means_at(e, v * (1 + step), mean[2]);
	means_at(e, v, mean[0]);
	double times = 1.2816 * site_effect_of_speed_errors(site, v) * sd;
	for (size_t i = 0; i < p->n_sieve; i++) {
		double P =
		    plant_product(p, p->feed_n, v * (1 + off), p->sieve[i]);
		double more = times * (mean[2][i] - mean[1][i]) / 2 / step;
		if (plant_feed(p, p->sieve[i], p->feed_n) >= 1)
			continue;
		ensemble_row_interval(
		    e, ENSEMBLE_ANSWER, i, 0.8, &low[i], &high[i]);
		cells++;
		in += P > low[i] - 1e-4 && P < high[i] + 1e-4;
		with +=
		    P > mean[0][i] - hypot(mean[0][i] - low[i], more) - 1e-4 &&
		    P < mean[0][i] + hypot(high[i] - mean[0][i], more) + 1e-4;
		held->error += (mean[0][i] - P) * (mean[0][i] - P);
		held->cells++;
	}
	held->band += in / cells;
	held->squares += in / cells * in / cells;
	held->with += with / cells;
	held->with_squares += with / cells * with / cells;
}

static void
count_plant(uint64_t number, double sd, struct held held[ASKED])
{
	struct plant p = plant_of(RIGHT, number), runs = p;
	struct rng_key key = rng_make_key(number, 0, 93);
	for (size_t r = 0; r < p.n_run; r++)
		runs.speed[r] *= 1 + sd * rng_normal(key, (uint32_t)r);
	struct site *site = plant_site(&runs, number);
	for (size_t r = 0; r < p.n_run; r++)
		site->run[r].speed = p.speed[r];
	site_update_digest_and_mean_feed(site);
	struct fit fit;
	struct posterior *posterior = counts_calibrate(site, number, &fit);
	struct ensemble *e =
	    ensemble_new(posterior, &site->run[0].feed, p.sieve, p.n_sieve);
	for (size_t a = 0; a < ASKED; a++)
		ask(&p, site, e, SPEED[a],
		    sd * rng_normal(key, (uint32_t)(10 + a)), sd, &held[a]);
	ensemble_free(e);
	posterior_free(posterior);
	site_free(site);
}

static void
print_share(double sum, double squares, double n)
{
	double mean = sum / n;
	printf(" %3.0f +- %-3.1f", 100 * mean,
	    100 * sqrt(fmax(squares / n - mean * mean, 0) / n));
}

bool
count_speeds(size_t n)
{
	bool ok = true;
	printf("speeds err by   at 65, 72, 85 m/s: band holds %%, with the "
	       "speeds' part %%, error\n");
	for (double sd = 0; sd < 0.011; sd += 0.005) {
		struct held held[ASKED] = {{0}};
		for (uint64_t i = 1; i <= n; i++)
			count_plant(500 + i, sd, held);
		printf("%4.1f %%", 100 * sd);
		for (size_t a = 0; a < ASKED; a++) {
			struct held *h = &held[a];
			print_share(h->band, h->squares, (double)n);
			print_share(h->with, h->with_squares, (double)n);
			printf(
			    " %5.2f ", 100 * sqrt(h->error / (double)h->cells));
			double share = h->with / (double)n;
			double error = sqrt(
			    fmax(h->with_squares / (double)n - share * share,
				0.01) /
			    (double)n);
			ok = ok && share + 3 * error > 0.72;
		}
		printf("\n");
		fflush(stdout);
	}
	return ok;
}

/* Checks the bands if the stated tip speeds err, for plants that follow Eqs 1
 * to 3.  The bands take the speeds to be exact, to have the usual errors, or to
 * have their true errors.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "core/numeric/rng.h"
#include "core/posterior/ensemble.h"
#include "counts.h"
#include "plants.h"

enum { ASKED = 3 };
static const double SPEED[ASKED] = {65, 72, 85};

/* The standard deviation of the speeds that bands assume: 0, the usual one, or
 * the true one. */
enum band { EXACT, USUAL, STATED, BANDS };

/* The share of a plant's passings within the band, summed over plants.  width:
 * the widths of the bands, summed over all passings. */
struct held {
	struct share {
		double sum, squares, width;
	} band[BANDS];
	double error;
	size_t cells;
};

/* Asks about v if the rotor's true speed is v (1 + off). */
static void
ask(const struct plant *p, struct ensemble *e, double v, double off,
    struct share *held, double *error, size_t *cells)
{
	double low, high, mean[PLANT_SIEVES], in = 0, n = 0;
	ensemble_set_speed(e, v);
	ensemble_mean_answer(e, mean);
	for (size_t i = 0; i < p->n_sieve; i++) {
		double P =
		    plant_product(p, p->feed_n, v * (1 + off), p->sieve[i]);
		if (plant_feed(p, p->sieve[i], p->feed_n) >= 1)
			continue;
		ensemble_interval_at_sieve(
		    e, ENSEMBLE_ANSWER, i, 0.8, &low, &high);
		n++;
		in += P > low - 1e-4 && P < high + 1e-4;
		held->width += high - low;
		*error += (mean[i] - P) * (mean[i] - P);
	}
	*cells += (size_t)n;
	held->sum += in / n;
	held->squares += in / n * in / n;
}

/* asked: the speed asked about has an error too. */
static void
count_plant(uint64_t number, double sd, bool asked, struct held held[ASKED])
{
	struct plant p = plant_of(RIGHT, number);
	struct site *site = plant_site_with_speed_errors(&p, number, sd);
	struct fit fit;
	struct posterior *posterior = counts_calibrate(site, number, &fit);
	const double taken[BANDS] = {0, POSTERIOR_USUAL_SPEED_SD, sd};
	for (size_t band = 0; band < BANDS; band++) {
		posterior->speed_sd = taken[band];
		struct ensemble *e = ensemble_new(
		    posterior, &site->run[0].feed, p.sieve, p.n_sieve);
		for (size_t a = 0; a < ASKED; a++) {
			double off = asked ? sd * plant_speed_error(
						      number, PLANT_RUNS + a)
					   : 0;
			struct held *h = &held[a];
			ask(&p, e, SPEED[a], off, &h->band[band], &h->error,
			    &h->cells);
		}
		ensemble_free(e);
	}
	posterior_free(posterior);
	site_free(site);
}

/* Prints a share and the mean width of its bands.  Returns true if the share is
 * at least 72 %, give or take three standard errors. */
static bool
print_share(const struct share *share, size_t cells, double n)
{
	double mean = share->sum / n;
	double variance = fmax(share->squares / n - mean * mean, 0);
	printf(" %3.0f +- %-3.1f %4.2f ", 100 * mean, 100 * sqrt(variance / n),
	    100 * share->width / (double)cells);
	return mean + 3 * sqrt(fmax(variance, 0.01) / n) > 0.72;
}

static bool
count_row(size_t n, double sd, bool asked)
{
	bool ok = true;
	struct held held[ASKED] = {{.error = 0}};
	for (uint64_t i = 1; i <= n; i++)
		count_plant(500 + i, sd, asked, held);
	printf("%3.1f %% %s", 100 * sd, asked ? "all " : "runs");
	for (size_t a = 0; a < ASKED; a++) {
		struct held *h = &held[a];
		size_t cells = h->cells / BANDS;
		print_share(&h->band[EXACT], cells, (double)n);
		ok = print_share(&h->band[USUAL], cells, (double)n) && ok;
		ok = print_share(&h->band[STATED], cells, (double)n) && ok;
		printf("%5.2f ", 100 * sqrt(h->error / (double)h->cells));
	}
	printf("\n");
	fflush(stdout);
	return ok;
}

bool
count_speeds(size_t n)
{
	printf(
	    "speeds that err, all or those of the runs alone; at 65, 72, "
	    "85 m/s: %% held and width\nof the band, exact, usual, with errors "
	    "stated, and error\n");
	bool ok = count_row(n, 0, true);
	for (size_t k = 1; k < 3; k++)
		for (size_t asked = 0; asked < 2; asked++)
			ok = count_row(n, 0.005 * (double)k, asked) && ok;
	return ok;
}

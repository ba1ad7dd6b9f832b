/* Checks the intervals of parameters, of the break size and of the fineness of
 * progeny, on plants that follow Eqs 1 to 3.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>

#include <gsl/gsl_statistics_double.h>

#include "base/xalloc.h"
#include "core/model/breakage.h"
#include "core/model/selection.h"
#include "core/posterior/ensemble.h"
#include "counts.h"
#include "plants.h"

enum { DRAWS = POSTERIOR_DRAWS };

/* The values checked; B(u) is the share of the progeny finer than u times the
 * parent. */
enum what { F_MAT, E0_MIN, ALPHA, BREAK_69, BREAK_79, FINE, HALF, WHATS };
static const char *const NAME[WHATS] = {"f_mat", "e0_min", "alpha",
    "break size, 69 m/s", "break size, 79 m/s", "B(0.1), 74 m/s",
    "B(0.5), 74 m/s"};

static double
finer(const struct params *p, double u)
{
	struct model_settings settings = model_settings_default();
	struct breaker b;
	breaker_set_params(&b, p, &settings);
	breaker_set_speed(&b, 74);
	return b.model->finer(&b, log(u), NULL);
}

static double
value_of(enum what what, const struct params *p,
    const struct model_settings *settings)
{
	static const char *const NAMES[] = {"f_mat", "e0_min", "alpha"};
	switch (what) {
	case BREAK_69:
	case BREAK_79:
		return params_break_size_by_impacts(
		    p, settings, what == BREAK_69 ? 69 : 79);
	case FINE:
		return finer(p, 0.1);
	case HALF:
		return finer(p, 0.5);
	default:
		return params_value_by_name(p, NAMES[what]);
	}
}

static double
truth_of(enum what what, const struct plant *p)
{
	double E = what == BREAK_69 ? 69 * 69 / 2.0 : 79 * 79 / 2.0;
	double place = -log2(what == FINE ? 0.1 : 0.5) / 10 * (PLANT_TABLE - 1);
	size_t i = (size_t)place;
	switch (what) {
	case F_MAT:
		return p->f_mat;
	case E0_MIN:
		return p->e0;
	case ALPHA:
		return p->alpha;
	case FINE:
	case HALF:
		return p->B[i] + (place - (double)i) * (p->B[i + 1] - p->B[i]);
	default:
		return pow(p->e0 / E, 1 / p->alpha);
	}
}

/* For one value, the number of plants whose true value is in the middle 80 % of
 * the draws, and in this interval stretched to contain the fit; the number
 * whose fit is outside; and the sum of the logarithms of the draws' median over
 * the truth. */
struct held {
	size_t in, stretched, outside;
	double off;
};

static void
count_plant(enum law law, uint64_t number, struct held held[WHATS])
{
	struct plant p = plant_of(law, number);
	struct site *site = plant_site(&p, number);
	struct fit fit;
	struct posterior *posterior = counts_calibrate(site, number, &fit);
	for (size_t w = 0; w < WHATS; w++) {
		double draw[DRAWS], low, high,
		    truth = truth_of(w, &p),
		    found = value_of(w, &fit.params, &fit.settings);
		for (size_t d = 0; d < DRAWS; d++)
			draw[d] = value_of(w, &posterior->draw[d].params,
			    &posterior->settings);
		ensemble_middle_interval(draw, 0.8, &low, &high);
		bool in = truth >= low && truth <= high;
		held[w].in += in;
		held[w].outside += found < low || found > high;
		held[w].stretched +=
		    truth >= fmin(low, found) && truth <= fmax(high, found);
		held[w].off += log(gsl_stats_median(draw, 1, DRAWS) / truth);
	}
	posterior_free(posterior);
	site_free(site);
}

bool
count_params(size_t n)
{
	static const enum law OF[] = {RIGHT, FIVE};
	bool ok = true;
	for (size_t l = 0; l < 2; l++) {
		struct held held[WHATS] = {{0}};
		uint64_t number = 0;
		for (size_t i = 0; i < n; i++) {
			do
				number++;
			while (plant_of(OF[l], number).e0 > 28);
			count_plant(OF[l], number, held);
		}
		printf("%-20s %s\n", LAW_NAME[OF[l]],
		    "  held %    median off %   stretched: held %  ends at "
		    "the fit %");
		for (size_t w = 0; w < WHATS; w++) {
			printf("%-20s", NAME[w]);
			ok = counts_share(held[w].in, n,
				 w <= ALPHA ? 0.72 : 0.5, 0.95) &&
			     ok;
			printf(" %10.0f %15.0f %17.0f\n",
			    100 * expm1(held[w].off / (double)n),
			    100.0 * (double)held[w].stretched / (double)n,
			    100.0 * (double)held[w].outside / (double)n);
		}
		fflush(stdout);
	}
	return ok;
}

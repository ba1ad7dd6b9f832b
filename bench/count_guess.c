/* Checks the band of guess with rocks as strong as one of Table 3, which is
 * left out, and random feeds and fragment laws.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/xalloc.h"
#include "core/answer/guess.h"
#include "core/numeric/rng.h"
#include "counts.h"
#include "io/store/material.h"
#include "measure.h"
#include "plants.h"

enum { ROWS = 19 };

/* How rocks break: by the default beta; by the plants' beta, whose first is
 * 0.15 times a normal number; by B = u^q; or by a beta of any direction for
 * which 3 to 65 % of the progeny is finer than a tenth. */
enum fragments { DEFAULT, PLANTS, POWERS, ANY, FRAGMENTS };
static const char *const NAME[FRAGMENTS] = {"the default",
    "those of the plants", "u^q, q 0.25 to 1.4", "any, 3 to 65 %"};

/* Computes p->B at even steps of ln u, from the density p(u) with beta, or u^q
 * if beta is NULL.  Returns B(1/10). */
static double
integrate(struct plant *p, const double *beta, double q)
{
	double total = 0;
	p->B[PLANT_TABLE - 1] = 0;
	for (size_t i = PLANT_TABLE - 1; i-- > 0;) {
		double u = exp2(-10 * ((double)i + 0.5) / (PLANT_TABLE - 1));
		total += beta == NULL
			     ? pow(u, q)
			     : fmax(0, beta[0] + beta[1] * u + beta[2] * u * u +
					   beta[3] * u * u * u);
		p->B[i] = total;
	}
	for (size_t i = 0; i < PLANT_TABLE && total > 0; i++)
		p->B[i] /= total;
	return p->B[(size_t)(log2(10) / 10 * (PLANT_TABLE - 1))];
}

static void
put_fragments(struct plant *p, enum fragments law, struct rng_key key)
{
	double beta[4] = {0, 1, -1, 0.5}, fine;
	if (law == POWERS)
		integrate(p, NULL, 0.25 + 1.15 * rng_uniform(key, 0));
	if (law == DEFAULT)
		integrate(p, beta, 0);
	if (law != ANY)
		return;
	uint32_t at = 1;
	do {
		for (size_t k = 0; k < 4; k++)
			beta[k] = 2 * rng_uniform(key, at++) - 1;
		fine = integrate(p, beta, 0);
	} while (!(fine > 0.03 && fine < 0.65));
}

/* Returns a plant with the row's strength and top size and the given law of
 * fragments. */
static struct plant
rock_of(enum fragments law, const struct material *row, uint64_t number)
{
	struct plant p = plant_of(RIGHT, number);
	double top = row->top_size_mm / 1000;
	for (size_t i = 0; i < p.n_sieve; i++)
		p.sieve[i] *= top / p.top;
	p.top = top;
	p.f_mat = row->params.f_mat;
	p.e0 = row->params.e0_min;
	p.alpha = row->params.alpha;
	put_fragments(&p, law, rng_make_key(number, law, 91));
	return p;
}

/* Lists all materials, and in pick those of other sites to guess from.  Returns
 * their number. */
static size_t
others(const struct material_list *table, const struct material *row,
    struct guess_material *m, size_t *pick, bool open)
{
	size_t n = 0;
	for (size_t i = 0; i < ROWS; i++) {
		const struct material *r = &table->item[i];
		m[i] = (struct guess_material){r->site, r->rock,
		    r->top_size_mm / 1000, r->params, model_settings_default(),
		    open};
		if (strcmp(r->site, row->site) != 0)
			pick[n++] = i;
	}
	return n;
}

/* Returns the share of the passings within the band.  Sets *error to the RMSE
 * of the guess. */
static double
held_of(const struct plant *p, const struct site *site,
    const struct material_list *table, size_t row, double v, bool open,
    double *error)
{
	struct guess_material m[ROWS];
	size_t pick[ROWS], n = others(table, &table->item[row], m, pick, open),
			   cells = 0, in = 0;
	struct guess g = guess_psd_from_materials(site, 0, m, pick, n, v);
	*error = 0;
	for (size_t i = 0; i < g.median.n; i++) {
		double s = g.median.size[i],
		       P = plant_product(p, p->feed_n, v, s);
		if (plant_feed(p, s, p->feed_n) >= 1)
			continue;
		cells++;
		in +=
		    P > g.low.passing[i] - 1e-4 && P < g.high.passing[i] + 1e-4;
		*error += pow(g.median.passing[i] - P, 2);
	}
	guess_free(&g);
	*error = sqrt(*error / (double)cells);
	return (double)in / (double)cells;
}

bool
count_guess(size_t n)
{
	bool ok = true;
	double *error = xcalloc_doubles(n);
	struct material_list list = {0}, *table = &list;
	material_add_table3_to_list(table);
	printf("%-22s %s\n", "fragments",
	    "  held %    RMSE, median   at one "
	    "law, held %");
	for (size_t l = 0; l < FRAGMENTS; l++) {
		double sum[2] = {0}, squares = 0, ignored;
		for (size_t i = 0; i < n; i++) {
			size_t row = i % ROWS;
			struct plant p = rock_of(
			    (enum fragments)l, &table->item[row], 4000 + i);
			struct site *site = plant_site(&p, 4000 + i);
			double v = 65 +
				   20 * rng_uniform(rng_make_key(i, l, 92), 0),
			       held = held_of(
				   &p, site, table, row, v, true, &error[i]);
			sum[0] += held / (double)n;
			squares += held * held / (double)n;
			sum[1] +=
			    held_of(&p, site, table, row, v, false, &ignored) /
			    (double)n;
			site_free(site);
		}
		double se =
		    sqrt(fmax(squares - sum[0] * sum[0], 0) / (double)n);
		printf("%-22s %5.0f +- %-5.1f %6.1f %14.0f\n", NAME[l],
		    100 * sum[0], 100 * se, 100 * measure_median(error, n),
		    100 * sum[1]);
		ok = ok && (l == DEFAULT || (sum[0] + 3 * se > 0.72 &&
						sum[0] - 3 * se < 0.92));
	}
	free(error);
	material_list_free(table);
	return ok;
}

/* The candidates that generations keep: percentiles against a plain
 * recomputation on the accurate product.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "made.h"

#include <stdlib.h>

#include "core/model/selection.h"
#include "core/search/candidates.h"
#include "core/search/misfit.h"

enum { TIERP_ROW = 2, POPULATION = 300, GENERATIONS = 12 };

struct searched {
	struct site *site;
	struct calibration *c;
	bool train[8];
};

static struct searched
search(size_t generations, size_t population)
{
	struct searched s = {.site = made_site(&TABLE_3[TIERP_ROW], 0.005, 4)};
	struct calibrate_options o = calibrate_options_default();
	o.population = population;
	misfit_mark_default_training(s.site, s.train);
	s.c = calibration_new(s.site, &o);
	for (size_t i = 0; i < generations; i++)
		calibration_step(s.c);
	return s;
}

static void
end(struct searched *s)
{
	calibration_free(s->c);
	site_free(s->site);
}

static struct params
candidate(const struct calibrate_generation *g, size_t i)
{
	struct params p = {.breakage = g->params.breakage};
	for (size_t j = 0; j < 7; j++)
		p.at[j] = (double)g->kept[j][i];
	return p;
}

static int
compare(const void *a, const void *b)
{
	double x = *(const double *)a, y = *(const double *)b;
	return (x > y) - (x < y);
}

/* The search's scheme is close near the best, and errs by a share of what
 * candidates far off differ by. */
static double
allowed(double difference)
{
	return 0.004 + 0.03 * fabs(difference);
}

static void
percentiles_are_those_of_the_candidates(void **state)
{
	(void)state;
	struct searched s = search(GENERATIONS, POPULATION);
	size_t n;
	const struct calibrate_generation *g =
	    calibration_generation_history(s.c, &n);
	struct model_settings settings = model_settings_default();
	struct misfit *m = misfit_new(s.site, s.train, NULL, false, settings);
	double *d = xcalloc_doubles(m->n_residual * CALIBRATE_KEPT);
	double *one = xcalloc_doubles(m->n_residual),
	       *best = xcalloc_doubles(m->n_residual);
	assert_int_equal(n, GENERATIONS);
	for (size_t at = 0; at < n; at += 3) {
		struct candidates c = candidates_compute_residuals(
		    s.site, s.train, settings, ISA_BEST, &g[at], &g[at].params);
		assert_int_equal(c.n, m->n_residual);
		assert_int_equal(g[at].n_kept, CALIBRATE_KEPT);
		for (size_t i = 0; i < CALIBRATE_KEPT; i++) {
			struct params p = candidate(&g[at], i);
			misfit_weighted_differences(m, &p, one);
			for (size_t k = 0; k < c.n; k++)
				d[k * CALIBRATE_KEPT + i] = one[k];
		}
		misfit_weighted_differences(m, &g[at].params, best);
		for (size_t k = 0; k < c.n; k++) {
			double *own = d + k * CALIBRATE_KEPT;
			qsort(own, CALIBRATE_KEPT, sizeof *own, compare);
			expect_near(
			    "p10", c.cell[k].p10, own[6], allowed(own[6]));
			expect_near("median", c.cell[k].median, own[32],
			    allowed(own[32]));
			expect_near(
			    "p90", c.cell[k].p90, own[57], allowed(own[57]));
			expect_near("best", c.cell[k].best, best[k], 1e-12);
		}
		candidates_clear(&c);
	}
	free(d);
	free(one);
	free(best);
	misfit_free(m);
	end(&s);
}

/* Cells are those of the runs fitted, and the worst is the worst. */
static void
cells_are_of_the_training_runs(void **state)
{
	(void)state;
	struct searched s = search(1, POPULATION);
	size_t n;
	const struct calibrate_generation *g =
	    calibration_generation_history(s.c, &n);
	struct candidates c = candidates_compute_residuals(
	    s.site, s.train, model_settings_default(), ISA_BEST, g, &g->params);
	const struct candidates_cell *worst =
	    candidates_worst_fitted_passing(&c);
	for (size_t k = 0; k < c.n; k++) {
		assert_true(s.train[c.cell[k].run]);
		assert_true(fabs(c.cell[k].median) <= fabs(worst->median));
	}
	assert_true(c.speed == s.site->run[0].speed);
	assert_true(c.break_size[0] <= c.break_size[1] &&
		    c.break_size[1] <= c.break_size[2]);
	candidates_clear(&c);
	end(&s);
}

/* With measured collision energies the strongest impact breaks the finest rock,
 * as in all other answers. */
static void
break_sizes_are_those_of_the_impacts(void **state)
{
	(void)state;
	struct searched s = search(6, POPULATION);
	size_t n;
	const struct calibrate_generation *g =
	    calibration_generation_history(s.c, &n) + 5;
	struct model_settings settings = model_settings_default();
	settings.impacts = (struct impacts){
	    .n = 2, .number = 4, .share = {0.7, 0.3}, .ratio = {0.2, 1.6}};
	double size[CALIBRATE_KEPT];
	for (size_t i = 0; i < CALIBRATE_KEPT; i++) {
		struct params p = candidate(g, i);
		size[i] = params_break_size_by_impacts(
		    &p, &settings, s.site->run[0].speed);
	}
	qsort(size, CALIBRATE_KEPT, sizeof *size, compare);
	struct candidates c = candidates_compute_residuals(
	    s.site, s.train, settings, ISA_BEST, g, &g->params);
	assert_int_equal(g->n_kept, CALIBRATE_KEPT);
	for (size_t k = 0; k < 3; k++) {
		size_t at = (k + 1) * CALIBRATE_KEPT / 4;
		assert_true(c.break_size[k] >= size[at - 1]);
		assert_true(c.break_size[k] <= size[at + 1]);
	}
	candidates_clear(&c);
	end(&s);
}

/* Beta is told over its largest, so that it does not jump when polished. */
static void
beta_is_scaled_as_it_is_reported(void **state)
{
	(void)state;
	struct searched s = search(6, POPULATION);
	size_t n;
	const struct calibrate_generation *g =
	    calibration_generation_history(s.c, &n) + 5;
	double low, high, least = INFINITY, most = -INFINITY;
	for (size_t j = 0; j < 4; j++) {
		candidates_p10_p90_of_param(g, j, &low, &high);
		assert_true(low >= -1 && low <= high && high <= 1);
		least = fmin(least, low);
		most = fmax(most, high);
	}
	assert_true(most == 1 || least == -1);
	candidates_p10_p90_of_param(g, 4, &low, &high);
	size_t below = 0;
	for (size_t i = 0; i < g->n_kept; i++)
		below += (double)g->kept[4][i] < low;
	assert_int_equal(below, 6);
	end(&s);
}

/* No more are kept than there are, and the elite is none of them. */
static void
a_small_population_keeps_what_it_has(void **state)
{
	(void)state;
	struct searched s = search(3, 16);
	size_t n;
	const struct calibrate_generation *g =
	    calibration_generation_history(s.c, &n);
	assert_in_range(g[2].n_kept, 8, 15);
	struct candidates c = candidates_compute_residuals(s.site, s.train,
	    model_settings_default(), ISA_BEST, &g[2], &g[2].params);
	for (size_t k = 0; k < c.n; k++)
		assert_true(c.cell[k].p10 <= c.cell[k].median &&
			    c.cell[k].median <= c.cell[k].p90);
	candidates_clear(&c);
	end(&s);
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(percentiles_are_those_of_the_candidates),
	    cmocka_unit_test(cells_are_of_the_training_runs),
	    cmocka_unit_test(break_sizes_are_those_of_the_impacts),
	    cmocka_unit_test(beta_is_scaled_as_it_is_reported),
	    cmocka_unit_test(a_small_population_keeps_what_it_has)};
	return cmocka_run_group_tests(tests, NULL, NULL);
}

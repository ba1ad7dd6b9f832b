/* The covariance of many passings: the same as of one matrix of all, in room
 * that grows with the runs.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "made.h"

#include <stdlib.h>
#include <string.h>

#include "core/posterior/covariance.h"

enum { SIEVES = 8, MOST = 40 * SIEVES };

/* Made-up cells of so many runs, from 66 to 84 m/s with repeats at some; apart:
 * how much the sieves of one differ from those of another, as a logarithm. */
static size_t
make_cells(size_t runs, double apart, struct cell *cell)
{
	struct draw draw = draw_start(runs);
	size_t n = 0;
	for (size_t r = 0; r < runs; r++) {
		double v = 66 + 18 * (double)(r / 2) / (double)runs * 2;
		double by = apart * draw_between(&draw, -1, 1);
		/* Some have fewer. */
		for (size_t i = r % 5 == 0; i < SIEVES; i++) {
			double P = draw_between(&draw, 0, 1);
			cell[n++] = (struct cell){.run = r,
			    .log_size = by - 4 - 0.69 * (double)i,
			    .t = discrepancy_speed_to_coordinate(
				v, el_log(2750)),
			    .h = i == 0 ? 0 : discrepancy_scale_at_passing(P)};
		}
	}
	return n;
}

/* Hyperparameters as far from their medians as chains begin. */
static void
make_hyper(struct draw *draw, double *log_hyper)
{
	for (size_t h = 0; h < HYPERS; h++)
		log_hyper[h] = el_log(HYPER[h].median) +
			       2 * HYPER[h].spread * draw_between(draw, -1, 1);
}

/* Probability and solution against those of the whole matrix. */
static void
test_same(void **state)
{
	(void)state;
	struct cell cell[MOST];
	size_t n = make_cells(20, 0, cell);
	double *U = xcalloc_doubles(n * n), *d = xcalloc_doubles(4 * n);
	double *x = d + n, *y = x + n, *z = y + n;
	struct draw draw = draw_start(1);
	struct covariance *c = covariance_new(ISA_BEST, cell, n);
	double *factor = xcalloc_doubles(covariance_factor_size(c));
	for (size_t k = 0; k < 50; k++) {
		double hyper[HYPERS];
		make_hyper(&draw, hyper);
		for (size_t i = 0; i < n; i++)
			d[i] = x[i] = y[i] = z[i] =
			    0.01 * cell[i].h * draw_between(&draw, -1, 1);
		covariance_compute_factor(c, hyper, factor);
		discrepancy_factor_covariance(ISA_BEST, cell, n, hyper, U);
		double level = covariance_minus_log_density(c, factor, z);
		double want = discrepancy_minus_log_density(ISA_BEST, U, n, y);
		expect_near("level", level, want, 1e-4 + 1e-6 * fabs(want));
		covariance_solve(c, factor, d);
		discrepancy_solve_lower(ISA_BEST, U, n, x);
		discrepancy_solve_upper(U, n, x);
		double most = 0;
		for (size_t i = 0; i < n; i++)
			most = fmax(most, fabs(x[i]));
		for (size_t i = 0; i < n; i++)
			expect_near("solution", d[i], x[i], 1e-5 * most);
	}
	covariance_free(c);
	free(factor);
	free(U);
	free(d);
}

/* Few cells are one matrix; of many the room grows by what a run has. */
static void
test_room(void **state)
{
	(void)state;
	struct cell cell[MOST];
	size_t n = make_cells(12, 0, cell), room[2];
	struct covariance *c = covariance_new(ISA_BEST, cell, n);
	assert_int_equal(covariance_factor_size(c), n * n);
	covariance_free(c);
	for (size_t k = 0; k < 2; k++) {
		n = make_cells(k == 0 ? 20 : 40, 0, cell);
		c = covariance_new(ISA_BEST, cell, n);
		room[k] = covariance_factor_size(c);
		covariance_free(c);
	}
	assert_in_range(room[1] - room[0], 1, 20 * SIEVES * SIEVES);
}

/* Where each run has sieves of its own these are taken together as so many, no
 * farther than half of what these lie apart. */
static void
test_sizes(void **state)
{
	(void)state;
	struct cell cell[MOST], moved[MOST];
	double size[MOST], log_hyper[HYPERS], d[MOST];
	size_t n = make_cells(40, 0.3, cell), sizes = 0;
	memcpy(moved, cell, sizeof moved);
	struct covariance *c = covariance_new(ISA_BEST, moved, n);
	for (size_t i = 0; i < n; i++) {
		size_t s = 0;
		while (s < sizes && size[s] != moved[i].log_size)
			s++;
		if (s == sizes)
			size[sizes++] = moved[i].log_size;
		expect_near("size", moved[i].log_size, cell[i].log_size,
		    (7 * 0.69 + 0.6) / (COVARIANCE_SIZES - 1) / 2);
		d[i] = 0.01 * cell[i].h;
	}
	assert_in_range(sizes, SIEVES, COVARIANCE_SIZES);
	double *factor = xcalloc_doubles(covariance_factor_size(c));
	for (size_t h = 0; h < HYPERS; h++)
		log_hyper[h] = el_log(HYPER[h].median);
	covariance_compute_factor(c, log_hyper, factor);
	assert_true(isfinite(covariance_minus_log_density(c, factor, d)));
	covariance_free(c);
	free(factor);
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(test_same),
	    cmocka_unit_test(test_room),
	    cmocka_unit_test(test_sizes),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}

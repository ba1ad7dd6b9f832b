/* Coordinates of parameters: there and back, and the prior's density.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "made.h"

#include <math.h>
#include <string.h>

#include "core/model/breakage.h"
#include "core/posterior/coordinates.h"

static struct coordinates
some(struct params *fit)
{
	struct bounds bounds = bounds_default(0);
	struct model_settings settings = model_settings_default();
	*fit = params_start_values(0);
	const double at[] = {0.1, 0.9, -1, 0.4, 0.3, 17, 0.93};
	for (size_t j = 0; j < ARRAY_LEN(at); j++)
		fit->at[j] = at[j];
	return coordinates_new_about_fit(fit, &bounds, &settings, log(2700));
}

/* Of the gauge only the direction comes back. */
static void
there_and_back(void **state)
{
	struct params fit;
	struct coordinates c = some(&fit);
	double x[PARAMS_MOST], at[PARAMS_MOST];
	(void)state;
	coordinates_from_params(&c, fit.at, x);
	for (size_t j = 0; j < 4; j++)
		assert_float_equal(x[j], 0, 1e-12);
	x[0] = 0.3;
	x[1] = -0.2;
	x[3] = 0.1;
	assert_true(isfinite(coordinates_to_params(&c, x, at)));
	double y[PARAMS_MOST];
	coordinates_from_params(&c, at, y);
	for (size_t j = 0; j < c.of->n; j++)
		assert_float_equal(y[j], x[j], 1e-9);
	for (size_t j = 4; j < c.of->n; j++)
		assert_float_equal(at[j], fit.at[j], 1e-9);
}

/* The determinant of a 3 x 3 matrix. */
static double
determinant(double m[3][3])
{
	double sum = 0;
	for (size_t k = 0; k < 3; k++) {
		size_t a = (k + 1) % 3, b = (k + 2) % 3;
		sum += m[0][k] * (m[1][a] * m[2][b] - m[1][b] * m[2][a]);
	}
	return sum;
}

/* ln of what a small cube of f_mat, e0_min and alpha's coordinates is large
 * as parameters; of the gauge's, on the sphere. */
static double
log_volume(const struct coordinates *c, const double *x, const size_t move[3],
    bool gauge)
{
	const double step = 1e-5;
	double derivative[3][PARAMS_MOST], m[3][3] = {{0}};
	for (size_t k = 0; k < 3; k++) {
		double y[PARAMS_MOST], a[PARAMS_MOST], b[PARAMS_MOST];
		memcpy(y, x, sizeof y);
		y[move[k]] = x[move[k]] - step;
		coordinates_to_params(c, y, a);
		y[move[k]] = x[move[k]] + step;
		coordinates_to_params(c, y, b);
		for (size_t j = 0; j < c->of->n; j++)
			derivative[k][j] = (b[j] - a[j]) / (2 * step);
	}
	for (size_t i = 0; i < 3; i++)
		for (size_t j = 0; j < 3; j++)
			for (size_t k = gauge ? 0 : 4; k < (gauge ? 4 : 7); k++)
				m[i][j] += derivative[i][k] * derivative[j][k];
	return log(determinant(m)) / 2;
}

/* Uniform in the parameters and on the sphere: where a cube of coordinates is
 * larger as parameters it is more probable by as much. */
static void
prior_is_uniform(void **state)
{
	static const size_t SLOPE[] = {4, 5, 6}, GAUGE[] = {0, 1, 3};
	struct params fit;
	struct coordinates c = some(&fit);
	double x[PARAMS_MOST] = {0}, y[PARAMS_MOST], at[PARAMS_MOST];
	(void)state;
	coordinates_from_params(&c, fit.at, x);
	memcpy(y, x, sizeof y);
	for (size_t k = 0; k < 3; k++) {
		y[SLOPE[k]] += 0.4 - 0.3 * (double)k;
		y[GAUGE[k]] += 0.2 + 0.1 * (double)k;
	}
	double less =
	    coordinates_to_params(&c, x, at) - coordinates_to_params(&c, y, at);
	double larger =
	    log_volume(&c, y, SLOPE, false) - log_volume(&c, x, SLOPE, false) +
	    log_volume(&c, y, GAUGE, true) - log_volume(&c, x, GAUGE, true);
	assert_float_equal(less, larger, 1e-6);
	assert_true(fabs(larger) > 0.1);
}

static void
keeps_within_bounds(void **state)
{
	struct params fit;
	struct coordinates c = some(&fit);
	double x[PARAMS_MOST] = {0}, at[PARAMS_MOST];
	(void)state;
	coordinates_from_params(&c, fit.at, x);
	for (int far = -4; far <= 4; far++)
		for (size_t j = 4; j < 7; j++) {
			double y[PARAMS_MOST];
			memcpy(y, x, sizeof y);
			y[j] = far;
			assert_true(isfinite(coordinates_to_params(&c, y, at)));
			for (size_t k = 4; k < 7; k++)
				assert_true(at[k] >= c.bounds.lower[k] &&
					    at[k] <= c.bounds.upper[k]);
		}
}

/* A direction in which p(u) is nowhere above 0 is none of rock that breaks. */
static void
wants_daughters(void **state)
{
	struct params fit;
	struct coordinates c = some(&fit);
	double x[PARAMS_MOST], at[PARAMS_MOST];
	const double none[] = {-0.2, -0.1, -1, 0.4};
	(void)state;
	memcpy(at, fit.at, sizeof at);
	memcpy(at, none, sizeof none);
	coordinates_from_params(&c, at, x);
	assert_true(isinf(coordinates_to_params(&c, x, at)));
	memcpy(at, fit.at, sizeof at);
	at[0] = -0.2;
	coordinates_from_params(&c, at, x);
	assert_true(isfinite(coordinates_to_params(&c, x, at)));
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
	    cmocka_unit_test(there_and_back),
	    cmocka_unit_test(prior_is_uniform),
	    cmocka_unit_test(keeps_within_bounds),
	    cmocka_unit_test(wants_daughters),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}

/* Chooses the method, continuous or classes, and adds the bypass (D14).
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "core/model/product.h"

#include <math.h>
#include <stdlib.h>

#include "base/xalloc.h"
#include "core/model/classes.h"
#include "core/model/continuous.h"

/* One of continuous and classes is NULL. */
struct model {
	struct breaker b;
	struct model_settings settings;
	struct continuous_solver *continuous;
	struct classes_solver *classes;
	size_t n_sieve;
	double *feed;         /* passing */
	double *plus, *minus; /* products for the finite differences */
};

struct model *
model_new(const struct psd *feed, const double *sieve, size_t n,
    struct model_settings settings)
{
	struct model *model = xcalloc(1, sizeof *model);
	model->n_sieve = n;
	model->settings = settings;
	model->feed = xcalloc_doubles(n);
	for (size_t i = 0; i < n; i++)
		model->feed[i] = psd_passing(feed, sieve[i]);
	if (settings.method == METHOD_CLASSES)
		model->classes = classes_solver_new(
		    &model->b, feed, sieve, n, settings.appearance);
	else
		model->continuous = continuous_solver_new(
		    &model->b, feed, sieve, model->feed, n);
	model->plus = xcalloc_doubles(n);
	model->minus = xcalloc_doubles(n);
	return model;
}

void
model_free(struct model *model)
{
	if (model == NULL)
		return;
	continuous_solver_free(model->continuous);
	classes_solver_free(model->classes);
	free(model->feed);
	free(model->plus);
	free(model->minus);
	free(model);
}

void
model_set_params(struct model *model, const struct params *p)
{
	breaker_set_params(&model->b, p, &model->settings);
}

/* Applies D14: the parameters' share of the feed bypasses the rotor, and the
 * settings' share of the rest.  d_passing [n_sieve * model's n], or NULL: turns
 * the derivatives of the crushed part into those of the product. */
static void
product_add_bypass(
    const struct model *model, double *passing, double *d_passing)
{
	const struct breakage *of = model->b.model;
	if (!of->bypass && model->settings.bypass == 0)
		return;
	double share = of->bypass ? model->b.p.at[of->n - 1] : 0;
	double all = 1 - model->settings.bypass;
	for (size_t s = 0; s < model->n_sieve; s++) {
		double broken = all * (passing[s] - model->feed[s]);
		passing[s] = model->feed[s] + (1 - share) * broken;
		if (d_passing == NULL)
			continue;
		double *row = d_passing + s * of->n;
		for (size_t j = 0; j < of->n; j++)
			row[j] *= all * (1 - share);
		if (of->bypass)
			row[of->n - 1] = -broken;
	}
}

/* Returns a step that is small compared with the parameter or, if that is
 * larger, with its scale: the largest parameter of the gauge, else 0.01. */
static double
finite_difference_step(const struct params *p, size_t i)
{
	double scale = i < breakage_model_of_params(p)->gauge
			   ? params_largest_beta(p)
			   : 1e-2;
	return 1e-6 * fmax(fabs(p->at[i]), scale);
}

static void
product_with_parameter_at(
    struct model *model, double v, size_t i, double at, double *passing)
{
	struct params p = model->b.p;
	p.at[i] = at;
	model_set_params(model, &p);
	breaker_set_speed(&model->b, v);
	classes_solver_compute_product(model->classes, passing);
}

static void
finite_difference_jacobian(struct model *model, double v, double *d_passing)
{
	const struct params p = model->b.p;
	size_t n = model->b.model->n;
	for (size_t i = 0; i < n; i++) {
		double h = finite_difference_step(&p, i);
		product_with_parameter_at(
		    model, v, i, p.at[i] + h, model->plus);
		product_with_parameter_at(
		    model, v, i, p.at[i] - h, model->minus);
		for (size_t s = 0; s < model->n_sieve; s++)
			d_passing[s * n + i] =
			    h > 0 ? (model->plus[s] - model->minus[s]) / (2 * h)
				  : 0;
		model_set_params(model, &p);
	}
}

void
model_jacobian(
    struct model *model, double v, double *passing, double *d_passing)
{
	breaker_set_speed(&model->b, v);
	if (model->classes == NULL)
		continuous_solver_compute_product(
		    model->continuous, passing, d_passing);
	else
		classes_solver_compute_product(model->classes, passing);
	if (model->classes != NULL && d_passing != NULL)
		finite_difference_jacobian(model, v, d_passing);
	product_add_bypass(model, passing, d_passing);
}

void
model_compute_product(struct model *model, double v, double *passing)
{
	model_jacobian(model, v, passing, NULL);
}

bool
model_is_feed_broken(struct model *model, double v)
{
	breaker_set_speed(&model->b, v);
	return model->classes != NULL
		   ? classes_solver_is_feed_broken(model->classes)
		   : breaker_has_progeny(&model->b);
}

double
model_broken_feed_share(struct model *model, double v)
{
	const struct breakage *of = model->b.model;
	double share = of->bypass ? 1 - model->b.p.at[of->n - 1] : 1;
	breaker_set_speed(&model->b, v);
	return (1 - model->settings.bypass) * share *
	       (model->classes != NULL
		       ? classes_solver_broken_feed_share(model->classes)
		       : continuous_solver_broken_feed_share(
			     model->continuous));
}

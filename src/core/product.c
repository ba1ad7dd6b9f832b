/* One door to the two methods.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "core/product.h"

#include <math.h>
#include <stdlib.h>

#include "base/xalloc.h"
#include "core/appearance.h"
#include "core/classes.h"
#include "core/continuous.h"

/* One of the two is NULL. */
struct model {
	struct continuous *continuous;
	struct classes *classes;
	size_t n_sieve;
	struct params p;
	double *plus, *minus; /* products on both sides, for differences */
};

struct model *
model_new(const struct psd *feed, const double *sieve, size_t n,
    struct model_settings settings)
{
	struct model *model = xcalloc(1, sizeof *model);
	model->n_sieve = n;
	if (settings.method == METHOD_CLASSES)
		model->classes = classes_new(feed, sieve, n, settings);
	else
		model->continuous = continuous_new(feed, sieve, n, settings.k);
	model->plus = xdoubles(n);
	model->minus = xdoubles(n);
	return model;
}

void
model_free(struct model *model)
{
	if (model == NULL)
		return;
	continuous_free(model->continuous);
	classes_free(model->classes);
	free(model->plus);
	free(model->minus);
	free(model);
}

void
model_set(struct model *model, const struct params *p)
{
	model->p = *p;
	if (model->classes != NULL)
		classes_set(model->classes, p);
	else
		continuous_set(model->continuous, p);
}

void
model_product(struct model *model, double v, double *passing)
{
	if (model->classes != NULL)
		classes_product(model->classes, v, passing);
	else
		continuous_product(model->continuous, v, passing, NULL);
}

/* A step small beside the parameter, or beside the scale of its kind. */
static double
difference_step(const struct params *p, size_t i)
{
	double scale = i < 4 ? 0 : 1e-2;
	for (size_t b = 0; b < 4 && i < 4; b++)
		scale = fmax(scale, fabs(p->beta[b]));
	return 1e-6 * fmax(fabs(p->at[i]), scale);
}

static void
classes_jacobian(struct model *model, double v, double *d_passing)
{
	for (size_t i = 0; i < PARAM_COUNT; i++) {
		struct params moved = model->p;
		double at = model->p.at[i];
		double h = difference_step(&model->p, i);
		moved.at[i] = at + h;
		classes_set(model->classes, &moved);
		classes_product(model->classes, v, model->plus);
		moved.at[i] = at - h;
		classes_set(model->classes, &moved);
		classes_product(model->classes, v, model->minus);
		for (size_t s = 0; s < model->n_sieve; s++)
			d_passing[s * PARAM_COUNT + i] =
			    h > 0 ? (model->plus[s] - model->minus[s]) / (2 * h)
				  : 0;
	}
	classes_set(model->classes, &model->p);
}

/* continuous works with beta scaled to 1, which scales its derivatives. */
static void
unscale_beta(const struct model *model, double *d_passing)
{
	double largest = 0;
	for (size_t b = 0; b < 4; b++)
		largest = fmax(largest, fabs(model->p.beta[b]));
	if (largest <= 0)
		return;
	for (size_t s = 0; s < model->n_sieve; s++)
		for (size_t b = 0; b < 4; b++)
			d_passing[s * PARAM_COUNT + b] /= largest;
}

void
model_jacobian(
    struct model *model, double v, double *passing, double *d_passing)
{
	if (model->classes != NULL) {
		classes_product(model->classes, v, passing);
		classes_jacobian(model, v, d_passing);
		return;
	}
	continuous_product(model->continuous, v, passing, d_passing);
	unscale_beta(model, d_passing);
}

bool
model_breaks(const struct model *model)
{
	return model->classes != NULL ? classes_breaks(model->classes)
				      : appearance_of(model->p.beta).total > 0;
}

double
model_selected(struct model *model, double v)
{
	return model->classes != NULL
		   ? classes_selected(model->classes, v)
		   : continuous_selected(model->continuous, v);
}

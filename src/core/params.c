/* The table of parameters.  Everything that prints, parses or bounds one reads
 * it here.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "core/params.h"

#include <assert.h>
#include <math.h>
#include <string.h>

const struct param_info PARAMS[PARAM_COUNT] = {
    {"beta1", "-", -1000, 1000, -BETA_MOST, BETA_MOST,
	"appearance: constant term"},
    {"beta2", "-", -1000, 1000, -BETA_MOST, BETA_MOST, "appearance: term in u"},
    {"beta3", "-", -1000, 1000, -BETA_MOST, BETA_MOST,
	"appearance: term in u squared"},
    {"beta4", "-", -1000, 1000, -BETA_MOST, BETA_MOST,
	"appearance: term in u cubed"},
    {"f_mat", "kg/(J m)", 0.001, 3, 0, F_MAT_MOST,
	"material: a higher one breaks more"},
    {"e0_min", "J m/kg", 0, 30, 0, E0_MIN_MOST,
	"threshold energy for breakage"},
    {"alpha", "-", 0, 1, 0, ALPHA_MOST, "size dependency of breakage"},
};

size_t
params_find(const char *name)
{
	size_t i = 0;
	while (i < PARAM_COUNT && strcmp(PARAMS[i].name, name) != 0)
		i++;
	return i;
}

/* 1 - exp(-u) has density u exp(-u) in ln u; this is its cubic. */
struct params
params_default_beta(void)
{
	return (struct params){.beta = {0, 1, -1, 0.5}};
}

void
params_scale_beta(struct params *p)
{
	double largest = 0;
	for (size_t i = 0; i < 4; i++)
		largest = fmax(largest, fabs(p->beta[i]));
	if (largest > 0)
		for (size_t i = 0; i < 4; i++)
			p->beta[i] /= largest;
}

struct bounds
bounds_default(void)
{
	struct bounds b;
	for (size_t i = 0; i < PARAM_COUNT; i++) {
		b.lower[i] = PARAMS[i].lower;
		b.upper[i] = PARAMS[i].upper;
	}
	return b;
}

struct model_settings
model_settings_default(void)
{
	return (struct model_settings){
	    METHOD_CONTINUOUS, APPEARANCE_RATIO, 1.0};
}

bool
model_settings_same(
    const struct model_settings *a, const struct model_settings *b)
{
	return a->method == b->method && a->appearance == b->appearance &&
	       a->k == b->k;
}

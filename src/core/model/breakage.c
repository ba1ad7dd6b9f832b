/* The list of breakage models, and functions that work on any row.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "core/model/breakage.h"

#include <math.h>
#include <string.h>

#include "base/xalloc.h"

extern const struct breakage BREAKAGE_GRUNDITZ, BREAKAGE_GRUNDITZ_BYPASS,
    BREAKAGE_ENERGY, BREAKAGE_ENERGY_BYPASS, BREAKAGE_VOGEL,
    BREAKAGE_VOGEL_BYPASS, BREAKAGE_T10, BREAKAGE_T10_BYPASS;

const struct breakage *const BREAKAGES[] = {&BREAKAGE_GRUNDITZ,
    &BREAKAGE_ENERGY, &BREAKAGE_VOGEL, &BREAKAGE_GRUNDITZ_BYPASS,
    &BREAKAGE_ENERGY_BYPASS, &BREAKAGE_VOGEL_BYPASS, &BREAKAGE_T10,
    &BREAKAGE_T10_BYPASS, NULL};

size_t
breakage_count_models(void)
{
	return sizeof BREAKAGES / sizeof *BREAKAGES - 1;
}

const char *
breakage_model_names(void)
{
	static char *names;
	if (names == NULL) {
		names = xstrdup("");
		for (size_t i = 0; i < breakage_count_models(); i++)
			xappend_to_list(&names, " ", "%s", BREAKAGES[i]->name);
	}
	return names;
}

size_t
breakage_find_by_name(const char *name)
{
	size_t i = 0;
	while (BREAKAGES[i] != NULL && strcmp(BREAKAGES[i]->name, name) != 0)
		i++;
	return i;
}

bool
breakage_is_extension_of(size_t wide, size_t narrow)
{
	const struct breakage *of = BREAKAGES[narrow], *in = BREAKAGES[wide];
	size_t j = 0;
	while (j < of->n &&
	       breakage_parameter_index(in, of->parameter[j].name) < in->n)
		j++;
	return wide != narrow && j == of->n;
}

struct params
breakage_params_in_wider_model(const struct params *p, size_t wide)
{
	const struct breakage *of = breakage_model_of_params(p);
	struct params q = params_start_values(wide);
	for (size_t i = 0; i < of->n; i++)
		q.at[breakage_parameter_index(
		    BREAKAGES[wide], of->parameter[i].name)] = p->at[i];
	return q;
}

struct params
breakage_params_in_narrower_model(const struct params *p)
{
	const struct breakage *of = breakage_model_of_params(p);
	struct params best = *p;
	for (size_t i = 0; i < breakage_count_models(); i++) {
		if (!breakage_is_extension_of(p->breakage, i) ||
		    BREAKAGES[i]->n >= breakage_model_of_params(&best)->n)
			continue;
		struct params q = {.breakage = i};
		for (size_t j = 0; j < BREAKAGES[i]->n; j++)
			q.at[j] = params_value_by_name(
			    p, BREAKAGES[i]->parameter[j].name);
		struct params back =
		    breakage_params_in_wider_model(&q, p->breakage);
		if (of->reference < of->n)
			back.at[of->reference] = p->at[of->reference];
		if (memcmp(back.at, p->at, of->n * sizeof *back.at) == 0)
			best = q;
	}
	return best;
}

size_t
breakage_widest_containing_model(size_t breakage)
{
	size_t widest = breakage;
	for (size_t i = 0; i < breakage_count_models(); i++)
		if (breakage_is_extension_of(i, breakage) &&
		    BREAKAGES[i]->reference < BREAKAGES[i]->n &&
		    BREAKAGES[i]->n > BREAKAGES[widest]->n &&
		    BREAKAGES[i]->bypass == BREAKAGES[breakage]->bypass)
			widest = i;
	return widest;
}

const struct breakage *
breakage_model_of_params(const struct params *p)
{
	return BREAKAGES[p->breakage];
}

size_t
breakage_parameter_index(const struct breakage *model, const char *name)
{
	size_t j = 0;
	while (j < model->n && strcmp(model->parameter[j].name, name) != 0)
		j++;
	return j;
}

double
params_value_by_name(const struct params *p, const char *name)
{
	size_t j = breakage_parameter_index(breakage_model_of_params(p), name);
	return j < breakage_model_of_params(p)->n ? p->at[j] : NAN;
}

struct params
params_start_values(size_t breakage)
{
	struct params p = {.breakage = breakage};
	for (size_t j = 0; j < BREAKAGES[breakage]->n; j++)
		p.at[j] = BREAKAGES[breakage]->parameter[j].start;
	return p;
}

double
specific_energy_at_speed(double v)
{
	return v * v / 2;
}

size_t
params_index_of_largest_beta(const struct params *p)
{
	size_t largest = 0, gauge = breakage_model_of_params(p)->gauge;
	for (size_t j = 1; j < gauge; j++)
		if (fabs(p->at[j]) > fabs(p->at[largest]))
			largest = j;
	return gauge > 0 ? largest : PARAMS_MOST;
}

double
params_largest_beta(const struct params *p)
{
	size_t j = params_index_of_largest_beta(p);
	return j < PARAMS_MOST ? fabs(p->at[j]) : 0;
}

void
params_scale_largest_beta_to_1(struct params *p)
{
	double largest = params_largest_beta(p);
	for (size_t j = 0;
	     largest > 0 && j < breakage_model_of_params(p)->gauge; j++)
		p->at[j] /= largest;
}

struct bounds
bounds_default(size_t breakage)
{
	struct bounds b = {{0}, {0}};
	for (size_t j = 0; j < BREAKAGES[breakage]->n; j++) {
		b.lower[j] = BREAKAGES[breakage]->parameter[j].lower;
		b.upper[j] = BREAKAGES[breakage]->parameter[j].upper;
	}
	return b;
}

double
bounds_scale_of_param(
    const struct bounds *bounds, const struct params *p, size_t j)
{
	return j < breakage_model_of_params(p)->gauge
		   ? 2 * params_largest_beta(p)
		   : bounds->upper[j] - bounds->lower[j];
}

void
breaker_set_params(struct breaker *b, const struct params *p,
    const struct model_settings *settings)
{
	b->p = *p;
	b->model = breakage_model_of_params(p);
	b->k = settings->k;
	b->impacts = settings->impacts;
}

void
breaker_set_speed(struct breaker *b, double v)
{
	b->v = v;
	b->E = specific_energy_at_speed(v);
	b->model->prepare(b);
}

bool
breaker_has_progeny(const struct breaker *b)
{
	return b->model->gauge == 0 || b->appearance.total > 0;
}

struct model_settings
model_settings_default(void)
{
	return (struct model_settings){.method = METHOD_CONTINUOUS,
	    .appearance = APPEARANCE_RATIO,
	    .k = 1.0};
}

bool
model_settings_are_same(
    const struct model_settings *a, const struct model_settings *b)
{
	return a->method == b->method && a->appearance == b->appearance &&
	       a->k == b->k && a->bypass == b->bypass &&
	       memcmp(&a->impacts, &b->impacts, sizeof a->impacts) == 0;
}

/* A breakage model: which sizes break at a tip speed, and into what.
 *
 * Each model has a file of its own, which ends with its row, and a line each in
 * breakage.c and breakage_all.h.  All other code uses a model only through its
 * row.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_MODEL_BREAKAGE_H
#define TIPSPEED_CORE_MODEL_BREAKAGE_H

#include <stdbool.h>
#include <stdint.h>

#include "core/model/appearance.h"
#include "core/model/params.h"
#include "core/numeric/isa.h"

struct batch_plan;

/* Results of the kernel, by candidate: the misfit and, if difference is not
 * NULL, the weighted differences simulated - measured, cell i (see struct
 * plan_target) at difference[i * stride].  If softer is not NULL, a share of
 * the rock has the e0_min `softer`, at most the candidate's own (D16); both
 * arrays are indexed by candidate. */
struct kernel_out {
	double *misfit, *difference;
	size_t stride;
	const double *softer, *share;
};

/* A model's part of the search; see kernel_body.h.  theta: an array of
 * candidates' values for each parameter.  evaluate: computes the KERNEL_LANES
 * candidates at the indices; smooth: all of them are smooth.  sort: puts the
 * candidates first..first+KERNEL_LANES-1 into bins of ln x* at the mean energy,
 * adding KERNEL_BINS for smooth candidates, whose S rises so slowly that fewer
 * Gauss points suffice. */
enum { KERNEL_LANES = 8, KERNEL_BINS = 256 };
struct model_kernel {
	void (*evaluate)(const struct batch_plan *plan,
	    const double *const *theta, const uint32_t *index, bool smooth,
	    double *scratch, const struct kernel_out *out);
	void (*sort)(const struct batch_plan *plan, const double *const *theta,
	    size_t first, uint16_t *bin);
};

/* Parameters at a tip speed, prepared by breaker_set_speed.  appearance: in a
 * model with a gauge, the appearance for beta scaled to 1; own: other values
 * that the model computes once. */
struct breaker {
	struct params p;
	const struct breakage *model;
	double k, v, E; /* impacts; m/s; J/kg */
	struct impacts impacts;
	struct appearance appearance;
	double own[3];
};

struct continuous_solver;

struct breakage {
	const char *name;   /* as typed */
	const char *brief;  /* one line, without the bypass */
	const char *source; /* for users who know no models by name */
	size_t n;
	const struct param_info *parameter; /* [n] */
	/* The gauge: the number of leading parameters of which only the
	 * direction matters, as their scale is free: the beta of Eq 1, or none.
	 * gauge_name: the collective name of these. */
	size_t gauge;
	const char *gauge_name;
	/* The parameter that a calibration sets to the mean specific energy of
	 * the training runs, or PARAMS_MOST if there is none. */
	size_t reference;
	size_t strength; /* index of f_mat; e0_min and alpha follow it */
	bool bypass;     /* the last parameter is the bypass share (D14) */
	bool forms;      /* Eq 1 may be a function of sizes other than u (D3) */

	/* Computes appearance and own from p, k, v and E. */
	void (*prepare)(struct breaker *b);
	/* B, the share of the progeny of a particle of size x that is finer
	 * than y = u x, for ln u <= 0.  It is `finer`, a function of u at the
	 * speed, times `at_size`, a function of y in m (NULL: 1).  Both add
	 * their derivatives to d [n], if d is not NULL. */
	double (*finer)(const struct breaker *b, double log_u, double *d);
	double (*at_size)(const struct breaker *b, double log_y, double *d);
	/* Returns dB / d ln u, in any unit, for the shares of the size classes
	 * (Table 1).  u may be a size in mm if the model has forms. */
	double (*density)(
	    const struct breaker *b, double u, double log_u, double log_x);
	/* A faster way to continuous_solver_compute_product's result, or NULL.
	 */
	void (*product)(
	    struct continuous_solver *c, double *passing, double *d);
	/* Returns B as text with its numbers.  The caller frees it. */
	char *(*appearance_text)(const struct params *p);

	const struct model_kernel *kernel[ISA_BEST]; /* of the search */
};

/* All models, the paper's first, ending with NULL.  breakage_count_models
 * returns their number. */
extern const struct breakage *const BREAKAGES[];
size_t breakage_count_models(void);

/* Returns the models' names, separated by spaces.  Not thread-safe. */
const char *breakage_model_names(void);

/* Returns the index of the model with that name, or breakage_count_models(). */
size_t breakage_find_by_name(const char *name);

/* True if the wide model has all the parameters of the narrow one and its
 * others have no effect at their start values. */
bool breakage_is_extension_of(size_t wide, size_t narrow);

/* Returns the same parameters in a wider model, with its others at their start
 * values. */
struct params breakage_params_in_wider_model(
    const struct params *p, size_t wide);

/* The inverse of breakage_params_in_wider_model: returns the parameters in the
 * smallest model that gives the same product because all parameters that it
 * lacks are at their start values. */
struct params breakage_params_in_narrower_model(const struct params *p);

/* Returns the index of the widest model that has all parameters of the given
 * model, the same bypass, and an appearance that depends on the energy (D12,
 * D17); the given model's own index if there is none. */
size_t breakage_widest_containing_model(size_t breakage);

const struct breakage *breakage_model_of_params(const struct params *p);

/* Returns the index of the parameter with that name, or the model's n. */
size_t breakage_parameter_index(const struct breakage *model, const char *name);

/* Returns the value of the parameter with that name, or NAN if the model does
 * not have it. */
double params_value_by_name(const struct params *p, const char *name);

/* Returns every parameter at its start value. */
struct params params_start_values(size_t breakage);

/* Returns the specific energy, J/kg, of a particle thrown at tip speed v, m/s.
 *   E = v^2 / 2
 * Source: paper Eq 4. */
double specific_energy_at_speed(double v);

/* Returns the index of the parameter in the gauge with the largest absolute
 * value, the first of several, or PARAMS_MOST if there is no gauge. */
size_t params_index_of_largest_beta(const struct params *p);

/* Returns that largest absolute value, or 0 if there is no gauge. */
double params_largest_beta(const struct params *p);

/* Scales the gauge's parameters to a largest absolute value of 1 (D4), unless
 * all are 0. */
void params_scale_largest_beta_to_1(struct params *p);

struct bounds bounds_default(size_t breakage);

/* Returns the change of a parameter that counts as 1: the width of its bounds
 * or, in the gauge, twice the largest absolute value there. */
double bounds_scale_of_param(
    const struct bounds *bounds, const struct params *p, size_t j);

struct model_settings model_settings_default(void);

/* True if equal parameters give equal products with both settings. */
bool model_settings_are_same(
    const struct model_settings *a, const struct model_settings *b);

/* Prepare b: first for parameters, with k and the impacts of the settings, then
 * for a tip speed (m/s). */
void breaker_set_params(struct breaker *b, const struct params *p,
    const struct model_settings *settings);
void breaker_set_speed(struct breaker *b, double v);

/* False if particles that break have no progeny, so product = feed. */
bool breaker_has_progeny(const struct breaker *b);

/* The last row of a parameter table, for the models with a bypass.
 * D14: product = (1 - bypass) crushed + bypass feed. */
#define BYPASS_PARAMETER                                           \
	{                                                          \
		"bypass", "-", 0, 0.5, 0, 1, 0,                    \
		    "share of the feed that bypasses the rotor", 0 \
	}

/* A model's two rows: without a bypass (N parameters) and with one. */
#define BREAKAGE_ROWS(ID, NAME, BRIEF, N, ...)                              \
	extern const struct breakage BREAKAGE_##ID, BREAKAGE_##ID##_BYPASS; \
	const struct breakage BREAKAGE_##ID = {                             \
	    .name = NAME, .brief = BRIEF, .n = N, __VA_ARGS__};             \
	const struct breakage BREAKAGE_##ID##_BYPASS = {                    \
	    .name = NAME "+bypass",                                         \
	    .brief = BRIEF,                                                 \
	    .n = N + 1,                                                     \
	    .bypass = true,                                                 \
	    __VA_ARGS__};

/* A model's kernels, which breakage_all.h defines.  A program that only prints
 * the tables is compiled without kernels. */
#ifdef TABLES_ONLY
#define KERNELS(model) struct breakage
#define KERNEL_ROW(model) \
	{                 \
		NULL      \
	}
#else
#define KERNELS(model)                                        \
	extern const struct model_kernel model##_kernel_base, \
	    model##_kernel_avx2, model##_kernel_avx512
#define KERNEL_ROW(model)                                   \
	{                                                   \
		&model##_kernel_base, &model##_kernel_avx2, \
		    &model##_kernel_avx512                  \
	}
#endif

#endif

/* A breakage model: which sizes break at a tip speed, and into what.
 *
 * One file for each model, which ends in its row, and a line in breakage.c and
 * in breakage_all.h.  All other code uses a model through its row only.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_MODEL_BREAKAGE_H
#define TIPSPEED_CORE_MODEL_BREAKAGE_H

#include <stdalign.h>
#include <stdbool.h>
#include <stdint.h>

#include "core/numeric/isa.h"
#include "core/model/params.h"

struct plan;

/* Results of the kernel, by candidate: the misfit, and, where difference is not
 * NULL, the weighted differences simulated - measured, with cell i (see struct
 * plan_target) at difference[i * stride].  Where softer is not NULL, a share of
 * the rock has that e0_min instead of the candidate's, which is at least as
 * large (D16); share 0: all has the candidate's. */
struct kernel_out {
	double *misfit, *difference;
	size_t stride;
	const double *softer, *share;
};

/* A model's part of the search, see kernel_body.h.  Evaluates the KERNEL_LANES
 * candidates at the indices; theta: one array for each parameter of the model.
 * smooth: all of them are smooth, see KERNEL_BINS. */
typedef void kernel_block(const struct plan *plan, const double *const *theta,
    const uint32_t *index, bool smooth, double *scratch,
    const struct kernel_out *out);

/* Sorts the candidates first..first+KERNEL_LANES-1: a bin of ln x* at the mean
 * energy for each, plus KERNEL_BINS for the smooth ones, whose S rises so
 * slowly that fewer Gauss points suffice. */
enum { KERNEL_LANES = 8, KERNEL_BINS = 256 };
typedef void kernel_bin_candidates(const struct plan *plan,
    const double *const *theta, size_t first, uint16_t *bin);

/* Parameters at a tip speed, prepared by breaker_set_speed.  own: values that a
 * model computes once for them. */
struct breaker {
	struct params p;
	const struct breakage *model;
	double k, v, E; /* impacts; m/s; J/kg */
	struct impacts impacts;
	alignas(max_align_t) unsigned char own[640];
};

struct continuous;

struct breakage {
	const char *name;  /* as typed */
	const char *brief; /* one line for help */
	size_t n;
	const struct param_info *parameter; /* [n] */
	/* The gauge: the number of first parameters of which only the direction
	 * matters; their scale is free.  gauge_name: their name together. */
	size_t gauge;
	const char *gauge_name;
	/* The parameter that a calibration sets to the mean specific energy of
	 * the training runs; PARAMS_MOST: none. */
	size_t reference;
	size_t strength; /* index of f_mat, which e0_min and alpha follow */
	bool bypass;     /* the last parameter is the bypass share (D14) */
	bool forms;      /* Eq 1 may be a function of other sizes than u (D3) */

	/* Computes own; p, k, v and E are set. */
	void (*prepare)(struct breaker *b);
	/* Selection S at ln x, x in m; d [n]: adds its derivatives, or NULL. */
	double (*selection)(const struct breaker *b, double log_x, double *d);
	/* ln x at which -ln(1 - S) has the value `exponent`; it rises with the
	 * exponent, and integrals of S end panels there.  For 0: the break
	 * size. */
	double (*size_at)(const struct breaker *b, double exponent);
	/* The smallest size that can break, m: 0 where every size does,
	 * INFINITY where none does. */
	double (*break_size)(const struct params *p, double E);
	/* B, the share finer than y = u x of what breaks at x, for ln u <= 0:
	 * a function of u at the speed times one of y (NULL: 1), y in m; d as
	 * of selection. */
	double (*finer)(const struct breaker *b, double log_u, double *d);
	double (*at_size)(const struct breaker *b, double log_y, double *d);
	/* dB / d ln u, in any unit: shares of the size classes (Table 1).  u
	 * may be a size in mm where the model has forms. */
	double (*density)(
	    const struct breaker *b, double u, double log_u, double log_x);
	/* False where what breaks has no progeny: product = feed. */
	bool (*breaks)(const struct breaker *b);
	/* A short-cut for the product, see continuous_product; or NULL. */
	void (*product)(struct continuous *c, double *passing, double *d);
	/* S and B as text with the numbers in them; the caller frees. */
	char *(*selection_text)(const struct params *p, double k);
	char *(*appearance_text)(const struct params *p);

	struct {
		kernel_block *block;
		kernel_bin_candidates *bins;
	} kernel[ISA_BEST]; /* of the search */
};

/* All models, the paper's first; NULL ends them.  breakage_count: how many. */
extern const struct breakage *const BREAKAGES[];
size_t breakage_count(void);

/* Returns the models' names, separated by spaces; for one thread. */
const char *breakage_names(void);

/* Returns the index of the model of that name, or breakage_count(). */
size_t breakage_find(const char *name);

/* True if a model has all the parameters of another, and its further parameters
 * have no effect at their start. */
bool breakage_extends(size_t wide, size_t narrow);

/* Returns the parameters in a model that extends theirs, the others at their
 * start. */
struct params breakage_widened(const struct params *p, size_t wide);

/* The inverse of breakage_widened: returns the parameters in the smallest model
 * that gives the same product, as all parameters that it lacks are at their
 * start. */
struct params breakage_narrowed(const struct params *p);

/* Returns the index of the widest model that has all parameters of the given
 * model and lets the appearance follow the energy (D12, D17); the given model
 * where there is none. */
size_t breakage_wider(size_t breakage);

/* Returns the model of the parameters. */
const struct breakage *breakage_of(const struct params *p);

/* Returns the index of the parameter of that name, or the model's n. */
size_t breakage_parameter(const struct breakage *model, const char *name);

/* Returns the value of a parameter by its name; NAN where the model does not
 * have it. */
double params_value(const struct params *p, const char *name);

/* Returns every parameter at its start. */
struct params params_start(size_t breakage);

/* Specific energy of a particle thrown at tip speed v.
 *   E = v^2 / 2
 * v rotor tip speed, m/s.  Returns J/kg.   Source: paper Eq 4. */
double energy_specific(double v);

/* Break size x*: the smallest size that can break at tip speed v, in the
 * parameters' model.
 * v m/s.  Returns m: 0 where every size breaks, INFINITY where none does. */
double params_break_size(const struct params *p, double v);

/* As params_break_size, but with the impacts of the settings: the break size of
 * the strongest impact. */
double params_break_size_by(
    const struct params *p, const struct model_settings *settings, double v);

/* Returns the largest absolute value of the parameters in the gauge; 0 without
 * a gauge. */
double params_largest_gauge(const struct params *p);

/* Scales the gauge's parameters to a largest absolute value of 1 (departure
 * D4); where all are 0 they stay 0. */
void params_scale_to_1(struct params *p);

struct bounds bounds_default(size_t breakage);

struct model_settings model_settings_default(void);

/* True if the same parameters give the same products with both settings. */
bool model_settings_same(
    const struct model_settings *a, const struct model_settings *b);

/* Prepare b for parameters, with the k and the impacts of the settings, and for
 * a tip speed (m/s). */
void breaker_set_params(struct breaker *b, const struct params *p,
    const struct model_settings *settings);
void breaker_set_speed(struct breaker *b, double v);

/* The last row of a parameter table, for the models with a bypass.
 * D14: product = (1 - bypass) crushed + bypass feed. */
#define BYPASS_PARAMETER                                           \
	{                                                          \
		"bypass", "-", 0, 0.5, 0, 1, 0,                    \
		    "share of the feed that bypasses the rotor", 0 \
	}

/* A model's two rows: without a bypass, with n parameters, and with a
 * bypass. */
#define BREAKAGE_ROWS(ID, NAME, BRIEF, N, ...)                                 \
	extern const struct breakage BREAKAGE_##ID, BREAKAGE_##ID##_BYPASS;    \
	const struct breakage BREAKAGE_##ID = {                                \
	    .name = NAME, .brief = BRIEF, .n = N, __VA_ARGS__};                \
	const struct breakage BREAKAGE_##ID##_BYPASS = {                       \
	    .name = NAME "+bypass",                                            \
	    .brief = NAME " with a share of the feed that bypasses the rotor", \
	    .n = N + 1,                                                        \
	    .bypass = true,                                                    \
	    __VA_ARGS__};

/* The kernel's functions of a model, which breakage_all.h defines; a program
 * that only prints the tables has none. */
#ifdef TABLES_ONLY
#define KERNELS(model) struct breakage
#define KERNEL_ROW(model) \
	{                 \
		{         \
			0 \
		}         \
	}
#else
#define KERNELS(model)                                              \
	kernel_block model##_block_base, model##_block_avx2,        \
	    model##_block_avx512;                                   \
	kernel_bin_candidates model##_bins_base, model##_bins_avx2, \
	    model##_bins_avx512
#define KERNEL_ROW(model)                                         \
	{                                                         \
		{model##_block_base, model##_bins_base},          \
		    {model##_block_avx2, model##_bins_avx2},      \
		{                                                 \
			model##_block_avx512, model##_bins_avx512 \
		}                                                 \
	}

#endif

#endif

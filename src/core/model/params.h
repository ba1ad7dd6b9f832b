/* The parameters of a breakage model and the settings that go with them.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_MODEL_PARAMS_H
#define TIPSPEED_CORE_MODEL_PARAMS_H

#include <stddef.h>

enum { PARAMS_MOST = 11 };

/* Parameters and the breakage model that they belong to: at[j] is the parameter
 * in row j of the model's table.  A plain value; zeros select the paper's
 * model.  Only files of the paper's family of models use the names. */
struct params {
	size_t breakage; /* index into BREAKAGES */
	union {
		struct {
			double beta[4]; /* appearance coefficients, -, only
					 * their direction matters (D4) */
			double f_mat;   /* material parameter, kg/(J m) */
			double e0_min;  /* threshold energy, J m/kg */
			double alpha;   /* size dependency, - */
		};
		double at[PARAMS_MOST];
	};
};

/* Larger values are rejected, whether typed, read or used as a bound: no rock
 * has them, so they are typing errors. */
enum { F_MAT_MOST = 10000, E0_MIN_MOST = 10000, ALPHA_MOST = 100 };

struct param_info {
	const char *name;    /* as typed */
	const char *unit;    /* "-" if none */
	double lower, upper; /* default search bounds */
	double least, most;  /* of any accepted value */
	double start;        /* value if a site has none; NAN: it must be
			      * given */
	const char *meaning;
	double spread; /* sd of a normal prior about start; 0: uniform */
};

/* Search bounds, one pair for each parameter.  A parameter with lower == upper
 * is fixed. */
struct bounds {
	double lower[PARAMS_MOST], upper[PARAMS_MOST];
};

enum method { METHOD_CONTINUOUS, METHOD_CLASSES };
enum appearance_form {
	APPEARANCE_RATIO,      /* progeny over parent: the default (D3) */
	APPEARANCE_PROGENY_MM, /* progeny size in mm */
	APPEARANCE_PARENT_MM   /* parent size in mm: literal, degenerate */
};

/* Impacts of a particle, instead of one at v^2/2 (see
 * spectrum_group_impacts_by_energy): `number` impacts, each with energy
 * ratio[j] v^2/2 with probability share[j]. n 0: the paper's single impact. */
enum { IMPACTS_MOST = 12 };
struct impacts {
	size_t n;
	double number, share[IMPACTS_MOST], ratio[IMPACTS_MOST];
};

/* How products are computed.  breakage: the model of later calibrations; a
 * product uses the model of its parameters.  k: number of impacts, 1 in the
 * paper; it acts only through its product with f_mat and is never fitted.
 * bypass: share of the feed that bypasses the rotor in addition to the
 * parameters' bypass (D14); always 0 except in a question about another
 * machine. */
struct model_settings {
	enum method method;
	enum appearance_form appearance;
	double k, bypass;
	unsigned breakage;
	struct impacts impacts;
};

#endif

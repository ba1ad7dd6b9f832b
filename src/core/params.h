/* The seven parameters of the model and the settings that go with them.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_PARAMS_H
#define TIPSPEED_CORE_PARAMS_H

#include <stdbool.h>
#include <stddef.h>

enum { PARAM_COUNT = 7, PARAM_BETA = 0, PARAM_F_MAT = 4 };
enum { PARAM_E0_MIN = 5, PARAM_ALPHA = 6 };

/* The parameters by their symbols, or in the order of the table below; a plain
 * value. */
struct params {
	union {
		struct {
			double beta[4]; /* appearance coefficients, -, only
					 * their direction matters (D4) */
			double f_mat;   /* material parameter, kg/(J m) */
			double e0_min;  /* threshold energy, J m/kg */
			double alpha;   /* size dependency, - */
		};
		double at[PARAM_COUNT];
	};
};

/* Beyond these no value is taken, typed, read or as a bound: far outside what
 * any rock has, so that what lies there is a slip of the pen.  Of beta either
 * way, of the others from 0.  Constants, because rows of other tables have
 * them too. */
enum {
	BETA_MOST = 1000000000,
	F_MAT_MOST = 10000,
	E0_MIN_MOST = 10000,
	ALPHA_MOST = 100
};

/* What there is to say of one parameter.  lower, upper: Table 2 of the paper,
 * whose text says six variables where there are seven (departure D7). */
struct param_info {
	const char *name;    /* as typed */
	const char *unit;    /* "-" where there is none */
	double lower, upper; /* default search bounds */
	double least, most;  /* of any value */
	const char *meaning;
};

extern const struct param_info PARAMS[PARAM_COUNT];

/* Index of the parameter of that name, or PARAM_COUNT. */
size_t params_find(const char *name);

/* beta of Broadbent and Callcott's breakage function, where a site has none of
 * its own; the rest 0. */
struct params params_default_beta(void);

/* beta scaled to a largest absolute value of 1 (departure D4); all-zero beta
 * stays as it is. */
void params_scale_beta(struct params *p);

/* Search bounds: one pair for each parameter. lower == upper holds it fixed. */
struct bounds {
	double lower[PARAM_COUNT], upper[PARAM_COUNT];
};

struct bounds bounds_default(void);

enum method { METHOD_CONTINUOUS, METHOD_CLASSES };
enum appearance_form {
	APPEARANCE_RATIO,      /* daughter over parent: the default (D3) */
	APPEARANCE_PROGENY_MM, /* daughter size in mm */
	APPEARANCE_PARENT_MM   /* parent size in mm: literal, degenerate */
};

/* How products are computed.  k: number of impacts, 1 in the paper; it acts
 * only as a product with f_mat and is never fitted. */
struct model_settings {
	enum method method;
	enum appearance_form appearance;
	double k;
};

struct model_settings model_settings_default(void);
bool model_settings_same(
    const struct model_settings *a, const struct model_settings *b);

#endif

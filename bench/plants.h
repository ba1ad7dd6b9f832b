/* Plants made by laws of their own, of which many are not the model's, to
 * count on.  The laws share no code with the program's models.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_BENCH_PLANTS_H
#define TIPSPEED_BENCH_PLANTS_H

#include <stddef.h>
#include <stdint.h>

#include "core/psd/site.h"

enum { PLANT_TABLE = 600, PLANT_SIEVES = 16, PLANT_RUNS = 256 };

enum law {
	RIGHT,
	FINER,
	STRONG,
	SHARED,
	BYPASS,
	DRIFT,
	T10,
	MIXED,
	FEW,
	FIVE,
	TWO,
	INDIVIDUAL,
	SCATTER,
	NO_LAW,
	LAWS, /* and those on which no prior was chosen: */
	WEIBULL = LAWS,
	LOGISTIC,
	PARENT,
	ATTRITION,
	TWO_MODES,
	SLOWER,
	BENT,
	BENT_MORE,
	ALL_LAWS
};

extern const char *const LAW_NAME[ALL_LAWS];

struct plant {
	enum law law;
	double top, feed_n;    /* m */
	double B[PLANT_TABLE]; /* over ln u, of the cubic */
	double f_mat, e0, alpha, gamma, e_ref, bypass, share, hard;
	double x63, finer, spread; /* of a curve of no law, see plants.c */
	double other;       /* what a law from WEIBULL on has of its own */
	double own, shared; /* errors, passing */
	double feed_own;    /* of the feed as the sheet has it */
	size_t n_sieve, n_run;
	double sieve[PLANT_SIEVES], speed[PLANT_RUNS]; /* m, m/s */
	double run_n[PLANT_RUNS]; /* feed_n of what met the rotor in a run */
};

/* The plant of that number: a law and a number always make the same one. */
struct plant plant_of(enum law law, uint64_t number);

/* Measures it at so many speeds, evenly from 66 to 84 m/s. */
void plant_measure(struct plant *p, size_t n_run);

/* Its sheet, with the errors of that number. */
struct site *plant_site(const struct plant *p, uint64_t number);

/* The same where the rotor had not the speeds that the sheet states, p's, but
 * (1 + sd plant_speed_error) of each. */
struct site *plant_site_with_speed_errors(
    const struct plant *p, uint64_t number, double sd);

/* Standard normal: of run k, or from PLANT_RUNS on of a speed asked about. */
double plant_speed_error(uint64_t number, size_t k);

/* The feed with exponent n, and the true product of it at tip speed v, at a
 * size s, m. */
double plant_feed(const struct plant *p, double x, double n);
double plant_product(const struct plant *p, double n, double v, double s);

/* The true product of the feed that answers are asked with.  Where each run has
 * its own: of equal parts of them, as asked [n_sieve] has their mean at the
 * plant's sieves, errors of its sampling included. */
double plant_truth(
    const struct plant *p, const double *asked, double v, double s);

#endif

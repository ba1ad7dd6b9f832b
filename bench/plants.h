/* Synthetic plants to count on.  They follow various laws, many of which are
 * not the model's.  The laws share no code with the program's models.
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
	LAWS, /* no prior was chosen with those that follow: */
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
	double B[PLANT_TABLE]; /* B at even steps of ln u, for the cubic */
	double f_mat, e0, alpha, gamma, e_ref, bypass, share, hard;
	double x63, finer, spread; /* for NO_LAW; see plants.c */
	double other;              /* the parameter of a law from WEIBULL on */
	double own, shared; /* standard deviations of errors, passing 0..1 */
	double feed_own;    /* the same for the feed in the sheet */
	size_t n_sieve, n_run;
	double sieve[PLANT_SIEVES], speed[PLANT_RUNS]; /* m, m/s */
	double run_n[PLANT_RUNS]; /* feed_n of the material that was crushed in
				   * a run */
};

/* Returns the plant with that number.  The same law and number always give the
 * same plant. */
struct plant plant_of(enum law law, uint64_t number);

/* Sets the plant's runs to n_run speeds, evenly from 66 to 84 m/s. */
void plant_measure(struct plant *p, size_t n_run);

/* Returns the plant's sheet, with the errors of that number. */
struct site *plant_site(const struct plant *p, uint64_t number);

/* As plant_site, but the rotor's true speeds are (1 + sd plant_speed_error)
 * times those that the sheet states. */
struct site *plant_site_with_speed_errors(
    const struct plant *p, uint64_t number, double sd);

/* Returns a standard normal number: the speed error of run k or, for k from
 * PLANT_RUNS on, of a speed asked about. */
double plant_speed_error(uint64_t number, size_t k);

/* Return the passing at size x or s, m, of the feed with exponent n, and of its
 * true product at tip speed v. */
double plant_feed(const struct plant *p, double x, double n);
double plant_product(const struct plant *p, double n, double v, double s);

/* Returns the passing at size s of the true product of the feed that answers
 * are for.  If each run has its own feed, that is a blend of equal parts; asked
 * [n_sieve] is their mean at the plant's sieves, including sampling errors. */
double plant_truth(
    const struct plant *p, const double *asked, double v, double s);

#endif

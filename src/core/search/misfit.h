/* Misfit (Eq 5): the distance of simulated products from measured ones.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_SEARCH_MISFIT_H
#define TIPSPEED_CORE_SEARCH_MISFIT_H

#include <stdbool.h>
#include <stddef.h>

#include "core/model/breakage.h"
#include "core/model/params.h"
#include "core/model/product.h"
#include "core/psd/site.h"

/* One training run, with those sieves of the product that the feed covers and
 * that are not idle.  weight [n]: factor of a difference before it is
 * squared. */
struct misfit_run {
	size_t run; /* index into the site's runs */
	double speed;
	struct psd feed; /* borrowed from the site */
	size_t n;
	double *sieve;    /* m, coarsest first */
	double *measured; /* passing, 0..1 */
	double *weight;
};

/* The objective of a calibration:
 *   E = sum over training runs and product sieves of
 *       (weight (measured - simulated passing))^2
 * D6: with the minus printed between the two squares, the misfit would have no
 * lower bound. */
struct misfit {
	const struct breakage *of; /* the model that all parameters passed in
				    * must have */
	struct model_settings settings;
	size_t n_run, n_residual;
	struct misfit_run *run;
	struct model **model; /* [n_run] */
	double *passing, *d_passing;
	bool (*stop)(void); /* or NULL; see misfit_should_stop */
};

/* train [n_run]: true for the training runs, or NULL for all; runs without a
 * product are ignored.  run_weight [n_run]: weight of each run's squares, >= 0,
 * or NULL: all 1.  by_sd: divide each difference by the sheet's standard
 * deviation, if it states one.  The site must outlive the misfit. */
struct misfit *misfit_new(const struct site *site, const bool *train,
    const double *run_weight, bool by_sd, struct model_settings settings);
void misfit_free(struct misfit *m);

/* Keeps at most `most` sieves of each run, evenly spread and including the
 * coarsest and the finest; most >= 2. */
void misfit_limit_sieves_per_run(struct misfit *m, size_t most);

/* Returns the number of passings, of the n_residual, that crushing can change.
 * If all of the feed passes a sieve, so does all of the product, for any
 * parameters. */
size_t misfit_count_changeable_passings(const struct misfit *m);

/* True if computations with this misfit should end because the user is waiting.
 * They then discard unfinished work, which may be repeated later.
 * Thread-safe. */
bool misfit_should_stop(const struct misfit *m);

/* Returns the misfit at p, or INFINITY if it is NaN.  Source: paper
 * Eq 5. */
double misfit_of_params(struct misfit *m, const struct params *p);

/* As misfit_of_params.  Also computes r [n_residual], the weighted differences
 * simulated - measured, if r is not NULL. */
double misfit_weighted_differences(
    struct misfit *m, const struct params *p, double *r);

/* Does what misfit_weighted_differences does, and computes the derivatives of r
 * by rows: J [n_residual * the model's number of parameters]. */
double misfit_jacobian(
    struct misfit *m, const struct params *p, double *r, double *J);

/* Returns the root mean square of the unweighted differences at p, 0..1. */
double misfit_rmse(struct misfit *m, const struct params *p);

/* Returns the number of sieves of the run's product that its feed covers.  They
 * are the coarsest, as only the finest sieves can be uncovered. */
size_t misfit_count_covered_sieves(const struct run *run);

/* Returns how many of these are coarser than `top`, the
 * site_finest_sieve_all_pass: idle sieves, which tell nothing.  At least one
 * is left. */
size_t misfit_count_uninformative_sieves(const struct run *run, double top);

/* Marks the default training set: all repeats at the slowest and the fastest
 * speed with a product.  Returns the number of runs marked. */
size_t misfit_mark_default_training(const struct site *site, bool *train);

/* Returns the misfit of the null model product = feed. */
double misfit_of_feed_as_product(const struct misfit *m);

#endif

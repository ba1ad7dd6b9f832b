/* The method `continuous`; used through product.h.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_MODEL_CONTINUOUS_H
#define TIPSPEED_CORE_MODEL_CONTINUOUS_H

#include "core/model/breakage.h"
#include "core/model/selection.h"
#include "core/psd/psd.h"

/* Panels end at STOPS values of the exponent in Eq 3.  With a spectrum of
 * impacts, they also end at each node's break size and at the same values for
 * the weakest node. */
enum { STOPS = 5, STOPS_MOST = 2 * STOPS + IMPACTS_MOST, GAUSS = 8 };

/* A point of the integrals over the feed: t = ln x, the mass dF, and S there
 * with its derivatives. */
struct point {
	double t, mass, shape[SHAPES];
};

/* Rows of the table of B are a multiple of AT_ONCE long. */
enum { AT_ONCE = 4, ROW_MOST = PARAMS_MOST + AT_ONCE };

struct moments;

/* Classes lie between neighbouring edges; density is dF / d ln x.  stop (the
 * ends of panels) and point (coarsest class first) are for the parameters and
 * speed of the last call.  b and feed_passing are borrowed. */
struct continuous_solver {
	const struct breaker *b;
	const double *feed_passing;
	size_t n_sieve, n_edge;
	double *log_sieve, *edge, *density;
	size_t n_stop;
	double stop[STOPS_MOST]; /* ln x, rising */
	size_t n_point;
	struct point *point;
	struct moments *above; /* [n_edge], for the paper's model, else NULL */
	/* B at nodes in equal steps of ln u down from 0, with its derivatives
	 * with respect to the n_moved parameters on which it depends; rows of
	 * `row`, 1 + n_moved or a little more. */
	size_t n_node, n_moved, moved[PARAMS_MOST], row;
	double *node;
};

/* See model_new.  feed_passing [n]: the feed's passing at each sieve.  b is
 * borrowed; both functions below use the parameters and speed that it has when
 * they are called. */
struct continuous_solver *continuous_solver_new(const struct breaker *b,
    const struct psd *feed, const double *sieve, const double *feed_passing,
    size_t n);
void continuous_solver_free(struct continuous_solver *c);

/* See model_jacobian (d_passing may be NULL) and model_broken_feed_share,
 * without the bypass. */
void continuous_solver_compute_product(
    struct continuous_solver *c, double *passing, double *d_passing);
double continuous_solver_broken_feed_share(struct continuous_solver *c);

/* Points of a Gauss-Legendre panel over ln x. */
struct panel {
	double t[GAUSS], weight[GAUSS];
};

/* Calls add(c, panel, data) for each panel of ln x from a to b, or from where S
 * begins if that is above a.  The interval lies within one class, which has the
 * given density. */
static inline void
continuous_solver_visit_panels(const struct continuous_solver *c, double a,
    double b, double density,
    void add(const struct continuous_solver *c, const struct panel *panel,
	void *data),
    void *data)
{
	static const double X[GAUSS / 2] = {0.1834346424956498,
	    0.5255324099163290, 0.7966664774136267, 0.9602898564975363};
	static const double W[GAUSS / 2] = {0.3626837833783620,
	    0.3137066458778873, 0.2223810344533745, 0.1012285362903763};
	if (density <= 0)
		return;
	if (a < c->stop[0])
		a = c->stop[0];
	for (size_t i = 1; i <= c->n_stop && a < b; i++) {
		bool more = i < c->n_stop;
		if (more && c->stop[i] <= a)
			continue;
		double end = more && c->stop[i] < b ? c->stop[i] : b;
		double middle = (a + end) / 2, half = (end - a) / 2;
		struct panel panel;
		for (size_t q = 0; q < GAUSS / 2; q++) {
			panel.t[2 * q] = middle - half * X[q];
			panel.t[2 * q + 1] = middle + half * X[q];
			panel.weight[2 * q] = panel.weight[2 * q + 1] =
			    density * half * W[q];
		}
		add(c, &panel, data);
		a = end;
	}
}

#endif

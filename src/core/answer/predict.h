/* Prediction: the product of a site at any tip speed.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_ANSWER_PREDICT_H
#define TIPSPEED_CORE_ANSWER_PREDICT_H

#include <stdbool.h>
#include <stddef.h>

#include "core/answer/forecast.h"
#include "core/model/params.h"
#include "core/psd/screening.h"
#include "core/psd/site.h"

/* product, feed: on the same sieves, which are those of the site's feeds and
 * products, or site->shown, that the feed covers.  curve: the product at
 * predict_list_table_sieves, off which sizes are read linearly in log size
 * (D20). model [product.n]: the product of the model alone.  low, high
 * [product.n], range: the band; NULL and NAN if there is none.  Sizes are in m;
 * NAN if outside the sieves. */
struct prediction {
	double speed;    /* m/s */
	double energy;   /* J/kg */
	size_t feed_run; /* the run whose feed was used */
	struct psd feed, product, curve;
	double *model, *low, *high;
	double range[PSD_SIZES + 1][2]; /* of `size` */
	union {
		struct {
			double p20, p50, p80;
			double break_size; /* x*; INFINITY: nothing breaks; 0:
					    * all sizes do */
		};
		double size[PSD_SIZES + 1];
	};
	/* The fraction and its share of the product; for the whole product,
	 * zeros and 1. */
	struct fraction fraction;
	double share, share_range[2];
	double selected;   /* mass fraction of the feed that is selected */
	bool no_daughters; /* p(u) is 0 everywhere: product = feed */
};

void prediction_free(struct prediction *prediction);

/* Returns the sieves of the site and of site->shown that the feed covers,
 * coarsest first, with passings of 0.  Free with psd_free. */
struct psd predict_list_table_sieves(
    const struct site *site, const struct psd *feed);

/* Returns the *n quantities, of the whole product or of a fraction, that
 * predict_at_table_sieves reads.  The caller frees the array. */
struct quantity *predict_table_quantities(const struct site *site,
    const struct psd *feed, const struct fraction *fraction, size_t *n);

/* Returns the table of a forecast of predict_table_quantities at its speed,
 * with the band if it has draws.  feed_run: the run whose feed is used, or
 * SITE_MEAN_FEED; see site_feed_of_run.  Free with prediction_free. */
struct prediction predict_at_table_sieves(const struct site *site,
    size_t feed_run, const struct fraction *fraction, struct forecast *f);

/* As predict_at_table_sieves, but for the model alone and the whole product.
 * Cannot fail. */
struct prediction predict_with_model_alone(const struct site *site,
    const struct params *p, struct model_settings settings, double speed,
    size_t feed_run);

/* Removes the band and keeps the answer. */
void prediction_remove_band(struct prediction *p);

/* Computes S [feed->n], 0..1, the selection of each size class of a feed: the
 * share of its mass that breaks.  Class i lies between sieves i and i + 1; the
 * last is the pan.  Weighted by the classes' masses, S sums to `selected`.
 * Method continuous: the mean of Eq 3 over the class, uniform in log size, and
 * 0 in the pan, which never breaks; classes: Eq 3 at the size of the class. */
void predict_broken_share_of_classes(const struct psd *feed,
    const struct params *p, struct model_settings settings, double speed,
    double *S);

/* True if the speed is outside the speeds of the runs marked in train. */
bool predict_is_extrapolation(
    const struct site *site, const bool *train, double speed);

#endif

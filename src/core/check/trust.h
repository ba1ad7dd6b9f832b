/* The trust in an answer: one light, with its reasons.
 *
 * A residual has two possible causes that its size and pattern cannot tell
 * apart: the model is wrong for this plant, or the samples are biased.  So
 * reasons state the observation and its consequence, not the cause.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_CHECK_TRUST_H
#define TIPSPEED_CORE_CHECK_TRUST_H

#include "core/search/calibrate.h"
#include "core/posterior/ensemble.h"
#include "core/posterior/posterior.h"
#include "core/check/validate.h"

enum light { LIGHT_GREEN, LIGHT_AMBER, LIGHT_RED };
extern const char *const LIGHT_NAME[3];

/* The largest difference between the two halves of the draws
 * (ensemble_difference_of_halves), in widths of the band, at which they count
 * as converged. */
#define DRAWS_SETTLED 0.25

/* A fit with a larger RMSE (passing, 0..1) on the training runs is called poor:
 * careful repeat samples agree within 0.005 or 0.01. */
#define FIT_POOR 0.02

/* Two samples from one belt agree within this, passing 0..1. */
#define SAMPLES_AGREE 0.01

/* If the fit lowers the null model's misfit by less than this share, the
 * products cannot be distinguished from the feed. */
#define FIT_LEAST_GAIN 0.5

/* True if there can be no band, because the fit is poor and has at most two
 * speeds.  Two points do not show how the discrepancy bends between them. */
bool trust_is_band_impossible(double rmse, size_t speeds);

/* How far two products contradict the rule that a faster rotor breaks more
 * (D23): the excess of the slower run's passing over the faster run's, 0..1.
 * most: the largest, at the sieve `at` of the faster run, m; mean: over its
 * sieves.  At a sieve that the slower run lacks, its next finer one counts. */
struct passing_order {
	double most, at, mean;
};
struct passing_order trust_compare_slow_fast_products(
    const struct psd *slow, const struct psd *fast);

/* A largest difference above ORDER_NOTABLE deserves a remark, but sampling may
 * explain it.  trust_is_product_order_wrong returns true if the difference, at
 * one sieve or on average, is more than sampling explains.  Of 180 sheets with
 * 1 point of noise, 29 exceed ORDER_NOTABLE somewhere, and 3 are called wrong.
 */
#define ORDER_NOTABLE 0.02
bool trust_is_product_order_wrong(const struct passing_order *o);

/* True if there are products and no sieve of any product passes more than its
 * feed does by over SAMPLES_AGREE. */
bool trust_are_products_like_feed(const struct site *site);

/* Returns the product cell (worst_sieve) furthest from the fit, if further than
 * a careful sample would be; otherwise worst_difference is 0. */
struct validation trust_find_outlier_cell(
    const struct site *site, const bool *train, const struct fit *fit);

/* The evidence on the fit itself.  It does not depend on the question and is
 * gathered once for each fit. */
struct evidence {
	size_t cells, parameters; /* of the fit */
	double rmse;              /* of the fit, passing 0..1 */
	/* The products are not measurably finer than the feed. */
	bool like_feed;
	/* The residuals at all runs used, without the part that a step of the
	 * parameters explains.  unexplained: their RMS, passing 0..1; size:
	 * their mean square over that of usual sampling errors; alike: the
	 * correlation of neighbours on a curve, in standard deviations. */
	double unexplained, size, alike;
	/* NAN without a posterior.  discrepancy, sampling: medians of the
	 * draws, passing 0..1; more: share of the draws in which the
	 * discrepancy exceeds the sampling error. */
	double discrepancy, sampling, more;
	/* Mean and standard deviation of gamma + kappa (D12, D17), which both
	 * shift the u of B(u) = 1/2 with the energy.  NAN in a model without
	 * these. */
	double finer, finer_sd;
	double unbounded; /* share of the draws with no threshold */
	double halves;    /* ensemble_difference_of_halves, the largest at three
			   * speeds */
	double breaks;    /* share of the feed coarser than the break size that
			   * breaks, at the slowest speed */
	bool all_break;   /* at that speed even particles as fine as the finest
			   * sieve break */
	size_t speeds;    /* number that inform the fit */
	double slowest, fastest;   /* of these speeds */
	struct validation holdout; /* the worst held-out run; n_sieve 0: there
				    * is none */
	struct validation outlier; /* trust_find_outlier_cell */
	/* The two runs that, adjusted to one feed, most contradict that a
	 * faster rotor breaks more: their speeds, m/s.  order.most 0: no runs
	 * do. */
	struct {
		double slow, fast;
		struct passing_order order;
	} against;
};

/* use: the runs that inform the answer.  noise: known error of a single
 * passing, 0..1; 0: the usual error. */
struct evidence trust_gather_evidence(const struct site *site,
    const bool *train, const bool *use, const struct fit *fit,
    const struct bounds *bounds, const struct posterior *posterior,
    double noise);

/* What the answer is about.  All members but speed may be 0 or NAN. */
struct trust_question {
	double speed; /* m/s; 0: the question is about the fit */
	double rotor; /* diameter, m, in runs and question; 0 if it is unknown
		       * or differs, so that reasons do not state speeds in
		       * rpm */
	/* True if the measured runs correct the answer; false if it is the
	 * model's alone. */
	bool corrected;
	double width; /* of the band, mean over the sieves, passing 0..1 */
	/* For a feed not sampled here: the largest difference from the nearest
	 * feed of the fit, passing 0..1. */
	double feed;
	/* A parameter on a bound, and the change of the answer if the parameter
	 * moved past the bound by its standard deviation. */
	const char *bound;
	double bound_moves; /* passing 0..1 */
};

/* The subject of a reason, from which callers tell which other reasons need
 * stating. */
enum trust_cause {
	TRUST_FIT,
	TRUST_DATA,
	TRUST_PATTERN,
	TRUST_HOLDOUT,
	TRUST_BEYOND,
	TRUST_SLOW,
	TRUST_BAND,
	TRUST_FEED,
	TRUST_BOUND,
	TRUST_MACHINE,
	TRUST_ORIGIN
};

enum { TRUST_REASONS = 16 };

/* The light is that of the worst reason.  Reasons [n], worst first, are
 * sentences without a full stop.  remark [remarks]: observations that would be
 * reasons beyond the measured speeds; between these, the measurements correct
 * the answer.  speed_sd: the standard deviation of the tip speeds, as a share,
 * that the band allows for; 0: there is no band, or speeds count as exact. */
struct trust {
	enum light light;
	double speed_sd;
	size_t n, remarks;
	char *remark[4];
	struct trust_reason {
		enum trust_cause cause;
		enum light light;
		char *text;
	} reason[TRUST_REASONS];
};

/* Returns how far beyond the measured speeds, m/s, an answer may be without
 * being red for that alone. */
double trust_reach_beyond_speeds(double slowest, double fastest);

/* Adds a reason.  Takes ownership of the text. */
void trust_add_reason(
    struct trust *t, enum light light, enum trust_cause cause, char *text);

/* Adds the reasons that follow from the evidence and the question. */
void trust_judge_answer(
    struct trust *t, const struct evidence *e, const struct trust_question *q);
void trust_free(struct trust *t);

/* Returns the change in an ensemble's answers, passing 0..1, for one standard
 * deviation of a parameter: the root mean square over its sieves, at the
 * ensemble's speed. */
double trust_answer_change_per_param_sd(
    const struct posterior *p, struct ensemble *e, const char *parameter);

/* Returns the largest difference between two feeds, passing 0..1. */
double trust_largest_feed_difference(const struct psd *a, const struct psd *b);

/* For a site with a feed for each product, computes the RMSE of a fit over all
 * products, passing 0..1: *own with these feeds, *mean with their mean for all.
 * Returns true if the mean is clearly better, that is, if the products do not
 * follow the differences between the feeds.  If false, *own and *mean may be
 * unset. */
bool trust_are_feeds_misleading(
    const struct site *site, const struct fit *fit, double *own, double *mean);

#endif

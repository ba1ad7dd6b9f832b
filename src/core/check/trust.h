/* The trust in an answer, as one light with its reasons.
 *
 * A residual has two causes that its size and pattern do not distinguish: the
 * model is wrong for this plant, or the samples are biased.  So reasons state
 * the observation and its consequence, and not the cause.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_CHECK_TRUST_H
#define TIPSPEED_CORE_CHECK_TRUST_H

#include "core/search/calibrate.h"
#include "core/posterior/ensemble.h"
#include "core/posterior/posterior.h"
#include "core/check/validate.h"

enum light { LIGHT_GREEN, LIGHT_AMBER, LIGHT_RED };
extern const char *const LIGHT_NAME[3];

/* How far the two halves of the draws may lie apart, in widths of the band
 * (ensemble_halves); above, they are unsettled. */
#define DRAWS_SETTLED 0.25

/* Above this RMSE (passing, 0..1) at the training runs a fit is called poor: a
 * careful sample repeats to 0.005 or 0.01. */
#define FIT_POOR 0.02

/* Where the fit lowers the null model's misfit by less than this share, the
 * products cannot be distinguished from the feed. */
#define FIT_NOTHING 0.5

/* Whether there is no band: the fit is poor, and two speeds or fewer inform it.
 * Two points lie on any line, so that nothing shows how the discrepancy bends
 * between them. */
bool trust_without_band(double rmse, size_t speeds);

/* How far two products contradict that a faster rotor breaks more (D23): by how
 * much the slower run's is finer than the faster run's, passing 0..1.  most:
 * the largest difference, at the sieve `at`, m; mean: over their common
 * sieves. */
struct order {
	double most, at, mean;
};
struct order trust_order(const struct psd *slow, const struct psd *fast);

/* ORDER_NOTABLE: worth a remark, but sampling may explain it.
 * trust_order_wrong: more than sampling explains, at one sieve or in the mean.
 * Of 180 sheets with a noise of 1 point, 29 exceed ORDER_NOTABLE somewhere, and
 * 3 are called wrong. */
#define ORDER_NOTABLE 0.02
bool trust_order_wrong(const struct order *o);

/* The evidence of a fit itself, independent of the question; computed once for
 * each fit.  use: the runs that inform the answer. */
struct evidence {
	size_t cells, parameters; /* of the fit */
	double rmse;              /* of the fit, passing 0..1 */
	bool like_feed;           /* products do not differ from the feed */
	/* Residuals at all runs used, less what a step of the parameters
	 * explains: mean square over that of usual sampling errors; correlation
	 * of neighbours on a curve, in its standard deviations. */
	double size, alike;
	/* NAN without a posterior.  discrepancy, sampling: medians of the
	 * draws, passing 0..1; more: share of the draws in which the
	 * discrepancy is larger than the sampling. */
	double discrepancy, sampling, more;
	/* gamma + kappa (D12, D17): both move B(u) = 1/2 alike with the energy.
	 * NAN in a model without them. */
	double finer, finer_sd;
	double unbounded; /* share of the draws with no threshold */
	double halves;    /* ensemble_halves, the worst of three speeds */
	double breaks;    /* of the feed above the break size, slowest speed */
	bool all_break;   /* there the fit breaks the finest sieve's size */
	size_t speeds;    /* how many inform it */
	double slowest, fastest;   /* of these */
	struct validation holdout; /* the worst; n_sieve 0: none was */
	/* The two runs, of those used and moved to one feed, that contradict
	 * most that faster is finer, m/s; most 0: none do. */
	struct {
		double slow, fast;
		struct order order;
	} against;
};

/* noise: known error of a single passing, 0..1; 0: as usual. */
struct evidence trust_gather_evidence(const struct site *site,
    const bool *train, const bool *use, const struct fit *fit,
    const struct bounds *bounds, const struct posterior *posterior,
    double noise);

/* The question.  All but speed may be 0 or NAN. */
struct trust_question {
	double speed; /* m/s; 0: none, the fit is meant */
	/* Whether the answer is corrected by the measured runs, and is not the
	 * model's alone. */
	bool corrected;
	double width; /* of the band, mean over the sieves, passing 0..1 */
	/* For a feed that was not sampled here: its largest difference from the
	 * nearest feed of the fit, passing 0..1. */
	double feed;
	/* A parameter on a bound, and by how much the answer would move if the
	 * parameter moved on by its standard deviation. */
	const char *bound;
	double bound_moves; /* passing 0..1 */
};

/* The subject of a reason, which decides whether others need to be stated. */
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

/* The light is that of the worst reason; reasons [n], the worst first, are
 * sentences without a full stop.  remark [remarks]: what would be reasons
 * beyond the measured speeds; between them the measurements correct it. */
struct trust {
	enum light light;
	size_t n, remarks;
	char *remark[4];
	struct trust_reason {
		enum trust_cause cause;
		enum light light;
		char *text;
	} reason[TRUST_REASONS];
};

/* Adds a reason and takes ownership of the text. */
void trust_add(
    struct trust *t, enum light light, enum trust_cause cause, char *text);

/* Adds the reasons that evidence and question give. */
void trust_judge(
    struct trust *t, const struct evidence *e, const struct trust_question *q);
void trust_free(struct trust *t);

/* Returns the change of an ensemble's answers, at its speed and n sizes, for
 * one standard deviation of a parameter: root mean square, passing 0..1. */
double trust_parameter_correlation(const struct posterior *p,
    struct ensemble *e, size_t n, const char *parameter);

/* Returns the largest difference of two feeds, passing 0..1. */
double trust_feed_difference(const struct psd *a, const struct psd *b);

#endif

/* Control charts (core/check/control_chart.h) of a site's routine cuts, which
 * are those that the prediction does not use.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_ASK_ROUTINE_H
#define TIPSPEED_CMD_ASK_ROUTINE_H

#include "cmd/session/session.h"
#include "core/check/control_chart.h"

struct routine_cut {
	/* run: of the site.  n: the number of sieves that crushing can change.
	 * worst: the sieve with the largest residual. */
	size_t run, n, worst;
	/* The time in words, or "". */
	char *when;
	/* time: s, or NAN.  speed: m/s. */
	double time, speed;
	/* size: the sieves [n], m.  measured, predicted: the passings there.
	 * truth: the passings in each draw [n][POSTERIOR_DRAWS]; NULL without
	 * draws.  error: the covariance of sampling errors [n][n]. */
	double *size, *measured, *predicted, *truth, *error;
};

/* The charts of a site's routine cuts. */
struct routine {
	/* In the order of their dates if all have one (dated), otherwise in the
	 * order in which they were added. */
	size_t n;
	struct routine_cut *cut;
	struct drift_point *point;
	struct drift_rule rule;
	/* drawn: the limits are from a calibration's posterior, otherwise from
	 * `set noise`. */
	bool dated, drawn, training_only;
	/* first, since: see drift_compute_charts.  running: how many of the
	 * latest cuts in a row have a mean on the same side of the prediction.
	 */
	size_t first, since, running;
	/* worst: the sieve, m, at which these differ most from the prediction.
	 * by: their mean difference there, passing. */
	double worst, by;
};

/* Fewer cuts than this do not show a slow drift. */
enum { ROUTINE_FEW = 5 };

/* Computes the charts of an entry's cuts.  Returns NULL with an error if there
 * are no cuts or there is nothing to compute limits from. */
struct routine *control_charts_compute(const struct session *s,
    const struct entry *entry, const struct drift_rule *rule,
    struct error *error);
void control_charts_free(struct routine *r);

/* Returns "coarser than predicted four times running, most at 4 mm (-3.1 points
 * on average): look at ..", or that there is no drift.  The caller frees it. */
char *drift_in_words(const struct routine *r);

/* Returns "the last cuts are coarser than predicted: see 'drift'" if the
 * entry's charts are beyond a limit after the last cut, otherwise NULL.  The
 * caller frees it.  Computed once, and cached with the calibration. */
char *drift_alarm_in_words(const struct session *s, const struct entry *entry);

extern const char *const ROUTINE_STATE[5];

#endif

/* Control charts (core/check/control_chart.h) of a site's routine cuts: those
 * not used for the prediction with which they are compared.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_ASK_ROUTINE_H
#define TIPSPEED_CMD_ASK_ROUTINE_H

#include "cmd/session/session.h"
#include "core/check/control_chart.h"

/* A cut: the site's run; when: in words, or ""; time: s, or NAN.  size m,
 * measured and predicted passings [n] on the sieves that crushing can change.
 * worst: the one with the largest residual. */
struct routine_cut {
	size_t run, n, worst;
	char *when;
	double time, speed;
	double *size, *measured, *predicted, *truth, *error;
};

/* Cuts [n] in the order of their dates if all have one (dated), otherwise in
 * the order in which they were added.  drawn: limits are from a calibration's
 * posterior, otherwise from `set noise`.  first, since: see drift_run_charts.
 * running: the number of latest cuts whose means are on the same side of the
 * prediction; worst: the sieve, m, at which these differ most; by: their mean
 * difference there, passing. */
struct routine {
	size_t n;
	struct routine_cut *cut;
	struct drift_point *point;
	struct drift_rule rule;
	bool dated, drawn, training_only;
	size_t first, since, running;
	double worst, by;
};

/* A slow drift shows only over this many cuts or more. */
enum { ROUTINE_FEW = 5 };

/* Charts the cuts of an entry.  Returns NULL with an error if there are no cuts
 * or no basis for limits. */
struct routine *routine_compute_charts(const struct session *s,
    const struct entry *entry, const struct drift_rule *rule,
    struct error *error);
void routine_charts_free(struct routine *r);

/* Returns "coarser than predicted four times running, most at 4 mm (-3.1 points
 * on average): look at ..", or that nothing drifts.  The caller frees it. */
char *drift_in_words(const struct routine *r);

/* If the entry's charts are beyond a limit after the last cut, returns "the
 * last cuts are coarser than predicted: see 'drift'", which the caller frees;
 * otherwise NULL.  Computed once for a site and cached with the calibration. */
char *drift_alarm_in_words(const struct session *s, const struct entry *entry);

extern const char *const ROUTINE_STATE[5];

#endif

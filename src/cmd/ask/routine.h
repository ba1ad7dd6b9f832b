/* Routine cuts of a site: those that the prediction they are compared with has
 * not seen, on the control charts of core/check/control_chart.h.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_ASK_ROUTINE_H
#define TIPSPEED_CMD_ASK_ROUTINE_H

#include "cmd/session/session.h"
#include "core/check/control_chart.h"

/* A cut: the site's run; when, in words, or ""; time, s, or NAN.  size m,
 * measured and predicted passings [n] on the sieves that crushing can change.
 * worst: of these, the one with the largest residual. */
struct routine_cut {
	size_t run, n, worst;
	char *when;
	double time, speed;
	double *size, *measured, *predicted, *truth, *error;
};

/* Cuts [n] in the order of their dates if all have one (dated), else in the
 * order they were added.  drawn: limits are from a calibration's posterior,
 * else from the noise that is set.  first, since: see drift_run_charts.
 * running: how many of the last cuts lie on the same side of the prediction, by
 * their mean; worst: m, the sieve at which these differ most; by: how much,
 * passings on average. */
struct routine {
	size_t n;
	struct routine_cut *cut;
	struct drift_point *point;
	struct drift_rule rule;
	bool dated, drawn, training_only;
	size_t first, since, running;
	double worst, by;
};

/* Follows the cuts of an entry.  NULL with an error if there are no cuts, or
 * nothing to find limits from. */
struct routine *routine_follow(const struct session *s,
    const struct entry *entry, const struct drift_rule *rule,
    struct error *error);
void routine_free(struct routine *r);

/* Returns "coarser than predicted four times running, most at 4 mm (-3.1 points
 * on average): look at ..", or that nothing drifts.  The caller frees. */
char *routine_state_words(const struct routine *r);

/* If the entry's charts are beyond a limit after its last cut, returns "the
 * last cuts are coarser than predicted: see 'drift'", which the caller frees,
 * else NULL.  Computed once for a site and kept with the calibration. */
char *routine_alarm(const struct session *s, const struct entry *entry);

extern const char *const ROUTINE_STATE[5];

#endif

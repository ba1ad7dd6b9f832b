/* Comparison of runs with their predictions, for validate.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_FIT_COMPARISON_H
#define TIPSPEED_CMD_FIT_COMPARISON_H

#include "cmd/fit/part.h"
#include "core/posterior/posterior.h"
#include "core/check/validate.h"

/* A compared run, with its prediction.  entry: its site's.  name: "74 (2)".
 * within: how many of its passings lie in the band for one more sample; within
 * and corrected are used only when one site is validated. */
struct compared {
	size_t entry;
	const struct site *site;
	char *name;
	bool *train;
	struct params params;
	struct model_settings settings;
	bool has_band, open; /* open: see trust_without_band */
	struct validation v;
	size_t within;
	double *corrected; /* [v.n_sieve] */
};

/* The state of one `validate`.  at, end, speed: for holdout=each, the site
 * under way, the site to stop before, and the speed left out last. */
struct comparison {
	bool all, each, sieves;
	double level;
	struct part part;
	char *options; /* that all parts must have */
	size_t n, left_out;
	struct compared *item;
	size_t at, end;
	double speed;
};

/* What predicts the runs of a site.  rmse: of the fit, 0..1. */
struct predicted_by {
	size_t entry;
	const struct site *site;
	const bool *train;
	struct params params;
	struct model_settings settings;
	const struct posterior *posterior;
	double rmse;
};

/* Returns the draws' answer at the run's covered sieves; `within` gets the
 * number of its passings that lie in the draws' band for one more sample; NULL
 * and 0 without draws.  The caller frees. */
double *comparison_corrected(const struct run *run,
    const struct posterior *posterior, double level, size_t *within);

/* Adds the comparisons of all held-out runs of the site that have a product. */
void comparison_add(struct comparison *c, const struct predicted_by *by);

/* Appends the runs of `from` to `c`, and frees `from`. */
void comparison_append(struct comparison *c, struct comparison *from);

/* Returns the answer on the runs of this site: fields, tables, and which
 * predicts best. */
struct answer *comparison_answer(
    const struct comparison *c, const struct site *site);

/* Frees a struct comparison *; also used as a job's `drop`. */
void comparison_drop(void *of);

#endif

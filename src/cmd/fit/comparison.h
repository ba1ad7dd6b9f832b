/* Runs compared with what predicts them: what validate works on.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_FIT_COMPARISON_H
#define TIPSPEED_CMD_FIT_COMPARISON_H

#include "cmd/fit/part.h"
#include "core/posterior/posterior.h"
#include "core/check/validate.h"

/* A run that was compared, with what predicted it.  entry: its site's.  name:
 * "74 (2)".  within: how many of its passings lie in the band for one more
 * sample; this and corrected are of one site alone. */
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

/* What one `validate` compares.  at, end, speed: of holdout=each, the site that
 * is looked at, the one to stop before, and the speed left out last. */
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

/* What runs of a site are compared with.  rmse: of the fit, 0..1. */
struct predicted_by {
	size_t entry;
	const struct site *site;
	const bool *train;
	struct params params;
	struct model_settings settings;
	const struct posterior *posterior;
	double rmse;
};

/* The answer of draws at the run's covered sieves, and how many of its passings
 * lie in their band for a sample; without draws NULL and 0.  The caller
 * frees. */
double *comparison_corrected(const struct run *run,
    const struct posterior *posterior, double level, size_t *within);

/* Compares all runs of the site that are held out and have a product. */
void comparison_add(struct comparison *c, const struct predicted_by *by);

/* Moves the runs of one behind those of the other, and frees it. */
void comparison_take(struct comparison *c, struct comparison *from);

/* Fields, tables, and who predicts best, of runs of this site. */
struct answer *comparison_answer(
    const struct comparison *c, const struct site *site);

/* Frees a struct comparison *; a job's too. */
void comparison_drop(void *of);

#endif

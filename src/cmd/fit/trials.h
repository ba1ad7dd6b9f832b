/* Held-out runs with their predictions and the differences.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_FIT_TRIALS_H
#define TIPSPEED_CMD_FIT_TRIALS_H

#include "cmd/session/session.h"
#include "core/posterior/posterior.h"
#include "core/check/validate.h"

/* A held-out run with its predictions.  entry: index of its site among the
 * loaded ones; key: of the site; source: of its data; name: "74 (2)"; passing:
 * the predictions, see validate_predict_by_all_ways; within: how many of its
 * passings lie in the band for one more sample, only if has_band; rotor:
 * diameter, m, 0 if not stated.  Runs read from a part have no name, run,
 * passing or rotor. */
struct trial {
	size_t entry;
	char *key, *source, *name;
	const struct run *run;
	double *passing;
	bool has_band, open; /* open: see trust_is_band_impossible */
	size_t within;
	double rotor;
	bool in_rpm; /* the sheet of its site is in rpm */
	struct validation v;
};

/* Such runs, in the order of their sites.  one: they are from one site, so
 * passings are compared with bands of this level, 0..1; each: every speed was
 * held out in turn; left_out: number of sites without such a run. */
struct trials {
	bool one, each;
	double level;
	size_t n, left_out;
	struct trial *item;
};

/* What the runs of a loaded site are predicted with.  train: the training runs;
 * rmse: that of the fit, 0..1. */
struct predicted_by {
	size_t entry;
	const bool *train;
	struct params params;
	struct model_settings settings;
	const struct posterior *posterior;
	double rmse;
};

/* Adds all held-out runs of the site that have a product. */
void trials_add_held_out_runs(
    struct trials *c, const struct session *s, const struct predicted_by *by);

/* As trials_add_held_out_runs, with the entry's own parameters.  posterior:
 * corrects them, or NULL. */
void trials_add_held_out_runs_of_site(struct trials *c, const struct session *s,
    size_t index, const struct posterior *posterior);

/* Adds a run and takes ownership of its strings and arrays. */
void trials_add_trial(struct trials *c, struct trial trial);

/* Moves the runs of `from` to the end of `c`. */
void trials_append_all(struct trials *c, struct trials *from);

/* Returns the sources of the runs' data (sources_text_and_clear), and the
 * number of their sites.  The caller frees the text. */
char *trials_data_sources_text(const struct trials *c, size_t *sites);

/* Returns what a way predicts at the sieves of a run, [v.n_sieve]. */
const double *trials_predicted_passing(
    const struct trial *trial, enum validate_way way);

/* Returns the score of a way at size i of PSD_PASSING over all runs. */
struct validate_score trials_score_at_size(
    const struct trials *c, enum validate_way way, size_t i);

/* Frees the members. */
void trials_clear(struct trials *c);

#endif

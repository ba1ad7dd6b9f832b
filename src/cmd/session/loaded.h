/* A loaded site with its parameters, their origin and the results of a
 * calibration.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_SESSION_LOADED_H
#define TIPSPEED_CMD_SESSION_LOADED_H

#include <stdbool.h>

#include "core/search/calibrate.h"
#include "core/check/control_chart.h"
#include "core/psd/site.h"
#include "core/check/trust.h"
#include "io/formats/answer.h"
#include "cmd/session/settings.h"
#include "io/store/material.h"

/* The results of a calibration: the fit, the generations [n] and bounds of
 * the search, and the site and training runs [n_run] that were fitted.
 * Computed on first use: the posterior and the evidence, indexed by the runs
 * that inform them (enum correction), and the products of the feed last
 * asked about. later: the runs added to the site since, and that with the
 * largest misfit; alarm: the state of their charts (control_chart.h).
 * Shared by the entries, snapshots and origins that refer to it. */
struct history {
	size_t holders, n;
	struct fit fit;
	struct calibrate_generation *generation;
	struct bounds bounds;
	const struct site *site;
	bool *train;
	bool (*stop)(void);
	struct posterior *posterior[2]; /* NULL: not drawn yet */
	struct posterior_run *drawing;  /* for posterior[drawn], or NULL */
	size_t drawn;
	struct evidence *evidence[2];
	double weight;          /* see calibration_sum_of_weights */
	double noise, speed_sd; /* those of the draws, and their seed */
	unsigned draw_seed;
	struct later {
		const struct site *site; /* NULL: not compared yet */
		size_t n;
		double rms, speed;
		bool missed, off, twice;
	} later;
	struct alarm {
		const struct site *site; /* NULL: not charted yet */
		const struct posterior *posterior;
		enum drift_state state;
	} alarm;
	/* The ensembles for the mean of several feeds and for a run's own feed
	 * or that of another sheet, so measured products can be moved from one
	 * feed to the other. */
	struct ensemble_of {
		const struct posterior *posterior;
		const struct site *site;
		size_t feed_run;
		struct ensemble *ensemble; /* NULL: none is kept */
	} kept[2];
};

/* The origin of parameters.  Immutable, and shared by the entries and snapshots
 * that refer to it.  Unknown members are "", 0 or NULL. */
struct origin {
	size_t holders;
	char *words;      /* "found by calibration", "taken from bro" */
	char *from;       /* the site or material; "": this site */
	char *material;   /* that was recalled from the store */
	char *date;       /* when the material was remembered */
	bool found;       /* by calibration, not set by hand */
	uint64_t digest;  /* of the data on which they were found */
	char *provenance; /* of these data */
	size_t n_speed;   /* training speeds, m/s */
	double *speed;
	struct history *history; /* the calibration, if in this session */
};

/* What a question assumes that differs from the measurements; see
 * cmd/ask/question.h.  own: the entry without these changes.  feed: that of
 * other sheets, or NULL; rock: its rock, or "".  rotor: m; 0: as measured.
 * bypass: share of the feed that bypasses the rotor; k: impacts; 0: as set.
 * correction: the runs that inform the answer.  sieve [n_sieve]: sieves to
 * show, m, coarsest first. */
struct blended;
struct scenario {
	const struct entry *own;
	const struct blended *feed;
	const char *rock;
	double rotor, bypass, k;
	enum correction correction;
	size_t n_sieve;
	const double *sieve;
};

/* Lookup keys of a site: digests of its name (in the form used in keys), of its
 * path, and of its file when loaded, or 0 without a file. */
struct lookup_keys {
	uint64_t name, path, file;
};

/* A loaded site with its answers.  key: its name in the session, "gavle/4".
 * train [site->n_run]: true for training runs.  remembered: the name under
 * which its fit was put into the store, or NULL.  new_cuts: how many cuts were
 * added since. */
struct entry {
	struct lookup_keys lookup;
	struct site *site;
	char *key;
	bool *train;
	bool has_params, has_fit;
	char *remembered;
	size_t new_cuts;
	struct params params;    /* set by hand or found */
	struct origin *origin;   /* of params; NULL: no params */
	struct fit fit;          /* that found the parameters */
	struct history *history; /* of the last calibration, or NULL */
	char options[400];       /* for the fit, as typed after calibrate */
	const struct scenario *scenario; /* NULL: as measured */
};

/* Frees n entries and all that they own. */
void entries_free(struct entry *entry, size_t n);

/* Returns another entry for the same site, with copies of the members and a
 * share in the history. */
struct entry entry_copy(const struct entry *from);

/* Frees what the entry owns. */
void entry_clear(struct entry *entry);

/* Returns the loaded entry on which an entry with a scenario is based. */
const struct entry *entry_without_scenario(const struct entry *entry);

/* Returns the diameter of the rotor that the entry's parameters were measured
 * with, m; 0: not known. */
double entry_rotor_of_params(const struct entry *entry);

/* Returns a history, without generations and with one holder, for a calibration
 * that found the fit on the runs marked in train [n_run] within the bounds.
 * weight: see calibration_sum_of_weights.  Borrows the site. */
struct history *history_new(const struct fit *fit, const struct bounds *bounds,
    double weight, const struct site *site, const bool *train);

/* Releases a share in the history, which may be NULL. */
void history_release(struct history *history);

/* Discards the draws; they will be redrawn with the errors and the seed that
 * are set. */
void history_discard_draws(struct history *history, const struct settings *set);

/* Discards what was computed for a site that is being removed. */
void history_discard_for_site(struct history *history, const struct site *site);

/* Return the origin of parameters: just found by the entry's fit; set by hand;
 * taken from another entry; a material in the store; the site's own fit, kept
 * in a material.  The caller owns a share. */
struct origin *origin_of_fit(const struct entry *entry);
struct origin *origin_new_by_hand(void);
struct origin *origin_of_params_taken(const struct entry *from);
struct origin *origin_from_store(const struct material *m);
struct origin *origin_of_remembered_fit(
    const struct entry *entry, const struct material *m);

/* True if the parameters were recalled from the store. */
bool origin_is_from_store(const struct origin *origin);

void origin_release(struct origin *origin); /* NULL is allowed */
bool origin_is_same(const struct origin *a, const struct origin *b);

/* Returns the origin of the entry's parameters in words: "set by hand". */
const char *origin_source_text(const struct entry *entry);

/* Returns the fit in this session, on any site, that found the entry's
 * parameters, or NULL. */
const struct fit *origin_source_fit(const struct entry *entry);

/* Returns the key of the site to which the fit of origin_source_fit belongs. */
const char *origin_site_key(const struct entry *entry);

/* Computes the slowest and fastest training speeds of the parameters or, if
 * unknown, the slowest and fastest speeds measured on the site.  Returns false
 * if neither are known. */
bool origin_known_speed_range(
    const struct entry *entry, double *slowest, double *fastest);

/* True if the speeds of origin_known_speed_range are training speeds. */
bool origin_has_training_speeds(const struct entry *entry);

/* Returns "trained at 69 and 79 m/s; reconstructed, not measured" or "set by
 * hand".  The caller frees it. */
char *origin_training_text(const struct origin *origin);

/* True if the parameters were calibrated on data other than the site's, which
 * deserves a warning. */
bool origin_is_other_site(const struct entry *entry);

/* origin_params_from_sentence returns "parameters from tierp (..), not
 * calibrated on this site", or "" if they were found on it; the caller frees
 * it.  origin_note_in_answer adds it as a note for parameters from another site
 * or the store; the light reports parameters set by hand. */
char *origin_params_from_sentence(const struct entry *entry);
void origin_note_in_answer(struct answer *r, const struct entry *entry);

/* Puts "params_from": {"origin", "trained_mps", "provenance"}. */
void origin_put_fields(struct fields *o, const struct entry *entry);

#endif

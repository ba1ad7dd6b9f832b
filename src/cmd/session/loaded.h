/* A loaded site with its parameters, where these are from, and the results of a
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

/* The results of a calibration.  Shared by the entries, snapshots and origins
 * that refer to it. */
struct history {
	/* holders: how many share it.  n: the number of generations. */
	size_t holders, n;
	/* What was found, the generations [n] and bounds of the search, and the
	 * site and its training runs [n_run]. */
	struct fit fit;
	struct calibrate_generation *generation;
	struct bounds bounds;
	const struct site *site;
	bool *train;
	/* For each choice of the runs that inform it (enum correction); NULL
	 * until it is needed. */
	struct posterior *posterior[2];
	struct posterior_run *drawing; /* for posterior[drawn], or NULL */
	size_t drawn;
	struct evidence *evidence[2]; /* likewise */
	double weight;                /* see calibration_sum_squared_weights */
	double noise, speed_sd;       /* those of the draws, and their seed */
	unsigned draw_seed;
	/* The runs added to the site since, and the one of them that the
	 * prediction misses by most, see cut_compare_runs_since_fit. */
	struct later {
		const struct site *site; /* NULL: not compared yet */
		size_t n;
		double rms, speed;
		bool missed, off, twice;
	} later;
	/* The state of their control charts (control_chart.h). */
	struct alarm {
		const struct site *site; /* NULL: not charted yet */
		const struct posterior *posterior;
		enum drift_state state;
	} alarm;
	/* The products of the draws, for the mean of several feeds and for the
	 * feed of a run or of another sheet: two, so that measured products can
	 * be moved from one feed to the other. */
	struct ensemble_of {
		const struct posterior *posterior;
		const struct site *site;
		size_t feed_run;
		struct ensemble *ensemble; /* NULL: none is kept */
	} kept[2];
};

/* Where parameters are from.  It does not change, and is shared by the entries
 * and snapshots that refer to it.  What is not known is "", 0 or NULL. */
struct origin {
	size_t holders;
	char *words;      /* "found by calibration", "taken from bro" */
	char *from;       /* the site or material; "": this site */
	char *material;   /* the name in the store, if recalled from it */
	char *date;       /* when that was remembered */
	bool found;       /* by calibration, not set by hand */
	uint64_t digest;  /* of the data on which they were found */
	char *provenance; /* of these data */
	size_t n_speed;   /* training speeds, m/s */
	double *speed;
	struct history *history; /* the calibration, if in this session */
};

/* How the conditions that a question assumes differ from those measured; see
 * cmd/ask/question.h. */
struct blended;
struct scenario {
	/* The entry without these changes. */
	const struct entry *own;
	/* A feed from other sheets, or NULL, and its rock, or "". */
	const struct blended *feed;
	const char *rock;
	/* rotor: its diameter, m; 0: as measured.  bypass: share of the feed
	 * that bypasses the rotor.  k: the number of impacts; 0: as set. */
	double rotor, bypass, k;
	/* The runs that correct the model. */
	enum correction correction;
	/* The sieves to show, m [n_sieve], coarsest first. */
	size_t n_sieve;
	const double *sieve;
};

/* Digests by which a site is looked up: of its name as keys have it, of its
 * path, and of the file's device and inode when it was loaded; 0 without a
 * file. */
struct lookup_keys {
	uint64_t name, path, file;
};

/* A loaded site, with its parameters. */
struct entry {
	struct lookup_keys lookup;
	struct site *site;
	char *key;   /* its name in the session, "gavle/4" */
	bool *train; /* [site->n_run]: which are training runs */
	bool has_params, has_fit;
	/* The name under which the store has its fit, or NULL. */
	char *remembered;
	size_t new_cuts;         /* added since then */
	struct params params;    /* set by hand or found */
	struct origin *origin;   /* of params; NULL: no params */
	struct fit fit;          /* that found the parameters */
	struct history *history; /* of the last calibration, or NULL */
	char options[400];       /* for the fit, as typed after calibrate */
	const struct scenario *scenario; /* NULL: as measured */
};

/* Frees n entries and all that they own. */
void entries_free(struct entry *entry, size_t n);

/* Returns another entry for the same site.  It has copies of the members, and
 * shares the history. */
struct entry entry_copy(const struct entry *from);

/* Frees what the entry owns. */
void entry_clear(struct entry *entry);

/* Returns the loaded entry that an entry with a scenario was made from, or the
 * entry itself. */
const struct entry *entry_without_scenario(const struct entry *entry);

/* Returns the diameter of the rotor with which the products behind the entry's
 * parameters were measured, m; 0 if it is not known. */
double entry_rotor_of_calibration(const struct entry *entry);

/* Returns a history, without generations and with one holder, for a calibration
 * that found the fit within the bounds, on the runs marked in train [n_run].
 * weight: see calibration_sum_squared_weights.  Borrows the site. */
struct history *history_new(const struct fit *fit, const struct bounds *bounds,
    double weight, const struct site *site, const bool *train);

/* Releases a share of the history, which may be NULL. */
void history_release(struct history *history);

/* Discards the draws.  They will be drawn again with the errors and the seed
 * that are set. */
void history_reset_posteriors(
    struct history *history, const struct settings *set);

/* Discards what was computed for a site that is being removed. */
void history_free_ensembles_of_site(
    struct history *history, const struct site *site);

/* Return the origin of parameters that the entry's fit just found, were set by
 * hand, were taken from another entry, are from a material in the store, or are
 * the site's own fit as kept in a material.  The caller owns a share. */
struct origin *origin_new_of_fit(const struct entry *entry);
struct origin *origin_new_by_hand(void);
struct origin *origin_new_of_copied_params(const struct entry *from);
struct origin *origin_new_from_store(const struct material *m);
struct origin *origin_new_of_remembered_fit(
    const struct entry *entry, const struct material *m);

/* True if the parameters were recalled from the store. */
bool origin_is_from_store(const struct origin *origin);

void origin_release(struct origin *origin); /* NULL is allowed */
bool origin_is_same(const struct origin *a, const struct origin *b);

/* Returns where the entry's parameters are from, in words: "set by hand". */
const char *origin_of_params_text(const struct entry *entry);

/* Returns the fit in this session, on any site, that found the entry's
 * parameters, or NULL. */
const struct fit *origin_fit_behind_params(const struct entry *entry);

/* Returns the key of the site to which the fit of origin_fit_behind_params
 * belongs. */
const char *origin_site_key(const struct entry *entry);

/* Computes the slowest and fastest training speeds of the parameters or, if
 * these are not known, those of the site's runs that are marked for training.
 * Returns false if there are neither. */
bool origin_training_speed_range(
    const struct entry *entry, double *slowest, double *fastest);

/* True if the speeds of origin_training_speed_range are training speeds. */
bool origin_has_training_speeds(const struct entry *entry);

/* Returns "trained at 69 and 79 m/s; reconstructed, not measured" or "set by
 * hand".  The caller frees it. */
char *origin_training_speeds_text(const struct origin *origin);

/* True if the parameters are another site's and were not calibrated on the same
 * data as this one's, which deserves a warning. */
bool origin_is_other_site(const struct entry *entry);

/* origin_params_source_sentence returns "parameters from tierp (..), not
 * calibrated on this site", or "" if they were found on it or set by hand, of
 * which the light tells; the caller frees it.  origin_add_note_to_answer adds
 * it as a note. */
char *origin_params_source_sentence(const struct entry *entry);
void origin_add_note_to_answer(struct answer *r, const struct entry *entry);

/* Puts the object "params_from": "origin", "trained_mps" and "provenance". */
void origin_put_param_source(struct fields *o, const struct entry *entry);

#endif

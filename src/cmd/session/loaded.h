/* A loaded site with what is known of it: its parameters, their origin, which
 * is passed on with them, and the results of a calibration.
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

/* The results of a calibration: the fit; its generations [n], with the bounds
 * it searched in; its site and training runs [n_run].  From these follow, when
 * first asked for, the posterior and the evidence, indexed by the runs that
 * inform them (enum correction), and the products of the feed that was last
 * asked for.  later: runs added to the site after it, and the one with the
 * largest misfit; alarm: the state of their charts (control_chart.h).  Shared
 * by the entries, snapshots and origins that refer to it. */
struct history {
	size_t holders, n;
	struct fit fit;
	struct calibrate_generation *generation;
	struct bounds bounds;
	const struct site *site;
	bool *train;
	bool (*stop)(void);
	struct posterior *posterior[2]; /* NULL: not drawn yet */
	struct posterior_run *drawing;  /* of the place `drawn`, or NULL */
	size_t drawn;
	struct evidence *evidence[2];
	double weight; /* see calibration_weight */
	double noise;  /* that the draws were made with, and their seed */
	unsigned draw_seed;
	struct later {
		const struct site *site; /* NULL: not compared yet */
		size_t n;
		double rms, speed;
		bool missed, off;
	} later;
	struct alarm {
		const struct site *site; /* NULL: not followed yet */
		const struct posterior *posterior;
		enum drift_state state;
	} alarm;
	/* The ensembles of the mean of several feeds, and of a run's own feed
	 * or another sheet's, so that measured products can be moved between
	 * the two. */
	struct ensemble_of {
		const struct posterior *posterior;
		const struct site *site;
		size_t feed_run;
		struct ensemble *ensemble; /* NULL: none is kept */
	} kept[2];
};

/* The origin of parameters.  Not changed once made, and shared by the entries
 * and snapshots that refer to it.  Unknown members are "", 0 or NULL. */
struct origin {
	size_t holders;
	char *words;      /* "found by calibration", "taken from bro" */
	char *whose;      /* site or material they belong to; "": this site */
	char *material;   /* of the store, recalled from there */
	char *date;       /* when the material was remembered */
	bool found;       /* by a calibration, not set by hand */
	uint64_t digest;  /* of the numbers they were found on */
	char *provenance; /* of these numbers */
	size_t n_speed;   /* how many speeds they were trained at, m/s */
	double *speed;
	struct history *spread; /* the calibration, where it was here */
};

/* What a question assumes instead of what was measured; see cmd/ask/question.h.
 * own: the entry as it is.  rock: the rock of the other feed, "" where it is
 * not stated or there is no other feed.  rotor: m, 0: not known; other_rotor:
 * it is not the rotor used in the measurements.  bypass: share of the feed led
 * past the rotor; k: impacts, 0: as set.  correction: runs that inform the
 * answer. */
struct variant {
	const struct entry *own;
	bool feed, other_rotor;
	char *rock;
	double rotor, measured_rotor, bypass, k;
	enum correction correction;
};

/* Lookup keys of a site: digests of its name as in keys, of its path, and of
 * its file when it was loaded, 0 where there was no file. */
struct mark_of {
	uint64_t name, path, file;
};

/* A loaded site with its answers.  key: its name in the session, "gavle/4".
 * train [site->n_run]: runs to train on, or that were trained on. */
struct entry {
	struct mark_of mark;
	struct site *site;
	char *key;
	bool *train;
	bool has_params, has_fit;
	struct params params;    /* set by hand or found */
	struct origin *origin;   /* of params; NULL: there are none */
	struct fit fit;          /* where the parameters were found */
	struct history *history; /* of the last calibration, or NULL */
	char options[400];       /* of the fit, as typed after calibrate */
	const struct variant *variant; /* NULL: it is as it was measured */
};

/* Frees n entries with what they own. */
void entries_free(struct entry *entry, size_t n);

/* Returns another entry of the same site, with copies of what it owns and a
 * share in its history. */
struct entry entry_copy(const struct entry *from);

/* Frees what the entry owns. */
void entry_clear(struct entry *entry);

/* Returns the loaded entry behind one that is asked about with a variant. */
const struct entry *entry_loaded(const struct entry *entry);

/* Returns the history of a calibration that ended with the fit, on the runs
 * marked in train [n_run], within the bounds; weight: see calibration_weight.
 * It has no generations and one holder.  Borrows the site. */
struct history *history_new(const struct fit *fit, const struct bounds *bounds,
    double weight, const struct site *site, const bool *train);

/* Drops a share in the history; NULL is allowed. */
void history_drop(struct history *history);

/* Discards the draws, so that they are drawn again with another noise or
 * seed. */
void history_draw_again(struct history *history, double noise, unsigned seed);

/* Discards what was computed for a site that is being removed. */
void history_forget(struct history *history, const struct site *site);

/* Return the origin of parameters: found by the entry's fit just now; set by
 * hand; taken over from another entry; of a material of the store; of the
 * site's own fit that a material kept.  The caller owns a share. */
struct origin *origin_of_fit(const struct entry *entry);
struct origin *origin_new_by_hand(void);
struct origin *origin_of_params_taken(const struct entry *from);
struct origin *origin_from_store(const struct stored *m);
struct origin *origin_of_remembered(
    const struct entry *entry, const struct stored *m);

/* True if the parameters were recalled from the store. */
bool origin_is_stored(const struct origin *origin);

void origin_drop(struct origin *origin); /* NULL is allowed */
bool origin_same(const struct origin *a, const struct origin *b);

/* Returns the origin of the entry's parameters in words: "set by hand". */
const char *origin_words(const struct entry *entry);

/* Returns the fit of this session that found the entry's parameters, on any
 * site; NULL if none did. */
const struct fit *origin_fit(const struct entry *entry);

/* Returns the key of the site that the fit of origin_fit was made on. */
const char *origin_key(const struct entry *entry);

/* The slowest and the fastest speed that the parameters were trained at or,
 * where these are not known, that were measured on the site.  False where
 * neither is known. */
bool origin_reach(const struct entry *entry, double *slowest, double *fastest);

/* True if origin_reach gives the speeds of the training. */
bool origin_trained(const struct entry *entry);

/* Returns "trained at 69 and 79 m/s; reconstructed, not measured", or "set by
 * hand".  The caller frees. */
char *origin_details(const struct origin *origin);

/* True if the parameters were calibrated on data other than the site's, which
 * is worth a warning. */
bool origin_is_other(const struct entry *entry);

/* origin_sentence returns "parameters from tierp (..), not calibrated on this
 * site", "" where they were found on it; the caller frees.  origin_note adds it
 * as a note where they are another site's or from the store; the light says
 * that parameters were set by hand. */
char *origin_sentence(const struct entry *entry);
void origin_note(struct answer *r, const struct entry *entry);

/* Puts "params_from": {"origin", "trained_mps", "provenance"}. */
void origin_put(struct fields *o, const struct entry *entry);

#endif

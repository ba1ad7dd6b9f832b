/* A loaded site with what is known of it: its parameters, where they are from,
 * which goes with them wherever they go, and what a calibration left.
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

/* What a calibration left: what it found; its generations, [n], with the bounds
 * it searched in; and its site and training runs [n_run], from which follows,
 * when first asked for, what is known after it: posterior and evidence, by the
 * runs that inform them (enum correction), and the products of the last feed
 * that was asked for. later: runs that came to a site after it, and the one
 * that it misses by most; alarm: the state of their charts (control_chart.h).
 * Shared by the entries, snapshots and origins that hold it. */
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
	double noise;  /* that they were drawn with, and from */
	unsigned draw_seed;
	struct later {
		const struct site *site; /* NULL: not compared yet */
		size_t n;
		double rms, speed;
		bool missed;
	} later;
	struct alarm {
		const struct site *site; /* NULL: not followed yet */
		const struct posterior *posterior;
		enum drift_state state;
	} alarm;
	/* Of the mean of several feeds, and of one of a run's own or another
	 * sheet's, so that what was measured can be moved between the two. */
	struct ensemble_of {
		const struct posterior *posterior;
		const struct site *site;
		size_t feed_run;
		struct ensemble *ensemble; /* NULL: none is kept */
	} kept[2];
};

/* Never changed once made, and shared by the entries and snapshots that hold
 * it.  What is not known is "", 0 or NULL. */
struct origin {
	size_t holders;
	char *words;      /* "found by calibration", "taken from bro" */
	char *whose;      /* site or material they are of; "": this site */
	char *material;   /* of the store, which they were recalled from */
	char *date;       /* and when that was remembered */
	bool found;       /* by a calibration, not set by hand */
	uint64_t digest;  /* of the numbers they were found on */
	char *provenance; /* of these */
	size_t n_speed;   /* how many speeds they were trained at, m/s */
	double *speed;
	struct history *spread; /* the calibration, where it was here */
};

/* What answers are asked of instead of what was measured; see
 * cmd/ask/question.h.  own: the entry as it is.  rock: of the other feed, ""
 * where not stated or there is none.  rotor: m, 0: not known; other_rotor: it
 * is not the one that was measured with.  bypass: share of the feed led past
 * the rotor; k: impacts, 0: as set.  correction: runs that inform the
 * answer. */
struct variant {
	const struct entry *own;
	bool feed, other_rotor;
	char *rock;
	double rotor, measured_rotor, bypass, k;
	enum correction correction;
};

/* Lookup keys of a site: digests of its name as in keys, of its path, and of
 * the file there when it was loaded, 0 where there was none. */
struct mark_of {
	uint64_t name, path, file;
};

/* A loaded site with its answers.  key: how it is called here, "gavle/4".
 * train [site->n_run]: runs to train on, or that were trained on. */
struct entry {
	struct mark_of mark;
	struct site *site;
	char *key;
	bool *train;
	bool has_params, has_fit;
	struct params params;    /* set by hand or found */
	struct origin *origin;   /* of them; NULL: there are none */
	struct fit fit;          /* where the parameters were found */
	struct history *history; /* of the last calibration, or NULL */
	char options[400];       /* of the fit, in the words of calibrate */
	const struct variant *variant; /* NULL: it is as it was measured */
};

/* Frees entries [n] with what they own. */
void entries_free(struct entry *entry, size_t n);

/* Another entry of the same site, with copies of what it owns and a share in
 * its history. */
struct entry entry_copy(const struct entry *from);

/* Frees what it owns. */
void entry_clear(struct entry *entry);

/* The site as it is loaded, of one that is asked about otherwise. */
const struct entry *entry_loaded(const struct entry *entry);

/* Of a calibration that ended with the fit, on the runs marked in train
 * [n_run], within the bounds; weight: see calibration_weight.  It has no
 * generations and one holder.  Borrows the site. */
struct history *history_new(const struct fit *fit, const struct bounds *bounds,
    double weight, const struct site *site, const bool *train);

/* Gives a share in it up; NULL is allowed. */
void history_drop(struct history *history);

/* Forgets what was drawn, which is to be drawn with another noise or seed. */
void history_redraw(struct history *history, double noise, unsigned seed);

/* Forgets what was worked out for a site that goes. */
void history_forget(struct history *history, const struct site *site);

/* Of the parameters that the entry's fit has just found; set by hand; those of
 * another entry, taken over; of a material; of the site's own fit that a
 * material kept.  The caller owns a share. */
struct origin *origin_of_fit(const struct entry *entry);
struct origin *origin_by_hand(void);
struct origin *origin_taken(const struct entry *from);
struct origin *origin_stored(const struct stored *m);
struct origin *origin_remembered(
    const struct entry *entry, const struct stored *m);

/* Whether they were recalled from the store. */
bool origin_is_stored(const struct origin *origin);

void origin_drop(struct origin *origin); /* NULL is allowed */
bool origin_same(const struct origin *a, const struct origin *b);

/* Where they are from, in words: "set by hand". */
const char *origin_words(const struct entry *entry);

/* The calibration of this session that found the entry's parameters, on
 * whatever site; NULL: none did. */
const struct fit *origin_fit(const struct entry *entry);

/* The site that it was made on: its key. */
const char *origin_key(const struct entry *entry);

/* The slowest and the fastest speed that the parameters were trained at, or
 * where that is not known, that was measured on the site.  False where neither
 * is known. */
bool origin_reach(const struct entry *entry, double *slowest, double *fastest);

/* Whether origin_reach has the speeds of the training. */
bool origin_trained(const struct entry *entry);

/* "trained at 69 and 79 m/s; reconstructed, not measured", or "set by hand".
 * The caller frees. */
char *origin_details(const struct origin *origin);

/* Whether they were calibrated on other data than the site's: a warning. */
bool origin_is_other(const struct entry *entry);

/* "parameters from tierp (..), not calibrated on this site"; "" where they were
 * found here.  The caller frees.  origin_note: as a note, of
 * another site's or of the store; the light says which were set by hand. */
char *origin_sentence(const struct entry *entry);
void origin_note(struct answer *r, const struct entry *entry);

/* Puts "params_from": {"origin", "trained_mps", "provenance"}. */
void origin_put(struct fields *o, const struct entry *entry);

#endif

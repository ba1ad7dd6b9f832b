/* Where parameters are from, which goes with them wherever they go.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_ORIGIN_H
#define TIPSPEED_CMD_ORIGIN_H

#include "cmd/session.h"
#include "io/stored.h"

/* Never changed once made, and shared by the entries and snapshots that hold
 * it.  What is not known is "", 0 or NULL. */
struct origin {
	size_t holders;
	char *words;      /* "found by calibration", "taken from bro" */
	char *whose;      /* site or material they are of; "": this site */
	bool stored;      /* it is a material of the store */
	bool found;       /* by a calibration, not set by hand */
	uint64_t digest;  /* of the numbers they were found on */
	char *provenance; /* of these */
	size_t n_speed;   /* how many speeds they were trained at, m/s */
	double *speed;
	struct history *spread; /* the calibration, where it was here */
};

/* Of the parameters that the entry's fit has just found; set by hand; those of
 * another entry, taken over; of a material.  The caller owns a share. */
struct origin *origin_of_fit(const struct entry *entry);
struct origin *origin_by_hand(void);
struct origin *origin_taken(const struct entry *from);
struct origin *origin_stored(const struct stored *m);

struct origin *origin_share(struct origin *origin);
void origin_drop(struct origin *origin); /* NULL is allowed */
bool origin_same(const struct origin *a, const struct origin *b);

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
 * found here.  The caller frees.  origin_note: as a note. */
char *origin_sentence(const struct entry *entry);
void origin_note(struct answer *r, const struct entry *entry);

/* Puts "params_from": {"origin", "trained_mps", "provenance"}. */
void origin_put(struct fields *o, const struct entry *entry);

#endif

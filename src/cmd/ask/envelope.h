/* Compares a grading envelope with the product of the site in use, or with the
 * fraction of it that the envelope is for.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_ASK_ENVELOPE_H
#define TIPSPEED_CMD_ASK_ENVELOPE_H

#include <stdbool.h>

#include "cmd/ask/question.h"
#include "cmd/ask/speed_search.h"
#include "cmd/session/session.h"
#include "io/formats/spec.h"

/* Returns the envelope that words name: one that comes with the program, or
 * that of a file; NULL words: the one chosen by `spec use`.  The session keeps
 * it.  NULL with an error; faults of a file have been reported by then. */
const struct spec *grading_spec(
    struct session *s, const char *words, struct error *error);

/* The limits of an envelope as conditions [n] on a fraction: first its n_sieve
 * sieves, those that the feed covers, with limits or without; then the fineness
 * modulus and what stays between two sieves, if the standard limits these.  All
 * questions about an envelope use these limits.  The caller frees `at`, which
 * points into the envelope.  modulus_unknown: the modulus is limited, but the
 * feed's sieves end too early. */
struct grading_limits {
	size_t n_sieve, n;
	struct condition *at;
	bool modulus_unknown;
};
struct grading_limits grading_limits(const struct spec *spec,
    const struct fraction *fraction, const struct psd *feed);

/* The limits as conditions on the fraction; after these the fraction's share of
 * the product, and a fineness modulus if the envelope's standard has one, else
 * NULL.  A limit of 100 % is met by what rounds to 100.0, as no screen is
 * perfect. */
struct grading {
	const struct spec *spec;
	struct grading_limits limits;
	struct fraction fraction;
	const struct modulus *modulus;
	struct wanted conditions;
};

/* Opens the comparison with an envelope.  The options cut, sharpness and
 * cut_size of the call describe the screens; cut=off: there are none. */
bool grading_open(const struct session *s, const struct args *args,
    const struct spec *spec, const struct question *q, struct grading *grading,
    struct error *error);

/* As grading_open, with the envelope in use, for its own fraction, by perfect
 * screens, and the feed of a run of the entry. */
bool grading_open_in_use(const struct session *s, const struct entry *entry,
    size_t feed, struct grading *grading, struct error *error);
void grading_close(struct grading *grading);

/* Returns "ASTM C33 fine aggregate, fraction 0/4.75".  The caller frees. */
char *grading_words(const struct grading *grading);

/* Adds columns and a row for each sieve at speed v: limits, passing and "ok",
 * "above", "below" or "not known". */
void grading_rows(struct answer *r, struct grading *grading, double v);

/* Returns what is missed at the forecast's speed, "outside on 2 of 7 sieves;
 * worst at 4 mm: 3.1 points above max", "inside on all sieves, but fineness
 * modulus (ASTM C136) 3.15 is above 3.1", or "" where all limits hold.  The
 * caller frees. */
char *grading_missed(const struct grading *grading);

/* Puts the worst sieve at that speed, worst_mm, and by how much it is outside,
 * outside_pct: 0 where all sieves hold. */
void grading_put_worst(struct fields *o, const struct grading *grading);

/* Notes the fineness modulus and the steps between sieves at that speed, if the
 * standard limits them; the source of the limits, and what is not checked. */
void grading_notes(struct answer *r, const struct grading *grading);

/* Puts spec, source, cut and the columns of grading_rows into the answer's
 * JSON. */
void grading_put_fields(struct answer *r, const struct grading *grading);

#endif

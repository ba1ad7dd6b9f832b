/* Compares the product of a site, or a fraction of it, with a grading envelope.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_ASK_ENVELOPE_H
#define TIPSPEED_CMD_ASK_ENVELOPE_H

#include <stdbool.h>

#include "cmd/ask/question.h"
#include "cmd/ask/speed_search.h"
#include "cmd/session/session.h"
#include "io/formats/spec.h"

/* Returns the envelope that `words` names, a shipped one or a file, or the one
 * chosen by `spec use` if words is NULL.  The session owns it.  Returns NULL
 * with an error if there is none; faults in a file are reported first. */
const struct spec *envelope_named_or_chosen(
    struct session *s, const char *words, struct error *error);

/* Appends the limits of an envelope as conditions on a fraction: first one for
 * each sieve [*n_sieve] that the feed covers, even without limits; then the
 * fineness modulus and the share retained between two sieves, if the standard
 * limits these.  All questions about an envelope get its limits here; they
 * point into it.  Returns false if the modulus is limited, but the feed's
 * sieves do not reach far enough for it. */
bool envelope_limits_to_conditions(const struct spec *spec,
    const struct fraction *fraction, const struct psd *feed,
    struct condition_list *list, size_t *n_sieve);

/* Sets the error that the feed covers none of the envelope's sieves.  Returns
 * false. */
bool envelope_set_error_no_sieve(const struct spec *spec, struct error *error);

/* The comparison of a fraction with an envelope.  A passing that rounds to
 * 100.0 % meets a limit of 100 %, because no screen is perfect. */
struct grading {
	const struct spec *spec;
	struct fraction fraction;
	/* The limits (envelope_limits_to_conditions); the first n_sieve are on
	 * sieves. */
	struct condition_list limits;
	size_t n_sieve;
	/* The fineness modulus that the standard defines, or NULL. */
	const struct modulus *modulus;
	/* The limits as conditions; its forecast also has the fraction's share
	 * of the product and, if there is one, the modulus. */
	struct conditions_search conditions;
};

/* Returns the fraction that an envelope's limits apply to: that of a question
 * or, if cut, the option of the call, is NULL, the envelope's own. */
struct fraction envelope_fraction(
    const struct spec *spec, const char *cut, const struct fraction *asked);

/* Opens the comparison of that fraction with an envelope. */
bool envelope_open_grading(const struct session *s, const char *cut,
    const struct spec *spec, const struct question *q, struct grading *grading,
    struct error *error);

/* As envelope_open_grading, for the envelope that `spec use` chose, with its
 * own fraction, ideal screens, and the feed of a run. */
bool envelope_open_chosen_forecast(const struct session *s,
    const struct entry *entry, size_t feed, struct grading *grading,
    struct error *error);
void envelope_close(struct grading *grading);

/* Returns "ASTM C33 fine aggregate, fraction 0/4.75".  The caller frees it. */
char *envelope_title_text(const struct grading *grading);

/* Adds columns, and a row for each sieve at speed v: its limits, the passing,
 * and "ok", "above", "below" or "not known". */
void envelope_add_sieve_rows(
    struct answer *r, struct grading *grading, double v);

/* Returns which limits are missed at the forecast's speed: "outside on 2 of 7
 * sieves; worst at 4 mm: 3.1 points above max", "inside on all sieves, but
 * fineness modulus (ASTM C136) 3.15 is above 3.1", or "" if all limits hold.
 * The caller frees it. */
char *envelope_missed_limits_text(const struct grading *grading);

/* Puts inside: whether the product, or that of some speed, meets the envelope;
 * null if it meets the limits that were checked, but not all were. */
void envelope_put_inside(struct answer *r, const struct grading *g, bool met);

/* Puts worst_mm, the sieve that is furthest outside at the forecast's speed,
 * and outside_pct, by how much; null and 0 if all are inside. */
void envelope_put_worst_sieve(struct fields *o, const struct grading *grading);

/* Notes, at the forecast's speed, the fineness modulus and the largest share
 * between two sieves, if the standard limits them; then the source of the
 * limits, and what is not checked. */
void envelope_add_notes(struct answer *r, const struct grading *grading);

/* Puts the fields spec, source and cut, and the columns of
 * envelope_add_sieve_rows as lists. */
void envelope_put_fields(struct answer *r, const struct grading *grading);

#endif

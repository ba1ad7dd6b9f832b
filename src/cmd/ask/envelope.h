/* Compares the product of a site, or a fraction of it, with a grading envelope.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_ASK_ENVELOPE_H
#define TIPSPEED_CMD_ASK_ENVELOPE_H

#include <stdbool.h>

#include "cmd/ask/question.h"
#include "cmd/ask/speed_search.h"
#include "cmd/session/session.h"
#include "io/formats/spec.h"

/* Returns the envelope named by words, one that comes with the program or a
 * file, or for NULL the one chosen by `spec use`.  The session owns it.  On
 * failure, returns NULL with an error, after reporting any faults of a file. */
const struct spec *envelope_find(
    struct session *s, const char *words, struct error *error);

/* Adds the limits of an envelope as conditions on a fraction: first those of
 * its sieves that the feed covers [n_sieve], with or without limits; then the
 * fineness modulus and the share retained between two sieves, if the standard
 * limits these.  All questions about an envelope use these limits, which point
 * into it.  Returns false if the modulus is limited, but the feed's sieves do
 * not reach far enough for it. */
bool envelope_add_conditions(const struct spec *spec,
    const struct fraction *fraction, const struct psd *feed,
    struct condition_list *list, size_t *n_sieve);

/* Sets the error that the feed covers no sieve of an envelope.  Returns
 * false. */
bool envelope_error_no_sieve(const struct spec *spec, struct error *error);

/* limits: those of envelope_add_conditions on the fraction, of which the first
 * n_sieve are on sieves.  conditions: on these, then the fraction's share of
 * the product, and a fineness modulus if the standard has one, else NULL.  As
 * no screen is perfect, what rounds to 100.0 meets a limit of 100 %. */
struct grading {
	const struct spec *spec;
	struct fraction fraction;
	struct condition_list limits;
	size_t n_sieve;
	const struct modulus *modulus;
	struct conditions_search conditions;
};

/* Opens the comparison with an envelope.  The options cut, sharpness and
 * cut_size of the call describe the screens; cut=off: no screens. */
bool envelope_open(const struct session *s, const struct args *args,
    const struct spec *spec, const struct question *q, struct grading *grading,
    struct error *error);

/* As envelope_open, with the chosen envelope, its own fraction,
 * perfect screens, and the feed of a run of the entry. */
bool envelope_open_chosen(const struct session *s, const struct entry *entry,
    size_t feed, struct grading *grading, struct error *error);
void envelope_close(struct grading *grading);

/* Returns "ASTM C33 fine aggregate, fraction 0/4.75".  The caller frees it. */
char *envelope_title(const struct grading *grading);

/* Adds columns and a row for each sieve at speed v: limits, passing and "ok",
 * "above", "below" or "not known". */
void envelope_add_rows(struct answer *r, struct grading *grading, double v);

/* Returns the limits missed at the forecast's speed, "outside on 2 of 7 sieves;
 * worst at 4 mm: 3.1 points above max", "inside on all sieves, but fineness
 * modulus (ASTM C136) 3.15 is above 3.1", or "" if all limits hold.  The caller
 * frees it. */
char *envelope_missed_limits_text(const struct grading *grading);

/* Puts worst_mm, the worst sieve at that speed, and outside_pct, how far
 * outside that is; 0 if no sieve is outside. */
void envelope_put_worst_sieve(struct fields *o, const struct grading *grading);

/* Notes the fineness modulus and the steps between sieves at that speed, if the
 * standard limits them, the source of the limits, and what is not checked. */
void envelope_add_notes(struct answer *r, const struct grading *grading);

/* Puts spec, source, cut and the columns of envelope_add_rows into the answer's
 * JSON. */
void envelope_put_fields(struct answer *r, const struct grading *grading);

#endif

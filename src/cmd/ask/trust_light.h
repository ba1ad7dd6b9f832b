/* The light: the trust in an answer, and its reasons, for commands and the full
 * screen.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_ASK_TRUST_LIGHT_H
#define TIPSPEED_CMD_ASK_TRUST_LIGHT_H

#include "cmd/session/session.h"
#include "core/answer/predict.h"

/* Return the light of the answer p, or of the entry's fit if p is NULL, with
 * its reasons, to free with trust_free, or alone. */
struct trust trust_in_answer_or_fit(const struct session *s,
    const struct entry *entry, const struct prediction *p);
enum light light_of_answer_or_fit(const struct session *s,
    const struct entry *entry, const struct prediction *p);

/* trust_replace_if_worse replaces *worst by t if that is worse, and frees the
 * other; trust_worst_of_predictions returns the worst light of answers [n]. */
void trust_replace_if_worse(struct trust *worst, struct trust t);
struct trust trust_worst_of_predictions(const struct session *s,
    const struct entry *entry, const struct prediction *p, size_t n);

/* trust_at_speed returns the light of the answer at a speed with the feed of a
 * run; trust_in_words_at_speed returns, for charts, "trust at 74 m/s: amber: "
 * and the first reason.  The caller frees them. */
struct trust trust_at_speed(const struct session *s, const struct entry *entry,
    double speed, size_t feed);
char *trust_in_words_at_speed(const struct session *s,
    const struct entry *entry, double speed, size_t feed);

/* Puts the fields "trust" and "reasons". */
void trust_put_fields(struct fields *o, const struct trust *t);

/* trust_add_to_answer adds the light to the answer's fields, and a sentence
 * about it, which is a warning if the light is red;
 * trust_add_to_answer_at_speed names the speed of the light, for an answer that
 * is not the product at that speed.  Both free the light. */
void trust_add_to_answer(struct answer *r, struct trust t);
void trust_add_to_answer_at_speed(
    struct answer *r, const struct site *site, double speed, struct trust t);

/* Returns the verdict on the fit behind an answer with this light, or on the
 * fit alone, with its own light: "poor", "too few data", "nothing breaks",
 * "good" if the light is green, and "doubtful" otherwise. */
const char *verdict_on_fit(const struct entry *entry, enum light light);

/* As verdict_on_fit for a fit, but without draws from its posterior, which take
 * three times as long as the calibration.  Draws may turn "good" into
 * "doubtful". */
const char *fit_verdict_without_posterior(
    const struct session *s, const struct entry *entry);

#endif

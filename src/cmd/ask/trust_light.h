/* How far an answer holds, as commands and the full screen say it: one light
 * and its reasons.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_ASK_TRUST_LIGHT_H
#define TIPSPEED_CMD_ASK_TRUST_LIGHT_H

#include "cmd/session/session.h"
#include "core/answer/predict.h"

/* Of the entry's answer p, or for NULL of its fit; trust_free. */
struct trust light_of(const struct session *s, const struct entry *entry,
    const struct prediction *p);

/* Keeps the worse of the two and frees the other; of several answers [n] the
 * worst. */
void light_worse(struct trust *worst, struct trust t);
struct trust light_worst(const struct session *s, const struct entry *entry,
    const struct prediction *p, size_t n);

/* That of the answer at a speed with the feed of a run; in words for charts
 * "trust at 74 m/s: amber: " and the first reason, which the caller frees. */
struct trust light_at(const struct session *s, const struct entry *entry,
    double speed, size_t feed);
char *light_said_at(const struct session *s, const struct entry *entry,
    double speed, size_t feed);

/* Puts "trust" and "reasons". */
void light_put(struct fields *o, const struct trust *t);

/* These of the answer's own, and the sentence about it, a warning where it is
 * red; frees it. */
void light_show(struct answer *r, struct trust t);

/* What the fit behind an answer p, or for NULL alone, is called: "poor", "too
 * few data", "nothing breaks"; "good" where the light is green, else
 * "doubtful". */
const char *light_verdict(const struct session *s, const struct entry *entry,
    const struct prediction *p);

/* The same of a fit by what shows without draws from its posterior, which take
 * three times as long as the calibration: "good" may become "doubtful" by
 * them. */
const char *light_verdict_undrawn(
    const struct session *s, const struct entry *entry);

#endif

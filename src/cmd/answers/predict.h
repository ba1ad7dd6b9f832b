/* predict without its words, for a slider.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_ANSWERS_PREDICT_H
#define TIPSPEED_CMD_ANSWERS_PREDICT_H

#include "cmd/session/session.h"

struct question;

/* Predicts as the command `predict` that the line is, and says nothing: the
 * session keeps the answer, the journal the line, and the value is for whoever
 * shows it.  False where there is nothing to predict with. */
bool predict_step(struct session *s, double speed, size_t feed_run,
    const char *line, struct prediction *p, struct error *error);

/* The most, 0..1, by which the feeds as they were sampled move the answer at
 * sieve i: how far tomorrow's feed may be from the mean is another question
 * than the band's.  0 where the site has one feed, or another was given. */
double predict_feeds_move(const struct session *s, const struct question *q,
    const struct prediction *at, size_t i);

/* How sure the answer is, in one sentence about one passing (D22); NULL of a
 * screened fraction, and without draws.  The caller frees. */
char *predict_sure(const struct session *s, const struct question *q,
    const struct prediction *p);

#endif

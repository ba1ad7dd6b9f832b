/* predict without its text, for a slider.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_ANSWERS_PREDICT_H
#define TIPSPEED_CMD_ANSWERS_PREDICT_H

#include "cmd/session/session.h"

struct question;

/* Runs the `predict` command in `line` without producing its text, for the site
 * in use as given by question_standing.  The session keeps the answer, the
 * journal keeps the line, and *p gets the prediction (prediction_free).  False
 * where there is nothing to predict with. */
bool predict_step(struct session *s, const struct entry *entry, double speed,
    size_t feed_run, const char *line, struct prediction *p,
    struct error *error);

/* Returns the most by which the feeds as they were sampled move a quantity, in
 * its own unit, from its value at a speed, m/s; how far tomorrow's feed may be
 * from the mean is a question that the band does not answer.  0 if the site has
 * one feed, or another was given. */
double predict_feeds_move(const struct session *s, const struct question *q,
    const struct quantity *of, double speed, double value);

/* Returns "8 times in 10" or "with 95 % probability".  The caller frees. */
char *predict_chance(double level);

/* Returns a sentence on how sure the answer is at one passing (D22); NULL for a
 * screened fraction, and without draws.  The caller frees. */
char *predict_sure(const struct session *s, const struct question *q,
    const struct prediction *p);

#endif

/* The command predict without its text, for a slider.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_ANSWERS_PREDICT_H
#define TIPSPEED_CMD_ANSWERS_PREDICT_H

#include "cmd/session/session.h"

struct question;

/* Runs the `predict` command in `line` without producing its text, for the
 * current site from question_site_with_feed_setting.  Keeps the answer in the
 * session and the line in the journal, and sets *p; free that with
 * prediction_free. Returns false if there is no basis for a prediction. */
bool predict_for_slider(struct session *s, const struct entry *entry,
    double speed, size_t feed_run, const char *line, struct prediction *p,
    struct error *error);

/* Finds the range of a quantity, in its own unit, at a speed, m/s, over the
 * feeds of the runs, or that of its change from another speed (from; NAN for
 * none): range out.  Returns false if the site has one feed, if the question
 * gives another, or if no curve reaches the quantity. */
bool predict_range_over_feeds(const struct session *s, const struct question *q,
    const struct quantity *of, double from, double speed,
    double range[static 2]);

/* Returns the largest change of a quantity, in its own unit, at a speed, m/s,
 * when the question's feed is replaced with a sampled one: the band does not
 * include changes of the feed.  Returns 0 if the site has one feed or the
 * question gives another. */
double predict_largest_change_by_feed(const struct session *s,
    const struct question *q, const struct quantity *of, double speed);

/* Returns "8 times in 10" or "with 95 % probability".  The caller frees it. */
char *predict_probability_words(double level);

/* Returns a sentence on the certainty of the answer for a quantity at a speed,
 * m/s, and on what a new belt cut may show (D22), or NULL without draws or
 * where the curve does not reach.  The caller frees it. */
char *predict_certainty_words(const struct session *s, const struct question *q,
    const struct quantity *of, double speed);

/* True if it is worth saying what corrects the model. */
bool predict_should_say_correction(
    const struct session *s, const struct entry *entry);

#endif

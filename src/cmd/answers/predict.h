/* predict for a slider, and sentences of predict that other commands show.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_ANSWERS_PREDICT_H
#define TIPSPEED_CMD_ANSWERS_PREDICT_H

#include "cmd/session/session.h"

struct question;

/* Does what the predict command in `line` does, but shows nothing.  entry: as
 * from question_site_with_feed_setting.  Keeps the prediction in the session
 * and the line in the journal, and sets *p, which the caller frees with
 * prediction_free.  Returns false with an error if the site has no
 * parameters. */
bool predict_at_screen_speed(struct session *s, const struct entry *entry,
    double speed, size_t feed_run, const char *line, struct prediction *p,
    struct error *error);

/* Sets range to the smallest and largest value of a quantity, in its own unit,
 * at a speed, m/s, when each run's feed is used in turn; or, unless `from` is
 * NAN, to the range of its change from that speed.  Returns false if the site
 * has only one feed, if the question brings another, or if no curve reaches the
 * quantity. */
bool predict_value_range_over_feeds(const struct session *s,
    const struct question *q, const struct quantity *of, double from,
    double speed, double range[static 2]);

/* Returns the most by which a quantity, in its own unit, changes at a speed,
 * m/s, if the feed of a run replaces the question's feed: the band does not
 * include changes of the feed.  Returns 0 if the site has only one feed or the
 * question brings another. */
double predict_largest_change_by_feed(const struct session *s,
    const struct question *q, const struct quantity *of, double speed);

/* Returns "8 times in 10" or "with 95 % probability".  The caller frees it. */
char *predict_probability_text(double level);

/* Returns a sentence with the bands of a quantity at a speed, m/s: that of the
 * answer and that of a new belt cut (D22).  light: of the answer.  Returns NULL
 * if there are no draws or the curve does not reach the quantity.  The caller
 * frees it. */
char *predict_certainty_text(const struct session *s, const struct question *q,
    const struct quantity *of, double speed, enum light light);

#endif

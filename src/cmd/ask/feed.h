/* The feed of a question, and its name.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_ASK_FEED_H
#define TIPSPEED_CMD_ASK_FEED_H

#include <stdbool.h>

#include "base/error.h"
#include "core/psd/site.h"
#include "io/formats/answer.h"

/* Returns the run with the feed sampled at a speed, m/s, for site_feed_of_run,
 * or SITE_MEAN_FEED for 0 and for a speed without a feed. */
size_t feed_run_at_speed_or_mean(const struct site *site, double speed);

/* The same for a feed that must exist: returns false with an error if none was
 * sampled at the speed. */
bool feed_find_run_at_speed(
    const struct site *site, double speed, size_t *feed, struct error *error);

/* Returns the speed at which the run's feed was sampled, m/s, or NAN for the
 * mean of several and for the feed of another sheet. */
double feed_sampling_speed(const struct site *site, size_t run);

/* Returns "mean of those sampled at 69, 74, 79 m/s, which differ by up to 5.6
 * points at 8 mm", or "sampled at 69 m/s"; NULL if the site has only one feed
 * or the feed is from another sheet, which titles name.  The caller frees
 * it. */
char *feed_sampling_text(const struct site *site, size_t run);

/* Adds the note "feed: ", or "feed of tierp: " for one of two products (whose),
 * with the words of feed_sampling_text, which also become the answer's field
 * "feed"; if moved > 0, adds how far measured products are moved (struct
 * question). */
void feed_note_in_answer(struct answer *r, const struct site *site, size_t run,
    const char *whose, double moved);

/* Notes, like feed_note_in_answer, the size that all of the site's feeds are
 * assumed to pass, if there is one; without whose, also as assumed_top_mm. */
void feed_note_assumed_top_size(
    struct answer *r, const struct site *site, const char *whose);

/* Names the size that all of the feed is assumed to pass, if there is one, and
 * the line that assumes another. */
void feed_note_other_top_size(struct answer *r, const struct site *site);

#endif

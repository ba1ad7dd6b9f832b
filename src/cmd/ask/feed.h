/* The feed of a question, and its name.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_ASK_FEED_H
#define TIPSPEED_CMD_ASK_FEED_H

#include <stdbool.h>

#include "base/error.h"
#include "core/psd/site.h"
#include "io/formats/answer.h"

/* Returns the run with the feed sampled at a speed, m/s, for site_feed;
 * SITE_MEAN_FEED for 0 and for a speed without a feed. */
size_t feed_sampled_at(const struct site *site, double speed);

/* The same of a feed that has to be there: false with an error where none was
 * sampled at the speed. */
bool feed_find_sampled(
    const struct site *site, double speed, size_t *feed, struct error *error);

/* Returns the speed at which that feed was sampled, m/s; NAN for the mean of
 * several, and for another sheet's. */
double feed_speed(const struct site *site, size_t run);

/* Returns "mean of those sampled at 69, 74, 79 m/s, which differ by up to 5.6
 * points at 8 mm", or "sampled at 69 m/s"; NULL if the site has only one feed,
 * or it is of another sheet, which titles name.  The caller frees. */
char *feed_words(const struct site *site, size_t run);

/* Adds the note "feed: " and the words of feed_words, which are also the
 * answer's key feed; for one of two products (whose) "feed of tierp: "; and if
 * moved > 0 by how much measured products are moved, see struct question. */
void feed_note(struct answer *r, const struct site *site, size_t run,
    const char *whose, double moved);

/* Notes, as feed_note, what size all of the site's feeds were assumed to pass,
 * if any was; without whose its key is assumed_top_mm. */
void feed_note_assumed(
    struct answer *r, const struct site *site, const char *whose);

/* Returns a path without its folders, for titles; borrowed. */
const char *feed_file(const char *path);

#endif

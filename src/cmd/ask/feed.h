/* The feed that a question has, and how it is called.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_ASK_FEED_H
#define TIPSPEED_CMD_ASK_FEED_H

#include <stdbool.h>

#include "core/psd/site.h"
#include "io/formats/answer.h"

/* The run whose feed was sampled at a speed, m/s, for site_feed; SITE_MEAN_FEED
 * of 0 and of a speed without one. */
size_t feed_at(const struct site *site, double speed);

/* The speed at which that feed was sampled, m/s; NAN of the mean of several,
 * and of another sheet's. */
double feed_speed(const struct site *site, size_t run);

/* "mean of those sampled at 69, 74, 79 m/s, which differ by up to 5.6 points
 * at 8 mm", "sampled at 69 m/s"; NULL where there is only one, or it is of
 * another sheet, which titles say.  The caller frees. */
char *feed_words(const struct site *site, size_t run);

/* Says it below an answer, "feed: " and those words, which are its key feed; of
 * one of two products (whose) "feed of tierp: "; and where moved > 0 by how
 * much, see struct question. */
void feed_note(struct answer *r, const struct site *site, size_t run,
    const char *whose, double moved);

/* Says what size all of its feeds were assumed to pass, if any was, as
 * feed_note; without whose its key is assumed_top_mm. */
void feed_note_assumed(
    struct answer *r, const struct site *site, const char *whose);

/* A path without its folders, for titles; borrowed. */
const char *feed_file(const char *path);

#endif

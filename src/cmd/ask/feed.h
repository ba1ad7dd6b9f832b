/* The feed of a question, and how it is named.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_ASK_FEED_H
#define TIPSPEED_CMD_ASK_FEED_H

#include <stdbool.h>

#include "base/error.h"
#include "core/psd/site.h"
#include "io/formats/answer.h"

/* Returns the run whose feed was sampled at a speed, m/s, for site_feed_of_run;
 * SITE_MEAN_FEED if the speed is 0 or no feed was sampled at it. */
size_t feed_run_at_speed_or_mean(const struct site *site, double speed);

/* As feed_run_at_speed_or_mean, but the feed must exist: returns false with an
 * error if none was sampled at the speed. */
bool feed_find_run_sampled_at_speed(
    const struct site *site, double speed, size_t *feed, struct error *error);

/* Returns the speed at which the feed of a run was sampled, m/s; NAN for the
 * mean of several feeds and for the feed of another sheet. */
double feed_sampling_speed(const struct site *site, size_t run);

/* Returns "mean of those sampled at 69, 74, 79 m/s, which differ by up to 5.6
 * points at 8 mm" or "sampled at 69 m/s".  NULL if the site has only one feed,
 * or if the feed is from another sheet, because then the title names it.  The
 * caller frees it. */
char *feed_sampling_text(const struct site *site, size_t run);

/* Notes feed_sampling_text after "feed: ", also as the field "feed"; or after
 * "feed of tierp: " if `whose` names the owner of one of two products.  If
 * moved > 0, adds how far measured products are moved (struct question). */
void feed_add_note_to_answer(struct answer *r, const struct site *site,
    size_t run, const char *whose, double moved);

/* If a size is assumed that all of the site's feeds pass, notes it, for `whose`
 * as feed_add_note_to_answer does; if that is NULL, also as the field
 * assumed_top_mm. */
void feed_note_assumed_top_size(
    struct answer *r, const struct site *site, const char *whose);

/* If a size is assumed that all of the feed passes, notes it and the line to
 * type for another. */
void feed_note_how_to_set_top_size(struct answer *r, const struct site *site);

#endif

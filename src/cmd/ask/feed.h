/* The feed that a question has, and how it is called.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_ASK_FEED_H
#define TIPSPEED_CMD_ASK_FEED_H

#include <stdbool.h>

#include "cmd/lang/command.h"
#include "core/psd/site.h"
#include "io/formats/answer.h"

/* The run whose feed to take, for site_feed: that sampled at the speed which
 * the option feed names, else SITE_MEAN_FEED, which is the feed of another
 * sheet where the call asks with one (cmd/ask/scenario.h). */
bool feed_choose(const struct site *site, const struct args *args, size_t *run,
    struct error *error);

/* The same of a speed, m/s: 0 or a speed without a feed is the mean. */
size_t feed_at(const struct site *site, double speed);

/* The speed at which that feed was sampled, m/s; NAN of the mean of several,
 * and of another sheet's. */
double feed_speed(const struct site *site, size_t run);

/* "mean of those sampled at 69, 74, 79 m/s, which differ by up to 5.6 points
 * at 8 mm", "sampled at 69 m/s"; NULL where there is only one, or it is of
 * another sheet, which titles say.  The caller frees. */
char *feed_words(const struct site *site, size_t run);

/* Says it below an answer, "feed: " and those words, which are its key feed. */
void feed_note(struct answer *r, const struct site *site, size_t run);

#endif

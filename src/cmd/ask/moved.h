/* Measured products moved to the feed of an answer, to be shown beside it.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_ASK_MOVED_H
#define TIPSPEED_CMD_ASK_MOVED_H

#include "cmd/session/session.h"

/* Where runs have feeds of their own, what was measured at a speed and what is
 * predicted there differ by the feeds too.  Moved (D19) it is
 *   measured + P(feed of the answer, v) - P(feed of the run, v)
 * with P the answer at the run's speed v, so that its distance from the
 * answer's curve is the misfit.  What is compared with a measurement, as by
 * validate, is never moved. */
struct moved;

/* A larger move, 0..1, is told beside a picture. */
#define MOVED_TOLD 0.003

struct moved *moved_new(void);
void moved_free(struct moved *moved);

/* Discards what is kept; call it when a site is removed. */
void moved_forget(struct moved *moved);

/* Returns the product of a run moved to a feed, see site_feed, with these
 * parameters; as measured where there are none (NULL), where the feeds are the
 * same, and at sieves that the run's feed lacks.  Borrowed, until another site,
 * feed or other parameters are asked for. */
const struct psd *moved_product(const struct session *s,
    const struct entry *entry, const struct params *params, size_t run,
    size_t feed_run);

/* Returns the largest move of a passing of that product, 0..1; 0 with another
 * sheet's feed or another machine, beside which no measured product is
 * shown. */
double moved_largest(const struct session *s, const struct entry *entry,
    const struct params *params, size_t run, size_t feed_run);

#endif

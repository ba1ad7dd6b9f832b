/* Measured products moved to the feed of an answer, to be shown with it.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_ASK_MOVED_H
#define TIPSPEED_CMD_ASK_MOVED_H

#include "cmd/session/session.h"

struct quantity;

/* If runs have individual feeds, the measured and the predicted product at a
 * speed also differ because of their feeds.  Moved (D19), the measured product
 * is
 *   measured + P(feed of the answer, v) - P(feed of the run, v)
 * with P the answer at the run's speed v; its distance from the answer's curve
 * is then the misfit.  Comparisons with measurements, as in validate, never
 * move them. */
struct moved;

/* A larger move, 0..1, is mentioned beside a plot. */
#define MOVED_TOLD 0.003

struct moved *moved_products_new(void);
void moved_products_free(struct moved *moved);

/* Discards cached products; call it when a site is removed. */
void moved_products_discard(struct moved *moved);

/* Returns the product of a run moved to a feed (see site_feed_of_run) with
 * these parameters.  It is unchanged if params is NULL or the feeds are the
 * same, and at sieves that the run's feed lacks.  Valid until the next call
 * with another site, feed or parameters. */
const struct psd *product_moved_to_feed(const struct session *s,
    const struct entry *entry, const struct params *params, size_t run,
    size_t feed_run);

/* Returns the largest move of a passing of that product, 0..1; 0 for a feed
 * from another sheet or another machine, with which no measured product is
 * shown. */
double largest_move_to_feed(const struct session *s, const struct entry *entry,
    const struct params *params, size_t run, size_t feed_run);

/* Returns what was measured of a quantity at a speed, as shown, the mean of
 * repeats, moved to a feed; NAN if nothing was, or with another
 * feed or machine.  Raises *moved to the largest move of a passing.  n: number
 * of these runs, out. */
double measured_mean_at_speed(const struct session *s,
    const struct entry *entry, size_t feed_run, const struct quantity *of,
    double speed, double *moved, size_t *n);

#endif

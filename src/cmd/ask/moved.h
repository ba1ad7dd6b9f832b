/* Measured products moved to the feed of an answer, to be shown beside it.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_ASK_MOVED_H
#define TIPSPEED_CMD_ASK_MOVED_H

#include "cmd/session/session.h"

struct quantity;

/* If runs have feeds of their own, a measured product also differs from the
 * predicted one because its feed does.  The measured product moved to the feed
 * of the answer (D19) is
 *   measured + P(feed of the answer, v) - P(feed of the run, v)
 * with P the answer at the run's speed v.  Its distance from the answer's curve
 * is then the misfit.  Comparisons with measurements, such as validate, never
 * move them. */
struct moved;

/* Moves larger than this passing, 0..1, are mentioned beside a plot. */
#define MOVED_MENTIONED 0.003

struct moved *moved_products_new(void);
void moved_products_free(struct moved *moved);

/* Discards the cached products.  Call it when a site is removed. */
void moved_products_discard(struct moved *moved);

/* Returns the product of a run, moved to a feed (for site_feed_of_run) with
 * these parameters.  It is not moved if params is NULL or the feeds are the
 * same, nor at sieves that the run's feed lacks.  Valid until the next call
 * with another site, feed or parameters. */
const struct psd *measured_product_moved_to_feed(const struct session *s,
    const struct entry *entry, const struct params *params, size_t run,
    size_t feed_run);

/* Returns the largest change of a passing by that move, 0..1; 0 for a feed from
 * another sheet or for another machine, as no measured product is shown with
 * those. */
double largest_change_by_moving_to_feed(const struct session *s,
    const struct entry *entry, const struct params *params, size_t run,
    size_t feed_run);

/* Returns the measured value of a quantity at a speed, moved to a feed and
 * averaged over repeats, in the unit shown; NAN if none was measured, or if the
 * feed or the machine is another.  Sets *n to the number of runs, and raises
 * *moved to the largest change of a passing. */
double measured_mean_quantity_at_speed(const struct session *s,
    const struct entry *entry, size_t feed_run, const struct quantity *of,
    double speed, double *moved, size_t *n);

#endif

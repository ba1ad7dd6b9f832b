/* Thinning: a few draws that represent many.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_POSTERIOR_THIN_H
#define TIPSPEED_CORE_POSTERIOR_THIN_H

#include <stddef.h>

#include "core/posterior/draws.h"
#include "core/psd/site.h"

/* Candidates come in batches of POSTERIOR_DRAWS; POSTERIOR_DRAWS of them are
 * kept.  thin_free. */
struct thin;
struct thin *thin_new(const struct site *site, size_t batches);
void thin_free(struct thin *t);

/* Adds the next batch by its answers at five speeds, from the slowest to the
 * fastest of site_reach, at sieves of the site. */
void thin_add(struct thin *t, const struct posterior *batch);

/* Chooses the draws to keep: their indices out, counted from the first batch
 * on, half of them from the first half of the batches.  They have the mean
 * answers of all draws, and at each end of the usual band the same share of
 * answers on either side as all draws. */
void thin_choose(struct thin *t, size_t chosen[static POSTERIOR_DRAWS]);

/* Sets the share of the draws kept that are straight (straight.h), for the same
 * feed and sieves. */
void thin_set_straight(const struct thin *t, struct posterior *p);

#endif

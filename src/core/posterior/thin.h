/* A few draws that stand for many.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_POSTERIOR_THIN_H
#define TIPSPEED_CORE_POSTERIOR_THIN_H

#include <stddef.h>

#include "core/posterior/draws.h"
#include "core/psd/site.h"

/* Candidates come in batches of POSTERIOR_DRAWS, of which in the end one is
 * left.  thin_free. */
struct thin;
struct thin *thin_new(const struct site *site, size_t batches);
void thin_free(struct thin *t);

/* The answers of the next batch at three speeds, from the slowest to the
 * fastest that is looked at, at sieves of the site. */
void thin_add(struct thin *t, const struct posterior *batch);

/* The numbers of those that are left, counted from the first batch on, half of
 * them from the first half of the batches: their mean answers, and how many
 * answers lie beside the ends of the usual band, are those of all. */
void thin_choose(struct thin *t, size_t chosen[static POSTERIOR_DRAWS]);

/* Sets what the straight line counts in the draws left (straight.h), of the
 * same feed and sieves. */
void thin_look(const struct thin *t, struct posterior *p);

#endif

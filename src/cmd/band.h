/* How far a fit and its products are open: draws kept with the entry.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_BAND_H
#define TIPSPEED_CMD_BAND_H

#include "cmd/session.h"
#include "core/predict.h"

/* The draws of the fit that found the entry's parameters, on this site or
 * another one, made when first asked for; NULL where no calibration of this
 * session found them, or one of too few data, or where session.stop said so
 * meanwhile. */
const struct uncertainty *band_draws(const struct entry *entry);

/* The band of the entry's prediction, borrowed until the next one is asked for.
 * NULL where band_draws is, or for a fit made with other settings.  The last
 * one is kept: who predicts, who draws and who shows numbers ask for the
 * same. */
const struct band *band_at(const struct session *s, const struct entry *entry,
    const struct prediction *p);

/* Why there is none: "no band: parameters ..".  Not to be asked where there is
 * one. */
const char *band_why_none(const struct entry *entry);

/* Says what low and high are: of another site's parameters they are what its
 * data leave open, and know nothing of the difference between the two. */
void band_note(struct answer *r, const struct entry *entry);

/* Puts "interval": {"beta1":[low, high], .. "alpha":[low, high]}, or null where
 * there is none. */
void band_put_interval(struct fields *o, const struct uncertainty *u);

/* Puts the ranges of the sizes. */
void band_put(struct fields *o, const struct band *band);

#endif

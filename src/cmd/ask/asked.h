/* A question: about which site, with which feed and machine, at which speed,
 * about which part of the product, and what informs the answer.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_ASK_ASKED_H
#define TIPSPEED_CMD_ASK_ASKED_H

#include "cmd/session/session.h"
#include "core/psd/screening.h"

/* entry: the site that is asked about.  If the question changes the feed, the
 * machine, the sieves or the runs that correct the model, entry points to
 * `own`, a copy with these changes, which `variant` describes; so do not copy a
 * question.  feed: for site_feed.  speed: m/s; speed_given: the call named it.
 * at [n_at]: speeds of a command that answers at several, borrowed.  level: of
 * bands, 0..1.  fraction: all zeros for the whole product.  params: those that
 * form the product (NULL: the entry's); with any others the answer is that of
 * the model alone.  moved: how far measured products beside the answer are
 * moved to its feed, 0..1, see cmd/ask/moved.h; 0 if too little to mention. */
struct question {
	const struct entry *entry;
	const struct params *params;
	size_t feed;
	double speed;
	bool speed_given;
	size_t n_at;
	const double *at;
	double level;
	struct fraction fraction;
	double moved;
	struct entry own;
	struct variant variant;
	struct named *named; /* what the call named */
};

/* Returns the question about the whole product of an entry as it is, with the
 * feed of a run; it owns nothing. */
struct question asked_whole(
    const struct session *s, const struct entry *entry, size_t feed);

#endif

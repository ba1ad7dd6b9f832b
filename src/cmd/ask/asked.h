/* A question: the site, feed, machine, speed and part of the product that it is
 * about, and the runs that inform the answer.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_ASK_ASKED_H
#define TIPSPEED_CMD_ASK_ASKED_H

#include "cmd/session/session.h"
#include "core/psd/screening.h"

/* entry: the site.  If the question changes the feed, the machine, the sieves
 * or the runs that correct the model, entry points to `changed`, a copy with
 * the changes of the scenario; so a question must not be copied.  feed: for
 * site_feed_of_run.  speed: m/s; speed_given: the call named it.  at [n_at]:
 * the speeds, for a command that answers at several, borrowed.  level: of
 * bands, 0..1.  fraction: all zeros for the whole product.  params: the
 * parameters of the product (NULL: the entry's); with others, the answer is
 * that of the model alone.  moved: how far measured products shown with the
 * answer are moved to its feed, 0..1, see cmd/ask/moved.h; 0 if too little to
 * mention. */
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
	struct scenario scenario;
	struct entry changed;
	/* Owned: the site of `changed`, and what the call named. */
	struct site *site;
	struct blended *blend;
	double *sieves, *speeds;
};

/* Returns the question about the whole product of an unchanged entry with the
 * feed of a run.  It owns nothing. */
struct question question_of_whole_product(
    const struct session *s, const struct entry *entry, size_t feed);

/* Keeps what was asked about.  of: the quantity that was named, or NULL.  A
 * step between sieves, which borrows these, is not kept. */
void session_keep_last_asked(
    struct session *s, double speed, const struct quantity *of);

#endif

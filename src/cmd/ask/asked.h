/* A question: which site, feed, machine, speed and part of the product it is
 * about, and which runs correct the model.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_ASK_ASKED_H
#define TIPSPEED_CMD_ASK_ASKED_H

#include "cmd/session/session.h"
#include "core/psd/screening.h"

/* A question.  Do not copy it: entry may point into it. */
struct question {
	/* The site.  If the question changes the feed, the machine, the sieves
	 * or the runs that correct the model, this points to `changed`. */
	const struct entry *entry;
	/* The parameters, or NULL for those of the entry.  With others, the
	 * answer is that of the model alone. */
	const struct params *params;
	/* For site_feed_of_run. */
	size_t feed;
	/* In m/s; speed_given: the call names it. */
	double speed;
	bool speed_given;
	/* The speeds, m/s [n_at], if a command answers at several; borrowed. */
	size_t n_at;
	const double *at;
	/* The probability of bands, 0..1. */
	double level;
	/* All zeros for the whole product. */
	struct fraction fraction;
	/* How far measured products are moved to the answer's feed to be shown
	 * beside it (cmd/ask/moved.h), 0..1; 0 if too little to mention. */
	double moved;
	/* The changes, and a copy of the entry with them. */
	struct scenario scenario;
	struct entry changed;
	/* Owned: the site of `changed`, and what the call named. */
	struct site *site;
	struct blended *blend;
	double *sieves, *speeds;
};

/* Returns the question about the whole product of an entry, without changes,
 * with the feed of a run.  It owns nothing. */
struct question question_of_whole_product(
    const struct session *s, const struct entry *entry, size_t feed);

/* Keeps the speed that was last asked about and, unless NULL, the quantity that
 * was named.  A step between sieves is not kept, because it borrows them. */
void session_set_last_question(
    struct session *s, double speed, const struct quantity *of);

#endif

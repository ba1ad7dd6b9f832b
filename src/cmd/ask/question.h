/* Questions as calls put them.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_ASK_QUESTION_H
#define TIPSPEED_CMD_ASK_QUESTION_H

#include "cmd/ask/asked.h"
#include "cmd/ask/blended.h"
#include "cmd/lang/command.h"
#include "cmd/session/session.h"

/* What is asked otherwise than the site is loaded.  feed: NULL for its own;
 * rotor: m, 0: not given; rpm likewise; bypass: 0..1; k: 0: as set.
 * sieve [n_sieve]: sieves to show, m, coarsest first. */
struct scenario {
	const struct blended *feed;
	double rotor, rpm, bypass, k;
	enum correction correction;
	size_t n_sieve;
	const double *sieve;
};

/* Reads the options of SHARED_... (table_shared.c) that the command has, of
 * the site in use or of a loaded one.  It is the only place that chooses a feed
 * or a machine.  question_free, also where it is false. */
bool question_read(struct session *s, const struct args *args,
    struct question *q, struct error *error);
bool question_of(struct session *s, const struct entry *loaded,
    const struct args *args, struct question *q, struct error *error);

/* The same question about another loaded site, of which nothing is read
 * again. */
bool question_too(struct session *s, const struct entry *loaded,
    const struct args *args, const struct question *like, struct question *q,
    struct error *error);

/* Reads the question of a call, has it answered, and frees it. */
bool question_run(struct session *s, const struct args *args,
    command_answer *answer, struct error *error);

/* The question about a loaded site as it stands, with the mean of its feeds, or
 * as the scenario has it. */
void question_make(const struct session *s, const struct entry *loaded,
    const struct scenario *scenario, struct question *q);

/* Without a speed the speed and the feed last predicted at the site in use are
 * asked about, where there are any. */
void question_as_last(
    const struct session *s, const struct args *args, struct question *q);

void question_free(struct session *s, struct question *q);

/* The feed itself. */
const struct psd *question_feed(const struct question *q);

#endif

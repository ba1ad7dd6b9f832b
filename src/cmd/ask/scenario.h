/* Another feed or another machine than what was measured, for one command.
 *
 * While it runs, every loaded site is a copy that has them, so that whatever
 * the command asks is answered with them: outlook.c takes the machine from the
 * entry, feed_choose the feed, light.c has the reasons, and the copy's `with`
 * tells them in every title.  Afterwards all is as before.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_ASK_SCENARIO_H
#define TIPSPEED_CMD_ASK_SCENARIO_H

#include "cmd/lang/command.h"
#include "cmd/session/session.h"

/* What is asked for.  feed: borrowed, NULL for the sites' own; from: where it
 * is from, for programs; words: for people; of: what its sheet says of its
 * data; rock: or "".  rotor: m, rpm, 0: not given.  bypass: 0..1; k: 0: as
 * set.  sieve [n_sieve]: sieves to show, m, coarsest first. */
struct variant_wish {
	const struct psd *feed;
	const char *from, *words, *of, *rock;
	double rotor, rpm, bypass, k;
	size_t n_sieve;
	const double *sieve;
};

/* Makes the copies; variant_end drops them.  Only one at a time, and nothing is
 * loaded or dropped meanwhile. */
void variant_begin(struct session *s, const struct variant_wish *wish);
void variant_end(struct session *s);

/* Runs a command with what its options feed, rpm, rotor_mm, cascade, k and
 * sieves ask for, as far as it has them; rpm becomes its speed. */
bool variant_run(struct session *s, struct args *args, struct error *error);

/* A path without its folders, for titles; borrowed. */
const char *variant_file(const char *path);

#endif

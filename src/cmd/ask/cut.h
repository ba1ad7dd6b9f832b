/* A belt cut beside what is predicted for it.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_ASK_CUT_H
#define TIPSPEED_CMD_ASK_CUT_H

#include "cmd/session/session.h"

/* Over the sieves of a run's product that crushing can change, [n]: root mean
 * square of measured less predicted, and the largest of these with its sieve,
 * m.  inside: sieves within the band of one more sample; no_band: there is
 * none.  level: of it, 0..1.  missed: the prediction does not hold; off: it
 * does as far as careful samples repeat, though most sieves lie outside the
 * band. */
struct cut {
	size_t n, inside;
	bool no_band, missed, off;
	double rms, worst, worst_sieve, level;
};

/* Of a run of the entry, which has parameters. */
struct cut cut_compare(
    const struct session *s, const struct entry *entry, size_t run);

/* Whether both have the same product at the same speed. */
bool cut_is_same(const struct run *a, const struct run *b);

/* The note "72 m/s, 2026-05-03 10:15, cut.csv" in the site's header that is of
 * this run, borrowed, or NULL: those of a speed are of its last runs, in one
 * order. */
const char *cut_heading(const struct site *site, size_t run);

/* "0.8 points (RMS of 12 sieves; largest +1.9 at 4 mm, measured less
 * predicted), 11 of 12 sieves within the 80 % band".  The caller frees. */
char *cut_words(const struct cut *cut);

/* What came to the site after the calibration that its parameters are from:
 * how many runs with a product, and the one that they miss by most; n is 0 for
 * none. */
struct later cut_later(const struct session *s, const struct entry *entry);

/* Whether the site has one product, and parameters from elsewhere: then it is
 * the only check there is, and *run has it. */
bool cut_is_only_check(const struct entry *entry, size_t *run);

#endif

/* Compares a belt cut with its prediction.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_ASK_CUT_H
#define TIPSPEED_CMD_ASK_CUT_H

#include "cmd/session/session.h"

/* Over the sieves of a run's product that crushing can change, [n]: root mean
 * square of predicted less measured, and the largest of these with its sieve,
 * m.  inside: sieves within the band of one more sample; no_band: there is
 * none.  level: of it, 0..1.  missed: the prediction does not hold; off: most
 * sieves lie outside the band, but no farther than careful samples differ. */
struct cut {
	size_t n, inside;
	bool no_band, missed, off;
	double rms, worst, worst_sieve, level;
};

/* Compares a run of the entry, which has parameters. */
struct cut cut_compare(
    const struct session *s, const struct entry *entry, size_t run);

/* True if both have the same product at the same speed. */
bool cut_is_same(const struct run *a, const struct run *b);

/* Returns the note "72 m/s, 2026-05-03 10:15, cut.csv" in the site's header
 * that describes this run, borrowed, or NULL.  The notes of a speed belong to
 * its last runs, in the same order. */
const char *cut_heading(const struct site *site, size_t run);

/* Returns "0.8 points (RMS of 12 sieves; largest +1.9 at 4 mm, answer -
 * measured), 11 of 12 sieves within the 80 % band".  The caller frees. */
char *cut_words(const struct cut *cut);

/* Returns what was added to the site after the calibration that its parameters
 * are from: how many runs with a product, and the run that they miss by most; n
 * is 0 for none. */
struct later cut_compare_later(
    const struct session *s, const struct entry *entry);

/* True if the site has one product, and parameters from elsewhere; *run, which
 * has it, is then the only check there is. */
bool cut_is_only_check(const struct entry *entry, size_t *run);

#endif

/* A first guess for an uncalibrated site, from materials of other sites.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_ANSWER_GUESS_H
#define TIPSPEED_CORE_ANSWER_GUESS_H

#include <stdbool.h>
#include <stddef.h>

#include "core/model/params.h"
#include "core/psd/psd.h"
#include "core/psd/site.h"

/* A material to guess from, or the site to guess for, whose params are not
 * used.  rock: "" if not known; top_size: m, 0 if not known.  settings: those
 * with which the parameters were found.  law_open: beta is not known, because
 * Table 3 does not print it.  Strings are borrowed. */
struct guess_material {
	const char *site, *rock;
	double top_size;
	struct params params;
	struct model_settings settings;
	bool law_open;
};

/* Finds the nearest materials: those of the same rock (ignoring case and
 * accents) first, then by |ln(top size / wanted top size)|, then in the order
 * of the list.  An unknown size counts as farthest.  Of materials with
 * identical numbers (D9), only the nearest counts.
 * leave_out [n]: true for materials to ignore.  Sets pick [most] to their
 * indices, nearest first, and returns their number. */
size_t guess_find_nearest_materials(const struct guess_material *m, size_t n,
    const struct guess_material *wanted, const bool *leave_out, size_t most,
    size_t *pick);

/* A value with its 80 % band over the materials.  NAN: below the finest sieve;
 * INFINITY: the break size if nothing breaks. */
struct guess_range {
	double middle, low, high;
};

/* Curves on the same sieves: at each sieve, the median and the 80 % band of the
 * materials' products.  size: P20, P50, P80 and the break size, m; the middle
 * of the first three is read off the median curve, the last is the median.
 *
 * The band extends from rank 0.1 (n + 1) to rank 0.9 (n + 1) of n values:
 * another value of the same kind lies in it with a probability of 80 %, if n is
 * at least 9.  With fewer, the band runs from the lowest to the highest value,
 * and the probability is (n - 1) / (n + 1). */
struct guess {
	double speed; /* m/s */
	struct psd feed, median, low, high;
	struct guess_range size[PSD_SIZES + 1];
};

/* The number of laws (values of beta) that represent an unknown beta, from
 * coarse to fine progeny: 5 to 67 % of the progeny is finer than a tenth of the
 * parent (with the default beta, 14 %). */
enum { GUESS_LAWS = 8 };

/* Returns a guess from the products of the run's feed at tip speed v (m/s), one
 * for each of the n >= 1 materials picked, with its own settings; if a
 * material's law is open, one for each of GUESS_LAWS.  Cannot fail.  Free with
 * guess_free. */
struct guess guess_psd_from_materials(const struct site *site, size_t feed_run,
    const struct guess_material *m, const size_t *pick, size_t n, double v);
void guess_free(struct guess *guess);

/* The errors of such guesses: RMSE of passing, 0..1, over the sieves.  n:
 * number of guesses; worst_at: index of the material with the largest; feed:
 * median error of the guess product = feed; held: share of the passings within
 * the band, where the band has a width; nearest: number of materials used for
 * each guess. */
struct guess_error {
	size_t n, worst_at, nearest;
	double median, worst, feed, held;
};

/* Leaves one site out at a time: guesses the product of each material at v,
 * m/s, from the nearest other materials and compares it with the model's
 * product for the material's own parameters.  The feed is synthetic (synth.h, n
 * = 1).  Other materials are those of another site with different numbers; of
 * materials with identical numbers, only one is guessed.  All top sizes must be
 * known. */
struct guess_error guess_leave_one_out_error(
    const struct guess_material *m, size_t n, size_t nearest, double v);

/* Whether choosing by rock and top size improves the guess.  all: the errors of
 * guesses from all other materials; few: those of guesses from the nearest, in
 * the number with the smallest median error.  helps: the median error of few is
 * below 0.8 times that of all.  With 18 sites, the best of so many numbers
 * gains less than that by chance. */
struct guess_choice {
	struct guess_error all, few;
	bool helps;
};

struct guess_choice guess_choose_neighbour_count(
    const struct guess_material *m, size_t n, double v);

#endif

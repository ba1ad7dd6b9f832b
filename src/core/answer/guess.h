/* A first guess for a site with no calibration, from materials of other sites.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_ANSWER_GUESS_H
#define TIPSPEED_CORE_ANSWER_GUESS_H

#include <stdbool.h>
#include <stddef.h>

#include "core/model/params.h"
#include "core/psd/psd.h"
#include "core/psd/site.h"

/* A material to guess from, or the site that a guess is for, whose params are
 * not read.  rock: "" when not known; top_size m, 0 when not known.  settings:
 * with which its parameters were found.  law_open: its beta is not known, as in
 * Table 3, which prints no beta.  Text is borrowed. */
struct guess_material {
	const char *site, *rock;
	double top_size;
	struct params params;
	struct model_settings settings;
	bool law_open;
};

/* The nearest materials: the same rock (without case and accents) before any
 * other, then the smallest |ln(top size / wanted top size)|, then the order of
 * the list; an unknown size counts as the farthest.  Of materials with the same
 * numbers (departure D9) only the nearest counts.
 *   leave_out [n]: true for materials not to use
 *   pick [most]: their indices out, nearest first.  Returns how many. */
size_t guess_nearest(const struct guess_material *m, size_t n,
    const struct guess_material *wanted, const bool *leave_out, size_t most,
    size_t *pick);

/* A value with its 80 % band over the materials; NAN where it lies below the
 * finest sieve, INFINITY for a break size where nothing breaks. */
struct guess_range {
	double middle, low, high;
};

/* Curves on the same sieves: median and 80 % band, sieve by sieve over the
 * products, one for each material.  p20, p50, p80, m: middle is read off the
 * median curve.  break_size, m: middle is the median.
 *
 * The band reaches from place 0.1 (n + 1) to 0.9 (n + 1) among n values:
 * another value of their kind lies in it with a probability of 80 %, if n is 9
 * or more.  With fewer the band is the least and the most, and the probability
 * (n - 1) / (n + 1). */
struct guess {
	double speed; /* m/s */
	struct psd feed, median, low, high;
	union {
		struct {
			struct guess_range p20, p50, p80, break_size;
		};
		struct guess_range size[PSD_SIZES + 1];
	};
};

/* The number of betas that stand for an unknown one, from coarse to fine
 * progeny: 5 to 67 % of what breaks is finer than a tenth of its parent
 * (default: 14 %). */
enum { GUESS_LAWS = 8 };

/* Guesses from the products of the run's feed at tip speed v (m/s), with each
 * of the n >= 1 materials picked and its own settings; where a law is open,
 * with each of GUESS_LAWS.  Cannot fail; free with guess_free. */
struct guess guess_product(const struct site *site, size_t feed_run,
    const struct guess_material *m, const size_t *pick, size_t n, double v);
void guess_free(struct guess *guess);

/* The errors of such guesses: RMSE of passing, 0..1, over the sieves.  n: how
 * many were guessed; worst_at: index of the worst; feed: the median error of
 * the guess that product = feed; held: share of the passings that lie within
 * the band, where it has a width.  nearest: how many materials were used. */
struct guess_error {
	size_t n, worst_at, nearest;
	double median, worst, feed, held;
};

/* Leaves one site out at a time: guesses the product at v of each material from
 * the nearest others and compares it with the model's product of its own
 * parameters.  The feed is made up, synth.h with n = 1.  Others are materials
 * of another site with other numbers; of materials with the same numbers one is
 * guessed.  Each top size must be known. */
struct guess_error guess_leave_one_out(
    const struct guess_material *m, size_t n, size_t nearest, double v);

/* Whether rock and top size improve the guess.  all: the errors of guesses from
 * all others; few: those from the number of nearest materials that has the
 * smallest median error.  helps: few's median error is less than 0.8 of all's.
 * With 18 sites the best of so many numbers shows a smaller gain by chance. */
struct guess_choice {
	struct guess_error all, few;
	bool helps;
};

struct guess_choice guess_choose(
    const struct guess_material *m, size_t n, double v);

#endif

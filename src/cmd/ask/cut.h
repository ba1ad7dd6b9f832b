/* Compares a belt cut with its prediction.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_ASK_CUT_H
#define TIPSPEED_CMD_ASK_CUT_H

#include "cmd/session/session.h"
#include "io/cells/datetime.h"

/* The differences, predicted - measured passing, between a cut and its
 * prediction. */
struct cut {
	/* n: the sieves that crushing can change, to which all of this refers.
	 * inside: how many of them are in the band of one more sample. */
	size_t n, inside;
	/* missed: the prediction fails.  off: it does not fail, but most sieves
	 * are outside the band, by no more than careful samples differ, or more
	 * than a quarter are, by more. */
	bool no_band, missed, off;
	/* The RMSE; the largest difference and its sieve, m. */
	double rms, worst, worst_sieve;
};

/* Compares the product of a run with its prediction.  The entry must have
 * parameters. */
struct cut cut_compare_with_prediction(
    const struct session *s, const struct entry *entry, size_t run);

/* True if two runs have the same product at the same speed. */
bool cut_is_duplicate(const struct run *a, const struct run *b);

/* Returns the note in the site's header that describes this run, "72 m/s,
 * 2026-05-03 10:15, cut.csv", or NULL.  The site owns it.  Notes of cuts at a
 * speed belong to the last runs at that speed, in the same order. */
const struct site_note *cut_find_note(const struct site *site, size_t run);

/* Reads the date in the note of a cut, "72 m/s, 2026-05-03 10:15, cut.csv", or
 * in a header line that states one, "Date, 3 May 2026".  Returns false if there
 * is none. */
bool cut_parse_date(const struct site_note *note, struct datetime *m);

/* Returns which number is the day in the site's notes with a date such as
 * 5/11/2026, according to those that can be read in only one way; DATETIME_OPEN
 * if there are no such notes or they differ. */
enum datetime_order cut_day_month_order(const struct site *site);

/* Returns "11 of 12 sieves are within the range for a belt cut; RMSE 0.8
 * points, largest error at 4 mm, where the answer is 1.9 above the cut".  The
 * caller frees it. */
char *cut_comparison_text(const struct cut *cut);

/* Compares the products that were added to the site after its parameters were
 * calibrated: how many there are, and the one that the prediction misses by
 * most or, if it misses none, the one with the largest RMSE.  twice: one of
 * them is the same as another run. */
struct later cut_compare_runs_since_fit(
    const struct session *s, const struct entry *entry);

/* True if the site has only one product, and parameters from elsewhere: that
 * product, of *run, is the only check on them. */
bool cut_is_only_product(const struct entry *entry, size_t *run);

#endif

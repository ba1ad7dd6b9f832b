/* Compares a belt cut with its prediction.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_ASK_CUT_H
#define TIPSPEED_CMD_ASK_CUT_H

#include "cmd/session/session.h"
#include "io/cells/datetime.h"

/* The n sieves of a run's product that crushing can change: root mean square of
 * predicted - measured, and the largest of these with its sieve, m.  inside:
 * sieves within the band of one more sample; no_band: there is no band; level:
 * that of the band, 0..1.  missed: the prediction fails; off: most sieves are
 * outside the band, but by no more than careful samples differ, or some are
 * outside by more than that. */
struct cut {
	size_t n, inside;
	bool no_band, missed, off;
	double rms, worst, worst_sieve, level;
};

/* Compares a run with its prediction.  The entry must have parameters. */
struct cut cut_compare_with_prediction(
    const struct session *s, const struct entry *entry, size_t run);

/* True if both have the same product at the same speed. */
bool cut_is_duplicate(const struct run *a, const struct run *b);

/* Returns the note "72 m/s, 2026-05-03 10:15, cut.csv" in the site's header
 * that describes this run, borrowed, or NULL.  Notes with a speed belong to the
 * last runs at that speed, in the same order. */
const struct site_note *cut_find_note(const struct site *site, size_t run);

/* Reads the date of a note: of a cut, "72 m/s, 2026-05-03 10:15, cut.csv", or a
 * line of the header that states one, "Date, 3 May 2026".  Returns false if it
 * has none. */
bool cut_parse_date(const struct site_note *note, struct datetime *m);

/* Returns which number is the day in a site's notes with a date such as
 * 5/11/2026, as shown by those of them that can be read in only one way;
 * DATETIME_OPEN if none does, or if they differ. */
enum datetime_order cut_day_month_order(const struct site *site);

/* Returns "11 of 12 sieves are within the range for a belt cut; RMSE 0.8
 * points, largest error at 4 mm, where the answer is 1.9 above the cut".  The
 * caller frees it. */
char *cut_comparison_text(const struct cut *cut);

/* Returns the number of runs with a product that were added to the site after
 * its parameters were calibrated, and of these the run that the prediction
 * misses by most or, if it misses none, the one with the largest misfit.
 * twice: one of them is the same as another run. */
struct later cut_compare_runs_since_fit(
    const struct session *s, const struct entry *entry);

/* True if the site has one product, and parameters from elsewhere, so that
 * *run, the run with the product, is the only check. */
bool cut_is_only_check(const struct entry *entry, size_t *run);

#endif

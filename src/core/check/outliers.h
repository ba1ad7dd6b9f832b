/* Finds wrong cells and columns of a sheet, and the mends that would correct
 * them.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_CHECK_OUTLIERS_H
#define TIPSPEED_CORE_CHECK_OUTLIERS_H

#include <stdbool.h>
#include <stddef.h>

#include "core/check/correction.h"
#include "core/posterior/posterior.h"

/* A mend that would make the sheet consistent.  It is only proposed: the
 * laboratory's sheet decides.
 *   measured, expected, sd  of a cell: as measured, and as expected from all
 *                 others (see loo.h), passing 0..1; NAN of columns
 *   surprise      of a cell after a calibration: how much more probable the
 *                 sheet is without it, as a logarithm; NAN
 *   off           of a column: its distance from what others make probable, RMS
 *                 before and after the mend, 0..1; NAN of cells
 *   rmse          of all products to the posterior's fit, before and after the
 *                 mend and without another calibration; NAN without */
struct finding {
	struct mend mend;
	double measured, expected, sd, surprise;
	double off[2], rmse[2];
};

/* unseen: the number of passings where it exceeds DOCTOR_CELLS, so that none
 * was compared with all others (their covariance is a matrix); else 0. */
enum { DOCTOR_CELLS = 1000 };
struct doctor {
	size_t n;
	struct finding *finding;
	size_t unseen;
};

/* Returns the findings; outliers_free.  posterior: of this same site, or NULL.
 * noise: known error of a passing, 0..1, or 0.  No cell is checked where a
 * column has a mend. */
struct doctor outliers_find(
    const struct site *site, const struct posterior *posterior, double noise);
void outliers_free(struct doctor *doctor);

#endif

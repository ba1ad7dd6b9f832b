/* Finds wrong cells and columns of a sheet, and mends that would correct them.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_CHECK_OUTLIERS_H
#define TIPSPEED_CORE_CHECK_OUTLIERS_H

#include <stddef.h>

#include "core/check/correction.h"
#include "core/posterior/posterior.h"

/* A mend that would make the sheet consistent.  It is only a proposal: the
 * laboratory's records decide. measured, expected, sd  of a cell: its measured
 * passing and that expected from all other cells (loo.h), 0..1; NAN for a
 * column
 *   surprise      of a cell, after a calibration: ln of how much more probable
 *                 the sheet is without it; else NAN
 *   off           of a column: its RMS distance from what the others suggest,
 *                 before and after the mend, 0..1; NAN for a cell
 *   rmse          of all products from the posterior's fit, before and after
 *                 the mend, not refitted; NAN without a posterior */
struct finding {
	struct mend mend;
	double measured, expected, sd, surprise;
	double off[2], rmse[2];
};

/* unseen: 0, or the number of passings if it exceeds OUTLIERS_CELLS_MOST.  Then
 * passings are not compared with all others, because the covariance matrix
 * would be too large. */
enum { OUTLIERS_CELLS_MOST = 1000 };
struct outlier_findings {
	size_t n;
	struct finding *finding;
	size_t unseen;
};

/* Returns the findings.  posterior: of the same site, or NULL.  noise: known
 * error of a passing, 0..1, or 0.  If a column needs a mend, cells are not
 * checked.  Free with outliers_free. */
struct outlier_findings outliers_find(
    const struct site *site, const struct posterior *posterior, double noise);
void outliers_free(struct outlier_findings *found);

#endif

/* The runs and numbers that a calibration rests on, as text for the store.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_STORE_BASIS_H
#define TIPSPEED_IO_STORE_BASIS_H

#include "base/error.h"
#include "core/search/calibrate.h"
#include "io/store/material.h"

/* then: the site as it was calibrated, on the runs marked in train [n_run];
 * now: with what was added since, or NULL.  weight: see calibration_weight. */
struct basis {
	struct fit fit;
	struct bounds bounds;
	double weight;
	bool *train;
	struct site *then, *now;
};

/* One line of text without control characters: numbers of the fit that no field
 * of a material has, and the sheets as site_write makes them.  The caller
 * frees. */
char *basis_written(const struct basis *basis);

/* The basis of a material, of which the fit takes what its fields have: where
 * it keeps one, else false without an error.  What was written reads back with
 * the same bits.  ERROR_DATA for text that no calibration writes, as a store
 * may come from others.  Clear it in any case. */
bool basis_read(
    const struct stored *m, struct basis *basis, struct error *error);
void basis_clear(struct basis *basis);

#endif

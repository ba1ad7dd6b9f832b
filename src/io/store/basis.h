/* The runs and numbers that a calibration is based on, as text for the store.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_STORE_BASIS_H
#define TIPSPEED_IO_STORE_BASIS_H

#include "base/error.h"
#include "core/search/calibrate.h"
#include "io/store/material.h"

/* then: the site as it was calibrated, on the runs marked in train [n_run];
 * now: the site with the runs added since, or NULL.  weight: see
 * calibration_weight. */
struct basis {
	struct fit fit;
	struct bounds bounds;
	double weight;
	bool *train;
	struct site *then, *now;
};

/* Returns the basis as one line of text without control characters: the numbers
 * of the fit that no field of a material contains, and the sheets as site_write
 * prints them.  The caller frees. */
char *basis_written(const struct basis *basis);

/* Reads the basis of a material; the numbers of the fit that fields of the
 * material contain come from these.  False without an error if the material has
 * no basis.  A basis that basis_written wrote reads back with the same bits.
 * False with ERROR_DATA for a text that no calibration writes, as a store may
 * come from others.  Clear the basis in any case. */
bool basis_from_material(
    const struct stored *m, struct basis *basis, struct error *error);
void basis_clear(struct basis *basis);

#endif

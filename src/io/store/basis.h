/* The runs and numbers on which a calibration is based, as text for the store.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_STORE_BASIS_H
#define TIPSPEED_IO_STORE_BASIS_H

#include "base/error.h"
#include "core/search/calibrate.h"
#include "io/store/material.h"

/* fit: the calibration, within bounds.  then: the site as it was calibrated, on
 * the runs marked in train [n_run]; now: the site with runs added since, or
 * NULL.  weight: see calibration_sum_squared_weights. */
struct fit_record {
	struct fit fit;
	struct bounds bounds;
	double weight;
	bool *train;
	struct site *then, *now;
};

/* Returns the basis as one line of text without control characters: the numbers
 * of the fit that are not fields of a material, and the sheets as site_write
 * prints them.  The caller frees it. */
char *fit_record_to_line(const struct fit_record *basis);

/* Reads the basis of a material, and the other numbers of its fit from the
 * material's fields.  A basis from fit_record_to_line reads back bit for bit.
 * Returns false without an error if the material has no basis, and with
 * ERROR_DATA if its text cannot come from a calibration (a store may come from
 * another user).  Always clear the basis. */
bool fit_record_from_material(
    const struct material *m, struct fit_record *basis, struct error *error);
void fit_record_clear(struct fit_record *basis);

#endif

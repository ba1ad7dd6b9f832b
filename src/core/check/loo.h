/* Leave-one-out: compares each passing of a sheet with what all others predict.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_CHECK_LOO_H
#define TIPSPEED_CORE_CHECK_LOO_H

#include <stdbool.h>
#include <stddef.h>

#include "core/posterior/posterior.h"
#include "core/psd/site.h"

/* All passings of a site as one Gaussian vector.
 *
 * Feeds: ln(P / (1 - P)) is the sum of a straight line in log size, a smooth
 * process with an amplitude and a length, and sampling errors as in D13.
 *
 * Products, without a posterior: as feeds, with a second process that is linear
 * in energy and a third for each run.
 * Products, with a posterior: their differences from the fit, with a covariance
 * that is the sum of those of D13 (discrepancy.h), of the parameters (by the
 * Jacobian at the fit and the width of their bounds, so that only the other
 * cells determine them) and of the feed's own errors, which propagate to the
 * products.
 *
 * So a wrong passing in a feed shows in the feed and in all its products.  Let
 * u be a cell's direction in the vector, and leave the cell out.  The other
 * cells then predict that it should be lower by
 *   shift = u' K^-1 y / u' K^-1 u    with variance  1 / u' K^-1 u
 * z is the shift over its standard deviation (Rasmussen and Williams 2006, eq
 * 5.12, where u has one element).  K has the amplitudes, lengths and errors
 * that are most probable without the cell; otherwise one grossly wrong cell
 * would make all cells seem uncertain. */
struct leave_out;

/* A cell of the sheet.  run: 0 for a feed shared by all runs. */
struct leave_out_cell {
	bool feed;
	size_t run, sieve; /* index into the curve */
};

/* posterior: of the same site, or NULL.  noise: known error of a passing, 0..1,
 * or 0. */
struct leave_out *leave_out_new(
    const struct site *site, const struct posterior *posterior, double noise);
void leave_out_free(struct leave_out *l);

/* Return the number of cells that can be checked, and cell i of these.
 * Passings of 0 and 100 % cannot be checked, except a product's if there is a
 * posterior; then a product's cells that its feed does not cover cannot be. */
size_t leave_out_count_cells(const struct leave_out *l);
struct leave_out_cell leave_out_get_cell(const struct leave_out *l, size_t i);

/* A cell compared with the others.  expected, sd: passing 0..1; sd includes the
 * error of one sample.  gain: ln of how much more probable the sheet is without
 * the cell. */
struct leave_out_shift {
	size_t cell;
	double expected, sd, z, gain;
};

/* Returns the cell without which the others agree best; z is 0 if there is no
 * cell to check. */
struct leave_out_shift leave_out_find_worst_cell(struct leave_out *l);

struct leave_out_shift leave_out_shift_of_cell(
    struct leave_out *l, size_t cell);

/* Leaves the cell out from now on. */
void leave_out_remove_cell(struct leave_out *l, size_t cell);

#endif

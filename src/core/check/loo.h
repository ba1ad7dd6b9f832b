/* Each passing of a sheet compared with its expectation by all others.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CORE_CHECK_LOO_H
#define TIPSPEED_CORE_CHECK_LOO_H

#include <stdbool.h>
#include <stddef.h>

#include "core/posterior/posterior.h"
#include "core/psd/site.h"

/* All passings of a site as one Gaussian vector.
 *
 * Feeds: ln(P / (1 - P)) is a straight line on log size, a smooth process with
 * an amplitude and a length, and errors of the sample, as in D13.
 * Products, without a posterior: as feeds, with a second process that changes
 * with the speed, straight in energy, and a third for each run.
 * Products, with a posterior: their differences from the fit.  Their covariance
 * is the sum of that of D13 (discrepancy.h); that of the parameters, by the
 * Jacobian at the fit and the width of their bounds, so that the other cells
 * alone determine them; and that of the feed's own errors, which the products
 * follow.
 *
 * So a wrong passing of a feed shows in the feed and in all products of it.
 * Leave a cell out, with u its shift in the vector: the other cells expect it
 * lower by
 *   shift = u' K^-1 y / u' K^-1 u    with variance  1 / u' K^-1 u
 * and z is their ratio (Rasmussen and Williams 2006, eq 5.12, where u has one
 * element).  Amplitudes, lengths and errors of K are those most probable
 * without the cell; otherwise one cell far off would make all cells seem
 * uncertain. */
struct leave_out;

/* A cell of the sheet.  run: 0 for a feed that all runs share. */
struct leave_out_cell {
	bool feed;
	size_t run, sieve; /* index into the curve */
};

/* posterior: of the site, or NULL.  noise: known error of a passing, 0..1, or
 * 0. */
struct leave_out *leave_out_new(
    const struct site *site, const struct posterior *posterior, double noise);
void leave_out_free(struct leave_out *l);

/* Return the number of cells that can be checked, and cell i of them.  Without
 * a posterior they exclude passings of 0 and 100 %; with one, passings of
 * products that the feed does not cover. */
size_t leave_out_cells(const struct leave_out *l);
struct leave_out_cell leave_out_cell(const struct leave_out *l, size_t i);

/* A cell against the others.  expected, sd: passing 0..1, with the error of one
 * sample; gain: how much more probable, as a logarithm, the sheet is with the
 * cell left free. */
struct leave_out_shift {
	size_t cell;
	double expected, sd, z, gain;
};

/* Returns the cell without which the others agree best; z is 0 where there is
 * no cell to check. */
struct leave_out_shift leave_out_worst(struct leave_out *l);

/* Returns the shift of the given cell. */
struct leave_out_shift leave_out_shift_of(struct leave_out *l, size_t cell);

/* Leaves the cell out from now on. */
void leave_out_drop(struct leave_out *l, size_t cell);

#endif

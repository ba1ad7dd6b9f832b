/* Divides many sites into parts for several programs, and makes the table of
 * sites into which collect joins the parts.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_FIT_PART_H
#define TIPSPEED_CMD_FIT_PART_H

#include "cmd/lang/command.h"
#include "cmd/session/session.h"
#include "io/formats/answer.h"
#include "io/formats/shards.h"

/* Part `number` (from 1) of `of` parts: every of-th site.  of 0: all sites.
 * from: where the part was stated, "part" or the name of an environment
 * variable. */
struct part {
	size_t number, of;
	const char *from;
};

/* Reads the part from part= of the call, or else from the environment that
 * Slurm sets for the tasks of a job array and Open MPI for its ranks.  all: the
 * call is about all sites; for other calls part= is an error. */
bool part_from_args(
    const struct args *args, bool all, struct part *part, struct error *error);

/* True if the part contains site `index`, from 0. */
bool part_has_site(const struct part *part, size_t index);

/* Returns the answer of `calibrate all`, with a row for each site [n]: its
 * numbers are f_mat, e0_min, alpha, the misfit, its RMSE and that of the
 * held-out runs, points. */
struct answer *part_build_calibrate_all_answer(
    const struct part_row *row, size_t n);

/* Returns as text all that the results of a calibration with these options
 * depend on; all parts must agree on it.  more: further dependencies.  The
 * caller frees it. */
char *part_common_options_text(const struct session *s,
    const struct calibrate_options *o, const char *more);

/* Puts what `collect` needs to know about a part into the part's answer.  index
 * [n]: the sites of its rows; options: see part_common_options_text. */
void part_put_fields_for_collect(struct answer *answer, const struct session *s,
    const struct part *part, const size_t *index, size_t n,
    const char *options);

#endif

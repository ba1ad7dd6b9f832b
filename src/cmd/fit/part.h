/* Division of many sites into parts for several programs, and the table of
 * sites that joins the parts.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_FIT_PART_H
#define TIPSPEED_CMD_FIT_PART_H

#include "cmd/lang/command.h"
#include "cmd/session/session.h"
#include "io/formats/answer.h"
#include "io/formats/shards.h"

/* Part `number`, from 1, of `of`: every of-th site.  of 0: all sites.  from:
 * the source of the part, "part" or an environment variable. */
struct part {
	size_t number, of;
	const char *from;
};

/* Reads the part from part= in the call, or else from the environment set by
 * Slurm for tasks of a job array or by Open MPI for ranks.  all: the call is
 * for all sites; other calls have no part. */
bool part_from_args(
    const struct args *args, bool all, struct part *part, struct error *error);

/* True if the part contains site `index`, from 0. */
bool part_has_site(const struct part *part, size_t index);

/* Returns the answer of `calibrate all`, with a row for each site [n]: its
 * numbers are f_mat, e0_min, alpha, the misfit, its RMSE and that of the
 * held-out runs, points. */
struct answer *part_calibrate_answer(const struct part_row *row, size_t n);

/* Returns in words everything on which the results of a calibration with these
 * options depend; all parts must agree on it.  more: further dependencies.  The
 * caller frees it. */
char *part_dependencies_text(const struct session *s,
    const struct calibrate_options *o, const char *more);

/* Puts what `collect` needs to know about a part into its answer.  index [n]:
 * its sites; options: see part_dependencies_text. */
void part_put_collect_fields(struct answer *answer, const struct session *s,
    const struct part *part, const size_t *index, size_t n,
    const char *options);

#endif

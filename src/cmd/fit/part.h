/* A part of many sites, for one of several programs that share them, and the
 * table of sites that the parts are joined to again.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_FIT_PART_H
#define TIPSPEED_CMD_FIT_PART_H

#include "cmd/lang/command.h"
#include "cmd/session/session.h"
#include "io/formats/answer.h"

/* Part `number`, from 1, of `of`: every so many-th site.  of 0: none, all sites
 * are taken.  from: what told it, "part" or a variable of the environment. */
struct part {
	size_t number, of;
	const char *from;
};

/* As part= of the call says, else the environment that Slurm gives to the tasks
 * of a job array, or Open MPI to its ranks.  all: the call is for all sites;
 * others have no part. */
bool part_choose(
    const struct args *args, bool all, struct part *part, struct error *error);

/* Whether it has site `index`, counted from 0. */
bool part_has(const struct part *part, size_t index);

/* The answer of `calibrate all`, and a site of it. */
struct part_row {
	const char *site, *remark;
	double f_mat, e0_min, alpha, misfit, rmse_pct, holdout_pct;
};

struct answer *part_answer(void);
void part_add(struct answer *answer, const struct part_row *row);

/* All that the results of a calibration with these options depend on, for parts
 * made elsewhere to agree on; more: what else.  The caller frees. */
char *part_options(const struct session *s, const struct calibrate_options *o,
    const char *more);

/* Puts what `collect` needs to know of a part into its answer: indices [n] of
 * the sites it has; options: as typed, whatever they default to. */
void part_sign(struct answer *answer, const struct session *s,
    const struct part *part, const size_t *index, size_t n,
    const char *options);

#endif

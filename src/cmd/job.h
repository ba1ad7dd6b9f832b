/* The session's job: a calibration under way, of one site or of all.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_JOB_H
#define TIPSPEED_CMD_JOB_H

#include <stdbool.h>

#include "cmd/command.h"
#include "cmd/session.h"

/* Restores the job that was just started from a checkpoint. */
bool job_resume(struct session *s, const char *path, struct error *error);

/* Starts the job on one site (all: first of all loaded ones), with the options
 * given; takes train and run_weight, either of which may be NULL for the
 * default, and log.  Where no site has a product, nothing is started. */
void job_start(struct session *s, const struct calibrate_options *options,
    bool *train, double *run_weight, bool all, FILE *log);

#endif

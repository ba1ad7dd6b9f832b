/* The calibration under way, as its driver and other commands see it.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_JOB_H
#define TIPSPEED_CMD_JOB_H

#include "cmd/session.h"

/* One step of the job; prints its result and ends it when it is done. */
void session_step(struct session *s);

/* Discards a calibration that was stopped, and says so. */
void session_let_go(struct session *s);

/* Stops the job for the user: the best so far becomes the site's fit, and
 * `continue` goes on from there. */
void session_pause(struct session *s);

/* Ends the job, and keeps nothing of it. */
void session_stop(struct session *s);

#endif

/* Runs the session's job and shows its progress.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CLI_PROGRESS_H
#define TIPSPEED_CLI_PROGRESS_H

#include "cmd/session/session.h"

/* Runs the job to its end.  On a signal, returns false with the job unchanged,
 * for session_stop_job_for_user. */
bool progress_run_job(struct session *s);

#endif

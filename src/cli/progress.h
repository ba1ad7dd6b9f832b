/* Runs the session's job and shows its progress.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CLI_PROGRESS_H
#define TIPSPEED_CLI_PROGRESS_H

#include "cmd/session/session.h"

/* Runs the job to its end.  False when a signal came: the job is then
 * unchanged, for session_pause. */
bool progress_run(struct session *s);

#endif

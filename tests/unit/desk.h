/* A session to try commands at.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TESTS_DESK_H
#define TIPSPEED_TESTS_DESK_H

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

#include <cmocka.h>

#include "base/xalloc.h"
#include "cmd/fit/job.h"
#include "cmd/run/line.h"

/* A session whose results and notes are kept. */
struct desk {
	struct session *session;
	struct error error;
	char *out, *notes;
	size_t n_out, n_notes;
	FILE *out_file, *notes_file;
};

static inline int
desk_open(void **state)
{
	struct desk *desk = xcalloc(1, sizeof *desk);
	desk->out_file = open_memstream(&desk->out, &desk->n_out);
	desk->notes_file = open_memstream(&desk->notes, &desk->n_notes);
	desk->session = session_new(desk->out_file, desk->notes_file);
	desk->session->set.threads = 1;
	*state = desk;
	return 0;
}

static inline int
desk_close(void **state)
{
	struct desk *desk = *state;
	session_free(desk->session);
	fclose(desk->out_file);
	fclose(desk->notes_file);
	free(desk->out);
	free(desk->notes);
	free(desk);
	return 0;
}

/* Runs a line to its end, jobs included. */
static inline bool
desk_say(struct desk *desk, const char *line)
{
	size_t next = 0;
	desk->error = (struct error){0};
	do {
		if (!session_run_line(desk->session, line, next, "script.tip", 12,
			&next, &desk->error))
			return false;
		while (session_is_calibrating(desk->session))
			session_step_job(desk->session);
	} while (next > 0);
	fflush(desk->out_file);
	fflush(desk->notes_file);
	return true;
}

static inline void
desk_expect(struct desk *desk, const char *line)
{
	if (!desk_say(desk, line))
		fail_msg("%s: %s", line, desk->error.text);
}

/* Tierp, calibrated: a small search, which the polish takes to the same end. */
#define TIERP_CALIBRATED "load data/sites/tierp.csv; calibrate population=200"

/* Once, at the start of main: names of files in tests are relative to srcdir. */
static inline void
chdir_to_source(void)
{
	const char *srcdir = getenv("srcdir");
	if (srcdir != NULL && chdir(srcdir) != 0)
		fail_msg("srcdir is not there: %s", srcdir);
}

#endif

/* The loop used by every driver: a line, the scripts it opens, the jobs it
 * starts.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CLI_DRIVER_H
#define TIPSPEED_CLI_DRIVER_H

#include "cmd/session/session.h"
#include "cli/pager.h"

/* Callbacks that differ between drivers. */
struct driver {
	struct session *session;
	struct pager *pager; /* holds back results at a prompt, or NULL */
	void *of;            /* for `fail` */
	/* Reports an error in a line of `name`; line is "" if there was
	 * none. */
	void (*fail)(void *of, const struct error *e, const char *line,
	    const char *name);
	/* Reports that a signal ended a line; NULL if the user can see that. */
	void (*interrupted)(const char *name, int number);
	/* Called with a line of a script before it is run, or NULL. */
	void (*begins)(void *of, const char *line);
	/* Runs the job to its end.  On a signal, leaves the job as it is and
	 * returns false. */
	bool (*work)(struct session *s);
	/* True: a calibration at the end of a typed line is left running. */
	bool watches;
};

/* Runs one line to its end.  name, number: its position in messages; number 0
 * for a line typed on the full screen.  Returns 0, the status of the first
 * error, after reporting it, or that of a signal. */
int driver_run_line_to_end(
    const struct driver *d, const char *line, const char *name, int number);

/* Runs all open scripts, except the outermost `depth`, to their ends.  Returns
 * what driver_run_line_to_end does. */
int driver_run_scripts(const struct driver *d, size_t depth);

#endif

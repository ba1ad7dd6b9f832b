/* Shows text, in a pager if it is taller than the screen.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CLI_PAGER_H
#define TIPSPEED_CLI_PAGER_H

#include <stddef.h>
#include <stdio.h>

#include "cmd/session/session.h"

/* The output of a line, held back until its height is known.  The session's
 * results go to file, and so do its notes while held. */
struct pager {
	struct session *session;
	FILE *file, *out, *notes;
	char *text;
	size_t n, shown;
};

void pager_begin_capture(struct pager *pager, struct session *s);

/* Also holds back notes, so that they appear with their results.  Does nothing
 * for NULL. */
void pager_hold_notes(struct pager *pager);

/* Shows the new output on standard output, in a pager if it is tall, and lets
 * notes through again. */
void pager_show_new_output(struct pager *pager);

/* Gives the session back its streams. */
void pager_end_capture(struct pager *pager);

#endif

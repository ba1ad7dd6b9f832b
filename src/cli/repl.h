/* The prompt, using readline on a terminal.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CLI_REPL_H
#define TIPSPEED_CLI_REPL_H

#include "cmd/session/session.h"

/* Prints a greeting and runs the user's init file.  Called before the files on
 * the command line are opened. */
void repl_greet_and_run_init(struct session *s);

/* Reads and runs lines until quit, ^D, SIGTERM or SIGHUP, and returns the exit
 * status: 0, 143 or 129.  Prints errors and continues.  signals_catch must have
 * been called. */
int repl_run(struct session *s);

/* Called instead of the full screen with --linear: runs the prompt or, if it is
 * running already, only prints a note. */
int repl_run_or_note_no_screen(struct session *s);

#endif

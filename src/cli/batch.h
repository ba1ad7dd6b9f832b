/* Runs scripts: from the command line, files, standard input, or typed lines.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CLI_BATCH_H
#define TIPSPEED_CLI_BATCH_H

#include "cmd/session/session.h"
#include "cli/pager.h"

/* Run a script: that of option -c number `line`, standard input, or a file.
 * Return the exit status: 0, or that of the first error, which ends the script
 * and is printed to stderr with its line and a caret. */
int batch_run_script_text(struct session *s, const char *text, int line);
int batch_run_script_stream(struct session *s);
int batch_run_script_file(struct session *s, const char *path);

/* Tells the session that a user now types the lines: starts autosaving and
 * announces the last autosaved session. */
void batch_make_session_interactive(struct session *s);

/* Reads and runs lines typed at a terminal while results go elsewhere.  After
 * an error, prints it and continues. */
int batch_run_typed_lines(struct session *s);

/* Runs a typed line with its jobs and prints any error. pager: at a prompt,
 * collects the results of the line to show them in a pager; else NULL. */
int batch_run_line(
    struct session *s, const char *line, int number, struct pager *pager);

/* As batch_run_line, but the output is shown only if the line fails or is
 * interrupted. */
int batch_run_line_quietly(struct session *s, const char *line, int number);

#endif

/* Forms of the files that results go to, by the ends of their names.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_SESSION_OUTPUT_H
#define TIPSPEED_CMD_SESSION_OUTPUT_H

#include <stdbool.h>

#include "cmd/lang/command.h"
#include "cmd/lang/parse.h"

/* OUTPUT_ANSWERS: one after the other, in one of ANSWER_FORMATS; OUTPUT_HTML,
 * OUTPUT_PDF: put together in a document. */
enum output_kind {
	OUTPUT_ANSWERS,
	OUTPUT_BOOK,
	OUTPUT_PICTURE,
	OUTPUT_HTML,
	OUTPUT_PDF
};

/* end: NULL for all other names, which get the format that is set.  drawn: of
 * commands that draw, COMMAND_DRAWS, else of those that do not.  format: of
 * OUTPUT_ANSWERS. */
struct output {
	const char *end;
	enum output_kind kind;
	bool drawn;
	int format;
};

/* The form of the file that the words name, for a command. */
const struct output *output_of(
    const struct command *command, const struct words *words);

/* Whether the command has results for that file; else an error with what to
 * write instead. */
bool output_allowed(const struct command *command, const struct words *words,
    struct error *error);

#endif

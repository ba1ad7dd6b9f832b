/* Questions at the prompt.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CLI_ASK_H
#define TIPSPEED_CLI_ASK_H

#include "cmd/sheets/ask_user.h"

/* Waits for a line typed at the terminal, even if the program is stopped or the
 * terminal resized meanwhile.  Returns its first character, or EOF at the end
 * of input or on a signal.  If line is not NULL, appends the line without its
 * end to *line. */
int ask_wait_for_line(char **line);

/* Returns the number of columns at which questions are wrapped. */
int question_wrap_width(void);

/* Ask at the prompt; for the hooks `confirm` and `ask` of the session.  read:
 * prompts with a text and returns the line without its end, which the caller
 * frees, or NULL at the end of input or on a signal. */
bool ask_confirm(struct session *s, const char *question, bool yes);
char *ask_question(struct session *s, const struct user_question *inquiry);
char *ask_question_with_reader(struct session *s,
    const struct user_question *inquiry, char *(*read)(const char *text));

#endif

/* Asks at the prompt.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CLI_ASK_H
#define TIPSPEED_CLI_ASK_H

#include "cmd/sheets/ask_user.h"

/* Waits for a line that is typed at the terminal.  A stop, or another size of
 * the terminal, is none.  Returns its first character, or EOF at the end of
 * input or a signal; adds all of it, without its end, to *line (NULL: not
 * wanted). */
int ask_line(char **line);

/* Asks at the prompt, for session->hooks.confirm and .question; read: asks for
 * a line after such a text, and returns it without its end, which the caller
 * frees, or NULL at the end of input or a signal. */
bool ask_confirm(struct session *s, const char *question);
char *ask_question(struct session *s, const struct inquiry *inquiry);
char *ask_with(struct session *s, const struct inquiry *inquiry,
    char *(*read)(const char *text));

#endif

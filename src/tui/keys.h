/* The keys of the full screen, as data: what is pressed, what it does, and the
 * command it composes.  The ? page and the manual are printed from it.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TUI_KEYS_H
#define TIPSPEED_TUI_KEYS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

#include "tui/acts.h"

/* Ends with a code of 0. */
extern const struct key KEYS[];

/* The row of a key on a page, or NULL. */
const struct key *keys_find(int code, enum page page);

/* The code of a key by its name ("Left", "^L", "Esc") or its character; false
 * where there is none such.  Those above 255 are special keys of ncurses. */
bool keys_code(const char *name, int *code);

/* For the ? page: a line for each key whose line has the word, without regard
 * to case, the page's own first; for "" all keys of the page, in brief.
 * keys_nth: the key of line n, or NULL; keys_count: how many keys there are. */
void keys_list(enum page page, const char *word, FILE *out);
const struct key *keys_nth(enum page page, const char *word, size_t n);
size_t keys_count(enum page page, const char *word);

/* The same for tipspeed-tui(1), as mdoc. */
void keys_manual(FILE *out);

/* Prints what each key does by a function, for who translates it. */
void keys_texts(void (*print)(const char *text, FILE *out), FILE *out);

#endif

/* The keys of the full screen, as data: each key and its effect.  The list that
 * ? shows and the manual are generated from this.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TUI_KEYS_H
#define TIPSPEED_TUI_KEYS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

#include "tui/acts.h"

/* Ends with a code of 0. */
extern const struct key KEYS[];

/* Returns the row of a key on a page, or NULL. */
const struct key *keys_find_by_code(int code, enum page page);

/* Returns the code of the key that opens a page. */
int keys_code_of_page(enum page page);

/* Finds the code of a key by its name ("Left", "^L", "Esc") or its character.
 * Returns false if there is no such key.  Codes above 255 are special keys of
 * ncurses. */
bool keys_code_of_name(const char *name, int *code);

/* Returns the length of the first of several names, which are separated by / or
 * a space. */
size_t keys_first_name_length(const char *names);

/* Returns the next of several hints separated by two spaces, and advances past
 * it.  The caller frees it. */
char *keys_next_hint(const char **hints);

/* Returns the row of hints for keys that are separated by two spaces, "<-/->  n
 * p  Enter use it".  A key without words gets those of its row in KEYS.  The
 * caller frees it. */
char *keys_hint_row_text(const char *hints, enum page page);

/* For the list that ? shows.  keys_print_list prints a line for each key whose
 * line contains the word, ignoring case, the page's own keys first.  If the
 * word is "", it prints all keys of the page, in brief.  in_rpm: with speeds in
 * rpm.  keys_nth_listed returns the key of line n, or NULL; keys_count_listed
 * returns the number of lines. */
void keys_print_list(enum page page, const char *word, bool in_rpm, FILE *out);
const struct key *keys_nth_listed(enum page page, const char *word, size_t n);
size_t keys_count_listed(enum page page, const char *word);

/* Returns a text about a key, translated.  in_rpm: with speeds in rpm. */
const char *keys_text_for_speed_unit(const char *words, bool in_rpm);

/* Prints the keys for tipspeed-tui(1), as mdoc. */
void keys_print_manual(FILE *out);

/* Passes each text in KEYS to print, for translators. */
void keys_print_for_translators(
    void (*print)(const char *text, FILE *out), FILE *out);

#endif

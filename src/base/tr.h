/* Translates texts for people with gettext: the sources contain English, and
 * po/ the other languages.  Texts that programs read or people type are not
 * translated.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_BASE_TR_H
#define TIPSPEED_BASE_TR_H

#include <stdbool.h>

/* Marks a text that is translated later, where it is shown. */
#define N_(text) text

/* Chooses the language, such as "sv", or for NULL that of the locale.  Returns
 * false if there is no catalogue for it. */
bool tr_set_language(const char *language);

/* Returns the text in the chosen language, or unchanged if the catalogue lacks
 * it. */
const char *tr(const char *text) __attribute__((format_arg(1)));

/* As tr, for a text that counts things: returns the form for n. */
const char *tr_n(const char *one, const char *several, unsigned long n)
    __attribute__((format_arg(1), format_arg(2)));

/* Turns translation on or off, because results for programs are always in
 * English. */
void tr_set_enabled(bool on);

/* True for yes, or no, or its first letter, in English or in the language of
 * texts. */
bool tr_is_yes(const char *said);
bool tr_is_no(const char *said);

/* Returns the letter that stands for yes, or no, in questions. */
char tr_yes_letter(void);
char tr_letter_for_no(void);

#endif

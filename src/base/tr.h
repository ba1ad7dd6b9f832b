/* Translates texts for people by gettext: English in the sources, other
 * languages in po/.  What programs read and what people type is not translated.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_BASE_TR_H
#define TIPSPEED_BASE_TR_H

#include <stdbool.h>

/* Marks a text that is translated later, where it is shown. */
#define N_(text) text

/* Chooses the language: "sv"; for NULL that of the locale.  False where there
 * is no catalogue for it. */
bool tr_begin(const char *language);

/* The text in that language; itself where the catalogue does not have it. */
const char *tr(const char *text) __attribute__((format_arg(1)));

/* The same for a text with a number of things: the form for n. */
const char *tr_n(const char *one, const char *several, unsigned long n)
    __attribute__((format_arg(1), format_arg(2)));

/* Translates from now on, or not: results for programs are in English whatever
 * the language.  Returns what it was. */
bool tr_on(bool on);

#endif

/* Text, independent of the locale: numbers, words, names, widths.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_BASE_TEXT_H
#define TIPSPEED_BASE_TEXT_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

/* Reads all of s as a decimal number with a point ("11.2", "1e-3"), whatever
 * the locale.  Spaces around it are allowed; hex, "inf" and "nan" are not. */
bool text_number(const char *s, double *value);

/* As text_number, but also with a decimal comma, "11,2", as people type it.  A
 * comma before three digits may separate thousands, "1,640", and is refused,
 * except in "0,063". */
bool text_typed_number(const char *s, double *value);

/* True if the character at `at` in s can only be a decimal comma. */
bool text_is_decimal_comma(const char *s, const char *at);

/* Reads all of s as a whole number from 0 to 2^64-1. */
bool text_whole(const char *s, uint64_t *value);

/* Returns the shortest decimal form that reads back as the same double. */
const char *text_exact(double value, char buf[static 32]);

/* Returns a number for a message that compares it with another: unchanged if it
 * is short, as typed numbers are; else with as few digits as distinguish the
 * two, at least four. */
const char *text_distinguishing(
    double value, double other, char buf[static 32]);

/* Removes spaces at both ends, in place; returns a pointer into s. */
char *text_trim(char *s);

/* Returns a copy in lower case without the accents of Latin letters, so that
 * "Borlänge" becomes "borlange", however its dots are encoded.  Other bytes are
 * unchanged.  The caller frees. */
char *text_fold(const char *s);

/* As text_fold, with every run of characters other than letters of any script,
 * digits, points and underscores replaced by one '-'; empty if there are no
 * such letters, digits, points or underscores. */
char *text_slug(const char *s);

/* Returns n bytes without the quotes (") in them; two quotes within quotes
 * become one.  The caller frees. */
char *text_unquoted(const char *s, size_t n);

/* Returns a text in quotes ("), with two for each one in it.  The caller
 * frees. */
char *text_quoted(const char *s);

/* True if a spreadsheet may take a cell for a formula: a cell that begins with
 * one of = + - @ and is neither a number nor a sign alone.  In a sheet such
 * text is written after an apostrophe, which the reader removes; text that
 * begins with apostrophes and then such a character gets one more. */
bool text_is_formula(const char *s);

/* True if s ends with `end` and has something before it. */
bool text_ends(const char *s, const char *end);

/* True if two words are the same, ignoring case and accents. */
bool text_same(const char *a, const char *b);

/* True if the text contains the word, ignoring case and accents. */
bool text_has(const char *text, const char *word);

/* Finds the index of a word in a list separated by spaces; false if it is not
 * in the list. */
bool text_find_word(const char *list, const char *word, size_t *index);

/* Returns the number of single-letter edits between a and b
 * (Damerau-Levenshtein). */
size_t text_distance(const char *a, const char *b);

/* Returns the code point at *text and moves *text after it; U+FFFD for a byte
 * that is not UTF-8.  Must not be called at the end of a text. */
uint32_t text_next_code_point(const char **text);

/* Returns how many bytes a and b have in common at the start, in whole
 * characters. */
size_t text_shared_prefix(const char *a, const char *b);

/* Returns the columns of a character on a terminal: 1 if the locale does not
 * know it, 0 for marks that combine with the character before. */
int text_columns(uint32_t code);

/* Text may come from others: a name, a sheet, a store.  Characters that a
 * terminal would act on (controls of both kinds), that reverse other text or
 * are invisible (marks of direction, line separators, spaces without width),
 * and that are not text (bytes that are not UTF-8, U+FFFE, U+FFFF) are shown as
 * \x1b, \u202e or \U000e0001.  Everything that is printed for people is shown
 * by these functions, and their output is allowed in XML.
 * 
 * text_escape_next: writes the character at *text as it is shown, moves *text
 * after it, and returns its columns.  text_escaped: returns a whole text, which
 * the caller frees.  text_put: prints it.  text_put_xml: prints it with < > &
 * as entities, for the text of an element.  text_width: returns its columns. */
enum { TEXT_SHOWN = 12 };
int text_escape_next(const char **text, char shown[static TEXT_SHOWN]);
char *text_escaped(const char *s);
void text_put(const char *s, FILE *out);
void text_put_xml(const char *s, FILE *out);
int text_width(const char *s);

/* Returns a text, or as much of it as so many columns hold: whole words, and
 * " .." for the rest; where these are little its beginning with "..", but
 * nothing of a number, which would be another one.  The caller frees. */
char *text_fitted(const char *s, int columns);

/* True if text_escaped changes nothing. */
bool text_is_plain(const char *s);

/* Prints text as text_escaped shows it, in lines of at most width columns,
 * broken at spaces, each after margin spaces; spaces at the start of the text
 * widen the margin. */
void text_wrap(const char *text, int margin, int width, FILE *out);

/* As text_wrap, but with the first line after `first` spaces. */
void text_print_hanging(
    const char *text, int first, int margin, int width, FILE *out);

/* text_wrapped returns the lines of text_wrap as one string, which the caller
 * frees; text_count_rows returns how many lines there are, 0 for an empty
 * text. */
char *text_wrapped(const char *text, int width);
int text_count_rows(const char *text, int width);

/* Adds the next line of `in`, including its line end, to *text, which contains
 * *n bytes and has room for *room, and puts a NUL after it.  The last line of a
 * file may lack a line end.  TEXT_END: the file has ended, or cannot be read
 * (ferror).  TEXT_TOO_LONG: *text would exceed 10 MB. */
enum text_line { TEXT_LINE, TEXT_END, TEXT_TOO_LONG };
enum text_line text_read_line(char **text, size_t *n, size_t *room, FILE *in);

/* Opens a file in memory.  After it is flushed or closed *text contains its *n
 * bytes, which the caller frees.  Without memory the program ends. */
FILE *text_memory(char **text, size_t *n);

/* True if s[0..n) is well-formed UTF-8 without NUL. */
bool text_is_utf8(const char *s, size_t n);

/* Returns the FNV-1a digest, 64 bits, of n bytes, continued from h; start with
 * TEXT_DIGEST_START.  It detects files that were changed by mistake; it does
 * not protect from malice. */
uint64_t text_digest(uint64_t h, const void *bytes, size_t n);
#define TEXT_DIGEST_START UINT64_C(0xcbf29ce484222325)

#endif

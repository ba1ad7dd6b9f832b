/* Text without a locale: numbers, words, names, widths.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_BASE_TEXT_H
#define TIPSPEED_BASE_TEXT_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

/* Read all of s as a decimal number with a point ("11.2", "1e-3"), whatever
 * the locale.  Spaces around it are allowed; hex, "inf" and "nan" are not. */
bool text_number(const char *s, double *value);

/* As people type it: also with a decimal comma, "11,2".  A comma before three
 * digits may separate thousands, "1,640", and is refused, except in "0,063". */
bool text_typed_number(const char *s, double *value);

/* Whether what is at a place of s can only be a decimal comma. */
bool text_is_decimal_comma(const char *s, const char *at);

/* Read all of s as a whole number from 0 to 2^64-1. */
bool text_whole(const char *s, uint64_t *value);

/* Shortest decimal form that reads back as the same double; buf of 32. */
const char *text_exact(double value, char buf[static 32]);

/* A number for a message that compares it with another: as it is where that is
 * short, as typed numbers are; else as few digits as distinguish the two, four
 * at least. */
const char *text_apart(double value, double other, char buf[static 32]);

/* Without spaces at both ends, in place; returns a pointer into s. */
char *text_trim(char *s);

/* A copy in lower case with the accents of Latin letters removed, so that
 * "Borlänge" is "borlange", however its dots are coded.  Other bytes stay.  The
 * caller frees. */
char *text_fold(const char *s);

/* text_fold, with every run of characters other than letters of any script,
 * digits, points and underscores replaced by one '-'; empty where there are
 * none. */
char *text_slug(const char *s);

/* n bytes without the quotes (") in them; two within quotes are one.  The
 * caller frees. */
char *text_unquoted(const char *s, size_t n);

/* Whether a spreadsheet may take a cell for a formula: one that begins with one
 * of = + - @ and is no number and no sign alone.  In a sheet an apostrophe
 * stands before such text, which the reader removes; text that begins with
 * apostrophes and then such a character gets one more. */
bool text_is_formula(const char *s);

/* True when s ends so and has something before it. */
bool text_ends(const char *s, const char *end);

/* Whether two words are the same apart from case and accents. */
bool text_same(const char *a, const char *b);

/* Whether the text contains the word, apart from case and accents. */
bool text_has(const char *text, const char *word);

/* Index of a word in a list separated by spaces; false if it is not there. */
bool text_choice(const char *list, const char *word, size_t *index);

/* Number of single-letter edits between a and b (Damerau-Levenshtein). */
size_t text_distance(const char *a, const char *b);

/* The code point at *text, which moves after it; U+FFFD for a byte that is no
 * UTF-8.  Not to be asked at the end of a text. */
uint32_t text_next(const char **text);

/* How many bytes both begin with, of whole characters. */
size_t text_shared(const char *a, const char *b);

/* Columns of a character on a terminal: 1 where the locale does not know it, 0
 * for marks that combine with the one before. */
int text_columns(uint32_t code);

/* Text may come from others: a name, a sheet, a store.  What a terminal would
 * act on (controls of both kinds), what reverses other text or is invisible
 * (marks of direction, line separators, spaces without width), and what is not
 * text (bytes that are not UTF-8, U+FFFE, U+FFFF) is shown as \x1b, \u202e or
 * \U000e0001.  Whatever is printed for people comes through here, and what
 * comes out may stand in XML.
 *
 * text_show: the character at *text, which moves after it, as it is shown;
 * returns its columns.  text_shown: a whole text, which the caller frees.
 * text_put: prints it.  text_put_xml: with < > & as entities, for the text of
 * an element.  text_width: its columns. */
enum { TEXT_SHOWN = 12 };
int text_show(const char **text, char shown[static TEXT_SHOWN]);
char *text_shown(const char *s);
void text_put(const char *s, FILE *out);
void text_put_xml(const char *s, FILE *out);
int text_width(const char *s);

/* text_is_plain: whether text_shown changes nothing.  text_is_hidden: whether
 * it replaces the character. */
bool text_is_plain(const char *s);
bool text_is_hidden(uint32_t code);

/* Prints text as shown in lines of at most width columns, broken at spaces,
 * each after margin spaces; spaces at its start widen the margin. */
void text_wrap(const char *text, int margin, int width, FILE *out);

/* The same with the first line after first spaces. */
void text_hang(const char *text, int first, int margin, int width, FILE *out);

/* The lines of text_wrap as one string, which the caller frees; and how many
 * they are, 0 of an empty text. */
char *text_wrapped(const char *text, int width);
int text_rows(const char *text, int width);

/* Adds the next line of `in`, its end included, to *text, which has *n bytes
 * and room for *room, and a NUL after it.  A line has no end where the file
 * ends, or cannot be read on (ferror); what would be longer than 10 MB is not
 * read. */
enum text_line { TEXT_LINE, TEXT_END, TEXT_TOO_LONG };
enum text_line text_line(char **text, size_t *n, size_t *room, FILE *in);

/* A file whose n bytes stand in *text, which the caller frees, once it is
 * flushed or closed; without memory the program ends. */
FILE *text_memory(char **text, size_t *n);

/* True when s[0..n) is well-formed UTF-8 without NUL. */
bool text_is_utf8(const char *s, size_t n);

/* FNV-1a, 64 bits, of n bytes going on from h; start with TEXT_DIGEST_START.
 * Detects files that were changed by mistake; no protection from malice. */
uint64_t text_digest(uint64_t h, const void *bytes, size_t n);
#define TEXT_DIGEST_START UINT64_C(0xcbf29ce484222325)

#endif

/* Text independent of the locale: numbers, words, names, widths.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_BASE_TEXT_H
#define TIPSPEED_BASE_TEXT_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

/* Parses all of s as a decimal number with a point ("11.2", "1e-3"), in any
 * locale.  Spaces around it are allowed; hex, "inf" and "nan" are not. */
bool text_parse_number(const char *s, double *value);

/* As text_parse_number, but also accepts a decimal comma, "11,2".  A comma
 * before three digits may separate thousands, "1,640", and is rejected, except
 * in "0,063". */
bool text_parse_typed_number(const char *s, double *value);

/* True if the character at `at` in s is a comma and can only be a decimal
 * one. */
bool text_is_decimal_comma(const char *s, const char *at);

/* True if the character at `at` in a list of quantities or conditions is a
 * comma within a number, not between two of them.  One before a fraction, as
 * in "p80=6,0/2>=30", is between them, unless the list begins with its
 * number. */
bool text_is_comma_in_number(const char *list, const char *at);

/* Returns the length of the first item of such a list, up to a comma or a
 * semicolon. */
size_t text_length_of_list_item(const char *list);

/* Parses all of s as a whole number from 0 to 2^64-1. */
bool text_parse_whole_number(const char *s, uint64_t *value);

/* Returns the shortest decimal form that reads back as the same double. */
const char *text_shortest_exact_number(double value, char buf[static 32]);

/* Returns a number as text for a message that compares it with another.  A
 * short number, as people type them, is exact; otherwise the text has as few
 * digits as distinguish the two, but at least four. */
const char *text_number_distinct_from(
    double value, double other, char buf[static 32]);

/* Removes spaces at both ends, in place; returns a pointer into s. */
char *text_trim(char *s);

/* Returns a copy in lower case without the accents of Latin letters: "Borlänge"
 * becomes "borlange", however its dots are encoded.  Cyrillic letters become
 * lower case too; other bytes are unchanged.  The caller frees it. */
char *text_fold_case_and_accents(const char *s);

/* As text_fold_case_and_accents, but replaces every run of characters other
 * than letters of any script, digits, dots and underscores with one '-', and
 * removes those at the ends. */
char *text_slug(const char *s);

/* Returns the n bytes at s without quotes ("); two quotes within quotes become
 * one.  The caller frees it. */
char *text_without_quotes(const char *s, size_t n);

/* Returns a text in quotes ("), with each quote in it doubled.  The caller
 * frees it. */
char *text_add_quotes(const char *s);

/* True if a spreadsheet may mistake a cell for a formula: it begins with one of
 * = + - @ and is neither a number nor a single sign.  Such text is written to
 * sheets with an apostrophe before it, which the reader removes; text that
 * already begins with apostrophes and such a character gets one more. */
bool text_may_be_formula(const char *s);

/* Writes text as a cell of a sheet that reads back as the same text: quoted if
 * necessary, and never a formula. */
void text_write_csv_cell(const char *text, char separator, FILE *out);

/* Writes a number with a decimal point or, if the separator is a semicolon,
 * with a decimal comma. */
void text_write_csv_number(double value, char separator, FILE *out);

/* Returns the letters of a spreadsheet's column, counted from 1, such as
 * "AB". */
const char *text_column_letters(int column, char buf[static 8]);

/* True if s ends with `end` and has something before it. */
bool text_ends_with(const char *s, const char *end);

/* Returns which of n endings a file's name has, in upper or lower case, or n if
 * it has none of them. */
size_t text_file_ending(const char *path, const char *const *ends, size_t n);

/* True if two texts or, if longer, their first n bytes differ only in the case
 * of the letters of ASCII.  strcasecmp depends on the locale: in Turkish, I and
 * i are different letters. */
bool text_is_same_but_case(const char *a, const char *b, size_t n);

/* True if two words are the same, ignoring case and accents. */
bool text_is_same_folded(const char *a, const char *b);

/* True if the text contains the word, also within another word, ignoring case
 * and accents. */
bool text_contains_folded(const char *text, const char *word);

/* Finds the index of a word in a list separated by spaces.  Returns false if it
 * is not in the list. */
bool text_find_word_in_list(const char *list, const char *word, size_t *index);

/* Returns the number of single-letter edits between a and b
 * (Damerau-Levenshtein). */
size_t text_edit_distance(const char *a, const char *b);

/* Returns the code point at *text, or U+FFFD for a byte that is not UTF-8, and
 * advances *text.  Must not be called at the end of a text. */
uint32_t text_next_code_point(const char **text);

/* Returns the length of s in bytes, or that of its longest beginning of whole
 * characters and at most `most` bytes. */
size_t text_bytes_up_to_limit(const char *s, size_t most);

/* Returns the length in bytes of the common beginning of a and b, in whole
 * characters. */
size_t text_shared_prefix_bytes(const char *a, const char *b);

/* Returns the width of a character on a terminal, in columns: 1 if the locale
 * does not know it, 0 for combining marks. */
int text_columns_of_character(uint32_t code);

/* Text may come from other people: a name, a sheet, a store.  Characters that a
 * terminal would interpret (C0 and C1 controls), that reverse other text or are
 * invisible (direction marks, line separators, zero-width spaces) or that are
 * not text (bytes that are not UTF-8, U+FFFE, U+FFFF) are shown as \x1b, \u202e
 * or \U000e0001.  Everything printed for people goes through these functions.
 * Their output is also allowed in XML.
 *
 * text_escape_next_character writes the character at *text as shown, advances
 * *text, and returns the character's columns.  text_with_control_escaped
 * returns a whole text, which the caller frees; text_print_escaped prints it;
 * text_print_xml prints it with < > & as entities, for the text of an element;
 * text_width_in_columns returns its columns. */
enum { TEXT_SHOWN = 12 };
int text_escape_next_character(
    const char **text, char shown[static TEXT_SHOWN]);
char *text_with_control_escaped(const char *s);
void text_print_escaped(const char *s, FILE *out);
void text_print_xml(const char *s, FILE *out);
int text_width_in_columns(const char *s);

/* Returns a text shortened to that many columns: whole words and " .."; if
 * little would remain, the beginning of a word and "..".  A number is not cut,
 * as part of it would be a different number.  The caller frees the text. */
char *text_cut_to_width(const char *s, int columns);

/* Prints text, escaped as by text_with_control_escaped, in lines of at most
 * width columns.  Lines are broken at spaces and indented by margin spaces,
 * plus those at the start of the text. */
void text_print_wrapped(const char *text, int margin, int width, FILE *out);

/* As text_print_wrapped, on a line of which `column` columns are printed. */
void text_print_hanging(
    const char *text, int column, int margin, int width, FILE *out);

/* text_wrapped returns the lines of text_print_wrapped as one string, which the
 * caller frees; text_count_rows returns their number, 0 for an empty text. */
char *text_wrapped(const char *text, int width);
int text_count_rows(const char *text, int width);

/* Appends the next line of `in`, with its line end, and a NUL to *text, which
 * contains *n bytes and has room for *room.  A line ends in LF, CR LF or CR;
 * the last one of a file may lack its end.  TEXT_END: the file has ended, or
 * cannot be read (ferror).  TEXT_TOO_LONG: *text would exceed 10 MB. */
enum text_line { TEXT_LINE, TEXT_END, TEXT_TOO_LONG };
enum text_line text_read_line(char **text, size_t *n, size_t *room, FILE *in);

/* Opens a file in memory.  After it is flushed or closed, *text holds its *n
 * bytes, which the caller frees.  Lack of memory ends the program. */
FILE *text_open_memory(char **text, size_t *n);

/* True if s[0..n) is well-formed UTF-8 without NUL. */
bool text_is_utf8(const char *s, size_t n);

/* Returns the FNV-1a digest, 64 bits, of n bytes, continued from h; start with
 * TEXT_DIGEST_START.  It detects accidental changes; it does not protect
 * against malice. */
uint64_t text_fnv1a_digest(uint64_t h, const void *bytes, size_t n);
#define TEXT_DIGEST_START UINT64_C(0xcbf29ce484222325)

#endif

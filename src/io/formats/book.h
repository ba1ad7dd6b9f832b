/* Writes results as an Excel workbook, .xlsx.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_FORMATS_BOOK_H
#define TIPSPEED_IO_FORMATS_BOOK_H

#include "base/error.h"
#include "io/formats/answer.h"

/* A workbook being written.  The same results give the same bytes. */
struct book;

/* Makes an empty workbook.  Its file is a temporary one without a name, which
 * disappears when the program ends.  Returns NULL, with an error of kind
 * ERROR_SYSTEM, if that cannot be made. */
struct book *book_new(struct error *error);
void book_free(struct book *book); /* may be NULL */

/* Adds a sheet with an answer as people see it.  Numbers are exact, but shown
 * with the same decimals; the passings in a table of sieves are also drawn as
 * curves.  Returns the number of rows in its table. */
size_t book_add_answer_worksheet(
    struct book *book, const struct answer *answer);

/* Adds a sheet with the cells of a text (see sheet_new_from_text), including
 * its comments. */
void book_add_text_worksheet(
    struct book *book, const char *name, const char *text);

/* Adds a line to the sheet "About", which comes last. */
void book_add_about_line(struct book *book, const char *key, const char *value);

/* book_count_sheets returns the number of sheets without "About"; book_has_site
 * is true if an answer in the book is about a site. */
size_t book_count_sheets(const struct book *book);
bool book_has_site(const struct book *book);

/* Frees the book and returns the workbook's *n bytes, which the caller frees.
 * Returns NULL, with an error of kind ERROR_SYSTEM, if the system fails. */
char *book_finish_to_bytes(struct book *book, size_t *n, struct error *error);

#endif

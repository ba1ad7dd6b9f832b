/* Documents: the answers of commands, for a browser or for paper.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_DOCUMENT_DOCUMENT_H
#define TIPSPEED_CMD_DOCUMENT_DOCUMENT_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

#include "core/check/trust.h"
#include "io/formats/answer.h"
#include "plot/chart.h"

/* A part; parts are in the order in which they were added.  text: for all parts
 * except answers and pictures; DOCUMENT_TEXT is preformatted.  light: for
 * DOCUMENT_LIGHT.  answer: as shown, see answer_copy_escaped. */
enum document_kind {
	DOCUMENT_HEADING,
	DOCUMENT_WORDS,
	DOCUMENT_WARNING,
	DOCUMENT_LIGHT,
	DOCUMENT_TEXT,
	DOCUMENT_ANSWER,
	DOCUMENT_PICTURE
};
struct document_part {
	enum document_kind kind;
	enum light light;
	char *text;
	struct answer *answer;
	struct chart *chart;
};

/* title: if NULL, that of the first answer or picture; titled_by is then the
 * index of that part, else SIZE_MAX.  made_by: the program and the command.
 * one_page: a document with a single part is printed on one page, portrait or
 * landscape, in the largest letters that fit, and its table is not broken. */
struct document {
	char *title, *made_by;
	bool one_page;
	size_t n, titled_by;
	struct document_part *part;
	FILE *out;            /* text printed to it becomes a part, as it is */
	char *text;           /* the text printed to it */
	size_t n_text, taken; /* its bytes, and how many are in parts */
};

/* made_by: copied. */
struct document *document_new(const char *made_by);
void document_free(struct document *document); /* NULL is allowed */

void document_set_title(struct document *document, const char *title);
void document_say(struct document *document, enum document_kind kind,
    const char *format, ...) __attribute__((format(printf, 3, 4)));
void document_add_trust_light(
    struct document *document, enum light light, const char *words);

/* Returns the number of rows in its table. */
size_t document_add_answer(
    struct document *document, const struct answer *answer);

/* Adds the chart and takes ownership of it. */
void document_add_chart(struct document *document, struct chart *chart);

/* Completes the document: turns remaining text into a part and chooses a title.
 * Returns false if the document has no part. */
bool document_finish(struct document *document);

/* Returns "3 tables, 1 image" or, without either, the number of lines of text.
 * The caller frees it. */
char *document_part_counts_text(const struct document *document);

/* Finds the next columns of a table that fit on a page beside the first one:
 * from `to` on, which is 0 before the first call.  Returns false if none is
 * left.  all: however wide they are. */
bool document_columns_that_fit(
    const struct answer_view *view, bool all, size_t *from, size_t *to);

/* True if a column contains only numbers, which are right-aligned. */
bool document_is_number_column(const struct answer_view *view, size_t column);

/* Returns the next line of a text, without its line end, or NULL at the end of
 * the text.  The caller frees it. */
char *document_take_next_line(const char **text);

#endif

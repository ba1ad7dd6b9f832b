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

enum document_kind {
	DOCUMENT_HEADING,
	DOCUMENT_WORDS,
	DOCUMENT_WARNING,
	DOCUMENT_LIGHT,
	DOCUMENT_TEXT, /* preformatted */
	DOCUMENT_ANSWER,
	DOCUMENT_PICTURE
};

struct document_part {
	enum document_kind kind;
	enum light light; /* of DOCUMENT_LIGHT */
	char *text;       /* of all but answers and pictures */
	/* As it is shown, see answer_copy_escaped. */
	struct answer *answer;
	struct chart *chart;
};

/* A document: its parts, in the order in which they were added. */
struct document {
	/* title: if not set, document_finish takes that of the first answer or
	 * picture that has one.  made_by: the program and the command. */
	char *title, *made_by;
	/* Print a document that has a single part on one page, upright or
	 * across, in the largest letters that fit; its table is not broken. */
	bool one_page;
	/* titled_by: the part that the title is from, or SIZE_MAX. */
	size_t n, titled_by;
	struct document_part *part;
	FILE *out;            /* text printed to it becomes a part, as it is */
	char *text;           /* the text printed to it */
	size_t n_text, taken; /* its bytes, and how many are in parts */
};

/* Copies made_by. */
struct document *document_new(const char *made_by);
void document_free(struct document *document); /* NULL is allowed */

void document_set_title(struct document *document, const char *title);
void document_add_paragraph(struct document *document, enum document_kind kind,
    const char *format, ...) __attribute__((format(printf, 3, 4)));
void document_add_trust_light(
    struct document *document, enum light light, const char *words);

/* Returns the number of rows in the answer's table. */
size_t document_add_answer(
    struct document *document, const struct answer *answer);

/* Adds the chart and takes ownership of it. */
void document_add_chart(struct document *document, struct chart *chart);

/* Ends the document: makes the text printed last a part, and chooses a title.
 * Returns false if the document has no part. */
bool document_finish(struct document *document);

/* Returns "3 tables, 1 image" or, if it has neither, the number of lines of
 * text.  The caller frees it. */
char *document_parts_summary_text(const struct document *document);

/* Finds the next columns of a table that fit on a page beside the first column:
 * from *from up to but not including *to, which is 0 before the first call.
 * Returns false if no columns are left.  all: take all, however wide. */
bool document_find_columns_that_fit(
    const struct answer_view *view, bool all, size_t *from, size_t *to);

/* True if the column contains only numbers, which are right-aligned. */
bool document_is_number_column(const struct answer_view *view, size_t column);

/* Returns the next line of a text, without its line break, and moves *text past
 * it; NULL at the end.  The caller frees it. */
char *document_copy_next_text_line(const char **text);

#endif

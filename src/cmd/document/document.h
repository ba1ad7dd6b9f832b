/* Documents: what commands answer, for a browser or for paper.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_DOCUMENT_DOCUMENT_H
#define TIPSPEED_CMD_DOCUMENT_DOCUMENT_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

#include "core/check/trust.h"
#include "io/formats/answer.h"
#include "plot/chart.h"

/* A part, in the order in which it was added.  text: of all but answers and
 * pictures; DOCUMENT_TEXT: lines that stay as they are.  light: of
 * DOCUMENT_LIGHT.  answer: as shown, see answer_shown. */
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

/* title: NULL: that of its first answer or picture, the part titled_by;
 * SIZE_MAX where it is of none.  made_by: the program and the command.
 * one_page: a part that is alone is one page on paper, upright or across, with
 * letters as large as fit. */
struct document {
	char *title, *made_by;
	bool one_page;
	size_t n, titled_by;
	struct document_part *part;
	FILE *out;            /* see document_out */
	char *text;           /* printed there */
	size_t n_text, taken; /* bytes of it, and of those in parts */
};

/* made_by: copied. */
struct document *document_new(const char *made_by);
void document_free(struct document *document); /* NULL is allowed */

/* What is printed here stands in the document as it is. */
FILE *document_out(struct document *document);

void document_title(struct document *document, const char *title);
void document_heading(struct document *document, const char *text);
void document_say(struct document *document, enum document_kind kind,
    const char *format, ...) __attribute__((format(printf, 3, 4)));
void document_light(
    struct document *document, enum light light, const char *words);

/* Returns how many rows its table has. */
size_t document_answer(struct document *document, const struct answer *answer);

/* Takes the chart. */
void document_picture(struct document *document, struct chart *chart);

/* Nothing more is added: what was printed last becomes a part, and there is a
 * title.  False where it has no part. */
bool document_end(struct document *document);

/* "3 tables, 1 image"; of one without either the lines of its text.  The caller
 * frees. */
char *document_extent(const struct document *document);

/* Of a table wider than a page: the column after those that stand beside the
 * first one, from the column `from` on. */
size_t document_block(const struct answer_view *view, size_t from);

/* Whether a column has numbers only, which are set flush right. */
bool document_is_number(const struct answer_view *view, size_t column);

/* The next line of a text, without its end, or NULL at its end; the caller
 * frees it. */
char *document_line(const char **text);

#endif

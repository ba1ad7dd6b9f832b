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

/* A part, in the order in which it was added.  text: of all parts but answers
 * and pictures; DOCUMENT_TEXT: lines that stay as they are.  light: of
 * DOCUMENT_LIGHT.  answer: as shown, see answer_escaped. */
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

/* title: NULL: the title of its first answer or picture, part titled_by;
 * SIZE_MAX where it comes from no part.  made_by: the program and the command.
 * one_page: a document of a single part is one page on paper, upright or
 * across, with letters as large as fit. */
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

/* Returns a stream; text printed to it is put in the document as it is. */
FILE *document_out(struct document *document);

void document_title(struct document *document, const char *title);
void document_heading(struct document *document, const char *text);
void document_say(struct document *document, enum document_kind kind,
    const char *format, ...) __attribute__((format(printf, 3, 4)));
void document_light(
    struct document *document, enum light light, const char *words);

/* Returns how many rows its table has. */
size_t document_answer(struct document *document, const struct answer *answer);

/* Adds the chart, which the document then owns. */
void document_picture(struct document *document, struct chart *chart);

/* Ends the document: the text printed last becomes a part, and a title is
 * chosen.  False if the document has no part. */
bool document_end(struct document *document);

/* Returns "3 tables, 1 image"; without either, how many lines its text has.
 * The caller frees. */
char *document_extent_words(const struct document *document);

/* For a table wider than a page: returns the column after those that fit beside
 * the first one, from the column `from` on. */
size_t document_block(const struct answer_view *view, size_t from);

/* True if a column contains only numbers, which are set flush right. */
bool document_is_number(const struct answer_view *view, size_t column);

/* Returns the next line of a text, without its end, or NULL at its end; the
 * caller frees it. */
char *document_line(const char **text);

#endif

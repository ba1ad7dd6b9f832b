/* Collects the parts of a document.  html.c and pdf.c say how they look.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/document/document.h"

#include <stdarg.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "base/tr.h"
#include "base/xalloc.h"

struct document *
document_new(const char *made_by)
{
	struct document *d = xcalloc(1, sizeof *d);
	d->made_by = xstrdup(made_by);
	d->titled_by = SIZE_MAX;
	d->out = text_open_memory(&d->text, &d->n_text);
	return d;
}

void
document_free(struct document *d)
{
	if (d == NULL)
		return;
	for (size_t i = 0; i < d->n; i++) {
		free(d->part[i].text);
		answer_free(d->part[i].answer);
		if (d->part[i].chart != NULL)
			chart_free(d->part[i].chart);
	}
	free(d->part);
	if (d->out != NULL)
		fclose(d->out);
	free(d->text);
	free(d->title);
	free(d->made_by);
	free(d);
}

static void
append_document_part(struct document *d, struct document_part part)
{
	d->part = xgrow_by_one(d->part, d->n, sizeof *d->part);
	d->part[d->n++] = part;
}

/* Makes a part of the text printed since the last part; call it before adding
 * another part.  Leaves out empty lines at both ends, meant for a terminal. */
static void
add_printed_text_to_document(struct document *d)
{
	fflush(d->out);
	size_t n = d->n_text, from = d->taken;
	d->taken = n;
	while (n > from && d->text[n - 1] == '\n')
		n--;
	while (from < n && d->text[from] == '\n')
		from++;
	if (n > from)
		append_document_part(
		    d, (struct document_part){.kind = DOCUMENT_TEXT,
			   .text = xstrndup(d->text + from, n - from)});
}

static void
document_add_part(struct document *d, struct document_part part)
{
	add_printed_text_to_document(d);
	append_document_part(d, part);
}

void
document_set_title(struct document *d, const char *title)
{
	xfree_and_set(&d->title, xstrdup(title));
}

void
document_add_paragraph(
    struct document *d, enum document_kind kind, const char *format, ...)
{
	va_list ap;
	va_start(ap, format);
	document_add_part(d, (struct document_part){.kind = kind,
				 .text = xvasprintf(tr(format), ap)});
	va_end(ap);
}

void
document_add_trust_light(
    struct document *d, enum light light, const char *words)
{
	document_add_part(d, (struct document_part){.kind = DOCUMENT_LIGHT,
				 .light = light,
				 .text = xstrdup(words)});
}

size_t
document_add_answer(struct document *d, const struct answer *answer)
{
	document_add_part(d, (struct document_part){.kind = DOCUMENT_ANSWER,
				 .answer = answer_copy_escaped(answer)});
	return answer_view(answer).n_row;
}

void
document_add_chart(struct document *d, struct chart *chart)
{
	document_add_part(d,
	    (struct document_part){.kind = DOCUMENT_PICTURE, .chart = chart});
}

bool
document_finish(struct document *d)
{
	add_printed_text_to_document(d);
	for (size_t i = 0; i < d->n && d->title == NULL; i++) {
		const struct document_part *p = &d->part[i];
		const char *title = p->answer != NULL
					? answer_view(p->answer).title
				    : p->chart != NULL ? p->chart->title
						       : NULL;
		d->title = title != NULL ? xstrdup(title) : NULL;
		d->titled_by = title != NULL ? i : SIZE_MAX;
	}
	if (d->title == NULL)
		d->title = xstrdup(d->made_by);
	d->one_page = d->one_page && d->n == 1;
	return d->n > 0;
}

char *
document_parts_summary_text(const struct document *d)
{
	size_t tables = 0, images = 0, lines = 0;
	for (size_t i = 0; i < d->n; i++) {
		const struct document_part *p = &d->part[i];
		images += p->kind == DOCUMENT_PICTURE;
		tables +=
		    p->answer != NULL && answer_view(p->answer).n_column > 0;
		for (const char *c = p->text; c != NULL && *c != '\0'; c++)
			lines += *c == '\n' || c[1] == '\0';
	}
	char *text = xstrdup("");
	if (tables > 0)
		xappend_to_list(&text, ", ",
		    tr_n("%zu table", "%zu tables", tables), tables);
	if (images > 0)
		xappend_to_list(&text, ", ",
		    tr_n("%zu image", "%zu images", images), images);
	if (tables + images == 0)
		xappend_to_list(
		    &text, ", ", tr_n("%zu line", "%zu lines", lines), lines);
	return text;
}

/* Returns the width of the longest word in a text, in columns of a terminal. */
static int
longest_word_width(const char *text)
{
	int most = 0;
	char *copy = xstrdup(text), *save = NULL;
	for (char *word = strtok_r(copy, " ", &save); word != NULL;
	     word = strtok_r(NULL, " ", &save)) {
		int w = text_width_in_columns(word);
		most = w > most ? w : most;
	}
	free(copy);
	return most;
}

/* Returns the width of a column.  Its heading may be broken between words, and
 * so may texts longer than MOST. */
static int
document_column_width(const struct answer_view *v, size_t column)
{
	enum { MOST = 40 };
	int width = longest_word_width(v->head[column]);
	for (size_t i = 0; i < v->n_row; i++) {
		int w = text_width_in_columns(
		    v->cell[i * v->n_column + column].text);
		width = w > width ? w : width;
	}
	return width < MOST ? width : MOST;
}

bool
document_find_columns_that_fit(
    const struct answer_view *v, bool all, size_t *from, size_t *to)
{
	enum { WIDEST = 132, GAP = 2 };
	bool first = *to == 0;
	*from = first ? 1 : *to;
	if (v->n_row == 0 || (!first && *from >= v->n_column))
		return false;
	int width = document_column_width(v, 0);
	for (*to = *from; *to < v->n_column; ++*to) {
		width += GAP + document_column_width(v, *to);
		if (!all && width > WIDEST && *to > *from)
			break;
	}
	return true;
}

bool
document_is_number_column(const struct answer_view *v, size_t column)
{
	for (size_t i = 0; i < v->n_row; i++)
		if (v->cell[i * v->n_column + column].is_text)
			return false;
	return v->n_row > 0;
}

char *
document_copy_next_text_line(const char **text)
{
	if (**text == '\0')
		return NULL;
	size_t n = strcspn(*text, "\n");
	char *line = xstrndup(*text, n);
	*text += n + ((*text)[n] == '\n');
	return line;
}

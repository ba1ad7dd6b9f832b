/* Results as people see them: tables and markdown.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <ctype.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "base/text.h"
#include "base/xalloc.h"
#include "io/report_inside.h"

/* Columns of a terminal, less two for its edges. */
enum { SCREEN = 79 };

/* A column of numbers is set flush right. */
static bool
is_number_column(const struct report *r, size_t column)
{
	for (size_t row = 0; row < report_rows(r); row++)
		if (r->cell[row * r->n_column + column].is_text)
			return false;
	return true;
}

static int
column_width(const struct report *r, size_t column)
{
	int width = text_width(r->head[column]);
	for (size_t row = 0; row < report_rows(r); row++) {
		int w = text_width(r->cell[row * r->n_column + column].text);
		width = w > width ? w : width;
	}
	return width;
}

static void
print_padded(const char *text, int width, bool right, bool last, FILE *out)
{
	int pad = width - text_width(text);
	fprintf(out, "%*s%s%*s", right ? pad : 0, "", text,
	    right || last ? 0 : pad, "");
}

/* True where the last column holds sentences that would not fit a screen behind
 * the columns before it. One column alone is something to be copied. */
static bool
wraps(const struct report *r, int *indent)
{
	enum { LEAST = 24 };
	*indent = 2;
	for (size_t c = 0; c + 1 < r->n_column; c++)
		*indent += column_width(r, c) + 2;
	if (r->n_column < 2 || *indent >= SCREEN - LEAST)
		return false;
	return *indent + column_width(r, r->n_column - 1) > SCREEN;
}

/* The last cell of a row, wrapped under itself. */
static void
print_sentence(const char *text, int indent, FILE *out)
{
	char *lines = NULL;
	size_t n = 0;
	FILE *memory = text_memory(&lines, &n);
	text_wrap(text, indent, SCREEN, memory);
	fclose(memory);
	if (n > (size_t)indent)
		fprintf(out, "%.*s", (int)n - indent - 1, lines + indent);
	free(lines);
}

/* Columns of a table that stand side by side: the first one and those from
 * `from` to before `to`. */
struct block {
	size_t from, to;
};

/* As many columns as fit a screen.  A table that ends in sentences wraps them
 * instead. */
static struct block
block_from(const struct report *r, size_t from)
{
	int indent, width = 4 + column_width(r, 0);
	struct block b = {from, r->n_column};
	if (wraps(r, &indent))
		return b;
	for (b.to = from; b.to < r->n_column; b.to++) {
		width += column_width(r, b.to) + 2;
		if (b.to > from && width > SCREEN + 2)
			break;
	}
	return b;
}

static void
print_row(const struct report *r, size_t row, bool head, struct block block,
    const char *between, FILE *out)
{
	int indent;
	bool wrap = wraps(r, &indent) && between[1] != '|';
	for (size_t c = 0; c < block.to; c = c == 0 ? block.from : c + 1) {
		const char *text =
		    head ? r->head[c] : r->cell[row * r->n_column + c].text;
		if (wrap && c + 1 == r->n_column) {
			print_sentence(text, indent, out);
			return;
		}
		bool last = c + 1 == block.to && between[1] != '|';
		print_padded(text, column_width(r, c), is_number_column(r, c),
		    last, out);
		if (c + 1 < block.to)
			fputs(between, out);
	}
}

int
report_first_clause(const char *provenance)
{
	return (int)strcspn(provenance, ";");
}

/* A row of a table (0: the heads) without blanks at its end. */
static void
print_trimmed(const struct report *r, size_t row, struct block block, FILE *out)
{
	char *line = NULL;
	size_t n = 0;
	FILE *memory = text_memory(&line, &n);
	print_row(r, row - 1, row == 0, block, "  ", memory);
	fclose(memory);
	while (n > 0 && line[n - 1] == ' ')
		n--;
	fprintf(out, "  %.*s\n", (int)n, line);
	free(line);
}

static char *
in_its_way(char *(*way)(const char *), const char *text)
{
	return text != NULL ? way(text) : NULL;
}

/* A copy with all its words put in that way: as shown, or as markdown.  Of the
 * provenance the first clause only. */
static struct report *
put_in(char *(*way)(const char *), const struct report *r)
{
	struct report *copy = report_new(r->command);
	copy->title = in_its_way(way, r->title);
	copy->n_column = r->n_column;
	copy->n_cell = r->n_cell;
	copy->n_note = r->n_note;
	copy->key = xcalloc(r->n_column, sizeof *copy->key);
	copy->head = xcalloc(r->n_column, sizeof *copy->head);
	copy->cell = xcalloc(r->n_cell, sizeof *copy->cell);
	copy->note = xcalloc(r->n_note, sizeof *copy->note);
	if (r->provenance != NULL && r->provenance[0] != '\0') {
		char *first = xstrndup(
		    r->provenance, (size_t)report_first_clause(r->provenance));
		copy->provenance = way(first);
		free(first);
	}
	for (size_t c = 0; c < r->n_column; c++)
		copy->head[c] = way(r->head[c]);
	for (size_t i = 0; i < r->n_cell; i++) {
		copy->cell[i] = r->cell[i];
		copy->cell[i].text = way(r->cell[i].text);
	}
	for (size_t i = 0; i < r->n_note; i++)
		copy->note[i] = way(r->note[i]);
	return copy;
}

void
report_print_table(const struct report *report, FILE *out)
{
	struct report *r = put_in(text_shown, report);
	if (r->title != NULL)
		fprintf(out, "%s\n", r->title);
	if (r->provenance != NULL)
		fprintf(out, "data: %s\n", r->provenance);
	size_t rows = report_rows(r), from = 1;
	while (rows > 0) {
		struct block block = block_from(r, from);
		for (size_t row = 0; row <= rows; row++)
			print_trimmed(r, row, block, out);
		from = block.to;
		if (from >= r->n_column)
			break;
		fputc('\n', out);
	}
	for (size_t i = 0; i < r->n_note; i++)
		text_wrap(r->note[i], 0, SCREEN, out);
	report_free(r);
}

/* Whether markdown or HTML could take the character for markup.  Within a word
 * like f_mat a low line is none. */
static bool
is_markup(const char *text, const char *p)
{
	if (*p == '_')
		return p == text || !isalnum((unsigned char)p[-1]) ||
		       !isalnum((unsigned char)p[1]);
	if (*p == ':')
		return strncmp(p, "://", 3) == 0;
	if (*p == '.')
		return p >= text + 3 && strncasecmp(p - 3, "www", 3) == 0;
	if (*p == '+' || *p == '-')
		return p == text && p[1] != '\0' &&
		       !isdigit((unsigned char)p[1]);
	return strchr(p == text ? "|*[]`\\~$#" : "|*[]`\\~$", *p) != NULL;
}

/* Words that markdown shows as they are: signs behind backslashes, and as
 * entities those of HTML, which knows no backslash. */
static char *
as_markdown(const char *text)
{
	char *shown = text_shown(text);
	char *copy = xcalloc(5 * strlen(shown) + 1, 1), *end = copy;
	for (const char *p = shown; *p != '\0'; p++) {
		const char *entity = *p == '<'   ? "&lt;"
				     : *p == '>' ? "&gt;"
				     : *p == '&' ? "&amp;"
						 : NULL;
		if (entity != NULL) {
			end = stpcpy(end, entity);
			continue;
		}
		if (is_markup(shown, p))
			*end++ = '\\';
		*end++ = *p;
	}
	free(shown);
	return copy;
}

static void
print_markdown_rows(const struct report *r, FILE *out)
{
	for (size_t row = 0; row <= report_rows(r); row++) {
		fputs("| ", out);
		print_row(r, row - 1, row == 0, (struct block){1, r->n_column},
		    " | ", out);
		fputs(" |\n", out);
		if (row > 0)
			continue;
		for (size_t c = 0; c < r->n_column; c++)
			fprintf(out, "%s",
			    is_number_column(r, c) ? "|--:" : "|---");
		fputs("|\n", out);
	}
}

void
report_print_markdown(const struct report *report, FILE *out)
{
	struct report *r = put_in(as_markdown, report);
	if (r->title != NULL)
		fprintf(out, "**%s**\n\n", r->title);
	if (r->provenance != NULL)
		fprintf(out, "Data: %s\n\n", r->provenance);
	if (r->n_column > 0)
		print_markdown_rows(r, out);
	for (size_t i = 0; i < r->n_note; i++)
		fprintf(out, "\n%s\n", r->note[i]);
	fputc('\n', out);
	report_free(r);
}

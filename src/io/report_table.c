/* Results as people see them: tables and markdown.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>
#include <string.h>

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

void
report_print_table(const struct report *r, FILE *out)
{
	if (r->title != NULL)
		fprintf(out, "%s\n", r->title);
	if (r->provenance != NULL && r->provenance[0] != '\0')
		fprintf(out, "data: %.*s\n", report_first_clause(r->provenance),
		    r->provenance);
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
}

/* A bar ends a cell of markdown, but for one behind a backslash. */
static char *
escaped(const char *text)
{
	char *copy = xcalloc(2 * strlen(text) + 1, 1), *end = copy;
	for (; *text != '\0'; text++) {
		if (*text == '|')
			*end++ = '\\';
		*end++ = *text;
	}
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

static void
print_markdown_table(const struct report *r, FILE *out)
{
	struct report copy = *r;
	copy.cell = xcalloc(r->n_cell, sizeof *copy.cell);
	copy.head = xcalloc(r->n_column, sizeof *copy.head);
	for (size_t i = 0; i < r->n_cell; i++) {
		copy.cell[i] = r->cell[i];
		copy.cell[i].text = escaped(r->cell[i].text);
	}
	for (size_t c = 0; c < r->n_column; c++)
		copy.head[c] = escaped(r->head[c]);
	print_markdown_rows(&copy, out);
	for (size_t i = 0; i < r->n_cell; i++)
		free(copy.cell[i].text);
	for (size_t c = 0; c < r->n_column; c++)
		free(copy.head[c]);
	free(copy.cell);
	free(copy.head);
}

void
report_print_markdown(const struct report *r, FILE *out)
{
	if (r->title != NULL)
		fprintf(out, "**%s**\n\n", r->title);
	if (r->provenance != NULL && r->provenance[0] != '\0')
		fprintf(out, "Data: %.*s\n\n",
		    report_first_clause(r->provenance), r->provenance);
	if (r->n_column > 0)
		print_markdown_table(r, out);
	for (size_t i = 0; i < r->n_note; i++)
		fprintf(out, "\n%s\n", r->note[i]);
	fputc('\n', out);
}

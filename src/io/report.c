/* Formats results.  Leaves to the commands what they contain.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/report.h"

#include <assert.h>
#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "base/xalloc.h"

const char *const REPORT_FORMATS[4] = {"table", "csv", "json", "markdown"};

enum { COLUMNS = 24 };

/* text is what people see; number is exact.  is_text: no number. */
struct cell {
	bool is_text;
	double number;
	char *text;
};

struct report {
	char *command, *title, *site, *provenance, *missing;
	size_t n_column, n_cell, n_note;
	char *key[COLUMNS], *head[COLUMNS];
	struct cell *cell; /* row by row */
	char **note;
	json_t *json, *extra;
};

static char *
format_text(const char *format, va_list ap)
{
	va_list again;
	va_copy(again, ap);
	int n = vsnprintf(NULL, 0, format, again);
	va_end(again);
	char *text = xcalloc(n > 0 ? (size_t)n + 1 : 1, 1);
	vsnprintf(text, (size_t)n + 1, format, ap);
	return text;
}

struct report *
report_new(const char *command)
{
	struct report *r = xcalloc(1, sizeof *r);
	r->command = xstrdup(command);
	r->missing = xstrdup("-");
	r->extra = json_object();
	return r;
}

void
report_free(struct report *r)
{
	if (r == NULL)
		return;
	for (size_t i = 0; i < r->n_column; i++) {
		free(r->key[i]);
		free(r->head[i]);
	}
	for (size_t i = 0; i < r->n_cell; i++)
		free(r->cell[i].text);
	for (size_t i = 0; i < r->n_note; i++)
		free(r->note[i]);
	free(r->cell);
	free(r->note);
	free(r->command);
	free(r->title);
	free(r->site);
	free(r->provenance);
	free(r->missing);
	json_decref(r->json);
	json_decref(r->extra);
	free(r);
}

void
report_title(struct report *r, const char *format, ...)
{
	va_list ap;
	va_start(ap, format);
	free(r->title);
	r->title = format_text(format, ap);
	va_end(ap);
}

void
report_site(struct report *r, const char *name, const char *provenance)
{
	r->site = xstrdup(name);
	r->provenance = xstrdup(provenance);
}

void
report_column(struct report *r, const char *key, const char *head)
{
	assert(r->n_column < COLUMNS);
	r->key[r->n_column] = xstrdup(key);
	r->head[r->n_column++] = xstrdup(head);
}

static void
add_cell(struct report *r, bool is_text, double number, char *text)
{
	r->cell = xrealloc(r->cell, r->n_cell + 1, sizeof *r->cell);
	r->cell[r->n_cell++] = (struct cell){is_text, number, text};
}

void
report_number(struct report *r, double value, int decimals)
{
	char *text;
	if (!isfinite(value))
		text = xstrdup(r->missing);
	else if (decimals < 0)
		text = xasprintf("%.6g", value);
	else
		text = xasprintf("%.*f", decimals, value);
	add_cell(r, false, value, text);
}

void
report_text(struct report *r, const char *text)
{
	add_cell(r, true, NAN, xstrdup(text));
}

void
report_missing(struct report *r, const char *words)
{
	free(r->missing);
	r->missing = xstrdup(words);
}

void
report_note(struct report *r, const char *format, ...)
{
	va_list ap;
	va_start(ap, format);
	r->note = xrealloc(r->note, r->n_note + 1, sizeof *r->note);
	r->note[r->n_note++] = format_text(format, ap);
	va_end(ap);
}

void
report_json(struct report *r, json_t *object)
{
	json_decref(r->json);
	r->json = object;
}

void
report_json_key(struct report *r, const char *key, json_t *value)
{
	json_object_set_new(r->extra, key, value);
}

json_t *
report_json_number(double value)
{
	return isfinite(value) ? json_real(value) : json_null();
}

static size_t
n_rows(const struct report *r)
{
	return r->n_column > 0 ? r->n_cell / r->n_column : 0;
}

/* A column of numbers is set flush right. */
static bool
is_number_column(const struct report *r, size_t column)
{
	for (size_t row = 0; row < n_rows(r); row++)
		if (r->cell[row * r->n_column + column].is_text)
			return false;
	return true;
}

static int
column_width(const struct report *r, size_t column)
{
	int width = text_width(r->head[column]);
	for (size_t row = 0; row < n_rows(r); row++) {
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
 * the columns before it. */
static bool
wraps(const struct report *r, int *indent)
{
	enum { SCREEN = 78, LEAST = 24 };
	*indent = 2;
	for (size_t c = 0; c + 1 < r->n_column; c++)
		*indent += column_width(r, c) + 2;
	return r->n_column > 0 && *indent<SCREEN - LEAST && * indent +
					  column_width(r, r->n_column - 1)>
				      SCREEN;
}

/* The last cell of a row, wrapped under itself. */
static void
print_sentence(const char *text, int indent, FILE *out)
{
	const int screen = 78;
	char *copy = xstrdup(text), *save = NULL;
	int column = indent;
	for (char *word = strtok_r(copy, " ", &save); word != NULL;
	     word = strtok_r(NULL, " ", &save)) {
		bool first = column == indent;
		if (!first && column + 1 + text_width(word) > screen) {
			fprintf(out, "\n%*s", indent, "");
			column = indent;
			first = true;
		}
		column += fprintf(out, "%s", first ? "" : " ");
		fputs(word, out);
		column += text_width(word);
	}
	free(copy);
}

static void
print_row(const struct report *r, size_t row, bool head, const char *between,
    FILE *out)
{
	int indent;
	bool wrap = wraps(r, &indent) && between[1] != '|';
	for (size_t c = 0; c < r->n_column; c++) {
		const char *text =
		    head ? r->head[c] : r->cell[row * r->n_column + c].text;
		if (wrap && c + 1 == r->n_column) {
			print_sentence(text, indent, out);
			return;
		}
		bool last = c + 1 == r->n_column && between[1] != '|';
		print_padded(text, column_width(r, c), is_number_column(r, c),
		    last, out);
		if (c + 1 < r->n_column)
			fputs(between, out);
	}
}

/* Length of the provenance's first clause, which says what the data are; the
 * rest says how they were made. */
static int
first_clause(const char *provenance)
{
	return (int)strcspn(provenance, ";");
}

/* A row of a table (0: the heads) without blanks at its end. */
static void
print_trimmed(const struct report *r, size_t row, FILE *out)
{
	char *line = NULL;
	size_t n = 0;
	FILE *memory = open_memstream(&line, &n);
	if (memory == NULL)
		return;
	print_row(r, row - 1, row == 0, "  ", memory);
	fclose(memory);
	while (n > 0 && line[n - 1] == ' ')
		n--;
	fprintf(out, "  %.*s\n", (int)n, line);
	free(line);
}

static void
print_table(const struct report *r, FILE *out)
{
	if (r->title != NULL)
		fprintf(out, "%s\n", r->title);
	if (r->provenance != NULL && r->provenance[0] != '\0')
		fprintf(out, "data: %.*s\n", first_clause(r->provenance),
		    r->provenance);
	for (size_t row = 0; row <= n_rows(r) && n_rows(r) > 0; row++)
		print_trimmed(r, row, out);
	for (size_t i = 0; i < r->n_note; i++)
		text_wrap(r->note[i], 0, 78, out);
}

static void
print_markdown(const struct report *r, FILE *out)
{
	if (r->title != NULL)
		fprintf(out, "**%s**\n\n", r->title);
	if (r->provenance != NULL && r->provenance[0] != '\0')
		fprintf(out, "Data: %.*s\n\n", first_clause(r->provenance),
		    r->provenance);
	for (size_t row = 0; row <= n_rows(r) && r->n_column > 0; row++) {
		fputs("| ", out);
		print_row(r, row - 1, row == 0, " | ", out);
		fputs(" |\n", out);
		if (row > 0)
			continue;
		for (size_t c = 0; c < r->n_column; c++)
			fprintf(out, "%s",
			    is_number_column(r, c) ? "|--:" : "|---");
		fputs("|\n", out);
	}
	for (size_t i = 0; i < r->n_note; i++)
		fprintf(out, "\n%s\n", r->note[i]);
	fputc('\n', out);
}

/* Commas and points, or semicolons and decimal commas. */
static void
print_csv_number(double value, char separator, FILE *out)
{
	char text[32];
	snprintf(text, sizeof text, "%.17g", value);
	char *point = strchr(text, '.');
	if (separator == ';' && point != NULL)
		*point = ',';
	fputs(text, out);
}

static void
print_csv_text(const char *text, char separator, FILE *out)
{
	if (strpbrk(text, (char[]){separator, '"', '\n', '\0'}) == NULL) {
		fputs(text, out);
		return;
	}
	fputc('"', out);
	for (const char *s = text; *s != '\0'; s++)
		fprintf(out, *s == '"' ? "\"\"" : "%c", *s);
	fputc('"', out);
}

/* The columns that stand before those of the result. */
static void
print_csv_origin(const struct report *r, char separator, FILE *out)
{
	fputs(r->command, out);
	if (r->site == NULL)
		return;
	fputc(separator, out);
	print_csv_text(r->site, separator, out);
	fputc(separator, out);
	char *kind =
	    xstrndup(r->provenance, (size_t)first_clause(r->provenance));
	print_csv_text(kind, separator, out);
	free(kind);
}

static void
print_csv(const struct report *r, char separator, FILE *out)
{
	if (r->n_column == 0)
		return;
	fputs("command", out);
	if (r->site != NULL)
		fprintf(out, "%csite%cprovenance", separator, separator);
	for (size_t c = 0; c < r->n_column; c++)
		fprintf(out, "%c%s", separator, r->key[c]);
	fputc('\n', out);
	for (size_t i = 0; i < n_rows(r) * r->n_column; i++) {
		if (i % r->n_column == 0)
			print_csv_origin(r, separator, out);
		fputc(separator, out);
		if (r->cell[i].is_text)
			print_csv_text(r->cell[i].text, separator, out);
		else if (isfinite(r->cell[i].number))
			print_csv_number(r->cell[i].number, separator, out);
		if (i % r->n_column == r->n_column - 1)
			fputc('\n', out);
	}
}

static json_t *
rows_as_json(const struct report *r)
{
	json_t *rows = json_array();
	for (size_t row = 0; row < n_rows(r); row++) {
		json_t *object = json_object();
		for (size_t c = 0; c < r->n_column; c++) {
			const struct cell *cell =
			    &r->cell[row * r->n_column + c];
			json_object_set_new(object, r->key[c],
			    cell->is_text ? json_string(cell->text)
					  : report_json_number(cell->number));
		}
		json_array_append_new(rows, object);
	}
	return rows;
}

static void
print_json(const struct report *r, FILE *out)
{
	json_t *object = r->json != NULL ? json_incref(r->json) : json_object();
	if (r->json == NULL) {
		json_object_set_new(object, "command", json_string(r->command));
		if (r->site != NULL)
			json_object_set_new(
			    object, "site", json_string(r->site));
		json_object_set_new(object, "rows", rows_as_json(r));
		json_object_update_missing(object, r->extra);
	}
	if (r->provenance != NULL)
		json_object_set_new(
		    object, "provenance", json_string(r->provenance));
	json_dumpf(object, out, JSON_COMPACT | JSON_REAL_PRECISION(17));
	fputc('\n', out);
	json_decref(object);
}

void
report_print(const struct report *r, enum report_format format, bool semicolon,
    FILE *out)
{
	switch (format) {
	case REPORT_CSV:
		print_csv(r, semicolon ? ';' : ',', out);
		break;
	case REPORT_JSON:
		print_json(r, out);
		break;
	case REPORT_MARKDOWN:
		print_markdown(r, out);
		break;
	default:
		print_table(r, out);
	}
}

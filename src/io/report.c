/* Collects results and prints them for programs.  What they contain is left to
 * the commands, how people see them to report_table.c.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/report.h"

#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "base/xalloc.h"
#include "io/report_inside.h"

const char *const REPORT_FORMATS[4] = {"table", "csv", "json", "markdown"};

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
	free(r->key);
	free(r->head);
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
	r->title = xvasprintf(format, ap);
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
	r->key = xrealloc(r->key, r->n_column + 1, sizeof *r->key);
	r->head = xrealloc(r->head, r->n_column + 1, sizeof *r->head);
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
	/* What rounds to nothing has no sign. */
	if (text[0] == '-' && strpbrk(text, "123456789") == NULL &&
	    isfinite(value))
		memmove(text, text + 1, strlen(text));
	add_cell(r, false, value, text);
}

void
report_text(struct report *r, const char *text)
{
	add_cell(r, true, NAN, xstrdup(text));
}

void
report_pairs(struct report *r, const char *const pairs[][2], size_t n)
{
	for (size_t i = 0; i < n; i++) {
		report_text(r, pairs[i][0]);
		report_text(r, pairs[i][1]);
	}
}

void
report_missing(struct report *r, const char *words)
{
	free(r->missing);
	r->missing = xstrdup(words);
}

size_t
report_rows(const struct report *r)
{
	return r->n_column > 0 ? r->n_cell / r->n_column : 0;
}

void
report_note(struct report *r, const char *format, ...)
{
	va_list ap;
	va_start(ap, format);
	r->note = xrealloc(r->note, r->n_note + 1, sizeof *r->note);
	r->note[r->n_note++] = xvasprintf(format, ap);
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

void
report_put(json_t *object, const char *key, double value)
{
	json_object_set_new(object, key, report_json_number(value));
}

/* Commas and points, or semicolons and decimal commas.  A sieve of 22.4 mm is
 * 22.4: people look things up by it. */
static void
print_csv_number(double value, char separator, FILE *out)
{
	char text[32];
	text_exact(value, text);
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
	    xstrndup(r->provenance, (size_t)report_first_clause(r->provenance));
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
	for (size_t i = 0; i < report_rows(r) * r->n_column; i++) {
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
cell_json(const struct report *r, size_t row, size_t column)
{
	const struct cell *cell = &r->cell[row * r->n_column + column];
	return cell->is_text ? json_string(cell->text)
			     : report_json_number(cell->number);
}

json_t *
report_json_rows(const struct report *r)
{
	json_t *rows = json_array();
	for (size_t row = 0; row < report_rows(r); row++) {
		json_t *object = json_object();
		for (size_t c = 0; c < r->n_column; c++)
			json_object_set_new(
			    object, r->key[c], cell_json(r, row, c));
		json_array_append_new(rows, object);
	}
	return rows;
}

void
report_put_column(json_t *object, const struct report *r, const char *key)
{
	size_t c = 0;
	while (strcmp(r->key[c], key) != 0)
		c++;
	json_t *list = json_array();
	for (size_t row = 0; row < report_rows(r); row++)
		json_array_append_new(list, cell_json(r, row, c));
	json_object_set_new(object, key, list);
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
		json_object_set_new(object, "rows", report_json_rows(r));
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
		report_print_markdown(r, out);
		break;
	default:
		report_print_table(r, out);
	}
}

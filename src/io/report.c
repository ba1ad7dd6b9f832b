/* Collects results and prints them for programs.  What they contain is left to
 * the commands, how people see them to report_table.c.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/report.h"

#include <assert.h>
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
	r->json = json_object();
	report_put(r->json, "command %s", command);
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
	report_put(r->json, "site %s", name);
}

void
report_column(struct report *r, const char *key, const char *head)
{
	r->key = xrealloc(r->key, r->n_column + 1, sizeof *r->key);
	r->head = xrealloc(r->head, r->n_column + 1, sizeof *r->head);
	r->key[r->n_column] = xstrdup(key);
	r->head[r->n_column++] = xstrdup(head);
}

void
report_columns(struct report *r, const char *format, ...)
{
	va_list ap;
	va_start(ap, format);
	char *list = xvasprintf(format, ap), *save = NULL;
	va_end(ap);
	for (char *key = strtok_r(list, ",", &save); key != NULL;
	     key = strtok_r(NULL, ",", &save)) {
		char *colon = strchr(key, ':');
		if (colon != NULL)
			*colon = '\0';
		key = text_trim(key);
		report_column(
		    r, key, colon != NULL ? text_trim(colon + 1) : key);
	}
	free(list);
}

static void
add_cell(struct report *r, bool is_text, double number, char *text)
{
	r->cell = xrealloc(r->cell, r->n_cell + 1, sizeof *r->cell);
	r->cell[r->n_cell++] = (struct cell){is_text, number, text};
}

/* decimals -1: as many digits as needed. */
static void
add_number(struct report *r, double value, int decimals)
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
report_cells(struct report *r, const char *format, ...)
{
	va_list ap;
	va_start(ap, format);
	for (const char *p = format; (p = strchr(p, '%')) != NULL; p++) {
		assert(p[1] == 's' || p[1] == '.' || p[1] == 'g');
		if (p[1] == 's')
			add_cell(r, true, NAN, xstrdup(va_arg(ap, char *)));
		else
			add_number(r, va_arg(ap, double),
			    p[1] == '.' ? atoi(p + 2) : -1);
	}
	va_end(ap);
}

void
report_text(struct report *r, const char *format, ...)
{
	va_list ap;
	va_start(ap, format);
	add_cell(r, true, NAN, xvasprintf(format, ap));
	va_end(ap);
}

void
report_pair(struct report *r, const char *name, const char *format, ...)
{
	va_list ap;
	va_start(ap, format);
	add_cell(r, true, NAN, xstrdup(name));
	add_cell(r, true, NAN, xvasprintf(format, ap));
	va_end(ap);
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

json_t *
report_json(struct report *r)
{
	r->json_given = true;
	return r->json;
}

json_t *
report_json_number(double value)
{
	return isfinite(value) ? json_real(value) : json_null();
}

/* JSON is UTF-8: a name that is not, a file's, is there as it is shown. */
static json_t *
text_json(const char *text)
{
	if (text_is_utf8(text, strlen(text)))
		return json_string(text);
	char *shown = text_shown(text);
	json_t *string = json_string(shown);
	free(shown);
	return string;
}

/* The value that a conversion of report_put stands for. */
static json_t *
next_value(const char *conversion, va_list *ap)
{
	switch (conversion[1]) {
	case 's':
		return text_json(va_arg(*ap, char *));
	case 'd':
		return json_boolean(va_arg(*ap, int));
	case 'z':
		return json_integer((json_int_t)va_arg(*ap, size_t));
	case 'l':
		return json_integer(
		    (json_int_t)va_arg(*ap, unsigned long long));
	default:
		assert(conversion[1] == 'g');
		return report_json_number(va_arg(*ap, double));
	}
}

void
report_put(json_t *object, const char *format, ...)
{
	va_list ap;
	va_start(ap, format);
	char *copy = xstrdup(format), *save = NULL;
	for (char *key = strtok_r(copy, " ", &save); key != NULL;
	     key = strtok_r(NULL, " ", &save))
		json_object_set_new(
		    object, key, next_value(strtok_r(NULL, " ", &save), &ap));
	free(copy);
	va_end(ap);
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
	char marks[] = {separator, '"', '\n', '\0'};
	const char *quote = strpbrk(text, marks) != NULL ? "\"" : "";
	fprintf(out, "%s%s", quote, text_is_formula(text) ? "'" : "");
	for (const char *s = text; *s != '\0'; s++)
		fprintf(out, *s == '"' ? "\"\"" : "%c", *s);
	fputs(quote, out);
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
	return cell->is_text ? text_json(cell->text)
			     : report_json_number(cell->number);
}

void
report_put_rows(struct report *r, const char *key)
{
	json_t *rows = json_array();
	for (size_t row = 0; row < report_rows(r); row++) {
		json_t *object = json_object();
		for (size_t c = 0; c < r->n_column; c++)
			json_object_set_new(
			    object, r->key[c], cell_json(r, row, c));
		json_array_append_new(rows, object);
	}
	json_object_set_new(report_json(r), key, rows);
}

void
report_put_columns(struct report *r, const char *keys)
{
	char *copy = xstrdup(keys), *save = NULL;
	for (char *key = strtok_r(copy, " ", &save); key != NULL;
	     key = strtok_r(NULL, " ", &save)) {
		size_t c = 0;
		while (strcmp(r->key[c], key) != 0)
			c++;
		json_t *list = json_array();
		for (size_t row = 0; row < report_rows(r); row++)
			json_array_append_new(list, cell_json(r, row, c));
		json_object_set_new(report_json(r), key, list);
	}
	free(copy);
}

static void
print_json(struct report *r, FILE *out)
{
	if (!r->json_given)
		report_put_rows(r, "rows");
	if (r->provenance != NULL)
		report_put(r->json, "provenance %s", r->provenance);
	json_dumpf(r->json, out, JSON_COMPACT | JSON_REAL_PRECISION(17));
	fputc('\n', out);
}

void
report_print(
    struct report *r, enum report_format format, bool semicolon, FILE *out)
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

/* Collects and prints answers.  Commands decide what is in them.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/formats/answer.h"

#include <assert.h>
#include <ctype.h>
#include <jansson.h>
#include <limits.h>
#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "base/tr.h"
#include "base/xalloc.h"
#include "core/psd/site.h"

/* The columns of a terminal, less one for its edge. */
enum { SCREEN = 79 };

/* spare [n_column]: see answer_add_optional_column. */
struct table {
	size_t n_column, n_cell;
	char **key, **head;
	int *spare;
	struct answer_cell *cell; /* row by row */
};

/* table[0]: what people see; table[1]: what programs see, if it has columns.
 * filled: the one to which cells are added. */
struct answer {
	char *command, *title, *site, *provenance, *missing;
	bool names_sites; /* its fields name the sites */
	int room;         /* width for a table, in columns */
	bool across;      /* transpose a table with more rows than columns */
	struct table table[2], *filled;
	json_t *fields; /* an object */
	char *repeated; /* keys of fields */
	size_t n_sentence;
	struct answer_sentence *sentence;
};

struct answer *
answer_new(const char *command)
{
	struct answer *a = xcalloc(1, sizeof *a);
	a->command = xstrdup(command);
	a->missing = xstrdup("-");
	a->fields = json_object();
	a->repeated = xstrdup("");
	a->filled = a->table;
	a->room = SCREEN;
	return a;
}

void
answer_set_width(struct answer *answer, int columns)
{
	answer->room = columns - 1;
}

void
answer_allow_transposed(struct answer *answer)
{
	answer->across = true;
}

static void
free_table(struct table *t)
{
	for (size_t i = 0; i < t->n_column; i++) {
		free(t->key[i]);
		free(t->head[i]);
	}
	for (size_t i = 0; i < t->n_cell; i++) {
		free(t->cell[i].text);
		free(t->cell[i].key);
	}
	free(t->key);
	free(t->head);
	free(t->spare);
	free(t->cell);
}

void
answer_free(struct answer *a)
{
	if (a == NULL)
		return;
	free_table(&a->table[0]);
	free_table(&a->table[1]);
	json_decref(a->fields);
	free(a->repeated);
	for (size_t i = 0; i < a->n_sentence; i++) {
		free(a->sentence[i].text);
		free(a->sentence[i].column);
	}
	free(a->sentence);
	free(a->command);
	free(a->title);
	free(a->site);
	free(a->provenance);
	free(a->missing);
	free(a);
}

const char *
answer_command_name(const struct answer *a)
{
	return a->command;
}

void
answer_set_title(struct answer *a, const char *format, ...)
{
	va_list ap;
	va_start(ap, format);
	xfree_and_set(&a->title, xvasprintf(tr(format), ap));
	va_end(ap);
}

void
answer_set_site(struct answer *a, const char *name, const char *provenance)
{
	a->site = xstrdup(name);
	a->provenance = xstrdup(provenance);
}

void
answer_set_site_names(
    struct answer *a, const char *names, const char *provenance)
{
	answer_set_site(a, names, provenance);
	a->names_sites = true;
}

void
answer_begin_table_for_programs(struct answer *a)
{
	a->filled = &a->table[1];
}

void
answer_resume_table_for_people(struct answer *a)
{
	a->filled = &a->table[0];
}

void
answer_add_optional_column(
    struct answer *a, const char *key, const char *head, int spare)
{
	struct table *t = a->filled;
	size_t n = t->n_column++;
	t->key = xrealloc(t->key, n + 1, sizeof *t->key);
	t->head = xrealloc(t->head, n + 1, sizeof *t->head);
	t->spare = xrealloc(t->spare, n + 1, sizeof *t->spare);
	t->key[n] = xstrdup(key);
	t->head[n] = xstrdup(head);
	t->spare[n] = spare;
}

void
answer_add_column(struct answer *a, const char *key, const char *head)
{
	answer_add_optional_column(a, key, tr(head), 0);
}

void
answer_add_columns(struct answer *a, const char *format, ...)
{
	va_list ap;
	va_start(ap, format);
	char *list = xvasprintf(tr(format), ap), *save = NULL;
	va_end(ap);
	for (char *key = strtok_r(list, ",", &save); key != NULL;
	     key = strtok_r(NULL, ",", &save)) {
		char *colon = strchr(key, ':');
		if (colon != NULL)
			*colon = '\0';
		key = text_trim(key);
		answer_add_column(
		    a, key, colon != NULL ? text_trim(colon + 1) : key);
	}
	free(list);
}

static void
answer_add_cell(struct answer *a, struct answer_cell cell)
{
	struct table *t = a->filled;
	t->cell = xgrow_by_one(t->cell, t->n_cell, sizeof *t->cell);
	t->cell[t->n_cell++] = cell;
}

static void
add_text_cell_to_answer(struct answer *a, char *text)
{
	answer_add_cell(a, (struct answer_cell){true, NAN, -1, text, NULL});
}

/* decimals: -1 for as many digits as needed; sign: print + too. */
static void
answer_add_number_cell(struct answer *a, double value, int decimals, bool sign)
{
	char *text;
	if (!isfinite(value))
		text = xstrdup(a->missing);
	else if (decimals < 0)
		text = xasprintf("%.6g", value);
	else
		text = xasprintf(sign ? "%+.*f" : "%.*f", decimals, value);
	/* A number that rounds to 0 has no sign. */
	if ((text[0] == '-' || text[0] == '+') &&
	    strpbrk(text, "123456789") == NULL && isfinite(value))
		memmove(text, text + 1, strlen(text));
	answer_add_cell(
	    a, (struct answer_cell){false, value, decimals, text, NULL});
}

void
answer_add_cells(struct answer *a, const char *format, ...)
{
	va_list ap;
	va_start(ap, format);
	for (const char *p = format; (p = strchr(p, '%')) != NULL; p++) {
		bool sign = p[1] == '+';
		p += sign;
		assert(p[1] == 's' || p[1] == '.' || p[1] == 'g');
		if (p[1] == 's') {
			add_text_cell_to_answer(a, xstrdup(va_arg(ap, char *)));
			continue;
		}
		int decimals = p[1] != '.'   ? -1
			       : p[2] == '*' ? va_arg(ap, int)
					     : atoi(p + 2);
		answer_add_number_cell(a, va_arg(ap, double), decimals, sign);
	}
	va_end(ap);
}

void
answer_add_text_cell(struct answer *a, const char *format, ...)
{
	va_list ap;
	va_start(ap, format);
	add_text_cell_to_answer(a, xvasprintf(tr(format), ap));
	va_end(ap);
}

void
answer_add_keyed_cell(struct answer *a, const char *key, const char *head)
{
	answer_add_cell(a, (struct answer_cell){
			       true, NAN, -1, xstrdup(tr(head)), xstrdup(key)});
}

void
answer_add_name_value_row(
    struct answer *a, const char *name, const char *format, ...)
{
	va_list ap;
	va_start(ap, format);
	add_text_cell_to_answer(a, xstrdup(tr(name)));
	add_text_cell_to_answer(a, xvasprintf(tr(format), ap));
	va_end(ap);
}

void
answer_set_missing_text(struct answer *a, const char *words)
{
	xfree_and_set(&a->missing, xstrdup(tr(words)));
}

static size_t
count_table_rows(const struct table *t)
{
	return t->n_column > 0 ? t->n_cell / t->n_column : 0;
}

size_t
answer_count_rows(const struct answer *a)
{
	return count_table_rows(a->filled);
}

/* Adds a sentence, which takes ownership of the text. */
static void
add_sentence_to_answer(struct answer *a, enum answer_grade grade, char *text)
{
	a->sentence =
	    xgrow_by_one(a->sentence, a->n_sentence, sizeof *a->sentence);
	a->sentence[a->n_sentence++] =
	    (struct answer_sentence){grade, text, NULL};
}

void
answer_note(struct answer *a, const char *format, ...)
{
	va_list ap;
	va_start(ap, format);
	add_sentence_to_answer(a, ANSWER_PLAIN, xvasprintf(tr(format), ap));
	va_end(ap);
}

void
answer_note_on_column(
    struct answer *a, const char *name, const char *format, ...)
{
	va_list ap;
	va_start(ap, format);
	add_sentence_to_answer(a, ANSWER_PLAIN, xvasprintf(tr(format), ap));
	a->sentence[a->n_sentence - 1].column = xstrdup(name);
	va_end(ap);
}

void
answer_add_sentence(
    struct answer *a, enum answer_grade grade, const char *format, ...)
{
	va_list ap;
	va_start(ap, format);
	add_sentence_to_answer(a, grade, xvasprintf(tr(format), ap));
	va_end(ap);
}

struct fields *
answer_json_fields(struct answer *a)
{
	return (struct fields *)(void *)a->fields;
}

/* Puts a value, of which it takes ownership, into an object or a list.  key:
 * NULL for a list. */
static struct fields *
add_json_value(struct fields *fields, const char *key, json_t *value)
{
	json_t *in = (json_t *)(void *)fields;
	if (key == NULL)
		json_array_append_new(in, value);
	else
		json_object_set_new(in, key, value);
	return (struct fields *)(void *)value;
}

/* Returns a text as JSON.  A text that is not UTF-8, such as the name of a
 * file, is escaped as people see it. */
static json_t *
json_of_text(const char *text)
{
	if (text_is_utf8(text, strlen(text)))
		return json_string(text);
	FREED char *shown = text_with_control_escaped(text);
	return json_string(shown);
}

static json_t *
json_of_number(double value)
{
	return isfinite(value) ? json_real(value) : json_null();
}

/* Returns the next value of fields_put_values, according to its conversion. */
static json_t *
json_of_next_argument(const char *conversion, va_list *ap)
{
	switch (conversion[1]) {
	case 's':
		return json_of_text(va_arg(*ap, char *));
	case 'd':
		return json_boolean(va_arg(*ap, int) != 0);
	case 'z':
		return json_integer((json_int_t)va_arg(*ap, size_t));
	case 'l':
		return json_integer(
		    (json_int_t)va_arg(*ap, unsigned long long));
	default:
		assert(conversion[1] == 'g');
		return json_of_number(va_arg(*ap, double));
	}
}

void
fields_put_values(struct fields *fields, const char *format, ...)
{
	va_list ap;
	va_start(ap, format);
	char *copy = xstrdup(format), *save = NULL;
	for (char *word = strtok_r(copy, " ", &save); word != NULL;
	     word = strtok_r(NULL, " ", &save)) {
		const char *key = word[0] != '%' ? word : NULL;
		word = key != NULL ? strtok_r(NULL, " ", &save) : word;
		add_json_value(fields, key, json_of_next_argument(word, &ap));
	}
	free(copy);
	va_end(ap);
}

void
fields_put_number(struct fields *fields, const char *key, double value)
{
	add_json_value(fields, key, json_of_number(value));
}

struct fields *
fields_add_object(struct fields *fields, const char *key)
{
	return add_json_value(fields, key, json_object());
}

struct fields *
fields_add_list(struct fields *fields, const char *key)
{
	return add_json_value(fields, key, json_array());
}

void
fields_put_numbers(struct fields *fields, const char *key, const double *value,
    size_t n, double (*shown)(double))
{
	struct fields *list = fields_add_list(fields, key);
	for (size_t i = 0; i < n; i++)
		fields_put_number(
		    list, NULL, shown != NULL ? shown(value[i]) : value[i]);
}

static void
add_cell_as_json_field(
    struct fields *fields, const char *key, const struct answer_cell *cell)
{
	const char *text = cell->key != NULL ? cell->key : cell->text;
	add_json_value(fields, key,
	    cell->is_text ? json_of_text(text) : json_of_number(cell->number));
}

static void
fields_add_table_rows(
    struct fields *fields, const char *key, const struct table *t)
{
	struct fields *list = fields_add_list(fields, key);
	for (size_t row = 0; row < count_table_rows(t); row++) {
		struct fields *object = fields_add_object(list, NULL);
		for (size_t c = 0; c < t->n_column; c++)
			add_cell_as_json_field(
			    object, t->key[c], &t->cell[row * t->n_column + c]);
	}
}

void
answer_add_rows_as_json_objects(struct answer *a, const char *key)
{
	fields_add_table_rows(answer_json_fields(a), key, a->filled);
}

void
answer_add_columns_to_json_fields(struct answer *a, const char *keys)
{
	const struct table *t = a->filled;
	size_t which;
	for (size_t c = 0; c < t->n_column; c++) {
		if (!text_find_word_in_list(keys, t->key[c], &which))
			continue;
		struct fields *list =
		    fields_add_list(answer_json_fields(a), t->key[c]);
		for (size_t i = c; i < t->n_cell; i += t->n_column)
			add_cell_as_json_field(list, NULL, &t->cell[i]);
	}
}

void
answer_repeat_fields_in_rows(struct answer *a, const char *keys)
{
	xappend_to_list(&a->repeated, " ", "%s", keys);
}

void
answer_drop_table_for_programs(struct answer *a)
{
	free_table(&a->table[1]);
	a->table[1] = (struct table){0};
	answer_resume_table_for_people(a);
}

bool
answer_has_json_fields(const struct answer *a)
{
	return json_object_size(a->fields) > 0;
}

/* Returns the member whose key is the first n characters, also one that json
 * does not print, ".key"; NULL if there is none. */
static const json_t *
find_json_member(const json_t *in, const char *name, size_t n)
{
	FREED char *key = xstrndup(name, n), *hidden = xasprintf(".%s", key);
	const json_t *item = json_object_get(in, key);
	return item != NULL ? item : json_object_get(in, hidden);
}

/* Finds the largest number at a path.  The items of a list are found under the
 * name of the list. */
static void
find_max_json_number_at_path(const json_t *in, const char *path, double *value)
{
	size_t n = strcspn(path, ".");
	for (size_t i = 0; i < json_array_size(in); i++)
		find_max_json_number_at_path(
		    json_array_get(in, i), path, value);
	if (json_is_object(in)) {
		find_max_json_number_at_path(find_json_member(in, path, n),
		    path + n + (path[n] == '.'), value);
	} else if (*path == '\0' && json_is_boolean(in)) {
		*value = fmax(*value, json_is_true(in));
	} else if (*path == '\0' && json_is_number(in)) {
		*value = fmax(*value, json_number_value(in));
	}
}

double
answer_find_json_number(const struct answer *a, const char *path)
{
	double value = NAN;
	if (strcmp(path, "warnings") == 0 && a->n_sentence > 0)
		value = 0;
	for (size_t i = 0; i < a->n_sentence && !isnan(value); i++)
		value += a->sentence[i].grade == ANSWER_WARNING;
	find_max_json_number_at_path(a->fields, path, &value);
	return value;
}

const char *
answer_find_json_text(const struct answer *a, const char *path)
{
	const json_t *in = a->fields;
	if (strcmp(path, "site") == 0 && a->site != NULL)
		return a->site;
	for (; *path != '\0'; path += *path == '.') {
		size_t n = strcspn(path, ".");
		in = find_json_member(in, path, n);
		path += n;
	}
	return json_string_value(in);
}

static const struct table *
table_for_programs(const struct answer *a)
{
	return &a->table[a->table[1].n_column > 0];
}

struct answer_view
answer_view(const struct answer *a)
{
	const struct table *t =
	    a->table[0].n_column > 0 ? &a->table[0] : table_for_programs(a);
	return (struct answer_view){.title = a->title,
	    .site = a->site,
	    .provenance = a->provenance,
	    .names_sites = a->names_sites,
	    .n_column = t->n_column,
	    .n_row = count_table_rows(t),
	    .n_sentence = a->n_sentence,
	    .head = t->head,
	    .cell = t->cell,
	    .sentence = a->sentence};
}

/* True if there is no table, so that the sentences are the answer. */
static bool
has_answer_only_sentences(const struct answer *a)
{
	return table_for_programs(a)->n_column == 0 && a->n_sentence > 0;
}

/* Returns the length of the provenance's first clause, which states the kind of
 * data; the rest says how they were made. */
static size_t
length_of_provenance_kind(const char *provenance)
{
	return strcspn(provenance, ";");
}

static bool
table_has_column(const struct table *t, const char *key)
{
	bool has = false;
	for (size_t c = 0; c < t->n_column && !has; c++)
		has = strcmp(t->key[c], key) == 0;
	return has;
}

/* Prints the columns before those of the answer, or their names: the site and
 * its provenance, each unless the rows have their own. */
static void
print_csv_command_and_site(
    const struct answer *a, bool names, char separator, FILE *out)
{
	const struct table *t = table_for_programs(a);
	fputs(names ? "command" : a->command, out);
	if (a->site == NULL)
		return;
	FREED char *kind =
	    xstrndup(a->provenance, length_of_provenance_kind(a->provenance));
	const char *cell[] = {a->site, kind};
	const char *const key[] = {"site", "provenance"};
	for (size_t i = 0; i < ARRAY_LEN(key); i++) {
		if (table_has_column(t, key[i]))
			continue;
		fputc(separator, out);
		text_write_csv_cell(names ? key[i] : cell[i], separator, out);
	}
}

/* Prints the fields that are repeated in each row, or their names. */
static void
print_csv_repeated_fields(
    const struct answer *a, bool names, char separator, FILE *out)
{
	FREED char *keys = xstrdup(a->repeated);
	char *save = NULL;
	for (char *key = strtok_r(keys, " ", &save); key != NULL;
	     key = strtok_r(NULL, " ", &save)) {
		const json_t *item =
		    find_json_member(a->fields, key, strlen(key));
		if (item == NULL)
			continue;
		fputc(separator, out);
		if (names)
			fputs(key, out);
		else if (json_is_string(item))
			text_write_csv_cell(
			    json_string_value(item), separator, out);
		else if (json_is_number(item))
			text_write_csv_number(
			    json_number_value(item), separator, out);
	}
}

static size_t
print_csv(const struct answer *a, bool semicolon, FILE *out)
{
	const char separator = semicolon ? ';' : ',';
	const struct table *t = table_for_programs(a);
	bool told = has_answer_only_sentences(a);
	size_t rows = told ? a->n_sentence : count_table_rows(t);
	if (t->n_column == 0 && !told)
		return 0;
	print_csv_command_and_site(a, true, separator, out);
	for (size_t c = 0; c < t->n_column; c++)
		fprintf(out, "%c%s", separator, t->key[c]);
	print_csv_repeated_fields(a, true, separator, out);
	if (told)
		fprintf(out, "%csentence", separator);
	fputc('\n', out);
	for (size_t row = 0; row < rows; row++) {
		print_csv_command_and_site(a, false, separator, out);
		for (size_t c = 0; c < t->n_column; c++) {
			const struct answer_cell *cell =
			    &t->cell[row * t->n_column + c];
			double number = cell->number;
			bool is_text =
			    cell->is_text &&
			    !(semicolon && strcmp(t->key[c], "value") == 0 &&
				strchr(cell->text, '.') != NULL &&
				text_parse_number(cell->text, &number));
			fputc(separator, out);
			if (is_text)
				text_write_csv_cell(
				    cell->key != NULL ? cell->key : cell->text,
				    separator, out);
			else if (isfinite(number))
				text_write_csv_number(number, separator, out);
		}
		print_csv_repeated_fields(a, false, separator, out);
		if (told) {
			fputc(separator, out);
			text_write_csv_cell(
			    a->sentence[row].text, separator, out);
		}
		fputc('\n', out);
	}
	return rows;
}

/* Returns a copy without values whose keys begin with a dot. */
static json_t *
copy_json_without_hidden_keys(json_t *in)
{
	const char *key;
	json_t *value, *copy;
	if (json_is_array(in)) {
		copy = json_array();
		for (size_t i = 0; i < json_array_size(in); i++)
			json_array_append_new(
			    copy, copy_json_without_hidden_keys(
				      json_array_get(in, i)));
		return copy;
	}
	if (!json_is_object(in))
		return json_incref(in);
	copy = json_object();
	json_object_foreach(in, key, value)
	{
		if (key[0] != '.')
			json_object_set_new(
			    copy, key, copy_json_without_hidden_keys(value));
	}
	return copy;
}

static size_t
print_json(const struct answer *a, bool semicolon, FILE *out)
{
	(void)semicolon;
	const struct table *t = table_for_programs(a);
	json_t *o = json_object(),
	       *own = copy_json_without_hidden_keys(a->fields);
	struct fields *all = (struct fields *)(void *)o;
	fields_put_values(all, "command %s", a->command);
	if (a->site != NULL && !a->names_sites)
		fields_put_values(all, "site %s", a->site);
	json_object_update(o, own);
	json_decref(own);
	if (has_answer_only_sentences(a)) {
		struct fields *list = fields_add_list(all, "sentences");
		for (size_t i = 0; i < a->n_sentence; i++)
			fields_put_values(list, "%s", a->sentence[i].text);
	} else if (!answer_has_json_fields(a)) {
		fields_add_table_rows(all, "rows", t);
	}
	if (a->provenance != NULL)
		fields_put_values(all, "provenance %s", a->provenance);
	json_dumpf(o, out, JSON_COMPACT | JSON_REAL_PRECISION(17));
	fputc('\n', out);
	json_decref(o);
	return count_table_rows(t);
}

/* The layout of a table, found once for all rows.  width, number [n_column]:
 * the width of each column, and whether it has numbers.  wraps: the last column
 * has sentences, which are wrapped from column `indent` on.  room: the columns
 * of the screen.  gap: the spaces between two columns.  even: a table that is
 * too wide is divided evenly.  n_key: how many of the first columns tell rows
 * apart; they are repeated in each block. */
struct form {
	int *width, indent, room, gap;
	bool *number, wraps, even;
	size_t n_key;
};

/* True for a column of numbers, which is aligned to the right. */
static bool
is_number_column(const struct table *t, size_t column)
{
	for (size_t row = 0; row < count_table_rows(t); row++)
		if (t->cell[row * t->n_column + column].is_text)
			return false;
	return true;
}

static int
table_column_width(const struct table *t, size_t column)
{
	int width = text_width_in_columns(t->head[column]);
	for (size_t row = 0; row < count_table_rows(t); row++) {
		int w = text_width_in_columns(
		    t->cell[row * t->n_column + column].text);
		width = w > width ? w : width;
	}
	return width;
}

static bool
do_rows_begin_alike(
    const struct table *t, size_t row, size_t other, size_t columns)
{
	for (size_t c = 0; c < columns; c++)
		if (strcmp(t->cell[row * t->n_column + c].text,
			t->cell[other * t->n_column + c].text) != 0)
			return false;
	return true;
}

/* Returns how many of the first columns tell neighbouring rows apart; 1 if they
 * do not, or if they would fill half the screen. */
static size_t
count_key_columns(const struct table *t, const struct form *f)
{
	size_t n = 1;
	int width = 0;
	for (size_t row = 1; row < count_table_rows(t); row++)
		while (
		    n < t->n_column && do_rows_begin_alike(t, row - 1, row, n))
			n++;
	for (size_t c = 0; c < n; c++)
		width += f->width[c] + f->gap;
	return n < t->n_column && 2 * width <= f->room ? n : 1;
}

/* Finds the layout of a table.  The last column is wrapped if it would not fit
 * the screen beside the others.  A single column is not wrapped, as it may be
 * copied. */
static struct form
lay_out_table_columns(const struct table *t, int room)
{
	enum { LEAST = 24 };
	struct form f = {.indent = 2, .room = room, .gap = 2};
	f.width = xcalloc(t->n_column + 1, sizeof *f.width);
	f.number = xcalloc(t->n_column + 1, sizeof *f.number);
	for (size_t c = 0; c < t->n_column; c++) {
		f.width[c] = table_column_width(t, c);
		f.number[c] = is_number_column(t, c);
		f.indent += c + 1 < t->n_column ? f.width[c] + 2 : 0;
	}
	f.wraps = t->n_column >= 2 && f.indent < room - LEAST &&
		  f.indent + f.width[t->n_column - 1] > room;
	f.n_key = count_key_columns(t, &f);
	return f;
}

static void
free_table_layout(struct form *f)
{
	free(f->width);
	free(f->number);
}

/* Columns of a table that are printed side by side: the key columns, and those
 * from `from` to before `to`. */
struct block {
	size_t from, to;
};

static size_t
next_column_of_block(const struct form *f, struct block b, size_t column)
{
	return column + 1 == f->n_key ? b.from : column + 1;
}

/* Returns a block of as many columns as fit the screen.  If the table wraps its
 * last column, all of them do. */
static struct block
find_columns_fitting_screen(
    const struct table *t, const struct form *f, size_t from)
{
	int width = 2;
	for (size_t c = 0; c < f->n_key; c++)
		width += f->width[c] + f->gap;
	struct block b = {from, t->n_column};
	if (f->wraps)
		return b;
	for (b.to = from; b.to < t->n_column; b.to++) {
		width += f->width[b.to] + f->gap;
		if (b.to > from && width > f->room + f->gap)
			break;
	}
	size_t n = b.to - from, all = t->n_column - from;
	if (f->even && n > 0) {
		size_t blocks = (all + n - 1) / n;
		b.to = from + (all + blocks - 1) / blocks;
	}
	return b;
}

/* Returns the column of the screen from which the last cell of a row is
 * wrapped, in the block that ends with it; 0 if it is not wrapped. */
static int
wrap_start_column(const struct table *t, const struct form *f, struct block b)
{
	size_t last = t->n_column - 1;
	if (f->wraps)
		return f->indent;
	if (last == 0 || b.from == 0 || b.to <= last || f->number[last])
		return 0;
	int indent = 2;
	for (size_t c = 0; c < last; c = next_column_of_block(f, b, c))
		indent += f->width[c] + 2;
	return indent + f->width[last] > f->room ? indent : 0;
}

static void
answer_print_row(const struct table *t, const struct form *f, size_t row,
    bool head, struct block block, const char *between, FILE *out)
{
	int indent = between[1] != '|' ? wrap_start_column(t, f, block) : 0;
	for (size_t c = 0; c < block.to;
	     c = next_column_of_block(f, block, c)) {
		const char *text =
		    head ? t->head[c] : t->cell[row * t->n_column + c].text;
		if (indent > 0 && c + 1 == t->n_column) {
			text_print_hanging(text, indent, indent, f->room, out);
			return;
		}
		bool last = c + 1 == block.to && between[1] != '|';
		int pad = f->width[c] - text_width_in_columns(text);
		fprintf(out, "%*s%s%*s", f->number[c] ? pad : 0, "", text,
		    f->number[c] || last ? 0 : pad, "");
		if (c + 1 < block.to)
			fputs(between, out);
	}
}

/* Prints a row of a table (0: the headings) without trailing spaces. */
static void
print_trimmed_row(const struct table *t, const struct form *f, size_t row,
    struct block block, FILE *out)
{
	FREED char *line = NULL;
	size_t n = 0;
	FILE *memory = text_open_memory(&line, &n);
	answer_print_row(
	    t, f, row - 1, row == 0, block, f->gap == 1 ? " " : "  ", memory);
	fclose(memory);
	while (n > 0 && (line[n - 1] == ' ' || line[n - 1] == '\n'))
		n--;
	fprintf(out, "  %.*s\n", (int)n, line);
}

static void
copy_converted_sentences(char *(*way)(const char *), const struct answer *a,
    bool warnings, struct answer *copy)
{
	for (size_t i = 0; i < a->n_sentence; i++) {
		const struct answer_sentence *said = &a->sentence[i];
		bool shown = said->column == NULL ||
			     table_has_column(&copy->table[0], said->column);
		if ((said->grade == ANSWER_WARNING) != warnings || !shown)
			continue;
		FREED char *text = xasprintf("%s%s%s",
		    !warnings                      ? ""
		    : has_answer_only_sentences(a) ? tr("Warning: ")
						   : tr("warning: "),
		    said->text, has_answer_only_sentences(a) ? "." : "");
		add_sentence_to_answer(copy, said->grade, way(text));
	}
}

/* Copies the columns that are shown (all if `shown` is NULL), and adds a
 * sentence that names the others. */
static void
copy_shown_columns(char *(*way)(const char *), const struct table *from,
    const bool *shown, struct answer *copy)
{
	FREED char *left_out = xstrdup("");
	for (size_t c = 0; c < from->n_column; c++) {
		FREED char *head = way(from->head[c]);
		if (shown == NULL || shown[c])
			answer_add_optional_column(
			    copy, from->key[c], head, from->spare[c]);
		else
			xappend_to_list(&left_out, ", ", "%s", head);
	}
	for (size_t i = 0; i < from->n_cell; i++)
		if (shown == NULL || shown[i % from->n_column])
			answer_add_cell(copy,
			    (struct answer_cell){from->cell[i].is_text,
				from->cell[i].number, from->cell[i].decimals,
				way(from->cell[i].text), NULL});
	if (left_out[0] != '\0')
		answer_note(copy, "left out for lack of room: %s", left_out);
}

/* Returns a copy with what people see, all texts converted by `way`: to what a
 * screen shows, or to markdown.  Only the first clause of the provenance is
 * included.  shown: see copy_shown_columns. */
static struct answer *
copy_answer_converting_texts(
    char *(*way)(const char *), const struct answer *a, const bool *shown)
{
	struct answer *copy = answer_new(a->command);
	copy->title = a->title != NULL ? way(a->title) : NULL;
	if (a->provenance != NULL && a->provenance[0] != '\0') {
		FREED char *first = xstrndup(
		    a->provenance, length_of_provenance_kind(a->provenance));
		FREED char *words = site_translate_provenance(first);
		copy->provenance = way(words);
	}
	copy_shown_columns(way, &a->table[0], shown, copy);
	copy->across = a->across;
	copy_converted_sentences(way, a, true, copy);
	copy_converted_sentences(way, a, false, copy);
	return copy;
}

struct answer *
answer_copy_escaped(const struct answer *a)
{
	return copy_answer_converting_texts(text_with_control_escaped, a, NULL);
}

/* Turns the first column into the headings, and the headings into the first
 * column. */
static void
answer_transpose(struct answer *a)
{
	struct table from = a->table[0];
	a->table[0] = (struct table){0};
	size_t rows = count_table_rows(&from);
	answer_add_column(a, from.key[0], from.head[0]);
	for (size_t row = 0; row < rows; row++)
		answer_add_column(
		    a, from.key[0], from.cell[row * from.n_column].text);
	for (size_t c = 1; c < from.n_column; c++) {
		add_text_cell_to_answer(a, xstrdup(from.head[c]));
		for (size_t row = 0; row < rows; row++) {
			struct answer_cell cell =
			    from.cell[row * from.n_column + c];
			cell.text = xstrdup(cell.text);
			answer_add_cell(a, cell);
		}
	}
	free_table(&from);
}

/* Returns which columns are shown [n_column]: all but those that can be spared
 * and do not fit into *room, which is enlarged if the others need more, unless
 * the screen is narrow.  The caller frees it. */
static bool *
choose_columns_to_show(const struct table *t, int *room)
{
	enum { GAP = 2 };
	bool *shown = xcalloc(t->n_column + 1, sizeof *shown);
	int width = 0, most = 0;
	for (size_t c = 0; c < t->n_column; c++)
		most = t->spare[c] > most ? t->spare[c] : most;
	for (int spare = 0; spare <= most; spare++)
		for (size_t c = 0; c < t->n_column; c++) {
			int wide = width + GAP + table_column_width(t, c);
			if (t->spare[c] != spare || (spare > 0 && wide > *room))
				continue;
			shown[c] = true;
			width = wide;
		}
	if (most > 0 && width > *room && *room >= SCREEN)
		*room = width;
	return shown;
}

static size_t
print_text_table(const struct answer *answer, bool semicolon, FILE *out)
{
	(void)semicolon;
	int room = answer->room, wrap = room < SCREEN ? room : SCREEN,
	    heading = room < SCREEN ? room : INT_MAX;
	FREED bool *shown = choose_columns_to_show(&answer->table[0], &room);
	struct answer *a = copy_answer_converting_texts(
	    text_with_control_escaped, answer, shown);
	const struct table *t = &a->table[0];
	bool turned = a->across && count_table_rows(t) > t->n_column;
	if (turned)
		answer_transpose(a);
	if (a->title != NULL)
		text_print_wrapped(a->title, 0, heading, out);
	if (a->provenance != NULL) {
		FREED char *data = xasprintf(tr("data: %s"), a->provenance);
		text_print_wrapped(data, 0, heading, out);
	}
	size_t rows = count_table_rows(t);
	struct form f = lay_out_table_columns(t, room);
	size_t from = f.n_key;
	f.even = turned;
	f.gap = turned ? 1 : 2;
	while (rows > 0) {
		struct block block = find_columns_fitting_screen(t, &f, from);
		for (size_t row = 0; row <= rows; row++)
			print_trimmed_row(t, &f, row, block, out);
		from = block.to;
		if (from >= t->n_column)
			break;
		fputc('\n', out);
	}
	free_table_layout(&f);
	for (size_t i = 0; i < a->n_sentence; i++)
		text_print_wrapped(a->sentence[i].text, 0, wrap, out);
	answer_free(a);
	return rows;
}

/* True if markdown or HTML could take the character at p for markup.  An
 * underscore within a word, as in f_mat, is not. */
static bool
is_markup_character(const char *text, const char *p)
{
	if (*p == '_')
		return p == text || !isalnum((unsigned char)p[-1]) ||
		       !isalnum((unsigned char)p[1]);
	if (*p == ':')
		return strncmp(p, "://", 3) == 0;
	if (*p == '.')
		return p >= text + 3 && text_is_same_but_case(p - 3, "www", 3);
	if (*p == '+' || *p == '-')
		return p == text && p[1] != '\0' &&
		       !isdigit((unsigned char)p[1]);
	return strchr(p == text ? "|*[]`\\~$#" : "|*[]`\\~$", *p) != NULL;
}

/* Escapes a text for markdown: its markup with backslashes, that of HTML with
 * entities. */
static char *
escape_for_markdown(const char *text)
{
	FREED char *shown = text_with_control_escaped(text);
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
		if (is_markup_character(shown, p))
			*end++ = '\\';
		*end++ = *p;
	}
	return copy;
}

static void
print_markdown_rows(const struct table *t, FILE *out)
{
	struct form f = lay_out_table_columns(t, SCREEN);
	for (size_t row = 0; row <= count_table_rows(t); row++) {
		fputs("| ", out);
		answer_print_row(t, &f, row - 1, row == 0,
		    (struct block){f.n_key, t->n_column}, " | ", out);
		fputs(" |\n", out);
		if (row > 0)
			continue;
		for (size_t c = 0; c < t->n_column; c++)
			fprintf(out, "%s", f.number[c] ? "|--:" : "|---");
		fputs("|\n", out);
	}
	free_table_layout(&f);
}

static size_t
print_answer_as_markdown(const struct answer *answer, bool semicolon, FILE *out)
{
	(void)semicolon;
	struct answer *a =
	    copy_answer_converting_texts(escape_for_markdown, answer, NULL);
	const struct table *t = &a->table[0];
	if (a->title != NULL)
		fprintf(out, "**%s**\n\n", a->title);
	if (a->provenance != NULL)
		fprintf(out, tr("Data: %s\n\n"), a->provenance);
	if (t->n_column > 0)
		print_markdown_rows(t, out);
	for (size_t i = 0; i < a->n_sentence; i++)
		fprintf(out, "\n%s\n", a->sentence[i].text);
	fputc('\n', out);
	size_t rows = count_table_rows(t);
	answer_free(a);
	return rows;
}

const struct answer_form ANSWER_FORMATS[4] = {
    {"table", false, print_text_table}, {"csv", true, print_csv},
    {"json", true, print_json}, {"markdown", false, print_answer_as_markdown}};

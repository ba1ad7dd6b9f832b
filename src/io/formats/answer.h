/* Answers: what a command returns, and the forms in which it is printed.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_FORMATS_ANSWER_H
#define TIPSPEED_IO_FORMATS_ANSWER_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

/* What a command returns: site and provenance, named fields, a table, and
 * sentences.  A command does not know the form in which its answer will be
 * shown.  table and markdown round numbers and show title, provenance and
 * sentences; csv and json are exact.  csv prints the table, with the shortest
 * numbers that read back unchanged; json prints the fields, %.17g, or the rows
 * of the table if there are no fields.  csv puts command, site and provenance
 * into columns, so each row states its source, unless the rows have columns of
 * these names.  Without a table the sentences
 * are the answer: people see them with full stops, csv prints a row for each,
 * json a list.  A table wider than the screen continues in further blocks, each
 * with the first column repeated. */
struct answer;

/* The forms of an answer, in the order of the enum.  exact: the form is for
 * programs.  print: prints the answer and returns the number of rows in the
 * table; with semicolon, csv separates cells with semicolons and uses decimal
 * commas, as spreadsheets do in Swedish and German.  JSON is one line. */
enum answer_format { ANSWER_TABLE, ANSWER_CSV, ANSWER_JSON, ANSWER_MARKDOWN };
extern const struct answer_form {
	const char *name;
	bool exact;
	size_t (*print)(const struct answer *, bool semicolon, FILE *out);
} ANSWER_FORMATS[4];

/* Named values in order, kept as an object or a list of jansson; the values of
 * a list have no names.  Units are part of the names: "p50_mm". */
struct fields;

/* Makes an empty answer.  command: the name of its command, which is copied. */
struct answer *answer_new(const char *command);
void answer_free(struct answer *answer);
const char *answer_command_name(const struct answer *answer);

void answer_set_title(struct answer *answer, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/* Sets the site that an answer is about and the provenance of its data (may be
 * ""). */
void answer_set_site(
    struct answer *answer, const char *name, const char *provenance);

/* As answer_set_site, but json omits the site, because the fields name the
 * sites. */
void answer_set_site_names(
    struct answer *answer, const char *names, const char *provenance);

/* Adds columns.  In "speed: m/s, size", each column has a key for csv and json
 * and, after a colon, a heading for people if it differs. */
void answer_add_columns(struct answer *answer, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/* Adds a column whose heading may contain any character. */
void answer_add_column(
    struct answer *answer, const char *key, const char *head);

/* Adds a column whose heading is already translated.  On a screen of 80 columns
 * that has no room for the whole table, columns whose `spare` is not 0 are left
 * out, those with the largest first, and the text says so, instead of
 * continuing in a second block.  Files have all columns. */
void answer_add_optional_column(
    struct answer *answer, const char *key, const char *head, int spare);

/* Sets the width of a table for people; 80 by default. */
void answer_set_width(struct answer *answer, int columns);

/* Lets people see the table transposed, with its first column as headings and a
 * row for each other column, if that is shorter. */
void answer_allow_transposed(struct answer *answer);

/* Begins or resumes a second table: columns and cells added from here on are
 * printed by csv and json, instead of the table that people see. */
void answer_begin_table_for_programs(struct answer *answer);

/* Resumes the table that people see. */
void answer_resume_table_for_people(struct answer *answer);

/* Adds cells, which fill the columns from left to right, row by row.  format:
 * conversions separated by spaces, "%s %.2f %g".  %s: a text; %.2f: a number,
 * with 2 decimals for people; %.*f: the same, with the decimals in an argument;
 * %+.2f: also with a sign; %g: with as many significant digits as needed, up to
 * 6.  NAN appears as the words of answer_set_missing_text, as an empty cell in
 * csv and as null in json. */
void answer_add_cells(struct answer *answer, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

void answer_add_text_cell(struct answer *answer, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/* Adds one cell of text: people see `head`, while csv and json print `key`. */
void answer_add_keyed_cell(
    struct answer *answer, const char *key, const char *head);

/* Adds a row with a name and a text, for a table with two columns. */
void answer_add_name_value_row(struct answer *answer, const char *name,
    const char *format, ...) __attribute__((format(printf, 3, 4)));

/* Sets what to show for NAN in cells added from here on ("below 0.063 mm"); "-"
 * by default. */
void answer_set_missing_text(struct answer *answer, const char *words);

/* Returns the number of complete rows. */
size_t answer_count_rows(const struct answer *answer);

/* Adds a sentence below the table: ANSWER_PLAIN is about the result;
 * ANSWER_REMARK says how to read it; ANSWER_WARNING says not to rely on it, and
 * people see it first, marked as a warning.  answer_note adds a plain
 * sentence. */
enum answer_grade { ANSWER_PLAIN, ANSWER_REMARK, ANSWER_WARNING };
void answer_add_sentence(struct answer *answer, enum answer_grade grade,
    const char *format, ...) __attribute__((format(printf, 3, 4)));
void answer_note(struct answer *answer, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/* Adds a plain sentence about the column `name`, which is left out if the
 * column is. */
void answer_note_on_column(struct answer *answer, const char *name,
    const char *format, ...) __attribute__((format(printf, 3, 4)));

/* The answer as people see it, borrowed: title, site and provenance or NULL
 * (names_sites: of several sites), a table row by row (the table for programs
 * if there is no other), sentences.  In a cell, text is what people see; number
 * is exact, NAN if missing, shown with `decimals`, or as many as needed if that
 * is -1; key is what programs see instead of a text, or NULL. */
struct answer_cell {
	bool is_text;
	double number;
	int decimals;
	char *text, *key;
};
struct answer_sentence {
	enum answer_grade grade;
	char *text,
	    *column; /* the key of the column that it is about, or NULL */
};
struct answer_view {
	const char *title, *site, *provenance;
	bool names_sites;
	size_t n_column, n_row, n_sentence;
	char *const *head;
	const struct answer_cell *cell;
	const struct answer_sentence *sentence;
};
struct answer_view answer_view(const struct answer *answer);

/* Returns a copy of the answer with all texts as people see them: control
 * characters escaped, only the first clause of the provenance, and warnings
 * first, marked as warnings. */
struct answer *answer_copy_escaped(const struct answer *answer);

/* Returns the answer's fields, which do not include command, site and
 * provenance; borrowed. */
struct fields *answer_json_fields(struct answer *answer);

/* Adds values under keys, as "speed %g extrapolated %d" says: %g is a number,
 * or null if it is not finite; %d true or false; %zu and %llu a whole number;
 * %s a text.  For a list the format has no keys: "%g %g".  json omits values
 * whose keys begin with a dot, ".poor %g". */
void fields_put_values(struct fields *fields, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

void fields_put_number(struct fields *fields, const char *key, double value);

/* Adds an object or a list to be filled, and returns it, borrowed.  key: NULL
 * in a list. */
struct fields *fields_add_object(struct fields *fields, const char *key);
struct fields *fields_add_list(struct fields *fields, const char *key);

/* Adds a list of numbers [n], each converted by `shown` (units_m_to_mm or
 * units_fraction_to_pct), or unchanged if that is NULL. */
void fields_put_numbers(struct fields *fields, const char *key,
    const double *value, size_t n, double (*shown)(double));

/* Add the rows so far to the fields: answer_add_rows_as_json_objects as a list
 * of objects, under `key`; answer_add_columns_to_json_fields as a list for each
 * column named in `keys`, which spaces separate. */
void answer_add_rows_as_json_objects(struct answer *answer, const char *key);
void answer_add_columns_to_json_fields(struct answer *answer, const char *keys);

/* Lets csv repeat fields at the end of each row: what the rows are about and do
 * not say, such as the speed.  keys: separated by spaces, those of hidden
 * fields without the dot; fields that are not set are left out. */
void answer_repeat_fields_in_rows(struct answer *answer, const char *keys);

/* Drops the table for programs, if its columns were put as lists: csv prints
 * that for people. */
void answer_drop_table_for_programs(struct answer *answer);

/* Returns the number in a field, such as "p50_mm" or "params.f_mat", or NAN if
 * there is none.  For a list, such as "holdout.rmse_pct", it is the largest
 * number; true is 1.  "warnings" is the number of warnings, if there are any
 * sentences. */
double answer_find_json_number(const struct answer *answer, const char *path);

/* Returns the text in a field, such as "trust", borrowed, or NULL if there is
 * none. */
const char *answer_find_json_text(
    const struct answer *answer, const char *path);

bool answer_has_json_fields(const struct answer *answer);

#endif

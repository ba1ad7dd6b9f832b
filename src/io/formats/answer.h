/* Answers: what a command returns, and how tables, spreadsheets, documents and
 * programs show it.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_FORMATS_ANSWER_H
#define TIPSPEED_IO_FORMATS_ANSWER_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

/* The value a command returns: its site and provenance, named fields, a table,
 * and sentences.  A command does not know how its answer will be shown.  Table
 * and markdown round numbers and show title, provenance and sentences; csv and
 * json are exact: csv has the table, with the shortest number that reads back
 * as the same, json the fields, %.17g, or the rows of the table where there are
 * none.  csv puts command, site and provenance into columns of their own, so
 * that each row states where it is from.  Where there is no table the sentences
 * are the answer: people see them with full stops, csv has a row for each, json
 * a list.  A table wider than a screen goes on in further blocks, each with the
 * first column again. */
struct answer;

/* The forms it is shown in, in the order of the enum.  exact: for programs.
 * print: returns how many rows the table has; semicolon: csv has semicolons,
 * and commas in its numbers, as spreadsheets have in Swedish and German.  JSON
 * is one line. */
enum answer_format { ANSWER_TABLE, ANSWER_CSV, ANSWER_JSON, ANSWER_MARKDOWN };
extern const struct answer_form {
	const char *name;
	bool exact;
	size_t (*print)(const struct answer *, bool semicolon, FILE *out);
} ANSWER_FORMATS[4];

/* Named values in order; of a list they have no names.  Units are part of the
 * names: "p50_mm". */
struct fields;

/* command: name of the command that made it; copied. */
struct answer *answer_new(const char *command);
void answer_free(struct answer *answer);
const char *answer_command(const struct answer *answer);

void answer_title(struct answer *answer, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/* The site an answer is about and what its data are (may be ""). */
void answer_site(
    struct answer *answer, const char *name, const char *provenance);

/* The same where json has the sites, or none, among its own fields. */
void answer_sites(
    struct answer *answer, const char *names, const char *provenance);

/* Columns: "speed: m/s, size" has keys for csv and json and, after a colon,
 * heads for people where these differ. */
void answer_columns(struct answer *answer, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/* A column whose head may hold any sign. */
void answer_column(struct answer *answer, const char *key, const char *head);

/* The width of a table for people; 80 by default. */
void answer_room(struct answer *answer, int columns);

/* Shows people the transposed table where that is shorter: its first column as
 * headings, a row for each of the others. */
void answer_across(struct answer *answer);

/* The columns and cells that follow are another table, which csv and json have
 * instead of the one before. */
void answer_for_programs(struct answer *answer);

/* Cells, which fill the columns from left to right, row by row: "%s %.2f %g",
 * with a space between two.  %s: a text; %.2f: a number, with so many decimals
 * for people, with a sign as %+.2f; %g: with as many significant digits as
 * needed, up to 6.  NAN is shown as the words given by answer_missing, empty in
 * csv and null in json. */
void answer_cells(struct answer *answer, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/* One cell of text. */
void answer_text(struct answer *answer, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/* One cell of text, which csv and json call by its key. */
void answer_name(struct answer *answer, const char *key, const char *head);

/* A row of a name and a text, under two columns. */
void answer_pair(struct answer *answer, const char *name, const char *format,
    ...) __attribute__((format(printf, 3, 4)));

/* What to show for the next NAN cells ("below 0.063 mm"); default "-". */
void answer_missing(struct answer *answer, const char *words);

/* The number of complete rows. */
size_t answer_rows(const struct answer *answer);

/* A sentence below the table: plain, of what was found; a remark on how to read
 * it; a warning not to rely on it, which people see first and marked as one.
 * answer_note: a plain one. */
enum answer_grade { ANSWER_PLAIN, ANSWER_REMARK, ANSWER_WARNING };
void answer_say(struct answer *answer, enum answer_grade grade,
    const char *format, ...) __attribute__((format(printf, 3, 4)));
void answer_note(struct answer *answer, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/* The answer as people see it, borrowed: title, site and provenance or NULL, a
 * table row by row (that for programs where there is no other), sentences.  A
 * cell: text is what people see; number is exact, NAN where it is missing,
 * shown with `decimals`, -1 for as many as needed; key: what programs see
 * instead of a text, or NULL. */
struct answer_cell {
	bool is_text;
	double number;
	int decimals;
	char *text, *key;
};
struct answer_sentence {
	enum answer_grade grade;
	char *text;
};
struct answer_view {
	const char *title, *site, *provenance;
	size_t n_column, n_row, n_sentence;
	char *const *head;
	const struct answer_cell *cell;
	const struct answer_sentence *sentence;
};
struct answer_view answer_view(const struct answer *answer);

/* A copy of that with all texts as they are shown: of the provenance the first
 * clause, warnings first and called so. */
struct answer *answer_shown(const struct answer *answer);

/* Its fields, beside command, site and provenance; borrowed. */
struct fields *answer_fields(struct answer *answer);

/* Adds values under keys, "speed %g extrapolated %d": %g a number, null where
 * it is not finite; %d true or false; %zu and %llu a whole number; %s text.  To
 * a list: "%g %g".  json leaves out what is after a point, ".poor %g". */
void fields_put(struct fields *fields, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

void fields_number(struct fields *fields, const char *key, double value);

/* Adds an object or a list to put more into; key: NULL in a list.  Borrowed. */
struct fields *fields_object(struct fields *fields, const char *key);
struct fields *fields_list(struct fields *fields, const char *key);

/* Adds a list of numbers [n] as shown, by units_mm or units_pct or, for NULL,
 * as they are. */
void fields_numbers(struct fields *fields, const char *key, const double *value,
    size_t n, double (*shown)(double));

/* Adds the rows there are as objects; or as lists the columns so called, with a
 * space between two. */
void answer_put_rows(struct answer *answer, const char *key);
void answer_put_columns(struct answer *answer, const char *keys);

/* The number of a field, NAN where there is none: "p50_mm", "params.f_mat"; of
 * a list the largest, "holdout.rmse_pct"; true is 1.  "warnings": how many of
 * its sentences are, where it has any sentences. */
double answer_number(const struct answer *answer, const char *path);

bool answer_has_fields(const struct answer *answer);

#endif

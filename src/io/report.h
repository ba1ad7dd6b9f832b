/* Results as tables: for people, spreadsheets, documents and programs.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_REPORT_H
#define TIPSPEED_IO_REPORT_H

#include <jansson.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

enum report_format { REPORT_TABLE, REPORT_CSV, REPORT_JSON, REPORT_MARKDOWN };

/* Names in the order of the enum, for options. */
extern const char *const REPORT_FORMATS[4];

/* One result of a command: rows under headed columns, with the words around
 * them.  Table and markdown round numbers and show title, provenance and notes;
 * csv and json are exact and leave the notes out: csv has the shortest number
 * that reads back as the same, json %.17g.  csv puts command, site and
 * provenance into columns of their own, so that a row never travels without
 * saying where it is from.  A table wider than a screen goes on in
 * further blocks, each with the first column again. */
struct report;

/* command: name of the command that made it; copied. */
struct report *report_new(const char *command);
void report_free(struct report *report);

void report_title(struct report *report, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/* The site a result is about and what its data are (may be ""). */
void report_site(
    struct report *report, const char *name, const char *provenance);

/* Columns: "speed: m/s, size" has keys for csv and json and, behind a colon,
 * heads for people where these differ. */
void report_columns(struct report *report, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/* A column whose head may hold any sign. */
void report_column(struct report *report, const char *key, const char *head);

/* Cells, which fill the columns from left to right, row by row: "%s %.2f %g",
 * with a blank between two.  %s: a text; %.2f: a number, with so many decimals
 * for people; %g: with as many significant digits as needed, up to 6.  NAN is
 * shown as the words given by report_missing, empty in csv and null in json. */
void report_cells(struct report *report, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/* One cell of text. */
void report_text(struct report *report, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/* What to show for the next NAN cells ("below 0.063 mm"); default "-". */
void report_missing(struct report *report, const char *words);

/* How many rows are full. */
size_t report_rows(const struct report *report);

/* A line below the table. */
void report_note(struct report *report, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/* The object printed as JSON, to put more into: {"command":..,"site":..}.
 * Where nobody asks for it, it has the rows: {"rows":[{key: value}, ..]}.
 * Borrowed. */
json_t *report_json(struct report *report);

/* Puts values under keys, "speed %g extrapolated %d": %g a number, null where
 * it is not finite; %d true or false; %zu and %llu a whole number; %s text. */
void report_put(json_t *object, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/* A number, or null where it is not finite. */
json_t *report_json_number(double value);

/* Puts the rows as objects into the report's own object; or as arrays its
 * columns so called, with a blank between two. */
void report_put_rows(struct report *report, const char *key);
void report_put_columns(struct report *report, const char *keys);

/* A row of a name and a text, under two columns. */
void report_pair(struct report *report, const char *name, const char *format,
    ...) __attribute__((format(printf, 3, 4)));

/* Prints it; JSON is one line.  semicolon: csv has semicolons, and commas in
 * its numbers, as spreadsheets have in Swedish and German. */
void report_print(struct report *report, enum report_format format,
    bool semicolon, FILE *out);

#endif

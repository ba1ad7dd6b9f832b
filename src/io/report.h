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

/* A column: key for csv and json ("p80_mm"), head for people ("P80 mm"). */
void report_column(struct report *report, const char *key, const char *head);

/* Cells fill the columns from left to right, row by row.  decimals: for
 * people; -1: as many significant digits as needed, up to 6.  NAN is shown as
 * the words given by report_missing, empty in csv and null in json. */
void report_number(struct report *report, double value, int decimals);
void report_text(struct report *report, const char *text);

/* What to show for the next NAN cells ("below 0.063 mm"); default "-". */
void report_missing(struct report *report, const char *words);

/* How many rows are full. */
size_t report_rows(const struct report *report);

/* A line below the table. */
void report_note(struct report *report, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/* The object printed as JSON instead of the default, which has the rows as
 * objects: {"command":..,"rows":[{key: value}, ..]}.  Takes the reference. */
void report_json(struct report *report, json_t *object);

/* One more key of the default object.  Takes the reference. */
void report_json_key(struct report *report, const char *key, json_t *value);

/* value, or null where it is not finite; the same under a key of an object. */
json_t *report_json_number(double value);
void report_put(json_t *object, const char *key, double value);

/* The rows as objects, as the default object has them. */
json_t *report_json_rows(const struct report *report);

/* The column so called as an array, under its key in an object. */
void report_put_column(
    json_t *object, const struct report *report, const char *key);

/* A row for each pair of a text and its value, under two columns. */
void report_pairs(
    struct report *report, const char *const pairs[][2], size_t n);

/* Prints it; JSON is one line.  semicolon: csv has semicolons, and commas in
 * its numbers, as spreadsheets have in Swedish and German. */
void report_print(const struct report *report, enum report_format format,
    bool semicolon, FILE *out);

#endif

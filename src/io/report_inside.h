/* The inside of a report, for the two files that make it up.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_REPORT_INSIDE_H
#define TIPSPEED_IO_REPORT_INSIDE_H

#include "io/report.h"

/* text is what people see; number is exact.  is_text: no number. */
struct cell {
	bool is_text;
	double number;
	char *text;
};

struct report {
	char *command, *title, *site, *provenance, *missing;
	size_t n_column, n_cell, n_note;
	char **key, **head;
	struct cell *cell; /* row by row */
	char **note;
	json_t *json;
	bool json_given; /* it was asked for */
};

/* Length of the provenance's first clause, which says what the data are; the
 * rest says how they were made. */
int report_first_clause(const char *provenance);

void report_print_table(const struct report *r, FILE *out);
void report_print_markdown(const struct report *r, FILE *out);

#endif

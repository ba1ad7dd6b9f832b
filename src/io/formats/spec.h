/* Reads a grading envelope, see tipspeed-spec(5).
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_FORMATS_SPEC_H
#define TIPSPEED_IO_FORMATS_SPEC_H

#include <stdbool.h>
#include <stddef.h>

#include "base/error.h"

/* A grading envelope.  size [n]: m, coarsest first; least, most [n]: passing
 * 0..1, NAN if there is no limit.  cut: the finest and the coarsest size, m, of
 * the fraction that the limits apply to; zeros: the whole product.  Texts are
 * never NULL.  source: "" if not stated; note: as in struct source; standard:
 * "" if read from a file. */
struct spec {
	char *name, *source, *note, *standard;
	double cut[2];
	size_t n;
	double *size, *least, *most;
};

/* Reads a text file, or the first sheet of a workbook.  On failure, returns
 * NULL and adds all faults of the sheet, each with line and column, to errors,
 * which the caller has zeroed; ERROR_SYSTEM if the file cannot be read. */
struct spec *spec_read_file(const char *path, struct error_list *errors);

/* Makes an empty envelope. */
struct spec *spec_new(void);
void spec_free(struct spec *spec);

/* Parses "0/4", in mm, as 0 and 0.004 m.  Returns false if the text does not
 * have this form. */
bool spec_parse_fraction_sizes(const char *text, double cut[static 2]);

#endif

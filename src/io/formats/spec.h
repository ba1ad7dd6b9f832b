/* Reads a grading envelope, see tipspeed-spec(5).
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_FORMATS_SPEC_H
#define TIPSPEED_IO_FORMATS_SPEC_H

#include <stdbool.h>
#include <stddef.h>

#include "base/error.h"

/* size [n] m, coarsest first; least, most [n] passing 0..1, NAN where there is
 * no limit.  cut: the fraction that the limits are for, finest and coarsest
 * size, m; zeros: the product as it is.  Strings are never NULL; source: ""
 * when not stated; note: that of struct source; standard: "" of a file. */
struct spec {
	char *name, *source, *note, *standard;
	double cut[2];
	size_t n;
	double *size, *least, *most;
};

/* Reads a sheet, of a workbook the first.  NULL and all the faults of the
 * sheet, each with its line and column, in errors, a list that the caller has
 * zeroed; ERROR_SYSTEM when the file cannot be read. */
struct spec *spec_read(const char *path, struct error_list *errors);

/* An empty one. */
struct spec *spec_new(void);
void spec_free(struct spec *spec);

/* "0/4" in mm as 0 and 0.004 m; false where it is no such fraction. */
bool spec_read_cut(const char *text, double cut[static 2]);

#endif

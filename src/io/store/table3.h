/* Reads rows of material parameters, as Table 3 of the paper has them.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_STORE_TABLE3_H
#define TIPSPEED_IO_STORE_TABLE3_H

#include <stdbool.h>
#include <stddef.h>

#include "base/error.h"
#include "core/model/params.h"

/* One row, as printed.  top_size_mm mm; f_mat kg/(J m); e0_min J m/kg. */
struct material {
	char *rock, *site, *feed_source;
	double top_size_mm, f_mat, e0_min, alpha;
	bool individual_feeds; /* "Individual" and "Unique Feeds" */
};

struct materials {
	size_t n;
	struct material *row;
};

/* Columns rock,site,top_size_mm,f_mat,feed_source,E0_min,alpha in this order.
 * NULL and the faults of the sheet in errors, a list that the caller has
 * zeroed; ERROR_SYSTEM when the file cannot be read. */
struct materials *materials_read(const char *path, struct error_list *errors);

/* The rows of data/table3.csv as they were when the program was built. */
struct materials *materials_table3(void);

/* The parameters of a row, with the default beta, which is not printed. */
struct params materials_params(const struct material *row);

void materials_free(struct materials *materials);

#endif

/* From a path to sheets.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/source.h"

#include <stdlib.h>

#include "base/xalloc.h"
#include "io/textfile.h"

/* A sieve sheet has some dozen lines, a log one for each minute of months. */
enum { MOST_ROWS = 2000, MOST_LOG = 200000 };

static bool
read_rows(const char *path, size_t most_rows, struct error_list *errors,
    struct source *source)
{
	*source = (struct source){.note = xstrdup("")};
	source->text = textfile_read(path, errors);
	if (source->text == NULL)
		return false;
	source->sheet = xcalloc(1, sizeof(*source->sheet));
	source->sheet[source->n++] =
	    sheet_new(path, source->text, most_rows, errors);
	return true;
}

bool
source_read(const char *path, struct error_list *errors, struct source *source)
{
	return read_rows(path, MOST_ROWS, errors, source);
}

bool
source_read_log(
    const char *path, struct error_list *errors, struct source *source)
{
	return read_rows(path, MOST_LOG, errors, source);
}

void
source_free(struct source *source)
{
	for (size_t i = 0; i < source->n; i++)
		sheet_free(source->sheet[i]);
	free(source->sheet);
	free(source->note);
	free(source->text);
}

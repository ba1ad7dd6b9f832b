/* From a path to sheets.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/source.h"

#include <stdlib.h>

#include "base/xalloc.h"
#include "io/textfile.h"

/* A sieve sheet has some dozen lines. */
enum { MOST_ROWS = 2000 };

bool
source_read(const char *path, struct error_list *errors, struct source *source)
{
	*source = (struct source){.note = xstrdup("")};
	source->text = textfile_read(path, errors);
	if (source->text == NULL)
		return false;
	source->sheet = xcalloc(1, sizeof(*source->sheet));
	source->sheet[source->n++] =
	    sheet_new(path, source->text, MOST_ROWS, errors);
	return true;
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

/* Reads a text file or a workbook as sheets of cells.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/cells/source.h"

#include <stdlib.h>
#include <string.h>

#include "base/xalloc.h"
#include "io/cells/textfile.h"
#include "io/cells/workbook.h"
#include "io/cells/number.h"

/* A sieve sheet has some dozen lines, a long table some for each of its
 * samples, a log one for each minute of months. */
static const struct sheet_limits SITE = {20000, SOURCE_MOST_CELLS},
				 LOG = {.rows = 200000};

/* Takes the sheets and the note. */
static bool
read_workbook(const char *path, const char *bytes, size_t n,
    struct sheet_limits most, struct error_list *errors, struct source *source)
{
	struct grid grid = grid_new(path, most, errors);
	if (!workbook_read(bytes, n, &grid)) {
		grid_clear(&grid);
		return false;
	}
	free(source->note);
	source->n = grid.n;
	source->sheet = grid.sheet;
	source->note = grid.note;
	for (size_t i = 0; i < source->n; i++)
		number_decide(source->sheet[i]);
	return !errors->stopped;
}

static bool
source_read_plain(const char *path, const char *bytes, size_t n,
    struct sheet_limits most, struct error_list *errors, struct source *source)
{
	const char *note;
	source->text = textfile_text(path, bytes, n, &note, errors);
	if (source->text == NULL)
		return false;
	free(source->note);
	source->note = xstrdup(note);
	source->sheet = xcalloc(1, sizeof(*source->sheet));
	source->sheet[source->n++] =
	    sheet_new(path, source->text, most, errors);
	if (source->sheet[0]->too_large || errors->stopped)
		return false;
	number_decide(source->sheet[0]);
	return !errors->stopped;
}

static bool
source_read_rows(const char *path, struct sheet_limits most,
    struct error_list *errors, struct source *source)
{
	size_t n;
	*source = (struct source){.note = xstrdup("")};
	FREED char *bytes = textfile_bytes(path, &n, errors);
	if (bytes == NULL)
		return false;
	return workbook_is(bytes, n)
		   ? read_workbook(path, bytes, n, most, errors, source)
		   : source_read_plain(path, bytes, n, most, errors, source);
}

bool
source_read(const char *path, struct error_list *errors, struct source *source)
{
	return source_read_rows(path, SITE, errors, source);
}

bool
source_read_memory(const char *path, const char *text,
    struct error_list *errors, struct source *source)
{
	*source = (struct source){.note = xstrdup("")};
	return source_read_plain(
	    path, text, strlen(text), SITE, errors, source);
}

bool
source_read_log(
    const char *path, struct error_list *errors, struct source *source)
{
	return source_read_rows(path, LOG, errors, source);
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

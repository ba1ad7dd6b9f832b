/* data/table3.csv and files like it.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/table3.h"

#include <assert.h>
#include <csv.h>
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "base/xalloc.h"

/* Made from data/table3.csv at build time: its rows without the remarks. */
extern const char TABLE3_TEXT[];

enum { CELLS = 7 };

/* The row being read; rows counts all rows, the heading included. */
struct reader {
	struct materials *materials;
	const char *path;
	struct error *error;
	char *cell[CELLS];
	size_t n_cell;
	int line;
	bool heading_seen, failed;
};

static void
cell_done(void *bytes, size_t n, void *data)
{
	struct reader *reader = data;
	if (reader->n_cell < CELLS)
		reader->cell[reader->n_cell] =
		    xstrndup(bytes != NULL ? bytes : "", n);
	reader->n_cell++;
}

static bool
take_row(struct reader *reader)
{
	struct material row = {0};
	double *number[CELLS] = {NULL, NULL, &row.top_size_mm, &row.f_mat, NULL,
	    &row.e0_min, &row.alpha};
	if (reader->n_cell != CELLS)
		return error_at(reader->error, ERROR_DATA, reader->path,
		    reader->line, 1,
		    "%d cells were wanted, found %zu\n"
		    "the columns are those of data/table3.csv; a sheet of "
		    "sieves is for load",
		    (int)CELLS, reader->n_cell);
	for (size_t i = 0; i < CELLS; i++)
		if (number[i] != NULL &&
		    (!text_number(reader->cell[i], number[i]) ||
			!(*number[i] > 0)))
			return error_at(reader->error, ERROR_DATA, reader->path,
			    reader->line, 1,
			    "cell %zu wants a number above 0, not '%s'", i + 1,
			    reader->cell[i]);
	row.rock = xstrdup(reader->cell[0]);
	row.site = xstrdup(reader->cell[1]);
	row.feed_source = xstrdup(reader->cell[4]);
	row.individual_feeds = strncmp(row.feed_source, "Default", 7) != 0;
	struct materials *m = reader->materials;
	m->row = xrealloc(m->row, m->n + 1, sizeof *m->row);
	m->row[m->n++] = row;
	return true;
}

static void
row_done(int end, void *data)
{
	(void)end;
	struct reader *reader = data;
	bool skip = reader->n_cell == 0 ||
		    (reader->n_cell > 0 && reader->cell[0] != NULL &&
			reader->cell[0][0] == '#');
	if (!skip && !reader->heading_seen)
		reader->heading_seen = true;
	else if (!skip && !reader->failed)
		reader->failed = !take_row(reader);
	for (size_t i = 0; i < CELLS; i++) {
		free(reader->cell[i]);
		reader->cell[i] = NULL;
	}
	reader->n_cell = 0;
}

/* One line at a time, so that line numbers stay true. */
static void
read_lines(struct reader *reader, FILE *in)
{
	char line[1024];
	while (!reader->failed && fgets(line, sizeof line, in) != NULL) {
		struct csv_parser parser;
		reader->line++;
		csv_init(&parser, 0);
		csv_parse(
		    &parser, line, strlen(line), cell_done, row_done, reader);
		csv_fini(&parser, cell_done, row_done, reader);
		csv_free(&parser);
	}
}

/* path stands in the messages. */
static struct materials *
read_stream(FILE *in, const char *path, struct error *error)
{
	struct reader reader = {
	    .materials = xcalloc(1, sizeof *reader.materials),
	    .path = path,
	    .error = error};
	read_lines(&reader, in);
	if (!reader.failed && reader.materials->n == 0)
		reader.failed = !error_at(error, ERROR_DATA, path, 0, 0,
		    "no rows of materials found");
	if (!reader.failed)
		return reader.materials;
	materials_free(reader.materials);
	return NULL;
}

struct materials *
materials_read(const char *path, struct error *error)
{
	FILE *in = fopen(path, "r");
	if (in == NULL) {
		error_at(error, ERROR_SYSTEM, path, 0, 0, "cannot read: %s",
		    strerror(errno));
		return NULL;
	}
	struct materials *materials = read_stream(in, path, error);
	fclose(in);
	return materials;
}

struct materials *
materials_table3(void)
{
	char *text = xstrdup(TABLE3_TEXT);
	FILE *in = fmemopen(text, strlen(text), "r");
	struct materials *materials =
	    in != NULL ? read_stream(in, "Table 3", NULL) : NULL;
	/* It is part of the program: the tests read all of it. */
	assert(materials != NULL);
	fclose(in);
	free(text);
	return materials;
}

void
materials_free(struct materials *m)
{
	if (m == NULL)
		return;
	for (size_t i = 0; i < m->n; i++) {
		free(m->row[i].rock);
		free(m->row[i].site);
		free(m->row[i].feed_source);
	}
	free(m->row);
	free(m);
}

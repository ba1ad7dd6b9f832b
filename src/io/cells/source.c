/* Reads a text file or a workbook as sheets of cells: recognises the kind of
 * file and rejects others.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/cells/source.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

#include "base/tr.h"
#include "base/xalloc.h"
#include "io/cells/archive.h"
#include "io/cells/grid.h"
#include "io/cells/number.h"
#include "io/cells/ods.h"
#include "io/cells/textfile.h"
#include "io/cells/xlsx.h"

/* A sieve sheet has some dozen lines; a long table has some dozen for each
 * sample, and a log one for each minute of several months. */
static const struct sheet_limits SITE = {20000, SOURCE_MOST_COLUMNS,
				     SOURCE_MOST_CELLS, 200000},
				 LOG = {.rows = 200000};

static bool
refuse_workbook(const struct sheets *grid, const char *what, const char *step)
{
	return error_set_at(error_list_add_item(grid->errors), ERROR_DATA,
	    grid->path, 0, 0,
	    "%s\n"
	    "%s",
	    what, step);
}

/* True if an OpenDocument workbook has a password: its parts are there but
 * cannot be read. */
static bool
is_password_protected(struct archive *archive)
{
	size_t n;
	FREED char *wrong = NULL;
	if (archive_has_entry(archive, "encrypted-package"))
		return true;
	FREED char *list =
	    archive_unpack_entry(archive, "META-INF/manifest.xml", &n, &wrong);
	return list != NULL && strstr(list, "encryption-data") != NULL;
}

static bool
refuse_other_file_type(struct archive *archive, const struct sheets *grid)
{
	static const char *const NAMES[][2] = {
	    {"xl/workbook.bin", N_("expected .xlsx, .ods or text, got .xlsb")},
	    {"Index/Document.iwa", N_("expected .xlsx, .ods or text, got a "
				      "file from an Apple program")},
	    {"word/document.xml",
		N_("expected a workbook or text, got a Word document")}};
	for (size_t i = 0; i < ARRAY_LEN(NAMES); i++)
		if (archive_has_entry(archive, NAMES[i][0]))
			return refuse_workbook(grid, tr(NAMES[i][1]),
			    tr("save the spreadsheet as .xlsx, or as CSV"));
	return refuse_workbook(grid,
	    tr("expected a workbook or text, got a zip archive"),
	    tr("unpack it, or save the spreadsheet as .xlsx, .ods or CSV"));
}

static bool
refuse_damaged_workbook(const struct sheets *grid, const char *wrong)
{
	FREED char *what =
	    xasprintf(tr("expected a workbook, got a damaged one: %s"), wrong);
	return refuse_workbook(
	    grid, what, tr("open and save it in a spreadsheet program"));
}

static bool
read_archive_to_grid(struct archive *archive, struct sheets *grid)
{
	bool xlsx = archive_has_entry(archive, "xl/workbook.xml");
	if (!xlsx && !archive_has_entry(archive, "content.xml") &&
	    !archive_has_entry(archive, "encrypted-package"))
		return refuse_other_file_type(archive, grid);
	if (!xlsx && is_password_protected(archive))
		return refuse_workbook(grid,
		    tr("expected a workbook without a password, got one with a "
		       "password"),
		    tr("save it without a password"));
	FREED char *wrong =
	    xlsx ? xlsx_read(archive, grid) : ods_read(archive, grid);
	return wrong == NULL || refuse_damaged_workbook(grid, wrong);
}

static bool
read_zip_to_grid(const char *bytes, size_t n, struct sheets *grid)
{
	FREED char *wrong = NULL;
	struct archive *archive =
	    archive_open(bytes, n, ARCHIVE_MOST_BYTES, &wrong);
	bool good = archive != NULL ? read_archive_to_grid(archive, grid)
				    : refuse_damaged_workbook(grid, wrong);
	archive_close(archive);
	return good;
}

static const char MARKED_UP[] =
    N_("expected .xlsx, .ods or text, got HTML or XML"),
		  JSON[] = N_("expected .xlsx, .ods or text, got JSON"),
		  SAVE_TABLE[] = N_("save the table as .xlsx or CSV");

/* Kinds of files that are not read as text, by their first bytes.  An empty zip
 * archive begins with PK\5\6, a split one with PK\7\8.  read: puts the cells
 * into the grid; returns false with one fault if that is not possible.  NULL:
 * the file is refused, with what is wrong and the next step. */
static const struct kind {
	const char *begin;
	bool (*read)(const char *bytes, size_t n, struct sheets *grid);
	const char *wrong, *step;
} KINDS[] = {
    {"PK\3\4", read_zip_to_grid, NULL, NULL},
    {"PK\5\6", read_zip_to_grid, NULL, NULL},
    {"PK\7\x8", read_zip_to_grid, NULL, NULL},
    {"\xD0\xCF\x11\xE0\xA1\xB1\x1A\xE1", NULL,
	N_("expected .xlsx, .ods or text, got an old .xls or a workbook "
	   "with a password"),
	N_("save it as .xlsx without a password")},
    {"<!DOCTYPE", NULL, MARKED_UP, SAVE_TABLE},
    {"<!doctype", NULL, MARKED_UP, SAVE_TABLE},
    {"<html", NULL, MARKED_UP, SAVE_TABLE},
    {"<?xml", NULL, MARKED_UP, SAVE_TABLE},
    {"%PDF", NULL, N_("expected .xlsx, .ods or text, got a PDF"), SAVE_TABLE},
    {"{\"", NULL, JSON, SAVE_TABLE},
    {"[{", NULL, JSON, SAVE_TABLE},
};

/* Returns the kind of a file, or NULL for text. */
static const struct kind *
find_kind_of_file(const char *bytes, size_t n)
{
	for (size_t i = 0; i < ARRAY_LEN(KINDS); i++) {
		size_t length = strlen(KINDS[i].begin);
		if (n >= length && memcmp(bytes, KINDS[i].begin, length) == 0)
			return &KINDS[i];
	}
	return NULL;
}

/* Returns false with a fault if a workbook has no sheet that can be read. */
static bool
check_some_sheet_read(const struct sheets *grid)
{
	if (grid->n > 0)
		return true;
	return grid->note[0] != '\0'
		   ? refuse_workbook(grid,
			 tr("expected a sheet with sieves, got none"),
			 grid->note)
		   : refuse_workbook(grid,
			 tr("expected cells with values, got an empty "
			    "workbook"),
			 tr("save it again in the program that wrote it"));
}

/* Moves the sheets and the note to the source. */
static bool
read_workbook_to_source(const char *path, const char *bytes, size_t n,
    struct sheet_limits most, struct error_list *errors, struct source *source)
{
	struct sheets grid = sheets_new(path, most, errors);
	size_t before = errors->n + errors->more;
	const struct kind *kind = find_kind_of_file(bytes, n);
	bool good = kind->read != NULL ? kind->read(bytes, n, &grid)
				       : refuse_workbook(&grid, tr(kind->wrong),
					     tr(kind->step));
	assert(good || errors->n + errors->more > before);
	sheets_add_count_of_omitted_notes(&grid);
	if (!good || !check_some_sheet_read(&grid)) {
		sheets_clear(&grid);
		return false;
	}
	source->n = grid.n;
	source->sheet = grid.sheet;
	xfree_and_set(&source->note, grid.note);
	for (size_t i = 0; i < source->n; i++)
		number_detect_decimal_sign(source->sheet[i]);
	return !errors->stopped;
}

static bool
source_read_plain_text(const char *path, const char *bytes, size_t n,
    struct sheet_limits most, struct error_list *errors, struct source *source)
{
	const char *note;
	source->text = textfile_decode(path, bytes, n, &note, errors);
	if (source->text == NULL)
		return false;
	xfree_and_set(&source->note, xstrdup(note));
	source->sheet = xcalloc(1, sizeof(*source->sheet));
	source->sheet[source->n++] =
	    sheet_new_from_text(path, source->text, most, errors);
	if (source->sheet[0]->too_large || errors->stopped)
		return false;
	number_detect_decimal_sign(source->sheet[0]);
	return !errors->stopped;
}

static bool
source_read_within_limits(const char *path, struct sheet_limits most,
    struct error_list *errors, struct source *source)
{
	size_t n;
	*source = (struct source){.note = xstrdup("")};
	FREED char *bytes =
	    textfile_read_bytes(path, TEXTFILE_SHEET, &n, errors);
	if (bytes == NULL)
		return false;
	return find_kind_of_file(bytes, n) != NULL
		   ? read_workbook_to_source(
			 path, bytes, n, most, errors, source)
		   : source_read_plain_text(
			 path, bytes, n, most, errors, source);
}

bool
source_read_sheets(
    const char *path, struct error_list *errors, struct source *source)
{
	return source_read_within_limits(path, SITE, errors, source);
}

bool
source_read_from_memory(const char *path, const char *text,
    struct error_list *errors, struct source *source)
{
	*source = (struct source){.note = xstrdup("")};
	return source_read_plain_text(
	    path, text, strlen(text), SITE, errors, source);
}

bool
source_read_plant_log_sheets(
    const char *path, struct error_list *errors, struct source *source)
{
	return source_read_within_limits(path, LOG, errors, source);
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

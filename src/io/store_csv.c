/* Export and import.  Quotes, line numbers and decimal signs are sheet's.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/store_csv.h"

#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "base/xalloc.h"
#include "io/file.h"
#include "io/sheet.h"
#include "io/textfile.h"

/* More lines than that would not fit the 10 MB of a text file. */
enum { MOST_ROWS = 10000 };

static void
write_list(const void *data, FILE *out)
{
	const struct stored_list *list = data;
	for (size_t f = 0; f < FIELD_COUNT; f++)
		fprintf(out, "%s%s", f > 0 ? "," : "", FIELDS[f].name);
	fputc('\n', out);
	for (size_t i = 0; i < list->n; i++) {
		for (size_t f = 0; f < FIELD_COUNT; f++) {
			char *text = stored_written(&list->item[i], &FIELDS[f]);
			if (f > 0)
				fputc(',', out);
			sheet_write_cell(text, out);
			free(text);
		}
		fputc('\n', out);
	}
}

bool
store_csv_save(
    const struct stored_list *list, const char *path, struct error *error)
{
	return file_replace_by(path, FILE_SHARED, write_list, list, error);
}

/* The column of each field, counted from 0; SIZE_MAX: there is none. */
static void
read_head(struct sheet *sheet, size_t column[static FIELD_COUNT])
{
	const struct row *head = &sheet->row[0];
	for (size_t f = 0; f < FIELD_COUNT; f++)
		column[f] = SIZE_MAX;
	for (size_t i = 0; i < head->n; i++) {
		struct cell cell = head->cell[i];
		size_t f = 0;
		while (f < FIELD_COUNT && !text_same(cell.text, FIELDS[f].name))
			f++;
		if (f == FIELD_COUNT)
			sheet_wanted(sheet, cell,
			    "the name of a column of materials",
			    "the columns are those that 'export' writes");
		else if (column[f] != SIZE_MAX)
			sheet_fault(sheet, cell,
			    "column %s was wanted once, found twice",
			    cell.text);
		else
			column[f] = i;
	}
	/* A file of another kind lacks most: the name stands for all. */
	bool other = column[FIELD_NAME] == SIZE_MAX;
	for (size_t f = 0; f < (other ? FIELD_NAME + 1 : FIELD_COUNT); f++)
		if (column[f] == SIZE_MAX)
			sheet_fault(sheet, sheet_cell(head, head->n),
			    "a column %s was wanted, found none\n"
			    "the columns are those that 'export' writes",
			    FIELDS[f].name);
}

/* A number that cannot be read is told already. */
static void
take_value(struct sheet *sheet, struct cell cell, const struct field *f,
    struct stored *m)
{
	double value;
	char *wanted = stored_wanted(f);
	bool read = true;
	if (f->kind == FIELD_TEXT)
		stored_set_text(m, f, cell.text);
	else if ((read = sheet_number(sheet, cell, wanted, &value)))
		stored_set_number(m, f, value);
	if (read && !stored_fits(m, f))
		sheet_wanted(sheet, cell, wanted, NULL);
	free(wanted);
}

static void
take_cell(struct sheet *sheet, struct cell cell, const struct field *f,
    struct stored *m)
{
	uint64_t whole;
	if (cell.text[0] == '\0') {
		if (f->needed)
			sheet_fault(sheet, cell,
			    "%s was wanted, found an empty cell\n"
			    "fill it, or take the row out",
			    f->name);
	} else if (f->kind != FIELD_WHOLE) {
		take_value(sheet, cell, f, m);
	} else if (text_whole(cell.text, &whole) && whole <= INT64_MAX) {
		stored_set_whole(m, f, (int64_t)whole);
	} else {
		sheet_wanted(sheet, cell, "a whole number below 2^63", NULL);
	}
}

static void
check_name(struct sheet *sheet, struct cell cell,
    const struct stored_list *there, const struct stored_list *list)
{
	if (stored_find(list, cell.text) != NULL)
		sheet_fault(sheet, cell,
		    "the name %.60s was wanted once, found again", cell.text);
	else if (there != NULL && stored_find(there, cell.text) != NULL)
		sheet_fault(sheet, cell,
		    "a new name was wanted, and the store has '%.60s' already\n"
		    "import with replace=on takes the sheet's",
		    cell.text);
}

static void
read_row(struct sheet *sheet, const struct row *row,
    const size_t column[static FIELD_COUNT], const struct stored_list *there,
    struct stored_list *list)
{
	struct stored m = stored_new();
	if (row->n > sheet->row[0].n)
		sheet_fault(sheet, row->cell[sheet->row[0].n],
		    "%zu cells were wanted, found more\n"
		    "put quotes round text that holds the separator",
		    sheet->row[0].n);
	for (size_t f = 0; f < FIELD_COUNT; f++)
		take_cell(sheet, sheet_cell(row, column[f]), &FIELDS[f], &m);
	check_name(sheet, sheet_cell(row, column[FIELD_NAME]), there, list);
	stored_list_add(list, m);
}

bool
store_csv_read(const char *path, const struct stored_list *there,
    struct stored_list *list, struct error_list *errors)
{
	char *text = textfile_read(path, errors);
	if (text == NULL)
		return false;
	struct sheet *sheet = sheet_new(path, text, MOST_ROWS, errors);
	size_t column[FIELD_COUNT];
	if (sheet->n_row > 0)
		read_head(sheet, column);
	if (sheet->n_row < 2 && sheet->n_fault == 0)
		sheet_fault(sheet, (struct cell){NULL, 1, 1},
		    "a line of column names and a line for each material were "
		    "wanted, found %zu line%s",
		    sheet->n_row, sheet->n_row == 1 ? "" : "s");
	bool head = sheet->n_fault == 0;
	for (size_t i = 1; head && i < sheet->n_row; i++)
		read_row(sheet, &sheet->row[i], column, there, list);
	bool ok = sheet->n_fault == 0;
	sheet_free(sheet);
	free(text);
	return ok;
}

/* Made-up sheets as a workbook: numbers are numbers there, and what ends in %
 * is a share with a format.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <xlsxwriter.h>

#include "habits.h"

void
sheets_add(struct plan *plan, struct sheets *grid, char *title, bool more)
{
	struct made_file *file = &plan->file[plan->n_file - more];
	if (!more) {
		plan->n_file++;
		snprintf(file->name, sizeof file->name, "%s.xlsx", title);
		file->bytes = xstrdup("");
	}
	xappend(&file->bytes, "[%s]\n", title);
	size_t columns = grid_columns(grid);
	for (size_t r = 0; r < grid->n_row; r++)
		for (size_t c = 0; c < columns; c++)
			xappend(&file->bytes, "%s%s",
			    grid->cell[r][c] != NULL ? grid->cell[r][c] : "",
			    c + 1 < columns ? "\t" : "\n");
	file->n = strlen(file->bytes);
	file->sheet[file->n_sheet] = grid;
	file->title[file->n_sheet++] = title;
}

static void
put_cell(lxw_worksheet *sheet, size_t row, size_t column, const char *text,
    lxw_format *percent)
{
	char *end;
	lxw_row_t r = (lxw_row_t)row;
	lxw_col_t c = (lxw_col_t)column;
	double v = strtod(text, &end);
	bool number = end > text;
	if (number && *end == '\0')
		worksheet_write_number(sheet, r, c, v, NULL);
	else if (number && strcmp(end, "%") == 0)
		worksheet_write_number(sheet, r, c, v / 100, percent);
	else
		worksheet_write_string(sheet, r, c, text, NULL);
}

void
sheets_save(const struct made_file *file, const char *path)
{
	lxw_workbook *book = workbook_new(path);
	lxw_format *percent = workbook_add_format(book);
	format_set_num_format(percent, "0.00%");
	for (size_t i = 0; i < file->n_sheet; i++) {
		const struct sheets *grid = file->sheet[i];
		lxw_worksheet *sheet =
		    workbook_add_worksheet(book, file->title[i]);
		assert_non_null(sheet);
		for (size_t r = 0; r < grid->n_row; r++)
			for (size_t c = 0; c < MOST_CELLS; c++)
				if (grid->cell[r][c] != NULL)
					put_cell(sheet, r, c, grid->cell[r][c],
					    percent);
	}
	assert_int_equal(workbook_close(book), LXW_NO_ERROR);
}

/* A grid of cells, and a file of it.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <iconv.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "habits.h"

void
grid_put(struct sheets *grid, size_t row, size_t column, char *text)
{
	assert_true(row < MOST_ROWS && column < MOST_CELLS);
	free(grid->cell[row][column]);
	grid->cell[row][column] = text;
	if (row >= grid->n_row)
		grid->n_row = row + 1;
}

size_t
grid_columns(const struct sheets *grid)
{
	size_t n = 0;
	for (size_t r = 0; r < grid->n_row; r++)
		for (size_t c = n; c < MOST_CELLS; c++)
			if (grid->cell[r][c] != NULL)
				n = c + 1;
	return n;
}

struct sheets *
grid_turned(const struct sheets *grid)
{
	struct sheets *turned = xcalloc(1, sizeof *turned);
	size_t columns = grid_columns(grid);
	for (size_t r = 0; r < grid->n_row; r++)
		for (size_t c = 0; c < columns; c++)
			if (grid->cell[r][c] != NULL)
				grid_put(
				    turned, c, r, xstrdup(grid->cell[r][c]));
	return turned;
}

void
grid_free(struct sheets *grid)
{
	for (size_t r = 0; r < MOST_ROWS; r++)
		for (size_t c = 0; c < MOST_CELLS; c++)
			free(grid->cell[r][c]);
	free(grid);
}

static bool
is_number(const char *text)
{
	return *text != '\0' && text[strspn(text, "0123456789.,- ")] == '\0';
}

static void
put_cell(const struct plan *plan, const char *text, FILE *out)
{
	const char special[] = {plan->separator, '"', '\n', '\0'};
	bool quotes = strpbrk(text, special) != NULL ||
		      (plan->quotes && !is_number(text) && *text != '\0');
	if (!quotes) {
		fputs(text, out);
		return;
	}
	fputc('"', out);
	for (; *text != '\0'; text++) {
		if (*text == '"')
			fputc('"', out);
		fputc(*text, out);
	}
	fputc('"', out);
}

/* In the coding of the plan; what that cannot say is a fault of the test. */
static void
encode(const struct plan *plan, char *text, size_t n, struct made_file *file)
{
	static const char *const NAMES[] = {
	    "UTF-8", "UTF-8", "WINDOWS-1252", "UTF-16LE", "UTF-16BE"};
	static const char *const MARKS[] = {
	    "", "\xEF\xBB\xBF", "", "\xFF\xFE", "\xFE\xFF"};
	size_t mark = strlen(MARKS[plan->coding]), left = 2 * n + 8;
	file->bytes = xcalloc(left + mark, 1);
	memcpy(file->bytes, MARKS[plan->coding], mark);
	char *to = file->bytes + mark;
	iconv_t how = iconv_open(NAMES[plan->coding], "UTF-8");
	assert_true(how != (iconv_t)-1);
	if (iconv(how, &text, &n, &to, &left) == (size_t)-1)
		fail_msg("seed %llu: not in %s: %.40s",
		    (unsigned long long)plan->seed, NAMES[plan->coding], text);
	iconv_close(how);
	file->n = (size_t)(to - file->bytes);
}

void
plan_text(struct plan *plan, const char *name, const char *text)
{
	struct made_file *file = &plan->file[plan->n_file++];
	char *copy = xstrdup(text);
	snprintf(file->name, sizeof file->name, "%s", name);
	encode(plan, copy, strlen(copy), file);
	free(copy);
}

void
file_clear(struct made_file *file)
{
	for (size_t i = 0; i < file->n_sheet; i++) {
		grid_free(file->sheet[i]);
		free(file->title[i]);
	}
	free(file->bytes);
	*file = (struct made_file){.bytes = NULL};
}

/* Adds a file to the plan, and takes the grid. */
void
grid_write(struct plan *plan, struct sheets *grid, const char *name)
{
	if (plan->workbook) {
		sheets_add(
		    plan, grid, xstrndup(name, strcspn(name, ".")), false);
		return;
	}
	char *text = NULL;
	size_t n = 0, columns = grid_columns(grid);
	FILE *out = open_memstream(&text, &n);
	if (plan->sep_line)
		fprintf(out, "sep=%c%s", plan->separator, plan->line_end);
	for (size_t r = 0; r < grid->n_row; r++) {
		size_t last = columns;
		while (!plan->padded && last > 0 &&
		       grid->cell[r][last - 1] == NULL)
			last--;
		for (size_t c = 0; c < last; c++) {
			const char *cell = grid->cell[r][c];
			if (c > 0)
				fputc(plan->separator, out);
			bool blank = plan->loose && cell != NULL &&
				     strchr(cell, plan->separator) == NULL &&
				     strpbrk(cell, "\"\n") == NULL;
			if (blank && c > 0)
				fputc(' ', out);
			put_cell(plan, cell != NULL ? cell : "", out);
			if (blank && r % 3 == 0)
				fputc(' ', out);
		}
		fputs(plan->line_end, out);
	}
	fclose(out);
	plan_text(plan, name, text);
	free(text);
	grid_free(grid);
}

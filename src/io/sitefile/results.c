/* Determines whether a sheet contains results printed by this program.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/sitefile/results.h"

#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "base/xalloc.h"
#include "io/cells/sheet.h"
#include "io/cells/source.h"
#include "io/cells/textfile.h"

static bool
is_first_cell_equal(const struct sheet *sheet, size_t row, const char *text)
{
	return row < sheet->n_row &&
	       strcmp(row_cell_at(&sheet->row[row], 0).text, text) == 0;
}

static char *
first_word(const char *text)
{
	return xstrndup(text, strcspn(text, " "));
}

/* Results name their site on the sheet "About", a template does not; see
 * add_about_sheet in cmd/session/redirect.c. */
static char *
command_on_about_sheet(const struct sheet *sheet)
{
	static const char OURS[] = "tipspeed ";
	size_t site = 0;
	while (site < sheet->n_row && !is_first_cell_equal(sheet, site, "site"))
		site++;
	bool ours = is_first_cell_equal(sheet, 0, "program") &&
		    strncmp(row_cell_at(&sheet->row[0], 1).text, OURS,
			strlen(OURS)) == 0;
	return ours && is_first_cell_equal(sheet, 1, "command") &&
		       site < sheet->n_row
		   ? first_word(row_cell_at(&sheet->row[1], 1).text)
		   : NULL;
}

/* Returns the command of an answer as text or Markdown, which does not name it,
 * but says how far to trust what it predicts, or has the headings of a plot's
 * numbers; or that of stored materials.  The results may be in another language
 * than the one in use. */
static const char *
command_by_line_of_answer(const struct row *row)
{
	static const char *const TRUST[] = {"trust: ", "trust at ",
	    "warning: trust", "omdöme: ", "omdöme vid ", "varning: omdöme"};
	const char *first = row->cell[0].text,
		   *last = row->cell[row->n - 1].text;
	for (size_t i = 0; i < ARRAY_LEN(TRUST); i++)
		if (strncmp(first, TRUST[i], strlen(TRUST[i])) == 0)
			return "predict";
	if (row->n > 3 && strcmp(first, "name") == 0 &&
	    strcmp(row->cell[1].text, "site") == 0 &&
	    strcmp(row->cell[3].text, "top_size_mm") == 0)
		return "store export";
	bool plot =
	    (strcmp(first, "series") == 0 && strcmp(last, "high") == 0) ||
	    (strcmp(first, "serie") == 0 && strcmp(last, "hög") == 0);
	return plot ? "plot" : NULL;
}

char *
command_that_made_sheet(const struct sheet *sheet)
{
	bool table = is_first_cell_equal(sheet, 0, "command") &&
		     sheet->row[0].n > 1 && sheet->n_row > 1;
	char *command = table ? first_word(sheet->row[1].cell[0].text)
			      : command_on_about_sheet(sheet);
	bool text = sheet->name[0] == '\0';
	for (size_t i = 0; i < sheet->n_row && text && command == NULL; i++) {
		const char *found = command_by_line_of_answer(&sheet->row[i]);
		command = found != NULL ? xstrdup(found) : NULL;
	}
	return command;
}

/* Results as JSON begin with {"command":"predict". */
static char *
command_in_json(const char *bytes, size_t n)
{
	static const char BEGIN[] = "{\"command\":\"";
	const size_t before = strlen(BEGIN);
	if (n < before || memcmp(bytes, BEGIN, before) != 0)
		return NULL;
	const char *name = bytes + before, *end = memchr(name, '"', n - before);
	return end != NULL ? xstrndup(name, (size_t)(end - name)) : NULL;
}

static char *
command_that_made_workbook(const char *path)
{
	struct error_list errors = {0};
	struct source source = {0};
	char *command = NULL;
	bool read = source_read_sheets(path, &errors, &source);
	for (size_t i = 0; read && i < source.n && command == NULL; i++)
		command = command_that_made_sheet(source.sheet[i]);
	source_free(&source);
	return command;
}

char *
command_that_made_file(const char *path)
{
	enum { ENOUGH = 4096, MOST = 100 * 1000 };
	char bytes[ENOUGH], *text = NULL, *command = NULL;
	const char *note;
	struct error_list errors = {0};
	struct stat about;
	/* Not a pipe, which can be read only once. */
	FILE *file = stat(path, &about) == 0 && S_ISREG(about.st_mode)
			 ? fopen(path, "rb")
			 : NULL;
	size_t n = file != NULL ? fread(bytes, 1, sizeof bytes, file) : 0;
	if (file != NULL)
		fclose(file);
	/* A workbook must be read whole; one with results is small. */
	if (n > 2 && memcmp(bytes, "PK", 2) == 0)
		return about.st_size <= MOST ? command_that_made_workbook(path)
					     : NULL;
	if ((command = command_in_json(bytes, n)) != NULL)
		return command;
	while (n > 0 && bytes[n - 1] != '\n')
		n--;
	if (n > 0)
		text = textfile_decode(path, bytes, n, &note, &errors);
	if (text != NULL) {
		const struct sheet_limits most = {.rows = ENOUGH};
		struct sheet *sheet =
		    sheet_new_from_text(path, text, most, &errors);
		command = command_that_made_sheet(sheet);
		sheet_free(sheet);
	}
	free(text);
	return command;
}

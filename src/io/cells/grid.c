/* Collects the cells of a workbook into sheets, within limits.  xlsx.c and
 * ods.c know the file formats.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/cells/grid.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "base/tr.h"
#include "base/xalloc.h"
#include "io/cells/encoding.h"

/* Limits of a workbook and of a sheet.  MOST_BYTES counts a text once for each
 * cell that has it. */
enum { MOST_SHEETS = 200, MOST_BYTES = 10 * 1000 * 1000 };

/* Limits of a cell (Excel allows 32,767 characters), of the number of remarks
 * and of the length of one. */
enum { MOST_CELL = 100 * 1000, MOST_NOTES = 20, MOST_NOTE = 400 };

struct sheets
sheets_new(
    const char *path, struct sheet_limits most, struct error_list *errors)
{
	return (struct sheets){
	    .path = path, .most = most, .errors = errors, .note = xstrdup("")};
}

void
sheets_clear(struct sheets *g)
{
	if (g->now != NULL)
		sheet_free(g->now);
	for (size_t i = 0; i < g->n; i++)
		sheet_free(g->sheet[i]);
	free(g->sheet);
	free(g->note);
}

void
sheets_add_note(struct sheets *g, const char *format, ...)
{
	if (g->n_note++ >= MOST_NOTES)
		return;
	va_list ap;
	va_start(ap, format);
	FREED char *text = xvasprintf(tr(format), ap);
	va_end(ap);
	size_t n = text_bytes_up_to_limit(text, MOST_NOTE);
	xappend_to_list(&g->note, "; ", "%.*s%s", (int)n, text,
	    text[n] != '\0' ? "..." : "");
}

void
sheets_add_count_of_omitted_notes(struct sheets *g)
{
	if (g->n_note > MOST_NOTES)
		xappend_to_list(&g->note, "; ",
		    tr("%zu more remarks on its sheets"),
		    g->n_note - MOST_NOTES);
}

void
sheets_note_too_many_sheets(struct sheets *g, int most)
{
	sheets_add_note(
	    g, "more than %d sheets: the others are not read", most);
}

void
sheets_begin_sheet(struct sheets *g, const char *name)
{
	g->now = sheet_new_empty(g->path, name, g->most, g->errors);
	g->too_big = g->n == MOST_SHEETS ? tr("more than 200 sheets") : NULL;
	g->bytes = 0;
	g->unsolved = g->hidden = false;
}

void
sheets_end_sheet(struct sheets *g)
{
	struct sheet *sheet = g->now;
	g->now = NULL;
	sheet_separate_comment_rows(sheet);
	bool empty = sheet->n_row == 0 && sheet->n_comment == 0;
	if (g->too_big != NULL)
		sheets_add_note(
		    g, "sheet %s is not read: %s", sheet->name, g->too_big);
	else if (!empty && g->hidden)
		sheets_add_note(g,
		    "hidden rows and columns of sheet %s are also read",
		    sheet->name);
	if (!empty && g->unsolved && g->too_big == NULL)
		sheets_add_note(g,
		    "sheet %s has formulas without results: open and save "
		    "the workbook in a spreadsheet program",
		    sheet->name);
	if (empty || g->too_big != NULL) {
		sheet_free(sheet);
		return;
	}
	g->sheet = xrealloc(g->sheet, g->n + 1, sizeof *g->sheet);
	g->sheet[g->n++] = sheet;
}

/* Adds a cell, if there is room, and takes ownership of its text.  Returns
 * false if the text is empty. */
static bool
sheets_put_cell(struct sheets *g, struct cell cell)
{
	bool filled = cell.text[0] != '\0';
	g->bytes += strlen(cell.text);
	if (filled && g->too_big == NULL) {
		if (g->bytes > MOST_BYTES)
			g->too_big = tr("more than 10 MB of text");
		else if (!sheet_has_room_for_cell(g->now, cell))
			g->too_big = (size_t)cell.column > g->now->most.columns
					 ? tr("too many columns")
					 : tr("too many rows or cells");
	}
	if (!filled || g->too_big != NULL)
		free(cell.text);
	else
		sheet_set_cell(g->now, cell);
	return filled;
}

bool
sheets_put_text(struct sheets *g, struct cell where, const char *text)
{
	if (g->too_big == NULL && strlen(text) > MOST_CELL)
		g->too_big = tr("more than 100 kB of text in a cell");
	if (g->too_big != NULL) /* this sheet will be skipped */
		return true;
	FREED char *line = encoding_to_nfc(text);
	char *to = line;
	for (const char *p = line; *p != '\0'; p++) {
		bool blank = *p == '\n' || *p == '\r' || *p == '\t';
		if (blank && to > line && to[-1] == ' ')
			continue;
		*to++ = blank ? ' ' : *p;
	}
	*to = '\0';
	char *said = text_trim(line);
	said += said[0] == '\'' && text_may_be_formula(said);
	where.text = xstrdup(said);
	where.kind = CELL_TEXT;
	return sheets_put_cell(g, where);
}

/* Returns 97.5 for 0.975, without an error in the last bit. */
static double
fraction_to_percent(double value)
{
	char text[32];
	double v = 100 * value;
	snprintf(text, sizeof text, "%.12g", v);
	text_parse_number(text, &v);
	return v;
}

bool
sheets_put_number(
    struct sheets *g, struct cell where, double value, const char *unit)
{
	char text[32];
	where.kind = CELL_NUMBER;
	where.number =
	    strcmp(unit, "%") == 0 ? fraction_to_percent(value) : value;
	where.text =
	    xasprintf("%s%s%s", text_shortest_exact_number(where.number, text),
		unit[0] != '\0' ? " " : "", unit);
	return sheets_put_cell(g, where);
}

bool
sheets_put_date(struct sheets *g, struct cell where, const char *text)
{
	const char *t = strchr(text, 'T');
	size_t n = strlen(text);
	if (t != NULL && strncmp(t, "T00:00:00", 9) == 0)
		n = (size_t)(t - text);
	else if (t != NULL && strlen(t) >= 9 && strncmp(t + 6, ":00", 3) == 0)
		n = (size_t)(t - text) + 6;
	where.text = xstrndup(text, n);
	where.kind = CELL_DATE;
	return sheets_put_cell(g, where);
}

bool
sheets_put_formula(struct sheets *g, struct cell where, const char *formula)
{
	FREED char *text = xasprintf("=%s", formula + (formula[0] == '='));
	g->unsolved = true;
	return sheets_put_text(g, where, text);
}

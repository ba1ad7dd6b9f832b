/* Reads content.xml of an .ods file in one pass.  Styles come first, and tell
 * which sheets are hidden; then come the sheets, with rows of cells.  Rows and
 * cells may be repeated.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/cells/ods.h"

#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "base/xalloc.h"
#include "io/cells/xml.h"

/* MOST_REPEATS: for rows and cells that are not empty; a sheet with more
 * repeats is too large in any case. */
enum { MOST_REPEATS = 5000, MOST_TABLES = 1000 };

/* A cell.  value: from the attribute that belongs to its type, or NULL.  said:
 * the text that people see.  failed: its formula gave an error.  paragraphs: it
 * has at least one. */
struct content {
	char *type, *value, *formula;
	struct xml_text said;
	bool failed, paragraphs;
};

struct reading {
	struct sheets *grid;
	char *style; /* the style of sheets being read, or NULL */
	size_t n_table, n_hidden;
	char **hidden; /* styles whose sheets are hidden */
	/* How deep the parser is inside a sheet, a cell and its paragraphs; 0
	 * is outside. */
	int table, cell, paragraph;
	int skip; /* how deep inside something that is not a cell's content */
	bool visible;
	struct cell at;
	size_t rows, cells; /* how often the row, the cell is repeated */
	struct content content;
	/* The cells of this row. */
	size_t n_kept;
	struct kept {
		int column;
		size_t repeats;
		struct content content;
	} * kept;
};

static void
clear_cell_content(struct content *c)
{
	free(c->type);
	free(c->value);
	free(c->formula);
	free(c->said.text);
	*c = (struct content){0};
}

static char *
copy_text_or_null(const char *text)
{
	return text != NULL ? xstrdup(text) : NULL;
}

static bool
is_style_hidden(const struct reading *r, const char *style)
{
	for (size_t i = 0; style != NULL && i < r->n_hidden; i++)
		if (strcmp(r->hidden[i], style) == 0)
			return true;
	return false;
}

static void
ods_read_style_visibility(
    struct reading *r, const char *name, const char *const *attribute)
{
	enum { MOST_STYLES = 1000 };
	const char *family = xml_attribute_value(attribute, "style:1.0 family");
	const char *shown = xml_attribute_value(attribute, "table:1.0 display");
	if (strcmp(name, "style") == 0 && family != NULL) {
		free(r->style);
		r->style = strcmp(family, "table") == 0
			       ? copy_text_or_null(xml_attribute_value(
				     attribute, "style:1.0 name"))
			       : NULL;
	} else if (strcmp(name, "table-properties") == 0 && r->style != NULL &&
		   shown != NULL && strcmp(shown, "false") == 0 &&
		   r->n_hidden < MOST_STYLES) {
		r->hidden =
		    xrealloc(r->hidden, r->n_hidden + 1, sizeof *r->hidden);
		r->hidden[r->n_hidden++] = xstrdup(r->style);
	}
}

static void
ods_begin_table(struct reading *r, const char *const *attribute)
{
	const char *name = xml_attribute_value(attribute, "table:1.0 name");
	const char *style =
	    xml_attribute_value(attribute, "table:1.0 style-name");
	name = name != NULL ? name : "";
	bool more = ++r->n_table > MOST_TABLES;
	r->visible = !more && !is_style_hidden(r, style);
	r->at = (struct cell){.line = 1};
	if (r->visible)
		sheets_begin_sheet(r->grid, name);
	else if (more && r->n_table == MOST_TABLES + 1)
		sheets_note_too_many_sheets(r->grid, MOST_TABLES);
	else if (!more)
		sheets_add_note(
		    r->grid, "sheet %s is hidden and not read", name);
}

static void
detect_hidden_rows_or_columns(struct reading *r, const char *const *attribute)
{
	const char *seen =
	    xml_attribute_value(attribute, "table:1.0 visibility");
	if (seen != NULL && strcmp(seen, "visible") != 0 && r->visible)
		r->grid->hidden = true;
}

static void
ods_begin_cell(struct reading *r, const char *const *attribute)
{
	static const struct {
		const char *type, *value;
	} VALUES[] = {{"float", "office:1.0 value"},
	    {"percentage", "office:1.0 value"},
	    {"currency", "office:1.0 value"}, {"date", "office:1.0 date-value"},
	    {"time", "office:1.0 time-value"},
	    {"string", "office:1.0 string-value"},
	    {"boolean", "office:1.0 boolean-value"}};
	struct content *c = &r->content;
	const char *type =
	    xml_attribute_value(attribute, "office:1.0 value-type");
	const char *more =
	    xml_attribute_value(attribute, "calcext:1.0 value-type");
	c->type = copy_text_or_null(type);
	c->formula = copy_text_or_null(
	    xml_attribute_value(attribute, "table:1.0 formula"));
	c->failed = more != NULL && strcmp(more, "error") == 0;
	for (size_t i = 0; type != NULL && i < ARRAY_LEN(VALUES); i++)
		if (strcmp(type, VALUES[i].type) == 0)
			c->value = copy_text_or_null(
			    xml_attribute_value(attribute, VALUES[i].value));
	r->cells = xml_attribute_as_integer(
	    attribute, "table:1.0 number-columns-repeated", 1);
}

/* Begins an element within a cell.  Only paragraphs are part of the text that
 * the cell shows; notes, shapes and readings (ruby) are not. */
static void
ods_begin_element_in_cell(
    struct reading *r, const char *name, const char *const *attribute)
{
	static const char *const OTHER[] = {
	    "annotation", "note", "ruby-text", "frame"};
	enum { MOST_SPACES = 100 };
	bool other = r->paragraph == 0 && strcmp(name, "p") != 0;
	for (size_t i = 0; i < ARRAY_LEN(OTHER); i++)
		other = other || strcmp(name, OTHER[i]) == 0;
	if (other || r->skip > 0) {
		r->skip++;
		return;
	}
	if (r->paragraph++ == 0 && r->content.paragraphs)
		xml_text_add(&r->content.said, " ", 1);
	r->content.paragraphs = true;
	size_t n = strcmp(name, "s") == 0
		       ? xml_attribute_as_integer(attribute, "text:1.0 c", 1)
		       : 0;
	n += strcmp(name, "tab") == 0 || strcmp(name, "line-break") == 0;
	for (size_t i = 0; i < n && i < MOST_SPACES; i++)
		xml_text_add(&r->content.said, " ", 1);
}

static void
ods_begin_element(void *data, const char *name, const char *const *attribute)
{
	struct reading *r = data;
	bool cell = strcmp(name, "table-cell") == 0 ||
		    strcmp(name, "covered-table-cell") == 0;
	if (r->skip > 0 && r->cell == 0) {
		r->skip++;
	} else if (r->cell > 0) {
		ods_begin_element_in_cell(r, name, attribute);
	} else if (r->table == 0 && strcmp(name, "table") == 0) {
		r->table = 1;
		ods_begin_table(r, attribute);
	} else if (r->table == 0) {
		r->skip = strcmp(name, "tracked-changes") == 0;
		ods_read_style_visibility(r, name, attribute);
	} else if (strcmp(name, "table-row") == 0) {
		detect_hidden_rows_or_columns(r, attribute);
		r->at.column = 1;
		r->rows = xml_attribute_as_integer(
		    attribute, "table:1.0 number-rows-repeated", 1);
	} else if (strcmp(name, "table-column") == 0) {
		detect_hidden_rows_or_columns(r, attribute);
	} else if (cell) {
		r->cell = 1;
		ods_begin_cell(r, attribute);
	} else if (strcmp(name, "shapes") == 0 || strcmp(name, "forms") == 0) {
		r->skip = 1;
	}
}

static void
ods_append_cell_text(void *data, const char *text, size_t n)
{
	struct reading *r = data;
	if (r->cell > 0 && r->paragraph > 0 && r->skip == 0)
		xml_text_add(&r->content.said, text, n);
}

/* Puts "PT10H15M00S" into the sheet as 10:15. */
static bool
put_ods_duration_as_time(struct sheets *grid, struct cell at, const char *value)
{
	int h, m, n = 0;
	char text[32], second[8] = "";
	if (sscanf(value, "PT%4dH%2dM%n", &h, &m, &n) != 2 || n == 0)
		return sheets_put_date(grid, at, value);
	if (strncmp(value + n, "00", 2) != 0 && strlen(value + n) > 2)
		snprintf(second, sizeof second, ":%.2s", value + n);
	snprintf(text, sizeof text, "%02d:%02d%s", h, m, second);
	return sheets_put_date(grid, at, text);
}

/* Copies to unit what follows the number in a cell's text: "m/s" for a cell
 * that shows "69 m/s", or "". */
static void
copy_unit_after_number(const char *said, char unit[static 16])
{
	size_t n = strlen(said);
	while (n > 0 && !isdigit((unsigned char)said[n - 1]))
		n--;
	const char *rest = said + n + strspn(said + n, " ");
	bool word = isalpha((unsigned char)*rest) || (*rest & 0x80) != 0;
	snprintf(
	    unit, 16, "%s", n > 0 && word && strlen(rest) < 16 ? rest : "");
}

/* Puts a cell into the sheet.  Returns false if it is empty. */
static bool
add_cell_content_to_grid(
    struct sheets *grid, struct cell at, const struct content *c)
{
	double number;
	char unit[16];
	const char *type = c->type != NULL ? c->type : "";
	const char *said = c->said.text != NULL ? c->said.text : "";
	bool numeric = strcmp(type, "float") == 0 ||
		       strcmp(type, "currency") == 0 ||
		       strcmp(type, "percentage") == 0;
	if (c->failed)
		return sheets_put_text(
		    grid, at, said[0] != '\0' ? said : "#VALUE!");
	if (numeric && c->value != NULL &&
	    text_parse_number(c->value, &number)) {
		copy_unit_after_number(said, unit);
		return sheets_put_number(
		    grid, at, number, type[0] == 'p' ? "%" : unit);
	}
	if (strcmp(type, "date") == 0 && c->value != NULL)
		return sheets_put_date(grid, at, c->value);
	if (strcmp(type, "time") == 0 && c->value != NULL)
		return put_ods_duration_as_time(grid, at, c->value);
	if (strcmp(type, "boolean") == 0 && c->value != NULL)
		return sheets_put_text(
		    grid, at, strcmp(c->value, "true") == 0 ? "TRUE" : "FALSE");
	if (strcmp(type, "string") == 0 && c->value != NULL)
		return sheets_put_text(grid, at, c->value);
	if (c->formula != NULL && type[0] == '\0' && said[0] == '\0')
		return sheets_put_formula(grid, at,
		    strchr(c->formula, '=') != NULL ? strchr(c->formula, '=')
						    : c->formula);
	return sheets_put_text(grid, at, said);
}

/* Keeps the cell until its row ends, unless it is empty, as most are. */
static void
ods_end_cell(struct reading *r)
{
	struct content *c = &r->content;
	if (c->type != NULL || c->formula != NULL || c->said.n > 0) {
		r->kept = xgrow_by_one(r->kept, r->n_kept, sizeof *r->kept);
		r->kept[r->n_kept++] =
		    (struct kept){r->at.column, r->cells, *c};
		*c = (struct content){0};
	}
	clear_cell_content(c);
	if (r->at.column < 2000000)
		r->at.column += (int)r->cells;
}

/* Puts a cell into a line as often as it is repeated.  Returns false if it is
 * empty. */
static bool
add_repeated_cell(const struct reading *r, const struct kept *kept, int line)
{
	struct cell at = {.line = line, .column = kept->column};
	for (size_t k = 0;
	     k < kept->repeats && k < MOST_REPEATS && r->grid->too_big == NULL;
	     k++, at.column++)
		if (!add_cell_content_to_grid(r->grid, at, &kept->content))
			return false;
	return true;
}

static void
add_repeated_row(struct reading *r)
{
	size_t most = r->rows < MOST_REPEATS ? r->rows : MOST_REPEATS;
	for (size_t line = 0; line < most && r->n_kept > 0 && r->visible &&
			      r->grid->too_big == NULL &&
			      !error_is_stop_requested(r->grid->errors);
	     line++) {
		size_t n = 0;
		for (size_t i = 0; i < r->n_kept; i++)
			if (add_repeated_cell(
				r, &r->kept[i], r->at.line + (int)line))
				r->kept[n++] = r->kept[i];
			else
				clear_cell_content(&r->kept[i].content);
		r->n_kept = n;
	}
	for (size_t i = 0; i < r->n_kept; i++)
		clear_cell_content(&r->kept[i].content);
	r->n_kept = 0;
	if (r->at.line < 100000000)
		r->at.line += (int)r->rows;
}

static void
ods_end_element(void *data, const char *name)
{
	struct reading *r = data;
	if (r->skip > 0) {
		r->skip--;
	} else if (r->paragraph > 0) {
		r->paragraph--;
	} else if (r->cell > 0) {
		r->cell = 0;
		ods_end_cell(r);
	} else if (r->table > 0 && strcmp(name, "table-row") == 0) {
		add_repeated_row(r);
	} else if (r->table > 0 && strcmp(name, "table") == 0) {
		r->table = 0;
		if (r->visible)
			sheets_end_sheet(r->grid);
	}
}

char *
ods_read(struct archive *archive, struct sheets *grid)
{
	static const struct xml_events EVENTS = {
	    ods_begin_element, ods_end_element, ods_append_cell_text};
	struct reading r = {.grid = grid};
	char *wrong = xml_parse_archive_part(
	    archive, "content.xml", &EVENTS, &r, grid->errors);
	clear_cell_content(&r.content);
	for (size_t i = 0; i < r.n_kept; i++)
		clear_cell_content(&r.kept[i].content);
	for (size_t i = 0; i < r.n_hidden; i++)
		free(r.hidden[i]);
	free(r.kept);
	free(r.hidden);
	free(r.style);
	return wrong;
}

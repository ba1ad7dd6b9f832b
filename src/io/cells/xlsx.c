/* Reads the parts of an .xlsx file one after the other: the list of sheets,
 * strings, formats, then each sheet.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/cells/xlsx.h"

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "base/tr.h"
#include "base/xalloc.h"
#include "io/cells/cell_format.h"
#include "io/cells/xml.h"

/* A file of 50 MB could have millions of them. */
enum { MOST_FORMATS = 100000, MOST_TABS = 1000 };

/* From the workbook: a sheet, with its relation and the part of the archive
 * that it is in; and a format code by its number. */
struct tab {
	char *name, *id, *part;
	bool hidden;
};
struct code {
	unsigned id;
	struct cell_format shown;
};

struct book {
	struct archive *archive;
	struct sheets *grid;
	bool from_1904;
	size_t n_tab, more; /* more: how many sheets were left out */
	struct tab *tab;
	/* All shared strings, each with a NUL, and where each begins. */
	struct xml_text string;
	size_t n_start, *start;
	size_t n_code, n_style;
	struct code *code;
	struct cell_format *style; /* formats of cells, by style index */
	bool in_styles, in_text;
	int phonetic;
};

static bool
is_attribute_true(const char *const *attribute, const char *name)
{
	const char *value = xml_attribute_value(attribute, name);
	return value != NULL &&
	       (strcmp(value, "1") == 0 || strcmp(value, "true") == 0);
}

/* xl/workbook.xml */
static void
begin_workbook_element(
    void *data, const char *name, const char *const *attribute)
{
	struct book *b = data;
	if (strcmp(name, "workbookPr") == 0)
		b->from_1904 = is_attribute_true(attribute, "date1904");
	if (strcmp(name, "sheet") != 0)
		return;
	const char *title = xml_attribute_value(attribute, "name");
	const char *id = xml_attribute_value(attribute, " id");
	const char *state = xml_attribute_value(attribute, "state");
	if (title == NULL || id == NULL)
		return;
	if (b->n_tab == MOST_TABS) {
		if (b->more++ == 0)
			sheets_note_too_many_sheets(b->grid, MOST_TABS);
		return;
	}
	b->tab = xrealloc(b->tab, b->n_tab + 1, sizeof *b->tab);
	b->tab[b->n_tab++] = (struct tab){.name = xstrdup(title),
	    .id = xstrdup(id),
	    .hidden = state != NULL && strcmp(state, "visible") != 0};
}

/* xl/_rels/workbook.xml.rels: the part that each sheet is in.  Charts and macro
 * sheets have other types. */
static void
read_sheet_relation(void *data, const char *name, const char *const *attribute)
{
	struct book *b = data;
	const char *id = xml_attribute_value(attribute, "Id");
	const char *type = xml_attribute_value(attribute, "Type");
	const char *target = xml_attribute_value(attribute, "Target");
	if (strcmp(name, "Relationship") != 0 || id == NULL || type == NULL ||
	    target == NULL || !text_ends_with(type, "/worksheet"))
		return;
	for (size_t i = 0; i < b->n_tab; i++)
		if (strcmp(b->tab[i].id, id) == 0 && b->tab[i].part == NULL)
			b->tab[i].part = target[0] == '/'
					     ? xstrdup(target + 1)
					     : xasprintf("xl/%s", target);
}

/* xl/sharedStrings.xml: <si><t>..</t></si>, or runs <r><t> in several fonts.
 * <rPh> has the pronunciation of Japanese text. */
static void
begin_shared_string_element(
    void *data, const char *name, const char *const *attribute)
{
	struct book *b = data;
	(void)attribute;
	if (strcmp(name, "si") == 0) {
		b->start = xgrow_by_one(b->start, b->n_start, sizeof *b->start);
		b->start[b->n_start++] = b->string.n;
		xml_text_add(&b->string, "", 0);
	}
	b->phonetic += strcmp(name, "rPh") == 0;
	b->in_text = strcmp(name, "t") == 0 && b->n_start > 0;
}

static void
end_shared_string_element(void *data, const char *name)
{
	struct book *b = data;
	b->in_text = false;
	b->phonetic -= strcmp(name, "rPh") == 0;
	if (strcmp(name, "si") == 0)
		xml_text_add(&b->string, "", 1);
}

static void
append_shared_string_text(void *data, const char *text, size_t n)
{
	struct book *b = data;
	if (b->in_text && b->phonetic == 0)
		xml_text_add(&b->string, text, n);
}

/* xl/styles.xml: <numFmt numFmtId formatCode>, then <cellXfs><xf numFmtId>. */
static void
xlsx_begin_style_element(
    void *data, const char *name, const char *const *attribute)
{
	struct book *b = data;
	unsigned id =
	    (unsigned)xml_attribute_as_integer(attribute, "numFmtId", 0);
	const char *code = xml_attribute_value(attribute, "formatCode");
	b->in_styles = b->in_styles || strcmp(name, "cellXfs") == 0;
	if (strcmp(name, "numFmt") == 0 && code != NULL && b->n_code < 1000) {
		b->code = xrealloc(b->code, b->n_code + 1, sizeof *b->code);
		b->code[b->n_code++] =
		    (struct code){id, cell_format_of_code(code)};
	}
	if (!b->in_styles || strcmp(name, "xf") != 0 ||
	    b->n_style == MOST_FORMATS)
		return;
	b->style = xgrow_by_one(b->style, b->n_style, sizeof *b->style);
	b->style[b->n_style] = cell_format_of_builtin_id(id);
	for (size_t i = b->n_code; i-- > 0;)
		if (b->code[i].id == id)
			b->style[b->n_style] = b->code[i].shown;
	b->n_style++;
}

static void
xlsx_end_style_element(void *data, const char *name)
{
	struct book *b = data;
	b->in_styles = b->in_styles && strcmp(name, "cellXfs") != 0;
}

/* A sheet while its part is read.  at: the place of the current cell; a next
 * cell without an address is beside it.  The rest is what has been read of the
 * current cell. */
struct reading {
	struct book *book;
	struct cell at;
	char type[12];
	size_t style;
	bool in_cell, has_value, has_formula;
	int phonetic;
	enum { IN_NOTHING, IN_VALUE, IN_FORMULA, IN_TEXT } in;
	struct xml_text value, formula;
	char *wrong;
};

static void
xlsx_read_cell_start(struct reading *r, const char *const *attribute)
{
	const char *place = xml_attribute_value(attribute, "r");
	const char *type = xml_attribute_value(attribute, "t");
	struct cell at = r->at;
	const char *end = place != NULL ? sheet_parse_cell_address(
					      place, &at.column, &at.line)
					: NULL;
	r->at.column++;
	if (end != NULL && *end == '\0')
		r->at = at;
	snprintf(r->type, sizeof r->type, "%s", type != NULL ? type : "n");
	r->style = xml_attribute_as_integer(attribute, "s", 0);
	r->in_cell = true;
	r->has_value = r->has_formula = false;
	r->value.n = r->formula.n = 0;
	xml_text_add(&r->value, "", 0);
	xml_text_add(&r->formula, "", 0);
}

static void
xlsx_read_row_start(struct reading *r, const char *const *attribute)
{
	size_t next = (size_t)r->at.line + 1;
	size_t line = xml_attribute_as_integer(attribute, "r", next);
	r->at.line = (int)(line > 0 ? line : next);
	r->at.column = 0;
	if (is_attribute_true(attribute, "hidden"))
		r->book->grid->hidden = true;
}

static void
begin_sheet_element(void *data, const char *name, const char *const *attribute)
{
	struct reading *r = data;
	r->in = IN_NOTHING;
	if (strcmp(name, "row") == 0)
		xlsx_read_row_start(r, attribute);
	else if (strcmp(name, "c") == 0)
		xlsx_read_cell_start(r, attribute);
	else if (strcmp(name, "col") == 0 &&
		 is_attribute_true(attribute, "hidden"))
		r->book->grid->hidden = true;
	else if (!r->in_cell)
		return;
	else if (strcmp(name, "rPh") == 0)
		r->phonetic++;
	else if (strcmp(name, "v") == 0)
		r->in = IN_VALUE;
	else if (strcmp(name, "f") == 0)
		r->in = IN_FORMULA;
	else if (strcmp(name, "t") == 0 && r->phonetic == 0)
		r->in = IN_TEXT;
	r->has_formula = r->has_formula || r->in == IN_FORMULA;
	r->has_value = r->has_value || r->in == IN_VALUE || r->in == IN_TEXT;
}

static void
append_sheet_cell_text(void *data, const char *text, size_t n)
{
	struct reading *r = data;
	if (r->in == IN_VALUE || r->in == IN_TEXT)
		xml_text_add(&r->value, text, n);
	else if (r->in == IN_FORMULA)
		xml_text_add(&r->formula, text, n);
}

/* Puts a text into the sheet.  Excel writes a carriage return as _x000D_, and
 * the _ before an x as _x005F_. */
static void
xlsx_put_unescaped_text(struct reading *r, const char *text)
{
	FREED char *copy = xstrdup(text);
	char *to = copy;
	for (const char *p = text; *p != '\0';) {
		unsigned code = 0;
		int n = 0;
		if (p[0] == '_' && p[1] == 'x' &&
		    sscanf(p, "_x%4x_%n", &code, &n) == 1 && n == 7 &&
		    code < 0x80) {
			*to++ = code < ' ' ? ' ' : (char)code;
			p += n;
		} else {
			*to++ = *p++;
		}
	}
	*to = '\0';
	sheets_put_text(r->book->grid, r->at, copy);
}

static void
xlsx_read_number_or_date(struct reading *r)
{
	const struct book *b = r->book;
	double value;
	char date[32];
	struct cell_format shown = r->style < b->n_style
				       ? b->style[r->style]
				       : cell_format_of_builtin_id(0);
	if (!text_parse_number(r->value.text, &value))
		xlsx_put_unescaped_text(r, r->value.text);
	else if (shown.kind != FORMAT_NUMBER &&
		 cell_format_serial_to_text(
		     value, b->from_1904, shown.kind, date))
		sheets_put_date(b->grid, r->at, date);
	else
		sheets_put_number(b->grid, r->at, value, shown.unit);
}

static void
put_shared_string_in_sheet(struct reading *r)
{
	const struct book *b = r->book;
	uint64_t i;
	if (text_parse_whole_number(r->value.text, &i) && i < b->n_start)
		xlsx_put_unescaped_text(r, b->string.text + b->start[i]);
	else if (r->wrong == NULL)
		r->wrong = xasprintf(
		    tr("row %d has a text that is not there"), r->at.line);
}

static void
xlsx_put_cell(struct reading *r)
{
	bool is_text =
	    strcmp(r->type, "str") == 0 || strcmp(r->type, "inlineStr") == 0;
	bool empty = r->value.n == 0;
	if (r->has_formula && (!r->has_value || (empty && !is_text)))
		sheets_put_formula(r->book->grid, r->at, r->formula.text);
	else if (!r->has_value || empty)
		return;
	else if (strcmp(r->type, "s") == 0)
		put_shared_string_in_sheet(r);
	else if (strcmp(r->type, "b") == 0)
		xlsx_put_unescaped_text(
		    r, strcmp(r->value.text, "1") == 0 ? "TRUE" : "FALSE");
	else if (strcmp(r->type, "d") == 0)
		sheets_put_date(r->book->grid, r->at, r->value.text);
	else if (strcmp(r->type, "n") == 0)
		xlsx_read_number_or_date(r);
	else
		xlsx_put_unescaped_text(r, r->value.text);
}

static void
end_sheet_element(void *data, const char *name)
{
	struct reading *r = data;
	r->in = IN_NOTHING;
	r->phonetic -= r->phonetic > 0 && strcmp(name, "rPh") == 0;
	if (!r->in_cell || strcmp(name, "c") != 0)
		return;
	r->in_cell = false;
	if (r->at.line > 0 && r->at.column > 0)
		xlsx_put_cell(r);
}

static char *
xlsx_read_sheet(struct book *b, const struct tab *tab)
{
	static const struct xml_events EVENTS = {
	    begin_sheet_element, end_sheet_element, append_sheet_cell_text};
	struct reading r = {.book = b};
	sheets_begin_sheet(b->grid, tab->name);
	char *wrong = xml_parse_archive_part(
	    b->archive, tab->part, &EVENTS, &r, b->grid->errors);
	free(r.value.text);
	free(r.formula.text);
	if (wrong == NULL && r.wrong != NULL)
		wrong = xasprintf("%s: %s", tab->part, r.wrong);
	else if (wrong == NULL)
		sheets_end_sheet(b->grid);
	free(r.wrong);
	return wrong;
}

static char *
read_visible_sheets(struct book *b)
{
	char *wrong = NULL;
	for (size_t i = 0; i < b->n_tab && wrong == NULL; i++) {
		const struct tab *tab = &b->tab[i];
		if (tab->part != NULL && tab->hidden)
			sheets_add_note(b->grid,
			    "sheet %s is hidden and not read", tab->name);
		else if (tab->part != NULL)
			wrong = xlsx_read_sheet(b, tab);
	}
	return wrong;
}

/* The parts that are read before the sheets. */
static const struct {
	const char *name;
	bool may_lack;
	struct xml_events events;
} PARTS[] = {{"xl/workbook.xml", false, {.begin = begin_workbook_element}},
    {"xl/_rels/workbook.xml.rels", false, {.begin = read_sheet_relation}},
    {"xl/sharedStrings.xml", true,
	{begin_shared_string_element, end_shared_string_element,
	    append_shared_string_text}},
    {"xl/styles.xml", true,
	{xlsx_begin_style_element, xlsx_end_style_element, NULL}}};

char *
xlsx_read(struct archive *archive, struct sheets *grid)
{
	struct book b = {.archive = archive, .grid = grid};
	char *wrong = NULL;
	for (size_t i = 0; i < ARRAY_LEN(PARTS) && wrong == NULL; i++)
		if (!PARTS[i].may_lack ||
		    archive_has_entry(archive, PARTS[i].name))
			wrong = xml_parse_archive_part(archive, PARTS[i].name,
			    &PARTS[i].events, &b, grid->errors);
	if (wrong == NULL)
		wrong = read_visible_sheets(&b);
	for (size_t i = 0; i < b.n_tab; i++) {
		free(b.tab[i].name);
		free(b.tab[i].id);
		free(b.tab[i].part);
	}
	free(b.tab);
	free(b.string.text);
	free(b.start);
	free(b.code);
	free(b.style);
	return wrong;
}

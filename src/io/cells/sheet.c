/* Splits the text of a CSV file into a grid of cells.  It has a parser of its
 * own, because no library records the columns at which cells begin.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/cells/sheet.h"

#include <ctype.h>
#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "base/tr.h"
#include "base/xalloc.h"
#include "io/cells/fixed_width.h"

/* A sheet has a few kB.  The limits keep time and memory small if the file is
 * something else. */
enum {
	MOST_COLUMNS = 256,
	MOST_LINE = 20000,
	SHOWN = 40 /* bytes of a cell quoted in a message */
};

static bool
is_fault_later_in_file(const struct error *a, const struct error *b)
{
	if (strcmp(a->file, b->file) != 0)
		return false;
	return a->line > b->line ||
	       (a->line == b->line && a->column > b->column);
}

/* Makes room for a new fault, in order among those of the same file, and
 * returns its place. */
static struct error *
insert_fault_in_order(struct sheet *sheet, const struct error *e)
{
	struct error_list *list = sheet->errors;
	struct error *slot = error_list_add_item(list);
	size_t i = list->n - 1;
	sheet->n_fault++;
	if (list->more > 0 && !is_fault_later_in_file(&list->item[i], e))
		return slot;
	for (; i > 0 && is_fault_later_in_file(&list->item[i - 1], e); i--)
		list->item[i] = list->item[i - 1];
	return &list->item[i];
}

bool
sheet_report_fault(
    struct sheet *sheet, struct cell where, const char *format, ...)
{
	struct error e;
	va_list ap;
	va_start(ap, format);
	FREED char *file =
	    sheet->name[0] != '\0'
		? xasprintf(tr("%s, sheet %s"), sheet->path, sheet->name)
		: xstrdup(sheet->path);
	error_set_formatted(
	    &e, ERROR_DATA, file, where.line, where.column, format, ap);
	e.in_grid = sheet->name[0] != '\0';
	va_end(ap);
	*insert_fault_in_order(sheet, &e) = e;
	return false;
}

int
sheet_truncated_text_length(const char *text)
{
	return (int)text_bytes_up_to_limit(text, SHOWN);
}

bool
sheet_report_expected(struct sheet *sheet, struct cell found,
    const char *wanted, const char *hint, ...)
{
	va_list ap;
	va_start(ap, hint);
	FREED char *step =
	    hint != NULL ? xvasprintf(tr(hint), ap) : xstrdup("");
	va_end(ap);
	int n = sheet_truncated_text_length(found.text);
	bool cut = found.text[n] != '\0';
	if (n == 0)
		sheet_report_fault(sheet, found,
		    "expected %s, got an empty cell\n"
		    "%s",
		    tr(wanted), step);
	else
		sheet_report_fault(sheet, found,
		    "expected %s, got '%.*s%s'\n"
		    "%s",
		    tr(wanted), n, found.text, cut ? "..." : "", step);
	return false;
}

struct cell
row_cell_at(const struct row *row, size_t i)
{
	if (i < row->n_all)
		return row->cell[i];
	static char nothing[1] = "";
	return (struct cell){.text = nothing,
	    .line = row->line,
	    .column = row->end,
	    .value = AS_ABSENT,
	    .number = NAN};
}

/* A place in a line of text; column counts characters. */
struct cursor {
	const char *p;
	int column;
};

static void
move_to_next_character(struct cursor *c)
{
	do
		c->p++;
	while ((*c->p & 0xC0) == 0x80);
	c->column++;
}

static void
sheet_skip_spaces_and_tabs(struct cursor *c, char separator)
{
	while ((*c->p == ' ' || *c->p == '\t') && *c->p != separator)
		move_to_next_character(c);
}

/* True if a text is within quotes after its ith character.  before: whether it
 * was before that character.  A quote that follows a digit outside quotes means
 * inches, as in 3/4". */
static bool
is_in_quotes_after_char(const char *text, size_t i, bool before)
{
	bool inches = !before && i > 0 && isdigit((unsigned char)text[i - 1]);
	return text[i] == '"' && !inches ? !before : before;
}

/* Moves from the opening quote past the closing one.  Returns false if there is
 * none. */
static bool
skip_quoted_text(struct cursor *c)
{
	move_to_next_character(c);
	while (*c->p != '\0' && (c->p[0] != '"' || c->p[1] == '"')) {
		if (*c->p == '"')
			move_to_next_character(c);
		move_to_next_character(c);
	}
	if (*c->p == '\0')
		return false;
	move_to_next_character(c);
	return true;
}

/* Moves to the separator or the end of the line.  Reports a misplaced quote,
 * unless it means inches, as in 3/4". */
static bool
skip_to_end_of_cell(struct sheet *sheet, struct cursor *c, int line)
{
	struct cell start = {.line = line, .column = c->column};
	const char *first = c->p;
	bool quoted = *c->p == '"';
	if (quoted && !skip_quoted_text(c))
		return sheet_report_fault(sheet, start,
		    "the quote is not closed at the end of the line\n"
		    "close it on the same line; write a quote inside a cell as "
		    "\"\"");
	sheet_skip_spaces_and_tabs(c, sheet->separator);
	while (*c->p != '\0' && *c->p != sheet->separator) {
		size_t at = (size_t)(c->p - first);
		if (quoted || is_in_quotes_after_char(first, at, false)) {
			start.column = c->column;
			return sheet_report_fault(sheet, start,
			    "%s\n"
			    "quote the whole cell and write a quote inside it "
			    "as \"\"",
			    quoted ? tr("text after the closing quote")
				   : tr("a quote inside a cell"));
		}
		move_to_next_character(c);
	}
	return true;
}

/* Adds a cell, which takes ownership of the text. */
static void
append_cell_to_row(struct row *row, char *text, int column)
{
	row->cell = xgrow_by_one(row->cell, row->n_all, sizeof *row->cell);
	row->cell[row->n_all++] =
	    (struct cell){.text = text, .line = row->line, .column = column};
}

/* Adds the cell whose text runs from `from` to before `end`. */
static void
sheet_add_cell(struct row *row, const struct cursor *from, const char *end)
{
	size_t n = (size_t)(end - from->p);
	FREED char *text = *from->p == '"' ? text_without_quotes(from->p, n)
					   : xstrndup(from->p, n);
	const char *said = text_trim(text);
	said += said[0] == '\'' && text_may_be_formula(said);
	append_cell_to_row(row, xstrdup(said), from->column);
	if (row->cell[row->n_all - 1].text[0] != '\0')
		row->n = row->n_all;
}

static bool
split_line_into_cells(struct sheet *sheet, const char *text, struct row *row)
{
	struct cursor c = {text, 1};
	while (row->n_all < sheet->most.columns) {
		sheet_skip_spaces_and_tabs(&c, sheet->separator);
		struct cursor from = c;
		if (!skip_to_end_of_cell(sheet, &c, row->line))
			return false;
		sheet_add_cell(row, &from, c.p);
		row->end = c.column;
		if (*c.p == '\0')
			return true;
		move_to_next_character(&c);
	}
	struct cell end = {.line = row->line, .column = c.column};
	return sheet_report_fault(sheet, end,
	    "more than %zu cells in a line\n"
	    "a site file has a few columns: is this the right file?",
	    sheet->most.columns);
}

static void
free_row_cells(struct row *row)
{
	for (size_t i = 0; i < row->n_all; i++)
		free(row->cell[i].text);
	free(row->cell);
}

/* Adds a row, unless it is empty.  Returns false, with a fault, if the file is
 * too large for a sheet. */
static bool
sheet_add_row(struct sheet *sheet, const char *line, int number)
{
	struct cell start = {.line = number, .column = 1};
	if (strlen(line) > sheet->most.bytes ||
	    sheet->n_row == sheet->most.rows) {
		sheet_report_fault(sheet, start,
		    "more than %zu lines, or %zu bytes in a line\n"
		    "a site file has a few kB: is this the right file?",
		    sheet->most.rows, sheet->most.bytes);
		sheet->lost = sheet->too_large = true;
		return false;
	}
	sheet->row = xgrow_by_one(sheet->row, sheet->n_row, sizeof *sheet->row);
	struct row *row = &sheet->row[sheet->n_row];
	*row = (struct row){.line = number, .end = 1};
	bool good = split_line_into_cells(sheet, line, row);
	sheet->lost = sheet->lost || !good;
	if (!good || row->n == 0) {
		free_row_cells(row);
		return true;
	}
	sheet->n_row++;
	sheet->wide = row->n_all > sheet->wide ? row->n_all : sheet->wide;
	if (sheet->n_row <= sheet->most.cells / sheet->wide)
		return true;
	sheet_report_fault(sheet, start,
	    "expected at most %zu cells, got %zu lines of up to %zu\n"
	    "a site file has a few kB: is this the right file?",
	    sheet->most.cells, sheet->n_row, sheet->wide);
	sheet->lost = sheet->too_large = true;
	return false;
}

/* Adds a line as a row or, if it starts with #, as a comment, which the reader
 * of the sheet may look at.  Skips "sep=;", which some spreadsheets write in
 * the first line. */
static bool
sheet_add_row_or_comment(struct sheet *sheet, const char *line, int number)
{
	const char *first = line + strspn(line, " \t\"");
	if (number == 1 && strncmp(first, "sep=", 4) == 0)
		return true;
	if (*first != '#')
		return sheet_add_row(sheet, line, number);
	size_t n = sheet->n_comment++;
	sheet->comment =
	    xgrow_by_one(sheet->comment, n, sizeof *sheet->comment);
	sheet->comment[n] = (struct comment){.line = number, .text = line};
	return true;
}

const char *
sheet_parse_cell_address(const char *p, int *column, int *line)
{
	*column = *line = 0;
	/* The letters of ASCII, in either case; isalpha knows others in some
	 * locales. */
	for (unsigned i; (i = (*p | 32u) - 'a') < 26 && *column < 1000; p++)
		*column = 26 * *column + (int)i + 1;
	for (; isdigit((unsigned char)*p) && *line < 1000000; p++)
		*line = 10 * *line + (*p - '0');
	return *column > 0 && *line > 0 ? p : NULL;
}

void
sheet_turn_comment_into_row(struct sheet *sheet, size_t i)
{
	struct comment comment = sheet->comment[i];
	size_t last = sheet->n_row;
	memmove(&sheet->comment[i], &sheet->comment[i + 1],
	    (--sheet->n_comment - i) * sizeof comment);
	if (comment.row.cell == NULL)
		sheet_add_row(sheet, comment.text, comment.line);
	else if (sheet->n_row < sheet->most.rows) {
		sheet->row =
		    xgrow_by_one(sheet->row, sheet->n_row, sizeof *sheet->row);
		sheet->row[sheet->n_row++] = comment.row;
	} else
		free_row_cells(&comment.row);
	if (sheet->n_row == last)
		return;
	struct row row = sheet->row[last];
	for (; last > 0 && sheet->row[last - 1].line > row.line; last--)
		sheet->row[last] = sheet->row[last - 1];
	sheet->row[last] = row;
}

/* Returns the length of a line, in which line ends within quotes become spaces,
 * and their number in *ends.  A quote that is not closed within 40 lines ends
 * with its own line, and is reported later. */
static size_t
join_quoted_lines(char *text, int *ends)
{
	enum { MOST_LINES = 40 };
	size_t n = 0, first = strcspn(text, "\r\n");
	int lines = 0;
	bool open = false;
	for (; text[n] != '\0' && lines < MOST_LINES; n++) {
		bool end = text[n] == '\r' || text[n] == '\n';
		if (end && !open)
			break;
		lines += end;
		open = is_in_quotes_after_char(text, n, open);
	}
	*ends = 0;
	if (open || lines == MOST_LINES || n == first)
		return first;
	*ends = lines;
	for (size_t i = 0; i < n; i++)
		if (text[i] == '\r' || text[i] == '\n')
			text[i] = ' ';
	return n;
}

/* Splits a text into lines in place, ends each with a NUL, and adds them. */
static void
add_text_lines_to_sheet(struct sheet *sheet, char *text)
{
	for (int number = 1;
	     *text != '\0' && !error_is_stop_requested(sheet->errors);
	     number++) {
		int ends;
		size_t n = join_quoted_lines(text, &ends);
		bool pair = text[n] == '\r' && text[n + 1] == '\n';
		char *next = text + n + (pair ? 2 : text[n] != '\0');
		text[n] = '\0';
		if (!sheet_add_row_or_comment(sheet, text, number))
			return;
		text = next;
		number += ends;
	}
}

/* True if the line has at least two cells, the first a number or the name of a
 * sieve, the second a number or empty. */
static bool
is_line_of_numbers(const char *line, char separator)
{
	const char stop[] = {separator, '\r', '\n', '\0'};
	/* Including units and no-break spaces. */
	const char *digits = "\" +-.,0123456789eEg%\xC2\xA0\xE2\x80\xAF\x89";
	const char *sieve = "\" +-.,0123456789eE#NOno/inch\xC2\xBA\xB0\xA0";
	size_t n = strcspn(line, stop);
	const char *second = line + n + 1;
	return line[n] == separator && strspn(line, sieve) >= n &&
	       strcspn(line, "0123456789") < n &&
	       strspn(second, digits) >= strcspn(second, stop);
}

static bool
has_sign_outside_quotes(const char *line, char sign)
{
	bool quoted = false;
	size_t n = strcspn(line, "\r\n");
	for (size_t i = 0; i < n; i++) {
		quoted = is_in_quotes_after_char(line, i, quoted);
		if (line[i] == sign && !quoted)
			return true;
	}
	return false;
}

/* Returns the sign that separates cells: the semicolon or tab if half of the
 * lines contain it, else the sign that separates numbers in most lines or, if
 * there are no lines of numbers, the sign that most lines contain.  Counting
 * signs instead would fail where decimal commas outnumber the semicolons. */
static char
find_cell_separator(const char *text, struct error_list *errors)
{
	static const char SIGNS[] = ";\t,";
	size_t numbers[3] = {0}, lines[3] = {0}, filled = 0;
	for (const char *p = text; *p != '\0'; p++) {
		if (p > text && p[-1] != '\n' && p[-1] != '\r')
			continue;
		if (*p == '#')
			continue;
		if (error_is_stop_requested(errors))
			break;
		filled += strcspn(p, "\r\n") > strspn(p, " \t;,");
		for (size_t i = 0; i < 3; i++) {
			numbers[i] += is_line_of_numbers(p, SIGNS[i]);
			lines[i] += has_sign_outside_quotes(p, SIGNS[i]);
		}
	}
	/* Numbers contain neither semicolons nor tabs, so half of the lines are
	 * enough. */
	for (size_t i = 0; i < 2; i++)
		if (2 * lines[i] >= filled && lines[i] > 0)
			return SIGNS[i];
	size_t best = 2;
	bool told = numbers[0] + numbers[1] + numbers[2] > 0;
	const size_t *count = told ? numbers : lines;
	for (size_t i = 3; i-- > 0;)
		if (count[i] > 0 && count[i] >= count[best])
			best = i;
	return SIGNS[best];
}

struct sheet *
sheet_new_empty(const char *path, const char *name, struct sheet_limits most,
    struct error_list *errors)
{
	struct sheet *sheet = xcalloc(1, sizeof *sheet);
	if (most.columns == 0)
		most.columns = MOST_COLUMNS;
	if (most.cells == 0)
		most.cells = most.rows * most.columns;
	if (most.bytes == 0)
		most.bytes = MOST_LINE;
	sheet->path = xstrdup(path);
	sheet->name = xstrdup(name);
	sheet->errors = errors;
	sheet->most = most;
	sheet->separator = '\t';
	return sheet;
}

struct sheet *
sheet_new_from_text(const char *path, char *text, struct sheet_limits most,
    struct error_list *errors)
{
	struct sheet *sheet = sheet_new_empty(path, "", most, errors);
	sheet->separator = fixed_width_convert_to_tabs(text)
			       ? '\t'
			       : find_cell_separator(text, errors);
	add_text_lines_to_sheet(sheet, text);
	return sheet;
}

/* Returns the number of rows up to and including line `line`. */
static size_t
count_rows_to_line(const struct sheet *sheet, int line)
{
	size_t n = 0, end = sheet->n_row;
	/* added in order, as most are */
	if (end > 0 && sheet->row[end - 1].line <= line)
		return end;
	while (n < end) {
		size_t middle = n + (end - n) / 2;
		if (sheet->row[middle].line > line)
			end = middle;
		else
			n = middle + 1;
	}
	return n;
}

bool
sheet_has_room_for_cell(const struct sheet *sheet, struct cell cell)
{
	size_t n = count_rows_to_line(sheet, cell.line);
	bool has_row = n > 0 && sheet->row[n - 1].line == cell.line;
	size_t rows = sheet->n_row + !has_row, wide = (size_t)cell.column;
	wide = wide > sheet->wide ? wide : sheet->wide;
	return wide <= sheet->most.columns && rows <= sheet->most.rows &&
	       rows <= sheet->most.cells / wide;
}

/* Returns the row of a line; inserts one if there is none. */
static struct row *
find_or_insert_sheet_row(struct sheet *sheet, int line)
{
	size_t n = count_rows_to_line(sheet, line);
	if (n > 0 && sheet->row[n - 1].line == line)
		return &sheet->row[n - 1];
	sheet->row = xgrow_by_one(sheet->row, sheet->n_row, sizeof *sheet->row);
	struct row *row = &sheet->row[n];
	memmove(row + 1, row, (sheet->n_row++ - n) * sizeof *row);
	*row = (struct row){.line = line, .end = 1};
	return row;
}

void
sheet_set_cell(struct sheet *sheet, struct cell cell)
{
	struct row *row = find_or_insert_sheet_row(sheet, cell.line);
	size_t at = (size_t)cell.column - 1;
	while (row->n_all <= at)
		append_cell_to_row(row, xstrdup(""), row->end++);
	free(row->cell[at].text);
	row->cell[at] = cell;
	sheet->wide = row->n_all > sheet->wide ? row->n_all : sheet->wide;
	if (cell.text[0] != '\0' && row->n <= at)
		row->n = at + 1;
}

/* True if a row is a remark; "#DIV/0!" and "#N/A" are results of formulas. */
static bool
is_remark_row(const struct row *row)
{
	const char *text = row->cell[0].text;
	bool failed =
	    strcmp(text, "#N/A") == 0 ||
	    (strchr(text, ' ') == NULL &&
		(text_ends_with(text, "!") || text_ends_with(text, "?")));
	return text[0] == '#' && !failed;
}

void
sheet_separate_comment_rows(struct sheet *sheet)
{
	size_t n = 0;
	for (size_t i = 0; i < sheet->n_row; i++) {
		struct row row = sheet->row[i];
		/* A key whose value is empty still needs two cells. */
		if (row.n_all == 1)
			append_cell_to_row(&row, xstrdup(""), row.end++);
		if (row.n == 0) {
			free_row_cells(&row);
		} else if (is_remark_row(&row)) {
			sheet->comment = xgrow_by_one(sheet->comment,
			    sheet->n_comment, sizeof *sheet->comment);
			sheet->comment[sheet->n_comment++] =
			    (struct comment){row.line, row.cell[0].text, row};
		} else {
			sheet->row[n++] = row;
		}
	}
	sheet->n_row = n;
}

void
sheet_free(struct sheet *sheet)
{
	for (size_t i = 0; i < sheet->n_row; i++)
		free_row_cells(&sheet->row[i]);
	for (size_t i = 0; i < sheet->n_comment; i++)
		free_row_cells(&sheet->comment[i].row);
	free(sheet->row);
	free(sheet->comment);
	free(sheet->path);
	free(sheet->name);
	free(sheet);
}

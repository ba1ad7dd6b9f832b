/* Finds the columns of tables in plain text.  Lines of numbers that follow each
 * other are a table if they share columns; each word in the lines above belongs
 * to the column that it stands over.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/cells/fixed_width.h"

#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include "base/xalloc.h"

enum {
	MOST_CELLS = 64,
	MOST_WIDE = 400,
	MOST_HEADS = 4,
	LEAST_LINES = 3 /* fewer lines of numbers are not a table */
};

/* The place of a cell in its line: bytes from `from` to before end, characters
 * from left to before right. */
struct span {
	size_t from, end, left, right;
};

/* A line, without its line end.  numbers: it has at least two cells, and all
 * but the first are numbers.  rule: it has only the characters of a rule, such
 * as - or |. */
struct line {
	char *text;
	size_t n;
	bool numbers, rule;
};

/* The columns of a table; only left and right of each are set. */
struct grid_columns {
	size_t n;
	struct span column[MOST_CELLS];
};

/* Splits a line where there are two or more spaces.  Returns the number of
 * cells, or 0 if there are too many. */
static size_t
split_at_wide_gaps(const struct line *line, struct span *cell)
{
	size_t n = 0, at = 0, characters = 0, blanks = 2;
	for (; at < line->n; at++) {
		unsigned char c = (unsigned char)line->text[at];
		characters += (c & 0xC0) != 0x80;
		if (c == ' ') {
			blanks++;
			continue;
		}
		if (blanks >= 2 && n == MOST_CELLS)
			return 0;
		if (blanks >= 2)
			cell[n++] =
			    (struct span){.from = at, .left = characters};
		cell[n - 1].end = at + 1;
		cell[n - 1].right = characters + 1;
		blanks = 0;
	}
	return n;
}

/* To search for digits, but only to the end of the line. */
static const char DIGIT_OR_END[] = "0123456789\r\n";

/* True for 97,5 and 97.5 %, and for the dash of a missing number.  False if it
 * begins or ends with a comma or semicolon, which then separates cells. */
static bool
is_cell_like_number(const struct line *line, const struct span *cell)
{
	const char *text = line->text + cell->from;
	size_t n = cell->end - cell->from;
	const char *end = text + n - 1;
	bool dash = n == 1 && *text == '-';
	return dash ||
	       (strcspn(text, DIGIT_OR_END) < n &&
		   strspn(text, "<>+-.,0123456789 %") >= n &&
		   strchr(",;", *text) == NULL && strchr(",;", *end) == NULL);
}

static bool
is_line_of_numbers(const struct line *line)
{
	struct span cell[MOST_CELLS];
	size_t n = split_at_wide_gaps(line, cell);
	for (size_t i = 1; i < n; i++)
		if (!is_cell_like_number(line, &cell[i]))
			return false;
	return n > 1 && strchr(",;", line->text[cell[0].end - 1]) == NULL &&
	       memchr(line->text, ';', line->n) == NULL;
}

static bool
is_text_line_of_dashes(const struct line *line)
{
	size_t dashes = 0;
	for (size_t i = 0; i < line->n; i++)
		dashes += strchr("-=_", line->text[i]) != NULL;
	return dashes > 2 && strspn(line->text, "-=_+:| ") >= line->n;
}

/* Lists the lines of a text.  For blank lines, n is 0. */
static struct line *
split_into_lines(char *text, size_t *n)
{
	size_t ends = 1;
	for (const char *p = text; *p != '\0'; p++)
		ends += *p == '\n' || *p == '\r';
	struct line *line = xcalloc(ends, sizeof *line);
	*n = 0;
	for (char *p = text; *p != '\0';) {
		struct line *own = &line[(*n)++];
		size_t length = strcspn(p, "\r\n");
		own->text = p;
		own->n = strspn(p, " ") < length ? length : 0;
		own->rule = is_text_line_of_dashes(own);
		own->numbers = !own->rule && is_line_of_numbers(own);
		p += length;
		p += p[0] == '\r' && p[1] == '\n' ? 2 : p[0] != '\0';
	}
	return line;
}

/* Finds the columns of lines of numbers: runs of characters that at least one
 * line fills. */
static struct grid_columns
find_columns_in_lines(const struct line *line, size_t n)
{
	bool filled[MOST_WIDE + 1] = {false};
	struct grid_columns g = {0};
	struct span cell[MOST_CELLS];
	for (size_t i = 0; i < n; i++) {
		size_t cells = split_at_wide_gaps(&line[i], cell);
		for (size_t k = 0; k < cells; k++)
			for (size_t c = cell[k].left;
			     c < cell[k].right && c < MOST_WIDE; c++)
				filled[c] = true;
	}
	for (size_t c = 1; c < MOST_WIDE && g.n < MOST_CELLS; c++) {
		if (filled[c] && !filled[c - 1])
			g.column[g.n++].left = c;
		if (filled[c])
			g.column[g.n - 1].right = c + 1;
	}
	return g;
}

static size_t
span_distance(const struct span *a, const struct span *b)
{
	return a->left >= b->right   ? a->left - b->right + 1
	       : b->left >= a->right ? b->left - a->right + 1
				     : 0;
}

/* Returns the column that a cell overlaps or is nearest to.  If it overlaps
 * several, their middles decide. */
static size_t
nearest_column_of_span(const struct grid_columns *g, const struct span *cell)
{
	size_t best = 0, least = SIZE_MAX;
	for (size_t i = 0; i < g->n; i++) {
		size_t a = cell->left + cell->right;
		size_t b = g->column[i].left + g->column[i].right;
		size_t off =
		    span_distance(cell, &g->column[i]) * MOST_WIDE * 4 +
		    (a > b ? a - b : b - a);
		if (off < least) {
			least = off;
			best = i;
		}
	}
	return best;
}

/* Widens the columns to hold a line of headings that has one for each.  A
 * heading may begin far to the left of its numbers. */
static void
widen_columns_to_headings(struct grid_columns *g, const struct line *head)
{
	struct span cell[MOST_CELLS];
	if (head->rule || split_at_wide_gaps(head, cell) != g->n)
		return;
	for (size_t i = 0; i < g->n; i++) {
		struct span *own = &g->column[i];
		own->left = cell[i].left < own->left ? cell[i].left : own->left;
		own->right =
		    cell[i].right > own->right ? cell[i].right : own->right;
	}
}

/* A table: its lines of numbers, from first to before end, and the headings
 * above them, from line top.  There is no empty line between. */
struct text_table {
	size_t top, first, end;
	struct grid_columns columns;
};

static struct text_table
find_table_in_text_lines(const struct line *line, size_t first, size_t n)
{
	struct text_table t = {.top = first, .first = first, .end = first};
	while (t.end < n && line[t.end].numbers)
		t.end++;
	t.columns = find_columns_in_lines(&line[first], t.end - first);
	while (t.top > 0 && first - t.top < MOST_HEADS &&
	       line[t.top - 1].n > 0 && !line[t.top - 1].numbers)
		t.top--;
	for (size_t k = t.top; k < first; k++)
		widen_columns_to_headings(&t.columns, &line[k]);
	return t;
}

/* Splits a line and puts tabs between its cells.  g: the columns of its table,
 * which give the number of tabs to put; NULL for a line outside tables, which
 * gets one tab between cells.  Returns the number of cells, or 0 if there are
 * more than columns, two are in one column, or the line is too wide. */
static size_t
separate_line_cells_by_tabs(struct line *line, const struct grid_columns *g,
    struct span cell[static MOST_CELLS])
{
	size_t n = split_at_wide_gaps(line, cell), at[MOST_CELLS] = {0};
	if (g != NULL && (n == 0 || n > g->n || cell[n - 1].right >= MOST_WIDE))
		return 0;
	for (size_t i = 0; i < n; i++) {
		at[i] = g != NULL ? nearest_column_of_span(g, &cell[i]) : i;
		if (i > 0 && at[i] <= at[i - 1])
			return 0;
	}
	for (size_t i = 0; i < n; i++) {
		size_t before = i == 0 ? 0 : cell[i - 1].end;
		size_t tabs = i == 0 ? at[0] : at[i] - at[i - 1];
		for (size_t k = 0; k < tabs && before + k < cell[i].from; k++)
			line->text[before + k] = '\t';
	}
	return n;
}

/* Puts tabs into the lines of a table and into its headings.  Returns false
 * unless every cell has a column of its own, no line of headings begins with a
 * number, and one of them has a heading for each column.  Otherwise a gap could
 * move a number into the column of another sample. */
static bool
separate_table_cells_by_tabs(struct line *line, const struct text_table *t)
{
	struct span cell[MOST_CELLS];
	bool whole = false;
	for (size_t k = t->top; k < t->end; k++) {
		if (line[k].rule)
			continue;
		bool head = k < t->first;
		size_t n =
		    separate_line_cells_by_tabs(&line[k], &t->columns, cell);
		if (n == 0 || (head && is_cell_like_number(&line[k], &cell[0])))
			return false;
		whole = whole || (head && n == t->columns.n);
	}
	return whole;
}

/* Puts tabs into all tables.  Returns false if the columns of one are in doubt,
 * or there are too few lines of numbers. */
static bool
separate_all_tables_by_tabs(struct line *line, size_t n)
{
	size_t numbers = 0;
	for (size_t i = 0; i < n; i++) {
		if (!line[i].numbers)
			continue;
		struct text_table t = find_table_in_text_lines(line, i, n);
		for (; i < t.end; i++)
			numbers +=
			    strcspn(line[i].text, DIGIT_OR_END) < line[i].n;
		i--;
		if (!separate_table_cells_by_tabs(line, &t))
			return false;
	}
	return numbers >= LEAST_LINES;
}

static void
replace_pipes_by_tabs(struct line *line)
{
	char *p = line->text, *last = line->text + line->n;
	while (last > p && last[-1] == ' ')
		last--;
	p += strspn(p, " ");
	if (*p == '|')
		*p++ = ' ';
	if (last > p && last[-1] == '|')
		*--last = ' ';
	for (; p < last; p++)
		*p = *p == '|' ? '\t' : *p;
}

/* True if most lines have a |, which then separates cells. */
static bool
has_bar_separators(const struct line *line, size_t n)
{
	size_t bars = 0, filled = 0;
	for (size_t i = 0; i < n; i++) {
		filled += line[i].n > 0;
		bars += memchr(line[i].text, '|', line[i].n) != NULL;
	}
	return bars > LEAST_LINES && 2 * bars > filled;
}

bool
fixed_width_convert_to_tabs(char *text)
{
	if (strchr(text, '\t') != NULL)
		return false;
	size_t n;
	struct span cell[MOST_CELLS];
	FREED char *copy = xstrdup(text);
	FREED struct line *line = split_into_lines(copy, &n);
	bool bars = has_bar_separators(line, n);
	if (!bars && !separate_all_tables_by_tabs(line, n))
		return false;
	for (size_t i = 0; i < n; i++)
		if (line[i].rule)
			line[i].text[0] = '#';
		else if (bars)
			replace_pipes_by_tabs(&line[i]);
		else if (memchr(line[i].text, '\t', line[i].n) == NULL)
			separate_line_cells_by_tabs(&line[i], NULL, cell);
	memcpy(text, copy, strlen(copy));
	return true;
}

/* Finds the tables on a sheet.  It searches a grid of the cells twice, as it is
 * and transposed, so that sieves always run downward.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/sitefile/layout.h"

#include <ctype.h>
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "base/xalloc.h"
#include "io/cells/datetime.h"
#include "io/sitefile/column_header.h"
#include "io/sitefile/sieve_size.h"
#include "io/sitefile/lexicon.h"
#include "io/cells/number.h"

enum {
	MOST_HEADS = 6,
	MOST_LINES_ABOVE = 20, /* from the headings to a row of speeds */
	MOST_TABLES = 64,
	LEAST_WITHOUT_HEAD = 4 /* sieves of a table without a heading */
};

/* What a cell can be in a table.  means: the meanings of its words, of which
 * `unknown` have none.  head: it can head a column of sieves.  foot: its words
 * say that its line has a sum, a loss or the like.  below: it is a size below
 * which material passes a sieve.  used: it is part of a table that was found.
 * kind, mm: what it is as a sieve. */
struct nature {
	uint64_t means;
	unsigned unknown;
	bool head, foot, below, used;
	enum sieve_kind kind;
	double mm;
};

/* A table that was found: rows first to before last, sieves in column c, their
 * heading in row head (g->n_row: none), numbers before column end.  score: how
 * many sizes are those of real sieves.  unsure: as in struct table. */
struct place {
	size_t c, head, first, last, end;
	int score;
	bool unsure;
};

/* A sheet as a grid.  at, nature [n_row * n_col]: its cells, and what they can
 * be.  In these arrays a row is `down` after the one above, and a column
 * `right` after the one before, so the transposed grid shares them.
 * bare_below: the first column has sizes -16, -11.2, below which material
 * passes.  gap [n_row]: there is an empty line above the row.  number
 * [n_row * n_col], row by row: the first column, from this one on, that has a
 * number, or n_col.  phi [n_col]: the sizes of the column are in phi.  place
 * [n_place]: the tables found. */
struct sheet_grid {
	struct sheet *sheet;
	bool across, bare_below;
	size_t n_row, n_col, down, right;
	struct cell *at;
	struct nature *nature;
	bool *gap, *phi;
	unsigned *number;
	size_t n_place;
	struct place place[MOST_TABLES];
};

static void
add_table_location_in_sheet(struct sheet_grid *g, struct place p)
{
	if (g->n_place < MOST_TABLES)
		g->place[g->n_place++] = p;
}

static size_t
cell_index_at(const struct sheet_grid *g, size_t r, size_t c)
{
	return r * g->down + c * g->right;
}

static struct cell *
cell_at(const struct sheet_grid *g, size_t r, size_t c)
{
	return &g->at[cell_index_at(g, r, c)];
}

static struct nature *
cell_classification_at(const struct sheet_grid *g, size_t r, size_t c)
{
	return &g->nature[cell_index_at(g, r, c)];
}

/* Returns the number of a column in the sheet, or of a line if across. */
static size_t
column_or_line_number(const struct sheet_grid *g, size_t c)
{
	return g->across ? (size_t)g->sheet->row[c].line : c + 1;
}

static bool
is_cell_filled(const struct sheet_grid *g, size_t r, size_t c)
{
	return cell_at(g, r, c)->text[0] != '\0';
}

/* True if there are only comments between two lines of a sheet.  *i: the first
 * comment to look at; it moves on, as the lines come in order. */
static bool
has_only_comments_between(
    const struct sheet *sheet, int line, int next, size_t *i)
{
	int comments = 0;
	for (; *i < sheet->n_comment && sheet->comment[*i].line < next; ++*i)
		comments += sheet->comment[*i].line > line;
	return next - line - 1 <= comments;
}

/* True if a cell can head a column of sieves: it has a word for size or sieve,
 * or only a unit of size, and no word for something else. */
static bool
can_be_sieve_heading(const struct cell *cell, const struct nature *n)
{
	static const uint64_t ELSE = WORD_PASSES | WORD_STAYS | WORD_FEED |
				     WORD_PRODUCT | WORD_ROTOR | WORD_SPEED |
				     WORD_SUMS | WORD_GRAMS | WORD_SHARE |
				     WORD_PERCENT | WORD_PAN;
	/* "n.d." is not a diameter. */
	if (cell->kind != CELL_TEXT || cell->value == AS_ABSENT ||
	    strpbrk(cell->text, "0123456789") != NULL ||
	    text_is_same_folded(cell->text, "top_size_mm"))
		return false;
	uint64_t means = n->means;
	uint64_t units =
	    WORD_MM | WORD_UM | WORD_INCH | WORD_TYLER | WORD_BS | WORD_PHI;
	/* "My" also means micrometre in some languages, but "My quarry" is a
	 * name. */
	bool mine =
	    n->unknown > 0 && text_is_same_but_case(cell->text, "my ", 3);
	if ((means & ELSE) != 0 || mine)
		return false;
	/* "Lower phi" is a limit of a class, not of a specification. */
	uint64_t more =
	    WORD_FILLER | ((means & WORD_PHI) != 0 ? WORD_LIMIT : 0);
	bool unit = (means & units) != 0 && n->unknown <= 1 &&
		    (means & ~units & ~more) == 0;
	bool number =
	    (means & ~(uint64_t)WORD_SAMPLE) == WORD_NUMBER && n->unknown == 0;
	return (means & WORD_SIZE) != 0 || unit || number;
}

static struct nature
classify_sheet_cell(
    const struct sheet *sheet, const struct cell *cell, bool below)
{
	const struct sieve_unit length = {1, SIEVE_NONE};
	struct nature n = {.kind = SIEVE_IS_NONE, .mm = NAN, .below = below};
	size_t unknown = 0;
	if (cell->text[0] == '\0')
		return n;
	n.kind = sieve_read_size(sheet, *cell, length, &n.mm);
	if (cell->kind == CELL_TEXT && cell->value == AS_NUMBER)
		return n;
	/* "3 1/2", in inches or a mesh number, as the heading says */
	if (n.kind == SIEVE_IS_NONE &&
	    sieve_mm_of_name(cell->text, SIEVE_INCH) > 0)
		n.kind = SIEVE_IS_SIZE;
	n.means = lexicon_text_meanings(cell->text, &unknown);
	n.unknown = (unsigned)unknown;
	n.head = can_be_sieve_heading(cell, &n);
	n.foot = n.kind == SIEVE_IS_NONE &&
		 (n.means & (WORD_TOTAL | WORD_LOSS | WORD_WASHED)) != 0;
	return n;
}

/* Finds what each cell can be. */
static void
classify_all_sheet_cells(struct sheet_grid *g)
{
	for (size_t r = 0;
	     r < g->n_row && !error_is_stop_requested(g->sheet->errors); r++)
		for (size_t c = 0; c < g->n_col; c++) {
			struct nature *n = cell_classification_at(g, r, c);
			*n = classify_sheet_cell(
			    g->sheet, cell_at(g, r, c), n->below);
		}
}

static void
find_next_number_of_each_cell(struct sheet_grid *g)
{
	double v;
	g->number = xcalloc(g->n_row * g->n_col + 1, sizeof *g->number);
	for (size_t r = 0;
	     r < g->n_row && !error_is_stop_requested(g->sheet->errors); r++) {
		unsigned next = (unsigned)g->n_col;
		for (size_t c = g->n_col; c-- > 0;) {
			if (number_value_of_cell(*cell_at(g, r, c), &v))
				next = (unsigned)c;
			g->number[r * g->n_col + c] = next;
		}
	}
}

/* True if two sizes are of one sieve, one perhaps in um. */
static bool
are_same_sieve(double a, double b)
{
	const double NEAR = 0.05;
	double apart = fabs(log10(a / b));
	return fmin(apart, fabs(apart - 3)) < NEAR * log10(exp(1));
}

/* Cuts "1/2 in (12.5 mm)" or "4.75 (No. 4)" to one of the two names: that in
 * brackets if it is in mm or um, else the first. */
static void
cut_cell_to_one_sieve_name(const struct sheet *sheet, struct cell *cell)
{
	const struct sieve_unit length = {1, SIEVE_NONE};
	char *text = cell->text, *open = strpbrk(text, "([");
	size_t n = strlen(text);
	double mm, other;
	if (cell->kind != CELL_TEXT || open == NULL ||
	    strchr(")]", text[n - 1]) == NULL)
		return;
	FREED char *copy = xstrdup(text);
	copy[open - text] = copy[n - 1] = '\0';
	char *first = text_trim(copy), *second = copy + (open - text) + 1;
	struct cell a = number_reparse_cell_with_text(sheet, *cell, first),
		    b = number_reparse_cell_with_text(sheet, *cell, second);
	bool metric =
	    (lexicon_text_meanings(second, NULL) & (WORD_MM | WORD_UM)) != 0;
	if (sieve_read_size(sheet, a, length, &mm) != SIEVE_IS_SIZE ||
	    sieve_read_size(sheet, b, length, &other) != SIEVE_IS_SIZE ||
	    (a.value == AS_NUMBER && b.value == AS_NUMBER) ||
	    !are_same_sieve(mm, other))
		return;
	*(metric ? text + n - 1 : open) = '\0';
	*cell = number_reparse_cell_with_text(
	    sheet, *cell, text_trim(metric ? open + 1 : text));
}

static struct sheet_grid
copy_sheet_to_grid(struct sheet *sheet, struct layout_range range)
{
	struct sheet_grid g = {
	    .sheet = sheet, .n_row = sheet->n_row, .right = 1};
	size_t comment = 0;
	const struct cell_range box = range.box;
	for (size_t r = 0; r < g.n_row; r++)
		g.n_col = sheet->row[r].n > g.n_col ? sheet->row[r].n : g.n_col;
	g.down = g.n_col;
	g.at = xcalloc(g.n_row * g.n_col + 1, sizeof *g.at);
	g.nature = xcalloc(g.n_row * g.n_col + 1, sizeof *g.nature);
	g.gap = xcalloc(g.n_row + 1, sizeof *g.gap);
	g.phi = xcalloc(g.n_col + 1, sizeof *g.phi);
	for (size_t r = 0; r < g.n_row; r++) {
		const struct row *row = &sheet->row[r];
		g.gap[r] = r > 0 && !has_only_comments_between(sheet,
					row[-1].line, row->line, &comment);
		for (size_t c = 0; c < g.n_col; c++) {
			struct cell cell = row_cell_at(row, c);
			if (box.bottom > 0 &&
			    (row->line < box.top || row->line > box.bottom ||
				(int)c + 1 < box.left || (int)c >= box.right))
				cell = row_cell_at(row, row->n_all);
			cut_cell_to_one_sieve_name(sheet, &cell);
			*cell_at(&g, r, c) = cell;
		}
	}
	return g;
}

/* Changes "In" to "feed" if there is an "Out", or "Ut 70 m/s", beside it;
 * otherwise it means inch. */
static void
mark_in_beside_out_as_feed(struct sheet_grid *g)
{
	static char feed[] = "feed";
	for (size_t r = 0; r < g->n_row; r++) {
		bool out = false;
		for (size_t c = 0; c < g->n_col && !out; c++) {
			const char *text = cell_at(g, r, c)->text;
			size_t n = strcspn(text, " ");
			out =
			    (n == 3 && text_is_same_but_case(text, "out", n)) ||
			    (n == 2 && text_is_same_but_case(text, "ut", n));
		}
		for (size_t c = 0; c < g->n_col && out; c++)
			if (text_is_same_folded(cell_at(g, r, c)->text, "in"))
				cell_at(g, r, c)->text = feed;
	}
}

/* True if the first column has -16, -11.2, -8, without a unit, for what passes
 * these sieves: all its numbers are below 0, but for a 16 or +16 beside -16,
 * and the sizes of sieves, and some cannot be in phi. */
static bool
has_bare_sizes_below(const struct sheet_grid *g)
{
	enum { LEAST = 3 };
	double v, last = NAN, next;
	size_t below = 0, above = 0, odd = 0;
	for (size_t r = 0; r < g->n_row; r++) {
		if (!number_value_of_cell(*cell_at(g, r, 0), &v))
			continue;
		bool more = r + 1 < g->n_row &&
			    number_value_of_cell(*cell_at(g, r + 1, 0), &next);
		if (v > 0 && v != -last && !(more && v == -next))
			return false;
		if (!sieve_is_standard(fabs(v)))
			return false;
		below += v < 0;
		above += v > 0;
		odd += 4 * v != floor(4 * v) || fabs(v) > SIEVE_MOST_PHI;
		last = v;
	}
	return below >= LEAST && above <= 1 && odd > 0;
}

/* Returns the size in "< 16" or "-16 mm", below which material passes a sieve,
 * or NULL.  -2 is not one, as it may be in phi, unless the first column has
 * such sizes; nor is -16+11.2 mm, which is a class. */
static char *
size_after_less_sign(const struct sheet_grid *g, size_t r, size_t c)
{
	static const char LESS[] = "<", OR_EQUAL[] = "\xE2\x89\xA4";
	const struct cell *cell = cell_at(g, r, c);
	const char *text = cell->text;
	bool first = g->bare_below && c == 0;
	bool minus = text[0] == '-' && strpbrk(text + 1, "-+/") == NULL &&
		     (first || (lexicon_text_meanings(text, NULL) &
				   (WORD_MM | WORD_UM)) != 0);
	size_t n = minus                                    ? 1
		   : strncmp(text, LESS, strlen(LESS)) == 0 ? strlen(LESS)
		   : strncmp(text, OR_EQUAL, strlen(OR_EQUAL)) == 0
		       ? strlen(OR_EQUAL)
		       : 0;
	if (n == 0 || (cell->kind != CELL_TEXT && !(minus && first)))
		return NULL;
	char *size = cell->text + n + strspn(text + n, " =");
	return isdigit((unsigned char)size[0]) ? size : NULL;
}

/* Returns the size in "+16", "> 16 mm" or ">= 16", which material is above, or
 * NULL.  A number in the first column is one if the others there are below
 * theirs. */
static const char *
size_after_greater_sign(const struct sheet_grid *g, size_t r, size_t c)
{
	const struct cell *cell = cell_at(g, r, c);
	const char *text = cell->text;
	double v;
	if (text[0] == '>' || text[0] == '+')
		return text + 1 + strspn(text + 1, " =");
	return g->bare_below && c == 0 && number_value_of_cell(*cell, &v) &&
		       v > 0
		   ? text
		   : NULL;
}

/* The sizes written "< 16" in a line or column: how many of them differ from
 * the one before, and the last. */
struct sizes_below {
	size_t n;
	const char *last;
};

static void
count_size_below_unless_repeated(struct sizes_below *below, const char *size)
{
	below->n += below->last == NULL || strcmp(below->last, size) != 0;
	below->last = size;
}

/* Below or above "+16", gives "-16", "-11.2", "-8" the names of the sieves on
 * which these classes stayed: 11.2, 8, and for the last one the pan's, which it
 * has.  r, c: the cell of "-16"; step: from it to the next class, 1 or -1; in a
 * line if across. */
static void
name_classes_by_lower_size(
    struct sheet_grid *g, size_t r, size_t c, int step, bool across)
{
	struct cell *cell = cell_at(g, r, c);
	for (;;) {
		size_t at = (across ? c : r) + (size_t)step;
		if (at >= (across ? g->n_col : g->n_row))
			return;
		r = across ? r : at;
		c = across ? at : c;
		char *size = size_after_less_sign(g, r, c);
		if (size == NULL)
			return;
		*cell = number_reparse_cell_with_text(g->sheet, *cell, size);
		cell = cell_at(g, r, c);
	}
}

/* Finds "-16" beside "+16", of the same size, so that these are classes. */
static void
name_classes_beside_greatest(struct sheet_grid *g)
{
	for (size_t r = 0; r < g->n_row; r++)
		for (size_t c = 0; c < g->n_col; c++) {
			const char *above = size_after_greater_sign(g, r, c);
			for (int i = 0; i < 4 && above != NULL; i++) {
				int step = i % 2 ? -1 : 1;
				size_t y = r + (size_t)(i < 2 ? step : 0);
				size_t x = c + (size_t)(i < 2 ? 0 : step);
				if (y >= g->n_row || x >= g->n_col)
					continue;
				const char *below =
				    size_after_less_sign(g, y, x);
				if (below != NULL && strcmp(above, below) == 0)
					name_classes_by_lower_size(
					    g, y, x, step, i >= 2);
			}
		}
}

/* Takes "< 16", "< 11.2", "< 8" in one line or column for sieves, and the
 * numbers there for what passes them.  "< 16" alone, or again and again in a
 * long table, is the pan. */
static void
mark_less_than_sizes_as_sieves(struct sheet_grid *g)
{
	enum { LEAST = 3 };
	FREED struct sizes_below *row = xcalloc(g->n_row + 1, sizeof *row);
	FREED struct sizes_below *col = xcalloc(g->n_col + 1, sizeof *col);
	for (size_t r = 0; r < g->n_row; r++)
		for (size_t c = 0; c < g->n_col; c++) {
			char *size = size_after_less_sign(g, r, c);
			if (size == NULL)
				continue;
			count_size_below_unless_repeated(&row[r], size);
			count_size_below_unless_repeated(&col[c], size);
		}
	for (size_t r = 0; r < g->n_row; r++)
		for (size_t c = 0; c < g->n_col; c++) {
			struct cell *cell = cell_at(g, r, c);
			char *size = size_after_less_sign(g, r, c);
			if (size == NULL ||
			    (row[r].n < LEAST && col[c].n < LEAST))
				continue;
			*cell = number_reparse_cell_with_text(
			    g->sheet, *cell, size);
			cell_classification_at(g, r, c)->below = true;
		}
}

/* Shifts the headings of tables written by R, which has no heading for its
 * column of row numbers: the headings are one cell short, and the lines below
 * begin with 1, 2, 3. */
static void
shift_headings_if_one_short(struct sheet_grid *g)
{
	size_t wide = g->n_col;
	double v;
	if (g->n_row < 4 || wide < 3 || is_cell_filled(g, 0, wide - 1) ||
	    !is_cell_filled(g, 0, wide - 2))
		return;
	for (size_t r = 1; r < g->n_row; r++)
		if (!is_cell_filled(g, r, wide - 1) ||
		    !number_value_of_cell(*cell_at(g, r, 0), &v) ||
		    v != (double)r)
			return;
	struct cell none = *cell_at(g, 0, wide - 1);
	for (size_t c = wide - 1; c > 0; c--)
		*cell_at(g, 0, c) = *cell_at(g, 0, c - 1);
	*cell_at(g, 0, 0) = none;
}

/* Returns the transposed grid, which has the same cells. */
static struct sheet_grid
transpose_sheet_grid(const struct sheet_grid *g)
{
	struct sheet_grid t = {.sheet = g->sheet,
	    .across = true,
	    .n_row = g->n_col,
	    .n_col = g->n_row,
	    .down = g->right,
	    .right = g->down,
	    .at = g->at,
	    .nature = g->nature};
	t.gap = xcalloc(t.n_row + 1, sizeof *t.gap);
	t.phi = xcalloc(t.n_col + 1, sizeof *t.phi);
	find_next_number_of_each_cell(&t);
	return t;
}

static void
free_sheet_grid(struct sheet_grid *g)
{
	free(g->gap);
	free(g->phi);
	free(g->number);
	if (g->across) /* the other grid has the rest */
		return;
	free(g->at);
	free(g->nature);
}

/* True if the numbers below a heading that says only "number" are those of ASTM
 * E11 sieves: 4, 8, 16, but not 4, 5, 6, which count something. */
static bool
has_astm_sieve_numbers(const struct sheet_grid *g, size_t r, size_t c)
{
	size_t n = 0;
	double v = NAN, last = NAN, step = 0;
	for (r++; r < g->n_row && !g->gap[r]; r++) {
		const struct cell *cell = cell_at(g, r, c);
		double mm = sieve_mm_of_name(cell->text, SIEVE_ASTM);
		bool number = number_value_of_cell(*cell, &v);
		if (!number && mm == 0)
			break;
		if (number && isnan(mm))
			return false;
		step = n > 0 ? fmax(step, fabs(v - last)) : 0;
		last = v;
		n++;
	}
	return n > 2 && step > 1;
}

/* True for the unit of a value, as in "Rotor diameter | 990 | mm": it is the
 * last of the only three cells in its line. */
static bool
is_unit_after_value(const struct sheet_grid *g, size_t r, size_t c)
{
	double v;
	size_t filled = 0;
	for (size_t k = 0; k < g->n_col && filled <= 3; k++)
		filled += is_cell_filled(g, r, k);
	return filled == 3 && c >= 2 && c < g->n_col &&
	       cell_classification_at(g, r, c)->head &&
	       is_cell_filled(g, r, c - 2) &&
	       !cell_classification_at(g, r, c - 2)->head &&
	       number_value_of_cell(*cell_at(g, r, c - 1), &v);
}

/* True for the value of a header line, as in "site | Sieves": it follows the
 * line's key, and nothing follows it. */
static bool
is_value_of_key(const struct sheet_grid *g, size_t r, size_t c)
{
	size_t at = g->across ? r : c, end = g->across ? g->n_row : g->n_col;
	for (size_t k = 2; at == 1 && k < end; k++)
		if (is_cell_filled(g, g->across ? k : r, g->across ? c : k))
			return false;
	const struct cell *key =
	    cell_at(g, g->across ? 0 : r, g->across ? c : 0);
	return at == 1 && lexicon_site_key_of_text(key->text) != N_KEY;
}

static bool
is_sieve_heading(const struct sheet_grid *g, size_t r, size_t c)
{
	const struct nature *n = cell_classification_at(g, r, c);
	bool number = (n->means & ~(uint64_t)WORD_SAMPLE) == WORD_NUMBER;
	return n->head && !is_unit_after_value(g, r, c) &&
	       !is_value_of_key(g, r, c) &&
	       (!number || has_astm_sieve_numbers(g, r, c));
}

/* True if a heading states phi, and the numbers below it can be in phi.  The
 * letter also means a diameter. */
static bool
is_phi_heading(const struct sheet_grid *g, size_t r, size_t c)
{
	double v;
	if (!is_sieve_heading(g, r, c) ||
	    (cell_classification_at(g, r, c)->means & WORD_PHI) == 0)
		return false;
	for (r++; r < g->n_row && !g->gap[r]; r++)
		if (number_value_of_cell(*cell_at(g, r, c), &v) &&
		    fabs(v) > SIEVE_MOST_PHI)
			return false;
	return true;
}

static enum sieve_kind
sieve_kind_of_cell(const struct sheet_grid *g, size_t r, size_t c, double *mm)
{
	const struct sieve_unit phi = {0, SIEVE_PHI};
	if (g->phi[c])
		return sieve_read_size(g->sheet, *cell_at(g, r, c), phi, mm);
	*mm = cell_classification_at(g, r, c)->mm;
	return cell_classification_at(g, r, c)->kind;
}

static bool
is_sieve_size_or_pan_cell(const struct sheet_grid *g, size_t r, size_t c)
{
	double mm;
	return sieve_kind_of_cell(g, r, c, &mm) != SIEVE_IS_NONE;
}

/* True if row r has a number after column c and before column `end`. */
static bool
has_number_beside(const struct sheet_grid *g, size_t r, size_t c, size_t end)
{
	return c + 1 < end && g->number[r * g->n_col + c + 1] < end;
}

/* Returns the next row below r, before any gap, that has a sieve and numbers
 * beside it; n_row if there is none. */
static size_t
find_sieve_row_below(const struct sheet_grid *g, size_t r, size_t c, size_t end)
{
	for (r++; r < g->n_row && !g->gap[r]; r++) {
		if (is_sieve_heading(g, r, c))
			break;
		if (is_sieve_size_or_pan_cell(g, r, c) &&
		    has_number_beside(g, r, c, end))
			return r;
	}
	return g->n_row;
}

/* True if row r, immediately below the sieves, has numbers but no sieve, and is
 * not a remark. */
static bool
is_row_without_sieve(const struct sheet_grid *g, size_t r, size_t c, size_t end)
{
	const char *text = cell_at(g, r, c)->text;
	bool word =
	    text[0] != '\0' && strchr("-<>#+0123456789", text[0]) == NULL;
	return !g->gap[r] && !word && has_number_beside(g, r, c, end);
}

/* True if row r has a sieve, or numbers and one that cannot be read, "16*". */
static bool
may_be_row_of_sieve(const struct sheet_grid *g, size_t r, size_t c, size_t end)
{
	const struct cell *cell = cell_at(g, r, c);
	struct datetime m;
	bool day = cell->kind == CELL_TEXT && datetime_parse(cell->text, &m);
	return is_sieve_size_or_pan_cell(g, r, c) ||
	       (!day && strpbrk(cell->text, "0123456789") != NULL &&
		   is_row_without_sieve(g, r, c, end));
}

/* Finds the last sieve of a table, and its score.  A blank line ends the table
 * unless another sieve follows, and so does a line of sums.  The heading of
 * another table always ends it. */
static void
find_table_end(const struct sheet_grid *g, struct place *p)
{
	int standard = 0;
	size_t known = 0; /* the next sieve below a line of sums */
	p->last = p->first;
	for (size_t r = p->first; r < g->n_row; r++) {
		double mm;
		enum sieve_kind kind = sieve_kind_of_cell(g, r, p->c, &mm);
		bool numbers = has_number_beside(g, r, p->c, p->end);
		if (is_sieve_heading(g, r, p->c))
			break;
		if (r >= known && cell_classification_at(g, r, p->c)->foot &&
		    (known = find_sieve_row_below(g, r, p->c, p->end)) ==
			g->n_row)
			break;
		if (r > p->first && g->gap[r] &&
		    (kind == SIEVE_IS_NONE || !numbers))
			break;
		if (kind == SIEVE_IS_NONE)
			continue;
		p->last = r + 1;
		standard += kind == SIEVE_IS_SIZE &&
			    (isnan(mm) || sieve_is_standard(mm) ||
				sieve_is_standard(mm / 1000) ||
				sieve_series_of_name(
				    cell_at(g, r, p->c)->text) != SIEVE_NONE);
	}
	while (p->last < g->n_row &&
	       is_row_without_sieve(g, p->last, p->c, p->end))
		p->last++;
	p->score = standard;
}

/* The sizes of a table, from the top: how many there are, how many are above or
 * below the one before, and how many differ from it by 1, as a count of samples
 * does. */
struct sequence {
	size_t n, rises, falls, steps;
};

static struct sequence
count_size_rises_and_falls(const struct sheet_grid *g, const struct place *p)
{
	struct sequence s = {0};
	double mm, last = NAN;
	for (size_t r = p->first; r < p->last; r++) {
		if (sieve_kind_of_cell(g, r, p->c, &mm) != SIEVE_IS_SIZE)
			continue;
		s.rises += mm > last;
		s.falls += mm < last;
		s.steps += fabs(fabs(mm - last) - 1) < 1e-9;
		last = mm;
		s.n++;
	}
	return s;
}

static bool
are_tables_overlapping(const struct place *a, const struct place *b)
{
	return a->first < b->last && b->first < a->last;
}

/* True if two columns of sieves are the lower and upper ends of adjoining
 * classes, whose mass is retained on the lower end. */
static bool
are_columns_class_ends(
    const struct sheet_grid *g, const struct place *low, const struct place *up)
{
	double a, b, last = NAN;
	size_t n = 0, joined = 0;
	for (size_t r = low->first; r < low->last; r++) {
		if (!number_value_of_cell(*cell_at(g, r, low->c), &a) ||
		    !number_value_of_cell(*cell_at(g, r, up->c), &b) || a >= b)
			return false;
		joined += b == last;
		last = a;
		n++;
	}
	return n > 2 && joined + 1 == n;
}

/* Of two headings above the same sieves, keeps only the lower one.  Of two
 * adjacent columns of sieves (No. and mm), keeps only the one with more real
 * sizes; the other becomes an ordinary column of the table. */
static void
drop_duplicate_headings(struct sheet_grid *g)
{
	size_t kept = 0;
	for (size_t i = 0; i < g->n_place; i++) {
		bool drop = false;
		for (size_t k = 0; k < g->n_place && !drop; k++) {
			const struct place *a = &g->place[i], *b = &g->place[k];
			if (k == i || !are_tables_overlapping(a, b))
				continue;
			if (a->c == b->c)
				drop = b->first - b->head < a->first - a->head;
			else if (a->c + 1 == b->c || b->c + 1 == a->c)
				drop = is_sieve_heading(g, a->head, a->c) &&
				       !are_columns_class_ends(g, a, b) &&
				       (are_columns_class_ends(g, b, a) ||
					   b->score > a->score ||
					   (b->score == a->score && k < i));
		}
		if (!drop)
			g->place[kept++] = g->place[i];
	}
	g->n_place = kept;
}

/* Finds the tables below headings of sieves. */
static void
find_tables_with_headings(struct sheet_grid *g)
{
	for (size_t r = 0;
	     r < g->n_row && !error_is_stop_requested(g->sheet->errors); r++)
		for (size_t c = 0; c < g->n_col; c++) {
			if (!is_sieve_heading(g, r, c))
				continue;
			/* The column immediately beside it has the same sieves
			 * in other words. */
			size_t end = c + 2;
			while (end < g->n_col && !is_sieve_heading(g, r, end))
				end++;
			end = end < g->n_col ? end : g->n_col;
			struct place p = {c, r, r + 1, 0, end, 0, false};
			g->phi[c] = g->phi[c] || is_phi_heading(g, r, c);
			while (p.first < g->n_row &&
			       p.first < r + 1 + MOST_HEADS &&
			       !is_sieve_size_or_pan_cell(g, p.first, c) &&
			       !(p.first < r + 4 &&
				   may_be_row_of_sieve(g, p.first, c, end)) &&
			       !is_sieve_heading(g, p.first, c))
				p.first++;
			if (p.first == g->n_row ||
			    !may_be_row_of_sieve(g, p.first, c, end))
				continue;
			find_table_end(g, &p);
			/* "Sieve analysis" is a title above other headings. */
			struct sequence size =
			    count_size_rises_and_falls(g, &p);
			bool title =
			    p.first > r + 1 && size.steps + 1 == size.n;
			if (p.last > p.first && !title)
				add_table_location_in_sheet(g, p);
		}
	drop_duplicate_headings(g);
}

/* True if the first cells of a line of the sheet are headings of their columns,
 * not the label of that line: there are several, or a number or a feed is
 * below. */
static bool
are_column_headings(const struct sheet_grid *g, size_t r, size_t c)
{
	if (r > 1 && is_cell_filled(g, r - 1, c))
		return true;
	return c + 1 < g->n_col &&
	       (strpbrk(cell_at(g, 0, c + 1)->text, "0123456789") != NULL ||
		   (cell_classification_at(g, 0, c + 1)->means & WORD_FEED) !=
		       0);
}

/* True if the cell above the numbers, or at the start of their line, says that
 * they are times, remarks or speeds. */
static bool
is_heading_of_other_than_sieves(const struct sheet_grid *g, size_t r, size_t c)
{
	const uint64_t other = WORD_OTHER | WORD_SPEED;
	if (r == 0 || (g->across && are_column_headings(g, r, c)))
		return false;
	uint64_t means =
	    cell_classification_at(g, g->across ? 0 : r - 1, c)->means;
	return (means & other) != 0 && (means & WORD_SIZE) == 0;
}

/* Finds tables without headings: numbers that only fall or only rise, but not
 * as a count does, and nearly all of which are sizes of real sieves. */
static void
find_tables_without_headings(struct sheet_grid *g)
{
	for (size_t c = 0; c < g->n_col && g->n_place == 0; c++)
		for (size_t r = 0;
		     r < g->n_row && !error_is_stop_requested(g->sheet->errors);
		     r++) {
			struct place p = {
			    c, g->n_row, r, 0, g->n_col, 0, false};
			double mm;
			if (sieve_kind_of_cell(g, r, c, &mm) != SIEVE_IS_SIZE)
				continue;
			find_table_end(g, &p);
			struct sequence size =
			    count_size_rises_and_falls(g, &p);
			while (p.first > 0 &&
			       sieve_kind_of_cell(g, p.first - 1, c, &mm) ==
				   SIEVE_IS_PAN &&
			       has_number_beside(g, p.first - 1, c, g->n_col))
				p.first--;
			bool ordered = size.rises + 1 == size.n ||
				       size.falls + 1 == size.n;
			if (size.n >= LEAST_WITHOUT_HEAD && ordered &&
			    size.steps + 1 != size.n &&
			    !is_heading_of_other_than_sieves(g, p.first, c) &&
			    p.score * 5 >= (int)size.n * 4)
				add_table_location_in_sheet(g, p);
			r = p.last > r ? p.last - 1 : r;
		}
}

/* Returns the row after the last of a series of numbers that only rise or only
 * fall, from row r of column c down.  *sizes: they may be sizes, because all
 * are above 0, they span a factor of 4 or more, and their steps differ, as
 * those of a count or a time do not; or because *phi.  *phi: they are quarters
 * of phi, some below 0. */
static size_t
end_of_ordered_numbers(
    const struct sheet_grid *g, size_t r, size_t c, bool *sizes, bool *phi)
{
	double v, last = NAN, step = NAN, least = INFINITY, most = 0;
	bool even = true, quarters = true;
	for (; r < g->n_row && !g->gap[r]; r++) {
		if (!number_value_of_cell(*cell_at(g, r, c), &v) ||
		    (!isnan(step) && (v - last) * step <= 0) || v == last ||
		    !has_number_beside(g, r, c, g->n_col))
			break;
		even = even && (isnan(step) ||
				   fabs(v - last - step) < 1e-6 * fabs(step));
		quarters = quarters && 4 * v == floor(4 * v) &&
			   fabs(v) <= SIEVE_MOST_PHI;
		step = v - last;
		last = v;
		least = fmin(least, v);
		most = fmax(most, v);
	}
	*phi = quarters && least < 0;
	*sizes = *phi || (least > 0 && most >= 4 * least && !even);
	return r;
}

/* Finds the first series of numbers in a column that may be sizes and have
 * numbers beside them.  below_0: as in find_tables_by_number_series; *phi: they
 * may be in phi. */
static bool
find_ordered_numbers(const struct sheet_grid *g, size_t c, bool below_0,
    struct place *p, bool *phi)
{
	for (size_t r = 0;
	     r < g->n_row && !error_is_stop_requested(g->sheet->errors); r++) {
		bool sizes;
		size_t first = r;
		size_t end = end_of_ordered_numbers(g, r, c, &sizes, phi);
		r = end > r ? end - 1 : r;
		const struct place *upper = &g->place[0];
		bool head = first > 0 && is_cell_filled(g, first - 1, c);
		bool like =
		    g->n_place == 0 ||
		    (first == upper->first && head &&
			strcmp(cell_at(g, first - 1, c)->text,
			    cell_at(g, first - 1, upper->c)->text) == 0);
		if (end < first + LEAST_WITHOUT_HEAD || !sizes ||
		    is_heading_of_other_than_sieves(g, first, c) || !like ||
		    (below_0 && !*phi))
			continue;
		head = head && !is_sieve_size_or_pan_cell(g, first - 1, c);
		*p = (struct place){c, head ? first - 1 : g->n_row, first, end,
		    g->n_col, (int)(end - first), true};
		return true;
	}
	return false;
}

/* Takes series of numbers for sieves, though no heading and no sieve tells: the
 * first such series in each column that has numbers beside it.  Those after the
 * first must have its heading.  They may be something else.  below_0: only
 * series in phi with values below 0. */
static void
find_tables_by_number_series(struct sheet_grid *g, bool below_0)
{
	for (size_t c = 0; c + 1 < g->n_col; c++) {
		struct place p;
		bool phi;
		if (!find_ordered_numbers(g, c, below_0, &p, &phi))
			continue;
		add_table_location_in_sheet(g, p);
		g->phi[c] = g->phi[c] || phi;
	}
}

/* Finds the tables in a column that has sieves according to the user, each from
 * the first sieve with numbers beside it. */
static void
find_tables_in_column(struct sheet_grid *g, size_t c)
{
	for (size_t r = 0;
	     r < g->n_row && !error_is_stop_requested(g->sheet->errors); r++) {
		struct place p = {c, r, r, 0, g->n_col, 0, false};
		if (!may_be_row_of_sieve(g, r, c, g->n_col) ||
		    !has_number_beside(g, r, c, g->n_col))
			continue;
		find_table_end(g, &p);
		p.head = r > 0 ? r - 1 : g->n_row;
		p.score += (int)(p.last - p.first);
		if (p.last >= p.first + 2)
			add_table_location_in_sheet(g, p);
		r = p.last > r ? p.last - 1 : r;
	}
}

static void
find_tables_in_given_columns(
    struct sheet_grid *g, const struct layout_range *range)
{
	g->n_place = 0;
	for (size_t i = 0; i < range->n_sieves; i++)
		for (size_t c = 0; c < g->n_col; c++) {
			if (column_or_line_number(g, c) != range->sieves[i])
				continue;
			g->phi[c] = g->phi[c] || range->phi;
			find_tables_in_column(g, c);
		}
}

/* True if row r, above the heading of the sieves, is a heading too: it
 * describes the columns, and is neither a key with its value nor a title; or it
 * has only a label such as "% passing" that is about all columns. */
static bool
is_further_heading_row(
    const struct sheet_grid *g, size_t r, const struct place *p, size_t end)
{
	const uint64_t all =
	    WORD_PASSES | WORD_STAYS | WORD_PERCENT | WORD_GRAMS | WORD_MASS;
	const struct nature *n = cell_classification_at(g, r, p->c);
	size_t filled = 0;
	for (size_t k = p->c + 1; k < end; k++)
		filled += is_cell_filled(g, r, k);
	if (filled == 0)
		return g->across && (n->means & all) != 0 && n->unknown == 0;
	if (!is_cell_filled(g, r, p->c))
		return true;
	if (filled == 2 && is_unit_after_value(g, r, p->c + 2))
		return false;
	const char *key = cell_at(g, r, p->c)->text;
	/* "Quarry,,A,B" describes the columns, as none is above the feed; so
	 * does "Rock:,,granite,gneiss". */
	if (!g->across && lexicon_site_key_of_text(key) != N_KEY)
		return filled > 1 && ((lexicon_is_label_of_sites(key) &&
					  !is_cell_filled(g, r, p->c + 1)) ||
					 text_ends_with(key, ":"));
	/* The command add writes a line such as cut, "72 m/s, 2026-05-04". */
	if (strcmp(key, "cut") == 0 && filled == 1 &&
	    strstr(cell_at(g, r, p->c + 1)->text, ", ") != NULL)
		return false;
	struct head first = heading_parse(cell_at(g, r, p->c)->text);
	bool of_columns =
	    first.unit != SPEED_NO_UNIT ||
	    (first.means & (WORD_SPEED | WORD_SAMPLE | WORD_SIZE)) != 0;
	return filled > 1 || g->across || (of_columns && end == p->c + 2);
}

/* Adds row r of the grid to a list of rows of a table. */
static void
append_sheet_table_row(const struct sheet_grid *g, size_t r, struct table *t,
    struct row **list, size_t *n_list)
{
	size_t n = t->n_col;
	struct row row = {
	    .n = n, .n_all = n, .cell = xcalloc(n, sizeof *row.cell)};
	for (size_t i = 0; i < n; i++) {
		row.cell[i] = *cell_at(g, r, t->column[i]);
		cell_classification_at(g, r, t->column[i])->used = true;
	}
	row.line = row.cell[0].line;
	row.end = row.cell[n - 1].column;
	*list = xgrow_by_one(*list, *n_list, sizeof **list);
	(*list)[(*n_list)++] = row;
}

/* True if a line above the sieves, which are in a line too, has at most one of
 * their cells and is no sample: "Rotor mm; 840". */
static bool
is_key_above_sieves(const struct sheet_grid *g, const struct place *p, size_t c)
{
	uint64_t means = cell_classification_at(g, 0, c)->means;
	size_t cells = 0;
	if (!g->across || c >= p->c)
		return false;
	for (size_t r = p->first; r < p->last; r++)
		cells += is_cell_filled(g, r, c);
	return cells < 2 && (means & (WORD_FEED | WORD_PRODUCT)) == 0;
}

/* Lists the columns of a table that are not empty: its sieves, then those from
 * column `from` to before `end`. */
static void
list_filled_columns(const struct sheet_grid *g, const struct place *p,
    size_t from, size_t end, struct table *t)
{
	t->column = xcalloc(g->n_col + 1, sizeof *t->column);
	t->column[t->n_col++] = p->c;
	size_t first = p->head < g->n_row ? p->head : p->first;
	bool empty = false;
	for (size_t c = from; c < end; c++) {
		bool filled = false, headed = false;
		for (size_t r = first; r < p->last; r++)
			filled = filled || is_cell_filled(g, r, c);
		for (size_t r = first; r < p->first; r++)
			headed = headed || is_cell_filled(g, r, c);
		/* After an empty column, only headings show that the table goes
		 * on. */
		if (c > p->c && empty && filled && !headed)
			break;
		empty = !filled;
		if (c != p->c && filled && !is_key_above_sieves(g, p, c))
			t->column[t->n_col++] = c;
	}
	t->number = xcalloc(t->n_col, sizeof *t->number);
	for (size_t i = 0; i < t->n_col; i++)
		t->number[i] = column_or_line_number(g, t->column[i]);
}

/* If the sieves are listed twice, as names and in mm, fills the cells of the
 * one from the other. */
static void
fill_missing_sieve_cells(struct table *t)
{
	static const uint64_t ELSE =
	    WORD_PASSES | WORD_STAYS | WORD_FEED | WORD_PRODUCT;
	struct sieve_unit none = {0, SIEVE_NONE};
	double mm;
	for (size_t c = 1; c < t->n_col; c++) {
		FREED char *head = layout_column_heading_text(t, c);
		uint64_t means = lexicon_text_meanings(head, NULL);
		if ((means & (WORD_SIZE | WORD_MM | WORD_MESH)) == 0 ||
		    (means & ELSE) != 0)
			continue;
		for (size_t i = 0; i < t->n_row; i++) {
			struct cell *own = &t->row[i].cell[0];
			const struct cell *other = &t->row[i].cell[c];
			if (own->value == AS_ABSENT &&
			    sieve_read_size(t->sheet, *other, none, &mm) !=
				SIEVE_IS_NONE)
				*own = *other;
		}
	}
}

/* Joins cells of row r that are before column end, but in none of the table's
 * columns, to its last row of headings: "m/s" beside "Rotor tip speed"; or the
 * speed of the only sample, as in "Ekeby; belt cut; 73 m/s", if the row is
 * above. */
static void
join_cells_beside_headings(const struct sheet_grid *g, const struct place *p,
    size_t r, size_t end, bool above, struct table *t)
{
	struct row *head = &t->head[t->n_head - 1];
	bool one = t->n_col == 2 && above;
	for (size_t c = p->c + 1; c < end; c++) {
		const char *text = cell_at(g, r, c)->text;
		struct head said = heading_parse(text);
		bool speed = one && heading_has_speed(&said) && !said.several;
		bool unit = c == p->c + 1 && said.unit != SPEED_NO_UNIT &&
			    !heading_has_speed(&said) && said.n_number == 0 &&
			    head->cell[0].text[0] != '\0';
		struct nature *n = cell_classification_at(g, r, c);
		if (n->used || (!speed && !unit))
			continue;
		struct cell *to = &head->cell[unit ? 0 : 1];
		to->text =
		    layout_adopt_text(t, xasprintf("%s %s", to->text, text));
		n->used = true;
	}
}

/* True if the first cell of row r, above or below a table, can head the speeds
 * of the samples.  units: these have a unit, so it need not say "speed". */
static bool
can_head_speeds(
    const struct sheet_grid *g, size_t r, const struct place *p, bool units)
{
	struct head first = heading_parse(cell_at(g, r, p->c)->text);
	bool speed = units || (first.means & WORD_SPEED) != 0 ||
		     first.unit != SPEED_NO_UNIT;
	static const uint64_t ELSE = WORD_LIMIT | WORD_MEAN | WORD_SAMPLE |
				     WORD_FEED | WORD_PERCENT | WORD_OTHER;
	return speed && !heading_has_speed(&first) && first.n_number == 0 &&
	       first.unknown == 0 && (first.means & ELSE) == 0;
}

/* True if row r, below a table, has speeds of its columns; or, further above,
 * of several of them and of nothing else, which can be those of a rotor. */
static bool
has_speeds_of_columns(const struct sheet_grid *g, size_t r,
    const struct place *p, const struct table *t, bool above)
{
	size_t all = 0, own = 0, i = 1;
	bool units = true, fast = true;
	if (!can_head_speeds(g, r, p, true))
		return false;
	for (size_t c = p->c + 1; c < g->n_col; c++) {
		double number = 0;
		struct head said = heading_parse(cell_at(g, r, c)->text);
		bool unit = heading_has_speed(&said);
		bool speed =
		    unit || number_value_of_cell(*cell_at(g, r, c), &number);
		while (i < t->n_col && t->column[i] < c)
			i++;
		all += speed;
		own += speed && i < t->n_col && t->column[i] == c;
		units = units && (unit || !speed);
		fast = fast && (!speed || number >= 20 || said.speed >= 20 ||
				   said.rpm >= 20);
	}
	return own >= (above ? 2 : 1) && (own == all || !above) &&
	       (fast || !above) && can_head_speeds(g, r, p, units);
}

/* Inserts row r, with the speeds of the samples, below the heading of the
 * sieves. */
static void
insert_row_of_speeds(const struct sheet_grid *g, size_t r, struct table *t)
{
	size_t at = t->titles < t->n_head ? t->titles + 1 : t->n_head;
	append_sheet_table_row(g, r, t, &t->head, &t->n_head);
	struct row speeds = t->head[t->n_head - 1];
	struct row *below = &t->head[at];
	memmove(below + 1, below, (t->n_head - 1 - at) * sizeof *below);
	*below = speeds;
}

/* Adds the rows below the sieves: sums and the like to the foot, and speeds to
 * the headings, like those above the samples. */
static void
add_rows_below_sieves(
    const struct sheet_grid *g, const struct place *p, struct table *t)
{
	for (size_t r = p->last; r < g->n_row; r++) {
		if (cell_classification_at(g, r, p->c)->foot) {
			append_sheet_table_row(g, r, t, &t->foot, &t->n_foot);
			continue;
		}
		/* A line between two tables may be the title of the lower. */
		for (size_t i = 0; i < g->n_place && g->gap[r]; i++)
			if (g->place[i].first > r)
				return;
		if (t->n_head == 0 || !has_speeds_of_columns(g, r, p, t, false))
			break;
		insert_row_of_speeds(g, r, t);
	}
}

/* Adds the nearest row of speeds that other lines separate from the headings
 * below, unless these state speeds themselves. */
static void
add_speeds_further_above(const struct sheet_grid *g, const struct place *p,
    size_t top, struct table *t)
{
	bool stated = t->n_head == 0;
	for (size_t i = 0; i < t->n_head; i++)
		for (size_t c = 0; c < t->n_col; c++) {
			struct head said =
			    heading_parse(t->head[i].cell[c].text);
			stated = stated || heading_has_speed(&said) ||
				 (c == 0 && (said.means & WORD_SPEED) != 0);
		}
	size_t first = top > MOST_LINES_ABOVE ? top - MOST_LINES_ABOVE : 0;
	for (size_t r = top; r-- > first && !stated &&
			     !cell_classification_at(g, r, p->c)->used;)
		if (has_speeds_of_columns(g, r, p, t, true)) {
			insert_row_of_speeds(g, r, t);
			return;
		}
}

/* Adds row r, above the sieves, to the headings, or a sum to the foot.  title:
 * it is above the heading of the sieves. */
static void
add_row_above_sieves(const struct sheet_grid *g, const struct place *p,
    size_t r, bool title, struct table *t, size_t end)
{
	if (cell_classification_at(g, r, p->c)->foot &&
	    has_number_beside(g, r, p->c, p->end)) {
		append_sheet_table_row(g, r, t, &t->foot, &t->n_foot);
		return;
	}
	append_sheet_table_row(g, r, t, &t->head, &t->n_head);
	join_cells_beside_headings(g, p, r, end, title, t);
	t->titles += title;
}

static void
add_one_table_to_layout(const struct sheet_grid *g, const struct place *p,
    size_t from, size_t end, struct layout *layout)
{
	layout->table =
	    xgrow_by_one(layout->table, layout->n, sizeof *layout->table);
	struct table *t = &layout->table[layout->n++];
	*t = (struct table){.sheet = g->sheet,
	    .across = g->across,
	    .left = (g->across ? p->first : p->c) + 1,
	    .end = g->across || end == g->n_col ? SIZE_MAX : end + 1,
	    .title = xstrdup(""),
	    .unsure = p->unsure};
	list_filled_columns(g, p, from, end, t);
	size_t own = p->head < g->n_row ? p->head : p->first, top = own;
	while (top > 0 && own - top < MOST_HEADS && !g->gap[top] &&
	       is_further_heading_row(g, top - 1, p, end) &&
	       !cell_classification_at(g, top - 1, p->c)->used)
		top--;
	for (size_t r = top; r < p->first; r++)
		add_row_above_sieves(g, p, r, r < own, t, end);
	for (size_t r = p->first; r < p->last; r++) {
		append_sheet_table_row(g, r, t, &t->row, &t->n_row);
		t->below =
		    t->below || cell_classification_at(g, r, p->c)->below;
	}
	add_speeds_further_above(g, p, top, t);
	add_rows_below_sieves(g, p, t);
	for (size_t r = p->last; r < g->n_row && g->across; r++)
		if (lexicon_is_date_label(cell_at(g, r, p->c)->text) &&
		    !cell_classification_at(g, r, p->c)->used)
			append_sheet_table_row(g, r, t, &t->foot, &t->n_foot);
	fill_missing_sieve_cells(t);
	free(t->column);
	t->column = NULL;
}

static void
add_tables_to_layout(const struct sheet_grid *g, struct layout *layout)
{
	for (size_t i = 0; i < g->n_place; i++) {
		const struct place *p = &g->place[i];
		size_t from = 0, end = g->n_col;
		for (size_t k = 0; k < g->n_place; k++) {
			const struct place *other = &g->place[k];
			if (k == i || !are_tables_overlapping(p, other))
				continue;
			if (other->c > p->c && other->c < end)
				end = other->c;
			if (other->c < p->c)
				from = p->c;
		}
		add_one_table_to_layout(g, p, from, end, layout);
	}
}

static int
sum_of_found_table_scores(const struct sheet_grid *g)
{
	int score = 0;
	for (size_t i = 0; i < g->n_place; i++)
		score += g->place[i].score + 1;
	return score;
}

static void
list_rows_outside_tables(const struct sheet_grid *g, struct layout *layout)
{
	layout->heading = xcalloc(g->n_row + 1, sizeof(*layout->heading));
	layout->read = xcalloc(g->n_row + 1, sizeof *layout->read);
	for (size_t r = 0; r < g->n_row; r++) {
		const struct row *row = &g->sheet->row[r];
		const struct cell *beside = NULL;
		size_t used = 0;
		for (size_t c = row->n; c-- > 0;)
			if (cell_classification_at(g, r, c)->used)
				used++;
			else if (row->cell[c].text[0] != '\0')
				beside = &row->cell[c];
		if (used == 0)
			layout->heading[layout->n_heading++] = row;
		else if (beside != NULL && layout->beside.text == NULL)
			layout->beside = *beside;
	}
}

/* True if two tables have the same headings, except for rows above the heading
 * of the sieves. */
static bool
are_table_headings_same(const struct table *a, const struct table *b)
{
	size_t heads = a->n_head - a->titles;
	if (a->n_col != b->n_col || a->across || heads == 0 ||
	    heads != b->n_head - b->titles)
		return false;
	for (size_t c = 0; c < a->n_col; c++)
		for (size_t r = 0; r < heads; r++)
			if (a->number[c] != b->number[c] ||
			    strcmp(a->head[a->titles + r].cell[c].text,
				b->head[b->titles + r].cell[c].text) != 0)
				return false;
	return true;
}

/* True if the numbers of a column only rise, or only fall, from the first row
 * of table a to the last of table b. */
static bool
do_tables_continue_order(const struct table *a, const struct table *b, size_t c)
{
	double v, last = NAN;
	bool up = false, down = false;
	for (size_t i = 0; i < a->n_row + b->n_row; i++) {
		const struct row *row =
		    i < a->n_row ? &a->row[i] : &b->row[i - a->n_row];
		if (!number_value_of_cell(row->cell[c], &v))
			return false;
		up = up || v > last;
		down = down || v < last;
		last = v;
	}
	return up != down;
}

/* True for "Page 2 of 2". */
static bool
is_page_number(const char *text)
{
	static const char *const PAGE[] = {
	    "page ", "sida ", "side ", "seite ", "sivu ", "pagina "};
	FREED char *folded = text_fold_case_and_accents(text);
	for (size_t i = 0; i < ARRAY_LEN(PAGE); i++)
		if (strncmp(folded, PAGE[i], strlen(PAGE[i])) == 0)
			return true;
	return false;
}

int
layout_first_line_of_table(const struct table *t)
{
	return t->n_head > 0 ? t->head[0].line : t->row[0].line;
}

/* True if a line between two tables differs from all lines above it: it may
 * name another test. */
static bool
has_unseen_text_between_tables(const struct layout *layout,
    const struct table *t, const struct table *rest)
{
	int from = t->row[t->n_row - 1].line;
	int to = layout_first_line_of_table(rest);
	for (size_t i = 0; i < layout->n_heading; i++) {
		const struct row *row = layout->heading[i];
		size_t k = 0;
		while (k < i &&
		       !text_is_same_folded(
			   layout->heading[k]->cell[0].text, row->cell[0].text))
			k++;
		if (row->line > from && row->line < to && k == i &&
		    !is_page_number(row->cell[0].text))
			return true;
	}
	return false;
}

/* Joins a table that was cut at the end of a page with the rest of it on the
 * next: the same headings are repeated, and the sieves and cumulative numbers
 * go on in order. */
static void
join_continued_tables(struct layout *layout)
{
	for (size_t b = 1; b < layout->n; b++) {
		struct table *t = &layout->table[b - 1],
			     *rest = &layout->table[b];
		bool goes_on = t->n_foot == 0 &&
			       are_table_headings_same(t, rest) &&
			       !has_unseen_text_between_tables(layout, t, rest);
		for (size_t c = 0; c < t->n_col && goes_on; c++)
			goes_on = do_tables_continue_order(t, rest, c);
		if (!goes_on)
			continue;
		t->row =
		    xrealloc(t->row, t->n_row + rest->n_row, sizeof *t->row);
		memcpy(
		    &t->row[t->n_row], rest->row, rest->n_row * sizeof *t->row);
		t->n_row += rest->n_row;
		rest->n_row = 0;
		layout_table_clear(rest);
		layout->n--;
		memmove(
		    rest, rest + 1, (layout->n - b) * sizeof *layout->table);
		b--;
	}
}

/* Sets t->after, the line after which lines may be about this table alone. */
static void
find_end_of_tables_above(const struct layout *layout, struct table *t)
{
	int top = layout_first_line_of_table(t);
	for (size_t b = 0; b < layout->n; b++) {
		const struct table *other = &layout->table[b];
		const struct row *end = other->n_foot > 0
					    ? &other->foot[other->n_foot - 1]
					    : &other->row[other->n_row - 1];
		if (end->line < top && end->line > t->after)
			t->after = end->line;
	}
	for (size_t i = 0; i < layout->n_heading && t->after > 0; i++)
		t->after += layout->heading[i]->line == t->after + 1;
}

static void
rows_free(struct row *row, size_t n)
{
	for (size_t i = 0; i < n; i++)
		free(row[i].cell);
	free(row);
}

char *
layout_adopt_text(struct table *t, char *text)
{
	t->text = xrealloc(t->text, t->n_text + 1, sizeof *t->text);
	return t->text[t->n_text++] = text;
}

char *
layout_column_heading_text(const struct table *t, size_t c)
{
	char *text = xstrdup("");
	for (size_t r = 0; r < t->n_head; r++)
		if (t->head[r].cell[c].text[0] != '\0')
			xappend_to_list(
			    &text, " ", "%s", t->head[r].cell[c].text);
	return text;
}

/* Finds tables in one of four ways, from 0.  Each is tried if those before it
 * found none; without headings, sizes in phi would be taken for mm. */
static void
find_tables_in_way(struct sheet_grid *g, size_t way)
{
	if (way == 0)
		find_tables_with_headings(g);
	else if (way == 2)
		find_tables_without_headings(g);
	else
		find_tables_by_number_series(g, way == 1);
}

struct layout *
layout_new_of_sheet(struct sheet *sheet, struct layout_range range)
{
	struct layout *layout = xcalloc(1, sizeof *layout);
	struct sheet_grid g = copy_sheet_to_grid(sheet, range);
	shift_headings_if_one_short(&g);
	mark_in_beside_out_as_feed(&g);
	g.bare_below = has_bare_sizes_below(&g);
	name_classes_beside_greatest(&g);
	mark_less_than_sizes_as_sieves(&g);
	classify_all_sheet_cells(&g);
	find_next_number_of_each_cell(&g);
	struct sheet_grid t = transpose_sheet_grid(&g);
	size_t ways = range.n_sieves > 0 ? 1 : 4;
	for (size_t i = 0; i < ways && g.n_place + t.n_place == 0; i++) {
		find_tables_in_way(&g, i);
		find_tables_in_way(&t, i);
	}
	if (range.n_sieves > 0) {
		find_tables_in_given_columns(&g, &range);
		find_tables_in_given_columns(&t, &range);
	}
	bool turned =
	    sum_of_found_table_scores(&t) > sum_of_found_table_scores(&g);
	add_tables_to_layout(turned ? &t : &g, layout);
	list_rows_outside_tables(&g, layout);
	join_continued_tables(layout);
	for (size_t b = 0; b < layout->n; b++)
		find_end_of_tables_above(layout, &layout->table[b]);
	free_sheet_grid(&t);
	free_sheet_grid(&g);
	return layout;
}

void
layout_table_clear(struct table *t)
{
	rows_free(t->head, t->n_head);
	rows_free(t->row, t->n_row);
	rows_free(t->foot, t->n_foot);
	rows_free(t->site, t->n_site);
	for (size_t i = 0; i < t->n_text; i++)
		free(t->text[i]);
	free(t->text);
	free(t->name);
	free(t->day);
	free(t->title);
	free(t->number);
	free(t->mm);
}

void
layout_free(struct layout *layout)
{
	for (size_t i = 0; i < layout->n; i++)
		layout_table_clear(&layout->table[i]);
	free(layout->table);
	free(layout->heading);
	free(layout->read);
	free(layout);
}

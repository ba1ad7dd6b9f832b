/* From the first cells of the rows to sieve sizes, coarsest first.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/site_sieve.h"

#include <ctype.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "base/xalloc.h"
#include "io/sieve_names.h"
#include "io/units.h"

/* The words that may begin the table, letters only, with a unit after. */
static const char *const SIZE_WORDS[] = {"size", "sieve", "sievesize", "sikt",
    "siktstorlek", "maskvidd", "storlek", "kornstorlek"};
static const struct {
	const char *unit;
	double mm;
} SIZE_UNITS[] = {{"mm", 1}, {"um", 1e-3}, {"m", 1e3}};

enum { MOST_LETTERS = 16 };

/* The letters of "Size (mm)" in small, the two signs for micro as u; a word
 * longer than any is cut. */
static void
letters(const char *text, char word[static MOST_LETTERS])
{
	char *folded = text_fold(text);
	size_t n = 0;
	for (const char *p = folded; *p != '\0' && n + 1 < MOST_LETTERS; p++) {
		bool micro = strncmp(p, "\xC2\xB5", 2) == 0 ||
			     strncmp(p, "\xCE\xBC", 2) == 0;
		if (micro || (*p >= 'a' && *p <= 'z') ||
		    (*p >= '0' && *p <= '9'))
			word[n++] = micro ? 'u' : *p;
		p += micro;
	}
	word[n] = '\0';
	free(folded);
}

/* What stands after the word that begins a table; NULL where none does. */
static const char *
behind_word(const char *word)
{
	const char *rest = NULL;
	size_t longest = 0;
	for (size_t w = 0; w < ARRAY_LEN(SIZE_WORDS); w++) {
		size_t n = strlen(SIZE_WORDS[w]);
		if (n > longest && strncmp(word, SIZE_WORDS[w], n) == 0) {
			longest = n;
			rest = word + n;
		}
	}
	return rest;
}

double
site_sieve_unit(const struct row *row)
{
	char word[MOST_LETTERS];
	letters(row->cell[0].text, word);
	const char *rest = behind_word(word);
	for (size_t u = 0; rest != NULL && u < ARRAY_LEN(SIZE_UNITS); u++)
		if (strcmp(rest, SIZE_UNITS[u].unit) == 0)
			return SIZE_UNITS[u].mm;
	return 0;
}

bool
site_sieve_word(const char *text)
{
	char word[MOST_LETTERS];
	letters(text, word);
	const char *rest = behind_word(word);
	return rest != NULL && *rest == '\0';
}

/* What is left under the finest sieve, as labs of several languages head it:
 * pan, Botten, <0.063. */
static bool
is_pan(const char *text)
{
	static const char *const WORDS[] = {"pan", "bottom", "receiver", "rest",
	    "botten", "tråg", "bunn", "boden", "fond", "fondo"};
	if (text[0] == '<')
		return true;
	for (size_t i = 0; i < ARRAY_LEN(WORDS); i++)
		if (text_same(text, WORDS[i]))
			return true;
	return false;
}

double
site_sieve_mm(
    struct sheet *sheet, struct cell cell, double unit, const char *wanted)
{
	double v;
	if (cell.text[0] == '\0') {
		sheet_wanted(sheet, cell, wanted,
		    "write the sieve size, or remove the row");
		return NAN;
	}
	if (!sheet_number(sheet, cell, wanted, &v))
		return NAN;
	double mm = site_column_round(v * unit, 1e9);
	if ((mm >= SIZE_LEAST_MM && mm <= SIZE_MOST_MM) || v == 0)
		return mm;
	sheet_wanted(sheet, cell,
	    v > 0 ? "a size from 1e-6 to 1e4 mm" : "a positive size", "%s",
	    v > 0 ? "check the number and its unit"
		  : "write pan for what is below the finest sieve");
	return NAN;
}

/* Of a sieve that has a name; 0 where it has none, NAN after a fault. */
static double
named_mm(struct sheet *sheet, struct cell cell)
{
	double mm = sieve_names_mm(cell.text);
	if (!isnan(mm))
		return mm;
	char *nearest = sieve_names_nearest(cell.text);
	sheet_wanted(sheet, cell, "a sieve of ASTM E11",
	    "use the nearest: %s; or begin a remark with # and a word, not a "
	    "number alone",
	    nearest);
	free(nearest);
	return NAN;
}

static double
row_mm(struct table *t, const struct row *row, double unit)
{
	struct cell cell = row->cell[0];
	if (row->n > t->head->n && t->told_cells)
		return NAN;
	if (row->n > t->head->n) {
		t->told_cells = true;
		sheet_fault(t->sheet, row->cell[t->head->n],
		    "expected %zu cells as in line %d, got %zu\n"
		    "%s",
		    t->head->n, t->head->line, row->n,
		    t->sheet->separator == ','
			? "use ; between the cells if they have decimal "
			  "commas; otherwise remove the last cells"
			: "remove the last cells, or give their columns "
			  "headings");
		return NAN;
	}
	if (is_pan(cell.text))
		return 0;
	double named = named_mm(t->sheet, cell);
	if (named != 0)
		return named;
	if (isalpha((unsigned char)cell.text[0])) {
		sheet_wanted(t->sheet, cell, "a sieve size or pan",
		    "remove sums and remarks from the table, or begin their "
		    "line with #");
		return NAN;
	}
	return site_sieve_mm(t->sheet, cell, unit, "a sieve size or pan");
}

/* Neither a size, a sieve's name nor the pan. */
static bool
is_word(const struct table *t, const struct row *row)
{
	double v;
	return !is_pan(row->cell[0].text) &&
	       sieve_names_mm(row->cell[0].text) == 0 &&
	       !sheet_value(t->sheet, row->cell[0], &v);
}

/* Below a table stand sums, with anything after them, and remarks in the first
 * cell alone. */
static void
drop_foot(struct table *t)
{
	static const char *const SUMS[] = {
	    "sum", "total", "summa", "totalt", "summe"};
	size_t foot = t->n_row;
	while (foot > 0 && is_word(t, &t->row[foot - 1]))
		foot--;
	for (size_t i = foot; i < t->n_row; i++)
		for (size_t k = 0; k < ARRAY_LEN(SUMS); k++)
			if (text_same(t->row[i].cell[0].text, SUMS[k])) {
				t->total = &t->row[i];
				t->n_row = i;
			}
	while (t->n_row > foot && t->row[t->n_row - 1].n == 1)
		t->n_row--;
}

void
site_sieve_numbers(struct sheet *sheet, const struct row *head)
{
	const char separator[] = {sheet->separator, '\0'};
	int line = head->line;
	for (size_t i = sheet->n_comment; !sheet->lost && i-- > 0;) {
		const struct comment *c = &sheet->comment[i];
		char *first =
		    text_unquoted(c->text, strcspn(c->text, separator));
		if (c->line > line && sieve_names_is_number(first))
			sheet_uncomment(sheet, i);
		free(first);
	}
}

static bool
is_finest_first(const struct table *t)
{
	size_t rising = 0, last = t->n_row;
	for (size_t i = 0; i < t->n_row; i++) {
		if (isnan(t->mm[i]))
			continue;
		if (last < t->n_row && t->mm[i] <= t->mm[last])
			return false;
		rising += last < t->n_row;
		last = i;
	}
	return rising > 0;
}

/* Neighbours are compared, so that one wrong size is one fault. */
static void
check_order(struct table *t)
{
	size_t last = t->n_row;
	for (size_t i = 0; i < t->n_row; i++) {
		if (isnan(t->mm[i]))
			continue;
		struct cell cell = t->row[i].cell[0];
		size_t twin = 0;
		while (twin < i && t->mm[twin] != t->mm[i])
			twin++;
		if (twin < i)
			sheet_fault(t->sheet, cell,
			    "duplicate sieve: %s is already in line %d\n"
			    "remove one of the two rows, or correct its size",
			    cell.text, t->row[twin].line);
		else if (last < t->n_row && t->mm[i] > t->mm[last])
			sheet_fault(t->sheet, cell,
			    "expected sieves coarsest first, got %s after %s\n"
			    "sort the rows by size, largest first, or correct "
			    "the size",
			    cell.text, t->row[last].cell[0].text);
		last = i;
	}
}

void
site_sieve_rows(struct table *t)
{
	double unit = site_sieve_unit(t->head);
	drop_foot(t);
	t->mm = xdoubles(t->n_row);
	for (size_t i = 0; i < t->n_row; i++) {
		t->mm[i] = row_mm(t, &t->row[i], unit);
		t->lost = t->lost || isnan(t->mm[i]);
	}
	if (!is_finest_first(t)) {
		check_order(t);
		return;
	}
	sheet_fault(t->sheet, t->row[0].cell[0],
	    "expected sieves coarsest first, got the table finest first\n"
	    "sort the rows by size, largest first (in a spreadsheet: Data, "
	    "Sort, Descending)");
	t->lost = true;
}

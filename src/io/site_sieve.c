/* From the first cells of the rows to sieve sizes, coarsest first.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/site_sieve.h"

#include <ctype.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "base/xalloc.h"

/* The limits of a sieve, mm: what lies outside is a slip of the pen. */
static const double FINEST = 1e-6, COARSEST = 1e4;

/* mm a unit of the words that may begin the table, letters only. */
static const struct {
	const char *word;
	double mm;
} SIZE_WORDS[] = {{"sizemm", 1}, {"sizeum", 1e-3}, {"sizem", 1e3},
    {"sievemm", 1}, {"sieveum", 1e-3}, {"sievem", 1e3}, {"sievesizemm", 1},
    {"sievesizeum", 1e-3}, {"sievesizem", 1e3}};

/* The letters of "Size (mm)" in small, the two signs for micro as u; a word
 * longer than any is cut. */
static void
letters(const char *text, char word[static 16])
{
	char *folded = text_fold(text);
	size_t n = 0;
	for (const char *p = folded; *p != '\0' && n < 15; p++) {
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

double
site_sieve_unit(const struct row *row)
{
	char word[16];
	letters(row->cell[0].text, word);
	for (size_t w = 0; w < ARRAY_LEN(SIZE_WORDS); w++)
		if (strcmp(word, SIZE_WORDS[w].word) == 0)
			return SIZE_WORDS[w].mm;
	return 0;
}

/* What is left under the finest sieve, as labs of several languages head it:
 * pan, Botten, <0.063. */
static bool
is_pan(const char *text)
{
	static const char *const WORDS[] = {"pan", "bottom", "receiver", "rest",
	    "botten", "bunn", "boden", "fond", "fondo"};
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
		    "write the sieve's size, or take the row out");
		return NAN;
	}
	if (!sheet_number(sheet, cell, wanted, &v))
		return NAN;
	double mm = site_column_round(v * unit, 1e9);
	if ((mm >= FINEST && mm <= COARSEST) || v == 0)
		return mm;
	sheet_wanted(sheet, cell,
	    v > 0 ? "a size from 1e-6 to 1e4 mm" : "a positive size",
	    "check the number and its unit");
	return NAN;
}

static double
row_mm(struct table *t, const struct row *row, double unit)
{
	struct cell cell = row->cell[0];
	if (row->n > t->head->n) {
		sheet_fault(t->sheet, row->cell[t->head->n],
		    "%zu cells were wanted as in line %d, found %zu\n%s",
		    t->head->n, t->head->line, row->n,
		    t->sheet->separator == ','
			? "decimal commas need ; between the cells; otherwise "
			  "take the last cells out"
			: "take the last cells out, or head their columns");
		return NAN;
	}
	if (is_pan(cell.text))
		return 0;
	if (isalpha((unsigned char)cell.text[0])) {
		sheet_wanted(t->sheet, cell, "a sieve size or pan",
		    "take sums and remarks out of the table, or begin their "
		    "line with #");
		return NAN;
	}
	return site_sieve_mm(t->sheet, cell, unit, "a sieve size or pan");
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
			    "each sieve was wanted once, found %s in line %d "
			    "already\n"
			    "take one of the two rows out, or correct its size",
			    cell.text, t->row[twin].line);
		else if (last < t->n_row && t->mm[i] > t->mm[last])
			sheet_fault(t->sheet, cell,
			    "sieves coarsest first were wanted, found %s after "
			    "%s\n"
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
	    "sieves coarsest first were wanted, found the table finest first\n"
	    "sort the rows by size, largest first (in a spreadsheet: Data, "
	    "Sort, Descending)");
	t->lost = true;
}

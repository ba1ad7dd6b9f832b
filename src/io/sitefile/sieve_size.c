/* Sizes, names and pans told apart.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/sitefile/sieve_size.h"

#include <ctype.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "io/sitefile/lexicon.h"
#include "io/cells/number.h"

struct sieve_unit
sieve_unit_of(uint64_t means)
{
	struct sieve_unit unit = {0, SIEVE_NONE};
	if ((means & WORD_MM) != 0)
		unit.mm = 1;
	else if ((means & WORD_UM) != 0)
		unit.mm = 1e-3;
	else if ((means & WORD_INCH) != 0)
		unit = (struct sieve_unit){25.4, SIEVE_INCH};
	else if ((means & WORD_M) != 0)
		unit.mm = 1e3;
	else if ((means & WORD_PHI) != 0)
		unit.series = SIEVE_PHI;
	else if ((means & WORD_TYLER) != 0)
		unit.series = SIEVE_TYLER;
	else if ((means & WORD_BS) != 0)
		unit.series = SIEVE_BS;
	else if ((means & WORD_ASTM) != 0)
		unit.series = SIEVE_ASTM;
	else if ((means & WORD_MESH) != 0)
		unit.series = SIEVE_MESH;
	return unit;
}

/* Sizes in phi go by quarters. */
static const double LEAST_PHI = 0.25;

/* What is left under the finest sieve, as labs of several languages call it:
 * pan, Botten, <0.063. */
static bool
is_pan(const char *text)
{
	size_t unknown;
	double below;
	/* -0.063 is below that sieve; what is coarser may be phi. */
	if (text[0] == '-' && text_number(text + 1, &below))
		return below > 0 && below < LEAST_PHI;
	if (text[0] == '<') {
		const char *rest = text + 1 + strspn(text + 1, " ");
		return isdigit((unsigned char)rest[0]) ||
		       sieve_names_series(rest) != SIEVE_NONE;
	}
	if (isdigit((unsigned char)text[0]) || strpbrk(text, "0123456789"))
		return false;
	uint64_t means = vocabulary_text(text, &unknown);
	return (means & WORD_PAN) != 0 && unknown == 0 &&
	       (means & (WORD_TOTAL | WORD_LOSS)) == 0;
}

/* "63 um" as 63, and mm in its unit; 0 where no unit of size follows. */
static double
cut_unit(const struct sheet *sheet, struct cell *cell, char copy[static 40])
{
	size_t n = strlen(cell->text), unknown;
	if (cell->kind != CELL_TEXT || n == 0 || n >= 40)
		return 0;
	size_t at = n;
	while (at > 0 && !isdigit((unsigned char)cell->text[at - 1]))
		at--;
	if (at == 0 || at == n)
		return 0;
	struct sieve_unit unit =
	    sieve_unit_of(vocabulary_text(cell->text + at, &unknown));
	if (unknown > 0 || unit.series != SIEVE_NONE)
		return 0;
	memcpy(copy, cell->text, at);
	copy[at] = '\0';
	*cell = number_cell(sheet, *cell, copy);
	return unit.mm;
}

/* The lower of the two sizes of a class, "11,2/16", "11,2 - 16" or "-16 +11.2",
 * or the one of "> 22,4" or "+22.4", as the cell's text. */
static bool
cut_class(const struct sheet *sheet, struct cell *cell, char copy[static 40])
{
	size_t n = strlen(cell->text);
	if (cell->kind != CELL_TEXT || n >= 40)
		return false;
	memcpy(copy, cell->text, n + 1);
	char sign = copy[0];
	bool signs = sign == '+' || sign == '-';
	char *first = copy + (signs ? 1 : strspn(copy, "> "));
	char *cut = strpbrk(first, signs ? "+-" : "/-");
	if (cut == NULL && first > copy && sign != '-') {
		*cell = number_cell(sheet, *cell, first);
		return cell->value == VALUE_NUMBER;
	}
	if (cut == NULL || cut == first || cut[0] == sign)
		return false;
	*cut = '\0';
	struct cell a = number_cell(sheet, *cell, text_trim(first)),
		    b = number_cell(sheet, *cell, text_trim(cut + 1));
	if (a.value != VALUE_NUMBER || b.value != VALUE_NUMBER ||
	    a.number == b.number)
		return false;
	*cell = a.number < b.number ? a : b;
	return true;
}

bool
sieve_size_is_class(const struct sheet *sheet, struct cell cell)
{
	char copy[40];
	return cut_class(sheet, &cell, copy);
}

enum sieve_kind
sieve_size(const struct sheet *sheet, struct cell cell, struct sieve_unit unit,
    double *mm)
{
	char copy[40];
	double value;
	*mm = NAN;
	if (cell.kind == CELL_DATE || cell.text[0] == '\0')
		return SIEVE_IS_NONE;
	if (is_pan(cell.text))
		return SIEVE_IS_PAN;
	if (unit.series == SIEVE_PHI) {
		if (!number_of(cell, &value) || fabs(value) > SIEVE_MOST_PHI)
			return SIEVE_IS_NONE;
		*mm = round(exp2(-value) * 1e9) / 1e9;
		return SIEVE_IS_SIZE;
	}
	/* A number alone is a name only where the head says so. */
	bool bare = cell.kind == CELL_TEXT && cell.value == VALUE_NUMBER &&
		    unit.series == SIEVE_NONE;
	double named = bare ? 0 : sieve_names_mm(cell.text, unit.series);
	if (named != 0) {
		*mm = named;
		return SIEVE_IS_SIZE;
	}
	char bounds[40];
	if (unit.mm > 0 && unit.series == SIEVE_NONE)
		cut_class(sheet, &cell, bounds);
	double own = cut_unit(sheet, &cell, copy);
	if (!number_of(cell, &value) || value < 0)
		return SIEVE_IS_NONE;
	if (value == 0)
		return SIEVE_IS_PAN;
	double factor = own > 0 ? own : unit.mm > 0 ? unit.mm : 1;
	*mm = round(value * factor * 1e9) / 1e9;
	return SIEVE_IS_SIZE;
}

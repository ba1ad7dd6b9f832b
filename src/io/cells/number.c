/* Parses cells as numbers: decimal signs, thousands, units, and marks for
 * missing numbers.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/cells/number.h"

#include <ctype.h>
#include <math.h>
#include <string.h>

#include "base/text.h"
#include "base/tr.h"
#include "base/xalloc.h"

enum { LONGEST = 64 };

size_t
number_thousands_separator_bytes(const char *s)
{
	static const char *const GROUPS[] = {" ", "\xC2\xA0", "\xE2\x80\xAF",
	    "\xE2\x80\x89", "'", "\xE2\x80\x99", "\xCA\xBC"};
	for (size_t i = 0; i < ARRAY_LEN(GROUPS); i++)
		if (strncmp(s, GROUPS[i], strlen(GROUPS[i])) == 0)
			return strlen(GROUPS[i]);
	return 0;
}

/* Copies a text without thousands separators, and without no-break spaces at
 * its ends: 1 010,5 becomes 1010,5.  Returns false for a text too long to be a
 * number. */
static bool
copy_without_thousands_blanks(const char *s, char copy[static LONGEST])
{
	char *to = copy;
	if (strlen(s) >= LONGEST)
		return false;
	for (const char *p = s; *p != '\0';) {
		size_t n = number_thousands_separator_bytes(p);
		bool end = n > 1 && (p == s || p[n] == '\0');
		if (end || (n > 0 && p > s && isdigit((unsigned char)p[-1]) &&
			       strspn(p + n, "0123456789") == 3))
			p += n;
		else
			*to++ = *p++;
	}
	*to = '\0';
	return true;
}

/* Returns the decimal sign of the number that a text begins with: '?' if the
 * sign may also separate thousands (1,250); NUL if there is no sign, or no
 * number. */
static char
decimal_sign_of_text(const char *s)
{
	char copy[LONGEST];
	if (!copy_without_thousands_blanks(s, copy))
		return '\0';
	const char *p = copy + strspn(copy, "<>+- ");
	size_t n = strspn(p, "0123456789.,");
	/* A unit may follow, another number may not. */
	if (n == 0 || p[n + strcspn(p + n, "0123456789.,")] != '\0')
		return '\0';
	size_t signs = 0, last = n;
	bool both = false;
	for (size_t i = 0; i < n; i++) {
		if (isdigit((unsigned char)p[i]))
			continue;
		both = both || (signs > 0 && p[i] != p[last]);
		signs++;
		last = i;
	}
	size_t after = n - last - 1;
	if (signs == 0)
		return '\0';
	if (both)
		return p[last];
	if (signs > 1) /* 1.234.567; not dates, versions */
		return after == 3 && last > 4 && last < 8 &&
			       p[last - 4] == p[last]
			   ? (p[last] == '.' ? ',' : '.')
			   : '\0';
	bool groups = after == 3 && last > 0 && last <= 3 && p[0] != '0';
	return groups ? '?' : p[last];
}

bool
number_is_ambiguous(const struct sheet *sheet, struct cell cell)
{
	return sheet->decimal == '\0' && cell.kind == CELL_TEXT &&
	       decimal_sign_of_text(cell.text) == '?';
}

/* Removes `sign` where it separates thousands.  Returns false if it occurs
 * elsewhere. */
static bool
remove_thousands_sign(char *s, char sign)
{
	char *to = s;
	for (const char *p = s; *p != '\0'; p++) {
		if (*p != sign) {
			*to++ = *p;
			continue;
		}
		if (p == s || !isdigit((unsigned char)p[-1]) ||
		    strspn(p + 1, "0123456789") != 3)
			return false;
	}
	*to = '\0';
	return true;
}

static bool
parse_number_text(const struct sheet *sheet, const char *text, double *value)
{
	char copy[LONGEST];
	if (!copy_without_thousands_blanks(text, copy))
		return false;
	char decimal = sheet->decimal;
	if (decimal == '\0')
		decimal = strchr(copy, ',') != NULL ? ',' : '.';
	if (!remove_thousands_sign(copy, decimal == ',' ? '.' : ','))
		return false;
	char *comma = decimal == ',' ? strchr(copy, ',') : NULL;
	if (comma != NULL)
		*comma = '.';
	return text_parse_number(copy, value);
}

/* Reads a percentage, "97,5 %", or a mass, "42 g".  Returns AS_NONE if it is
 * neither. */
static enum cell_value
parse_number_with_unit(
    const struct sheet *sheet, const char *text, double *value)
{
	static const struct {
		const char *unit;
		enum cell_value value;
	} UNITS[] = {{"%", AS_PERCENT}, {"g", AS_GRAMS}, {"gr", AS_GRAMS},
	    {"gram", AS_GRAMS}};
	enum { MOST = 40 };
	char copy[MOST];
	size_t n = strlen(text);
	for (size_t i = 0; n < MOST && i < ARRAY_LEN(UNITS); i++) {
		size_t k = strlen(UNITS[i].unit);
		if (n <= k || strcmp(text + n - k, UNITS[i].unit) != 0)
			continue;
		memcpy(copy, text, n - k);
		copy[n - k] = '\0';
		if (text_ends_with(copy, "\xC2\xA0"))
			copy[n - k - 2] = '\0';
		return parse_number_text(sheet, text_trim(copy), value)
			   ? UNITS[i].value
			   : AS_NONE;
	}
	return AS_NONE;
}

/* Returns AS_ABSENT for a mark for a missing number, AS_TRACE for a word that
 * means an amount too small to weigh, else AS_NONE. */
static enum cell_value
value_of_word(const char *text)
{
	static const char *const ABSENT[] = {"", "-", "--", "---",
	    "\xE2\x80\x93", "\xE2\x80\x94", "\xE2\x88\x92", "n/a", "na", "n.a.",
	    "nan", "#n/a", "none", "null", "nd", "n.d.", "ej", "k.a.", "?",
	    "not used", "saknas", "s/d", "bdl", "brak", "n.b."};
	static const char *const TRACE[] = {"trace", "traces", "tr", "tr.",
	    "sp\xC3\xA5r", "spuren", "trazas", "tracce"};
	for (size_t i = 0; i < ARRAY_LEN(ABSENT); i++)
		if (text_is_same_but_case(text, ABSENT[i], SIZE_MAX))
			return AS_ABSENT;
	for (size_t i = 0; i < ARRAY_LEN(TRACE); i++)
		if (text_is_same_but_case(text, TRACE[i], SIZE_MAX))
			return AS_TRACE;
	return AS_NONE;
}

static void
parse_number_in_cell(const struct sheet *sheet, struct cell *cell)
{
	double number = NAN;
	cell->value = AS_NONE;
	if (cell->kind == CELL_NUMBER) {
		cell->value = AS_NUMBER;
		number = cell->number;
	} else if (cell->kind == CELL_TEXT) {
		bool less = cell->text[0] == '<';
		if (parse_number_text(sheet, cell->text + less, &number))
			cell->value = AS_NUMBER;
		else if ((cell->value = value_of_word(cell->text)) == AS_NONE)
			cell->value = parse_number_with_unit(
			    sheet, cell->text + less, &number);
		if (less && cell->value != AS_NONE)
			cell->value = AS_TRACE;
	}
	bool has = cell->value >= AS_NUMBER && cell->value != AS_TRACE;
	cell->number = has ? number : (double)NAN;
}

void
number_parse_all_cells(struct sheet *sheet)
{
	for (size_t r = 0;
	     r < sheet->n_row && !error_is_stop_requested(sheet->errors); r++)
		for (size_t i = 0; i < sheet->row[r].n_all; i++)
			parse_number_in_cell(sheet, &sheet->row[r].cell[i]);
}

void
number_detect_decimal_sign(struct sheet *sheet)
{
	size_t points = 0, commas = 0;
	char first = '\0';
	sheet->open = (struct cell){0};
	for (size_t r = 0;
	     r < sheet->n_row && !error_is_stop_requested(sheet->errors); r++)
		for (size_t i = 0; i < sheet->row[r].n; i++) {
			struct cell cell = sheet->row[r].cell[i];
			char sign = cell.kind == CELL_TEXT
					? decimal_sign_of_text(cell.text)
					: '\0';
			points += sign == '.';
			commas += sign == ',';
			if (first == '\0' && (sign == '.' || sign == ','))
				first = sign;
			if (sign == '?' && sheet->open.text == NULL)
				sheet->open = cell;
		}
	sheet->decimal = points > commas ? '.' : points < commas ? ',' : first;
	/* If commas separate the cells, points are decimal. */
	if (sheet->decimal == '\0' && sheet->separator == ',')
		sheet->decimal = '.';
	if (sheet->decimal != '\0')
		sheet->open.text = NULL;
	number_parse_all_cells(sheet);
}

void
number_set_decimal_sign(struct sheet *sheet, char sign)
{
	sheet->decimal = sign;
	sheet->open.text = NULL;
	number_parse_all_cells(sheet);
}

struct cell
number_reparse_cell_with_text(
    const struct sheet *sheet, struct cell cell, char *text)
{
	cell.kind = CELL_TEXT;
	cell.text = text;
	parse_number_in_cell(sheet, &cell);
	return cell;
}

bool
number_value_of_cell(struct cell cell, double *value)
{
	if (cell.value == AS_NUMBER)
		*value = cell.number;
	return cell.value == AS_NUMBER;
}

static const char *
hint_for_non_number(const char *s)
{
	if (s[0] == '\0')
		return tr("write the number in that cell");
	if (s[0] == '=')
		return tr(
		    "the workbook was saved without results: open and save "
		    "it in a spreadsheet program");
	size_t n = strspn(s, "0123456789");
	bool date = n > 0 && strchr("-/.", s[n]) != NULL && s[n] != '\0' &&
		    (isalpha((unsigned char)s[n + 1]) ||
			strchr(s + n + 1, s[n]) != NULL);
	if (date)
		return tr(
		    "the spreadsheet turned it into a date: type it again "
		    "in a cell formatted as text");
	n = strspn(s, "+-0123456789");
	bool group = n > 0 && s[n] != '\0' && strchr(" ',.\xC2\xE2", s[n]) &&
		     isdigit((unsigned char)s[strlen(s) - 1]);
	if (group)
		return tr("write thousands without a separator: 1000");
	return n > 0 ? tr("write the number alone; units belong in the header")
		     : tr("write digits and a decimal point, or leave the cell "
			  "empty if nothing was measured");
}

bool
number_read_cell(
    struct sheet *sheet, struct cell cell, const char *wanted, double *value)
{
	if (number_value_of_cell(cell, value))
		return true;
	char sign = decimal_sign_of_text(cell.text);
	if (sheet->decimal == '\0' || (sign != '.' && sign != ',') ||
	    sign == sheet->decimal)
		return sheet_report_expected(
		    sheet, cell, wanted, "%s", hint_for_non_number(cell.text));
	if (sheet->mixed)
		return false;
	sheet->mixed = true;
	return sheet_report_fault(sheet, cell,
	    "expected a decimal %s as in other cells, got %s\n"
	    "use one decimal sign in the whole sheet",
	    sheet->decimal == ',' ? "comma" : "point", cell.text);
}

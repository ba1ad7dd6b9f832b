/* Finds the opening of a sieve from the text of a cell: by name in a table of
 * standard sieves, or by number and unit.  Recognises pans.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/sitefile/sieve_size.h"

#include <ctype.h>
#include <math.h>
#include <string.h>

#include "base/text.h"
#include "base/tr.h"
#include "base/xalloc.h"
#include "io/sitefile/lexicon.h"
#include "io/cells/number.h"

/* Standard sieves, coarsest first.  name, number, mm: from ASTM E11-20, Table
 * 1, alternative and standard designation; the number of the first N_INCHES is
 * in inches.  The openings are those of the standard, which are not exactly
 * 25.4 times the inches.  tyler, bs: the mesh number with the nearest opening
 * in the Tyler standard screen scale, and in BS 410 up to its edition of 1976,
 * from the comparison tables of both and of ASTM E11; or 0. */
enum { N_INCHES = 23 };
static const struct {
	const char *name;
	double number, mm, tyler, bs;
} SIEVES[] = {{"5 in", 5, 125, 0, 0}, {"4.24 in", 4.24, 106, 0, 0},
    {"4 in", 4, 100, 0, 0}, {"3 1/2 in", 3.5, 90, 0, 0}, {"3 in", 3, 75, 0, 0},
    {"2 1/2 in", 2.5, 63, 0, 0}, {"2.12 in", 2.12, 53, 0, 0},
    {"2 in", 2, 50, 0, 0}, {"1 3/4 in", 1.75, 45, 0, 0},
    {"1 1/2 in", 1.5, 37.5, 0, 0}, {"1 1/4 in", 1.25, 31.5, 0, 0},
    {"1.06 in", 1.06, 26.5, 0, 0}, {"1 in", 1, 25, 0, 0},
    {"7/8 in", 0.875, 22.4, 0, 0}, {"3/4 in", 0.75, 19, 0, 0},
    {"5/8 in", 0.625, 16, 0, 0}, {"0.530 in", 0.53, 13.2, 0, 0},
    {"1/2 in", 0.5, 12.5, 0, 0}, {"7/16 in", 0.4375, 11.2, 0, 0},
    {"3/8 in", 0.375, 9.5, 0, 0}, {"5/16 in", 0.3125, 8, 2.5, 0},
    {"0.265 in", 0.265, 6.7, 3, 0}, {"1/4 in", 0.25, 6.3, 0, 0},
    {"No. 3 1/2", 3.5, 5.6, 3.5, 3}, {"No. 4", 4, 4.75, 4, 3.5},
    {"No. 5", 5, 4, 5, 4}, {"No. 6", 6, 3.35, 6, 5}, {"No. 7", 7, 2.8, 7, 6},
    {"No. 8", 8, 2.36, 8, 7}, {"No. 10", 10, 2, 9, 8},
    {"No. 12", 12, 1.7, 10, 10}, {"No. 14", 14, 1.4, 12, 12},
    {"No. 16", 16, 1.18, 14, 14}, {"No. 18", 18, 1, 16, 16},
    {"No. 20", 20, 0.85, 20, 18}, {"No. 25", 25, 0.71, 24, 22},
    {"No. 30", 30, 0.6, 28, 25}, {"No. 35", 35, 0.5, 32, 30},
    {"No. 40", 40, 0.425, 35, 36}, {"No. 45", 45, 0.355, 42, 44},
    {"No. 50", 50, 0.3, 48, 52}, {"No. 60", 60, 0.25, 60, 60},
    {"No. 70", 70, 0.212, 65, 72}, {"No. 80", 80, 0.18, 80, 85},
    {"No. 100", 100, 0.15, 100, 100}, {"No. 120", 120, 0.125, 115, 120},
    {"No. 140", 140, 0.106, 150, 150}, {"No. 170", 170, 0.09, 170, 170},
    {"No. 200", 200, 0.075, 200, 200}, {"No. 230", 230, 0.063, 250, 240},
    {"No. 270", 270, 0.053, 270, 300}, {"No. 325", 325, 0.045, 325, 350},
    {"No. 400", 400, 0.038, 400, 400}, {"No. 450", 450, 0.032, 0, 0},
    {"No. 500", 500, 0.025, 0, 0}, {"No. 635", 635, 0.02, 0, 0}};

/* Openings in ISO 3310-1 and EN 933-2 that are not in ASTM E11, mm. */
static const double OTHERS[] = {80, 56, 40, 35.5, 28, 20, 18, 14, 12, 10, 9,
    7.1, 6, 5, 4.5, 3.55, 3.15, 3, 2.5, 2.24, 1.8, 1.6, 1.25, 1.12, 0.9, 0.8,
    0.63, 0.56, 0.45, 0.4, 0.315, 0.28, 0.224, 0.2, 0.16, 0.14, 0.112, 0.1,
    0.08, 0.071, 0.056, 0.05, 0.04, 0.036};

/* Reads "4", "3/8", "3 1/2", "3-1/2" or "0.530" at *text, which begins with a
 * digit or a point, and moves *text past it. */
static double
parse_mixed_fraction(const char **text)
{
	double whole = 0, part = 0, of = 1;
	int n = 0;
	int got =
	    sscanf(*text, "%lf%*1[ -]%lf / %lf%n", &whole, &part, &of, &n);
	if (got == 3 && part > 0) { /* not 1 - 3/8, which is a class */
		*text += n;
		return whole + part / of;
	}
	if (sscanf(*text, "%lf / %lf%n", &part, &of, &n) == 2) {
		*text += n;
		return part / of;
	}
	sscanf(*text, "%lf%n", &whole, &n);
	*text += n;
	return whole;
}

/* Reads the series that the word at *text states, and moves *text past it.
 * Returns SIEVE_NONE if the word cannot be part of a sieve name. */
static enum sieve_series
parse_sieve_series_word(const char **text)
{
	static const struct {
		const char *word;
		enum sieve_series series;
	} NAMES[] = {{"#", SIEVE_ASTM}, {"n\xC2\xBA", SIEVE_ASTM},
	    {"n\xC2\xB0", SIEVE_ASTM}, {"number", SIEVE_ASTM},
	    {"no.", SIEVE_ASTM}, {"no", SIEVE_ASTM}, {"nr.", SIEVE_ASTM},
	    {"nr", SIEVE_ASTM}, {"astm", SIEVE_ASTM}, {"u.s.", SIEVE_ASTM},
	    {"us", SIEVE_ASTM}, {"tyler", SIEVE_TYLER}, {"bss", SIEVE_BS},
	    {"bs", SIEVE_BS}, {"b.s.", SIEVE_BS}, {"meshes", SIEVE_MESH},
	    {"mesh", SIEVE_MESH}, {"inches", SIEVE_INCH}, {"inch", SIEVE_INCH},
	    {"in.", SIEVE_INCH}, {"in", SIEVE_INCH}, {"pulgadas", SIEVE_INCH},
	    {"pulgada", SIEVE_INCH}, {"pulg.", SIEVE_INCH},
	    {"pulg", SIEVE_INCH}, {"polegadas", SIEVE_INCH},
	    {"polegada", SIEVE_INCH}, {"pol.", SIEVE_INCH}, {"pol", SIEVE_INCH},
	    {"tum", SIEVE_INCH}, {"zoll", SIEVE_INCH}, {"\"", SIEVE_INCH},
	    {"''", SIEVE_INCH}, {"\xE2\x80\xB3", SIEVE_INCH},
	    {"\xE2\x80\x9D", SIEVE_INCH}};
	for (size_t i = 0; i < ARRAY_LEN(NAMES); i++) {
		size_t n = strlen(NAMES[i].word);
		if (strncmp(*text, NAMES[i].word, n) == 0) {
			*text += n;
			return NAMES[i].series;
		}
	}
	return SIEVE_NONE;
}

/* Returns the series that a name states ("BS 7 mesh"), and its number in
 * *value; SIEVE_NONE if the text is not a sieve name. */
static enum sieve_series
parse_sieve_series_and_number(const char *text, double *value)
{
	FREED char *folded = text_fold_case_and_accents(text);
	enum sieve_series series = SIEVE_NONE;
	bool good = true;
	*value = NAN;
	for (const char *p = folded; good && *p != '\0';) {
		if (*p == ' ' || (*p == '-' && p > folded)) {
			p++;
			continue;
		}
		if (isdigit((unsigned char)*p) || *p == '.') {
			good = isnan(*value) &&
			       isdigit((unsigned char)p[*p == '.']);
			*value = good ? parse_mixed_fraction(&p) : NAN;
			continue;
		}
		enum sieve_series word = parse_sieve_series_word(&p);
		good = word != SIEVE_NONE;
		if (series == SIEVE_NONE || series == SIEVE_MESH)
			series = word;
		else if (word != SIEVE_MESH && word != series &&
			 word != SIEVE_ASTM)
			good = false;
	}
	return good && *value > 0 && isfinite(*value) ? series : SIEVE_NONE;
}

/* Returns the opening, mm, of the sieve with this number in a series, or
 * NAN. */
static double
sieve_opening_of_number(enum sieve_series series, double number)
{
	for (size_t i = 0; i < ARRAY_LEN(SIEVES); i++) {
		enum sieve_series astm = i < N_INCHES ? SIEVE_INCH : SIEVE_ASTM;
		double own = series == SIEVE_TYLER ? SIEVES[i].tyler
			     : series == SIEVE_BS  ? SIEVES[i].bs
			     : series == astm      ? SIEVES[i].number
						   : 0;
		if (own > 0 && fabs(own - number) < 1e-9)
			return SIEVES[i].mm;
	}
	return NAN;
}

/* Returns the opening of the standard sieve nearest to a size, if it differs
 * from the size by less than the given share of it; else NAN. */
static double
nearest_sieve_opening(double mm, double share)
{
	double nearest = NAN, off = share * mm;
	for (size_t i = 0; i < ARRAY_LEN(SIEVES) + ARRAY_LEN(OTHERS); i++) {
		double other = i < ARRAY_LEN(SIEVES)
				   ? SIEVES[i].mm
				   : OTHERS[i - ARRAY_LEN(SIEVES)];
		if (fabs(other - mm) < off) {
			off = fabs(other - mm);
			nearest = other;
		}
	}
	return nearest;
}

enum sieve_series
sieve_series_of_name(const char *text)
{
	double value;
	return parse_sieve_series_and_number(text, &value);
}

double
sieve_mm_of_name(const char *text, enum sieve_series head)
{
	double value;
	enum sieve_series series = parse_sieve_series_and_number(text, &value);
	bool bare = series == SIEVE_NONE;
	if (bare || (series == SIEVE_MESH && head != SIEVE_NONE)) {
		const char *p = text + strspn(text, " ");
		if (bare && head != SIEVE_NONE &&
		    isdigit((unsigned char)p[*p == '.']))
			value = parse_mixed_fraction(&p);
		if (bare && (head == SIEVE_NONE || p[strspn(p, " ")] != '\0' ||
				isnan(value)))
			return 0;
		bool inches =
		    bare && head == SIEVE_ASTM && strchr(text, '/') != NULL;
		if (inches && value == 3.5) /* of inches, or No. 3 1/2 */
			return NAN;
		series = inches ? SIEVE_INCH : head;
	}
	double mm = sieve_opening_of_number(series, value);
	if (series != SIEVE_INCH || !bare || !isnan(mm))
		return mm;
	/* Decimal inches are rounded openings: 0.0469 is 1.18 mm. */
	mm = nearest_sieve_opening(25.4 * value, 0.015);
	return isnan(mm) ? 25.4 * value : mm;
}

bool
sieve_is_standard(double mm)
{
	return !isnan(nearest_sieve_opening(mm, 0.01));
}

double
sieve_next_coarser(double mm, bool astm)
{
	static const double EN[] = {0.063, 0.125, 0.25, 0.5, 1, 2, 4, 5.6, 8,
	    11.2, 16, 22.4, 31.5, 45, 63, 90, 125};
	static const double E11[] = {0.075, 0.15, 0.3, 0.6, 1.18, 2.36, 4.75,
	    9.5, 12.5, 19, 25, 37.5, 50, 75, 100};
	const double *series = astm ? E11 : EN;
	size_t n = astm ? ARRAY_LEN(E11) : ARRAY_LEN(EN), i = 0;
	while (i < n && series[i] < 1.01 * mm)
		i++;
	return i < n ? series[i] : 10 * ceil(0.1 * sqrt(2) * mm);
}

char *
sieve_nearest_names(const char *text)
{
	double wanted;
	bool inches =
	    parse_sieve_series_and_number(text, &wanted) == SIEVE_INCH;
	size_t finer = inches ? 0 : N_INCHES, end = ARRAY_LEN(SIEVES);
	while (finer < (inches ? N_INCHES : end) &&
	       (inches ? SIEVES[finer].number >= wanted
		       : SIEVES[finer].number <= wanted))
		finer++;
	char *list = xstrdup("");
	for (size_t i = finer > 0 ? finer - 1 : 0; i < end && i <= finer; i++)
		xappend_to_list(&list, " and ", tr("%s (%g mm)"),
		    SIEVES[i].name, SIEVES[i].mm);
	return list;
}

struct sieve_unit
sieve_unit_from_words(uint64_t means)
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

/* The smallest size in phi above 0, as these are stated in quarters. */
static const double LEAST_PHI = 0.25;

/* True for a name of what is below the finest sieve, in several languages: pan,
 * Botten, <0.063, -0.063 mm. */
static bool
is_pan_name(const struct cell *cell)
{
	const char *text = cell->text;
	size_t unknown;
	double v;
	/* -0.063 means below that sieve, but -0.5 may be phi, which has no
	 * unit. */
	if (number_value_of_cell(*cell, &v) && v < 0)
		return v > -LEAST_PHI;
	if (text[0] == '-' && isdigit((unsigned char)text[1])) {
		const char *rest = text + 1 + strspn(text + 1, "0123456789.,");
		uint64_t unit = lexicon_text_meanings(rest, &unknown);
		return (unit & (WORD_MM | WORD_UM)) != 0 && unknown == 0 &&
		       strpbrk(rest, "0123456789/") == NULL;
	}
	if (text[0] == '<') {
		const char *rest = text + 1 + strspn(text + 1, " ");
		return isdigit((unsigned char)rest[0]) ||
		       sieve_series_of_name(rest) != SIEVE_NONE;
	}
	if (isdigit((unsigned char)text[0]) || strpbrk(text, "0123456789"))
		return false;
	uint64_t means = lexicon_text_meanings(text, &unknown);
	return (means & WORD_PAN) != 0 && unknown == 0 &&
	       (means & (WORD_TOTAL | WORD_LOSS)) == 0;
}

/* Cuts the cell "63 um" to 63 and returns the length of the unit, mm; 0 if
 * there is no unit of length. */
static double
sieve_size_split_off_unit(
    const struct sheet *sheet, struct cell *cell, char copy[static 40])
{
	size_t n = strlen(cell->text), unknown;
	if (cell->kind != CELL_TEXT || n == 0 || n >= 40)
		return 0;
	size_t at = n;
	while (at > 0 && !isdigit((unsigned char)cell->text[at - 1]))
		at--;
	/* 64 m/s is a speed. */
	if (at == 0 || at == n || strchr(cell->text + at, '/') != NULL)
		return 0;
	struct sieve_unit unit = sieve_unit_from_words(
	    lexicon_text_meanings(cell->text + at, &unknown));
	if (unknown > 0 || unit.mm == 0)
		return 0;
	memcpy(copy, cell->text, at);
	copy[at] = '\0';
	*cell = number_reparse_cell_with_text(sheet, *cell, copy);
	return unit.mm;
}

/* Converts a size to mm, rounded to 9 decimals.  unit: mm; 0 means 1 mm. */
static double
mm_of_value_in_unit(double value, double unit)
{
	return round(value * (unit > 0 ? unit : 1) * 1e9) / 1e9;
}

/* Reads one end of a class, but not of one in inches, because 3/8 in is a
 * sieve.  *own gets the length of its unit, mm, or 0 if it has none. */
static bool
read_end_of_class(
    const struct sheet *sheet, char *text, double *value, double *own)
{
	char copy[40];
	struct cell cell = number_reparse_cell_with_text(
	    sheet, (struct cell){0}, text_trim(text));
	*own = sieve_size_split_off_unit(sheet, &cell, copy);
	return *own <= 1 && number_value_of_cell(cell, value);
}

/* Reads a class between two sizes, "11,2/16", "11,2 - 16 mm" or "-16 +11.2", or
 * above one, "> 22,4" or "+22.4".  lower, upper: in mm; upper is 0 for a class
 * above a size.  unit: of sizes without one, mm, or 0 if they need one; a unit
 * after the second size is also that of the first.  Returns false if the cell
 * is not a class. */
static bool
read_class(const struct sheet *sheet, struct cell cell, double unit,
    double *lower, double *upper)
{
	char copy[40];
	double a, b, own_a, own_b;
	size_t n = strlen(cell.text);
	*lower = *upper = 0;
	if (cell.kind != CELL_TEXT || n >= sizeof copy)
		return false;
	memcpy(copy, cell.text, n + 1);
	char sign = copy[0];
	bool signs = sign == '+' || sign == '-';
	char *first = copy + (signs ? 1 : strspn(copy, "> "));
	char *cut = strpbrk(first, signs ? "+-" : "/-");
	if (cut == NULL && first > copy && sign != '-') {
		if (!read_end_of_class(sheet, first, &a, &own_a))
			return false;
		own_a = own_a > 0 ? own_a : unit;
		*lower = mm_of_value_in_unit(a, own_a);
		return own_a > 0;
	}
	if (cut == NULL || cut == first || cut[0] == sign)
		return false;
	*cut = '\0';
	if (!read_end_of_class(sheet, first, &a, &own_a) ||
	    !read_end_of_class(sheet, cut + 1, &b, &own_b))
		return false;
	own_b = own_b > 0 ? own_b : unit;
	a = mm_of_value_in_unit(a, own_a > 0 ? own_a : own_b);
	b = mm_of_value_in_unit(b, own_b);
	*lower = fmin(a, b);
	*upper = fmax(a, b);
	return own_b > 0 && a != b;
}

bool
sieve_cell_is_class(const struct sheet *sheet, struct cell cell)
{
	double lower, upper;
	return read_class(sheet, cell, 1, &lower, &upper);
}

double
sieve_upper_mm_of_class_cell(
    const struct sheet *sheet, struct cell cell, struct sieve_unit unit)
{
	double lower, upper;
	return unit.series == SIEVE_NONE &&
		       read_class(sheet, cell, unit.mm, &lower, &upper)
		   ? upper
		   : 0;
}

enum sieve_kind
sieve_read_size(const struct sheet *sheet, struct cell cell,
    struct sieve_unit unit, double *mm)
{
	char copy[40];
	double value;
	*mm = NAN;
	if (cell.kind == CELL_DATE || cell.text[0] == '\0')
		return SIEVE_IS_NONE;
	/* A number alone is a name only if the heading says so. */
	if (unit.series == SIEVE_NONE && cell.kind == CELL_TEXT &&
	    cell.value == AS_NUMBER && cell.number > 0) {
		*mm = mm_of_value_in_unit(cell.number, unit.mm);
		return SIEVE_IS_SIZE;
	}
	/* With mesh numbers, -200 is what passes No. 200. */
	bool mesh = unit.series != SIEVE_NONE && unit.series != SIEVE_PHI &&
		    unit.series != SIEVE_INCH && cell.text[0] == '-' &&
		    sieve_mm_of_name(cell.text + 1, unit.series) > 0;
	if (mesh || is_pan_name(&cell))
		return SIEVE_IS_PAN;
	if (unit.series == SIEVE_PHI) {
		if (!number_value_of_cell(cell, &value) ||
		    fabs(value) > SIEVE_MOST_PHI)
			return SIEVE_IS_NONE;
		*mm = round(exp2(-value) * 1e9) / 1e9;
		return SIEVE_IS_SIZE;
	}
	double named = sieve_mm_of_name(cell.text, unit.series);
	if (named != 0) {
		*mm = named;
		return SIEVE_IS_SIZE;
	}
	double lower, upper;
	if (unit.series == SIEVE_NONE &&
	    read_class(sheet, cell, unit.mm, &lower, &upper)) {
		*mm = lower > 0 ? lower : (double)NAN;
		return lower > 0 ? SIEVE_IS_SIZE : SIEVE_IS_PAN;
	}
	double own = sieve_size_split_off_unit(sheet, &cell, copy);
	if (!number_value_of_cell(cell, &value) || value < 0)
		return SIEVE_IS_NONE;
	if (value == 0)
		return SIEVE_IS_PAN;
	*mm = mm_of_value_in_unit(value, own > 0 ? own : unit.mm);
	return SIEVE_IS_SIZE;
}

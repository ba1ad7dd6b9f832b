/* Finds the sizes of a table's sieves and their unit, and sorts them, coarsest
 * first.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/sitefile/site_sieve.h"

#include <ctype.h>
#include <math.h>
#include <string.h>

#include "base/text.h"
#include "base/tr.h"
#include "base/xalloc.h"
#include "io/sitefile/units.h"
#include "io/sitefile/lexicon.h"
#include "io/cells/number.h"

/* The largest sieve of a crusher's product is within these limits, mm.  Above
 * them the numbers may be in um, below in inches or metres.  COARSEST_TOP
 * applies if the sheet states a unit of length, the others if it states
 * none. */
static const double COARSEST_TOP = 500, LEAST_TOP = 4, COARSE_TOP = 150;

double
site_sieve_read_mm(
    struct sheet *sheet, struct cell cell, double unit, const char *wanted)
{
	double v;
	if (cell.text[0] == '\0') {
		sheet_report_expected(sheet, cell, wanted,
		    "write the sieve size, or remove the row");
		return NAN;
	}
	if (!number_read_cell(sheet, cell, wanted, &v))
		return NAN;
	double mm = round_to_step(v * unit, 1e9);
	if ((mm >= SIZE_LEAST_MM && mm <= SIZE_MOST_MM) || v == 0)
		return mm;
	sheet_report_expected(sheet, cell,
	    v > 0 ? N_("a size from 1e-6 to 1e4 mm") : N_("a positive size"),
	    "%s",
	    v > 0 ? tr("check the number and its unit")
		  : tr("write pan for what is below the finest sieve"));
	return NAN;
}

/* Reports a sieve name that does not exist. */
static void
report_unknown_sieve_name(struct table *t, struct cell cell)
{
	if (sieve_series_of_name(cell.text) == SIEVE_MESH ||
	    t->unit.series == SIEVE_MESH) {
		sheet_report_expected(t->sheet, cell,
		    "a mesh number with its series",
		    "write Tyler, BS or No. (ASTM E11) before the numbers or "
		    "in the heading; or load FILE columns=\"%zu=sieve tyler, "
		    "..\"",
		    t->number[0]);
		return;
	}
	FREED char *nearest = sieve_nearest_names(cell.text);
	sheet_report_expected(t->sheet, cell, "a sieve of ASTM E11",
	    "use the nearest: %s; or begin a remark with # and a word, not a "
	    "number alone",
	    nearest);
}

/* Returns the size of a row's sieve, mm; 0 for the pan, NAN after a fault. */
static double
sieve_mm_of_row(struct table *t, struct cell cell)
{
	double mm;
	enum sieve_kind kind = sieve_read_size(t->sheet, cell, t->unit, &mm);
	if (kind == SIEVE_IS_PAN)
		return 0;
	if (kind == SIEVE_IS_SIZE && isnan(mm)) {
		report_unknown_sieve_name(t, cell);
		return NAN;
	}
	if (kind == SIEVE_IS_SIZE && mm >= SIZE_LEAST_MM && mm <= SIZE_MOST_MM)
		return mm;
	bool inches = strchr(cell.text, '/') != NULL &&
		      sieve_mm_of_name(cell.text, SIEVE_INCH) > 0;
	if (inches || isalpha((unsigned char)cell.text[0])) {
		sheet_report_expected(t->sheet, cell, "a sieve size or pan",
		    "%s",
		    inches ? tr("write inches, Tyler or BS into the heading")
			   : tr("remove sums and remarks from the table, or "
				"begin their line with #"));
		return NAN;
	}
	return site_sieve_read_mm(t->sheet, cell,
	    t->unit.mm > 0 ? t->unit.mm : 1, "a sieve size or pan");
}

/* A summary of a table's sieves.  n: how many are bare numbers or fractions;
 * n_part: how many are fractions, 3/8, as of inches.  Of the numbers, n_astm
 * are numbers of ASTM E11 sieves, n_below are below 0, and n_beyond are outside
 * the range of phi; rises: they rise from the first to the last; even: by equal
 * steps; whole: all are whole.  named: each size is a name or has its own unit.
 * most: the largest size, if numbers are in mm; in_mm, in_um: the share of
 * sizes that are real sieves, if they are in mm or in um. */
struct numbers {
	size_t n, n_part, n_astm, n_below, n_beyond;
	bool rises, even, whole, named;
	double most, in_mm, in_um;
};

/* True if a text is a fraction of an inch that is the size of a sieve, 3/8 or 1
 * 1/2; not a class, 12.5/16. */
static bool
is_inch_fraction(const char *text)
{
	const char *bar = strchr(text, '/');
	double parts;
	return bar != NULL && isdigit((unsigned char)text[0]) &&
	       strpbrk(text, ".,") == NULL &&
	       text_parse_number(bar + 1, &parts) &&
	       (parts == 2 || parts == 4 || parts == 8 || parts == 16 ||
		   parts == 32) &&
	       sieve_mm_of_name(text, SIEVE_ASTM) > 0;
}

/* True if two texts are neighbouring classes, 8/16 and 4/8. */
static bool
are_neighbouring_classes(const char *a, const char *b)
{
	const char *low = strchr(a, '/'), *high = strchr(b, '/');
	if (low == NULL || high == NULL)
		return false;
	size_t from = (size_t)(low - a), to = (size_t)(high - b);
	return (strlen(high + 1) == from && strncmp(a, high + 1, from) == 0) ||
	       (strlen(low + 1) == to && strncmp(b, low + 1, to) == 0);
}

static bool
are_fractions_inches(const struct table *t)
{
	size_t meet = 0;
	for (size_t i = 1; i < t->n_row; i++)
		meet += are_neighbouring_classes(
		    t->row[i - 1].cell[0].text, t->row[i].cell[0].text);
	return meet < 2;
}

/* Counts the sizes that are names of sieves, and those that standards have. */
static void
count_named_and_standard_sizes(const struct table *t, struct numbers *all)
{
	const struct sieve_unit none = {0, SIEVE_NONE}, bare = {1, SIEVE_NONE};
	size_t named = 0, numbers = 0, n = 0, in_mm = 0, in_um = 0;
	for (size_t i = 0; i < t->n_row; i++) {
		struct cell cell = t->row[i].cell[0];
		double v, mm;
		if (sieve_read_size(t->sheet, cell, none, &mm) ==
		    SIEVE_IS_SIZE) {
			bool number = number_value_of_cell(cell, &v);
			numbers += number;
			named += !number;
		}
		if (sieve_read_size(t->sheet, cell, bare, &mm) !=
			SIEVE_IS_SIZE ||
		    isnan(mm))
			continue;
		n++;
		in_mm += sieve_is_standard(mm);
		in_um += sieve_is_standard(mm * 1e-3);
		all->most = fmax(all->most, mm);
	}
	all->named = named > 0 && numbers == 0;
	all->in_mm = n > 0 ? (double)in_mm / (double)n : 0;
	all->in_um = n > 0 ? (double)in_um / (double)n : 0;
}

static struct numbers
summarise_numbers_in_sieve_column(const struct table *t)
{
	struct numbers all = {.rises = true, .even = true, .whole = true};
	bool fractions = are_fractions_inches(t);
	double v, last = NAN, step = NAN;
	count_named_and_standard_sizes(t, &all);
	for (size_t i = 0; i < t->n_row; i++) {
		struct cell cell = t->row[i].cell[0];
		bool part = fractions && is_inch_fraction(cell.text);
		bool number = number_value_of_cell(cell, &v);
		all.n += part || number;
		all.n_part += part;
		all.whole = all.whole && !(number && v != floor(v));
		if (part || !number)
			continue;
		all.n_astm +=
		    v > 0 && sieve_mm_of_name(cell.text, SIEVE_ASTM) > 0;
		all.n_below += v < 0;
		all.n_beyond += fabs(v) > SIEVE_MOST_PHI;
		all.even = all.even && !(fabs(v - last - step) > 1e-9);
		step = v - last;
		all.rises = all.rises && !(v <= last);
		last = v;
	}
	return all;
}

/* Recognises numbers of ASTM E11 sieves, 4, 8, 16 .. 200, which rise while the
 * sieves get finer.  said: the heading says number, though 16, 8, 4 could also
 * be in mm.  Without such a heading, fractions of an inch above them show that
 * they are not mm.  Returns SIEVES_ASSUMED, and leaves t->unit, if they are not
 * sieve numbers. */
static enum sieve_certainty
recognise_astm_numbers(struct table *t, const struct numbers *all, bool said)
{
	bool astm = all->n > 2 && all->n_part + all->n_astm == all->n;
	if (!astm || (!said && (!all->rises || all->n < 4)))
		return SIEVES_ASSUMED;
	t->unit = (struct sieve_unit){0, SIEVE_ASTM};
	if (said && !all->rises && all->in_mm >= 1)
		return SIEVES_OPEN;
	return said              ? SIEVES_SAID
	       : all->n_part > 0 ? SIEVES_ASSUMED
				 : SIEVES_OPEN;
}

/* Returns the likeliest unit of numbers for which several are possible. */
static struct sieve_unit
guess_sieve_unit(const struct numbers *all)
{
	bool small = all->in_mm < 0.8 && all->in_um >= 0.8;
	if (all->n_below > 0)
		return (struct sieve_unit){0, SIEVE_PHI};
	return (struct sieve_unit){
	    small || all->most > COARSE_TOP ? 1e-3 : 1, SIEVE_NONE};
}

/* Decides the unit of the sieves.  Assumes mm or um if none is stated and the
 * numbers leave no doubt.  means: the meanings of the heading. */
static enum sieve_certainty
site_sieve_find_unit(struct table *t, uint64_t means)
{
	struct numbers all = summarise_numbers_in_sieve_column(t);
	double most = all.most, most_um = 1e-3 * all.most;
	bool mesh = t->unit.series == SIEVE_MESH && all.whole;
	bool said = (means & WORD_NUMBER) != 0;
	if (all.named)
		return SIEVES_SAID;
	/* The letter phi also means a diameter. */
	if (t->unit.series == SIEVE_PHI && all.n_beyond == 0)
		return all.n_below > 0 || all.even ? SIEVES_SAID : SIEVES_OPEN;
	if (t->unit.series == SIEVE_PHI)
		t->unit = (struct sieve_unit){0, SIEVE_NONE};
	if (t->unit.series != SIEVE_NONE && t->unit.series != SIEVE_MESH)
		return SIEVES_SAID;
	if (t->unit.mm > 0 && most * t->unit.mm <= COARSEST_TOP &&
	    most * t->unit.mm >= 0.1)
		return SIEVES_SAID;
	if (t->unit.mm > 0) {
		t->unit = guess_sieve_unit(&all);
		return SIEVES_OPEN;
	}
	if (mesh)
		/* and each row is reported for its missing series */
		return SIEVES_SAID;
	t->unit = (struct sieve_unit){1, SIEVE_NONE};
	enum sieve_certainty numbers = recognise_astm_numbers(t, &all, said);
	if (t->unit.series == SIEVE_ASTM)
		return numbers;
	if (all.in_mm >= 0.8 && most > LEAST_TOP && most <= COARSE_TOP)
		return SIEVES_ASSUMED;
	t->unit = guess_sieve_unit(&all);
	return all.in_um >= 0.8 && most_um > LEAST_TOP && most_um <= COARSE_TOP
		   ? SIEVES_ASSUMED
		   : SIEVES_OPEN;
}

/* Returns 1 if the sizes rise without exception, ignoring NAN, -1 if they fall
 * or there is at most one, else 0. */
static int
order_of_sizes(const double *v, size_t n)
{
	int rises = 0, falls = 0, pairs = 0;
	double last = NAN;
	for (size_t i = 0; i < n; i++) {
		if (isnan(v[i]))
			continue;
		pairs += !isnan(last);
		rises += v[i] > last;
		falls += v[i] < last;
		last = v[i];
	}
	return falls == pairs ? -1 : rises == pairs;
}

/* Reads 2, 1, 500, 250 as mm and um, because sieves below 1 mm are named by
 * their um, as in ISO 3310.  Adds the unit to the cells in um, which are at one
 * end of the table, if that puts all sizes in order.  Returns true if it
 * did. */
static bool
read_sizes_in_mm_and_um(struct table *t)
{
	size_t n = t->n_row, from = 0, to = 0;
	FREED double *v = xcalloc_doubles(n);
	double number;
	for (size_t i = 0; i < n; i++)
		v[i] = number_value_of_cell(t->row[i].cell[0], &number) &&
			       number > 0
			   ? number
			   : NAN;
	bool split = false;
	for (size_t i = 1; i < n && order_of_sizes(v, n) == 0 && to == 0; i++) {
		from = v[i] > 10 * v[i - 1] ? i : 0;
		to = v[i] > 10 * v[i - 1] ? n : 10 * v[i] < v[i - 1] ? i : 0;
	}
	for (size_t i = from; i < to; i++) {
		split = v[i] >= 20 && v[i] < 1000;
		v[i] /= 1000;
		if (!split && !isnan(v[i]))
			break;
	}
	split = split && order_of_sizes(v, n) != 0;
	for (size_t i = from; split && i < to; i++) {
		struct cell *cell = &t->row[i].cell[0];
		if (isnan(v[i]))
			continue;
		*cell = number_reparse_cell_with_text(t->sheet, *cell,
		    layout_adopt_text(t, xasprintf("%s um", cell->text)));
	}
	return split;
}

static bool
are_sieves_finest_first(const struct table *t)
{
	FREED double *mm = xcalloc_doubles(t->n_row);
	for (size_t i = 0; i < t->n_row; i++)
		if (sieve_read_size(t->sheet, t->row[i].cell[0], t->unit,
			&mm[i]) != SIEVE_IS_SIZE)
			mm[i] = NAN;
	return order_of_sizes(mm, t->n_row) > 0;
}

struct cell
site_sieve_heading_cell(const struct table *t)
{
	return t->n_head > t->titles ? t->head[t->titles].cell[0]
				     : t->row[0].cell[0];
}

/* Checks that sizes fall and do not repeat.  Compares neighbours, so that one
 * wrong size is one fault. */
static void
site_sieve_check_order(struct table *t)
{
	size_t last = t->n_row;
	double least = INFINITY;
	for (size_t i = 0; i < t->n_row; i++) {
		if (isnan(t->mm[i]))
			continue;
		struct cell cell = t->row[i].cell[0];
		size_t twin = t->mm[i] < least ? i : 0;
		least = fmin(least, t->mm[i]);
		while (twin < i && t->mm[twin] != t->mm[i])
			twin++;
		if (twin < i)
			sheet_report_fault(t->sheet, cell,
			    "duplicate sieve: %s is already in line %d\n"
			    "remove one of the two rows, or correct its size",
			    cell.text, t->row[twin].line);
		else if (last < t->n_row && t->mm[i] > t->mm[last])
			sheet_report_fault(t->sheet, cell,
			    "expected sieves coarsest first, got %s after %s\n"
			    "sort the rows by size, largest first, or correct "
			    "the size",
			    cell.text, t->row[last].cell[0].text);
		last = i;
	}
}

enum sieve_certainty
site_sieve_find_unit_and_sort(struct table *t, uint64_t told)
{
	FREED char *head = layout_column_heading_text(t, 0);
	/* A heading of speeds, beside sieves without a heading, states no unit
	 * of size. */
	struct head said = heading_parse(head);
	bool speeds =
	    (said.unit != SPEED_NO_UNIT || (said.means & WORD_SPEED) != 0) &&
	    (said.means & WORD_SIZE) == 0;
	uint64_t means = told != 0 ? told : speeds ? 0 : said.means;
	t->unit = sieve_unit_from_words(means);
	bool lengths = t->unit.mm == 1 || t->unit.mm == 0;
	bool split = lengths && t->unit.series == SIEVE_NONE &&
		     read_sizes_in_mm_and_um(t);
	if (split)
		t->unit.mm = 1;
	struct sieve_unit stated = t->unit;
	enum sieve_certainty certainty = site_sieve_find_unit(t, means);
	if (t->unsure && told == 0)
		certainty = SIEVES_OPEN;
	if (split && certainty == SIEVES_SAID)
		certainty = SIEVES_ASSUMED;
	bool own = strncmp(site_sieve_heading_cell(t).text, "size_", 5) == 0;
	bool unit = stated.mm > 0 || stated.series != SIEVE_NONE;
	if ((told != 0 || own) && certainty == SIEVES_OPEN && unit) {
		t->unit = stated;
		certainty = SIEVES_SAID;
	}
	t->finest_first = are_sieves_finest_first(t);
	for (size_t i = 0; t->finest_first && i < t->n_row / 2; i++) {
		struct row row = t->row[i];
		t->row[i] = t->row[t->n_row - 1 - i];
		t->row[t->n_row - 1 - i] = row;
	}
	return certainty;
}

/* Reports a number in a column without a heading, as a decimal comma may have
 * cut a number in two. */
static void
check_columns_have_headings(struct table *t)
{
	size_t heads = 0, last = t->n_head > 0 ? t->n_head - 1 : 0;
	for (size_t c = 0; c < t->n_col; c++) {
		FREED char *head = layout_column_heading_text(t, c);
		heads = head[0] != '\0' ? c + 1 : heads;
	}
	for (size_t i = 0; i < t->n_row && heads > 1; i++) {
		size_t n = t->n_col;
		while (n > heads && t->row[i].cell[n - 1].text[0] == '\0')
			n--;
		if (n == heads)
			continue;
		t->lost = true;
		sheet_report_fault(t->sheet, t->row[i].cell[heads],
		    "expected %zu cells as in line %d, got %zu\n"
		    "%s",
		    heads, t->head[t->titles < last ? t->titles : last].line, n,
		    t->sheet->separator == ','
			? tr("use ; between the cells if they have decimal "
			     "commas; otherwise remove the last cells")
			: tr("remove the last cells, or give their columns "
			     "headings"));
		return;
	}
}

void
site_sieve_read_and_check(struct table *t)
{
	check_columns_have_headings(t);
	t->mm = xcalloc_doubles(t->n_row);
	for (size_t i = 0; i < t->n_row; i++) {
		t->mm[i] = sieve_mm_of_row(t, t->row[i].cell[0]);
		t->lost = t->lost || isnan(t->mm[i]);
	}
	site_sieve_check_order(t);
}

size_t
site_sieve_rows_before_repeat(const struct table *t, size_t *again)
{
	enum { ENOUGH = 3 };
	FREED double *mm = xcalloc_doubles(t->n_row);
	double least = INFINITY;
	size_t words = t->n_row, in_a_row = 0;
	*again = t->n_row;
	for (size_t i = 0; i < t->n_row && in_a_row < ENOUGH; i++) {
		bool size = sieve_read_size(t->sheet, t->row[i].cell[0],
				t->unit, &mm[i]) != SIEVE_IS_NONE;
		words = !size && words > i ? i : words;
		mm[i] = size ? mm[i] : (double)NAN;
		/* A size below all before it cannot be a repeat. */
		bool twice = false;
		for (size_t k = 0; k < i && mm[i] >= least; k++)
			twice = twice || mm[k] == mm[i];
		least = fmin(least, mm[i]);
		in_a_row = twice ? in_a_row + 1 : 0;
		*again = in_a_row == 1 ? i : *again;
	}
	if (in_a_row < ENOUGH)
		return t->n_row;
	return words < *again ? words : *again;
}

const char *
site_sieve_unit_text(const struct table *t)
{
	static const char *const SERIES[] = {"mm", "ASTM E11", "in",
	    N_("Tyler mesh"), N_("BS mesh"), N_("mesh"), "phi"};
	if (t->unit.series != SIEVE_NONE)
		return SERIES[t->unit.series];
	return t->unit.mm == 1e-3 ? "um" : t->unit.mm == 1e3 ? "m" : "mm";
}

void
site_sieve_uncomment_astm_rows(struct sheet *sheet)
{
	const char separator[] = {sheet->separator, '\0'};
	size_t rows = sheet->n_row;
	for (size_t i = sheet->n_comment; !sheet->lost && i-- > 0;) {
		const struct comment *c = &sheet->comment[i];
		FREED char *first =
		    text_without_quotes(c->text, strcspn(c->text, separator));
		bool cells = c->row.cell != NULL
				 ? c->row.n > 1
				 : c->text[strcspn(c->text, separator)] != '\0';
		first[strcspn(first, "([")] = '\0'; /* #4 (4.75 mm) */
		/* "#" alone heads a column of numbers. */
		bool head = strcmp(first, "#") == 0;
		if (cells &&
		    (head || sieve_series_of_name(first) == SIEVE_ASTM))
			sheet_turn_comment_into_row(sheet, i);
	}
	if (sheet->n_row > rows)
		number_parse_all_cells(sheet);
}

/* Converts the cells of a column to passing in per cent and checks them.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/sitefile/site_column.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "base/tr.h"
#include "base/xalloc.h"
#include "io/sitefile/lexicon.h"
#include "io/cells/number.h"

const char *const SITE_ROLES[4] = {"feed", "product", "sd", ""};

const struct site_unit SITE_UNITS[SITE_N_UNIT] = {
    {"", N_("% passing"), PASSING, OF_100, 100, N_("passing from 0 to 100 %")},
    {"_passing_pct", N_("% passing"), PASSING, OF_100, 100,
	N_("passing from 0 to 100 %")},
    {"_fraction", N_("fraction passing"), PASSING, OF_1, 1,
	N_("a fraction from 0 to 1")},
    {"_retained_g", N_("mass retained"), RETAINED, OF_MASS, 1e12,
	N_("mass retained, 0 g or more")},
    {"_retained_pct", N_("% retained"), RETAINED, OF_100, 100,
	N_("mass retained, 0 to 100 %")},
    {"_retained_fraction", N_("fraction retained"), RETAINED, OF_1, 1,
	N_("a fraction from 0 to 1")},
    {"_cum_retained_g", N_("cumulative mass retained"), CUMULATIVE, OF_MASS,
	1e12, N_("mass retained, 0 g or more")},
    {"_cum_retained_pct", N_("% cumulative retained"), CUMULATIVE, OF_100, 100,
	N_("mass retained, 0 to 100 %")},
    {"_cum_retained_fraction", N_("cumulative fraction retained"), CUMULATIVE,
	OF_1, 1, N_("a fraction from 0 to 1")},
};

size_t
site_unit_index(enum unit_kind kind, enum unit_scale scale)
{
	size_t i = 0;
	while (i < SITE_N_UNIT &&
	       (SITE_UNITS[i].kind != kind || SITE_UNITS[i].scale != scale))
		i++;
	return i < SITE_N_UNIT ? i : 0;
}

void
site_column_drop(struct columns *all, size_t i)
{
	free(all->column[i].assumed);
	all->n--;
	memmove(&all->column[i], &all->column[i + 1],
	    (all->n - i) * sizeof *all->column);
}

/* Speeds that differ by at most this, m/s, are the same, as for
 * site_run_at_speed. */
static const double SAME_SPEED = 1e-3;

static bool
is_column_of_role_and_speed(
    const struct column *c, enum role role, double speed)
{
	return c->role == role && fabs(c->speed - speed) <= SAME_SPEED;
}

size_t
site_column_count_by_role(
    const struct columns *all, const struct table *t, enum role role)
{
	size_t n = 0;
	for (size_t i = 0; i < all->n; i++)
		n += all->column[i].role == role &&
		     (t == NULL || all->column[i].table == t);
	return n;
}

size_t
site_column_count_at_speed(
    const struct columns *all, enum role role, double speed)
{
	size_t n = 0;
	for (size_t i = 0; i < all->n; i++)
		n += is_column_of_role_and_speed(&all->column[i], role, speed);
	return n;
}

struct table_samples
site_column_samples_of_table(const struct columns *all, const struct table *t)
{
	struct table_samples s = {.products = true};
	for (size_t i = 0; i < all->n; i++) {
		const struct column *c = &all->column[i];
		if (c->table != t || c->twin > 0)
			continue;
		bool product = c->role == PRODUCT;
		s.only = s.n++ == 0 ? c : NULL;
		s.feed = c->role == FEED ? c : s.feed;
		s.product = product ? c : s.product;
		s.products =
		    s.products && product && (c->speed > 0 || c->rpm > 0);
		s.open = s.open || c->open;
	}
	s.products = s.products && s.n > 0;
	return s;
}

struct column *
site_column_find(
    const struct columns *all, enum role role, double speed, size_t nth)
{
	size_t wanted =
	    site_column_count_at_speed(all, role, speed) > 1 ? nth : 0;
	for (size_t i = 0; i < all->n; i++)
		if (is_column_of_role_and_speed(&all->column[i], role, speed) &&
		    all->column[i].nth == wanted)
			return &all->column[i];
	return NULL;
}

/* How far the sum of percentages retained may be from 100, in per cent. */
static const double SUM_TOLERANCE = 0.5;

/* The share of the mass that may be lost in sieving, as EN 933-1 allows. */
static const double MASS_TOLERANCE = 0.01;

double
round_to_step(double v, double per_unit)
{
	return round(v * per_unit) / per_unit + 0.0;
}

size_t
site_column_count_values(const struct column *c)
{
	const struct table *t = c->table;
	size_t n = 0;
	for (size_t i = 0; i < t->n_row; i++)
		n += t->mm[i] > 0 && !isnan(c->pct[i]);
	return n;
}

const char *
site_column_passing_text(
    const struct column *c, size_t row, double other, char buf[static 32])
{
	double v = c->pct[row];
	if (SITE_UNITS[c->unit].kind == PASSING)
		return text_number_distinct_from(v, other, buf);
	for (int digits = 1; digits <= 9; digits++) {
		snprintf(buf, 32, "%.*f", digits, v);
		if (fabs(strtod(buf, NULL) - other) > 0 || v == other)
			break;
	}
	return buf;
}

/* Returns the heading of c with another suffix: "product_fraction@69". */
static const char *
column_heading_in_unit(
    const struct column *c, const char *suffix, char buf[static 64])
{
	char speed[32] = "";
	if (c->speed > 0)
		text_shortest_exact_number(c->speed, speed);
	snprintf(buf, 64, "%s%s%s%s", SITE_ROLES[c->role], suffix,
	    c->speed > 0 ? "@" : "", speed);
	return buf;
}

double
site_column_value_in_row(const struct column *c, size_t row)
{
	return c->table->row[row].cell[c->at].number;
}

static bool
check_value_fits_column_unit(struct column *c, struct cell cell, double v)
{
	struct sheet *sheet = c->table->sheet;
	char head[64];
	if (c->role == SD && (v > 100 || round_to_step(v, 1e12) <= 0))
		return sheet_report_expected(sheet, cell,
		    "a standard deviation above 0, up to 100",
		    "write it in percentage points of passing");
	if (v >= 0 && v <= SITE_UNITS[c->unit].most * (1 + 1e-9))
		return true;
	bool percent = SITE_UNITS[c->unit].scale == OF_1 && v > 1.05;
	/* A column of fractions with percentages in it is reported once. */
	if (percent && c->told_percent)
		return false;
	c->told_percent = c->told_percent || percent;
	return sheet_report_expected(sheet, cell, SITE_UNITS[c->unit].wanted,
	    percent ? N_("change the column heading to %s")
		    : N_("check the number%.0s"),
	    column_heading_in_unit(c, "", head));
}

/* Reads the cell of the pan, which has what passes all sieves; a passing must
 * be 0 there, and a cumulative share 100 %. */
static bool
read_pan_cell(struct column *c, struct cell cell, double v)
{
	const struct site_unit *unit = &SITE_UNITS[c->unit];
	bool cumulative = unit->kind == CUMULATIVE;
	c->pan = v;
	if (unit->kind == RETAINED || unit->scale == OF_MASS)
		return check_value_fits_column_unit(c, cell, v);
	double end = cumulative ? unit->most : 0;
	if (fabs(v - end) <= 0.01 * unit->most)
		return true;
	return sheet_report_expected(c->table->sheet, cell,
	    cumulative ? N_("100 % above the pan")
		       : N_("nothing passing the pan"),
	    "leave the cell empty, or say what the column has: "
	    "product_retained_pct@69");
}

static void
read_column_cells(struct column *c)
{
	struct table *t = c->table;
	const struct site_unit *unit = &SITE_UNITS[c->unit];
	bool retained = unit->kind == RETAINED;
	enum cell_value own = unit->scale == OF_MASS ? AS_GRAMS : AS_PERCENT;
	for (size_t i = 0; i < t->n_row; i++) {
		struct cell cell = t->row[i].cell[c->at];
		double v = 0;
		c->pct[i] = NAN;
		bool trace = cell.value == AS_TRACE;
		if (cell.value == AS_ABSENT || (trace && !retained))
			continue;
		bool good = true;
		if (cell.value == own)
			v = cell.number;
		else
			good = trace || number_read_cell(
					    t->sheet, cell, N_("a number"), &v);
		if (good && t->mm[i] <= 0)
			good = read_pan_cell(c, cell, v);
		else if (good &&
			 (good = check_value_fits_column_unit(c, cell, v)))
			c->pct[i] = v;
		c->faulty = c->faulty || !good;
	}
}

/* Moves the mass of each row, from its size down to the next, to the sieve on
 * which it stayed, which is that of the next row.  What passes the finest size
 * is the pan's. */
static void
move_masses_to_next_sieve(struct column *c)
{
	size_t n = c->table->n_row;
	if (!c->to_next || n == 0)
		return;
	c->pan = c->pct[n - 1];
	for (size_t i = n - 1; i > 0; i--)
		c->pct[i] = c->pct[i - 1];
	c->pct[0] = 0;
}

/* Sets empty cells and dashes above the first retained amount to 0, as nothing
 * stayed on those sieves. */
static void
zero_cells_above_first_mass(struct column *c)
{
	struct table *t = c->table;
	size_t first = 0;
	while (first < t->n_row && (isnan(c->pct[first]) || t->mm[first] <= 0))
		first++;
	if (SITE_UNITS[c->unit].kind == PASSING || c->role == SD || c->faulty ||
	    first == t->n_row || c->pct[first] <= 0)
		return;
	for (size_t i = 0; i < first; i++)
		c->pct[i] = t->mm[i] > 0 ? 0 : NAN;
}

/* What the lines below the table state for a column, in its unit.  total: the
 * largest total, or NAN; where: its cell.  weighed: the total is the mass
 * before sieving, M1 of EN 933-1.  washed: the amount washed out, either
 * stated, or the difference between the masses before and after washing.  odd:
 * a mass about washing that does not tell what was washed out.  fines_lost:
 * what was washed out is not known, but the mass that was sieved is. */
struct foot {
	double total, washed;
	struct cell where, odd;
	bool weighed, fines_lost;
};

static struct foot
read_totals_below_column(const struct column *c, double sum)
{
	struct foot foot = {.total = NAN, .washed = 0, .where = c->head};
	double before = NAN, after = NAN;
	for (size_t i = 0; i < c->table->n_foot; i++) {
		const struct row *row = &c->table->foot[i];
		uint64_t means = lexicon_text_meanings(row->cell[0].text, NULL);
		const struct cell *cell = &row->cell[c->at];
		bool percent = cell->value == AS_PERCENT;
		double v = percent ? (double)NAN : cell->number;
		bool washing = (means & WORD_WASHED) != 0;
		if (isnan(v)) {
			continue;
		} else if (washing && v < 0.2 * sum) {
			foot.washed += v;
		} else if (washing) { /* a mass, before or after washing */
			foot.odd = row->cell[c->at];
			before = v > after || isnan(after) ? v : before;
			after = isnan(after) || v < after ? v : after;
			before = fmax(before, v);
		} else if ((means & WORD_TOTAL) != 0 && !(v <= foot.total)) {
			foot.total = v;
			foot.where = row->cell[c->at];
			foot.weighed = (means & WORD_WEIGHED) != 0;
		}
	}
	if (!isnan(after) && before > after) {
		foot.washed = before - after;
		foot.total = isnan(foot.total) || before > foot.total
				 ? before
				 : foot.total;
		foot.weighed = true;
		foot.odd.text = NULL;
	} else if (!isnan(after) && foot.total > after) {
		foot.washed = foot.total - after;
		foot.odd.text = NULL;
	} else if (fabs(after - sum) <= MASS_TOLERANCE * sum) {
		foot.odd.text = NULL; /* it is the mass put on the sieves */
		foot.fines_lost = true;
	}
	return foot;
}

static double
sum_of_column(const struct column *c)
{
	double sum = isnan(c->pan) ? 0 : c->pan;
	for (size_t i = 0; i < c->table->n_row; i++)
		sum += isnan(c->pct[i]) ? 0 : c->pct[i];
	return sum;
}

/* Reads the lines below the table and adds the mass that was washed out to the
 * pan.  Returns false after a fault. */
static bool
add_washed_mass_to_pan(struct column *c, struct foot *foot)
{
	*foot = read_totals_below_column(c, sum_of_column(c));
	if (foot->odd.text != NULL)
		return sheet_report_fault(c->table->sheet, foot->odd,
		    "expected the masses before and after washing, or what was "
		    "washed out, got %s alone\nlabel the lines 'mass before "
		    "washing' and 'mass after washing', or write the "
		    "difference as 'washed out'",
		    foot->odd.text);
	if (foot->fines_lost)
		xfree_and_set(&c->assumed,
		    xasprintf("%s%s\n", c->assumed != NULL ? c->assumed : "\n",
			tr("without what was washed out")));
	if (foot->washed > 0)
		c->pan = (isnan(c->pan) ? 0 : c->pan) + foot->washed;
	return true;
}

/* True if the sheet states no total, or one that agrees with the sum of the
 * column; else reports it. */
static bool
check_stated_total(
    struct column *c, struct cell where, double total, double sum)
{
	if (isnan(total) || fabs(total - sum) <= MASS_TOLERANCE * total)
		return true;
	return sheet_report_fault(c->table->sheet, where,
	    "expected %.9g g, the sum of column %s, got %s\n"
	    "up to %g %% may be lost in sieving: were digits transposed, or a "
	    "sieve forgotten?",
	    round_to_step(sum, 1e6), c->head.text, where.text,
	    100 * MASS_TOLERANCE);
}

/* Returns the mass put on the sieves, in the column's unit, or 0 after a
 * fault. */
static double
total_mass_on_sieves(struct column *c)
{
	struct foot foot;
	if (!add_washed_mass_to_pan(c, &foot))
		return 0;
	double total = foot.total, sum = sum_of_column(c);
	bool cumulative = SITE_UNITS[c->unit].kind == CUMULATIVE;
	if (cumulative && !isnan(c->pan))
		return c->pan;
	bool unknown = isnan(c->pan) && isnan(total);
	if (unknown && c->twin == 0)
		sheet_report_fault(c->table->sheet, c->head,
		    "expected the mass in the pan, got none in column %s\n"
		    "add a last row: pan, with the mass below the finest sieve "
		    "(0 if there was none), or a row total with the mass "
		    "sieved",
		    c->head.text);
	if (unknown) /* a twin is not needed */
		return 0;
	if (cumulative)
		return total;
	if (isnan(c->pan) && total >= sum * (1 - MASS_TOLERANCE))
		return fmax(total, sum);
	if (!isnan(c->pan) && !(sum > 0)) {
		sheet_report_fault(c->table->sheet, c->head,
		    "expected a mass, got 0 g in column %s\n"
		    "fill the column or remove it",
		    c->head.text);
		return 0;
	}
	if (!check_stated_total(c, foot.where, total, sum))
		return 0;
	return foot.weighed ? fmax(total, sum) : sum; /* as in EN 933-1 */
}

/* Returns the total that percentages or fractions retained are shares of, or 0
 * after a fault. */
static double
total_of_retained_shares(struct column *c)
{
	char head[64];
	struct foot foot;
	double whole = SITE_UNITS[c->unit].most;
	if (!add_washed_mass_to_pan(c, &foot))
		return 0;
	double sum = sum_of_column(c), off = (sum - whole) / whole * 100;
	bool pan = !isnan(c->pan);
	/* The sum may be less by what was lost in sieving. */
	if (pan && off < -SUM_TOLERANCE && off >= -100 * MASS_TOLERANCE)
		return sum;
	if (off <= SUM_TOLERANCE && (!pan || off >= -SUM_TOLERANCE))
		return whole;
	sheet_report_fault(c->table->sheet, c->head,
	    "expected retained %s that sum to %g, got %g in column %s\n"
	    "check the numbers, or change the column heading to %s",
	    whole > 1 ? tr("percentages") : tr("fractions"), whole,
	    round_to_step(sum, 1e9), c->head.text,
	    column_heading_in_unit(c, "_cum_retained_pct", head));
	return 0;
}

/* Converts the column to percent passing with 12 decimals, as site_write prints
 * them. */
static void
convert_column_to_passing(struct column *c)
{
	const struct site_unit *unit = &SITE_UNITS[c->unit];
	struct table *t = c->table;
	double total = unit->most;
	if (c->faulty || t->lost)
		total = 0;
	else if (unit->scale == OF_MASS)
		total = total_mass_on_sieves(c);
	else if (unit->kind == RETAINED)
		total = total_of_retained_shares(c);
	double left = total;
	c->faulty = c->faulty || total <= 0;
	for (size_t i = 0; i < t->n_row; i++) {
		double v = c->pct[i];
		if (isnan(v))
			continue;
		left = unit->kind == RETAINED ? left - v : total - v;
		if (unit->kind == PASSING)
			v = 100 * v / unit->most;
		else
			v = total > 0 ? 100 * fmax(left, 0) / total : NAN;
		c->pct[i] = round_to_step(v, 1e12);
	}
}

static void
check_passing_never_rises(struct column *c)
{
	struct table *t = c->table;
	char p[32], q[32], mm[32], other[32];
	size_t last = t->n_row;
	for (size_t i = 0; i < t->n_row; i++) {
		if (isnan(c->pct[i]) || isnan(t->mm[i]))
			continue;
		bool finer = last < t->n_row && t->mm[i] < t->mm[last];
		if (finer && c->pct[i] > c->pct[last])
			sheet_report_fault(t->sheet, t->row[i].cell[c->at],
			    "passing rises from %s to %s at %s mm (finer "
			    "sieve, more passing)\n"
			    "check this row and that of %s mm: passing cannot "
			    "rise on a finer sieve",
			    site_column_passing_text(c, last, c->pct[i], p),
			    site_column_passing_text(c, i, c->pct[last], q),
			    text_number_distinct_from(
				t->mm[i], t->mm[last], mm),
			    text_number_distinct_from(
				t->mm[last], t->mm[i], other));
		last = i;
	}
}

/* Returns the row of the coarsest sieve that has a value, or n_row. */
static size_t
coarsest_row_with_value(const struct column *c)
{
	const struct table *t = c->table;
	size_t i = 0;
	while (i < t->n_row && (isnan(c->pct[i]) || !(t->mm[i] > 0)))
		i++;
	return i;
}

/* Takes the size that all of a sample passes from its coarsest class, 11.2/16.
 * Returns false if the coarsest sieve passes everything, or is not the lower
 * end of such a class. */
static bool
set_top_size_from_class(struct column *c)
{
	const struct table *t = c->table;
	size_t i = coarsest_row_with_value(c);
	if (i == t->n_row || !(c->pct[i] < 100) ||
	    SITE_UNITS[c->unit].kind != RETAINED)
		return false;
	double upper =
	    sieve_upper_mm_of_class_cell(t->sheet, t->row[i].cell[0], t->unit);
	c->top = upper > t->mm[i] ? upper : 0;
	return c->top > 0;
}

void
site_column_read_values(struct column *c)
{
	struct table *t = c->table;
	c->pct = xcalloc_doubles(t->n_row);
	c->pan = NAN;
	read_column_cells(c);
	move_masses_to_next_sieve(c);
	zero_cells_above_first_mass(c);
	if (c->role != SD) {
		convert_column_to_passing(c);
		check_passing_never_rises(c);
	}
	bool whole = c->role != SD && !c->faulty && !t->lost;
	if (whole && !set_top_size_from_class(c) && c->role == FEED) {
		/* the size of the largest grains must be known */
		size_t i = coarsest_row_with_value(c);
		c->below = i < t->n_row && c->pct[i] < 100 ? i + 1 : 0;
	}
	size_t least = c->role == FEED ? 2 : 1;
	if (!whole || c->twin > 0 || site_column_count_values(c) >= least)
		return;
	sheet_report_fault(t->sheet, c->head,
	    "expected %zu or more sieves, got %zu in column %s\n"
	    "fill the column or remove it",
	    least, site_column_count_values(c), c->head.text);
}

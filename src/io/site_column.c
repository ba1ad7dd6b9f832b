/* From the cells of a column to passing in percent.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/site_column.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "base/xalloc.h"

enum kind { PASSING, FRACTION, RETAINED_G, RETAINED_PCT, CUM_RETAINED };

static const char *const ROLES[] = {"feed", "product", "sd"};

/* What may follow the role in a header, and the largest value. */
static const struct {
	const char *suffix;
	enum kind kind;
	double most;
	const char *wanted;
} UNITS[] = {
    {"", PASSING, 100, "passing from 0 to 100 %"},
    {"_passing_pct", PASSING, 100, "passing from 0 to 100 %"},
    {"_fraction", FRACTION, 1, "a fraction from 0 to 1"},
    {"_retained_g", RETAINED_G, 1e12, "mass retained, 0 g or more,"},
    {"_retained_pct", RETAINED_PCT, 100, "mass retained, 0 to 100 %,"},
    {"_cum_retained_pct", CUM_RETAINED, 100, "mass retained, 0 to 100 %,"},
};

/* Speeds nearer than this, m/s, are one run, as for site_run_at. */
static const double SAME_SPEED = 1e-3;

/* Above this a tip speed is a slip of the pen; m/s. */
static const double FASTEST = 200;

/* Percent that the parts of a sieving may miss of the whole. */
static const double SUM_TOLERANCE = 0.5;

double
site_column_round(double v, double per_unit)
{
	return round(v * per_unit) / per_unit + 0.0;
}

struct column *
site_column_find(const struct table *t, enum role role, double speed)
{
	for (size_t i = 0; i < t->n_column; i++)
		if (t->column[i].role == role &&
		    fabs(t->column[i].speed - speed) <= SAME_SPEED)
			return &t->column[i];
	return NULL;
}

size_t
site_column_count(const struct table *t, const struct column *c)
{
	size_t n = 0;
	for (size_t i = 0; i < t->n_row; i++)
		n += t->mm[i] > 0 && !isnan(c->pct[i]);
	return n;
}

/* A bare unit, retained_g@69, is the product's. */
static bool
find_word(const char *word, struct column *c)
{
	char name[40];
	c->role = SD;
	c->unit = 0;
	if (strcmp(word, ROLES[SD]) == 0)
		return true;
	for (c->unit = 0; c->unit < ARRAY_LEN(UNITS); c->unit++) {
		const char *suffix = UNITS[c->unit].suffix;
		for (c->role = FEED; c->role <= PRODUCT; c->role++) {
			snprintf(
			    name, sizeof name, "%s%s", ROLES[c->role], suffix);
			if (strcmp(word, name) == 0)
				return true;
		}
		c->role = PRODUCT;
		if (suffix[0] != '\0' && strcmp(word, suffix + 1) == 0)
			return true;
	}
	return false;
}

/* 69, 69.5, "69 m/s" or 69m/s; text is changed. */
static bool
find_speed(struct table *t, char *text, struct column *c)
{
	size_t n = strlen(text);
	if (n >= 3 && strcmp(text + n - 3, "m/s") == 0)
		text[n - 3] = '\0';
	char *comma = strchr(text, ',');
	if (comma != NULL && t->sheet->separator != ',')
		*comma = '.';
	if (text_number(text, &c->speed) && c->speed > SAME_SPEED &&
	    c->speed <= FASTEST)
		return true;
	error_hint(sheet_wanted(t->sheet, c->head,
		       "a tip speed above 0, up to 200 m/s,"),
	    "write it behind @, as in product@69");
	return false;
}

/* The speed behind the @, which only the feed of all runs may lack. */
static bool
split_head(struct table *t, char *word, struct column *c)
{
	char *at = strchr(word, '@');
	if (at != NULL)
		*at = '\0';
	if (!find_word(text_trim(word), c)) {
		error_hint(sheet_wanted(t->sheet, c->head, "a column header"),
		    "understood are feed, feed@69, product@69 and sd@69; feed "
		    "and product also with _fraction, _passing_pct, "
		    "_retained_g, _retained_pct, _cum_retained_pct before "
		    "the @");
		return false;
	}
	c->speed = 0;
	if (at != NULL)
		return find_speed(t, text_trim(at + 1), c);
	if (c->role == FEED)
		return true;
	error_hint(
	    sheet_wanted(t->sheet, c->head, "a column with its tip speed"),
	    "write the speed in m/s behind @: %s@69", ROLES[c->role]);
	return false;
}

bool
site_column_head(struct table *t, struct column *c)
{
	char *word = text_fold(c->head.text);
	bool good = split_head(t, word, c);
	free(word);
	if (!good)
		return false;
	const struct column *twin = site_column_find(t, c->role, c->speed);
	if (twin == NULL)
		return true;
	error_hint(sheet_fault(t->sheet, c->head,
		       "%s was wanted once, found at column %d already",
		       c->head.text, twin->head.column),
	    c->speed > 0 ? "each run has a speed of its own: average the two, "
			   "or change one"
			 : "keep one of the two");
	return false;
}

static bool
is_retained(const struct column *c)
{
	enum kind kind = UNITS[c->unit].kind;
	return kind == RETAINED_G || kind == RETAINED_PCT;
}

/* "product_fraction@69": the header of c with another unit. */
static const char *
other_head(const struct column *c, const char *suffix, char buf[static 64])
{
	const char *at = strchr(c->head.text, '@');
	snprintf(
	    buf, 64, "%s%s%.30s", ROLES[c->role], suffix, at != NULL ? at : "");
	return buf;
}

static bool
in_range(struct table *t, struct column *c, struct cell cell, double v)
{
	char head[64];
	if (c->role == SD && (v > 100 || site_column_round(v, 1e12) <= 0)) {
		error_hint(sheet_wanted(t->sheet, cell,
			       "a standard deviation above 0, up to 100,"),
		    "give it in percentage points of passing");
		return false;
	}
	if (v >= 0 && v <= UNITS[c->unit].most)
		return true;
	bool percent = UNITS[c->unit].kind == FRACTION && v > 1;
	/* One percent in a column of fractions says it for all of them. */
	if (percent && c->told_percent)
		return false;
	c->told_percent = c->told_percent || percent;
	struct error *e = sheet_wanted(t->sheet, cell, UNITS[c->unit].wanted);
	if (percent)
		error_hint(e, "divide by 100 or head the column %s",
		    other_head(c, "", head));
	else
		error_hint(e, "check the number");
	return false;
}

/* The pan holds what no sieve holds; a curve of passing ends there at 0. */
static bool
read_pan(struct table *t, struct column *c, struct cell cell, double v)
{
	c->pan = v;
	bool cumulative = UNITS[c->unit].kind == CUM_RETAINED;
	if (is_retained(c))
		return in_range(t, c, cell, v);
	if (v == (cumulative ? 100 : 0))
		return true;
	error_hint(
	    sheet_wanted(t->sheet, cell,
		cumulative ? "100 % above the pan" : "nothing passing the pan"),
	    "leave the cell empty");
	return false;
}

static void
read_cells(struct table *t, struct column *c)
{
	for (size_t i = 0; i < t->n_row; i++) {
		struct cell cell = sheet_cell(&t->row[i], c->at);
		double v;
		c->pct[i] = NAN;
		if (cell.text[0] == '\0' || t->row[i].n > t->head->n)
			continue;
		bool good = sheet_number(t->sheet, cell, "a number", &v);
		if (good && t->mm[i] <= 0)
			good = read_pan(t, c, cell, v);
		else if (good && (good = in_range(t, c, cell, v)))
			c->pct[i] = v;
		c->faulty = c->faulty || !good;
	}
}

/* A column of percent without any above 1. */
static void
check_percent(struct table *t, struct column *c)
{
	char head[64];
	double most = isnan(c->pan) ? 0 : c->pan;
	for (size_t i = 0; i < t->n_row; i++)
		most = c->pct[i] > most ? c->pct[i] : most;
	bool percent = c->role != SD && UNITS[c->unit].most == 100;
	if (!percent || most <= 0 || most > 1)
		return;
	error_hint(sheet_fault(t->sheet, c->head,
		       "percent was wanted, found nothing above %g in column "
		       "%s",
		       most, c->head.text),
	    "multiply by 100 or head the column %s",
	    other_head(c, "_fraction", head));
	c->faulty = true;
}

/* What the sieves and the pan hold together: the mass in g, or 100 %.  0 after
 * a fault. */
static double
total_retained(struct table *t, struct column *c)
{
	char head[64];
	bool grams = UNITS[c->unit].kind == RETAINED_G;
	double sum = isnan(c->pan) ? 0 : c->pan;
	for (size_t i = 0; i < t->n_row; i++)
		sum += isnan(c->pct[i]) ? 0 : c->pct[i];
	if (grams && isnan(c->pan)) {
		error_hint(sheet_fault(t->sheet, c->head,
			       "the mass in the pan was wanted, found none in "
			       "column %s",
			       c->head.text),
		    "add a last row with pan and the mass below the finest "
		    "sieve, 0 if there was none");
	} else if (grams && !(sum > 0)) {
		error_hint(sheet_fault(t->sheet, c->head,
			       "a mass was wanted, found 0 g in column %s",
			       c->head.text),
		    "fill the column or take it out");
	} else if (!grams &&
		   (sum > 100 + SUM_TOLERANCE ||
		       (!isnan(c->pan) && sum < 100 - SUM_TOLERANCE))) {
		error_hint(sheet_fault(t->sheet, c->head,
			       "retained parts that sum to 100 %% were wanted, "
			       "found %g in column %s",
			       sum, c->head.text),
		    "check the numbers, or head the column %s",
		    other_head(c, "_cum_retained_pct", head));
	} else {
		return grams ? sum : 100;
	}
	return 0;
}

/* Retained on each sieve to passing: what is left below. */
static void
convert_retained(struct table *t, struct column *c)
{
	double total = c->faulty || t->lost ? 0 : total_retained(t, c);
	double left = total;
	c->faulty = total <= 0;
	for (size_t i = 0; i < t->n_row; i++) {
		if (isnan(c->pct[i]))
			continue;
		left -= c->pct[i];
		c->pct[i] = total > 0 ? 100 * fmax(left, 0) / total : NAN;
	}
}

/* To percent passing with 12 decimals, as site_write writes it. */
static void
convert(struct table *t, struct column *c)
{
	enum kind kind = UNITS[c->unit].kind;
	if (is_retained(c))
		convert_retained(t, c);
	for (size_t i = 0; i < t->n_row; i++) {
		double v = c->pct[i];
		if (kind == FRACTION)
			v *= 100;
		else if (kind == CUM_RETAINED)
			v = 100 - v;
		c->pct[i] = site_column_round(v, 1e12);
	}
}

static void
check_rise(struct table *t, struct column *c)
{
	char p[32], q[32], mm[32];
	size_t last = t->n_row;
	for (size_t i = 0; i < t->n_row; i++) {
		if (isnan(c->pct[i]) || isnan(t->mm[i]))
			continue;
		bool finer = last < t->n_row && t->mm[i] < t->mm[last];
		if (finer && c->pct[i] > c->pct[last])
			error_hint(
			    sheet_fault(t->sheet, sheet_cell(&t->row[i], c->at),
				"passing rises from %s to %s at %s mm (finer "
				"sieve, more passing): check the row",
				text_exact(c->pct[last], p),
				text_exact(c->pct[i], q),
				text_exact(t->mm[i], mm)),
			    "a finer sieve passes as much as the coarser one "
			    "or less");
		last = i;
	}
}

/* The feed's largest grains must be known: some sieve passes them all. */
static void
check_coarsest(struct table *t, struct column *c)
{
	static const double series[] = {63, 45, 31.5, 22.4, 16, 11.2, 8, 5.6, 4,
	    2, 1, .5, .25, .125, .063}; /* EN 933, mm */
	char p[32], mm[32];
	size_t i = 0, s = ARRAY_LEN(series);
	while (i < t->n_row && (isnan(c->pct[i]) || !(t->mm[i] > 0)))
		i++;
	if (i == t->n_row || c->pct[i] >= 100)
		return;
	struct error *e = sheet_fault(t->sheet, sheet_cell(&t->row[i], c->at),
	    "a coarsest feed sieve that passes 100 %% was wanted, found "
	    "%s %% at %s mm",
	    text_exact(c->pct[i], p), text_exact(t->mm[i], mm));
	while (s > 0 && series[s - 1] <= t->mm[i])
		s--;
	const char *all = is_retained(c) || UNITS[c->unit].kind == CUM_RETAINED
			      ? "0"
			  : UNITS[c->unit].kind == FRACTION ? "1"
							    : "100";
	if (s > 0)
		error_hint(e, "add %g mm with %s", series[s - 1], all);
	else
		error_hint(
		    e, "add a sieve coarser than %s mm with %s", mm, all);
}

void
site_column_values(struct table *t, struct column *c)
{
	c->pct = xdoubles(t->n_row);
	c->pan = NAN;
	read_cells(t, c);
	check_percent(t, c);
	convert(t, c);
	if (c->role != SD)
		check_rise(t, c);
	if (c->role == FEED && !c->faulty && !t->lost)
		check_coarsest(t, c);
	size_t least = c->role == FEED ? 2 : 1;
	if (c->role == SD || c->faulty || t->lost ||
	    site_column_count(t, c) >= least)
		return;
	error_hint(sheet_fault(t->sheet, c->head,
		       "%zu or more sieves were wanted, found %zu in column %s",
		       least, site_column_count(t, c), c->head.text),
	    "fill the column or take it out");
}

/* From a plan to its files.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "habits.h"

/* "No. 4", "3/8 in", "BS 7 mesh", "Tyler 8 mesh". */
static char *
sieve_name(const struct plan *plan, const struct sieve *sieve)
{
	static const char *const NUMBERS[] = {
	    "No. %s", "#%s", "No.%s", "No %s"};
	const char *name = sieve->name;
	size_t form = (size_t)plan->word;
	if (name[0] == ' ')
		return form % 3 == 0   ? xasprintf("%s\"", name + 1)
		       : form % 3 == 1 ? xasprintf("%s in", name + 1)
				       : xasprintf("%s in.", name + 1);
	if (plan->series == &SERIES_ASTM)
		switch (form % ARRAY_LEN(NUMBERS)) {
		case 0:
			return xasprintf("No. %s", name);
		case 1:
			return xasprintf("#%s", name);
		case 2:
			return xasprintf("No.%s", name);
		default:
			return xasprintf("No %s", name);
		}
	return form % 2 == 0
		   ? xasprintf("%s %s mesh", plan->series->name, name)
		   : xasprintf("%s mesh %s", name, plan->series->name);
}

/* What lies on a sieve is between it and the next coarser one. */
static char *
size_range(const struct plan *plan, const struct curve *curve, size_t i)
{
	char *low = plan_short(plan, curve->mm[i], 3), *high, *text;
	if (i == 0) {
		text = xasprintf("> %s", low);
	} else {
		high = plan_short(plan, curve->mm[i - 1], 3);
		text = plan->word % 2 == 0 ? xasprintf("%s - %s", low, high)
					   : xasprintf("%s/%s", low, high);
		free(high);
	}
	free(low);
	return text;
}

char *
size_cell(const struct plan *plan, const struct curve *curve, size_t i)
{
	double mm = curve->mm[i];
	const char *name = curve->sieve[i]->name;
	bool small = plan->sizes == SIZE_UM_BELOW_1 && mm < 1;
	char *text, *number;
	if (name != NULL && plan->sizes == SIZE_NAMES)
		return sieve_name(plan, curve->sieve[i]);
	if (name != NULL && plan->sizes == SIZE_NUMBERS && name[0] != ' ')
		return xstrdup(name);
	if (plan->sizes == SIZE_UM)
		return plan_number(plan, round(mm * 1000), 0);
	if (plan->sizes == SIZE_INCHES)
		return plan_short(plan, mm / 25.4, 4);
	if (plan->sizes == SIZE_RANGES)
		return size_range(plan, curve, i);
	if (plan->sizes == SIZE_BELOW) {
		number = plan_short(plan, mm, 3);
		text =
		    xasprintf("<%s%s", plan->word % 2 == 0 ? "" : " ", number);
		free(number);
		return text;
	}
	if (plan->sizes == SIZE_MM || plan->sizes == SIZE_BARE)
		return plan->word % 7 == 3 ? plan_number(plan, mm, 3)
					   : plan_short(plan, mm, 3);
	number = plan_short(plan, small ? mm * 1000 : mm, 3);
	text = xasprintf("%s%s%s", number, plan->word % 3 == 1 ? "" : " ",
	    !small              ? "mm"
	    : plan->micro_greek ? "\xCE\xBCm"
				: "\xC2\xB5m");
	free(number);
	return text;
}

/* i == n: the pan. */
char *
value_cell(const struct plan *plan, const struct curve *curve, size_t i)
{
	static const char *const GAPS[] = {"", "", "-", "n/a", "<"};
	bool share = curve->quantity == PASS_SHARE ||
		     curve->quantity == HELD_SHARE ||
		     curve->quantity == SUM_SHARE;
	if (i < curve->n && curve->left_out[i]) {
		char *least = plan_short(plan, 0.1, 1);
		char *text = xasprintf(
		    "%s%s", GAPS[plan->gaps], plan->gaps == 4 ? least : "");
		free(least);
		return text;
	}
	if (i == curve->n && curve->quantity <= PASS_SHARE &&
	    plan->word % 2 == 0)
		return xstrdup(plan->word % 4 == 0 ? "" : "-");
	char *number = plan_number(plan, curve->shown[i], curve->decimals);
	bool percent = plan->percent_signs && !share &&
		       curve->quantity != HELD_G && curve->quantity != SUM_G;
	bool grams = plan->gram_signs &&
		     (curve->quantity == HELD_G || curve->quantity == SUM_G);
	char *text = xasprintf("%s%s", number,
	    grams                 ? " g"
	    : !percent            ? ""
	    : plan->word % 2 == 0 ? " %"
				  : "%");
	free(number);
	return text;
}

static char *
pan_cell(const struct plan *plan, const struct curve *curve)
{
	if (plan->word % 6 < 5)
		return plan_upper(plan, plan_word(plan, plan->tongue->pan, 3));
	char *finest = plan->sizes == SIZE_RANGES
			   ? plan_short(plan, curve->mm[curve->n - 1], 3)
			   : size_cell(plan, curve, curve->n - 1);
	char *text = xasprintf("<%s", finest);
	free(finest);
	return text;
}

static bool
has_pan(const struct plan *plan, const struct curve *curve)
{
	return plan->pan || curve->quantity == HELD_G ||
	       curve->quantity == SUM_G;
}

static void
add_column(struct plan *plan, struct column_plan *column, size_t *n,
    enum column_kind kind, size_t curve)
{
	struct column_plan *c = &column[(*n)++];
	*c = (struct column_plan){.kind = kind, .curve = curve};
	if (kind != COLUMN_OTHER)
		return;
	c->other = plan->curve[curve];
	truth_show(&c->other,
	    c->other.quantity == PASS_PCT ? HELD_PCT : PASS_PCT, 1, false,
	    false);
}

/* Which curves a table has; OF_ONE and more: the one of this number. */
enum of { OF_ALL, OF_FEED, OF_PRODUCT, OF_ONE };

static bool
is_of(const struct plan *plan, size_t curve, enum of of)
{
	if (of >= OF_ONE)
		return curve == (size_t)of - OF_ONE;
	return of == OF_ALL || plan->curve[curve].feed == (of == OF_FEED);
}

/* The curves in the order of their columns; their number. */
static size_t
curve_order(const struct plan *plan, enum of of, size_t *order)
{
	size_t n = 0;
	for (size_t pass = 0; pass < 2; pass++)
		for (size_t k = 0; k < plan->n_curve; k++) {
			size_t i = plan->fast_first ? plan->n_curve - 1 - k : k;
			bool first =
			    plan->curve[i].feed != plan->products_first;
			if (first == (pass == 0) && is_of(plan, i, of))
				order[n++] = i;
		}
	return n;
}

static size_t
choose_columns(struct plan *plan, enum of of, struct column_plan *column)
{
	size_t n = 0, order[MOST_CURVES];
	size_t n_order = curve_order(plan, of, order);
	if (plan->row_numbers)
		add_column(plan, column, &n, COLUMN_NUMBER, 0);
	if (plan->lab_column)
		add_column(plan, column, &n, COLUMN_LAB, 0);
	if (!plan->size_last)
		add_column(plan, column, &n, COLUMN_SIZE, order[0]);
	if (plan->two_sizes)
		add_column(plan, column, &n, COLUMN_SIZE_MM, order[0]);
	if (plan->date_column)
		add_column(plan, column, &n, COLUMN_DATE, 0);
	for (size_t i = 0; i < n_order; i++) {
		add_column(plan, column, &n, COLUMN_CURVE, order[i]);
		if (plan->paired)
			add_column(plan, column, &n, COLUMN_OTHER, order[i]);
		if (plan->blank_column && i == 0)
			add_column(plan, column, &n, COLUMN_BLANK, 0);
	}
	if (plan->limits) {
		add_column(plan, column, &n, COLUMN_LOW, order[0]);
		add_column(plan, column, &n, COLUMN_HIGH, order[0]);
	}
	if (plan->remark_column)
		add_column(plan, column, &n, COLUMN_REMARK, 0);
	if (plan->size_last)
		add_column(plan, column, &n, COLUMN_SIZE, order[0]);
	return n;
}

/* What stands in a column beside sieve i. */
static char *
cell_of(struct plan *plan, const struct column_plan *column, size_t i,
    size_t number)
{
	const struct curve *curve = &plan->curve[column->curve];
	bool pan = i == curve->n;
	char *text, *v;
	switch (column->kind) {
	case COLUMN_NUMBER:
		return xasprintf("%zu", number);
	case COLUMN_SIZE:
		return pan ? pan_cell(plan, curve) : size_cell(plan, curve, i);
	case COLUMN_SIZE_MM:
		return pan ? NULL : plan_short(plan, curve->mm[i], 3);
	case COLUMN_CURVE:
		return value_cell(plan, curve, i);
	case COLUMN_OTHER:
		return value_cell(plan, &column->other, i);
	case COLUMN_LOW:
	case COLUMN_HIGH:
		v = plan_number(plan,
		    pan ? 0
			: fmin(100,
			      fmax(0,
				  curve->pct[i] +
				      (column->kind == COLUMN_LOW ? -5 : 12))),
		    0);
		text = pan || isnan(curve->pct[i]) ? xstrdup("") : xstrdup(v);
		free(v);
		return text;
	case COLUMN_REMARK:
		return number == 3 ? xstrdup("ok") : NULL;
	case COLUMN_DATE:
		return xstrdup("2026-05-03");
	case COLUMN_LAB:
		return xstrdup("4711");
	default:
		return NULL;
	}
}

/* The sum of what lies on the sieves and in the pan, or NULL. */
static char *
total_cell(const struct plan *plan, const struct curve *curve)
{
	if (curve->quantity < HELD_G || curve->quantity > HELD_SHARE)
		return NULL;
	double sum = 0;
	for (size_t i = 0; i <= curve->n; i++)
		sum +=
		    i < curve->n || has_pan(plan, curve) ? curve->shown[i] : 0;
	return plan_number(plan, sum, curve->decimals);
}

/* A row below the table: its name, and a number for each curve. */
static void
foot_row(struct plan *plan, const struct column_plan *column, size_t n,
    struct sheets *grid, size_t row, size_t at, const char *name,
    char *(*number)(const struct plan *, const struct curve *))
{
	for (size_t i = 0; i < n; i++) {
		const struct column_plan *c = &column[i];
		char *text = NULL;
		if (c->kind == COLUMN_SIZE)
			text = plan_upper(plan, name);
		else if (c->kind == COLUMN_CURVE)
			text = number(plan, &plan->curve[c->curve]);
		else if (c->kind == COLUMN_OTHER)
			text = number(plan, &c->other);
		if (text != NULL)
			grid_put(grid, row, at + i, text);
	}
}

static char *
dry_cell(const struct plan *plan, const struct curve *curve)
{
	return curve->quantity == HELD_G
		   ? plan_number(plan, curve->mass, curve->decimals)
		   : NULL;
}

static char *
washed_cell(const struct plan *plan, const struct curve *curve)
{
	return curve->quantity == HELD_G
		   ? plan_number(
			 plan, curve->mass - curve->washed, curve->decimals)
		   : NULL;
}

static char *
loss_cell(const struct plan *plan, const struct curve *curve)
{
	return curve->quantity == HELD_G
		   ? plan_number(plan, curve->loss, curve->decimals)
		   : NULL;
}

static char *
fineness_cell(const struct plan *plan, const struct curve *curve)
{
	return plan_number(plan, 2 + 0.013 * curve->mass / 30, 2);
}

static char *
date_cell(const struct plan *plan, const struct curve *curve)
{
	static const char *const DATES[] = {
	    "2026-05-03", "14.9.2026", "14/09/2026"};
	(void)curve;
	return xstrdup(plan_word(plan, DATES, 3));
}

/* NULL of a curve in its other quantity. */
static char *
count_cell(const struct plan *plan, const struct curve *curve)
{
	for (size_t i = 0; i < plan->n_curve; i++)
		if (&plan->curve[i] == curve)
			return xasprintf("%zu", i + 1);
	return NULL;
}

static char *
remark_cell(const struct plan *plan, const struct curve *curve)
{
	(void)plan;
	return curve->feed ? NULL : xstrdup(curve->speed < 70 ? "ok" : "wet");
}

/* Rows above the sieves: in lines of samples, columns before them. */
static size_t
rows_above(struct plan *plan, const struct column_plan *column, size_t n,
    struct sheets *grid, size_t row, size_t at)
{
	static const char *const COUNTS[] = {"No", "#", "Nr"};
	if (plan->count_row)
		foot_row(plan, column, n, grid, row++, at,
		    plan_word(plan, COUNTS, 3), count_cell);
	if (plan->date_row && plan->word % 2 == 0)
		foot_row(plan, column, n, grid, row++, at, plan->tongue->date,
		    date_cell);
	return row;
}

/* What laboratories and crews write below a table. */
static size_t
other_rows(struct plan *plan, const struct column_plan *column, size_t n,
    struct sheets *grid, size_t row, size_t at)
{
	static const char *const NAMES[] = {"P80 mm", "D50", "Moisture %",
	    "t/h", "Power kW", "% < 0.063", "Feed rate t/h", "FM"};
	row += plan->shape != SHAPE_ACROSS && plan->word % 2;
	for (size_t i = 0, most = 1 + pick(plan, 3); i < most; i++)
		foot_row(plan, column, n, grid, row++, at,
		    NAMES[pick(plan, ARRAY_LEN(NAMES))], fineness_cell);
	return row;
}

static size_t
feet(struct plan *plan, const struct column_plan *column, size_t n,
    struct sheets *grid, size_t row, size_t at)
{
	const struct tongue *t = plan->tongue;
	if (plan->total)
		foot_row(plan, column, n, grid, row++, at,
		    plan_word(plan, t->total, 3), total_cell);
	if (plan->loss || plan->washed)
		foot_row(plan, column, n, grid, row++, at, t->dry, dry_cell);
	if (plan->washed)
		foot_row(plan, column, n, grid, row++, at, t->after_wash,
		    washed_cell);
	if (plan->loss && plan->word % 2 == 0)
		foot_row(plan, column, n, grid, row++, at, t->loss, loss_cell);
	if (plan->fineness)
		foot_row(plan, column, n, grid, row++, at, t->fineness,
		    fineness_cell);
	if (plan->other_rows)
		row = other_rows(plan, column, n, grid, row, at);
	if (plan->remark_row)
		foot_row(
		    plan, column, n, grid, row++, at, t->remark, remark_cell);
	return row;
}

/* One table with its heads; the row after it. */
static size_t
table_put(
    struct plan *plan, enum of of, struct sheets *grid, size_t row, size_t at)
{
	struct column_plan column[MOST_CELLS];
	size_t n = choose_columns(plan, of, column);
	size_t order[MOST_CURVES];
	curve_order(plan, of, order);
	const struct curve *first = &plan->curve[order[0]];
	row = rows_above(plan, column, n, grid, row, at);
	if (plan->heads == HEADS_ABOVE)
		grid_put(grid, row, at, head_sample(plan, first));
	for (size_t c = 0; c < n; c++) {
		head_put(plan, &column[c], c > 0 ? &column[c - 1] : NULL, grid,
		    row, at + c);
		if (column[c].kind == COLUMN_CURVE)
			plan->curve_column[column[c].curve] = at + c + 1;
		if (column[c].kind == COLUMN_SIZE)
			plan->size_column = at + c + 1;
	}
	row += head_rows(plan);
	if (plan->date_row && plan->word % 2 == 1)
		foot_row(plan, column, n, grid, row++, at, plan->tongue->date,
		    date_cell);
	size_t rows = first->n + has_pan(plan, first);
	for (size_t k = 0; k < rows; k++, row++)
		for (size_t c = 0; c < n; c++) {
			size_t i = plan->finest_first ? rows - 1 - k : k;
			char *text = cell_of(plan, &column[c], i, k + 1);
			if (text != NULL)
				grid_put(grid, row, at + c, text);
		}
	return feet(plan, column, n, grid, row, at);
}

static size_t
key_value(struct plan *plan, struct sheets *grid, size_t row, const char *key,
    const char *value)
{
	char *word = plan_upper(plan, key);
	if (plan->word % 2 == 0) {
		grid_put(grid, row, 0, xstrdup(word));
		grid_put(grid, row, 1, xstrdup(value));
	} else {
		grid_put(grid, row, 0, xasprintf("%s: %s", word, value));
	}
	free(word);
	return row + 1;
}

/* Lines above the table; the first row after them. */
static size_t
top_lines(struct plan *plan, struct sheets *grid)
{
	const struct tongue *t = plan->tongue;
	static const char *const LINES[] = {"Norrberga Krossar AB",
	    "VSI test 2026", "Quarry: Hollow Lane", "Sieve analysis",
	    "Particle size distribution", "Weighed by: L. Holm",
	    "Machine: Barmac B7150", "Sampled 14.9.2026",
	    "EN 933-1 wet sieving", "Rock: granite, density 2.68"};
	size_t row = 0;
	for (size_t i = 0; plan->lab_lines && i < 3; i++)
		grid_put(grid, row++, 0,
		    xstrdup(LINES[pick(plan, ARRAY_LEN(LINES))]));
	if (plan->title)
		grid_put(grid, row++, 0,
		    xasprintf("%s, 3/5 2026, %s 17", t->title, t->sample));
	if (plan->title && plan->blanks)
		row++;
	if (plan->header) {
		row = key_value(plan, grid, row, t->site, "Berga");
		row = key_value(plan, grid, row, t->rock, "Granit");
		row = key_value(plan, grid, row, t->date, "2026-05-03");
	}
	if (plan->person_row)
		row = key_value(plan, grid, row, t->person, "AB");
	if (plan->speeds == SPEED_RPM) {
		char *v = plan->rotor_in_m
			      ? plan_short(plan, plan->rotor_mm / 1000, 3)
			      : plan_short(plan, plan->rotor_mm, 0);
		char *key = xasprintf(
		    "%s (%s)", t->rotor, plan->rotor_in_m ? "m" : "mm");
		row = key_value(plan, grid, row, key, v);
		free(key);
		free(v);
	}
	if (row > 0 && plan->blanks)
		row++;
	if (plan->caption)
		grid_put(grid, row++, 0, plan_quantity(plan, plan->quantity));
	return row;
}

static void
end_lines(struct plan *plan, struct sheets *grid)
{
	if (!plan->remarks)
		return;
	size_t row = grid->n_row + (plan->blanks ? 1 : 0);
	char *word = plan_upper(plan, plan->tongue->remark);
	grid_put(grid, row, 0, xasprintf("%s: EN 933-1, 105 °C, 24 h", word));
	free(word);
}

static void
copy_block(const struct sheets *from, struct sheets *to, size_t row)
{
	size_t columns = grid_columns(from);
	for (size_t r = 0; r < from->n_row; r++)
		for (size_t c = 0; c < columns; c++)
			if (from->cell[r][c] != NULL)
				grid_put(
				    to, row + r, c, xstrdup(from->cell[r][c]));
}

static void
make_wide(struct plan *plan, struct sheets *grid, size_t row)
{
	struct sheets *table = xcalloc(1, sizeof *table);
	table_put(plan, OF_ALL, table, 0, 0);
	if (plan->shape == SHAPE_ACROSS) {
		struct sheets *turned = grid_turned(table);
		copy_block(turned, grid, row);
		grid_free(turned);
		plan->size_column = 0;
	} else {
		copy_block(table, grid, row);
	}
	grid_free(table);
}

static void
make_apart(struct plan *plan, struct sheets *grid, size_t row)
{
	size_t end = table_put(plan, OF_FEED, grid, row, 0);
	if (plan->shape == SHAPE_BELOW)
		table_put(plan, OF_PRODUCT, grid, end + 1 + pick(plan, 2), 0);
	else
		table_put(plan, OF_PRODUCT, grid, row, grid_columns(grid) + 1);
	plan->size_column = 0;
}

/* A table for each sample, beside or below each other. */
static void
make_each(struct plan *plan, struct sheets *grid, size_t row)
{
	size_t order[MOST_CURVES], n = curve_order(plan, OF_ALL, order);
	size_t at = 0, gap = pick(plan, 2);
	for (size_t i = 0; i < n; i++) {
		size_t end = table_put(plan, OF_ONE + order[i], grid, row, at);
		if (plan->shape == SHAPE_EACH_BELOW)
			row = end + 1;
		else
			at = grid_columns(grid) + gap;
		plan->curve_column[order[i]] = i + 1;
	}
	plan->size_column = 0;
}

/* A sheet of a workbook for each sample, with its name, in which some signs may
 * not be. */
static void
make_sheets(struct plan *plan)
{
	enum { LONGEST = 28 };
	size_t order[MOST_CURVES], n = curve_order(plan, OF_ALL, order);
	for (size_t i = 0; i < n; i++) {
		struct sheets *grid = xcalloc(1, sizeof *grid);
		size_t row = i == 0 ? top_lines(plan, grid) : 0;
		char *title = head_sample(plan, &plan->curve[order[i]]);
		table_put(plan, OF_ONE + order[i], grid, row, 0);
		for (char *p = title; (p = strpbrk(p, "/@[]()")) != NULL;)
			*p = ' ';
		size_t cut = strlen(title);
		while (cut > LONGEST || (title[cut] & 0xC0) == 0x80)
			cut--;
		title[cut] = '\0';
		sheets_add(plan, grid, xstrdup(text_trim(title)), i > 0);
		free(title);
		plan->curve_column[order[i]] = i + 1;
	}
	plan->size_column = 0;
}

/* The order of the columns of a long table: n numbers below n, shuffled where
 * the habit says so. */
static void
shuffle(struct plan *plan, size_t n, size_t *order, bool shuffled)
{
	for (size_t i = 0; i < n; i++)
		order[i] = i;
	for (size_t i = n; shuffled && i > 1; i--) {
		size_t k = pick(plan, i), was = order[k];
		order[k] = order[i - 1];
		order[i - 1] = was;
	}
}

enum long_column { LONG_SAMPLE, LONG_RUN, LONG_SPEED, LONG_SIZE, LONG_VALUE };

static char *
long_head(const struct plan *plan, size_t column)
{
	const struct tongue *t = plan->tongue;
	const char *unit = plan->speeds == SPEED_KMH    ? "km/h"
			   : plan->speeds == SPEED_FEET ? "ft/min"
							: "m/s";
	switch (column) {
	case LONG_SAMPLE:
		return plan_upper(plan, t->sample);
	case LONG_RUN:
		return xstrdup("nr");
	case LONG_SPEED:
		return plan->speeds == SPEED_RPM
			   ? xstrdup("rpm")
			   : xasprintf("%s (%s)", t->speed, unit);
	case LONG_SIZE:
		return head_size(plan);
	default:
		return plan_quantity(plan, plan->quantity);
	}
}

static char *
long_cell(const struct plan *plan, const struct curve *c, size_t column,
    size_t run, size_t i)
{
	switch (column) {
	case LONG_SAMPLE:
		return plan_role(plan, c->feed);
	case LONG_RUN:
		return xasprintf("%zu", run);
	case LONG_SPEED:
		return c->speed > 0 ? plan_short(plan, c->as_written, 1) : NULL;
	case LONG_SIZE:
		return i < c->n ? size_cell(plan, c, i) : pan_cell(plan, c);
	default:
		return value_cell(plan, c, i);
	}
}

/* One row for each number, curve after curve, sieve after sieve, or in any
 * order. */
static void
make_long(struct plan *plan, struct sheets *grid, size_t row)
{
	size_t order[5], by[MOST_CURVES * (MOST_SIEVES + 1)], n = 0;
	size_t rows = plan->curve[0].n + has_pan(plan, &plan->curve[0]);
	size_t all = rows * plan->n_curve;
	shuffle(plan, 5, order, plan->word % 3 == 0);
	shuffle(plan, all, by, plan->word % 4 == 0);
	for (size_t k = 0; k < 5; k++)
		if (order[k] != LONG_RUN || plan->repeats)
			grid_put(grid, row, n++, long_head(plan, order[k]));
	row++;
	for (size_t r = 0; r < all; r++, row++) {
		bool by_sieve = plan->word % 4 == 1;
		size_t c = by_sieve ? by[r] % plan->n_curve : by[r] / rows;
		size_t i = by_sieve ? by[r] / plan->n_curve : by[r] % rows;
		size_t at = 0;
		for (size_t k = 0; k < 5; k++) {
			if (order[k] == LONG_RUN && !plan->repeats)
				continue;
			char *text = long_cell(
			    plan, &plan->curve[c], order[k], c + 1, i);
			if (text != NULL)
				grid_put(grid, row, at, text);
			at++;
		}
	}
	for (size_t c = 0; c < plan->n_curve; c++)
		plan->curve_column[c] = c + 1;
	plan->size_column = 0;
}

/* A row for each speed and sieve: speed, sieve, feed, product. */
static void
make_pairs(struct plan *plan, struct sheets *grid, size_t row)
{
	const struct curve *feed = &plan->curve[0];
	size_t rows = feed->n + has_pan(plan, feed), order[4];
	shuffle(plan, 4, order, plan->word % 3 == 0);
	for (size_t c = 0; c < plan->n_curve; c++) {
		const struct curve *curve = &plan->curve[c];
		plan->curve_column[c] = c + 1;
		if (curve->feed) {
			feed = curve;
			continue;
		}
		for (size_t i = 0; i < rows; i++)
			for (size_t k = 0; k < 4; k++) {
				char *cell =
				    order[k] == 0 ? long_cell(plan, curve,
							LONG_SPEED, c, i)
				    : order[k] == 1
					? long_cell(
					      plan, curve, LONG_SIZE, c, i)
					: value_cell(plan,
					      order[k] == 2 ? feed : curve, i);
				grid_put(grid, row + 1 + i, k, cell);
			}
		row += rows;
	}
	plan->size_column = 0;
}

static void
pairs_heads(struct plan *plan, struct sheets *grid, size_t row)
{
	struct draw again = plan->draw;
	size_t order[4];
	shuffle(plan, 4, order, plan->word % 3 == 0);
	plan->draw = again;
	for (size_t k = 0; k < 4; k++) {
		const struct tongue *t = plan->tongue;
		char *quantity = plan_quantity(plan, plan->quantity);
		const char *role =
		    plan_word(plan, order[k] == 2 ? t->feed : t->product, 6);
		grid_put(grid, row, k,
		    order[k] == 0   ? long_head(plan, LONG_SPEED)
		    : order[k] == 1 ? long_head(plan, LONG_SIZE)
				    : xasprintf("%s %s", role, quantity));
		free(quantity);
	}
}

/* A file for the feed, and one for each cut. */
static void
make_files(struct plan *plan)
{
	size_t cut = 0;
	for (size_t c = 0; c < plan->n_curve; c++) {
		struct curve *curve = &plan->curve[c];
		struct sheets *grid = xcalloc(1, sizeof *grid);
		size_t row = top_lines(plan, grid);
		char *speed = head_speed(plan, curve);
		char *role = plan_role(plan, curve->feed);
		if (!plan->at_files || curve->feed)
			row = key_value(
			    plan, grid, row, plan->tongue->sample, role);
		if (!plan->at_files && curve->speed > 0)
			row = key_value(
			    plan, grid, row, plan->tongue->speed, speed);
		grid_put(grid, row, 0, head_size(plan));
		grid_put(grid, row++, 1, plan_quantity(plan, curve->quantity));
		size_t rows = curve->n + has_pan(plan, curve);
		for (size_t k = 0; k < rows; k++, row++) {
			size_t i = plan->finest_first ? rows - 1 - k : k;
			grid_put(grid, row, 0,
			    i < curve->n ? size_cell(plan, curve, i)
					 : pan_cell(plan, curve));
			grid_put(grid, row, 1, value_cell(plan, curve, i));
		}
		end_lines(plan, grid);
		char name[32] = "feed.csv";
		if (!curve->feed)
			snprintf(name, sizeof name, "cut%zu.csv", ++cut);
		if (plan->at_files && !curve->feed)
			plan->file[plan->n_file].at = curve->speed;
		grid_write(plan, grid, name);
		plan->curve_column[c] = c + 1;
		free(speed);
		free(role);
	}
	plan->size_column = 0;
}

void
sheet_make(struct plan *plan)
{
	if (plan->shape == SHAPE_FILES) {
		make_files(plan);
		return;
	}
	if (plan->shape == SHAPE_EACH_SHEET) {
		make_sheets(plan);
		return;
	}
	struct sheets *grid = xcalloc(1, sizeof *grid);
	size_t row = top_lines(plan, grid);
	switch (plan->shape) {
	case SHAPE_LONG:
		make_long(plan, grid, row);
		break;
	case SHAPE_PAIRS:
		pairs_heads(plan, grid, row);
		make_pairs(plan, grid, row);
		break;
	case SHAPE_BESIDE:
	case SHAPE_BELOW:
		make_apart(plan, grid, row);
		break;
	case SHAPE_EACH_BESIDE:
	case SHAPE_EACH_BELOW:
		make_each(plan, grid, row);
		break;
	default:
		make_wide(plan, grid, row);
	}
	end_lines(plan, grid);
	grid_write(plan, grid, "sheet.csv");
}

/* Makes a long table wide: a column for each sample, a row for each sieve of
 * any of them.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/sitefile/layout_long.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "base/tr.h"
#include "base/xalloc.h"
#include "io/sitefile/column_header.h"
#include "io/cells/number.h"
#include "io/cells/source.h"
#include "io/sitefile/sieve_size.h"
#include "io/sitefile/site_day.h"
#include "io/sitefile/lexicon.h"

/* What a column of a long table is for: KEY tells samples apart and what they
 * are, COUNT tells them apart only (a sample's number). */
enum use { UNUSED, KEY, COUNT, VALUE };

/* Of the wide table, whose columns are compared each with all others. */
enum { MOST_COLUMNS = 4000 };

/* size [n_row]: index of the row's sieve among the n_size different ones, whose
 * first rows are first [n_size].  sample [n_row]: likewise of its sample, whose
 * cells have the digest mark [n_row]. */
struct longer {
	struct table *table;
	enum use *use;
	struct head *head;
	double *mm;
	uint64_t told;
	size_t *size, *first, n_size;
	size_t *sample, *lead, n_sample;
	uint64_t *mark;
};

static bool
is_numeric_column(const struct table *t, size_t c)
{
	size_t numbers = 0;
	for (size_t r = 0; r < t->n_row; r++) {
		struct cell cell = t->row[r].cell[c];
		if (cell.value == AS_ABSENT)
			continue;
		if (isnan(cell.number))
			return false;
		numbers++;
	}
	return numbers > 0;
}

static enum use
guess_column_use(const struct table *t, size_t c, const struct head *head)
{
	static const uint64_t COUNTED = WORD_PASSES | WORD_STAYS |
					WORD_PERCENT | WORD_GRAMS | WORD_MASS |
					WORD_SHARE;
	bool numeric = is_numeric_column(t, c);
	if ((head->means & (WORD_OTHER | WORD_LIMIT)) != 0)
		return UNUSED;
	if (!numeric)
		return KEY;
	bool speed = heading_has_speed(head);
	bool percent = (head->means & WORD_PERCENT) != 0;
	if (!speed && !percent &&
	    (head->unit != SPEED_NO_UNIT || (head->means & WORD_SPEED) != 0))
		return KEY;
	bool other = (head->means & (WORD_SAMPLE | WORD_SPEED)) != 0 &&
		     (head->means & (COUNTED & ~WORD_PERCENT)) == 0;
	if (other)
		return COUNT; /* a number of the sample, or per cent of speed */
	return VALUE;
}

/* A row with what it is sorted by. */
struct ranked {
	double by;
	size_t row;
};

/* Orders the largest first and, among equals, the upper row. */
static int
compare_largest_first(const void *a, const void *b)
{
	const struct ranked *x = a, *y = b;
	if (x->by != y->by)
		return x->by > y->by ? -1 : 1;
	return (x->row > y->row) - (x->row < y->row);
}

/* Indices of the different sizes, coarsest first. */
static void
list_distinct_sizes(struct longer *l)
{
	const struct table *t = l->table;
	struct sieve_unit unit =
	    sieve_unit_from_words(l->told != 0 ? l->told : l->head[0].means);
	/* Of which series they are shows later; here they only differ. */
	if (unit.series == SIEVE_MESH)
		unit = (struct sieve_unit){1, SIEVE_NONE};
	FREED struct ranked *ranked = xcalloc(t->n_row, sizeof *ranked);
	size_t n = 0;
	for (size_t r = 0; r < t->n_row; r++) {
		enum sieve_kind kind = sieve_read_size(
		    t->sheet, t->row[r].cell[0], unit, &l->mm[r]);
		if (kind == SIEVE_IS_PAN)
			l->mm[r] = 0;
		if (!isnan(l->mm[r]))
			ranked[n++] = (struct ranked){l->mm[r], r};
	}
	qsort(ranked, n, sizeof *ranked, compare_largest_first);
	for (size_t i = 0; i < n; i++) {
		if (i == 0 || ranked[i].by != ranked[i - 1].by)
			l->first[l->n_size++] = ranked[i].row;
		l->size[ranked[i].row] = l->n_size - 1;
	}
}

static bool
is_row_of_same_sample(const struct longer *l, size_t a, size_t b)
{
	const struct table *t = l->table;
	for (size_t c = 1; c < t->n_col; c++)
		if ((l->use[c] == KEY || l->use[c] == COUNT) &&
		    strcmp(t->row[a].cell[c].text, t->row[b].cell[c].text) != 0)
			return false;
	return true;
}

/* Returns a digest of the cells that identify the sample of row r. */
static uint64_t
hash_of_sample_cells(const struct longer *l, size_t r)
{
	uint64_t mark = TEXT_DIGEST_START;
	for (size_t c = 1; c < l->table->n_col; c++) {
		const char *text = l->table->row[r].cell[c].text;
		if (l->use[c] == KEY || l->use[c] == COUNT)
			mark = text_fnv1a_digest(mark, text, strlen(text) + 1);
	}
	return mark;
}

/* Finds the different samples by the digests of their rows, in a hash table. */
static void
list_distinct_samples(struct longer *l)
{
	size_t n = l->table->n_row, room = 2 * n + 1;
	FREED size_t *known =
	    xcalloc(room, sizeof *known); /* samples from 1; 0: no */
	for (size_t r = 0; r < n; r++) {
		l->mark[r] = hash_of_sample_cells(l, r);
		size_t at = (size_t)(l->mark[r] % room);
		for (; known[at] != 0; at = (at + 1) % room) {
			size_t lead = l->lead[known[at] - 1];
			if (l->mark[lead] == l->mark[r] &&
			    is_row_of_same_sample(l, lead, r))
				break;
		}
		if (known[at] == 0) {
			l->lead[l->n_sample++] = r;
			known[at] = l->n_sample;
		}
		l->sample[r] = known[at] - 1;
	}
}

/* True if sample a comes after b by their numbers: [n], NAN if a sample has
 * none. */
static bool
is_later_sample(const double *a, const double *b, size_t n)
{
	for (size_t i = 0; i < n; i++)
		if (!isnan(a[i]) && !isnan(b[i]))
			return a[i] > b[i];
	return false;
}

/* Returns the numbers of all samples [n_sample][n], and n. */
static double *
numbers_of_all_samples(const struct longer *l, size_t *n)
{
	const struct table *t = l->table;
	*n = 0;
	for (size_t c = 1; c < t->n_col; c++)
		*n += l->use[c] == COUNT;
	double *number = xcalloc_doubles(l->n_sample * *n), *to = number;
	for (size_t s = 0; s < l->n_sample; s++)
		for (size_t c = 1; c < t->n_col; c++) {
			struct cell cell = t->row[l->lead[s]].cell[c];
			if (l->use[c] != COUNT)
				continue;
			*to++ =
			    cell.value == AS_NUMBER ? cell.number : (double)NAN;
		}
	return number;
}

/* Sorts the samples by their numbers. */
static void
sort_samples_by_number(struct longer *l)
{
	size_t n, n_sample = l->n_sample;
	FREED double *number = numbers_of_all_samples(l, &n);
	FREED size_t *order = xcalloc(n_sample, sizeof *order);
	FREED size_t *place = xcalloc(n_sample, sizeof *place);
	size_t *lead = xcalloc(n_sample, sizeof *lead);
	for (size_t i = 0; i < n_sample; i++) {
		size_t k = i;
		for (; k > 0 && is_later_sample(&number[order[k - 1] * n],
				    &number[i * n], n);
		     k--)
			order[k] = order[k - 1];
		order[k] = i;
	}
	for (size_t i = 0; i < n_sample; i++) {
		place[order[i]] = i;
		lead[i] = l->lead[order[i]];
	}
	for (size_t r = 0; r < l->table->n_row; r++)
		l->sample[r] = place[l->sample[r]];
	free(l->lead);
	l->lead = lead;
}

/* True if each sample has each of its sieves once, and some sieves occur for
 * several samples. */
static bool
is_long_table(const struct longer *l)
{
	size_t n = l->table->n_row;
	bool good = true, values = false;
	for (size_t c = 1; c < l->table->n_col; c++)
		values = values || l->use[c] == VALUE;
	if (!values || l->n_sample < 2 || 2 * n < 3 * l->n_size)
		return false;
	FREED struct ranked *ranked = xcalloc(n, sizeof *ranked);
	for (size_t r = 0; r < n && good; r++) {
		good = !isnan(l->mm[r]);
		/* Exact: both are below the number of rows. */
		ranked[r].by = (double)l->sample[r] * (double)l->n_size +
			       (double)l->size[r];
	}
	qsort(ranked, n, sizeof *ranked, compare_largest_first);
	for (size_t i = 1; i < n && good; i++)
		good = ranked[i].by != ranked[i - 1].by;
	return good;
}

static const char *
speed_unit_text(enum speed_unit unit)
{
	static const char *const TEXTS[] = {[SPEED_NO_UNIT] = "",
	    [SPEED_MPS] = "m/s",
	    [SPEED_KMH] = "km/h",
	    [SPEED_FT_MIN] = "ft/min",
	    [SPEED_FT_S] = "ft/s",
	    [SPEED_RPM] = "rpm"};
	return TEXTS[unit];
}

/* Returns the heading of a sample's column: "Product 69 m/s Passing %". */
static char *
sample_heading(const struct longer *l, size_t sample, size_t value)
{
	const struct table *t = l->table;
	char *text = xstrdup("");
	for (size_t c = 1; c < t->n_col; c++) {
		struct cell cell = t->row[l->lead[sample]].cell[c];
		double v;
		if (l->use[c] != KEY || cell.value == AS_ABSENT)
			continue;
		bool number = number_value_of_cell(cell, &v);
		enum speed_unit unit = heading_speed_unit(&l->head[c]);
		if (number && v == 0)
			continue;
		if (number && unit == SPEED_NO_UNIT &&
		    (l->head[c].means & WORD_SPEED) != 0)
			xappend_to_list(&text, " ", tr("speed %s"), cell.text);
		else
			xappend_to_list(&text, " ", "%s %s", cell.text,
			    number ? speed_unit_text(unit) : "");
	}
	FREED char *own = layout_heading_text(t, value);
	xappend_to_list(&text, " ", "%s", own);
	return text;
}

/* Returns the name of a sample: all cells that identify it. */
static char *
sample_name(const struct longer *l, size_t sample)
{
	char *text = xstrdup("");
	for (size_t c = 1; c < l->table->n_col; c++) {
		struct cell cell = l->table->row[l->lead[sample]].cell[c];
		if ((l->use[c] == KEY || l->use[c] == COUNT) &&
		    cell.value != AS_ABSENT)
			xappend_to_list(&text, " ", "%s", cell.text);
	}
	return text;
}

/* Returns an empty row of n cells at the position of another. */
static struct row
new_empty_row(size_t n, const struct row *from)
{
	struct row row = {.n = n,
	    .n_all = n,
	    .cell = xcalloc(n, sizeof(struct cell)),
	    .line = from->line};
	for (size_t c = 0; c < n; c++)
		row.cell[c] = row_cell_at(from, from->n_all);
	row.cell[0] = from->cell[0];
	return row;
}

/* True if the wide table has room for all samples; otherwise false with a
 * fault. */
static bool
has_room_for_samples(const struct longer *l)
{
	const struct table *t = l->table;
	size_t values = 0, most = SOURCE_MOST_CELLS / l->n_size;
	for (size_t c = 1; c < t->n_col; c++)
		values += l->use[c] == VALUE;
	most = (most < MOST_COLUMNS ? most : MOST_COLUMNS) / values;
	return l->n_sample <= most ||
	       sheet_fault(t->sheet, t->row[0].cell[0],
		   "expected a long table of at most %zu samples, got %zu with "
		   "%zu columns of numbers each\n"
		   "divide it, or read a part of it: load %s range=A1:F500",
		   most, l->n_sample, values, t->sheet->path);
}

/* True if all rows of a sample have the same in column c. */
static bool
is_same_in_all_rows(const struct longer *l, size_t sample, size_t c)
{
	const struct row *row = l->table->row;
	const char *text = row[l->lead[sample]].cell[c].text;
	for (size_t r = 0; r < l->table->n_row; r++)
		if (l->sample[r] == sample &&
		    strcmp(row[r].cell[c].text, text) != 0)
			return false;
	return true;
}

/* Writes the headings, names and days of all samples.  days: the column with
 * them, or 0. */
static void
write_sample_headings(const struct longer *l, struct table *wide, size_t days)
{
	const struct table *t = l->table;
	size_t at = 1;
	for (size_t s = 0; s < l->n_sample; s++) {
		char *name = layout_adopt_text(wide, sample_name(l, s));
		const struct cell *lead = t->row[l->lead[s]].cell;
		bool day = days > 0 && is_same_in_all_rows(l, s, days);
		for (size_t c = 1; c < t->n_col; c++) {
			if (l->use[c] != VALUE)
				continue;
			char *text =
			    layout_adopt_text(wide, sample_heading(l, s, c));
			wide->head[0].cell[at] =
			    number_cell_from_text(t->sheet, lead[c], text);
			if (day)
				wide->day[at] = lead[days].text;
			wide->name[at] = name;
			wide->number[at++] = t->number[c];
		}
	}
}

/* Replaces the long table with a wide one. */
static void
widen_table(struct longer *l)
{
	struct table *t = l->table, wide = *t;
	size_t values = 0;
	for (size_t c = 1; c < t->n_col; c++)
		values += l->use[c] == VALUE;
	wide.n_col = 1 + values * l->n_sample;
	wide.n_head = 1;
	wide.titles = 0;
	wide.n_row = l->n_size;
	wide.head = xcalloc(1, sizeof *wide.head);
	wide.row = xcalloc(wide.n_row, sizeof *wide.row);
	wide.number = xcalloc(wide.n_col, sizeof *wide.number);
	wide.name = xcalloc(wide.n_col, sizeof(*wide.name));
	wide.day = xcalloc(wide.n_col, sizeof(*wide.day));
	const struct row *above =
	    t->n_head > 0 ? &t->head[t->n_head - 1] : &t->row[0];
	wide.head[0] = new_empty_row(wide.n_col, above);
	for (size_t i = 0; i < wide.n_row; i++)
		wide.row[i] = new_empty_row(wide.n_col, &t->row[l->first[i]]);
	char *size = layout_heading_text(t, 0);
	wide.head[0].cell[0].text = layout_adopt_text(&wide, size);
	wide.number[0] = t->number[0];
	wide.name[0] = size;
	write_sample_headings(l, &wide, site_day_column(t));
	for (size_t r = 0; r < t->n_row; r++) {
		struct cell *to =
		    &wide.row[l->size[r]].cell[1 + values * l->sample[r]];
		for (size_t c = 1; c < t->n_col; c++)
			if (l->use[c] == VALUE)
				*to++ = t->row[r].cell[c];
	}
	struct table old = *t;
	wide.foot = NULL; /* sums of all samples together say nothing */
	wide.n_foot = 0;
	*t = wide;
	old.title = NULL;
	old.text = NULL;
	old.n_text = 0;
	layout_table_clear(&old);
}

/* If nothing else identifies the samples, a column headed "ID" or with dates
 * may: the first such column that makes the table a long one does. */
static bool
is_long_by_id_or_date(struct longer *l)
{
	const struct table *t = l->table;
	bool repeats = 2 * t->n_row >= 3 * l->n_size, found = false;
	for (size_t c = 1; c < t->n_col && repeats && !found; c++) {
		if (l->use[c] != UNUSED)
			continue;
		l->use[c] = is_numeric_column(t, c) ? COUNT : KEY;
		l->n_sample = 0;
		list_distinct_samples(l);
		found = 2 * l->n_sample <= t->n_row && is_long_table(l);
		l->use[c] = found ? l->use[c] : UNUSED;
	}
	return found;
}

bool
layout_long_to_wide(struct table *t, uint64_t told)
{
	size_t n = t->n_row;
	bool good = true;
	struct longer l = {.table = t, .told = told};
	l.use = xcalloc(t->n_col, sizeof *l.use);
	l.head = xcalloc(t->n_col, sizeof *l.head);
	l.mm = xcalloc_doubles(n);
	l.size = xcalloc(n, sizeof *l.size);
	l.first = xcalloc(n, sizeof *l.first);
	l.sample = xcalloc(n, sizeof *l.sample);
	l.lead = xcalloc(n, sizeof *l.lead);
	l.mark = xcalloc(n, sizeof *l.mark);
	for (size_t c = 0; c < t->n_col && !error_should_stop(t->sheet->errors);
	     c++) {
		FREED char *text = layout_heading_text(t, c);
		l.head[c] = heading_parse(text);
		l.use[c] = c > 0 ? guess_column_use(t, c, &l.head[c]) : UNUSED;
	}
	list_distinct_sizes(&l);
	list_distinct_samples(&l);
	if ((is_long_table(&l) || is_long_by_id_or_date(&l)) &&
	    (good = has_room_for_samples(&l))) {
		sort_samples_by_number(&l);
		widen_table(&l);
	}
	free(l.use);
	free(l.head);
	free(l.mm);
	free(l.size);
	free(l.first);
	free(l.sample);
	free(l.lead);
	free(l.mark);
	return good;
}

/* Makes a long table wide: a column for each sample, and a row for each sieve
 * that any sample has.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/sitefile/layout_long.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/tr.h"
#include "base/xalloc.h"
#include "io/sitefile/column_header.h"
#include "io/cells/number.h"
#include "io/cells/source.h"
#include "io/sitefile/sieve_size.h"
#include "io/sitefile/site_day.h"
#include "io/sitefile/lexicon.h"

/* What a column of a long table is used for.  KEY: its cells tell samples apart
 * and describe them; COUNT: they only tell samples apart, as numbers do; VALUE:
 * they are the measured numbers. */
enum use { UNUSED, KEY, COUNT, VALUE };

/* Words of headings above measured numbers. */
static const uint64_t COUNTED = WORD_PASSES | WORD_STAYS | WORD_PERCENT |
				WORD_GRAMS | WORD_MASS | WORD_SHARE;

/* A row of the long table.  mm: its sieve; size: the index of that sieve among
 * the different ones; lead: the first row of its sample; column: in such a
 * first row, the column of the sample in the wide table. */
struct entry {
	double mm;
	size_t size, lead, column;
};

/* A long table.  use, head [n_col]: the use and heading of each column, n_value
 * of which are VALUE.  entry [n_row].  n_size: the number of different sieves.
 * sample [n_sample]: the first row of each sample. */
struct longer {
	struct table *table;
	enum use *use;
	struct head *head;
	struct entry *entry;
	size_t n_size, *sample, n_sample, n_value;
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
	if ((head->means & (WORD_OTHER | WORD_LIMIT)) != 0)
		return UNUSED;
	if (!is_numeric_column(t, c))
		return KEY;
	if (!heading_has_speed(head) && (head->means & WORD_PERCENT) == 0 &&
	    (head->unit != SPEED_NO_UNIT || (head->means & WORD_SPEED) != 0))
		return KEY;
	/* the number of a sample, or per cent of full speed */
	bool other = (head->means & (WORD_SAMPLE | WORD_SPEED)) != 0 &&
		     (head->means & (COUNTED & ~WORD_PERCENT)) == 0;
	return other ? COUNT : VALUE;
}

static bool
is_sample_id_column(const struct longer *l, size_t c)
{
	return l->use[c] == KEY || l->use[c] == COUNT;
}

/* A row, and what it is sorted by: a number or a text. */
struct ranked {
	double by;
	char *key;
	size_t row;
};

/* Orders the largest number first, then texts by their bytes, then rows from
 * the top. */
static int
compare_ranked_rows(const void *a, const void *b)
{
	const struct ranked *x = a, *y = b;
	if (x->by != y->by)
		return x->by > y->by ? -1 : 1;
	int order = x->key != NULL ? strcmp(x->key, y->key) : 0;
	return order != 0 ? order : (x->row > y->row) - (x->row < y->row);
}

/* Numbers the different sizes, coarsest first. */
static void
assign_size_numbers(struct longer *l, uint64_t told)
{
	const struct table *t = l->table;
	struct sieve_unit unit =
	    sieve_unit_from_words(told != 0 ? told : l->head[0].means);
	/* The series of mesh numbers is not needed here, only which differ. */
	if (unit.series == SIEVE_MESH)
		unit = (struct sieve_unit){1, SIEVE_NONE};
	FREED struct ranked *ranked = xcalloc(t->n_row, sizeof *ranked);
	size_t n = 0;
	for (size_t r = 0; r < t->n_row; r++) {
		double *mm = &l->entry[r].mm;
		if (sieve_read_size(t->sheet, t->row[r].cell[0], unit, mm) ==
		    SIEVE_IS_PAN)
			*mm = 0;
		if (!isnan(*mm))
			ranked[n++] = (struct ranked){.by = *mm, .row = r};
	}
	qsort(ranked, n, sizeof *ranked, compare_ranked_rows);
	for (size_t i = 0; i < n; i++) {
		l->n_size += i == 0 || ranked[i].by != ranked[i - 1].by;
		l->entry[ranked[i].row].size = l->n_size - 1;
	}
}

/* Returns all rows, each with the cells that identify its sample, sorted by
 * these.  The caller frees the rows and their keys. */
static struct ranked *
list_rows_sorted_by_sample(const struct longer *l)
{
	const struct table *t = l->table;
	struct ranked *ranked = xcalloc(t->n_row, sizeof *ranked);
	for (size_t r = 0; r < t->n_row; r++) {
		ranked[r] = (struct ranked){.key = xstrdup(""), .row = r};
		for (size_t c = 1; c < t->n_col; c++)
			if (is_sample_id_column(l, c))
				xappend(&ranked[r].key, "%s\n",
				    t->row[r].cell[c].text);
	}
	qsort(ranked, t->n_row, sizeof *ranked, compare_ranked_rows);
	return ranked;
}

/* Finds the samples.  Returns true if the table is a long one: there are
 * several samples, none has a sieve twice, and some sieves occur for several
 * samples. */
static bool
find_samples_of_long_table(struct longer *l)
{
	size_t n = l->table->n_row, lead = 0;
	FREED struct ranked *ranked = list_rows_sorted_by_sample(l);
	/* For each sieve, 1 + the first row of the last sample that has it. */
	FREED size_t *had = xcalloc(l->n_size + 1, sizeof *had);
	bool once = true;
	for (size_t i = 0; i < n; i++) {
		struct entry *e = &l->entry[ranked[i].row];
		if (i == 0 || strcmp(ranked[i].key, ranked[i - 1].key) != 0)
			lead = ranked[i].row;
		e->lead = lead;
		once = once && !isnan(e->mm) && had[e->size] != lead + 1;
		had[e->size] = lead + 1;
	}
	l->n_sample = 0;
	for (size_t r = 0; r < n; r++) {
		if (l->entry[r].lead == r)
			l->sample[l->n_sample++] = r;
		free(ranked[r].key);
	}
	return once && l->n_value > 0 && l->n_sample > 1 &&
	       2 * n >= 3 * l->n_size;
}

/* True if the sample with first row a has a higher number than that with first
 * row b. */
static bool
is_sample_number_higher(const struct longer *l, size_t a, size_t b)
{
	const struct row *row = l->table->row;
	for (size_t c = 1; c < l->table->n_col; c++) {
		struct cell x = row[a].cell[c], y = row[b].cell[c];
		if (l->use[c] == COUNT && x.value == AS_NUMBER &&
		    y.value == AS_NUMBER)
			return x.number > y.number;
	}
	return false;
}

static void
sort_samples_by_number(struct longer *l)
{
	for (size_t i = 0; i < l->n_sample; i++) {
		size_t own = l->sample[i], k = i;
		for (;
		     k > 0 && is_sample_number_higher(l, l->sample[k - 1], own);
		     k--)
			l->sample[k] = l->sample[k - 1];
		l->sample[k] = own;
	}
	for (size_t i = 0; i < l->n_sample; i++)
		l->entry[l->sample[i]].column = 1 + i * l->n_value;
}

/* True if a column has rpm of a motor or the like, beside one of m/s. */
static bool
has_rpm_of_other_part(const struct longer *l, size_t c)
{
	size_t k = 1;
	while (k < l->table->n_col && l->head[k].unit != SPEED_MPS)
		k++;
	return k < l->table->n_col && heading_is_of_other_part(&l->head[c]) &&
	       heading_speed_unit(&l->head[c]) == SPEED_RPM;
}

/* Returns the heading of a column of the wide table: "Product 69 m/s Passing
 * %".  lead: the first row of its sample; value: the column of its numbers in
 * the long table. */
static char *
wide_table_heading(const struct longer *l, size_t lead, size_t value)
{
	static const char *const UNITS[] = {[SPEED_NO_UNIT] = "",
	    [SPEED_MPS] = "m/s",
	    [SPEED_KMH] = "km/h",
	    [SPEED_FT_MIN] = "ft/min",
	    [SPEED_FT_S] = "ft/s",
	    [SPEED_RPM] = "rpm"};
	const struct table *t = l->table;
	char *text = xstrdup("");
	for (size_t c = 1; c < t->n_col; c++) {
		struct cell cell = t->row[lead].cell[c];
		double v;
		if (l->use[c] != KEY || cell.value == AS_ABSENT ||
		    has_rpm_of_other_part(l, c))
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
			    number ? UNITS[unit] : "");
	}
	FREED char *own = layout_column_heading_text(t, value);
	xappend_to_list(&text, " ", "%s", own);
	return text;
}

/* Returns the name of the sample with first row `lead`: all cells that identify
 * it. */
static char *
long_table_sample_name(const struct longer *l, size_t lead)
{
	char *text = xstrdup("");
	for (size_t c = 1; c < l->table->n_col; c++) {
		struct cell cell = l->table->row[lead].cell[c];
		if (is_sample_id_column(l, c) && cell.value != AS_ABSENT)
			xappend_to_list(&text, " ", "%s", cell.text);
	}
	return text;
}

/* Returns an empty row of n cells with the line and first cell of another
 * row. */
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

/* Returns true if the wide table has room for all samples, else false with a
 * fault. */
static bool
has_table_room_for_samples(const struct longer *l)
{
	const struct table *t = l->table;
	size_t most = SOURCE_MOST_CELLS / l->n_size;
	if (most > SOURCE_MOST_COLUMNS)
		most = SOURCE_MOST_COLUMNS;
	most /= l->n_value;
	return l->n_sample <= most ||
	       sheet_report_fault(t->sheet, t->row[0].cell[0],
		   "expected a long table of at most %zu samples, got %zu with "
		   "%zu columns of numbers each\n"
		   "divide it, or read a part of it: load %s range=A1:F500",
		   most, l->n_sample, l->n_value, t->sheet->path);
}

/* Returns the day of a sample if all of its rows have the same text in column
 * c, else NULL. */
static char *
day_shared_by_rows_of_sample(const struct longer *l, size_t lead, size_t c)
{
	const struct row *row = l->table->row;
	char *text = row[lead].cell[c].text;
	for (size_t r = 0; r < l->table->n_row; r++)
		if (l->entry[r].lead == lead &&
		    strcmp(row[r].cell[c].text, text) != 0)
			return NULL;
	return text;
}

/* Writes the headings, names and days of all samples. */
static void
set_wide_table_headings(const struct longer *l, struct table *wide)
{
	const struct table *t = l->table;
	size_t at = 1, days = site_day_column(t);
	for (size_t s = 0; s < l->n_sample; s++) {
		size_t lead = l->sample[s];
		char *name =
		    layout_adopt_text(wide, long_table_sample_name(l, lead));
		char *day = days > 0
				? day_shared_by_rows_of_sample(l, lead, days)
				: NULL;
		for (size_t c = 1; c < t->n_col; c++) {
			if (l->use[c] != VALUE)
				continue;
			char *text = layout_adopt_text(
			    wide, wide_table_heading(l, lead, c));
			wide->head[0].cell[at] = number_reparse_cell_with_text(
			    t->sheet, t->row[lead].cell[c], text);
			wide->day[at] = day;
			wide->name[at] = name;
			wide->number[at++] = t->number[c];
		}
	}
}

/* True if the cells of a column name each sample's site or machine, and not the
 * sample itself. */
static bool
is_column_of_sites(const struct longer *l, size_t c)
{
	const struct table *t = l->table;
	FREED char *text = layout_column_heading_text(t, c);
	bool names = lexicon_is_label_of_sites(text);
	for (size_t r = 0; r < t->n_row && names; r++) {
		struct head cell = heading_parse(t->row[r].cell[c].text);
		names = !heading_has_speed(&cell) &&
			(cell.means & (WORD_FEED | WORD_PRODUCT)) == 0;
	}
	return names;
}

/* Takes numbers of sites or machines, beside a column of measured numbers, for
 * what tells samples apart. */
static void
recognise_numbers_of_sites(struct longer *l)
{
	bool measured = false;
	for (size_t c = 1; c < l->table->n_col; c++)
		measured = measured || (l->use[c] == VALUE &&
					   (l->head[c].means & COUNTED) != 0);
	for (size_t c = 1; measured && c < l->table->n_col; c++)
		if (l->use[c] == VALUE && is_column_of_sites(l, c)) {
			l->use[c] = COUNT;
			l->n_value--;
		}
}

static void
set_wide_table_sites(const struct longer *l, struct table *wide)
{
	const struct table *t = l->table;
	wide->site = xcalloc(t->n_col, sizeof *wide->site);
	for (size_t c = 1; c < t->n_col; c++) {
		if (!is_sample_id_column(l, c) || !is_column_of_sites(l, c))
			continue;
		struct row *site = &wide->site[wide->n_site++];
		*site = new_empty_row(wide->n_col, &wide->head[0]);
		for (size_t i = 0; i + 1 < wide->n_col; i++)
			site->cell[i + 1] =
			    t->row[l->sample[i / l->n_value]].cell[c];
	}
}

/* Replaces the long table with a wide one. */
static void
replace_by_wide_table(struct longer *l)
{
	struct table *t = l->table, old = *t, wide = *t;
	wide.n_col = 1 + l->n_value * l->n_sample;
	wide.n_head = 1;
	wide.titles = 0;
	wide.n_row = l->n_size;
	wide.head = xcalloc(1, sizeof *wide.head);
	wide.row = xcalloc(wide.n_row, sizeof *wide.row);
	wide.number = xcalloc(wide.n_col, sizeof *wide.number);
	wide.name = xcalloc(wide.n_col, sizeof(*wide.name));
	wide.day = xcalloc(wide.n_col, sizeof(*wide.day));
	wide.head[0] = new_empty_row(
	    wide.n_col, t->n_head > 0 ? &t->head[t->n_head - 1] : &t->row[0]);
	char *size = layout_column_heading_text(t, 0);
	wide.head[0].cell[0].text = layout_adopt_text(&wide, size);
	wide.number[0] = t->number[0];
	wide.name[0] = size;
	set_wide_table_headings(l, &wide);
	set_wide_table_sites(l, &wide);
	for (size_t r = 0; r < t->n_row; r++) {
		const struct entry *e = &l->entry[r];
		struct row *row = &wide.row[e->size];
		if (row->cell == NULL)
			*row = new_empty_row(wide.n_col, &t->row[r]);
		struct cell *to = &row->cell[l->entry[e->lead].column];
		for (size_t c = 1; c < t->n_col; c++)
			if (l->use[c] == VALUE)
				*to++ = t->row[r].cell[c];
	}
	wide.foot = NULL; /* sums over several samples mean nothing */
	wide.n_foot = 0;
	*t = wide;
	old.title = NULL;
	old.text = NULL;
	old.n_text = 0;
	layout_table_clear(&old);
}

/* Looks for a column headed "ID", or with dates, that identifies the samples,
 * if nothing else does.  The first that makes the table a long one is used. */
static bool
find_id_or_date_column(struct longer *l)
{
	const struct table *t = l->table;
	bool found = false;
	for (size_t c = 1; c < t->n_col && !found; c++) {
		if (l->use[c] != UNUSED)
			continue;
		l->use[c] = is_numeric_column(t, c) ? COUNT : KEY;
		found = find_samples_of_long_table(l) &&
			2 * l->n_sample <= t->n_row;
		l->use[c] = found ? l->use[c] : UNUSED;
	}
	return found;
}

/* Gives the day in a column of days, if all rows have the same, to all samples
 * of a table that has a column for each of them. */
static void
set_day_of_all_samples(struct table *t)
{
	size_t days = site_day_column(t);
	char *day = days > 0 ? t->row[0].cell[days].text : NULL;
	for (size_t r = 0; r < t->n_row && day != NULL; r++)
		if (strcmp(t->row[r].cell[days].text, day) != 0)
			day = NULL;
	if (day == NULL || t->day != NULL)
		return;
	t->day = xcalloc(t->n_col, sizeof(*t->day));
	for (size_t c = 1; c < t->n_col; c++)
		t->day[c] = day;
}

bool
layout_long_to_wide(struct table *t, uint64_t told)
{
	bool good = true;
	FREED enum use *use = xcalloc(t->n_col, sizeof *use);
	FREED struct head *head = xcalloc(t->n_col, sizeof *head);
	FREED struct entry *entry = xcalloc(t->n_row, sizeof *entry);
	FREED size_t *sample = xcalloc(t->n_row, sizeof *sample);
	struct longer l = {.table = t,
	    .use = use,
	    .head = head,
	    .entry = entry,
	    .sample = sample};
	for (size_t c = 0;
	     c < t->n_col && !error_is_stop_requested(t->sheet->errors); c++) {
		FREED char *text = layout_column_heading_text(t, c);
		head[c] = heading_parse(text);
		use[c] = c > 0 ? guess_column_use(t, c, &head[c]) : UNUSED;
		l.n_value += use[c] == VALUE;
	}
	recognise_numbers_of_sites(&l);
	assign_size_numbers(&l, told);
	if ((find_samples_of_long_table(&l) || find_id_or_date_column(&l)) &&
	    (good = has_table_room_for_samples(&l))) {
		sort_samples_by_number(&l);
		replace_by_wide_table(&l);
	} else {
		set_day_of_all_samples(t);
	}
	return good;
}

/* From a sheet of cells to a site: heading, sieves, runs.  Cells and their
 * places come from sheet, columns and their units from site_column.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/site_read.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "base/text.h"
#include "base/xalloc.h"
#include "io/sieve_names.h"
#include "io/site_column.h"
#include "io/site_sieve.h"
#include "io/source.h"

static void
read_top_size(struct site *site, struct sheet *sheet, struct cell cell)
{
	double mm = site_sieve_mm(sheet, cell, 1, "a positive size in mm");
	if (mm <= 0)
		sheet_wanted(sheet, cell, "a positive size in mm",
		    "write the size, or remove the line");
	site->top_size = mm / 1000;
}

static const char *const KEYS[] = {
    "site", "rock", "machine", "provenance", "top_size_mm"};
enum { TOP_SIZE = 4, N_KEY = 5 };

static void
take_value(struct site *site, size_t key, struct sheet *sheet, struct cell cell)
{
	char **text[TOP_SIZE] = {
	    &site->name, &site->rock, &site->machine, &site->provenance};
	if (key == TOP_SIZE) {
		read_top_size(site, sheet, cell);
		return;
	}
	free(*text[key]);
	*text[key] = xstrdup(cell.text);
}

/* "rock Granite" without a separator. */
static bool
begins_with_key(const char *text)
{
	for (size_t k = 0; k < N_KEY; k++)
		if (strncasecmp(text, KEYS[k], strlen(KEYS[k])) == 0)
			return true;
	return false;
}

/* A title in one cell is a key without a value.  seen: line of each known key,
 * 0 before it is met. */
static void
read_heading_line(struct site *site, struct sheet *sheet, const struct row *row,
    int seen[static N_KEY])
{
	struct cell key = row->cell[0], value = sheet_cell(row, 1);
	size_t k = 0;
	while (k < N_KEY && !text_same(key.text, KEYS[k]))
		k++;
	if (key.text[0] == '\0' ||
	    (row->n_all < 2 && begins_with_key(key.text))) {
		sheet_wanted(sheet, key, "a key and a value",
		    "write key%cvalue, or begin a remark with #%s",
		    sheet->separator,
		    row->n > 2 ? "; put all column headings on one line" : "");
	} else if (row->n > 2) {
		sheet_wanted(sheet, row->cell[2],
		    "the end of the line after key and value",
		    "quote a value that contains the separator, or begin a "
		    "remark with #; with decimal commas, separate the cells "
		    "with ;");
	} else if (k < N_KEY && seen[k] > 0) {
		sheet_fault(sheet, key,
		    "duplicate key: %s is already in line %d\n"
		    "remove one of the two lines",
		    KEYS[k], seen[k]);
	} else if (k < N_KEY) {
		take_value(site, k, sheet, value);
	} else {
		site_add_note(&site->note, &site->n_note, key.text, value.text);
	}
	if (k < N_KEY)
		seen[k] = row->line;
}

/* File name without folder and extension.  A name that is not UTF-8, or has
 * control characters in it, could not be written into a sheet again. */
static char *
name_from(const char *path)
{
	const char *slash = strrchr(path, '/');
	const char *name = slash != NULL ? slash + 1 : path;
	const char *dot = strrchr(name, '.');
	bool extension = dot != NULL && dot > name;
	size_t n = extension ? (size_t)(dot - name) : strlen(name);
	bool good = text_is_utf8(name, n);
	char *copy = xstrndup(name, n);
	for (char *p = copy; *p != '\0'; p++) {
		unsigned char c = (unsigned char)*p;
		if (c < 0x20 || c == 0x7F || (c >= 0x80 && !good))
			*p = '_';
	}
	return copy;
}

static void
read_heading(struct site *site, struct sheet *sheet, size_t n_line)
{
	int seen[N_KEY] = {0};
	for (size_t i = 0; i < n_line; i++)
		read_heading_line(site, sheet, &sheet->row[i], seen);
	if (site->name[0] == '\0') {
		free(site->name);
		site->name = name_from(sheet->path);
	}
}

/* Heads of columns, in words of their own: three cells or more, no number in
 * the first two. */
static bool
is_heads(const struct row *row)
{
	double v;
	return row->n > 2 && !text_number(row->cell[0].text, &v) &&
	       !text_number(row->cell[1].text, &v);
}

/* Without a first line of the table nothing else can be judged.  The place
 * told is the first line that looks like the table. */
static void
tell_no_table(struct sheet *sheet)
{
	struct row none = {.line = 1, .end = 1};
	struct cell found =
	    sheet->n_row > 0 ? sheet->row[0].cell[0] : sheet_cell(&none, 0);
	for (size_t i = sheet->n_row; i-- > 0;) {
		struct cell cell = sheet->row[i].cell[0];
		double v;
		if (sheet_value(sheet, cell, &v) ||
		    strncasecmp(cell.text, "size", 4) == 0 ||
		    is_heads(&sheet->row[i]))
			found = cell;
	}
	char c = sheet->separator;
	if (site_sieve_word(found.text))
		sheet_wanted(sheet, found, "a line that begins with size_mm",
		    "add the unit of the sizes: %s mm", found.text);
	else
		sheet_wanted(sheet, found, "a line that begins with size_mm",
		    "begin the table with "
		    "size_mm%cfeed%cproduct@69%cproduct@79, then one line for "
		    "each sieve",
		    c, c, c);
}

static bool
is_empty_column(const struct table *t, size_t at)
{
	bool empty = t->head->cell[at].text[0] == '\0';
	for (size_t i = 0; empty && i < t->n_row; i++)
		empty = sheet_cell(&t->row[i], at).text[0] == '\0';
	return empty;
}

static void
read_heads(struct table *t)
{
	t->column = xcalloc(t->head->n, sizeof *t->column);
	for (size_t at = 1; at < t->head->n; at++) {
		struct column c = {.head = t->head->cell[at], .at = at};
		if (is_empty_column(t, at))
			continue;
		if (site_column_head(t, &c))
			t->column[t->n_column++] = c;
		else
			t->lost = true;
	}
}

static size_t
count_role(const struct table *t, enum role role)
{
	size_t n = 0;
	for (size_t i = 0; i < t->n_column; i++)
		n += t->column[i].role == role;
	return n;
}

/* Of repeats at one speed, one feed serves all, or each product has its own;
 * likewise standard deviations. */
static void
check_repeats(struct table *t, const struct column *c)
{
	size_t own = site_column_repeats(t, c->role, c->speed);
	size_t products = site_column_repeats(t, PRODUCT, c->speed);
	if (c->role == PRODUCT || c->nth != 1 || own == products)
		return;
	sheet_fault(t->sheet, c->head,
	    "duplicate column: expected one %s@%g%s, got %zu\n"
	    "keep one for all products at this speed, or one for each in their "
	    "order",
	    SITE_ROLES[c->role], c->speed,
	    products > 1 ? " or one for each product" : "", own);
}

/* A feed for each product, a product for each standard deviation. */
static void
check_partner(struct table *t, const struct column *c)
{
	const struct column *shared = site_column_find(t, FEED, 0, 0);
	bool alone = site_column_repeats(t, PRODUCT, c->speed) == 0;
	check_repeats(t, c);
	if (c->role == FEED && c->speed > 0 && shared != NULL)
		sheet_fault(t->sheet, c->head,
		    "expected one kind of feed, got feed and %s\n"
		    "use one feed for all runs, or feed@SPEED for each run",
		    c->head.text);
	if (c->role == SD && alone)
		sheet_fault(t->sheet, c->head,
		    "expected a product for %s, got none\n"
		    "add its product column, or remove this one",
		    c->head.text);
	if (c->role == PRODUCT && shared == NULL && count_role(t, FEED) > 0 &&
	    site_column_repeats(t, FEED, c->speed) == 0)
		sheet_fault(t->sheet, c->head,
		    "expected a feed for %s, got none\n"
		    "add a feed@ column with this speed",
		    c->head.text);
}

/* Each product value needs a standard deviation, and the other way round. */
static void
check_sd(struct table *t, const struct column *product)
{
	const struct column *sd =
	    site_column_find(t, SD, product->speed, product->nth);
	for (size_t i = 0; i < t->n_row && sd != NULL; i++) {
		struct cell a = sheet_cell(&t->row[i], product->at);
		struct cell b = sheet_cell(&t->row[i], sd->at);
		bool has = a.text[0] != '\0', has_sd = b.text[0] != '\0';
		if (has == has_sd || !(t->mm[i] > 0))
			continue;
		sheet_wanted(t->sheet, b,
		    has ? "a standard deviation"
			: "no standard deviation without a product",
		    "%s",
		    has ? "fill it, or remove the column"
			: "leave both cells empty where the sieve was not "
			  "used");
	}
}

static void
read_columns(struct table *t)
{
	size_t speeds = 0;
	for (size_t i = 0; i < t->n_column; i++) {
		struct column *c = &t->column[i];
		site_column_values(t, c);
		if (c->role == PRODUCT)
			check_sd(t, c);
		if (!t->lost)
			check_partner(t, c);
		speeds += c->role == PRODUCT && c->nth == 0;
	}
	struct cell head = t->head->cell[0];
	if (!t->lost && count_role(t, FEED) == 0)
		sheet_fault(t->sheet, head,
		    "expected a feed column, got none\n"
		    "add a column feed, or feed@SPEED for each run");
	/* A feed without any product will do for a guess. */
	if (!t->lost && speeds == 1)
		sheet_fault(t->sheet, head,
		    "expected products at two or more speeds, got 1\n"
		    "add columns such as product@69 and product@79");
}

static void
read_table(struct table *t, size_t head)
{
	t->head = &t->sheet->row[head];
	site_sieve_numbers(t->sheet, t->head);
	t->row = t->head + 1;
	t->n_row = t->sheet->n_row - head - 1;
	read_heads(t);
	site_sieve_rows(t);
	if (t->n_row > 0)
		read_columns(t);
	else if (!t->lost)
		sheet_fault(t->sheet, t->head->cell[0],
		    "expected a row for each sieve below this line, got none\n"
		    "add rows such as 22.4,100,100,100");
}

static struct psd
make_psd(const struct table *t, const struct column *c)
{
	struct psd psd = psd_new(site_column_count(t, c));
	size_t n = 0;
	for (size_t i = 0; i < t->n_row; i++) {
		if (!(t->mm[i] > 0) || isnan(c->pct[i]))
			continue;
		psd.size[n] = t->mm[i] / 1000;
		psd.passing[n++] = c->pct[i] / 100;
	}
	return psd;
}

/* nth: of the runs at its speed. */
static void
fill_run(const struct table *t, const struct column *shared, struct run *run,
    size_t nth)
{
	double v = run->speed;
	const struct column *own = site_column_find(t, FEED, v, nth);
	const struct column *product = site_column_find(t, PRODUCT, v, nth);
	const struct column *sd = site_column_find(t, SD, v, nth);
	if (site_column_repeats(t, PRODUCT, v) > 1)
		snprintf(run->repeat, sizeof run->repeat, " (%u)",
		    (unsigned)nth + 1);
	run->feed = make_psd(t, shared != NULL ? shared : own);
	if (product != NULL)
		run->product = make_psd(t, product);
	if (sd == NULL)
		return;
	struct psd deviation = make_psd(t, sd);
	run->product_sd = deviation.passing;
	free(deviation.size);
}

static int
by_speed(const void *a, const void *b)
{
	const struct run *r = a, *s = b;
	return (r->speed > s->speed) - (r->speed < s->speed);
}

/* A run for each product, and for each speed with no more than a feed of its
 * own; where there is only the feed of all runs, one run without a speed. */
static void
make_runs(struct site *site, const struct table *t)
{
	const struct column *shared = site_column_find(t, FEED, 0, 0);
	site->individual_feeds = shared == NULL;
	site->run = xrealloc(site->run, t->n_column, sizeof *site->run);
	for (size_t i = 0; i < t->n_column; i++) {
		const struct column *c = &t->column[i];
		size_t n = site_column_repeats(t, PRODUCT, c->speed);
		if (c->role == SD || !(c->speed > 0) ||
		    site_run_at(site, c->speed) < site->n_run)
			continue;
		for (size_t k = 0; k == 0 || k < n; k++)
			site->run[site->n_run++] =
			    (struct run){.speed = c->speed};
	}
	if (site->n_run == 0)
		site->run[site->n_run++] = (struct run){.speed = 0};
	qsort(site->run, site->n_run, sizeof *site->run, by_speed);
	for (size_t r = 0, first = 0; r < site->n_run; r++) {
		first = site_run_repeats(site, r) ? first : r;
		fill_run(t, shared, &site->run[r], r - first);
	}
	site->digest = site_digest(site);
}

static void
table_clear(struct table *t)
{
	for (size_t i = 0; i < t->n_column; i++)
		free(t->column[i].pct);
	free(t->column);
	free(t->mm);
}

static void __attribute__((format(printf, 3, 4)))
leave_out(struct site *site, const char *where, const char *format, ...)
{
	va_list ap;
	va_start(ap, format);
	char *what = xvasprintf(format, ap);
	va_end(ap);
	site_add_note(&site->left_out, &site->n_left_out, where, what);
	free(what);
}

static void
leave_out_row(struct site *site, const struct table *t, size_t i, bool compared)
{
	const struct row *row = &t->row[i];
	const char *text = row->cell[0].text;
	char *where = xasprintf("line %d", row->line);
	bool values = false;
	for (size_t c = 0; c < t->n_column && i < t->n_row; c++)
		values = values || !isnan(t->column[c].pct[i]);
	if (i < t->n_row && t->mm[i] > 0 && !values)
		leave_out(site, where, "the sieve %s has no numbers", text);
	else if (i >= t->n_row && row != t->total)
		leave_out(site, where, "remark below the table: %.*s",
		    sheet_cut(text), text);
	else if (i >= t->n_row && !compared)
		leave_out(
		    site, where, "%s: sums are checked for grams only", text);
	free(where);
}

/* What stands in the table or below it and was not read.  A line that begins
 * with # may be a sieve that somebody thought away. */
static void
tell_left_out(struct site *site, const struct table *t)
{
	bool grams = false;
	char where[32];
	for (size_t c = 0; c < t->n_column; c++)
		grams =
		    grams || SITE_UNITS[t->column[c].unit].kind == RETAINED_G;
	for (size_t i = 0; i < t->sheet->n_comment; i++) {
		const struct comment *c = &t->sheet->comment[i];
		if (c->line <= t->head->line)
			continue;
		snprintf(where, sizeof where, "line %d", c->line);
		int shown = sheet_cut(c->text);
		leave_out(site, where, "a comment: %.*s%s", shown, c->text,
		    c->text[shown] != '\0' ? "..." : "");
	}
	for (const struct row *row = t->row;
	     row < t->sheet->row + t->sheet->n_row; row++)
		leave_out_row(site, t, (size_t)(row - t->row), grams);
	for (size_t at = 1; at < t->head->n; at++) {
		snprintf(where, sizeof where, "column %zu", at + 1);
		if (t->head->cell[at].text[0] == '\0')
			leave_out(site, where, "it is empty");
	}
}

/* "#4 = 4.75, No. 8 = 2.36" of the sieves that have names. */
static void
tell_names(struct site *site, const struct table *t)
{
	for (size_t i = 0; i < t->n_row; i++) {
		const char *text = t->row[i].cell[0].text;
		if (sieve_names_mm(text) > 0)
			xlist(&site->named, ", ", "%s = %g", text, t->mm[i]);
	}
}

static struct site *
read_sheet(const char *path, struct sheet *sheet)
{
	struct table t = {.sheet = sheet, .lost = sheet->lost};
	struct site *site = site_new(0);
	size_t head = 0;
	while (head < sheet->n_row && site_sieve_unit(&sheet->row[head]) <= 0)
		head++;
	if (head < sheet->n_row) {
		read_heading(site, sheet, head);
		read_table(&t, head);
	} else if (!sheet->lost) {
		tell_no_table(sheet);
	}
	if (sheet->n_fault == 0) {
		free(site->path);
		site->path = xstrdup(path);
		make_runs(site, &t);
		tell_left_out(site, &t);
		tell_names(site, &t);
	} else {
		site_free(site);
		site = NULL;
	}
	table_clear(&t);
	return site;
}

struct site *
site_read(const char *path, struct error_list *errors)
{
	struct source source;
	struct site *site = NULL;
	if (source_read(path, errors, &source))
		site = read_sheet(path, source.sheet[0]);
	source_free(&source);
	return site;
}

/* Reads the sheets of one site, or of its samples: sheets come from source.c,
 * tables from layout.c, the meaning of columns from classify.c.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/sitefile/site_read.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "base/tr.h"
#include "base/xalloc.h"
#include "core/psd/rotor_speed.h"
#include "io/sitefile/layout_long.h"
#include "io/sitefile/classify.h"
#include "io/sitefile/column_header.h"
#include "io/sitefile/results.h"
#include "io/sitefile/rotor_size.h"
#include "io/sitefile/site_ask.h"
#include "io/sitefile/site_column.h"
#include "io/sitefile/site_day.h"
#include "io/sitefile/site_describe.h"
#include "io/sitefile/site_heading.h"
#include "io/sitefile/site_samples.h"
#include "io/sitefile/site_sieve.h"
#include "io/sitefile/site_title.h"
#include "io/cells/source.h"
#include "io/sitefile/lexicon.h"
#include "io/cells/number.h"

/* One sheet of one file, with what was found on it. */
struct page {
	size_t file;
	struct sheet *sheet;
	struct layout *layout;
};

/* A site being read.  table [n_table]: the tables of all layouts; all: their
 * columns.  lost: there is a fault, so it cannot be said what is missing.
 * other_site: the sheets name several sites, rocks or machines. */
struct reading {
	const struct site_request *request;
	struct error_list *errors;
	struct site *site;
	struct samples columns, samples;
	struct layout_range range;
	size_t n_source, n_page, n_table;
	struct source *source;
	struct page *page;
	struct table **table;
	struct columns all;
	struct open open;
	bool lost, other_site;
};

/* Returns the rotor's diameter, m, or 0: the sheet's or, for cuts, that of
 * their site. */
static double
rotor_of_reading(const struct reading *r)
{
	return r->site->rotor > 0 ? r->site->rotor : r->request->site_rotor;
}

/* Reports that there is no table.  Without one, nothing else can be checked. */
static void
report_missing_table(struct sheet *sheet)
{
	struct row none = {.line = 1, .end = 1};
	struct cell found =
	    sheet->n_row > 0 ? sheet->row[0].cell[0] : row_cell_at(&none, 0);
	for (size_t i = sheet->n_row;
	     i-- > 0 && !error_is_stop_requested(sheet->errors);) {
		struct cell cell = sheet->row[i].cell[0];
		double v;
		if (number_value_of_cell(cell, &v) ||
		    (lexicon_text_meanings(cell.text, NULL) & WORD_SIZE) != 0)
			found = cell;
	}
	char c = sheet->separator == ';' ? ';' : ',';
	bool heads =
	    (lexicon_text_meanings(found.text, NULL) & WORD_SIZE) != 0 &&
	    found.line == sheet->row[sheet->n_row - 1].line;
	if (heads) {
		sheet_report_expected(sheet, found,
		    "a row for each sieve below this line",
		    "add rows such as 22.4%c100%c100%c100", c, c, c);
		return;
	}
	sheet_report_expected(sheet, found, "a table of sieves",
	    "begin it with a line of headings, "
	    "size_mm%cfeed%cproduct@69%cproduct@79, then one line for each "
	    "sieve; or see: template",
	    c, c, c);
}

/* Checks repeats at one speed: either one feed serves all of them, or each has
 * its own.  The same goes for standard deviations. */
static void
check_feeds_match_repeats(const struct columns *t, const struct column *c)
{
	if (!(c->speed > 0))
		return;
	size_t own = site_column_count_at_speed(t, c->role, c->speed);
	size_t products = site_column_count_at_speed(t, PRODUCT, c->speed);
	if (c->role == PRODUCT || c->nth != 1 || own == products)
		return;
	sheet_report_fault(c->table->sheet, c->head,
	    products > 1
		? N_("duplicate column: expected one %s@%g or one for each "
		     "product, got %zu\nkeep one for all products at this "
		     "speed, or one for each in the same order")
		: N_("duplicate column: expected one %s@%g, got %zu\nkeep one "
		     "for all products at this speed, or one for each in the "
		     "same order"),
	    SITE_ROLES[c->role], c->speed, own);
}

/* Checks that a product has a feed, and a standard deviation a product; and
 * that there is not one feed too many. */
static void
check_column_has_feed_or_product(const struct columns *t,
    const struct column *c, const struct site_request *request)
{
	const struct column *shared = site_column_find(t, FEED, 0, 0);
	bool alone = site_column_count_at_speed(t, PRODUCT, c->speed) == 0;
	check_feeds_match_repeats(t, c);
	if (c->role == FEED && !(c->speed > 0) && c->nth == 1)
		site_ask_refuse_second_feed(c, t, request);
	if (c->role == FEED && c->speed > 0 && shared != NULL)
		sheet_report_fault(c->table->sheet, c->head,
		    "expected one kind of feed, got feed and %s\n"
		    "use one feed for all runs, or feed@SPEED for each run",
		    c->head.text);
	if (c->role == SD && alone)
		sheet_report_fault(c->table->sheet, c->head,
		    "expected a product for %s, got none\n"
		    "add its product column, or remove this one",
		    c->head.text);
	if (c->role == PRODUCT && shared == NULL &&
	    site_column_count_by_role(t, NULL, FEED) > 0 &&
	    site_column_count_at_speed(t, FEED, c->speed) == 0)
		sheet_report_fault(c->table->sheet, c->head,
		    "expected a feed for %s, got none\n"
		    "add a feed with this speed or, if one feed serves all "
		    "products, write no speed above it",
		    c->head.text);
}

/* Checks that a product and its standard deviation, unless that is empty, have
 * values in the same rows. */
static void
check_sd_beside_values(const struct columns *all, const struct column *product)
{
	const struct table *t = product->table;
	const struct column *sd =
	    site_column_find(all, SD, product->speed, product->nth);
	if (sd == NULL || sd->table != t || site_column_count_values(sd) == 0)
		return;
	for (size_t i = 0; i < t->n_row; i++) {
		struct cell a = t->row[i].cell[product->at];
		struct cell b = t->row[i].cell[sd->at];
		bool has = a.text[0] != '\0', has_sd = b.text[0] != '\0';
		if (has == has_sd || !(t->mm[i] > 0))
			continue;
		sheet_report_expected(t->sheet, b,
		    has ? N_("a standard deviation")
			: N_("no standard deviation without a product"),
		    "%s",
		    has ? tr("fill it, or remove the column")
			: tr("leave both cells empty where the sieve was not "
			     "used"));
	}
}

/* Checks that two quantities of the same sample agree, but for rounding and
 * losses in sieving. */
static void
check_sample_columns_agree(const struct columns *all, const struct column *twin)
{
	const double far = 1.5;
	const struct table *t = twin->table;
	char one[32], other[32];
	for (size_t k = 0; k < all->n; k++) {
		const struct column *c = &all->column[k];
		if (c->table != t || t->number[c->at] != twin->twin)
			continue;
		for (size_t i = 0; i < t->n_row; i++) {
			if (!(fabs(c->pct[i] - twin->pct[i]) > far))
				continue;
			sheet_report_fault(t->sheet, t->row[i].cell[twin->at],
			    "expected the same sample as column %zu, got %s %% "
			    "passing and %s %%\nsay which to read: load FILE "
			    "columns=\"1=sieve mm, 2=feed, ..\"",
			    twin->twin,
			    text_number_distinct_from(
				c->pct[i], twin->pct[i], one),
			    text_number_distinct_from(
				twin->pct[i], c->pct[i], other));
			return;
		}
	}
}

/* Reports a missing feed, product or number. */
static void
report_missing_columns(struct reading *r)
{
	bool parts = r->request->parts;
	const struct row *top = &r->table[0]->row[0];
	struct cell sieves = site_sieve_heading_cell(r->table[0]);
	if (r->all.n == 0)
		sheet_report_fault(r->table[0]->sheet,
		    top->n_all > 1 ? top->cell[1] : sieves,
		    "expected numbers below the headings, got none\nfill in "
		    "the columns from this cell on; leave a cell empty only "
		    "where a sieve was not used");
	else if (site_column_count_by_role(&r->all, NULL, FEED) == 0 && !parts)
		sheet_report_fault(r->table[0]->sheet, sieves,
		    "expected a feed column, got none\n"
		    "add a column feed, or load the feed's file with it: load "
		    "feed.csv %s@SPEED",
		    r->request->path[0]);
	else if (site_column_count_by_role(&r->all, NULL, PRODUCT) == 0 &&
		 parts)
		sheet_report_fault(r->table[0]->sheet, sieves,
		    "expected a product, got a feed only\n"
		    "add takes samples of product; load this file as a site");
}

/* Of the feeds whose coarsest sieve does not pass everything, returns the one
 * with the largest such sieve, or NULL. */
static const struct column *
feed_with_unknown_top_size(const struct columns *all)
{
	const struct column *found = NULL;
	for (size_t i = 0; i < all->n; i++) {
		const struct column *c = &all->column[i];
		if (c->below > 0 &&
		    (found == NULL || c->table->mm[c->below - 1] >
					  found->table->mm[found->below - 1]))
			found = c;
	}
	return found;
}

/* Sets the size that all of a feed passes, if that is not its coarsest sieve:
 * what the user gave; or the next sieve up, if almost nothing is coarser.
 * Otherwise asks for it. */
static void
set_or_ask_top_size(struct reading *r, struct site_ask *ask)
{
	const struct column *c = feed_with_unknown_top_size(&r->all);
	double top = round_to_step(r->request->top, 1e9);
	char p[32], mm[32];
	if (c == NULL)
		return;
	if (!(top > 0))
		top = site_ask_find_known_top_size(c);
	if (!(top > 0)) {
		site_ask_top_size(c, r->request, ask);
		return;
	}
	const struct table *t = c->table;
	size_t at = c->below - 1;
	if (top <= t->mm[at]) {
		sheet_report_fault(t->sheet, t->row[at].cell[0],
		    "expected top= above the coarsest sieve, %g mm, got "
		    "%g\nname a size that all of it passes, such as the next: "
		    "top=%g",
		    t->mm[at], top, sieve_next_coarser(t->mm[at], false));
		return;
	}
	for (size_t i = 0; i < r->all.n; i++)
		if (r->all.column[i].below > 0)
			r->all.column[i].top = top;
	xappend_to_list(&r->site->assumed, "; ",
	    tr("all of the feed passes %s mm (%s %% passes its coarsest sieve, "
	       "%g mm)"),
	    text_shortest_exact_number(top, mm),
	    site_column_passing_text(c, at, 100, p), t->mm[at]);
	site_notes_append(
	    &r->site->note, &r->site->n_note, SITE_ASSUMED_TOP, mm);
}

/* Reports a sample whose speeds in m/s and in rpm belong to another rotor than
 * the one stated, or than those of `first`, by more than what is rounded off,
 * as 0.85 m to 0.9; returns the first sample that states both. */
static const struct column *
check_rpm_agree_with_speed(
    const struct column *c, const struct column *first, double rotor)
{
	const double ROUNDED_OFF = 0.05, OF_ROTOR = 0.08;
	const struct head *a = first != NULL ? &first->said : &c->said;
	double v = c->said.speed, rpm = c->said.rpm;
	if (!(v > 0) || !(rpm > 0))
		return first;
	double own = rotor_speed_from_rpm(rpm, rotor);
	if (fabs(v / rpm * a->rpm / a->speed - 1) > ROUNDED_OFF)
		sheet_report_fault(c->table->sheet, c->head,
		    "expected m/s and rpm of one rotor, got %g m/s at %g rpm "
		    "and %g m/s at %g rpm\n"
		    "correct the wrong number, or leave out the rpm",
		    a->speed, a->rpm, v, rpm);
	else if (first == NULL && own > 0 && fabs(v / own - 1) > OF_ROTOR)
		sheet_report_fault(c->table->sheet, c->head,
		    "expected m/s and rpm of the rotor of %g mm, which has %g "
		    "m/s at %g rpm, got %g m/s\n"
		    "correct the wrong number, or leave out the rpm or the "
		    "rotor",
		    1000 * rotor, own, rpm, v);
	return first != NULL ? first : c;
}

static void
read_and_check_sheet_columns(struct reading *r)
{
	struct columns *all = &r->all;
	const struct column *first = NULL;
	for (size_t i = 0; i < all->n && !error_is_stop_requested(r->errors);
	     i++) {
		struct column *c = &all->column[i];
		first =
		    check_rpm_agree_with_speed(c, first, rotor_of_reading(r));
		site_column_read_values(c);
		r->lost = r->lost || c->table->lost;
	}
	for (size_t i = 0; i < all->n && !error_is_stop_requested(r->errors);
	     i++) {
		if (all->column[i].twin > 0)
			check_sample_columns_agree(all, &all->column[i]);
		if (all->column[i].role == PRODUCT)
			check_sd_beside_values(all, &all->column[i]);
		if (!r->lost)
			check_column_has_feed_or_product(
			    all, &all->column[i], r->request);
	}
	if (!r->lost && !error_is_stop_requested(r->errors))
		report_missing_columns(r);
}

static struct psd
psd_of_column(const struct column *c)
{
	const struct table *t = c->table;
	struct psd psd = psd_new(site_column_count_values(c) + (c->top > 0));
	size_t n = 0;
	if (c->top > 0) {
		psd.size[n] = c->top / 1000;
		psd.passing[n++] = 1;
	}
	for (size_t i = 0; i < t->n_row; i++) {
		if (!(t->mm[i] > 0) || isnan(c->pct[i]))
			continue;
		psd.size[n] = t->mm[i] / 1000;
		psd.passing[n++] = c->pct[i] / 100;
	}
	return psd;
}

/* Fills the curves of a run, which is the nth at its speed. */
static void
set_curves_of_run_from_sheet(const struct columns *t,
    const struct column *shared, struct run *run, size_t nth)
{
	double v = run->speed;
	const struct column *own = site_column_find(t, FEED, v, nth);
	const struct column *product = site_column_find(t, PRODUCT, v, nth);
	const struct column *sd = site_column_find(t, SD, v, nth);
	if (site_column_count_at_speed(t, PRODUCT, v) > 1)
		snprintf(run->repeat, sizeof run->repeat, " (%u)",
		    (unsigned)nth + 1);
	if (shared != NULL || own != NULL)
		run->feed = psd_of_column(shared != NULL ? shared : own);
	if (product != NULL) {
		run->product = psd_of_column(product);
		run->place = (size_t)(product - t->column);
	}
	if (sd == NULL || site_column_count_values(sd) == 0)
		return;
	struct psd deviation = psd_of_column(sd);
	run->product_sd = deviation.passing;
	free(deviation.size);
}

static int
compare_runs_by_speed(const void *a, const void *b)
{
	const struct run *r = a, *s = b;
	return (r->speed > s->speed) - (r->speed < s->speed);
}

/* Reads the line, written by site_write, that lists the runs without a feed
 * sample of their own, and drops it from the notes.  Their columns have the
 * mean feed, for readers that do not know the line. */
static void
parse_note_of_feedless_runs(struct site *site)
{
	const struct site_note *note = site->note;
	size_t i = 0;
	char speed[32];
	while (i < site->n_note &&
	       strcmp(note[i].key, SITE_CUTS_WITHOUT_FEED) != 0)
		i++;
	if (i == site->n_note)
		return;
	FREED char *list = xasprintf(", %s, ", note[i].value);
	for (size_t r = 0; r < site->n_run; r++) {
		struct run *run = &site->run[r];
		text_shortest_exact_number(run->speed, speed);
		FREED char *item = xasprintf(", %s%s, ", speed, run->repeat);
		run->lacks_feed = strstr(list, item) != NULL;
	}
	site_drop_note(site, i);
}

/* Makes a run for each product, and for each speed that has only a feed.  If
 * there is nothing but a feed for all runs, makes one run without a speed. */
static void
make_runs_of_site(struct site *site, const struct columns *t)
{
	const struct column *shared = site_column_find(t, FEED, 0, 0);
	site->individual_feeds = shared == NULL;
	site->run = xrealloc(site->run, t->n, sizeof *site->run);
	for (size_t i = 0; i < t->n; i++) {
		const struct column *c = &t->column[i];
		size_t n = site_column_count_at_speed(t, PRODUCT, c->speed);
		if (c->role == SD || !(c->speed > 0) ||
		    site_run_at_speed(site, c->speed) < site->n_run)
			continue;
		for (size_t k = 0; k == 0 || k < n; k++)
			site->run[site->n_run++] =
			    (struct run){.speed = c->speed};
	}
	if (site->n_run == 0)
		site->run[site->n_run++] = (struct run){.speed = 0};
	qsort(site->run, site->n_run, sizeof *site->run, compare_runs_by_speed);
	for (size_t r = 0, first = 0; r < site->n_run; r++) {
		first = site_run_repeats_speed(site, r) ? first : r;
		set_curves_of_run_from_sheet(
		    t, shared, &site->run[r], r - first);
	}
	parse_note_of_feedless_runs(site);
	site_update_digest_and_mean_feed(site);
}

/* Notes the sieves without numbers as left out. */
static void
note_sieves_without_numbers(struct reading *r, const struct table *t)
{
	for (size_t i = 0; i < t->n_row; i++) {
		bool values = !(t->mm[i] > 0);
		for (size_t c = 0; c < r->all.n && !values; c++)
			values = r->all.column[c].table == t &&
				 !isnan(r->all.column[c].pct[i]);
		if (!values)
			site_heading_leave_out(r->site, t->row[i].line,
			    "the sieve %s has no numbers",
			    t->row[i].cell[0].text);
	}
}

/* Notes the cells of samples that say that a number is missing, "-" or "<0.1",
 * as left out. */
static void
note_left_out_cells(struct reading *r)
{
	size_t more = 0;
	FREED char *list = xstrdup("");
	for (size_t k = 0; k < r->all.n; k++) {
		const struct column *c = &r->all.column[k];
		for (size_t i = 0; i < c->table->n_row; i++) {
			const char *text = c->table->row[i].cell[c->at].text;
			bool read = !isnan(c->pct[i]) || c->table->mm[i] <= 0;
			if (text[0] == '\0' || read || c->twin > 0)
				continue;
			if (more++ < 3)
				xappend_to_list(&list, ", ",
				    tr("'%.*s' in line %d"),
				    sheet_truncated_text_length(text), text,
				    c->table->row[i].line);
		}
	}
	if (more > 3)
		xappend_to_list(&list, ", ", tr("%zu more"), more - 3);
	if (more > 0)
		site_notes_append(&r->site->left_out, &r->site->n_left_out,
		    tr("cells without a number"), list);
}

/* Notes lines of totals as left out if no column is in grams, as only masses
 * are compared with them. */
static void
note_left_out_sums(struct reading *r, const struct page *page)
{
	bool grams = false;
	for (size_t c = 0; c < r->all.n; c++)
		grams =
		    grams || SITE_UNITS[r->all.column[c].unit].scale == OF_MASS;
	for (size_t b = 0; b < page->layout->n && !grams; b++)
		for (size_t i = 0; i < page->layout->table[b].n_foot; i++) {
			const struct row *row = &page->layout->table[b].foot[i];
			const char *text = row->cell[0].text;
			if ((lexicon_text_meanings(text, NULL) & WORD_TOTAL) !=
			    0)
				site_heading_leave_out(r->site, row->line,
				    "%s: sums are checked for grams only",
				    text);
		}
}

/* Returns the filled cells of a line as one text: "Date 2026-11-12". */
static char *
join_cells_of_line(const struct row *row)
{
	char *words = xstrdup("");
	for (size_t c = 0; c < row->n; c++)
		if (row->cell[c].text[0] != '\0')
			xappend_to_list(&words, " ", "%s", row->cell[c].text);
	return words;
}

/* Appends the words of the nth of several lines; only the first few are
 * shown. */
static void
append_line_to_short_list(char **list, const struct row *row, size_t n)
{
	enum { FEW = 4 };
	FREED char *words = join_cells_of_line(row);
	int shown = sheet_truncated_text_length(words);
	if (n < FEW)
		xappend_to_list(list, ", ", "%.*s%s", shown, words,
		    words[shown] != '\0' ? "..." : "");
	else if (n == FEW)
		xappend(list, ", ...");
}

/* Returns the last table that ends above a line, or NULL. */
static const struct table *
last_table_above_row(const struct layout *layout, const struct row *row)
{
	const struct table *found = NULL;
	for (size_t b = 0; b < layout->n; b++) {
		const struct table *t = &layout->table[b];
		if (t->row[t->n_row - 1].line < row->line)
			found = t;
	}
	return found;
}

/* True if line i outside the tables has been read: it is above the first row of
 * the first table, or is the title of a table, the day of a cut, or the rotor's
 * diameter. */
static bool
is_line_already_read(
    const struct reading *r, const struct layout *layout, size_t i)
{
	const struct row *row = layout->heading[i];
	FREED char *words = join_cells_of_line(row);
	bool cut = r->request->parts &&
		   title_find_table_below_line(layout, row) != NULL;
	FREED char *day = cut ? site_heading_date_of_line(row) : NULL;
	double mm = rotor_diameter_mm_in_text(words, false);
	return day != NULL || row->line <= layout->table[0].row[0].line ||
	       (mm > 0 && fabs(mm - 1000 * r->site->rotor) < 0.5) ||
	       layout->read[i];
}

/* Notes lines that were not read, from the ith on, together with the table
 * above or below which they stand.  Returns the number of lines. */
static size_t
note_left_out_lines(struct reading *r, const struct layout *layout, size_t i)
{
	const struct row *first = layout->heading[i];
	const struct table *below = title_find_table_below_line(layout, first);
	const struct table *above = last_table_above_row(layout, first);
	FREED char *words = xstrdup("");
	size_t n = 0;
	do
		append_line_to_short_list(&words, layout->heading[i + n], n);
	while (++n + i < layout->n_heading &&
	       title_find_table_below_line(layout, layout->heading[i + n]) ==
		   below &&
	       last_table_above_row(layout, layout->heading[i + n]) == above &&
	       !is_line_already_read(r, layout, i + n));
	FREED char *samples = site_ask_samples_of_table(
	    below != NULL ? below : above, &r->all, SIZE_MAX);
	if (samples[0] == '\0' || layout->n == 1)
		site_heading_leave_out(
		    r->site, first->line, "remark below the table: %s", words);
	else
		site_heading_leave_out(r->site, first->line,
		    below != NULL ? N_("above the table of %s: %s")
				  : N_("below the table of %s: %s"),
		    samples, words);
	return n;
}

/* True if a table has speeds from the cells of a row: a sample has one. */
static bool
is_row_of_speeds(
    const struct reading *r, const struct table *t, const struct row *row)
{
	for (size_t k = 0; k < r->all.n; k++) {
		const struct column *c = &r->all.column[k];
		if (c->table == t && c->at < row->n && c->speed > 0 &&
		    fabs(row->cell[c->at].number - c->speed) < 1e-6)
			return true;
	}
	return false;
}

/* Notes as left out each row between the headings and the sieves that has
 * numbers of several samples after words that mean nothing here: "ca 16". */
static void
note_unknown_rows_above_sieves(struct reading *r, const struct table *t)
{
	for (size_t i = t->titles + 1; i < t->n_head && !t->across; i++) {
		const struct row *row = &t->head[i];
		const char *label = row->cell[0].text;
		struct head said = heading_parse(label);
		size_t numbers = 0;
		for (size_t c = 1; c < row->n; c++)
			numbers += isfinite(row->cell[c].number);
		FREED char *words = xstrdup("");
		append_line_to_short_list(&words, row, 0);
		if (numbers > 1 && said.unknown > 0 && said.means == 0 &&
		    !lexicon_is_date_label(label) &&
		    !lexicon_is_label_of_sites(label) &&
		    !is_row_of_speeds(r, t, row))
			site_heading_leave_out(r->site, row->line,
			    "%s: numbers above the first sieve", words);
	}
}

/* Notes what is in the tables or below them and was not read.  A comment may be
 * a sieve that the user has excluded with #. */
static void
note_all_unread_lines(struct reading *r)
{
	for (size_t p = 0; p < r->n_page; p++) {
		const struct page *page = &r->page[p];
		if (page->layout->n == 0)
			continue;
		const struct table *first = &page->layout->table[0];
		int head = first->n_head > 0 ? first->row[0].line - 1 : 0;
		for (size_t i = 0; i < page->sheet->n_comment; i++) {
			const struct comment *c = &page->sheet->comment[i];
			bool dashes =
			    c->text[strspn(c->text, "#-=_+:| \t")] == '\0';
			if (c->line <= head || dashes)
				continue;
			int shown = sheet_truncated_text_length(c->text);
			site_heading_leave_out(r->site, c->line,
			    "a comment: %.*s%s", shown, c->text,
			    c->text[shown] != '\0' ? "..." : "");
		}
		note_left_out_sums(r, page);
		for (size_t i = 0, n; i < page->layout->n_heading; i += n)
			n = is_line_already_read(r, page->layout, i)
				? 1
				: note_left_out_lines(r, page->layout, i);
		const struct cell *beside = &page->layout->beside;
		if (beside->text != NULL)
			site_heading_leave_out(r->site, beside->line,
			    "beside the table: %.*s",
			    sheet_truncated_text_length(beside->text),
			    beside->text);
	}
	for (size_t i = 0; i < r->n_table; i++) {
		note_unknown_rows_above_sieves(r, r->table[i]);
		note_sieves_without_numbers(r, r->table[i]);
	}
	note_left_out_cells(r);
}

/* Lists the sieves that have names in site->named: "#4 = 4.75, No. 8 = 2.36".
 * Tables with the same sieves list them once.  Notes that "# 4" below a number
 * in mm, which may be a row that somebody removed, is taken for one. */
static void
note_mm_of_named_sieves(struct reading *r)
{
	FREED char *before = xstrdup("");
	for (size_t k = 0; k < r->n_table; k++) {
		const struct table *t = r->table[k];
		FREED char *named = xstrdup("");
		bool number = false; /* the sieve above */
		for (size_t i = 0; i < t->n_row; i++) {
			const char *text = t->row[i].cell[0].text;
			double v;
			bool bare = number_value_of_cell(t->row[i].cell[0], &v);
			if (number && t->unit.mm > 0 &&
			    strncmp(text, "# ", 2) == 0)
				xappend_to_list(&r->site->assumed, "; ",
				    tr("'%s' as a sieve, not a remark"), text);
			number = bare;
			if (t->mm[i] > 0 &&
			    (sieve_series_of_name(text) != SIEVE_NONE ||
				(bare && t->unit.series != SIEVE_NONE)))
				xappend_to_list(
				    &named, ", ", "%s = %g", text, t->mm[i]);
		}
		if (named[0] != '\0' && strcmp(named, before) != 0)
			xappend_to_list(&r->site->named, ", ", "%s", named);
		xfree_and_set(&before, xstrdup(named));
	}
}

/* True if a table contains its sieves twice; notes that as an open question. */
static bool
detect_sieves_listed_twice(struct reading *r, const struct table *t)
{
	size_t again, end = site_sieve_rows_before_repeat(t, &again);
	if (end == t->n_row)
		return false;
	if (r->open.twice == NULL) {
		r->open.twice = t;
		r->open.end = end;
		r->open.again = again;
	}
	r->lost = true;
	return true;
}

/* Takes the speed from the name of one of several files that are one site:
 * "cut_60ms.csv".  Returns false if the name states none, or the sheet states
 * one. */
static bool
read_speed_from_file_name(
    const struct site_request *q, const char *path, struct surroundings *near)
{
	FREED char *stem = site_heading_name_from_path(path);
	struct head name = heading_parse_file_name(stem);
	if (q->n < 2 || q->parts || near->speed > 0 || near->rpm > 0 ||
	    name.several || !heading_has_speed(&name))
		return false;
	near->speed = name.speed;
	near->rpm = name.rpm;
	return true;
}

/* Notes that the columns from the ith on have the speed in the name of their
 * file, unless the headings of all of them state one. */
static void
note_speed_of_file_name(struct reading *r, const char *path, size_t i)
{
	bool used = false;
	for (; i < r->all.n; i++)
		used = used || (r->all.column[i].role == PRODUCT &&
				   !heading_has_speed(&r->all.column[i].said));
	if (!used)
		return;
	FREED char *stem = site_heading_name_from_path(path);
	xappend_to_list(
	    &r->site->assumed, "; ", tr("the speed in the name of %s"), stem);
}

/* Reports a product from the ith on whose heading states another speed than
 * `given`, that after the name of their file, if not 0.  One from rpm may
 * differ from it by what is rounded off. */
static void
check_speed_given_for_file(const struct columns *all, size_t i, double given)
{
	for (; given > 0 && i < all->n; i++) {
		const struct column *c = &all->column[i];
		bool other = c->role == PRODUCT && c->speed > 0 &&
			     fabs(c->speed - given) > given / 100;
		if (!other)
			continue;
		FREED char *wanted = xasprintf(
		    tr("a product at %g m/s, as after the file's name"), given);
		sheet_report_expected(c->table->sheet, c->head, wanted,
		    "leave out that speed to take the sheet's, %g m/s",
		    c->speed);
		return;
	}
}

/* Returns the speed given for a file, m/s, or 0. */
static double
given_speed(const struct reading *r, size_t file)
{
	double given = r->request->speed != NULL ? r->request->speed[file] : 0;
	return given < 0 ? rotor_speed_from_rpm(-given, rotor_of_reading(r))
			 : given;
}

static void
read_site_table(struct reading *r, const struct page *page, struct table *t,
    struct heading_speed told)
{
	const struct site_request *q = r->request;
	double given = q->speed != NULL ? q->speed[page->file] : 0;
	struct surroundings near = {.rotor = rotor_of_reading(r),
	    .speed = told.mps,
	    .rpm = told.rpm,
	    .told = r->columns.others,
	    .samples = &r->samples};
	near.context = title_read_role_and_speed(
	    page->layout, t, q->path[page->file], &near);
	/* "VSI 2" above a later table may mean that it is another site's. */
	if (t->strange && t != &page->layout->table[0] && !near.told &&
	    q->range == NULL)
		r->open.other = t;
	if (given != 0) { /* instead of that of the sheet */
		near.speed = fmax(given, 0);
		near.rpm = fmax(-given, 0);
		r->open.rotor |= given < 0 && near.rotor == 0;
	}
	bool named = read_speed_from_file_name(q, q->path[page->file], &near);
	uint64_t sieve = samples_set_column_headings(&r->columns, t);
	if (!layout_long_to_wide(t, sieve)) {
		r->lost = true;
		return;
	}
	enum sieve_certainty how = site_sieve_find_unit_and_sort(t, sieve);
	t->lost = page->sheet->lost;
	r->table = xrealloc(r->table, r->n_table + 1, sizeof(*r->table));
	r->table[r->n_table++] = t;
	if (detect_sieves_listed_twice(r, t))
		return;
	site_sieve_read_and_check(t);
	t->unit_open = how == SIEVES_OPEN;
	if (how == SIEVES_ASSUMED)
		xappend_to_list(&r->site->assumed, "; ", tr("sieves in %s"),
		    site_sieve_unit_text(t));
	r->lost = r->lost || t->lost;
	size_t first = r->all.n;
	classify_columns(t, &near, &r->all, r->site);
	check_speed_given_for_file(&r->all, first, given_speed(r, page->file));
	if (named)
		note_speed_of_file_name(r, q->path[page->file], first);
	bool lone = q->feed && r->all.n == first + 1;
	for (size_t i = first; (given != 0 || q->parts || lone) && i < r->all.n;
	     i++)
		if (r->all.column[i].role == NO_ROLE)
			r->all.column[i].role = lone ? FEED : PRODUCT;
	site_ask_find_ambiguous_number(&r->open, t);
}

/* Parses columns=, samples= and range=. */
static bool
parse_columns_samples_and_range(struct reading *r)
{
	const struct site_request *q = r->request;
	struct error e;
	bool good =
	    samples_parse_columns_option(
		&r->columns, q->columns, &r->range, &e) &&
	    samples_parse_option(&r->samples, q->samples, &e) &&
	    (q->range == NULL || cell_range_parse(q->range, &r->range.box) ||
		error_set(&e, ERROR_USAGE,
		    "expected a range such as A3:F20, got '%s'\n"
		    "the first is the cell at the top left, the second the one "
		    "at the bottom right",
		    q->range));
	if (!good)
		*error_list_add_item(r->errors) = e;
	return good;
}

/* Reports a sheet of predictions, which must not be read as measurements,
 * whatever columns= says.  Returns false if there is one. */
static bool
check_sheets_are_not_results(const struct source *source)
{
	char *command = NULL;
	size_t i = 0;
	while (i < source->n && command == NULL)
		command = command_that_made_sheet(source->sheet[i++]);
	if (command != NULL)
		sheet_report_fault(source->sheet[i - 1],
		    source->sheet[i - 1]->row[0].cell[0],
		    strcmp(command, "store export") == 0
			? N_("expected a site file, got materials of a store "
			     "(%s)\n'store import FILE' reads them")
			: N_("expected a site file, got tipspeed's own results "
			     "(%s)\nload the sheet that they were made from; "
			     "'write' saves a site file"),
		    command);
	free(command);
	return command == NULL;
}

/* Reads the sheet of a file that the user named, or all sheets. */
static bool
read_site_file(struct reading *r, size_t file)
{
	const struct site_request *q = r->request;
	struct source *source = &r->source[r->n_source++];
	bool read = q->text != NULL
			? source_read_from_memory(
			      q->path[file], q->text, r->errors, source)
			: source_read_sheets(q->path[file], r->errors, source);
	if (!read || !check_sheets_are_not_results(source))
		return false;
	size_t before = r->n_page;
	FREED char *names = xstrdup("");
	if (source->note[0] != '\0')
		xappend_to_list(&r->site->remark, "; ", "%s", source->note);
	for (size_t i = 0; i < source->n && !error_is_stop_requested(r->errors);
	     i++) {
		struct sheet *sheet = source->sheet[i];
		xappend_to_list(&names, ", ", "%s", sheet->name);
		if (q->sheet != NULL &&
		    !text_is_same_folded(sheet->name, q->sheet))
			continue;
		if (q->decimal != '\0')
			number_set_decimal_sign(sheet, q->decimal);
		site_sieve_uncomment_astm_rows(sheet);
		struct layout *layout = layout_new_of_sheet(sheet, r->range);
		r->page = xrealloc(r->page, r->n_page + 1, sizeof *r->page);
		r->page[r->n_page++] = (struct page){file, sheet, layout};
		r->lost = r->lost || sheet->lost;
	}
	bool found = r->n_page > before;
	if (!found)
		error_set_at(error_list_add_item(r->errors), ERROR_DATA,
		    q->path[file], 0, 0,
		    names[0] != '\0'
			? N_("expected a sheet called %s, got none\n"
			     "its sheets: %s")
			: N_("expected a sheet called %s, got a file without "
			     "sheets\nleave out sheet="),
		    q->sheet != NULL ? q->sheet : tr("(any)"), names);
	return found;
}

/* Takes the rotor's diameter from the options, else from a key, else from
 * titles and remarks; from none if the lines of the sheet disagree. */
static void
set_rotor_of_site(struct reading *r)
{
	const struct heading_rotor *said = &r->open.stated;
	bool differ = said->other_line > 0;
	if (r->request->rotor > 0 || differ)
		r->site->rotor = r->request->rotor;
	if (r->site->rotor > 0 || differ || !(said->mm > 0))
		return;
	r->site->rotor = said->mm / 1000;
	xappend_to_list(&r->site->remark, "; ",
	    tr("rotor of %g mm in diameter, stated in line %d"), said->mm,
	    said->line);
}

/* Notes, once for all columns, which speeds in rpm were read as which in
 * m/s. */
static void
note_speeds_from_rpm(struct reading *r)
{
	FREED char *rpm = xstrdup(""), *mps = xstrdup("");
	for (size_t i = 0; i < r->all.n; i++) {
		const struct column *c = &r->all.column[i];
		bool told = !(c->rpm > 0) || !(c->speed > 0);
		for (size_t k = 0; k < i; k++)
			told = told || r->all.column[k].rpm == c->rpm;
		if (told)
			continue;
		xappend_to_list(&rpm, ", ", "%g", c->rpm);
		xappend_to_list(&mps, ", ", "%g", c->speed);
	}
	if (rpm[0] != '\0')
		xappend_to_list(&r->site->remark, "; ",
		    tr("%s rpm, rotor of %g mm, read as %s m/s"), rpm,
		    1000 * rotor_of_reading(r), mps);
}

/* Notes, unless another site's rotor serves, that lines which differ leave the
 * rotor unknown. */
static void
note_differing_rotors(struct reading *r)
{
	const struct site_request *q = r->request;
	if (r->site->rotor > 0 || r->open.stated.other_line == 0 || q->parts ||
	    q->feed)
		return;
	FREED char *rotors = site_heading_rotors_text(&r->open.stated);
	xappend_to_list(&r->site->remark, "; ",
	    tr("rotor diameter not taken, got %s: load with "
	       "rotor_mm=DIAMETER to state it"),
	    rotors);
}

static void
read_all_tables(struct reading *r)
{
	for (size_t i = 0; i < r->n_page; i++)
		title_move_lines_to_headings(r->page[i].layout);
	for (size_t i = 0; i < r->n_page; i++)
		site_heading_merge_rotor(
		    r->page[i].layout, r->page[i].sheet, &r->open.stated);
	for (size_t i = 0; i < r->n_page; i++) {
		const struct page *page = &r->page[i];
		struct heading_speed told = {0};
		if (page->layout->n == 0)
			continue;
		site_heading_read(page->layout, page->sheet, r->site, &told);
		r->other_site = r->other_site || told.other_site;
		set_rotor_of_site(r);
		if (title_has_speed_per_table(page->layout))
			told = (struct heading_speed){0};
		for (size_t b = 0;
		     b < page->layout->n && !error_is_stop_requested(r->errors);
		     b++)
			read_site_table(r, page, &page->layout->table[b], told);
	}
}

/* Lists the numbers of a column, without the pan.  Returns how many there
 * are. */
static size_t
list_values_of_column(const struct column *c, double *list)
{
	size_t n = 0;
	for (size_t i = 0; i < c->table->n_row; i++) {
		double v = site_column_value_in_row(c, i);
		bool pan = c->table->mm != NULL && c->table->mm[i] == 0;
		if (!isnan(v) && !pan)
			list[n++] = v;
	}
	return n;
}

/* True if two columns have the same role, speed and numbers, perhaps in reverse
 * order. */
static bool
are_duplicate_columns(const struct column *a, const struct column *b)
{
	if (a->role != b->role || a->role == NO_ROLE ||
	    fabs(a->speed - b->speed) > 1e-3 || a->rpm != b->rpm)
		return false;
	FREED double *x = xcalloc_doubles(a->table->n_row);
	FREED double *y = xcalloc_doubles(b->table->n_row);
	size_t n = list_values_of_column(a, x), same = 0, back = 0;
	if (n != list_values_of_column(b, y))
		return false;
	for (size_t i = 0; i < n; i++) {
		same += fabs(x[i] - y[i]) > 0 ? 0 : 1;
		back += fabs(x[i] - y[n - 1 - i]) > 0 ? 0 : 1;
	}
	return n > 0 && (same == n || back == n);
}

/* True if all samples of a table are in earlier sheets too: it may be the data
 * of a chart.  A copy on the same sheet may be meant as another sample. */
static bool
is_table_repeated(const struct reading *r, size_t k)
{
	size_t own = 0;
	for (size_t i = 0; i < r->all.n; i++) {
		const struct column *c = &r->all.column[i];
		bool found = c->table != r->table[k];
		own += !found;
		for (size_t j = 0; j < i && !found; j++)
			found =
			    r->all.column[j].table->sheet != c->table->sheet &&
			    are_duplicate_columns(c, &r->all.column[j]);
		if (!found)
			return false;
	}
	return own > 0;
}

/* Leaves out tables that only repeat samples. */
static void
drop_repeated_tables(struct reading *r)
{
	for (size_t k = r->n_table; k-- > 1;) {
		struct table *t = r->table[k];
		if (r->columns.n > 0 || !is_table_repeated(r, k))
			continue;
		site_heading_leave_out(r->site, t->row[0].line,
		    "%s: samples again", samples_sheet_label(t->sheet));
		for (size_t i = r->all.n; i-- > 0;)
			if (r->all.column[i].table == t)
				site_column_drop(&r->all, i);
		r->n_table--;
		memmove(&r->table[k], &r->table[k + 1],
		    (r->n_table - k) * sizeof(*r->table));
		r->open.other = r->open.other == t ? NULL : r->open.other;
	}
	for (size_t k = 0; k < r->n_table; k++)
		r->open.sieves = r->open.sieves || r->table[k]->unit_open;
}

static const struct page *
page_of_column(const struct reading *r, const struct column *c)
{
	const struct page *page = r->page;
	while (page->sheet != c->table->sheet)
		page++;
	return page;
}

/* Gives each feed the speed of its file, if several files have a feed. */
static void
set_feed_speeds_from_files(struct reading *r)
{
	bool several = false, all = true;
	const struct column *first = NULL;
	for (size_t i = 0; i < r->all.n; i++) {
		const struct column *c = &r->all.column[i];
		if (c->role != FEED || c->speed > 0)
			continue;
		first = first != NULL ? first : c;
		size_t file = page_of_column(r, c)->file;
		several = several || file != page_of_column(r, first)->file;
		all = all && given_speed(r, file) > 0;
	}
	for (size_t i = 0; i < r->all.n && several && all; i++) {
		struct column *c = &r->all.column[i];
		if (c->role == FEED && !(c->speed > 0))
			c->speed = given_speed(r, page_of_column(r, c)->file);
	}
}

/* Drops products without a speed when only the feed is wanted.  If the only
 * column is called product, it may be meant as the feed, so it loses its
 * role. */
static void
drop_products_without_speed(struct reading *r)
{
	struct columns *all = &r->all;
	size_t feeds = site_column_count_by_role(all, NULL, FEED);
	for (size_t i = all->n; i-- > 0;) {
		struct column *c = &all->column[i];
		if (c->role != PRODUCT || c->speed > 0)
			continue;
		if (feeds > 0)
			site_column_drop(all, i);
		else if (all->n == 1)
			c->role = NO_ROLE;
	}
}

/* Returns the speeds of the products: "1560, 1680 rpm" if all are in rpm, else
 * in m/s. */
static char *
product_speeds_text(const struct columns *all)
{
	bool turns = true;
	FREED char *rpm = xstrdup(""), *mps = xstrdup("");
	for (size_t i = 0; i < all->n; i++) {
		const struct column *c = &all->column[i];
		if (c->role != PRODUCT)
			continue;
		turns = turns && c->rpm > 0;
		xappend_to_list(&rpm, ", ", "%g", c->rpm);
		xappend_to_list(&mps, ", ", "%g", c->speed);
	}
	return turns ? xasprintf("%s rpm", rpm) : xasprintf("%s m/s", mps);
}

/* Gives each feed the speed of the product in its table. */
static void
set_feed_speeds_from_products(struct columns *all)
{
	for (size_t i = 0; i < all->n; i++)
		for (size_t k = 0; k < all->n; k++) {
			struct column *feed = &all->column[i],
				      *product = &all->column[k];
			if (feed->role != FEED || product->role != PRODUCT ||
			    feed->table != product->table)
				continue;
			feed->speed = product->speed;
			feed->rpm = product->rpm;
			feed->nth = product->nth;
		}
}

/* Reads tables as one site, without a question, if their titles differ only in
 * speed or they are separate tests. */
static void
accept_tables_as_one_site(struct reading *r)
{
	const struct site_request *q = r->request;
	const struct table *last =
	    r->n_table > 1 ? r->table[r->n_table - 1] : NULL;
	if (r->other_site && last != NULL && q->range == NULL &&
	    !r->columns.others && r->samples.n == 0 &&
	    last->sheet == r->table[0]->sheet) {
		r->open.other = last;
		return;
	}
	bool tests = !r->other_site &&
		     titles_are_separate_tests(r->table, r->n_table, &r->all);
	if (!tests &&
	    (r->open.other == NULL || !titles_are_speed_series(r->table,
					  r->n_table, &r->all, q->parts)))
		return;
	if (tests)
		set_feed_speeds_from_products(&r->all);
	r->open.other = NULL;
	FREED char *speeds = product_speeds_text(&r->all);
	xappend_to_list(&r->site->remark, "; ",
	    site_column_count_by_role(&r->all, NULL, FEED) > 0
		? tr("read as one site: feed and products at %s")
		: tr("read as one site: products at %s"),
	    speeds);
}

/* Returns the day of a sample: the one in its headings, or else the one stated
 * above its table; NULL if there is none. */
static char *
day_of_sample_or_title(const struct reading *r, const struct column *c)
{
	bool differ = false;
	char *day = site_day_of_sample(c->table, c->at);
	return day != NULL ? day
			   : title_find_day(page_of_column(r, c)->layout,
				 c->table, NULL, &differ);
}

/* Notes the days of the cuts.  The notes of cuts at one speed are matched by
 * their order, so if one of them has a day, each gets a note. */
static void
note_days_of_cuts(struct reading *r)
{
	const struct columns *all = &r->all;
	FREED char **day = xcalloc(all->n + 1, sizeof(*day));
	for (size_t i = 0; i < all->n; i++)
		if (all->column[i].role == PRODUCT)
			day[i] = day_of_sample_or_title(r, &all->column[i]);
	for (size_t i = 0; i < all->n; i++) {
		const struct column *c = &all->column[i];
		bool any = false;
		for (size_t k = 0; k < all->n; k++)
			any = any || (day[k] != NULL &&
					 all->column[k].speed == c->speed);
		if (c->role != PRODUCT || !any)
			continue;
		FREED char *note = xasprintf("%g m/s%s%s", c->speed,
		    day[i] != NULL ? ", " : "", day[i] != NULL ? day[i] : "");
		site_notes_append(
		    &r->site->note, &r->site->n_note, "cut", note);
	}
	for (size_t i = 0; i < all->n; i++)
		free(day[i]);
}

/* Notes as left out the days of cuts that are stated in a form that is not
 * read, and days above the tables. */
static void
note_days_not_read(struct reading *r)
{
	for (size_t i = 0; i < r->all.n; i++) {
		const struct column *c = &r->all.column[i];
		const char *day = site_find_unreadable_day(c->table, c->at);
		if (c->role == PRODUCT && day != NULL)
			site_heading_leave_out(r->site, c->head.line,
			    "the day '%.*s' of the cut at %g m/s: write year, "
			    "month, day",
			    sheet_truncated_text_length(day), day, c->speed);
	}
	for (size_t p = 0; p < r->n_page; p++) {
		const struct layout *of = r->page[p].layout;
		for (size_t i = 0; i < of->n_heading; i++) {
			const char *day =
			    site_unreadable_day_of_line(of->heading[i]);
			if (day != NULL)
				site_heading_leave_out(r->site,
				    of->heading[i]->line,
				    "the day '%.*s': write year, month, day",
				    sheet_truncated_text_length(day), day);
		}
	}
}

/* Sets the provenance, if the sheet states none, to the days of the samples or,
 * if these have none, to the only day stated outside the tables.  See
 * site_data_kind. */
static void
set_provenance_from_days(struct reading *r)
{
	const struct columns *all = &r->all;
	FREED char **own = xcalloc(all->n + 1, sizeof(*own));
	FREED char *day = NULL;
	bool differ = false;
	if (r->site->provenance[0] != '\0')
		return;
	for (size_t i = 0; i < all->n; i++)
		own[i] =
		    site_day_of_sample(all->column[i].table, all->column[i].at);
	FREED char *days = site_day_range_text(own, all->n);
	for (size_t i = 0; i < all->n; i++)
		free(own[i]);
	for (size_t p = 0; p < r->n_page; p++)
		day = title_find_day(r->page[p].layout, NULL, day, &differ);
	if (days == NULL && (day == NULL || differ))
		return;
	xfree_and_set(&r->site->provenance,
	    xasprintf("sheet of %s", days != NULL ? days : day));
}

static struct site *
finish_site_reading(struct reading *r)
{
	const struct site_request *q = r->request;
	xfree_and_set(&r->site->path, xstrdup(q->path[0]));
	xappend_to_list(
	    &r->site->part, " ", "%s", q->sheet != NULL ? q->sheet : "");
	if (q->range != NULL)
		xappend_to_list(&r->site->part, " ", "%s", q->range);
	if (r->site->name[0] == '\0')
		xfree_and_set(
		    &r->site->name, site_heading_name_from_path(q->path[0]));
	r->site->told = q->columns != NULL || q->samples != NULL ||
			q->rotor > 0 || q->decimal != '\0';
	for (size_t i = 0; i < q->n && q->speed != NULL; i++)
		r->site->told = r->site->told || q->speed[i] != 0;
	note_speeds_from_rpm(r);
	note_differing_rotors(r);
	make_runs_of_site(r->site, &r->all);
	if (q->parts) {
		note_days_of_cuts(r);
		note_days_not_read(r);
	} else {
		set_provenance_from_days(r);
	}
	note_all_unread_lines(r);
	note_mm_of_named_sieves(r);
	site_describe_columns(r->table, r->n_table, &r->all, r->site);
	struct site *site = r->site;
	r->site = NULL;
	return site;
}

static void
clear_site_reading(struct reading *r)
{
	for (size_t i = 0; i < r->all.n; i++) {
		free(r->all.column[i].pct);
		free(r->all.column[i].assumed);
	}
	free(r->all.column);
	free(r->table);
	for (size_t i = 0; i < r->n_page; i++)
		layout_free(r->page[i].layout);
	free(r->page);
	for (size_t i = 0; i < r->n_source; i++)
		source_free(&r->source[i]);
	free(r->source);
	samples_clear(&r->columns);
	samples_clear(&r->samples);
	site_free(r->site);
}

/* Returns false if no page has a table; those without one are ignored. */
static bool
read_site_files(struct reading *r)
{
	size_t n = 0;
	for (size_t i = 0; i < r->request->n; i++)
		if (!read_site_file(r, i) || error_is_stop_requested(r->errors))
			return false;
	for (size_t i = 0; i < r->n_page; i++)
		n += r->page[i].layout->n;
	if (n == 0 && !r->lost)
		report_missing_table(r->page[0].sheet);
	return n > 0;
}

struct site *
site_read_with_options(const struct site_request *request,
    struct error_list *errors, struct site_ask *ask)
{
	struct site_ask none = {0};
	struct site *site = NULL;
	ask = ask != NULL ? ask : &none;
	struct reading r = {
	    .request = request, .errors = errors, .site = site_new(0)};
	r.source = xcalloc(request->n, sizeof *r.source);
	if (parse_columns_samples_and_range(&r) && read_site_files(&r)) {
		read_all_tables(&r);
		drop_repeated_tables(&r);
		set_feed_speeds_from_files(&r);
		if (request->feed)
			drop_products_without_speed(&r);
		size_t before = errors->n;
		if (r.n_table > 0) {
			samples_report_missing(&r.samples, r.table[0]);
			samples_report_missing(&r.columns, r.table[0]);
		}
		bool missing = errors->n > before;
		classify_columns_together(&r.all, r.site,
		    r.columns.others || r.samples.n > 0, &r.open.rotor);
		accept_tables_as_one_site(&r);
		bool open = errors->n == 0 &&
			    site_ask_pending_question(&r.open, request, r.table,
				r.n_table, &r.all, ask);
		if (!open && !missing) {
			read_and_check_sheet_columns(&r);
			set_or_ask_top_size(&r, ask);
		}
		ask->no_feed =
		    site_column_count_by_role(&r.all, NULL, FEED) == 0;
		ask->no_product =
		    site_column_count_by_role(&r.all, NULL, PRODUCT) == 0;
		if (errors->n == 0)
			site = finish_site_reading(&r);
	}
	clear_site_reading(&r);
	site_ask_clear(&none);
	return site;
}

struct site *
site_read(const char *path, struct error_list *errors)
{
	struct site_request request = {.n = 1, .path = &path};
	return site_read_with_options(&request, errors, NULL);
}

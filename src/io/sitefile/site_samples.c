/* Gives columns the headings that columns= states by number, and samples the
 * roles that samples= states by name.  The names of samples are in their
 * headings, or in the rows of a long table.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/sitefile/site_samples.h"

#include <ctype.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "base/xalloc.h"
#include "base/tr.h"
#include "io/cells/number.h"
#include "io/fs/file.h"
#include "io/sitefile/lexicon.h"
#include "io/sitefile/site_day.h"

/* Cuts off the next part of a list separated by commas, and returns it, or NULL
 * after the last; moves *rest past it.  The comma in a number such as @63,6
 * does not separate. */
static char *
next_list_item(char **rest)
{
	char *part = *rest, *comma = part != NULL ? strchr(part, ',') : NULL;
	while (comma != NULL && comma > part &&
	       isdigit((unsigned char)comma[-1]) &&
	       isdigit((unsigned char)comma[1]) &&
	       comma[1 + strcspn(comma + 1, "=,")] != '=')
		comma = strchr(comma + 1, ',');
	*rest = comma != NULL ? comma + 1 : NULL;
	if (comma != NULL)
		*comma = '\0';
	return part;
}

/* Adds "3=feed" (numbers: a column by its number) or "S01=feed". */
static bool
parse_sample_assignment(
    struct samples *s, bool numbers, char *part, struct error *error)
{
	char *text = text_trim(part), *cut = strrchr(text, '=');
	unsigned long number = numbers ? strtoul(text, &cut, 10) : 0;
	bool good = cut != NULL && cut > text && *cut == '=' && cut[1] != '\0';
	if (!good || (numbers && (number == 0 || number > 100000)))
		return error_set(error, ERROR_USAGE,
		    numbers ? N_("expected NUMBER=WHAT in columns, got '%s'\n"
				 "for instance: columns=\"1=sieve mm, 2=feed, "
				 "3=product@69\"")
			    : N_("expected NAME=WHAT in samples, got '%s'\n"
				 "for instance: samples=\"A1=feed, A2=@70\""),
		    text);
	*cut = '\0';
	s->item = xrealloc(s->item, s->n + 1, sizeof *s->item);
	s->item[s->n++] = (struct sample){.number = number,
	    .name = xstrdup(text_trim(text)),
	    .text = xstrdup(text_trim(cut + 1))};
	return true;
}

static bool
parse_column_or_sample_roles(
    struct samples *s, bool numbers, const char *text, struct error *error)
{
	FREED char *copy = xstrdup(text != NULL ? text : "");
	char *rest = text != NULL ? copy : NULL;
	for (char *part; (part = next_list_item(&rest)) != NULL;)
		if (!parse_sample_assignment(s, numbers, part, error))
			return false;
	return true;
}

bool
samples_parse_option(struct samples *s, const char *text, struct error *error)
{
	return parse_column_or_sample_roles(s, false, text, error);
}

bool
samples_parse_columns_option(struct samples *s, const char *text,
    struct layout_range *range, struct error *error)
{
	static const uint64_t ELSE =
	    WORD_FEED | WORD_PRODUCT | WORD_PASSES | WORD_STAYS;
	if (!parse_column_or_sample_roles(s, true, text, error))
		return false;
	for (size_t i = 0; i < s->n; i++) {
		uint64_t means = lexicon_text_meanings(s->item[i].text, NULL);
		if ((means & WORD_SIZE) == 0 || (means & ELSE) != 0) {
			s->others = true;
			continue;
		}
		if (range->n_sieves < LAYOUT_SIEVES)
			range->sieves[range->n_sieves++] = s->item[i].number;
		range->phi = range->phi || (means & WORD_PHI) != 0;
	}
	return text == NULL || range->n_sieves > 0 ||
	       error_set(error, ERROR_USAGE,
		   "expected a column of sieves in columns, got '%s'\n"
		   "for instance: columns=\"1=sieve mm, 2=feed, 3=product@69\"",
		   text);
}

void
samples_clear(struct samples *s)
{
	for (size_t i = 0; i < s->n; i++) {
		free(s->item[i].name);
		free(s->item[i].text);
	}
	free(s->item);
}

static const struct sample *
find_sample_of_column(struct samples *columns, size_t number)
{
	for (size_t i = 0; i < columns->n; i++)
		if (columns->item[i].number == number) {
			columns->item[i].found = true;
			return &columns->item[i];
		}
	return NULL;
}

/* Moves column c of some rows to place n, and makes it the last for now. */
static void
move_column_of_rows(struct row *row, size_t n_row, size_t c, size_t n)
{
	for (size_t r = 0; r < n_row; r++) {
		row[r].cell[n] = row[r].cell[c];
		row[r].n = row[r].n_all = n + 1;
	}
}

/* Gives the columns new headings and drops those that the user did not name. */
static void
rename_and_keep_named_columns(struct samples *columns, struct table *t)
{
	size_t n = 0;
	struct row head = {.line = t->row[0].line};
	head.cell = xcalloc(t->n_col, sizeof *head.cell);
	char **day = xcalloc(t->n_col, sizeof(*day));
	for (size_t c = 1; c < t->n_col; c++) {
		char *own = site_day_of_sample(t, c);
		day[c] = own != NULL ? layout_adopt_text(t, own) : NULL;
	}
	t->day = day; /* those of the headings that are replaced */
	for (size_t c = 0; c < t->n_col; c++) {
		const struct sample *named =
		    find_sample_of_column(columns, t->number[c]);
		if (named == NULL && c > 0)
			continue;
		struct cell cell = t->n_head > 0
				       ? t->head[t->n_head - 1].cell[c]
				       : t->row[0].cell[c];
		char *text = layout_adopt_text(
		    t, xstrdup(named != NULL ? named->text : ""));
		head.cell[n] =
		    number_reparse_cell_with_text(t->sheet, cell, text);
		t->number[n] = t->number[c];
		t->day[n] = t->day[c];
		move_column_of_rows(t->row, t->n_row, c, n);
		move_column_of_rows(t->foot, t->n_foot, c, n);
		n++;
	}
	for (size_t r = 0; r < t->n_head; r++)
		free(t->head[r].cell);
	t->head = xrealloc(t->head, 1, sizeof *t->head);
	head.n = head.n_all = n;
	t->head[0] = head;
	t->n_head = 1;
	t->titles = 0;
	t->n_col = n;
}

uint64_t
samples_set_column_headings(struct samples *columns, struct table *t)
{
	const struct sample *sieves =
	    find_sample_of_column(columns, t->number[0]);
	if (columns->others)
		rename_and_keep_named_columns(columns, t);
	return sieves != NULL ? lexicon_text_meanings(sieves->text, NULL) : 0;
}

/* True if the cells of a row of headings are all different. */
static bool
are_headings_distinct(const struct table *t, size_t r)
{
	const struct cell *cell = t->head[r].cell;
	for (size_t c = 1; c < t->n_col; c++) {
		if (cell[c].text[0] == '\0')
			return false;
		for (size_t k = 1; k < c; k++)
			if (text_is_same_but_case(
				cell[c].text, cell[k].text, SIZE_MAX))
				return false;
	}
	return true;
}

bool
samples_have_distinct_names(const struct table *t)
{
	size_t r = 0;
	while (r < t->n_head && t->name == NULL && !are_headings_distinct(t, r))
		r++;
	return t->name != NULL || r < t->n_head;
}

/* True if the label of a row of headings says that it names the samples:
 * "Sample", "Prov nr". */
static bool
is_row_of_sample_names(const struct row *row)
{
	static const uint64_t ELSE = WORD_SPEED | WORD_PASSES | WORD_STAYS |
				     WORD_GRAMS | WORD_MASS | WORD_SIZE;
	uint64_t means = lexicon_text_meanings(row->cell[0].text, NULL);
	return (means & WORD_SAMPLE) != 0 && (means & ELSE) == 0 &&
	       !lexicon_is_date_label(row->cell[0].text);
}

const struct cell *
samples_name_of_column(const struct table *t, size_t c)
{
	for (size_t r = 0; r < t->n_head; r++)
		if (is_row_of_sample_names(&t->head[r]) &&
		    t->head[r].cell[c].text[0] != '\0')
			return &t->head[r].cell[c];
	return NULL;
}

char *
samples_label_of_column(const struct table *t, size_t c)
{
	if (t->name != NULL)
		return xstrdup(t->name[c]);
	for (size_t r = 0; r < t->n_head; r++)
		if (is_row_of_sample_names(&t->head[r]) &&
		    are_headings_distinct(t, r))
			return xstrdup(t->head[r].cell[c].text);
	for (size_t r = 0; r < t->n_head; r++)
		if (are_headings_distinct(t, r))
			return xstrdup(t->head[r].cell[c].text);
	return layout_column_heading_text(t, c);
}

/* Adds what the text says to what the headings of a column state; reports a
 * contradiction. */
static void
apply_sample_option_text(struct column *c, const char *text)
{
	static const uint64_t GROUPS[] = {WORD_FEED | WORD_PRODUCT | WORD_SD,
	    WORD_PASSES | WORD_STAYS, WORD_SUMS,
	    WORD_PERCENT | WORD_GRAMS | WORD_SHARE};
	struct head own = heading_parse(text), *said = &c->said;
	bool speed = heading_has_speed(&own);
	if ((own.means & GROUPS[0]) == 0 && speed)
		own.means |= WORD_PRODUCT;
	bool against = own.speed > 0 && said->speed > 0 &&
		       fabs(own.speed - said->speed) > 1e-3;
	for (size_t i = 0; i < ARRAY_LEN(GROUPS); i++) {
		uint64_t stated = said->means & GROUPS[i];
		against |=
		    stated != 0 && (own.means & GROUPS[i] & ~stated) != 0;
		said->means |= own.means & GROUPS[i];
	}
	if (against)
		sheet_report_fault(c->table->sheet, c->head,
		    "expected what this heading states, got '%s' in samples=\n"
		    "leave out what contradicts it, or correct the sheet",
		    text);
	if (speed) {
		said->speed = own.speed;
		said->rpm = own.rpm;
		said->unit = own.unit;
	}
	/* The rest of its headings is its name. */
	said->unknown = said->n_number = 0;
	said->several = own.several;
	said->means &= ~(uint64_t)(WORD_SAMPLE | WORD_NUMBER | WORD_OTHER);
}

const char *
samples_sheet_label(const struct sheet *sheet)
{
	return sheet->name[0] != '\0' ? sheet->name
				      : file_name_without_folders(sheet->path);
}

bool
samples_is_sheet_named(const struct samples *s, const struct sheet *sheet)
{
	for (size_t i = 0; i < s->n; i++)
		if (text_is_same_folded(
			s->item[i].name, samples_sheet_label(sheet)))
			return true;
	return false;
}

bool
samples_apply_to_column(struct samples *s, struct column *c)
{
	const struct table *t = c->table;
	FREED char *label = samples_label_of_column(t, c->at);
	for (size_t i = 0; i < s->n; i++) {
		struct sample *one = &s->item[i];
		bool same = text_is_same_folded(label, one->name) ||
			    text_is_same_folded(
				samples_sheet_label(t->sheet), one->name);
		for (size_t r = 0; r < t->n_head && t->name == NULL; r++)
			same =
			    same || text_is_same_folded(
					t->head[r].cell[c->at].text, one->name);
		if (!same)
			continue;
		one->found = true;
		apply_sample_option_text(c, one->text);
		return true;
	}
	return false;
}

void
samples_report_missing(const struct samples *s, const struct table *t)
{
	enum { SHOWN = 5 };
	size_t i = 0;
	while (i < s->n && s->item[i].found)
		i++;
	if (i == s->n)
		return;
	if (s->item[i].number > 0) {
		sheet_report_fault(t->sheet, t->row[0].cell[0],
		    "expected columns with numbers in columns=, each once, got "
		    "%s\n"
		    "columns are counted from the left, empty ones too",
		    s->item[i].name);
		return;
	}
	FREED char *list = xstrdup("");
	for (size_t c = 1; c < t->n_col && c <= SHOWN; c++) {
		FREED char *label = samples_label_of_column(t, c);
		xappend_to_list(&list, ", ", "%s", label);
	}
	sheet_report_fault(t->sheet, t->row[0].cell[0],
	    "expected a sample called %s, got none\nsamples here: %s%s",
	    s->item[i].name, list, t->n_col > SHOWN + 1 ? ", .." : "");
}

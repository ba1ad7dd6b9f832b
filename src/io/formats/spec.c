/* Reads the limits of a grading envelope from a sheet.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/formats/spec.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "base/tr.h"
#include "base/xalloc.h"
#include "io/cells/sheet.h"
#include "io/sitefile/layout.h"
#include "io/sitefile/site_sieve.h"
#include "io/cells/source.h"
#include "io/cells/number.h"

static const char *const HEADS[2] = {"min_pct", "max_pct"};

bool
spec_parse_fraction_sizes(const char *text, double cut[static 2])
{
	double mm[2];
	const char *slash = strchr(text, '/');
	FREED char *fine = slash != NULL
			       ? xstrndup(text, (size_t)(slash - text))
			       : xstrdup("");
	bool ok = text_parse_number(fine, &mm[0]) &&
		  text_parse_number(slash + 1, &mm[1]) && mm[0] >= 0 &&
		  mm[1] > mm[0];
	for (size_t i = 0; ok && i < 2; i++)
		cut[i] = mm[i] / 1000;
	return ok;
}

/* Reads a key with its value.  Returns false for an unknown key, as in a
 * remark. */
static bool
spec_parse_key_value(
    struct spec *spec, struct sheet *sheet, struct cell key, struct cell value)
{
	static const char *const CUT[] = {
	    "cut", "cut mm", "cut_mm", "fraction", "fraction mm"};
	bool cut = false;
	for (size_t i = 0; i < ARRAY_LEN(CUT); i++)
		cut = cut || text_is_same_folded(key.text, CUT[i]);
	char **text = text_is_same_folded(key.text, "spec")     ? &spec->name
		      : text_is_same_folded(key.text, "source") ? &spec->source
								: NULL;
	if (cut) {
		if (!spec_parse_fraction_sizes(value.text, spec->cut))
			sheet_report_expected(sheet, value,
			    "a fraction in mm such as 0/4",
			    "leave the line out for limits on the whole "
			    "product");
		return true;
	}
	if (text != NULL)
		xfree_and_set(text, xstrdup(value.text));
	return text != NULL;
}

static void
read_spec_key_lines(
    struct spec *spec, struct sheet *sheet, const struct layout *layout)
{
	for (size_t i = 0; i < layout->n_heading; i++) {
		const struct row *row = layout->heading[i];
		if (row->n > 2)
			sheet_report_expected(sheet, row->cell[2],
			    "the end of the line after key and value",
			    "quote a value that contains the separator");
		spec_parse_key_value(
		    spec, sheet, row->cell[0], row_cell_at(row, 1));
	}
}

/* Reads the keys in the lines immediately above the table, which look like its
 * headings if a value has numbers, "cut,0/4", up to one that is unknown. */
static void
read_keys_above_table(
    struct spec *spec, struct sheet *sheet, const struct table *t)
{
	size_t i = 0;
	while (i < t->titles && t->head[i].n == 2 &&
	       spec_parse_key_value(spec, sheet, t->head[i].cell[0],
		   row_cell_at(&t->head[i], 1)))
		i++;
	if (i < t->titles)
		sheet_report_expected(sheet, t->head[0].cell[t->n_col - 1],
		    "the end of the line after key and value",
		    "quote a value that contains the separator");
}

/* Returns the index in HEADS of what a heading such as max_pct, "Max %" or
 * "Upper limit" names, or 2. */
static size_t
limit_named_in_heading(const char *heading)
{
	static const char *const WORDS[3] = {"min minimum lower undre untere",
	    "max maximum upper ovre obere", "pct passing limit limits grans"};
	FREED char *folded = text_fold_case_and_accents(heading);
	size_t named = 2, i, which;
	char *next = NULL;
	for (char *word = strtok_r(folded, " _-%()[],.:", &next); word != NULL;
	     word = strtok_r(NULL, " _-%()[],.:", &next)) {
		for (i = 0; i < 3; i++)
			if (text_find_word_in_list(WORDS[i], word, &which))
				break;
		if (i == 3 || (i < 2 && named < 2))
			return 2;
		named = i < 2 ? i : named;
	}
	return named;
}

/* Finds the places of min_pct and max_pct in a row; at is 0 for one that is
 * missing. */
static void
spec_find_limit_columns(const struct table *t, size_t at[static 2])
{
	at[0] = at[1] = 0;
	for (size_t i = 1; i < t->n_col; i++) {
		struct cell head = t->head[t->n_head - 1].cell[i];
		size_t which = limit_named_in_heading(head.text);
		if (which < 2 && at[which] == 0)
			at[which] = i;
		else if (head.text[0] != '\0')
			sheet_report_expected(t->sheet, head,
			    "a column min_pct or max_pct, each once",
			    "use size_mm,min_pct,max_pct; see "
			    "tipspeed-spec(5)");
	}
	if (at[0] == 0 && at[1] == 0 && t->n_col < 2)
		sheet_report_fault(t->sheet, site_sieve_heading_cell(t),
		    "expected a column min_pct or max_pct, got none\n"
		    "write this line as size_mm,min_pct,max_pct");
}

/* Returns the limit of a row as passing, 0..1; NAN if the cell is empty or has
 * a fault. */
static double
parse_limit_of_row(const struct table *t, size_t row, size_t at)
{
	double v;
	struct cell cell = row_cell_at(&t->row[row], at);
	if (cell.value == AS_PERCENT)
		cell.value = AS_NUMBER;
	if (at == 0 || cell.text[0] == '\0' || cell.value == AS_ABSENT ||
	    !number_read_cell(t->sheet, cell, tr("a number"), &v))
		return NAN;
	if (v >= 0 && v <= 100)
		return v / 100;
	sheet_report_expected(t->sheet, cell, "passing from 0 to 100 %",
	    "leave the cell empty where there is no limit");
	return NAN;
}

/* Checks that a limit does not rise from one sieve to the next finer one that
 * has a limit. */
static void
check_limits_never_rise(
    const struct table *t, const double *limit, size_t at, size_t at_most)
{
	char size[32];
	double last = INFINITY;
	for (size_t i = 0; i < t->n_row; i++) {
		if (isnan(limit[i]))
			continue;
		if (limit[i] > last)
			sheet_report_fault(t->sheet,
			    row_cell_at(&t->row[i], at),
			    "%s rises from %g to %g at %s mm (finer sieve, "
			    "more passing)\n"
			    "check this row and the one above: a limit cannot "
			    "rise on a finer sieve",
			    HEADS[at_most], 100 * last, 100 * limit[i],
			    text_shortest_exact_number(t->mm[i], size));
		last = limit[i];
	}
}

static void
spec_read_limit_rows(
    struct spec *spec, struct table *t, const size_t at[static 2])
{
	enum { FEW = 3 };
	double largest = -1;
	size_t limited = 0;
	spec->n = t->n_row;
	spec->size = xcalloc_doubles(t->n_row);
	spec->least = xcalloc_doubles(t->n_row);
	spec->most = xcalloc_doubles(t->n_row);
	for (size_t i = 0; i < t->n_row; i++) {
		struct cell cell = t->row[i].cell[0];
		spec->size[i] = t->mm[i] / 1000;
		spec->least[i] = parse_limit_of_row(t, i, at[0]);
		spec->most[i] = parse_limit_of_row(t, i, at[1]);
		double larger = fmax(spec->least[i], spec->most[i]);
		largest = fmax(largest, larger);
		limited += isnan(larger) ? 0 : 1;
		if (t->mm[i] <= 0)
			sheet_report_expected(t->sheet, cell, "a sieve size",
			    "remove the row: an envelope has no pan");
		if (spec->least[i] > spec->most[i])
			sheet_report_fault(t->sheet, cell,
			    "expected min_pct <= max_pct, got %g above "
			    "%g\nwere the two swapped?",
			    100 * spec->least[i], 100 * spec->most[i]);
	}
	if (largest > 0 && largest <= 0.01 && limited >= FEW)
		sheet_report_fault(t->sheet, site_sieve_heading_cell(t),
		    "expected limits in per cent, got none above 1\n"
		    "write per cent passing, such as 85 for 0.85");
	if (largest < 0 && t->sheet->n_fault == 0)
		sheet_report_fault(t->sheet, site_sieve_heading_cell(t),
		    "expected a limit in a row below, got none\n"
		    "write per cent passing into min_pct or max_pct");
	for (size_t i = 0; i < 2 && !t->lost; i++)
		check_limits_never_rise(
		    t, i == 0 ? spec->least : spec->most, at[i], i);
}

static void
spec_read_table(struct spec *spec, struct table *t)
{
	enum sieve_certainty certainty = site_sieve_find_unit_and_sort(t, 0);
	size_t at[2];
	spec_find_limit_columns(t, at);
	site_sieve_read_and_check(t);
	if (certainty == SIEVES_OPEN)
		sheet_report_expected(t->sheet, site_sieve_heading_cell(t),
		    "the unit of the sieves", "write size_mm");
	spec_read_limit_rows(spec, t, at);
}

static void
spec_read_sheet(struct spec *spec, struct sheet *sheet)
{
	struct layout_range all = {0};
	site_sieve_uncomment_astm_rows(sheet);
	struct layout *layout = layout_new_of_sheet(sheet, all);
	read_spec_key_lines(spec, sheet, layout);
	if (layout->n > 0 && layout->table[0].n_head > 0) {
		read_keys_above_table(spec, sheet, &layout->table[0]);
		spec_read_table(spec, &layout->table[0]);
		if (layout->n > 1)
			sheet_report_fault(sheet,
			    site_sieve_heading_cell(&layout->table[1]),
			    "expected the limits of one envelope, got a second "
			    "table\n"
			    "put each envelope into a file of its own");
	} else if (!sheet->lost) {
		struct row none = {.line = 1, .end = 1};
		sheet_report_expected(sheet, row_cell_at(&none, 0),
		    "a line that begins with size_mm, and rows of sieves below "
		    "it",
		    "begin the table with size_mm,min_pct,max_pct and continue "
		    "with rows such as 4,85,99");
	}
	layout_free(layout);
}

struct spec *
spec_read_file(const char *path, struct error_list *errors)
{
	struct source source;
	struct spec *spec = NULL;
	if (source_read_sheets(path, errors, &source)) {
		spec = spec_new();
		xfree_and_set(&spec->note, xstrdup(source.note));
		if (source.n > 1)
			xappend_to_list(&spec->note, "; ",
			    tr("of %zu sheets, only '%s' is read"), source.n,
			    source.sheet[0]->name);
		spec_read_sheet(spec, source.sheet[0]);
		if (spec->name[0] == '\0')
			xfree_and_set(&spec->name, xstrdup(path));
		if (source.sheet[0]->n_fault > 0 || errors->stopped) {
			spec_free(spec);
			spec = NULL;
		}
	}
	source_free(&source);
	return spec;
}

struct spec *
spec_new(void)
{
	struct spec *spec = xcalloc(1, sizeof *spec);
	spec->name = xstrdup("");
	spec->source = xstrdup("");
	spec->note = xstrdup("");
	spec->standard = xstrdup("");
	return spec;
}

void
spec_free(struct spec *spec)
{
	if (spec == NULL)
		return;
	free(spec->name);
	free(spec->source);
	free(spec->note);
	free(spec->standard);
	free(spec->size);
	free(spec->least);
	free(spec->most);
	free(spec);
}

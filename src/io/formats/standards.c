/* Reads data/envelopes.csv and data/envelope-scalars.csv, and finds an envelope
 * by words from its name.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/formats/standards.h"

#include <assert.h>
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "base/tr.h"
#include "base/xalloc.h"
#include "io/cells/number.h"
#include "io/cells/sheet.h"
#include "io/cells/textfile.h"
#include "io/fs/file.h"

/* The rows of the two files, without remarks, made at build time. */
extern const char *const ENVELOPES_TEXT[], *const ENVELOPE_SCALARS_TEXT[];

enum { MOST_ROWS = 1000 };

static const char COPY[] =
    N_("transcribed from a second-hand copy: check it against your own");

static double
read_limit_cell(struct sheet *sheet, const struct row *row, size_t at)
{
	double value;
	struct cell cell = row_cell_at(row, at);
	if (cell.text[0] == '\0' ||
	    !number_read_cell(sheet, cell, tr("a number"), &value))
		return NAN;
	return value;
}

static struct spec *
find_spec_by_name(const struct standards *all, const char *name)
{
	for (size_t i = 0; i < all->n; i++)
		if (strcmp(all->spec[i]->name, name) == 0)
			return all->spec[i];
	return NULL;
}

/* Inserts a row in its place, coarsest first; replaces a row with the same
 * sieve. */
static void
insert_envelope_sieve_limits(
    struct spec *spec, double size, double least, double most)
{
	size_t i = 0, n = spec->n;
	while (i < n && spec->size[i] > size)
		i++;
	bool there = i < n && spec->size[i] == size;
	double **column[] = {&spec->size, &spec->least, &spec->most};
	const double value[] = {size, least, most};
	for (size_t c = 0; c < ARRAY_LEN(column); c++) {
		double *x = *column[c];
		if (!there) {
			x = xrealloc(x, n + 1, sizeof *x);
			memmove(x + i + 1, x + i, (n - i) * sizeof *x);
		}
		x[i] = value[c];
		*column[c] = x;
	}
	spec->n += !there;
}

/* Returns the envelope with this name less the brackets at its end, from which
 * it takes its limits, or NULL. */
static const struct spec *
find_base_envelope(const struct standards *all, const char *name)
{
	const char *bracket = strstr(name, " (");
	if (bracket == NULL)
		return NULL;
	FREED char *base = xstrndup(name, (size_t)(bracket - name));
	return find_spec_by_name(all, base);
}

static struct spec *
standards_add_envelope(struct standards *all, const char *standard,
    const char *name, const char *cut, const char *source)
{
	struct spec *spec = spec_new();
	xfree_and_set(&spec->name, xstrdup(name));
	xfree_and_set(&spec->standard, xstrdup(standard));
	xfree_and_set(&spec->source, xstrdup(source));
	bool ok = spec_parse_fraction_sizes(cut, spec->cut);
	assert(ok);
	(void)ok;
	const struct spec *base = find_base_envelope(all, name);
	for (size_t i = 0; base != NULL && i < base->n; i++)
		insert_envelope_sieve_limits(
		    spec, base->size[i], base->least[i], base->most[i]);
	all->spec = xrealloc(all->spec, all->n + 1, sizeof(*all->spec));
	all->spec[all->n++] = spec;
	return spec;
}

static void
read_envelope_row(
    struct standards *all, struct sheet *sheet, const struct row *row)
{
	enum { STANDARD, NAME, CUT, SIZE, LEAST, MOST, SOURCE };
	const char *standard = row_cell_at(row, STANDARD).text;
	const char *source = row_cell_at(row, SOURCE).text;
	FREED char *name =
	    xasprintf("%s %s", standard, row_cell_at(row, NAME).text);
	double mm = read_limit_cell(sheet, row, SIZE);
	struct spec *spec = find_spec_by_name(all, name);
	if (spec == NULL)
		spec = standards_add_envelope(
		    all, standard, name, row_cell_at(row, CUT).text, source);
	insert_envelope_sieve_limits(spec, mm / 1000,
	    read_limit_cell(sheet, row, LEAST) / 100,
	    read_limit_cell(sheet, row, MOST) / 100);
	/* What the source says in addition to that of the envelope's first
	 * row, with its sieve: "0.15 mm: crushed stone sand: up to 20". */
	size_t n = strcspn(spec->source, ";"), more = strlen(source);
	if (strncmp(spec->source, source, n) == 0 && more >= n + 4 &&
	    source[n + 1] == '(')
		xappend_to_list(&spec->source, "; ", "%g mm: %.*s", mm,
		    (int)(more - n - 3), source + n + 2);
}

static void
standards_read_limit_row(
    struct standards *all, struct sheet *sheet, const struct row *row)
{
	enum { STANDARD, ITEM, LEAST, MOST, UNIT, NOTE };
	all->limit = xrealloc(all->limit, all->n_limit + 1, sizeof *all->limit);
	all->limit[all->n_limit++] = (struct standard_limit){
	    .standard = xstrdup(row_cell_at(row, STANDARD).text),
	    .item = xstrdup(row_cell_at(row, ITEM).text),
	    .unit = xstrdup(row_cell_at(row, UNIT).text),
	    .note = xstrdup(row_cell_at(row, NOTE).text),
	    .least = read_limit_cell(sheet, row, LEAST),
	    .most = read_limit_cell(sheet, row, MOST)};
}

/* Reads the rows of a built-in table, without its heading. */
static void
standards_read_built_in_table(struct standards *all, const char *name,
    const char *const *line,
    void (*read)(struct standards *, struct sheet *, const struct row *))
{
	struct error_list errors = {0};
	FREED char *text = textfile_join_built_in_lines(line);
	const struct sheet_limits most = {.rows = MOST_ROWS};
	struct sheet *sheet = sheet_new_from_text(name, text, most, &errors);
	number_detect_decimal_sign(sheet);
	for (size_t i = 1; i < sheet->n_row; i++)
		read(all, sheet, &sheet->row[i]);
	/* These tables are part of the program, and tests read all of them. */
	assert(sheet->n_fault == 0);
	sheet_free(sheet);
}

struct standards *
standards_read_built_in(void)
{
	struct standards *all = xcalloc(1, sizeof *all);
	standards_read_built_in_table(
	    all, "envelopes", ENVELOPES_TEXT, read_envelope_row);
	standards_read_built_in_table(
	    all, "scalars", ENVELOPE_SCALARS_TEXT, standards_read_limit_row);
	for (size_t i = 0; i < all->n; i++)
		xappend(&all->spec[i]->source, "; %s", tr(COPY));
	return all;
}

void
standards_free(struct standards *all)
{
	if (all == NULL)
		return;
	for (size_t i = 0; i < all->n; i++)
		spec_free(all->spec[i]);
	for (size_t i = 0; i < all->n_limit; i++) {
		free(all->limit[i].standard);
		free(all->limit[i].item);
		free(all->limit[i].unit);
		free(all->limit[i].note);
	}
	free(all->spec);
	free(all->limit);
	free(all);
}

static const char BETWEEN[] = " :;,()";

/* Returns how well a word matches a folded name: 2 if it is a word of the name,
 * 1 if it begins one, else 0. */
static int
score_word_match(const char *name, const char *word)
{
	int best = 0;
	size_t n = strlen(word);
	for (const char *p = name + strspn(name, BETWEEN); *p != '\0';) {
		size_t own = strcspn(p, BETWEEN);
		if (own >= n && strncmp(p, word, n) == 0)
			best = own == n ? 2 : best > 1 ? best : 1;
		p += own;
		p += strspn(p, BETWEEN);
	}
	return best;
}

static int
lowest_word_match_score(const char *name, const char *words)
{
	FREED char *folded = text_fold_case_and_accents(name),
		   *all = text_fold_case_and_accents(words);
	char *next = NULL;
	int least = 2;
	for (char *word = strtok_r(all, BETWEEN, &next); word != NULL;
	     word = strtok_r(NULL, BETWEEN, &next)) {
		int in = score_word_match(folded, word);
		least = in < least ? in : least;
	}
	return least;
}

/* True if the words are enough to mean the plain one of an envelope's variants:
 * they contain a number, as that of its standard, "C33", or all of its own
 * name, "zone II"; but not "ASTM" alone. */
static bool
do_words_name_base_envelope(const struct spec *spec, const char *folded)
{
	return folded[strcspn(folded, "0123456789")] != '\0' ||
	       lowest_word_match_score(
		   folded, spec->name + strlen(spec->standard)) == 2;
}

/* If all marked names begin with one of them, and the words mean that one,
 * keeps only that.  Returns the number of marked names. */
static size_t
unmark_all_but_base_envelope(
    const struct standards *all, const char *folded, bool *match, size_t n)
{
	for (size_t i = 0; i < all->n; i++) {
		const char *name = all->spec[i]->name;
		size_t length = strlen(name), begin = 0;
		for (size_t j = 0; j < all->n; j++) {
			const char *other = all->spec[j]->name;
			begin +=
			    match[j] && strncmp(other, name, length) == 0 &&
			    (other[length] == '\0' || other[length] == ' ');
		}
		if (!match[i] || begin < n ||
		    !do_words_name_base_envelope(all->spec[i], folded))
			continue;
		memset(match, 0, all->n * sizeof *match);
		match[i] = true;
		return 1;
	}
	return n;
}

size_t
standards_mark_envelopes_named(
    const struct standards *all, const char *words, bool *match)
{
	FREED char *folded = text_fold_case_and_accents(words);
	size_t n = 0, full = 0;
	FREED int *in = xcalloc(all->n + 1, sizeof *in);
	for (size_t i = 0; i < all->n; i++) {
		in[i] = lowest_word_match_score(all->spec[i]->name, folded);
		full += in[i] == 2;
	}
	for (size_t i = 0; i < all->n; i++)
		n += match[i] = in[i] >= (full > 0 ? 2 : 1);
	return n > 1 ? unmark_all_but_base_envelope(all, folded, match, n) : n;
}

static const char *
most_similar_envelope_name(const struct standards *all, const char *words)
{
	const char *best = all->spec[0]->name;
	size_t least = SIZE_MAX;
	FREED char *folded = text_fold_case_and_accents(words);
	for (size_t i = 0; i < all->n; i++) {
		FREED char *name =
		    text_fold_case_and_accents(all->spec[i]->name);
		/* Leaving out the end of a name is not a mistake. */
		if (strlen(name) > strlen(folded))
			name[strlen(folded)] = '\0';
		size_t d = text_edit_distance(name, folded);
		if (d < least) {
			least = d;
			best = all->spec[i]->name;
		}
	}
	return best;
}

const struct spec *
standards_find_envelope(
    const struct standards *all, const char *words, struct error *error)
{
	FREED bool *match = xcalloc(all->n, sizeof *match);
	size_t n = standards_mark_envelopes_named(all, words, match), at = 0;
	while (at < all->n && !match[at])
		at++;
	FREED char *list = xstrdup("");
	for (size_t i = 0; i < all->n && n > 1; i++)
		if (match[i])
			xappend_to_list(&list, ", ", "%s", all->spec[i]->name);
	if (n == 0)
		error_set(error, ERROR_USAGE,
		    "there is no envelope '%s', and no such file\n"
		    "did you mean '%s'? 'spec list' lists them",
		    words, most_similar_envelope_name(all, words));
	else if (n > 1)
		error_set(error, ERROR_USAGE,
		    "'%s' matches %zu envelopes\ngive more of the name: %s",
		    words, n, list);
	return n == 1 ? all->spec[at] : NULL;
}

bool
standards_is_file_path(const char *word)
{
	static const char *const BEGIN[] = {"/", "./", "../", "~"};
	for (size_t i = 0; i < ARRAY_LEN(BEGIN); i++)
		if (strncmp(word, BEGIN[i], strlen(BEGIN[i])) == 0)
			return true;
	return file_has_sheet_ending(word) || file_exists(word);
}

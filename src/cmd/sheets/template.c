/* template: an empty site file to fill in.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <string.h>

#include "base/text.h"
#include "base/xalloc.h"
#include "cmd/session/session.h"
#include "cmd/lang/table.h"
#include "core/psd/psd.h"
#include "io/formats/book.h"

/* Basic set and set 1 of EN 933-2 with its filler sieves, which most
 * laboratories in Europe have. */
static const double SIEVES[] = {
    31.5, 22.4, 16, 11.2, 8, 5.6, 4, 2, 1, 0.5, 0.25, 0.125, 0.063};

static const char *const KEYS[][2] = {{"site", "name of the quarry or plant"},
    {"rock", "rock type"}, {"machine", "make and model of the crusher"},
    {"rotor_mm", "diameter of the rotor, from tip to tip, mm"},
    {"provenance", "who sampled, where and when; results state it"}};

static const char *const WORDS[2][3] = {
    {"what passes each sieve, % of the mass",
	"the coarsest sieve passes 100 % of the feed: all of it must be known",
	""},
    {"what stays on each sieve, g",
	"nothing of the feed stays on the coarsest sieve: all of it must be "
	"known",
	"pan: what passes the finest sieve"}};

struct form {
	char separator;
	FILE *sheet;
};

static void
write_template_remark(const struct form *f, const char *text)
{
	FREED char *line = xasprintf("# %s", text);
	text_write_csv_cell(line, f->separator, f->sheet);
	fputc('\n', f->sheet);
}

/* Writes a row for each sieve, with an empty cell for each column.  Returns the
 * number of rows. */
static size_t
write_template_sieve_rows(
    const struct form *f, const struct number_list *sieves, size_t columns)
{
	size_t n = sieves->n > 0 ? sieves->n : ARRAY_LEN(SIEVES);
	FREED double *mm = xcalloc_doubles(n);
	memcpy(mm, sieves->n > 0 ? sieves->at : SIEVES, n * sizeof *mm);
	n = psd_sort_distinct_sizes(mm, n, 0);
	for (size_t i = 0; i < n; i++) {
		text_write_csv_number(mm[i], f->separator, f->sheet);
		for (size_t c = 0; c < columns; c++)
			fputc(f->separator, f->sheet);
		fputc('\n', f->sheet);
	}
	return n;
}

static size_t
write_sieve_template(const struct form *f, const struct args *args)
{
	const struct number_list *speeds = &args->speeds;
	bool grams = args->unit == 1;
	const char *unit = grams ? "_retained_g" : "";
	write_template_remark(f,
	    "fill in what you have and remove lines that you do not need; "
	    "lines with # are remarks");
	for (size_t i = 0; i < ARRAY_LEN(KEYS); i++) {
		FREED char *text = xasprintf("%s: %s", KEYS[i][0], KEYS[i][1]);
		write_template_remark(f, text);
	}
	for (size_t i = 0; i < ARRAY_LEN(KEYS); i++)
		fprintf(f->sheet, "%s%c\n", KEYS[i][0], f->separator);
	write_template_remark(f,
	    "feed: what goes in; product@69: what comes out at a tip speed "
	    "of 69 m/s");
	write_template_remark(
	    f, "tip speed in m/s = 3.1416 x rotor_mm x rpm / 60000");
	for (size_t i = 0; i < 3; i++)
		if (WORDS[grams][i][0] != '\0')
			write_template_remark(f, WORDS[grams][i]);
	write_template_remark(
	    f, "leave a cell empty where a sieve was not used");
	fprintf(f->sheet, "size_mm%cfeed%s", f->separator, unit);
	for (size_t i = 0; i < speeds->n; i++) {
		fprintf(f->sheet, "%cproduct%s@", f->separator, unit);
		text_write_csv_number(speeds->at[i], f->separator, f->sheet);
	}
	fputc('\n', f->sheet);
	size_t rows =
	    write_template_sieve_rows(f, &args->sieves, speeds->n + 1);
	if (!grams)
		return rows;
	fputs("pan", f->sheet);
	for (size_t c = 0; c <= speeds->n; c++)
		fputc(f->separator, f->sheet);
	fputc('\n', f->sheet);
	return rows + 1;
}

bool
cmd_template(struct session *s, const struct args *args, struct error *error)
{
	FREED char *text = NULL;
	size_t n = 0;
	enum answer_format format = s->set.format;
	if (format == ANSWER_JSON || format == ANSWER_MARKDOWN)
		return error_set(error, ERROR_USAGE,
		    "template makes a site file, which cannot be in %s\n"
		    "write: template > FILE.csv, or template > FILE.xlsx",
		    ANSWER_FORMATS[format].name);
	struct form f = {s->set.semicolon ? ';' : ',', s->out};
	/* In workbooks numbers have no decimal sign. */
	if (s->book != NULL)
		f = (struct form){',', text_open_memory(&text, &n)};
	s->rows += write_sieve_template(&f, args);
	if (s->book == NULL)
		return true;
	fclose(f.sheet);
	book_add_text_worksheet(s->book, "template", text);
	return true;
}

/* What the reader of a sheet passed over.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/site_left_out.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>

#include "base/xalloc.h"
#include "io/sieve_names.h"

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

void
site_left_out(struct site *site, const struct table *t)
{
	tell_left_out(site, t);
	tell_names(site, t);
}

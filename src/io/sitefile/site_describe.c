/* Describes in words how columns were read, grouped by kind.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/sitefile/site_describe.h"

#include <stdlib.h>
#include <string.h>

#include "base/tr.h"
#include "base/xalloc.h"
#include "io/fs/file.h"
#include "io/sitefile/classify.h"
#include "io/sitefile/site_sieve.h"

/* Returns rising numbers, without repeats, as "3", "3, 4" or "3 to 5, 8". */
static char *
numbers_to_ranges_text(const size_t *number, size_t n)
{
	char *text = xstrdup("");
	for (size_t i = 0, last; i < n; i = last + 1) {
		for (last = i;
		     last + 1 < n && number[last + 1] == number[last] + 1;
		     last++)
			;
		if (last < i + 2)
			last = i;
		xappend_to_list(&text, ", ", "%zu", number[i]);
		if (last > i)
			xappend(&text, tr(" to %zu"), number[last]);
	}
	return text;
}

static void
append_number_unless_repeated(size_t *number, size_t *n, size_t next)
{
	if (*n == 0 || number[*n - 1] != next)
		number[(*n)++] = next;
}

/* Appends a description of the samples of a table, grouped by unit. */
static void
describe_samples(const struct table *t, const struct columns *all, char **text)
{
	FREED size_t *number = xcalloc(all->n + 1, sizeof *number);
	size_t n = 0;
	const struct column *before = NULL;
	char *roles = xstrdup("");
	for (size_t i = 0; i <= all->n; i++) {
		const struct column *c = i < all->n ? &all->column[i] : NULL;
		if (c != NULL && (c->table != t || c->twin > 0))
			continue;
		bool ends = before != NULL &&
			    (c == NULL || c->unit != before->unit ||
				(c->role == SD) != (before->role == SD));
		if (ends) {
			FREED char *list = numbers_to_ranges_text(number, n);
			xappend_to_list(text, "; ", tr("%s in %s (%s)"), roles,
			    list,
			    before->role == SD
				? tr("percentage points")
				: tr(SITE_UNITS[before->unit].words));
			xfree_and_set(&roles, xstrdup(""));
			n = 0;
			before = NULL;
		}
		if (c == NULL)
			break;
		FREED char *words = classify_describe_column(c);
		words[strcspn(words, " ")] = '\0';
		const char *at = strchr(words, '@');
		bool again =
		    before != NULL && before->role == c->role && at != NULL;
		xappend_to_list(&roles, ", ", "%s", again ? at : words);
		append_number_unless_repeated(number, &n, t->number[c->at]);
		before = c;
	}
	free(roles);
}

/* Returns the name of a table's file or, if all are in one file, of its sheet;
 * "" if all are on one sheet. */
static const char *
file_or_sheet_name_of_table(struct table *const *table, size_t n, size_t k)
{
	const struct sheet *own = table[k]->sheet;
	for (size_t i = 0; i < n; i++)
		if (strcmp(table[i]->sheet->path, own->path) != 0)
			return file_name_without_folders(own->path);
	for (size_t i = 0; i < n; i++)
		if (table[i]->sheet != own && own->name != NULL)
			return own->name;
	return "";
}

static char *
describe_tables(struct table *const *table, size_t n, const struct columns *all)
{
	char *text = xstrdup("");
	for (size_t k = 0; k < n; k++) {
		const struct table *t = table[k];
		const char *place = file_or_sheet_name_of_table(table, n, k);
		FREED char *own = xstrdup("");
		const struct table *before = table[k > 0 ? k - 1 : 0];
		bool same = before->across == t->across &&
			    before->number[0] == t->number[0] &&
			    before->finest_first == t->finest_first &&
			    strcmp(site_sieve_unit_text(before),
				site_sieve_unit_text(t)) == 0;
		if (k == 0 || !same)
			xappend_to_list(&own, "; ",
			    t->finest_first
				? tr("sieves in %s %zu (%s, finest first)")
				: tr("sieves in %s %zu (%s)"),
			    t->across ? tr("line") : tr("column"), t->number[0],
			    site_sieve_unit_text(t));
		describe_samples(t, all, &own);
		if (own[0] != '\0')
			xappend_to_list(&text, "; ", "%s%s%s", place,
			    place[0] != '\0' ? ": " : "", own);
	}
	return text;
}

/* Appends a note of column i with all columns that have it, unless an earlier
 * column has it, so that it has been appended already. */
static void
append_assumption_once(
    const struct columns *all, size_t i, const char *note, char **text)
{
	FREED size_t *number = xcalloc(all->n + 1, sizeof *number);
	FREED char *line = xasprintf("\n%s\n", note);
	size_t n = 0, has = 0, samples = 0;
	for (size_t k = 0; k < all->n; k++) {
		const struct column *c = &all->column[k];
		samples += c->twin == 0;
		if (c->assumed == NULL || strstr(c->assumed, line) == NULL)
			continue;
		if (k < i)
			return;
		has++;
		append_number_unless_repeated(
		    number, &n, c->table->number[c->at]);
	}
	FREED char *list = numbers_to_ranges_text(number, n);
	bool across = all->column[i].table->across;
	const char *colon = strncmp(note, "as ", 3) == 0 ? "" : ":";
	if (has == samples && has > 1)
		xappend_to_list(
		    text, "; ", tr("all samples%s %s"), colon, note);
	else
		xappend_to_list(text, "; ",
		    across ? tr_n("line %s%s %s", "lines %s%s %s", n)
			   : tr_n("column %s%s %s", "columns %s%s %s", n),
		    list, colon, note);
}

void
site_describe_columns(struct table *const *table, size_t n_table,
    const struct columns *all, struct site *site)
{
	bool own = true;
	for (size_t k = 0; k < n_table; k++) {
		const struct table *t = table[k];
		own = own && t->n_head == 1 && !t->across && t->name == NULL &&
		      !t->finest_first &&
		      strncmp(t->head[0].cell[0].text, "size_", 5) == 0;
	}
	if (!own)
		xfree_and_set(
		    &site->read_as, describe_tables(table, n_table, all));
	for (size_t i = 0; i < all->n; i++) {
		const char *assumed = all->column[i].assumed;
		FREED char *notes = xstrdup(assumed != NULL ? assumed : "");
		char *rest = notes;
		for (char *note; (note = strtok_r(rest, "\n", &rest));)
			append_assumption_once(all, i, note, &site->assumed);
	}
}

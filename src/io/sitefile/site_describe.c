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

/* Returns "3", "3, 4" or "3 to 5, 8" for rising numbers without repeats. */
static char *
numbers_text(const size_t *number, size_t n)
{
	char *text = xstrdup("");
	for (size_t i = 0, last; i < n; i = last + 1) {
		for (last = i;
		     last + 1 < n && number[last + 1] == number[last] + 1;
		     last++)
			;
		if (last < i + 2)
			last = i;
		xlist(&text, ", ", "%zu", number[i]);
		if (last > i)
			xappend(&text, tr(" to %zu"), number[last]);
	}
	return text;
}

static bool
is_own_form(const struct table *t)
{
	return t->n_head == 1 && !t->across && !t->is_long &&
	       !t->finest_first &&
	       strncmp(t->head[0].cell[0].text, "size_", 5) == 0;
}

/* Adds "product@69" or, after another product, only "@79". */
static void
add_role(char **text, const struct column *c, const struct column *before)
{
	FREED char *words = classify_column_text(c);
	words[strcspn(words, " ")] = '\0';
	const char *at = strchr(words, '@');
	bool again = before != NULL && before->role == c->role && at != NULL;
	xlist(text, ", ", "%s", again ? at : words);
}

static void
add_rising_number(size_t *number, size_t *n, size_t next)
{
	if (*n == 0 || number[*n - 1] != next)
		number[(*n)++] = next;
}

/* Describes the samples of a table, grouped by unit. */
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
			FREED char *list = numbers_text(number, n);
			xlist(text, "; ", tr("%s in %s (%s)"), roles, list,
			    before->role == SD
				? tr("percentage points")
				: tr(SITE_UNITS[before->unit].words));
			free(roles);
			roles = xstrdup("");
			n = 0;
			before = NULL;
		}
		if (c == NULL)
			break;
		add_role(&roles, c, before);
		add_rising_number(number, &n, t->number[c->at]);
		before = c;
	}
	free(roles);
}

/* True if a table has its sieves in the same place and unit as the one before
 * it. */
static bool
has_sieves_like(const struct table *a, const struct table *b)
{
	return a->across == b->across && a->number[0] == b->number[0] &&
	       a->finest_first == b->finest_first &&
	       strcmp(site_sieve_unit(a), site_sieve_unit(b)) == 0;
}

/* Returns the file or sheet that distinguishes a table from others; "" if all
 * are on one sheet. */
static const char *
place_of_table(struct table *const *table, size_t n, size_t k)
{
	const struct sheet *own = table[k]->sheet;
	for (size_t i = 0; i < n; i++)
		if (strcmp(table[i]->sheet->path, own->path) != 0)
			return file_name(own->path);
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
		const char *place = place_of_table(table, n, k);
		FREED char *own = xstrdup("");
		if (k == 0 || !has_sieves_like(table[k - 1], t))
			xlist(&own, "; ",
			    t->finest_first
				? tr("sieves in %s %zu (%s, finest first)")
				: tr("sieves in %s %zu (%s)"),
			    t->across ? tr("line") : tr("column"), t->number[0],
			    site_sieve_unit(t));
		describe_samples(t, all, &own);
		if (own[0] != '\0')
			xlist(&text, "; ", "%s%s%s", place,
			    place[0] != '\0' ? ": " : "", own);
	}
	return text;
}

/* Returns the note after the one at `at`, and the length of that one: notes are
 * lines. */
static const char *
next_note(const char *at, size_t *n)
{
	*n = strcspn(at, "\n");
	return at[*n] == '\n' ? at + *n + 1 : at + *n;
}

static bool
has_note(const struct column *c, const char *note, size_t n)
{
	size_t own;
	for (const char *p = c->assumed != NULL ? c->assumed : "";
	     *p != '\0';) {
		const char *next = next_note(p, &own);
		if (own == n && strncmp(p, note, n) == 0)
			return true;
		p = next;
	}
	return false;
}

/* Adds a note with all columns that have it, unless a column before the i-th
 * has it and it has been added. */
static void
add_note(const struct columns *all, size_t i, const char *note, size_t length,
    char **text)
{
	FREED size_t *number = xcalloc(all->n + 1, sizeof *number);
	size_t n = 0, has = 0, samples = 0;
	for (size_t k = 0; k < all->n; k++) {
		const struct column *c = &all->column[k];
		samples += c->twin == 0;
		if (!has_note(c, note, length))
			continue;
		if (k < i)
			return;
		has++;
		add_rising_number(number, &n, c->table->number[c->at]);
	}
	FREED char *list = numbers_text(number, n);
	bool across = all->column[i].table->across;
	const char *colon = strncmp(note, "as ", 3) == 0 ? "" : ":";
	if (has == samples && has > 1)
		xlist(text, "; ", tr("all samples%s %.*s"), colon, (int)length,
		    note);
	else
		xlist(text, "; ",
		    across ? tr_n("line %s%s %.*s", "lines %s%s %.*s", n)
			   : tr_n("column %s%s %.*s", "columns %s%s %.*s", n),
		    list, colon, (int)length, note);
}

void
site_describe(struct table *const *table, size_t n_table,
    const struct columns *all, struct site *site)
{
	bool own = true;
	for (size_t k = 0; k < n_table; k++)
		own = own && is_own_form(table[k]);
	if (!own) {
		free(site->read_as);
		site->read_as = describe_tables(table, n_table, all);
	}
	for (size_t i = 0; i < all->n; i++) {
		const char *p = all->column[i].assumed;
		size_t n;
		while (p != NULL && *p != '\0') {
			const char *next = next_note(p, &n);
			add_note(all, i, p, n, &site->assumed);
			p = next;
		}
	}
}

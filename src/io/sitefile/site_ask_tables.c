/* Lists the tables of a sheet with their titles and lines, and proposes those
 * that are most likely one site.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/sitefile/site_ask_tables.h"

#include <stdlib.h>
#include <string.h>

#include "base/tr.h"
#include "base/xalloc.h"
#include "io/cells/sheet.h"
#include "io/sitefile/site_title.h"

/* Whether a table has nothing but products whose speeds are known. */
static bool
has_products(const struct table *t, const struct columns *all)
{
	size_t products = 0;
	for (size_t i = 0; i < all->n; i++) {
		const struct column *c = &all->column[i];
		if (c->table != t || c->twin > 0)
			continue;
		if (c->role != PRODUCT || !(c->speed > 0 || c->rpm > 0))
			return false;
		products++;
	}
	return products > 0;
}

static bool
tables_have_feed(const struct table *t, const struct columns *all)
{
	for (size_t i = 0; i < all->n; i++)
		if (all->column[i].table == t && all->column[i].role == FEED)
			return true;
	return false;
}

/* Whether table k may be of the site whose feed is in table `feed`; like: a
 * table of products that is, or NULL. */
static bool
is_table_of_site(
    const struct tables *s, size_t k, size_t feed, const struct table *like)
{
	const struct table *t = s->table[k];
	if (!has_products(t, s->all) || title_is_limit(t))
		return false;
	FREED char *line = title_line(s->table[feed]), *own = title_line(t);
	bool same = !title_names_differ(line, own);
	return same && (like == NULL || (!t->strange && !like->strange) ||
			   title_is_like(like, t));
}

void
site_ask_tables_guess(struct tables *s)
{
	size_t feed = 0;
	const struct table *like = NULL;
	while (feed < s->n && !tables_have_feed(s->table[feed], s->all))
		feed++;
	feed = feed < s->n ? feed : 0;
	s->first = s->last = feed;
	if (!tables_have_feed(s->table[feed], s->all))
		return;
	while (s->last + 1 < s->n &&
	       is_table_of_site(s, s->last + 1, feed, like)) {
		s->last++;
		like = s->table[s->last];
	}
	while (s->last == feed && s->first > 0 &&
	       is_table_of_site(s, s->first - 1, feed, like)) {
		s->first--;
		like = s->table[s->first];
	}
}

static void
box_extend(struct site_box *box, const struct row *row, size_t n)
{
	for (size_t r = 0; r < n; r++) {
		int line = row[r].line;
		box->top = box->top == 0 || line < box->top ? line : box->top;
		box->bottom = line > box->bottom ? line : box->bottom;
	}
}

/* The cells of a table, of its first n_row rows; of one whose sieves go across
 * its lines in full. */
static struct site_box
table_box(const struct table *t, size_t n_row)
{
	struct site_box box = {0};
	int least = (int)t->number[0], most = least, wide = 1;
	for (size_t c = 0; c < t->n_col; c++) {
		int number = (int)t->number[c];
		least = number < least ? number : least;
		most = number > most ? number : most;
	}
	if (t->across) {
		for (size_t r = 0; r < t->sheet->n_row; r++)
			if (t->sheet->row[r].n_all > (size_t)wide)
				wide = (int)t->sheet->row[r].n_all;
		return (struct site_box){least, 1, most, wide};
	}
	box_extend(&box, t->head, t->n_head);
	box_extend(&box, t->row, n_row);
	if (n_row == t->n_row)
		box_extend(&box, t->foot, t->n_foot);
	box.left = least;
	box.right = most;
	return box;
}

char *
site_ask_table_range(const struct table *t, size_t n_row)
{
	return site_box_text(table_box(t, n_row));
}

/* "feed, product@69": what a table seems to have. */
static char *
tables_contents(const struct table *t, const struct columns *all)
{
	enum { MOST = 3 };
	size_t n = 0;
	char *list = xstrdup("");
	for (size_t i = 0; i < all->n && !title_is_limit(t); i++) {
		const struct column *c = &all->column[i];
		if (c->table != t || c->twin > 0 || c->role == NO_ROLE)
			continue;
		FREED char *words = recognise_column_text(c);
		words[strcspn(words, " ")] = '\0';
		if (n++ < MOST)
			xlist(&list, ", ", "%s",
			    strstr(words, "@SPEED") != NULL
				? SITE_ROLES[c->role]
				: words);
	}
	if (n > MOST)
		xappend(&list, ", ..");
	if (n == 0)
		xappend(&list, "%s",
		    title_is_limit(t) ? tr("limits or a mean")
				      : tr("not said"));
	return list;
}

void
site_ask_tables_list(const struct tables *s, struct site_ask *ask)
{
	ask->tables = true;
	ask->n = s->n;
	ask->first = s->first;
	ask->last = s->last;
	ask->column = xcalloc(s->n, sizeof *ask->column);
	for (size_t i = 0; i < s->n; i++) {
		const struct table *t = s->table[i];
		struct site_box box = table_box(t, t->n_row);
		FREED char *line = title_line(t);
		ask->column[i] = (struct site_ask_column){.number = i + 1,
		    .head = xstrndup(line, (size_t)sheet_cut_length(line)),
		    .values = xasprintf(tr("%d to %d"), box.top, box.bottom),
		    .guess = tables_contents(t, s->all),
		    .box = box};
	}
	FREED char *range = site_box_text(site_ask_box(ask, s->first, s->last));
	ask->settle = xasprintf("range=%s", range);
}

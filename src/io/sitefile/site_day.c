/* Finds the day on which each sample was taken: in a row of days beside the
 * samples ("Date", "Provtagen"), or in the heading of the sample itself.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/sitefile/site_day.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "base/xalloc.h"
#include "io/cells/datetime.h"
#include "io/sitefile/lexicon.h"

static bool
is_date(const char *text, struct datetime *m)
{
	return datetime_parse(text, m) && m->has_date;
}

/* Returns the only date in a heading, "Cut 2026-05-03, 72 m/s" or "Cut 3 May
 * 2026, 72 m/s"; NULL if there is none, or several.  The caller frees it. */
static char *
only_date_in_heading(const char *heading)
{
	static const char BETWEEN[] = " ,;()[]@\n";
	struct datetime m;
	char *found = NULL;
	for (const char *p = heading; *(p += strspn(p, BETWEEN)) != '\0';) {
		size_t n = strcspn(p, BETWEEN);
		const char *month = p + n + strspn(p + n, " ");
		const char *year = month + strcspn(month, BETWEEN);
		year += strspn(year, " ,");
		size_t last = strcspn(year, BETWEEN);
		FREED char *word = xstrndup(p, n);
		FREED char *words = xstrndup(p, (size_t)(year - p) + last);
		/* "3 May 72 m/s" and "3 May, 2000 rpm" have no year. */
		bool named = last == 4 && is_date(words, &m) &&
			     !text_is_same_but_case(year + 4, " rpm", 4);
		p = named ? year + last : p + n;
		if (!named && !is_date(word, &m))
			continue;
		if (found != NULL) {
			free(found);
			return NULL;
		}
		found = xstrdup(named ? words : word);
	}
	return found;
}

/* Returns a date in the form that a site keeps: "2026-05-03".  A date such as
 * 25/3/2026 is kept as it is, because it shows how to read 5/3/2026 beside
 * it. */
static char *
format_date_for_site(const char *text)
{
	struct datetime m;
	is_date(text, &m);
	if (!m.plain)
		return xstrdup(text);
	char *day =
	    datetime_to_text(datetime_seconds_since_1970(&m, DATETIME_OPEN));
	if (!m.has_time)
		day[strcspn(day, " ")] = '\0';
	return day;
}

/* Takes the day that `text`, a cell of a row, states for a sample: into *stated
 * if the row's label says that it is the day of sampling, else into *other.  If
 * two days differ, "" is kept. */
static void
parse_day_in_cell(
    char **stated, char **other, const struct row *row, const char *text)
{
	struct datetime m;
	bool whole = is_date(text, &m);
	FREED char *word = whole ? xstrdup(text) : only_date_in_heading(text);
	enum lexicon_day label = lexicon_day_kind_of_label(row->cell[0].text);
	if (word == NULL || (whole && label == DAY_OTHER))
		return;
	char *day = format_date_for_site(word);
	char **slot = whole && label == DAY_SAMPLED ? stated : other;
	if (*slot != NULL && strcmp(*slot, day) != 0)
		day[0] = '\0';
	xfree_and_set(slot, day);
}

char *
site_day_of_sample(const struct table *t, size_t c)
{
	FREED char *stated = NULL, *other = NULL;
	struct datetime m;
	if (t->day != NULL && t->day[c] != NULL && is_date(t->day[c], &m))
		return format_date_for_site(t->day[c]);
	for (size_t r = 0; r < t->n_head; r++) {
		const struct cell *cell = &t->head[r].cell[c];
		/* A day spreads to the right; but an empty cell below one may
		 * mean the same day, or have been forgotten. */
		while (!t->across && cell > &t->head[r].cell[1] &&
		       cell->text[0] == '\0')
			cell--;
		parse_day_in_cell(&stated, &other, &t->head[r], cell->text);
	}
	for (size_t r = 0; r < t->n_foot; r++)
		if (lexicon_is_date_label(t->foot[r].cell[0].text))
			parse_day_in_cell(&stated, &other, &t->foot[r],
			    t->foot[r].cell[c].text);
	const char *first = stated != NULL ? stated : other;
	return first != NULL && first[0] != '\0' ? xstrdup(first) : NULL;
}

/* True for a heading with a word such as 17/11-26, which may be a date. */
static bool
has_word_like_date(const char *heading)
{
	for (const char *p = heading; *p != '\0'; p += *p != '\0') {
		char sign[4] = "";
		size_t parts = 0, n;
		while ((n = strspn(p, "0123456789")) > 0) {
			parts += n < 5;
			p += n;
			if (*p == '\0' || strchr("./-", *p) == NULL)
				break;
			sign[parts < 3 ? parts : 3] = *p++;
		}
		/* "8/11.2" and "0.063-2" are fractions. */
		if (parts == 3 &&
		    (sign[1] == sign[2] || (sign[1] == '/' && sign[2] == '-')))
			return true;
	}
	return false;
}

const char *
site_find_unreadable_day(const struct table *t, size_t c)
{
	struct datetime m;
	if (t->day != NULL && t->day[c] != NULL && !is_date(t->day[c], &m))
		return t->day[c];
	for (size_t r = 0; r < t->n_head + t->n_foot; r++) {
		const struct row *row =
		    r < t->n_head ? &t->head[r] : &t->foot[r - t->n_head];
		const char *text = row->cell[c].text;
		if (lexicon_is_date_label(row->cell[0].text) &&
		    strpbrk(text, "0123456789") != NULL && !is_date(text, &m))
			return text;
	}
	FREED char *day = site_day_of_sample(t, c);
	for (size_t r = 0; r < t->n_head && day == NULL; r++)
		if (has_word_like_date(t->head[r].cell[c].text))
			return t->head[r].cell[c].text;
	return NULL;
}

const char *
site_unreadable_day_of_line(const struct row *row)
{
	struct datetime m;
	const char *text = row_cell_at(row, 1).text;
	return row->n == 2 && lexicon_is_date_label(row->cell[0].text) &&
		       strpbrk(text, "0123456789") != NULL && !is_date(text, &m)
		   ? text
		   : NULL;
}

/* True if the cells of a column that are not empty have dates; any: texts that
 * are no numbers. */
static bool
is_column_of_dates(const struct table *t, size_t c, bool any)
{
	size_t n = 0;
	struct datetime m;
	for (size_t r = 0; r < t->n_row; r++) {
		const struct cell *cell = &t->row[r].cell[c];
		if (cell->value == AS_ABSENT)
			continue;
		if (any ? cell->value != AS_NONE : !is_date(cell->text, &m))
			return false;
		n++;
	}
	return n > 0;
}

/* Returns the column of dates with the best label, or 0; any: of texts whose
 * label says that they are dates. */
static size_t
find_day_column(const struct table *t, bool any)
{
	enum lexicon_day best = any ? DAY_ANY : DAY_OTHER;
	size_t found = 0;
	for (size_t c = 1; c < t->n_col; c++) {
		FREED char *label = layout_column_heading_text(t, c);
		enum lexicon_day own = lexicon_day_kind_of_label(label);
		if (own < best || own == DAY_OTHER ||
		    !is_column_of_dates(t, c, any))
			continue;
		/* Of two equally good labels, neither is used. */
		found = own > best || (any && found == 0) ? c : 0;
		best = own;
	}
	return found;
}

size_t
site_day_column(const struct table *t)
{
	size_t found = find_day_column(t, false);
	return found > 0 ? found : find_day_column(t, true);
}

char *
site_day_range_text(char *const *day, size_t n)
{
	enum datetime_order order = DATETIME_OPEN;
	struct datetime m;
	double from = INFINITY, to = -INFINITY;
	for (size_t i = 0; i < n; i++)
		if (day[i] != NULL && is_date(day[i], &m) && !m.plain &&
		    m.order != DATETIME_OPEN)
			order = m.order;
	for (size_t i = 0; i < n; i++) {
		if (day[i] == NULL || !is_date(day[i], &m))
			continue;
		double time = datetime_seconds_since_1970(&m, order);
		if (isnan(time))
			return NULL;
		from = fmin(from, time);
		to = fmax(to, time);
	}
	if (from > to)
		return NULL;
	FREED char *first = datetime_to_text(from),
		   *last = datetime_to_text(to);
	first[strcspn(first, " ")] = last[strcspn(last, " ")] = '\0';
	return strcmp(first, last) == 0 ? xstrdup(first)
					: xasprintf("%s to %s", first, last);
}

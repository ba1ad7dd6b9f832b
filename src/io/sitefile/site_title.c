/* Reads the lines immediately above each table for its sample and speed.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/sitefile/site_title.h"

#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "base/xalloc.h"
#include "io/cells/datetime.h"
#include "io/sitefile/column_header.h"
#include "io/sitefile/lexicon.h"
#include "io/sitefile/site_heading.h"

/* True if a heading states which sample a table has: a role or a speed. */
static bool
is_title_of_sample(const struct head *head)
{
	return (head->means & (WORD_FEED | WORD_PRODUCT)) != 0 ||
	       heading_has_speed(head);
}

/* True if cell c of a line is the value in "Sample; Feed". */
static bool
is_value_of_sample_key(const struct row *row, size_t c)
{
	size_t first = 0, unknown;
	while (first < c && row->cell[first].text[0] == '\0')
		first++;
	uint64_t means = lexicon_text_meanings(row->cell[first].text, &unknown);
	struct head value = heading_parse(row->cell[c].text);
	return first < c && (means & ~WORD_NUMBER) == WORD_SAMPLE &&
	       unknown == 0 && is_title_of_sample(&value);
}

/* True if cell c of a line may be a title: it is the only one, or the line is a
 * key for a sample and its value.  It stops at a third one, as lines can have
 * thousands. */
static bool
can_be_title_cell(const struct row *row, size_t c)
{
	size_t filled = 0, end = row->cell[c].text[0] != '\0' ? row->n : 0;
	for (size_t i = 0; i < end && filled <= 2; i++)
		filled += (size_t)(row->cell[i].text[0] != '\0');
	return filled == 1 || (filled == 2 && is_value_of_sample_key(row, c));
}

/* True if a line is above a table and below the tables before it. */
static bool
is_line_above_table(const struct table *t, const struct row *row)
{
	return !t->across && row->line < layout_first_line_of_table(t) &&
	       row->line > t->after;
}

/* True if cell c of a line may be part of a table's title: it is within three
 * lines above the table and, if the line has more cells, over its columns; or
 * it is further above and the only cell of its line, such as "Product, 67 m/s"
 * over the date of a sample.  It is not a key with its value. */
static bool
can_be_table_title(const struct table *t, const struct row *row, size_t c)
{
	int first = layout_first_line_of_table(t);
	bool near = row->line < first && row->line >= first - 3 &&
		    (row->n == 1 || (c + 1 >= t->left && c + 1 < t->end));
	return lexicon_site_key_of_text(row->cell[0].text) == N_KEY &&
	       (near ||
		   (can_be_title_cell(row, c) && is_line_above_table(t, row)));
}

const struct table *
title_find_table_below_line(const struct layout *layout, const struct row *row)
{
	for (size_t b = 0; b < layout->n; b++)
		if (is_line_above_table(&layout->table[b], row))
			return &layout->table[b];
	return NULL;
}

char *
title_find_day(const struct layout *layout, const struct table *t, char *before,
    bool *differ)
{
	char *day = before;
	for (size_t i = 0; i < layout->n_heading; i++) {
		const struct row *row = layout->heading[i];
		bool asked = t == NULL || is_line_above_table(t, row);
		FREED char *own = asked ? site_heading_date_of_line(row) : NULL;
		if (own != NULL && day == NULL)
			day = xstrdup(own);
		*differ = *differ || (own != NULL && strcmp(own, day) != 0);
	}
	return day;
}

/* Adds cell c of a line to a table's title if it may be one. */
static void
append_cell_to_table_title(
    struct table *t, const struct row *row, size_t c, const struct head *title)
{
	if (!can_be_title_cell(row, c))
		return;
	xappend_to_list(&t->title, "\n", "%s", row->cell[c].text);
	t->strange =
	    t->strange || title->unknown > 0 ||
	    (title->means & (WORD_LIMIT | WORD_MEAN | WORD_MACHINE)) != 0;
}

/* Takes the speed that a line above a table states with a key, "tip speed; 70".
 * Returns false if there is none. */
static bool
read_speed_above_table(const struct layout *layout, const struct table *t,
    struct heading_speed *speed)
{
	bool found = false;
	for (size_t i = 0; i < layout->n_heading; i++)
		if (is_line_above_table(t, layout->heading[i]) &&
		    site_heading_speed_of_line(
			t->sheet, layout->heading[i], speed))
			found = layout->read[i] = true;
	return found;
}

bool
title_has_speed_per_table(const struct layout *layout)
{
	struct heading_speed speed = {0};
	for (size_t b = 1; b < layout->n; b++)
		if (read_speed_above_table(layout, &layout->table[b], &speed))
			return true;
	return false;
}

/* What a title may say about all numbers below it. */
static const uint64_t BASIS_WORDS = WORD_PASSES | WORD_STAYS | WORD_SUMS |
				    WORD_PERCENT | WORD_GRAMS | WORD_SHARE |
				    WORD_MASS;

/* True if words say what numbers are: "% passing", "percent retained", "masses
 * in g". */
static bool
do_words_state_column_quantity(uint64_t means)
{
	bool passes = (means & WORD_PASSES) != 0;
	bool stays = (means & WORD_STAYS) != 0;
	uint64_t unit = means & (WORD_PERCENT | WORD_GRAMS | WORD_SHARE);
	if (unit == WORD_PERCENT)
		return passes != stays;
	return unit == WORD_GRAMS && !passes &&
	       (stays || (means & WORD_MASS) != 0);
}

/* Sets t->basis from the lines of a table's title.  A line with a number, "mass
 * of sample 2000 g", "36 % passing", does not say what all numbers are, but it
 * may contradict a line that does. */
static void
set_table_quantity_from_title(struct table *t)
{
	static const uint64_t ELSE = WORD_LIMIT | WORD_MEAN | WORD_SD |
				     WORD_LOSS | WORD_WEIGHED | WORD_TOTAL |
				     WORD_PAN;
	uint64_t all = 0;
	bool stated = false;
	for (const char *p = t->title; *p != '\0';) {
		size_t n = strcspn(p, "\n");
		FREED char *line = xstrndup(p, n);
		FREED char *bare = heading_without_speeds(line);
		uint64_t means = lexicon_text_meanings(line, NULL);
		all |= means & BASIS_WORDS;
		stated = stated || (do_words_state_column_quantity(means) &&
				       (means & ELSE) == 0 &&
				       strpbrk(bare, "0123456789") == NULL);
		p += n + (size_t)(p[n] == '\n');
	}
	t->basis = stated && do_words_state_column_quantity(all) ? all : 0;
}

/* True if a name can tell one sample from others: S1, Prov A, Berga. */
static bool
is_name_telling_samples_apart(const char *name)
{
	size_t unknown;
	lexicon_text_meanings(name, &unknown);
	const char *last = strrchr(name, ' ');
	last = last != NULL ? last + 1 : name;
	return unknown > 0 || strpbrk(name, "0123456789") != NULL ||
	       strlen(last) == 1;
}

/* Splits a line, "S2: product at 65 m/s" or "S2 | product | 65 m/s", into the
 * name of a sample and what is said about it.  Returns false if it has no such
 * parts.  The caller frees both in either case. */
static bool
split_line_at_sample_name(const struct row *row, char **name, char **said)
{
	const char *text = row->cell[0].text;
	size_t n = strcspn(text, ":=");
	*said = xstrdup(text[n] != '\0' ? text + n + 1 : "");
	FREED char *before = xstrndup(text, n);
	*name = xstrdup(text_trim(before));
	for (size_t c = 1; c < row->n; c++)
		if (row->cell[c].text[0] != '\0')
			xappend_to_list(said, " ", "%s", row->cell[c].text);
	return (*said)[0] != '\0' && is_name_telling_samples_apart(*name);
}

/* Returns the only heading of a table that is this name and says less than
 * `said`; NULL if there is none, or several. */
static struct cell *
find_heading_by_sample_name(
    struct table *t, const char *name, const struct head *said)
{
	struct cell *found = NULL;
	for (size_t r = 0; r < t->n_head; r++)
		for (size_t c = 1; c < t->n_col; c++) {
			struct cell *cell = &t->head[r].cell[c];
			if (!text_is_same_folded(cell->text, name))
				continue;
			if (found != NULL)
				return NULL;
			found = cell;
		}
	if (found == NULL)
		return NULL;
	struct head own = heading_parse(found->text);
	bool role = (own.means & (WORD_FEED | WORD_PRODUCT)) != 0;
	return heading_has_speed(&own) || (role && !heading_has_speed(said))
		   ? NULL
		   : found;
}

void
title_move_lines_to_headings(struct layout *layout)
{
	size_t n = 0;
	for (size_t i = 0; i < layout->n_heading; i++) {
		const struct row *row = layout->heading[i];
		FREED char *name = NULL, *said = NULL;
		bool key = split_line_at_sample_name(row, &name, &said),
		     taken = false;
		struct head head = heading_parse(said);
		key = key && is_title_of_sample(&head) && !head.several;
		for (size_t b = 0; b < layout->n && key; b++) {
			struct table *t = &layout->table[b];
			struct cell *cell =
			    find_heading_by_sample_name(t, name, &head);
			taken = taken || cell != NULL;
			if (cell != NULL)
				cell->text = layout_adopt_text(
				    t, xasprintf("%s %s", cell->text, said));
		}
		if (!taken)
			layout->heading[n++] = row;
	}
	layout->n_heading = n;
}

/* Takes the lines that are a table's title, and returns the role that they
 * state, or 0.  If they state several speeds, each is that of one sample.  The
 * highest or lowest speed of a machine is not that of a sample. */
static uint64_t
read_table_title_lines(
    const struct layout *layout, struct table *t, struct heading_speed *speed)
{
	uint64_t stated = 0;
	for (size_t i = 0; i < layout->n_heading; i++) {
		const struct row *row = layout->heading[i];
		bool read = false;
		for (size_t c = 0; c < row->n; c++) {
			if (!can_be_table_title(t, row, c))
				continue;
			struct head title = heading_parse(row->cell[c].text);
			if (!read)
				append_cell_to_table_title(t, row, c, &title);
			/* A further speed shows that each is of one sample. */
			if (read ? !heading_has_speed(&title)
				 : !is_title_of_sample(&title))
				continue;
			uint64_t role =
			    title.means & (WORD_FEED | WORD_PRODUCT);
			stated = role != 0 ? role : stated;
			if (heading_has_speed(&title) && !title.several &&
			    (title.means & WORD_LIMIT) == 0) {
				site_heading_record_speed(
				    speed, title.speed, title.rpm);
				/* rpm below m/s may be of another sample */
				speed->mps = speed->differ ? 0 : title.speed;
				speed->rpm = speed->differ ? 0 : title.rpm;
			}
			layout->read[i] = read = true;
		}
	}
	return stated;
}

uint64_t
title_read_role_and_speed(const struct layout *layout, struct table *t,
    const char *path, struct surroundings *near)
{
	uint64_t means = lexicon_text_meanings(t->sheet->name, NULL);
	struct head name = heading_parse_file_name(t->sheet->name);
	struct heading_speed own = {0}, says = {0};
	if (read_speed_above_table(layout, t, &own)) {
		near->speed = own.mps;
		near->rpm = own.rpm;
	}
	if (!(near->speed > 0)) {
		near->speed = name.speed;
		near->rpm = name.rpm > 0 ? name.rpm : near->rpm;
	}
	uint64_t role = read_table_title_lines(layout, t, &says);
	means = role != 0 ? role : means;
	if (says.mps > 0 || says.rpm > 0 || says.differ) {
		near->speed = says.mps;
		near->rpm = says.rpm;
	}
	if (says.differ)
		means &= ~(uint64_t)(WORD_FEED | WORD_PRODUCT);
	set_table_quantity_from_title(t);
	if ((means & (WORD_FEED | WORD_PRODUCT)) == 0 && !says.differ) {
		FREED char *stem = site_heading_name_from_path(path);
		means |= lexicon_text_meanings(stem, NULL);
	}
	return means;
}

char *
title_feed_or_last_line(const struct table *t)
{
	for (const char *p = t->title;;) {
		size_t n = strcspn(p, "\n");
		char *line = xstrndup(p, n);
		if (p[n] == '\0' ||
		    (lexicon_text_meanings(line, NULL) & WORD_FEED) != 0)
			return line;
		free(line);
		p += n + 1;
	}
}

/* Returns as many of the last lines of a title as another title has.  The lines
 * above the first table may also include some that are about all tables. */
static const char *
title_tail_as_long_as_other(const char *title, const char *other)
{
	size_t n = 1;
	for (const char *p = other; (p = strchr(p, '\n')) != NULL; p++)
		n++;
	const char *from = title + strlen(title);
	while (from > title && (from[-1] != '\n' || --n > 0))
		from--;
	return from;
}

bool
title_differs_only_in_speed(const struct table *a, const struct table *b)
{
	FREED char *one = heading_without_speeds(
	    title_tail_as_long_as_other(a->title, b->title));
	FREED char *other = heading_without_speeds(b->title);
	return strcmp(one, other) == 0;
}

bool
title_mentions_limits_or_mean(const struct table *t)
{
	return (heading_parse(t->title).means & (WORD_LIMIT | WORD_MEAN)) != 0;
}

/* True if a table's only sample c is a product whose speed is known, and the
 * title speaks of a single sample. */
static bool
has_one_product_with_speed(const struct table *t, const struct column *c)
{
	struct head head = heading_parse(t->title);
	bool speed = heading_has_speed(&head) || c->speed > 0 || c->rpm > 0;
	return c->role == PRODUCT && !c->said.several && speed &&
	       !head.several && !title_mentions_limits_or_mean(t);
}

/* True if the product of table k has the same title as the products before it,
 * but another speed. */
static bool
is_same_title_other_speed(
    struct table *const *table, size_t k, const struct columns *all)
{
	const struct column *own =
	    site_column_samples_of_table(all, table[k]).only;
	for (size_t i = 0; i < k; i++) {
		const struct column *c =
		    site_column_samples_of_table(all, table[i]).only;
		if (c->role == PRODUCT &&
		    (!title_differs_only_in_speed(table[i], table[k]) ||
			(c->speed == own->speed && c->rpm == own->rpm)))
			return false;
	}
	return true;
}

/* True if there are two tables, one with the feed and the other with all
 * products, and no name in their titles contradicts that. */
static bool
is_pair_of_feed_and_products(
    struct table *const *table, size_t n, const struct columns *all)
{
	for (size_t k = 0; k < 2 && n == 2; k++) {
		const struct column *feed =
		    site_column_samples_of_table(all, table[k]).only;
		struct table_samples other =
		    site_column_samples_of_table(all, table[1 - k]);
		if (feed != NULL && feed->role == FEED && !(feed->speed > 0) &&
		    other.products && !other.open)
			return !title_mentions_limits_or_mean(table[0]) &&
			       !title_mentions_limits_or_mean(table[1]) &&
			       !heading_names_differ(
				   table[0]->title, table[1]->title);
	}
	return false;
}

bool
titles_are_speed_series(
    struct table *const *table, size_t n, const struct columns *all, bool parts)
{
	if (is_pair_of_feed_and_products(table, n, all))
		return true;
	const struct table *feed = NULL;
	for (size_t k = 0; k < n; k++) {
		const struct column *c =
		    site_column_samples_of_table(all, table[k]).only;
		if (c == NULL || table[k]->sheet != table[0]->sheet)
			return false;
		bool is_feed = c->role == FEED && !(c->speed > 0);
		if (is_feed ? feed != NULL
			    : !has_one_product_with_speed(table[k], c) ||
				  !is_same_title_other_speed(table, k, all))
			return false;
		feed = is_feed ? table[k] : feed;
	}
	if (feed == NULL)
		return parts;
	if (title_mentions_limits_or_mean(feed))
		return false;
	FREED char *line = title_feed_or_last_line(feed);
	for (size_t k = 0; k < n; k++)
		if (table[k] != feed &&
		    heading_names_differ(line, table[k]->title))
			return false;
	return true;
}

/* Returns the folded text without what may differ from test to test: speeds,
 * dates, the number after "test", and default names of sheets.  c: the product
 * of the test.  The caller frees it. */
static char *
strip_text_to_test_run_name(const char *text, const struct column *c)
{
	static const char *const COUNTED[] = {"ark", "blad", "feuil", "hoja",
	    "prov", "run", "sheet", "tabelle", "test", "trial", "versuch"};
	FREED char *from = heading_without_speeds(text);
	char *name = xstrdup("");
	bool counts = false;
	for (const char *p = from; *p != '\0';) {
		size_t n = strcspn(p, " ,;:()[]@\n_");
		size_t letters = strcspn(p, "0123456789");
		letters = letters < n ? letters : n;
		bool date = strspn(p, "0123456789-./") == n && n >= 6;
		bool number = strspn(p, "0123456789") == n;
		bool named = false;
		for (size_t i = 0; i < ARRAY_LEN(COUNTED); i++)
			named =
			    named || (strlen(COUNTED[i]) == letters && n > 0 &&
					 strncmp(p, COUNTED[i], letters) == 0);
		/* as in P72 */
		char *end;
		double v = strtod(p + letters, &end);
		bool speed =
		    end > p + letters && (v == c->speed || v == c->rpm);
		size_t kept = speed ? letters : n;
		if (kept > 0 && !date && !named && !(number && counts))
			xappend_to_list(&name, " ", "%.*s", (int)kept, p);
		counts = n > 0 ? named : counts;
		p += n + (p[n] != '\0');
	}
	return name;
}

static bool
has_same_test_name(const char *a, const struct column *first, const char *b,
    const struct column *c)
{
	FREED char *one = strip_text_to_test_run_name(a, first),
		   *other = strip_text_to_test_run_name(b, c);
	return strcmp(one, other) == 0;
}

/* Returns the product of a table that has one product and one feed, or NULL. */
static const struct column *
only_product_column_of_table(const struct columns *all, const struct table *t)
{
	struct table_samples s = site_column_samples_of_table(all, t);
	bool test =
	    s.n == 2 && !s.open && s.feed != NULL && !(s.feed->speed > 0);
	return test ? s.product : NULL;
}

bool
titles_are_separate_tests(
    struct table *const *table, size_t n, const struct columns *all)
{
	for (size_t k = 0; k < n; k++) {
		const struct table *t = table[k], *first = table[0];
		const struct column *c = only_product_column_of_table(all, t);
		const struct column *one =
		    only_product_column_of_table(all, first);
		if (c == NULL || one == NULL || !(c->speed > 0 || c->rpm > 0) ||
		    title_mentions_limits_or_mean(t) ||
		    (!has_same_test_name(
			 first->sheet->name, one, t->sheet->name, c) &&
			!(datetime_is_day_in_words(first->sheet->name) &&
			    datetime_is_day_in_words(t->sheet->name))) ||
		    !has_same_test_name(
			title_tail_as_long_as_other(first->title, t->title),
			one, t->title, c))
			return false;
		for (size_t i = 0; i < k; i++) {
			const struct column *other =
			    only_product_column_of_table(all, table[i]);
			if (c->speed == other->speed && c->rpm == other->rpm)
				return false;
		}
	}
	return n > 1;
}

/* Words the questions that a sheet leaves open, and proposes answers in the
 * form of options of load.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/sitefile/site_ask.h"

#include <math.h>
#include <stdarg.h>
#include <string.h>

#include "base/text.h"
#include "base/tr.h"
#include "base/xalloc.h"
#include "io/fs/file.h"
#include "io/sitefile/classify.h"
#include "io/sitefile/column_header.h"
#include "io/sitefile/site_samples.h"
#include "io/sitefile/site_sieve.h"
#include "io/sitefile/site_title.h"
#include "io/sitefile/lexicon.h"
#include "io/cells/number.h"

void
site_ask_find_ambiguous_number(struct open *open, const struct table *t)
{
	if (t->sheet->open.text == NULL || open->number.text != NULL)
		return;
	for (size_t r = 0; r < t->n_row; r++)
		for (size_t c = 0; c < t->n_col; c++)
			if (number_is_ambiguous(t->sheet, t->row[r].cell[c])) {
				open->number = t->row[r].cell[c];
				return;
			}
}

/* Returns the first filled cells of a column: "100 97.8 92.9". */
static char *
first_cells_of_column_text(const struct table *t, size_t at)
{
	char *list = xstrdup("");
	for (size_t r = 0, n = 0; r < t->n_row && n < 4; r++) {
		const char *text = t->row[r].cell[at].text;
		if (text[0] == '\0')
			continue;
		xappend_to_list(&list, " ", "%.*s",
		    sheet_truncated_text_length(text), text);
		n++;
	}
	return list;
}

/* Returns the name that the sheet gives a sample or, if no heading names
 * samples, the lowest heading of its column. */
static const char *
sample_name_or_heading(const struct column *c)
{
	const struct cell *name = samples_name_of_column(c->table, c->at);
	return name != NULL ? name->text : c->head.text;
}

static void
add_column_to_question(struct site_ask *ask, const struct table *t, size_t at,
    const char *head, char *guess, bool open)
{
	ask->column = xrealloc(ask->column, ask->n + 1, sizeof *ask->column);
	ask->column[ask->n++] = (struct site_ask_column){
	    .number = t->number[at],
	    .head = xstrndup(head, (size_t)sheet_truncated_text_length(head)),
	    .values = first_cells_of_column_text(t, at),
	    .guess = guess,
	    .open = open};
}

/* True if it is better to ask for samples by name than by column: in a long
 * table, whose columns have no numbers of their own, or if there are many
 * samples. */
static bool
is_better_asked_by_sample(
    struct table *const *table, size_t n_table, const struct columns *all)
{
	enum { FEW = 6 };
	const struct table *t = table[0];
	size_t unknown = 0;
	for (size_t i = 0; i < all->n; i++) {
		const struct column *c = &all->column[i];
		unknown += c->twin == 0 && c->role != FEED && !(c->speed > 0);
	}
	if (n_table > 1 || (t->name == NULL && unknown <= FEW) ||
	    !samples_have_distinct_names(t))
		return false;
	for (size_t i = 0; i < all->n; i++) {
		FREED char *label =
		    samples_label_of_column(t, all->column[i].at);
		if (label[0] == '\0' || strpbrk(label, "\",=") != NULL)
			return false;
	}
	return true;
}

/* True if each table has one sample and is alone on a sheet with a name of its
 * own, so that the names of the sheets tell the samples apart. */
static bool
do_sheet_names_identify_samples(
    struct table *const *table, size_t n_table, const struct columns *all)
{
	for (size_t k = 0; k < n_table; k++) {
		const char *name = samples_sheet_label(table[k]->sheet);
		if (site_column_samples_of_table(all, table[k]).n != 1 ||
		    strpbrk(name, "\",=") != NULL)
			return false;
		for (size_t i = 0; i < k; i++)
			if (text_is_same_folded(
				samples_sheet_label(table[i]->sheet), name))
				return false;
	}
	return n_table > 1;
}

/* Describes what a column seems to be.  If there is no feed yet (*feed), the
 * first column without a role is called the feed, and *feed set. */
static char *
describe_guessed_role(const struct column *c, bool *feed)
{
	char *words = classify_describe_column(c);
	if (*feed || c->role != NO_ROLE)
		return words;
	*feed = true;
	FREED char *role = words;
	return xasprintf("feed%s", role + strcspn(role, " "));
}

/* Returns false if two samples are known to come from different sites or
 * machines. */
static bool
can_be_of_same_site(const struct column *a, const struct column *b)
{
	return a->whose == NULL || b->whose == NULL ||
	       text_is_same_folded(a->whose, b->whose);
}

static void
add_sieve_column_to_question(
    struct site_ask *ask, const struct table *t, bool open)
{
	char *sieve = xasprintf(tr("sieve %s"), site_sieve_unit_text(t));
	add_column_to_question(
	    ask, t, 0, site_sieve_heading_cell(t).text, sieve, open);
}

/* True if tables on one sheet have the same columns, and their titles say which
 * sample each is.  Then one columns= can say for all what the numbers are. */
static bool
do_titles_name_samples(
    struct table *const *table, size_t n_table, const struct columns *all)
{
	static const uint64_t ROLES = WORD_FEED | WORD_PRODUCT | WORD_SD;
	bool same = n_table > 1;
	for (size_t k = 1; k < n_table && same; k++) {
		same = table[k]->sheet == table[0]->sheet &&
		       table[k]->n_col == table[0]->n_col;
		for (size_t c = 0; c < table[0]->n_col && same; c++)
			same = table[k]->number[c] == table[0]->number[c];
	}
	for (size_t i = 0; i < all->n && same; i++) {
		const struct column *c = &all->column[i];
		same = c->twin > 0 ||
		       ((c->said.means & ROLES) == 0 &&
			   !heading_has_speed(&c->said) && c->role != NO_ROLE);
	}
	return same;
}

/* Lists the columns of a table with their quantities.  If one of them is
 * certain, open columns get "-" and are left out of the proposed answer. */
static void
add_column_quantities_to_question(
    struct site_ask *ask, const struct table *t, const struct columns *all)
{
	size_t sure = 0;
	for (size_t i = 0; i < all->n; i++)
		sure += all->column[i].table == t && !all->column[i].open &&
			all->column[i].twin == 0;
	add_sieve_column_to_question(ask, t, false);
	FREED char *text =
	    xasprintf("%zu=%s", t->number[0], ask->column[0].guess);
	for (size_t i = 0; i < all->n; i++) {
		const struct column *c = &all->column[i];
		if (c->table != t || c->twin > 0)
			continue;
		FREED char *words = classify_describe_column(c);
		bool out = c->open && sure > 0;
		char *guess = xstrdup(out ? "-" : strchr(words, ' ') + 1);
		if (!out)
			xappend_to_list(
			    &text, ", ", "%zu=%s", t->number[c->at], guess);
		add_column_to_question(
		    ask, t, c->at, c->head.text, guess, c->open);
	}
	ask->settle = xasprintf("columns=\"%s\"", text);
}

/* Lists the columns in the words of columns=, or of samples= if it is better to
 * ask by sample or sheet.  Of many samples, the first two show how to name all.
 * If there are several sites, the first is proposed. */
static void
list_columns_to_ask_about(struct site_ask *ask, struct table *const *table,
    size_t n_table, const struct columns *all, bool sieves)
{
	enum { SHOWN = 2 };
	bool by_sheet = do_sheet_names_identify_samples(table, n_table, all);
	bool by_sample =
	    by_sheet || is_better_asked_by_sample(table, n_table, all);
	bool feed = site_column_count_by_role(all, NULL, FEED) > 0;
	FREED char *text = xstrdup("");
	const struct column *own = NULL;
	size_t shown = 0;
	ask->by_sample = by_sample;
	for (size_t k = 0; k < n_table; k++) {
		const struct table *t = table[k];
		ask->across = t->across && !by_sample;
		if (!by_sample || k == 0)
			add_sieve_column_to_question(ask, t, sieves);
		if (!by_sample)
			xappend_to_list(&text, ", ", "%zu=%s", t->number[0],
			    ask->column[ask->n - 1].guess);
		for (size_t i = 0; i < all->n; i++) {
			const struct column *c = &all->column[i];
			if (c->table != t || c->twin > 0)
				continue;
			char *guess = describe_guessed_role(c, &feed);
			/* the sheet's headings state the quantity */
			if (by_sheet)
				guess[strcspn(guess, " ")] = '\0';
			FREED char *name =
			    by_sheet    ? xstrdup(samples_sheet_label(t->sheet))
			    : by_sample ? samples_label_of_column(t, c->at)
					: xasprintf("%zu", t->number[c->at]);
			const char *at = by_sample ? strchr(guess, '@') : NULL;
			own = own != NULL || c->whose == NULL ? own : c;
			bool mine = own == NULL || can_be_of_same_site(own, c);
			if (mine && (!by_sample || by_sheet || shown++ < SHOWN))
				xappend_to_list(&text, ", ", "%s=%s", name,
				    at != NULL ? at : guess);
			add_column_to_question(ask, t, c->at,
			    by_sample ? name : sample_name_or_heading(c), guess,
			    c->open);
		}
	}
	FREED char *settle =
	    xasprintf("%s=\"%s\"", by_sample ? "samples" : "columns", text);
	if (by_sample && sieves)
		ask->settle = xasprintf("columns=\"%zu=%s\" %s",
		    ask->column[0].number, ask->column[0].guess, settle);
	else
		ask->settle = xstrdup(settle);
}

/* Returns the command that loads the files with the answer, and the options of
 * the request that it does not replace.  If a sheet is read only for its feed,
 * its command does not have these options, so the sheet is loaded and written
 * anew. */
static char *
load_command_text_with_answer(const struct site_request *q, const char *settle)
{
	FREED char *list = xstrdup("");
	struct site_request rest = *q;
	for (size_t i = 0; i < q->n; i++) {
		FREED char *word = site_request_file_text(q, i);
		bool quote = strpbrk(word, " \t;#'|>") != NULL;
		xappend_to_list(&list, " ", "%s%s%s", quote ? "\"" : "", word,
		    quote ? "\"" : "");
	}
	if (strncmp(settle, "columns", 7) == 0)
		rest.columns = NULL;
	if (strstr(settle, "samples=") != NULL)
		rest.samples = NULL;
	FREED char *options = site_request_options_text(&rest);
	char *line = xasprintf(
	    "%s %s%s %s", q->parts ? "add" : "load", list, options, settle);
	const char *name = file_name_without_folders(q->path[0]);
	if (q->feed)
		xappend(&line, "; write \"%.*s-read.csv\"",
		    (int)strcspn(name, "."), name);
	return line;
}

static const char *
hint_to_write_feed_again(const struct site_request *q)
{
	return q->feed ? tr(", and write it again for feed=") : "";
}

/* Reports the question as a fault, whose hint is the command with the proposed
 * answer.  Returns true. */
static bool __attribute__((format(printf, 5, 6)))
report_question_as_fault(const struct site_request *q, const struct table *t,
    struct cell where, const struct site_ask *ask, const char *what, ...)
{
	va_list ap;
	va_start(ap, what);
	FREED char *said = xvasprintf(what, ap);
	va_end(ap);
	FREED char *line = load_command_text_with_answer(q, ask->settle);
	return !error_set_at(error_list_add_item(t->sheet->errors), ERROR_DATA,
	    t->sheet->path, where.line, where.column,
	    "%s\nsay what it is%s: %s", said, hint_to_write_feed_again(q),
	    line);
}

/* The tables [n] of a sheet in order, the columns of all, and the tables
 * proposed as the site, first to last. */
struct tables {
	struct table *const *table;
	size_t n, first, last;
	const struct columns *all;
};

/* True if table k may belong to the site whose feed is in table `feed`.  like:
 * a table of products that does belong to it, or NULL. */
static bool
is_table_of_same_site(
    const struct tables *s, size_t k, size_t feed, const struct table *like)
{
	const struct table *t = s->table[k];
	if (!site_column_samples_of_table(s->all, t).products ||
	    title_mentions_limits_or_mean(t))
		return false;
	FREED char *line = title_feed_or_last_line(s->table[feed]),
		   *own = title_feed_or_last_line(t);
	bool same = !heading_names_differ(line, own);
	return same && (like == NULL || (!t->strange && !like->strange) ||
			   title_differs_only_in_speed(like, t));
}

/* Proposes the tables that are most likely one site: the first with a feed, and
 * the tables of products next to it whose titles differ only in speed. */
static void
propose_tables_of_site(struct tables *s)
{
	size_t feed = 0;
	const struct table *like = NULL;
	while (feed < s->n &&
	       site_column_count_by_role(s->all, s->table[feed], FEED) == 0)
		feed++;
	if (feed == s->n) /* then the first table is */
		return;
	s->first = s->last = feed;
	while (s->last + 1 < s->n &&
	       is_table_of_same_site(s, s->last + 1, feed, like)) {
		s->last++;
		like = s->table[s->last];
	}
	while (s->last == feed && s->first > 0 &&
	       is_table_of_same_site(s, s->first - 1, feed, like)) {
		s->first--;
		like = s->table[s->first];
	}
}

static void
extend_cell_range_over_rows(
    struct cell_range *box, const struct row *row, size_t n)
{
	for (size_t r = 0; r < n; r++) {
		int line = row[r].line;
		box->top = box->top == 0 || line < box->top ? line : box->top;
		box->bottom = line > box->bottom ? line : box->bottom;
	}
}

/* Returns the range of cells of a table's first n_row rows; or its whole lines,
 * if the sieves are in one line. */
static struct cell_range
cell_range_of_table_rows(const struct table *t, size_t n_row)
{
	struct cell_range box = {0};
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
		return (struct cell_range){least, 1, most, wide};
	}
	extend_cell_range_over_rows(&box, t->head, t->n_head);
	extend_cell_range_over_rows(&box, t->row, n_row);
	if (n_row == t->n_row)
		extend_cell_range_over_rows(&box, t->foot, t->n_foot);
	box.left = least;
	box.right = most;
	return box;
}

char *
site_ask_samples_of_table(
    const struct table *t, const struct columns *all, size_t most)
{
	size_t n = 0;
	char *list = xstrdup("");
	for (size_t i = 0; i < all->n; i++) {
		const struct column *c = &all->column[i];
		if (c->table != t || c->role == NO_ROLE)
			continue;
		FREED char *words = classify_describe_column(c);
		char *speed = strstr(words, "@SPEED");
		*(speed != NULL ? speed : words + strcspn(words, " ")) = '\0';
		if (n++ < most)
			xappend_to_list(&list, ", ", "%s", words);
	}
	if (n > most)
		xappend(&list, ", ..");
	return list;
}

/* Describes the samples that a table seems to contain. */
static char *
describe_samples_of_table(const struct table *t, const struct columns *all)
{
	if (title_mentions_limits_or_mean(t))
		return xstrdup(tr("limits or a mean"));
	char *list = site_ask_samples_of_table(t, all, 3);
	if (list[0] == '\0')
		xappend(&list, "%s", tr("not said"));
	return list;
}

/* Fills *ask with the tables and the proposed range. */
static void
list_tables_in_question(const struct tables *s, struct site_ask *ask)
{
	ask->tables = true;
	ask->n = s->n;
	ask->first = s->first;
	ask->last = s->last;
	ask->column = xcalloc(s->n, sizeof *ask->column);
	for (size_t i = 0; i < s->n; i++) {
		const struct table *t = s->table[i];
		struct cell_range box = cell_range_of_table_rows(t, t->n_row);
		FREED char *line = title_feed_or_last_line(t);
		ask->column[i] = (struct site_ask_column){.number = i + 1,
		    .head = xstrndup(
			line, (size_t)sheet_truncated_text_length(line)),
		    .values = xasprintf(tr("%d to %d"), box.top, box.bottom),
		    .guess = describe_samples_of_table(t, s->all),
		    .box = box};
	}
	FREED char *range =
	    cell_range_text(cell_range_around_tables(ask, s->first, s->last));
	ask->settle = xasprintf("range=%s", range);
}

/* Returns the second table that has a feed for all runs, or NULL. */
static const struct table *
second_table_with_feed(const struct columns *all)
{
	const struct table *first = NULL;
	for (size_t i = 0; i < all->n; i++) {
		const struct column *c = &all->column[i];
		if (c->role != FEED || c->speed > 0)
			continue;
		if (first != NULL && first != c->table)
			return c->table;
		first = c->table;
	}
	return NULL;
}

static bool
ask_which_table(const struct site_request *q, struct table *const *table,
    size_t n_table, const struct table *second, const struct columns *all,
    struct site_ask *ask)
{
	const struct table *first = table[0];
	for (size_t i = 0; i < n_table; i++)
		if (table[i]->sheet != second->sheet)
			first = table[i];
	if (strcmp(first->sheet->path, second->sheet->path) != 0) {
		FREED char *files = xstrdup("");
		for (size_t i = 0; i < q->n; i++)
			xappend_to_list(&files, " ", "%s@SPEED", q->path[i]);
		sheet_report_fault(second->sheet, second->row[0].cell[0],
		    "expected one feed, got one in each of several files\n"
		    "give each the tip speed of its samples: load %s",
		    files);
		return true;
	}
	if (first->sheet != second->sheet) {
		ask->settle = xasprintf("sheet=\"%s\"", first->sheet->name);
		return report_question_as_fault(q, second,
		    second->row[0].cell[0], ask,
		    tr("expected one site, got sheets with a feed each"));
	}
	struct tables tables = {.table = table, .n = n_table, .all = all};
	propose_tables_of_site(&tables);
	list_tables_in_question(&tables, ask);
	return report_question_as_fault(q, first, second->row[0].cell[0], ask,
	    tr("expected one site, got several tables that may be of different "
	       "machines, days or limits"));
}

static bool
ask_about_sieves_listed_twice(
    const struct open *open, const struct site_request *q, struct site_ask *ask)
{
	const struct table *t = open->twice;
	struct cell again = t->row[open->again].cell[0];
	FREED char *range =
	    cell_range_text(cell_range_of_table_rows(t, open->end));
	ask->settle = xasprintf("range=%s", range);
	return report_question_as_fault(q, t, again, ask,
	    tr("expected one table, got the sieves from %s on a second time"),
	    again.text);
}

/* Proposes the table with most sieves, if tables below each other do not tell
 * feed from product; the others may be extracts from it.  Returns false if
 * there is only one table, or a column has a role. */
static bool
propose_largest_table(struct tables *s)
{
	bool below = false;
	for (size_t i = 0; i < s->all->n; i++)
		if (s->all->column[i].role != NO_ROLE)
			return false;
	for (size_t i = 1; i < s->n; i++) {
		const struct table *t = s->table[i], *before = s->table[i - 1];
		below = below || (t->sheet == before->sheet &&
				     t->row[0].line > before->row[0].line);
		if (t->n_row > s->table[s->first]->n_row)
			s->first = i;
	}
	/* A range= covers one sheet, so only the tables of that sheet are
	 * listed. */
	const struct sheet *sheet = s->table[s->first]->sheet;
	while (s->table[0]->sheet != sheet) {
		s->table++;
		s->first--;
		s->n--;
	}
	while (s->table[s->n - 1]->sheet != sheet)
		s->n--;
	s->last = s->first;
	return below;
}

/* Returns the only number of a column above 100, if all others can be
 * percentages; else NULL. */
static const struct cell *
only_number_above_100(const struct column *c)
{
	const struct table *t = c->table;
	const struct cell *above = NULL;
	size_t n = 0, n_above = 0;
	for (size_t r = 0; r < t->n_row; r++) {
		double v;
		const struct cell *cell = &t->row[r].cell[c->at];
		if (!number_value_of_cell(*cell, &v))
			continue;
		n++;
		v /= 1 + 1e-9;
		n_above += v < 0 || v > 100;
		above = v > 100 ? cell : above;
	}
	bool mass = SITE_UNITS[c->unit].scale == OF_MASS &&
		    (c->said.means & WORD_GRAMS) != 0;
	return n >= 4 && n_above == 1 && !mass ? above : NULL;
}

/* Changes the hint to @SPEED after each file without a feed, because column
 * numbers do not tell files apart.  If no file has a feed, the first may be the
 * one. */
static void
hint_speed_for_each_file(const struct site_request *q,
    const struct columns *all, struct error *error)
{
	FREED char *files = xstrdup("");
	bool none = site_column_count_by_role(all, NULL, FEED) == 0;
	for (size_t i = 0; i < q->n; i++) {
		bool feed = none && i == 0;
		for (size_t k = 0; k < all->n; k++)
			feed = feed ||
			       (all->column[k].role == FEED &&
				   strcmp(all->column[k].table->sheet->path,
				       q->path[i]) == 0);
		FREED char *word = site_request_file_text(q, i);
		bool given = q->speed != NULL && q->speed[i] != 0;
		xappend_to_list(
		    &files, " ", "%s%s", word, given || feed ? "" : "@SPEED");
	}
	error_set_hint(error, "say their speeds: load %s", files);
}

/* Asks whether two samples at one speed are repeats: `first` and the next one
 * that differs from it in name. */
static bool
ask_if_samples_are_repeats(const struct site_request *q,
    const struct columns *all, const struct column *first, struct site_ask *ask)
{
	const struct column *other = first + 1;
	while (other < all->column + all->n - 1 &&
	       (!other->unlike || other->speed != first->speed))
		other++;
	FREED char *one = samples_label_of_column(first->table, first->at),
		   *two = samples_label_of_column(other->table, other->at);
	return report_question_as_fault(q, first->table, first->head, ask,
	    tr("expected repeats of one product at %g m/s, got '%.*s' and "
	       "'%.*s'"),
	    first->speed, sheet_truncated_text_length(one), one,
	    sheet_truncated_text_length(two), two);
}

/* Asks which samples to read, if they come from several sites or machines. */
static bool
ask_which_site_samples(const struct site_request *q, const struct columns *all,
    const struct column *first, struct site_ask *ask)
{
	const struct column *other = first + 1;
	while (other < all->column + all->n - 1 &&
	       can_be_of_same_site(first, other))
		other++;
	const char *two = other->whose != NULL ? other->whose : "";
	return report_question_as_fault(q, first->table, first->head, ask,
	    tr("expected samples of one site and machine, got those of '%.*s' "
	       "and '%.*s'"),
	    sheet_truncated_text_length(first->whose), first->whose,
	    sheet_truncated_text_length(two), two);
}

/* Asks what a column is; or a line, if the samples are in lines. */
static void
ask_what_column_is(const struct site_request *q, const struct column *c,
    bool speed, struct site_ask *ask)
{
	const struct table *t = c->table;
	const char *name = sample_name_or_heading(c);
	FREED char *values = first_cells_of_column_text(t, c->at);
	report_question_as_fault(q, t, c->head, ask,
	    t->across ? speed ? tr("expected headings and numbers that tell "
				   "what line %zu is, and its tip speed, got "
				   "'%.*s' before %s")
			      : tr("expected headings and numbers that tell "
				   "what line %zu is, got '%.*s' before %s")
	    : speed ? tr("expected headings and numbers that tell what column "
			 "%zu is, and its tip speed, got '%.*s' above %s")
		    : tr("expected headings and numbers that tell what "
			 "column %zu is, got '%.*s' above %s"),
	    t->number[c->at], sheet_truncated_text_length(name), name, values);
}

/* Asks about the first open column and, if it is not known, its speed. */
static bool
ask_about_unclear_column(const struct site_request *q,
    const struct column *first, const struct columns *all, struct site_ask *ask)
{
	const struct table *t = first->table;
	struct error *error = &t->sheet->errors->item[0];
	bool speed = first->role == PRODUCT && !(first->speed > 0);
	const struct cell *above = only_number_above_100(first);
	if (above != NULL)
		return report_question_as_fault(q, t, *above, ask,
		    t->across
			? tr("expected at most 100 %% passing, got '%.*s': "
			     "line %zu has no other number above 100; correct "
			     "it if it is a typing error")
			: tr("expected at most 100 %% passing, got '%.*s': "
			     "column %zu has no other number above 100; "
			     "correct it if it is a typing error"),
		    sheet_truncated_text_length(above->text), above->text,
		    t->number[first->at]);
	if (first->whose != NULL)
		return ask_which_site_samples(q, all, first, ask);
	if (first->unlike)
		return ask_if_samples_are_repeats(q, all, first, ask);
	ask_what_column_is(q, first, speed, ask);
	bool known = first->speed > 0 || first->rpm > 0;
	if (q->n > 1 && !known && !q->parts)
		hint_speed_for_each_file(q, all, error);
	else if (q->n > 1 && first->role == PRODUCT && known) {
		/* columns= would be about all files, samples= adds nothing */
		FREED char *words = classify_describe_column(first);
		error_set_hint(error,
		    "its numbers seem to be '%s': write that "
		    "into its heading",
		    strchr(words, ' ') + 1);
	}
	if (q->parts && speed && q->n == 1 && all->n == 1)
		error_set_hint(error,
		    "give its speed: add %s@SPEED, or with a log its time: add "
		    "%s@2026-05-03T10:15",
		    q->path[0], q->path[0]);
	return true;
}

static bool
ask_rotor_diameter(const struct heading_rotor *stated,
    const struct site_request *q, const struct table *t, struct site_ask *ask)
{
	struct cell first = t->row[0].cell[0];
	bool two = stated->other_mm > 0;
	ask->settle = two ? xasprintf("rotor_mm=%g or rotor_mm=%g", stated->mm,
				stated->other_mm)
			  : xstrdup("rotor_mm=DIAMETER");
	if (stated->other_line == 0)
		return report_question_as_fault(q, t, first, ask,
		    tr("expected tip speeds in m/s, got rpm without the "
		       "rotor's diameter"));
	FREED char *rotors = site_heading_rotors_text(stated);
	return report_question_as_fault(q, t, first, ask,
	    tr("expected one rotor diameter for speeds in rpm, got %s"),
	    rotors);
}

bool
site_ask_pending_question(const struct open *open, const struct site_request *q,
    struct table *const *table, size_t n_table, const struct columns *all,
    struct site_ask *ask)
{
	const struct table *second = second_table_with_feed(all);
	for (size_t i = 0; i < n_table && second == NULL; i++)
		if (table[i] == open->other)
			second = table[i];
	const struct column *first = NULL;
	if (open->twice != NULL)
		return ask_about_sieves_listed_twice(open, q, ask);
	for (size_t i = 0; i < all->n && first == NULL; i++)
		first = all->column[i].open ? &all->column[i] : NULL;
	if (open->number.text != NULL) {
		ask->settle = xstrdup("decimal=point|comma");
		return report_question_as_fault(q, table[0], open->number, ask,
		    tr("expected a number that can be read in one way, got %s: "
		       "a decimal sign, or thousands?"),
		    open->number.text);
	}
	if (open->rotor)
		return ask_rotor_diameter(&open->stated, q, table[0], ask);
	if (second != NULL)
		return ask_which_table(q, table, n_table, second, all, ask);
	struct tables tables = {.table = table, .n = n_table, .all = all};
	if (propose_largest_table(&tables)) {
		const struct table *most = tables.table[tables.first];
		list_tables_in_question(&tables, ask);
		return report_question_as_fault(q, most, most->row[0].cell[0],
		    ask,
		    tr("expected one table, got several: the one with most "
		       "sieves is proposed"));
	}
	if (first == NULL && !open->sieves)
		return false;
	if (!open->sieves && do_titles_name_samples(table, n_table, all))
		add_column_quantities_to_question(ask, table[0], all);
	else
		list_columns_to_ask_about(
		    ask, table, n_table, all, open->sieves);
	if (first == NULL)
		return report_question_as_fault(q, table[0],
		    table[0]->row[0].cell[0], ask,
		    tr("expected the unit of the sieves, got none that "
		       "fits their numbers"));
	return ask_about_unclear_column(q, first, all, ask);
}

/* Returns the next sieve above a size, mm, in the series of the column's
 * sieves. */
static double
next_sieve_up(const struct column *c, double mm)
{
	const struct table *t = c->table;
	const char *name = t->row[c->below - 1].cell[0].text;
	bool astm = t->unit.series == SIEVE_ASTM ||
		    t->unit.series == SIEVE_INCH ||
		    sieve_series_of_name(name) != SIEVE_NONE;
	return sieve_next_coarser(mm, astm);
}

double
site_ask_find_known_top_size(const struct column *c)
{
	/* Sieve analyses are stated to 0.1 %, so this is 100.0. */
	const double ALL_BUT = 99.95;
	size_t at = c->below - 1;
	return c->pct[at] >= ALL_BUT ? next_sieve_up(c, c->table->mm[at]) : 0;
}

/* True if the sizes may be the upper ends of classes rather than sieves: much
 * is retained on the coarsest and, without a pan, nothing passes the finest.
 * Read as classes, the same numbers leave nothing coarser, and fines below the
 * finest size. */
static bool
may_sizes_be_upper_ends(const struct column *c)
{
	const double MUCH = 5, NOTHING = 0.05;
	const struct table *t = c->table;
	size_t at = c->below - 1, finest = at;
	for (size_t i = at; i < t->n_row; i++)
		if (!isnan(c->pct[i]) && t->mm[i] > 0)
			finest = i;
	return SITE_UNITS[c->unit].kind == RETAINED && isnan(c->pan) &&
	       !sieve_cell_is_class(t->sheet, t->row[at].cell[0]) &&
	       c->pct[at] < 100 - MUCH && fabs(c->pct[finest]) < NOTHING;
}

void
site_ask_top_size(
    const struct column *c, const struct site_request *q, struct site_ask *ask)
{
	const struct table *t = c->table;
	size_t at = c->below - 1;
	double coarser = next_sieve_up(c, t->mm[at]);
	bool alone = t->sheet->errors->n == 0, much = c->pct[at] < 90;
	/* then neither is proposed */
	bool ends = may_sizes_be_upper_ends(c);
	double further = much && !ends ? next_sieve_up(c, coarser) : 0;
	char p[32];
	site_column_passing_text(c, at, 100, p);
	FREED char *settle = xasprintf("top=%g", coarser);
	FREED char *passes =
	    much ? xasprintf(tr("%g mm, the next sieve up (or %g mm or more, "
				"since much is coarser)"),
		       coarser, further)
		 : xasprintf(tr("%g mm, the next sieve up"), coarser);
	FREED char *line = load_command_text_with_answer(q, settle);
	if (ends)
		sheet_report_fault(t->sheet, t->row[at].cell[c->at],
		    "the coarsest sieve, %g mm, passes %s %% of the feed, and "
		    "the finest nothing: are these sieves, or the upper ends "
		    "of classes?\n"
		    "for classes write both ends in the sheet, such as 8-16 "
		    "and 0-0.063; for sieves say which size all of the feed "
		    "passes: %s",
		    t->mm[at], p, line);
	else
		sheet_report_fault(t->sheet, t->row[at].cell[c->at],
		    "the coarsest sieve, %g mm, passes %s %% of the feed, as "
		    "is usual: which size does all of it pass?\n"
		    "take %s%s: %s",
		    t->mm[at], p, passes, hint_to_write_feed_again(q), line);
	if (!alone)
		return;
	ask->settle = xstrdup(ends ? "top=" : settle);
	ask->further = further;
}

void
site_ask_refuse_second_feed(const struct column *further,
    const struct columns *all, const struct site_request *q)
{
	const struct table *t = further->table;
	const struct column *first = site_column_find(all, FEED, 0, 0);
	FREED char *sieve = xasprintf(tr("sieve %s"), site_sieve_unit_text(t));
	FREED char *columns =
	    xasprintf("columns=\"%zu=%s", t->number[0], sieve);
	for (size_t i = 0; i < all->n; i++) {
		const struct column *c = &all->column[i];
		bool other = c->role == FEED && c != first;
		FREED char *words = classify_describe_column(c);
		if (c->table == t && c->twin == 0 && !other)
			xappend(&columns, ", %zu=%s", t->number[c->at], words);
	}
	xappend(&columns, "\"");
	FREED char *line = load_command_text_with_answer(q, columns);
	sheet_report_fault(t->sheet, further->head,
	    "expected one feed, or one for each product, got %s beside %s\n"
	    "keep the first%s: %s",
	    further->head.text, first->head.text, hint_to_write_feed_again(q),
	    line);
}

/* Composes the questions about a sheet and the table shown with them, and
 * interprets the answers.  The driver asks the user.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/sheets/ask_user.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "base/tr.h"
#include "base/xalloc.h"
#include "io/sitefile/column_header.h"
#include "io/sitefile/lexicon.h"

enum { WRONG_SIZE = 160 };

/* Rotors of VSI crushers have diameters of 0.4 to 1.5 m. */
static const double LEAST_ROTOR_MM = 100, MOST_ROTOR_MM = 5000;

enum { CELLS = 4 };

/* The words of an answer that say which column it is, and what its numbers
 * are. */
static const uint64_t ROLES = WORD_FEED | WORD_PRODUCT | WORD_SD,
		      MEASURES = WORD_PASSES | WORD_STAYS | WORD_SUMS |
				 WORD_SHARE | WORD_PERCENT | WORD_GRAMS |
				 WORD_MASS;

/* Sets cell to the texts of a row, which are valid as long as the question and
 * `number`, a buffer of at least 24 bytes. */
static void
question_row_cells(const struct user_question *q, size_t row, bool narrow,
    char *number, const char *cell[static CELLS])
{
	bool tables = q->ask->tables;
	const char *const HEADS[] = {"",
	    tables           ? tr("title")
	    : q->ask->across ? tr("sample")
			     : tr("head"),
	    tables   ? tr("lines")
	    : narrow ? tr("values")
		     : tr("first values"),
	    tr("seems to be")};
	if (row == 0) {
		memcpy(cell, HEADS, sizeof HEADS);
		cell[0] = narrow           ? ""
			  : tables         ? tr("table")
			  : q->ask->across ? tr("line")
					   : tr("column");
		return;
	}
	const struct site_ask_column *c = &q->ask->column[row - 1];
	snprintf(number, 24, "%zu", c->number);
	cell[0] = number;
	cell[1] = c->head;
	cell[2] = c->values;
	cell[3] = c->guess;
}

/* Finds widths at which all rows fit into `room` columns: values are shortened
 * first, then headings, then guesses. */
static void
question_column_widths(
    const struct user_question *q, int room, bool narrow, int width[CELLS])
{
	static const int LEAST[CELLS] = {0, 9, 6, 8};
	static const int GIVES[] = {2, 1, 3};
	char number[24];
	const char *cell[CELLS];
	for (int i = 0; i < CELLS; i++)
		width[i] = 0;
	for (size_t r = 0; r <= q->ask->n; r++) {
		question_row_cells(q, r, narrow, number, cell);
		for (int i = 0; i < CELLS; i++) {
			int w = text_width_in_columns(cell[i]);
			width[i] = w > width[i] ? w : width[i];
		}
	}
	for (int i = 0; i < CELLS; i++)
		room -= width[i];
	for (size_t k = 0; k < ARRAY_LEN(GIVES) && room < 0; k++) {
		int i = GIVES[k], spare = width[i] - LEAST[i];
		int less = spare < -room ? spare : -room;
		less = less > 0 ? less : 0;
		width[i] -= less;
		room += less;
	}
}

static void
append_padded_cell(char **line, const char *text, int width, bool right)
{
	int own = text_width_in_columns(text);
	if (right || own <= width) {
		xappend(line, "%*s%s%*s",
		    right && own < width ? width - own : 0, "", text,
		    !right ? width - own : 0, "");
		return;
	}
	char shown[TEXT_SHOWN];
	int at = 0, most = width - 2;
	for (const char *p = text; *p != '\0';) {
		int w = text_escape_next_character(&p, shown);
		if (at + w > most)
			break;
		xappend(line, "%s", shown);
		at += w;
	}
	xappend(line, "..%*s", at < most ? most - at : 0, "");
}

char *
user_question_row_text(const struct user_question *q, size_t row, int columns)
{
	bool narrow = columns < 60;
	const char *gap = narrow ? " " : "  ";
	int width[CELLS], mark = 2;
	char number[24];
	const char *cell[CELLS];
	question_column_widths(
	    q, columns - mark - (CELLS - 1) * (narrow ? 1 : 2), narrow, width);
	question_row_cells(q, row, narrow, number, cell);
	bool open = row > 0 && q->ask->column[row - 1].open;
	char *line = xstrdup(open ? "? " : "  ");
	for (int i = 0; i < CELLS; i++) {
		xappend(&line, "%s", i > 0 ? gap : "");
		append_padded_cell(&line, cell[i], width[i], i == 0);
	}
	size_t n = strlen(line);
	while (n > 0 && line[n - 1] == ' ')
		line[--n] = '\0';
	return line;
}

static bool
is_guessed_sieve_column(const struct site_ask_column *c)
{
	return strncmp(c->guess, "sieve", 5) == 0;
}

static bool
does_column_guess_lack_speed(const struct site_ask_column *c)
{
	return strstr(c->guess, "@SPEED") != NULL;
}

/* Returns the guess with another role and speed: "product@69 retained_g". */
static char *
replace_role_of_guess(const struct site_ask_column *c, const char *role)
{
	const char *unit = strchr(c->guess, ' ');
	return xasprintf("%s%s", role, unit != NULL ? unit : "");
}

/* Interprets an answer that is only a speed.  The column keeps its guessed
 * role, but a feed without a speed becomes a product. */
static char *
parse_speed_answer(const struct site_ask_column *c, const struct head *head,
    char wrong[static WRONG_SIZE])
{
	bool rpm = head->rpm > 0 && !(head->speed > 0);
	double v = head->speed > 0 ? head->speed
		   : rpm           ? head->rpm
				   : head->number[0];
	if (!rpm && !(v >= 1 && v <= SITE_FASTEST)) {
		snprintf(wrong, WRONG_SIZE,
		    tr("expected a tip speed from 1 to %d m/s, got %g; for rpm "
		       "write: %g rpm"),
		    SITE_FASTEST, v, v);
		return NULL;
	}
	char number[32];
	/* a guessed sieve column that is something else is a product */
	FREED char *role = is_guessed_sieve_column(c)
			       ? xstrdup("product")
			       : xstrndup(c->guess, strcspn(c->guess, "@ "));
	bool feed = strcmp(role, "feed") == 0 && strchr(c->guess, '@') == NULL;
	FREED char *said = xasprintf(rpm ? "%s %s rpm" : "%s@%s",
	    feed ? "product" : role, text_shortest_exact_number(v, number));
	return replace_role_of_guess(c, said);
}

static char *
parse_column_role_answer(const struct site_ask_column *c, const char *said,
    const struct head *head, uint64_t means)
{
	bool role = (means & ROLES) != 0;
	bool bare = head->speed == 0 && head->rpm == 0 && head->n_number > 0;
	char number[32];
	if (!role && said[0] >= '0' && said[0] <= '9')
		return xasprintf(
		    "product%s%s", heading_has_speed(head) ? " " : "@", said);
	if (!role) {
		char *text = xstrndup(c->guess, strcspn(c->guess, " "));
		xappend(&text, " %s", said);
		return text;
	}
	if ((means & MEASURES) != 0)
		return xstrdup(said);
	if (bare && (means & WORD_PRODUCT) != 0) {
		FREED char *product = xasprintf("product@%s",
		    text_shortest_exact_number(head->number[0], number));
		return replace_role_of_guess(c, product);
	}
	return replace_role_of_guess(c, said);
}

static char *
parse_sieve_unit_answer(
    const char *said, uint64_t means, char wrong[static WRONG_SIZE])
{
	uint64_t unit = WORD_MM | WORD_UM | WORD_M | WORD_INCH | WORD_MESH |
			WORD_TYLER | WORD_BS | WORD_ASTM | WORD_PHI;
	if ((means & unit) != 0)
		return xasprintf(
		    "%s%s", (means & WORD_SIZE) != 0 ? "" : tr("sieve "), said);
	snprintf(wrong, WRONG_SIZE,
	    tr("expected the unit of the sieves (mm, um, in, phi, tyler, bs, "
	       "astm), got '%.30s'"),
	    said);
	return NULL;
}

/* Interprets the answer about a column: a speed, words, or "" for the guess.
 * Returns the words for columns=, which the caller frees, or NULL: then the
 * column is left out or, if `wrong` is not empty, it says what was expected. */
static char *
parse_column_answer(const struct site_ask_column *c, const char *answer,
    char wrong[static WRONG_SIZE])
{
	FREED char *copy = xstrdup(answer);
	char *said = text_trim(copy), *text = NULL;
	/* In columns= a comma separates columns. */
	for (char *p = said; *p != '\0'; p++)
		if (*p == ',' && (p[1] < '0' || p[1] > '9'))
			*p = ' ';
	struct head head = heading_parse(said);
	uint64_t means = head.means | lexicon_text_meanings(said, NULL);
	bool speed = heading_has_speed(&head) || head.n_number > 0;
	wrong[0] = '\0';
	if (said[0] == '\0' && does_column_guess_lack_speed(c))
		snprintf(wrong, WRONG_SIZE,
		    tr("expected a tip speed in m/s, got nothing; - leaves it "
		       "out"));
	else if (said[0] == '\0')
		text = xstrdup(c->guess);
	else if (is_guessed_sieve_column(c))
		text = parse_sieve_unit_answer(said, means, wrong);
	else if (strcmp(said, "-") != 0 && strpbrk(said, "\"=") != NULL)
		snprintf(wrong, WRONG_SIZE,
		    tr("expected words for what it is, got '%.40s'"), said);
	else if ((means & (ROLES | MEASURES)) != 0)
		text = parse_column_role_answer(c, said, &head, means);
	else if (speed && head.unknown == 0)
		text = parse_speed_answer(c, &head, wrong);
	else if (strcmp(said, "-") != 0)
		snprintf(wrong, WRONG_SIZE,
		    tr("expected a tip speed, feed, product@69 or -, got "
		       "'%.30s'"),
		    said);
	return text;
}

/* Asks about one column until the answer is valid, and puts it into the table
 * as the guess: "-" leaves out the column, "." also all that follow.  Returns
 * false if the user gives up. */
static bool
ask_about_column(
    struct session *s, struct user_question *q, struct site_ask_column *c)
{
	char wrong[WRONG_SIZE] = "";
	const char *kind = q->ask->across ? tr("line") : tr("column");
	bool speed = does_column_guess_lack_speed(c);
	FREED char *question =
	    speed ? xasprintf(tr("%s %zu '%s': tip speed, m/s"), kind,
			c->number, c->head)
		  : xasprintf(tr("%s %zu '%s': what is it"), kind, c->number,
			c->head);
	char *words = NULL;
	bool rest;
	q->text = question;
	q->offered = speed ? "" : c->guess;
	q->hint = is_guessed_sieve_column(c)
		      ? tr("or: mm, um, in, phi, tyler, bs, astm")
		  : speed ? tr("or: 1350 rpm, feed; - leaves it out")
			  : tr("or: feed, product@69, retained_g; - leaves it "
			       "out");
	q->wrong = wrong;
	do {
		FREED char *answer = s->hooks.ask(s, q);
		if (answer == NULL)
			return false;
		rest = strcmp(answer, ".") == 0;
		words = parse_column_answer(c, rest ? "-" : answer, wrong);
		q->first = false;
	} while (words == NULL && wrong[0] != '\0');
	xfree_and_set(
	    &c->guess, words != NULL ? words : xstrdup(rest ? "." : "-"));
	c->open = false;
	return true;
}

/* Asks about the open columns, one by one.  The answers go into a copy of the
 * table, which the next question shows. */
static bool
ask_about_columns(struct session *s, const struct site_ask *ask,
    const char *file, struct user_answers *said)
{
	struct site_ask table = *ask;
	table.column = xcalloc(ask->n, sizeof *table.column);
	for (size_t i = 0; i < ask->n; i++) {
		table.column[i] = ask->column[i];
		table.column[i].guess = xstrdup(ask->column[i].guess);
	}
	FREED char *about = xasprintf(tr("%s: what are the %s marked with ?"),
	    file, ask->across ? tr("lines") : tr("columns"));
	struct user_question q = {.about = about, .ask = &table, .first = true};
	bool good = true;
	xfree_and_set(&said->columns, xstrdup(""));
	if (ask->by_sample)
		xfree_and_set(&said->samples, xstrdup(""));
	for (size_t i = 0; i < ask->n && good; i++) {
		struct site_ask_column *c = &table.column[i];
		q.at = i;
		if (c->open)
			good = ask_about_column(s, &q, c);
		if (good && strcmp(c->guess, ".") == 0)
			break;
		if (!good || strcmp(c->guess, "-") == 0)
			continue;
		if (ask->by_sample && i > 0)
			xappend_to_list(
			    &said->samples, ", ", "%s=%s", c->head, c->guess);
		else
			xappend_to_list(&said->columns, ", ", "%zu=%s",
			    c->number, c->guess);
	}
	for (size_t i = 0; i < ask->n; i++)
		free(table.column[i].guess);
	free(table.column);
	return good;
}

static bool
parse_rotor_answer(const char *said, struct user_answers *into, char *wrong)
{
	double mm;
	bool good = text_parse_typed_number(said, &mm) &&
		    mm >= LEAST_ROTOR_MM && mm <= MOST_ROTOR_MM;
	into->rotor = good ? mm / 1000 : 0;
	if (!good)
		snprintf(wrong, WRONG_SIZE,
		    tr("expected a diameter from %g to %g mm, got '%.30s'"),
		    LEAST_ROTOR_MM, MOST_ROTOR_MM, said);
	return good;
}

static bool
is_abbreviation_of(const char *said, const char *word)
{
	return said[0] != '\0' &&
	       text_is_same_but_case(word, said, strlen(said));
}

/* Y or Enter accepts the size offered; a number replaces it. */
static bool
parse_top_size_answer(const char *settle, const char *said,
    struct user_answers *into, char *wrong)
{
	bool yes = said[0] == '\0' || is_abbreviation_of(said, "yes") ||
		   tr_is_yes(said);
	const char *number = yes ? strchr(settle, '=') + 1 : said;
	bool good =
	    text_parse_typed_number(number, &into->top) && into->top > 0;
	if (!good)
		snprintf(wrong, WRONG_SIZE,
		    strchr(settle, '=')[1] == '\0'
			? tr("expected a size in mm, or n, got '%.30s'")
			: tr("expected y, n or another size in mm, got "
			     "'%.30s'"),
		    said);
	return good;
}

static bool
parse_decimal_mark_answer(
    const char *said, struct user_answers *into, char *wrong)
{
	bool comma =
	    strcmp(said, ",") == 0 || text_is_same_folded(said, "comma");
	bool point =
	    strcmp(said, ".") == 0 || text_is_same_folded(said, "point");
	into->decimal = comma ? ',' : '.';
	if (!comma && !point)
		snprintf(wrong, WRONG_SIZE,
		    tr("expected point or comma, got '%.30s'"), said);
	return comma || point;
}

static bool
parse_date_order_answer(
    const char *said, struct user_answers *into, char *wrong)
{
	into->month_first = is_abbreviation_of(said, "month");
	if (is_abbreviation_of(said, "day") || into->month_first)
		return true;
	snprintf(wrong, WRONG_SIZE, tr("expected %s or %s, got '%.30s'"), "day",
	    "month", said);
	return false;
}

/* Takes a sheet or range as typed, or the one offered if nothing was typed. */
static bool
parse_sheet_or_range_answer(
    const char *settle, const char *said, struct user_answers *into)
{
	char **slot =
	    strncmp(settle, "sheet=", 6) == 0 ? &into->sheet : &into->range;
	const char *from = said[0] != '\0' ? said : strchr(settle, '=') + 1;
	xfree_and_set(slot, text_without_quotes(from, strlen(from)));
	return true;
}

/* Takes tables by number, "2" or "1-3", or as cells, or the tables offered if
 * nothing was typed. */
static bool
parse_tables_answer(const struct site_ask *ask, const char *said,
    struct user_answers *into, char *wrong)
{
	struct cell_range box;
	char *end;
	size_t from = ask->first + 1, to = ask->last + 1;
	if (said[0] >= '0' && said[0] <= '9') {
		from = to = strtoul(said, &end, 10);
		end += strspn(end, " ");
		if (*end == '-')
			to = strtoul(end + 1, &end, 10);
		from = *end == '\0' ? from : 0;
	} else if (cell_range_parse(said, &box)) {
		return parse_sheet_or_range_answer("range=", said, into);
	} else if (said[0] != '\0') {
		from = 0;
	}
	if (from == 0 || from > to || to > ask->n) {
		snprintf(wrong, WRONG_SIZE,
		    tr("expected tables from 1 to %zu, such as 2 or 1-2, or "
		       "cells, got '%.30s'"),
		    ask->n, said);
		return false;
	}
	xfree_and_set(&into->range,
	    cell_range_text(cell_range_around_tables(ask, from - 1, to - 1)));
	return true;
}

static bool
parse_option_answer(const struct site_ask *ask, const char *said,
    struct user_answers *into, char *wrong)
{
	const char *settle = ask->settle;
	if (ask->tables)
		return parse_tables_answer(ask, said, into, wrong);
	if (strncmp(settle, "top=", 4) == 0)
		return parse_top_size_answer(settle, said, into, wrong);
	if (strncmp(settle, "rotor_mm=", 9) == 0)
		return parse_rotor_answer(said, into, wrong);
	if (strncmp(settle, "decimal=", 8) == 0)
		return parse_decimal_mark_answer(said, into, wrong);
	if (strncmp(settle, "dates=", 6) == 0)
		return parse_date_order_answer(said, into, wrong);
	return parse_sheet_or_range_answer(settle, said, into);
}

/* Asks until the answer is valid.  Returns false if the user gives up, also by
 * answering "n" to a proposed top size. */
static bool
ask_until_valid_answer(
    struct session *s, struct user_question *q, struct user_answers *said)
{
	char wrong[WRONG_SIZE] = "";
	bool top = strncmp(q->ask->settle, "top=", 4) == 0;
	q->wrong = wrong;
	for (q->first = true;; q->first = false) {
		FREED char *answer = s->hooks.ask(s, q);
		char *text = answer != NULL ? text_trim(answer) : NULL;
		if (text == NULL ||
		    (top && (is_abbreviation_of(text, "no") || tr_is_no(text))))
			return false;
		wrong[0] = '\0';
		if (parse_option_answer(q->ask, text, said, wrong))
			return true;
	}
}

/* The questions about options.  offers: an empty line means the option's
 * value. */
static const struct {
	const char *option, *question;
	bool offers;
} ASKS[] = {{"rotor_mm=", N_("diameter of the rotor in mm"), false},
    {"decimal=", N_("decimal sign, point or comma"), false},
    {"sheet=", N_("which sheet is to be read"), true},
    {"range=", N_("which cells are to be read"), true},
    {"dates=", N_("is it day or month first"), false}};

/* Returns the question about the size that all of the feed passes.  size: the
 * proposed one, or "".  further: if > 0, a larger size to name too, because the
 * proposed one is doubtful. */
static char *
top_size_question(const char *size, double further)
{
	if (size[0] == '\0')
		return xstrdup(
		    tr("sieves: type the size in mm that all of it passes; "
		       "classes: type n, and write both ends in the sheet"));
	return further > 0
		   ? xasprintf(tr("take %s mm, the next sieve up (or type %g "
				  "or more, since much is coarser)"),
			 size, further)
		   : xasprintf(tr("take %s mm, the next sieve up"), size);
}

static bool
ask_for_option_value(struct session *s, const struct site_ask *ask,
    const struct error *trouble, struct user_answers *said)
{
	const char *value = strchr(ask->settle, '=') + 1;
	FREED char *about = xasprintf("%s: %s", trouble->file, trouble->text);
	FREED char *passes = top_size_question(value, ask->further);
	FREED char *tables =
	    ask->first < ask->last
		? xasprintf("%zu-%zu", ask->first + 1, ask->last + 1)
		: xasprintf("%zu", ask->first + 1);
	struct user_question q = {.about = about,
	    .ask = ask,
	    .text = passes,
	    .offered = value[0] != '\0' ? "Y/n" : "",
	    .hint = ""};
	for (size_t i = 0; i < ARRAY_LEN(ASKS); i++)
		if (strncmp(ask->settle, ASKS[i].option,
			strlen(ASKS[i].option)) == 0) {
			q.text = tr(ASKS[i].question);
			q.offered = ASKS[i].offers ? value : "";
		}
	if (ask->tables) {
		q.text = tr("which tables are to be read");
		q.offered = tables;
		q.hint = tr("or: 2, 1-2, or cells such as A5:B17");
		q.at = ask->first;
	}
	return ask_until_valid_answer(s, &q, said);
}

/* True if there is a user to ask.  Scripts run at a prompt ask no questions, so
 * that they always do the same. */
static bool
can_ask_user(const struct session *s)
{
	return s->hooks.ask != NULL && s->scripts <= s->typed_depth;
}

bool
ask_date_order(
    struct session *s, const struct error *trouble, bool *month_first)
{
	static char SETTLE[] = "dates=";
	const struct site_ask ask = {.settle = SETTLE};
	struct user_answers said = {0};
	bool good =
	    can_ask_user(s) && ask_for_option_value(s, &ask, trouble, &said);
	*month_first = said.month_first;
	return good;
}

bool
ask_open_questions(struct session *s, const struct site_ask *ask,
    const struct error *trouble, struct user_answers *said)
{
	if (!can_ask_user(s) || ask->settle == NULL)
		return false;
	return ask->n > 0 && !ask->tables
		   ? ask_about_columns(s, ask, trouble->file, said)
		   : ask_for_option_value(s, ask, trouble, said);
}

/* Classifies the columns of a table by their headings, or else by the shape of
 * their numbers.  An ambiguous column is open.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/sitefile/classify.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "base/tr.h"
#include "base/xalloc.h"
#include "io/sitefile/lexicon.h"
#include "io/sitefile/site_day.h"
#include "io/cells/datetime.h"
#include "io/cells/number.h"

static const uint64_t ROLE_WORDS = WORD_FEED | WORD_PRODUCT | WORD_SD;
static const uint64_t KIND_WORDS = WORD_PASSES | WORD_STAYS | WORD_SUMS;
static const uint64_t SCALE_WORDS =
    WORD_PERCENT | WORD_GRAMS | WORD_SHARE | WORD_MASS;

static void __attribute__((format(printf, 2, 3)))
assume(struct column *c, const char *format, ...)
{
	va_list ap;
	va_start(ap, format);
	FREED char *what = xvasprintf(tr(format), ap);
	va_end(ap);
	if (c->assumed == NULL)
		c->assumed = xstrdup("\n");
	xappend(&c->assumed, "%s\n", what);
}

/* Returns the heading of column c in row r: its own cell or, if that is empty,
 * the cell to its left, which then spreads over it as merged cells do (*own is
 * false).  Returns NULL if there is none. */
static const struct cell *
find_heading_cell(const struct table *t, size_t r, size_t c, bool *own)
{
	const struct row *row = &t->head[r];
	*own = row->cell[c].text[0] != '\0';
	size_t k = c;
	while (k > 0 && row->cell[k].text[0] == '\0')
		k--;
	if (*own)
		return &row->cell[c];
	return k > 0 && t->n_head > 1 ? &row->cell[k] : NULL;
}

/* Adds to a heading what it lacks, from a cell above it.  own: the cell is
 * above this column, not spread over it from the left; titles: it is above the
 * heading of the sieves. */
static void
add_words_from_heading_above(
    struct head *said, const struct head *more, bool own, bool titles)
{
	const uint64_t group[] = {ROLE_WORDS, KIND_WORDS, SCALE_WORDS};
	uint64_t rest = ~(ROLE_WORDS | KIND_WORDS | SCALE_WORDS);
	/* If "Feed" stands above a column to the left, and this column has a
	 * speed of its own, the feed is not meant here. */
	bool mean = !own && (said->means & WORD_MEAN) != 0;
	bool feed =
	    !own && (more->means & WORD_FEED) != 0 && heading_has_speed(said);
	for (size_t i = feed ? 1 : 0; i < ARRAY_LEN(group); i++)
		if ((said->means & group[i]) == 0)
			said->means |= more->means & group[i];
	if (own)
		said->means |= more->means & rest;
	if (own && !titles)
		said->unknown += more->unknown;
	said->several =
	    said->several || (own && said->speed > 0 && more->speed > 0 &&
				 fabs(said->speed - more->speed) > 0.5);
	if (!mean && said->speed == 0 && (said->rpm == 0 || more->speed > 0)) {
		said->speed = more->speed;
		said->rpm = said->rpm > 0 ? said->rpm : more->rpm;
		if (heading_has_speed(more))
			said->spread = !own;
		said->unit =
		    said->unit == SPEED_NO_UNIT ? more->unit : said->unit;
	}
	if (own && said->rpm == 0)
		said->rpm = more->rpm;
	if (said->n_number == 0) {
		said->spread = said->spread || (!own && more->n_number > 0);
		said->n_number = more->n_number;
		memcpy(said->number, more->number, sizeof said->number);
	}
	said->several = said->several || more->several;
	said->range = said->range || more->range;
}

/* Takes the number in a heading for a speed, in a unit stated elsewhere. */
static void
use_heading_number_as_speed(struct head *head, enum speed_unit unit)
{
	if (unit == SPEED_RPM)
		head->rpm = head->number[0];
	else
		head->speed = speed_in_unit_to_mps(head->number[0], unit, 0);
	head->n_number = 0;
}

/* Applies the label in the first cell of a row of headings, such as "Speed
 * (m/s)", "Sample" or "Date", to one heading of that row. */
static void
apply_label_of_heading_row(const struct cell *label, struct head *head)
{
	struct head row = heading_parse(label->text);
	bool sample = (row.means & WORD_SAMPLE) != 0 ||
		      (head->unknown == 0 &&
			  ((head->means & (WORD_FEED | WORD_PRODUCT)) != 0 ||
			      heading_has_speed(head)));
	/* A row labelled "ID" may have "Feed" and "69 m/s". */
	if ((row.means & (WORD_OTHER | WORD_ROTOR)) != 0 && !sample &&
	    (row.means & WORD_SPEED) == 0 && row.unit == SPEED_NO_UNIT) {
		*head = (struct head){0};
		return;
	}
	enum speed_unit unit = heading_speed_unit(&row);
	bool speed = unit != SPEED_NO_UNIT || (row.means & WORD_SPEED) != 0;
	/* "Speed (Hz)", "Belt speed m/s", "t/h": another quantity. */
	bool other =
	    row.unknown > 0 || row.n_number > 0 ||
	    ((row.means & ~WORD_FILLER) == 0 && row.unit == SPEED_NO_UNIT) ||
	    (row.means & (WORD_PERCENT | WORD_GRAMS | WORD_LIMIT)) != 0 ||
	    (speed && (row.means & (WORD_SAMPLE | WORD_FEED)) != 0);
	if (other && head->unit == SPEED_NO_UNIT) {
		head->n_number = 0;
		return;
	}
	if (speed && head->n_number == 1 && head->unit == SPEED_NO_UNIT) {
		if (unit == SPEED_NO_UNIT) {
			head->means |= WORD_SPEED;
			return;
		}
		head->unit = unit;
		use_heading_number_as_speed(head, unit);
	} else if ((row.means & WORD_SAMPLE) != 0 && !speed) {
		head->n_number = 0;
	}
}

/* Combines all headings of a column, from the lowest up.  Of rpm beside m/s,
 * only those of the rotor count. */
static struct head
combine_column_headings(const struct table *t, size_t c)
{
	struct head said = {0};
	bool other = false;
	for (size_t r = t->n_head; r-- > 0;) {
		bool own;
		const struct cell *cell = find_heading_cell(t, r, c, &own);
		if (cell == NULL || cell->kind == CELL_DATE)
			continue;
		struct head one = heading_parse(cell->text);
		bool anchor = r == t->titles;
		if (!anchor && t->head[r].cell[0].text[0] != '\0')
			apply_label_of_heading_row(&t->head[r].cell[0], &one);
		struct head label = heading_parse(t->head[r].cell[0].text);
		other = other || (!anchor && one.rpm > 0 &&
				     heading_is_of_other_part(&label));
		add_words_from_heading_above(&said, &one, own, r < t->titles);
	}
	/* "speed 69" from a long table, or "tip speed (m/s) 69" in one cell. */
	bool number = said.speed == 0 && said.rpm == 0 && said.n_number == 1;
	if (number && said.unit != SPEED_NO_UNIT)
		use_heading_number_as_speed(&said, said.unit);
	else if (number && (said.means & WORD_RPM) != 0 && said.number[0] > 200)
		use_heading_number_as_speed(&said, SPEED_RPM);
	if (other && said.speed > 0)
		said.rpm = 0;
	return said;
}

/* True if a column has a heading of unknown words, such as "Costs", in a row
 * that says what the column to its left is. */
static bool
is_heading_unlike_left_one(const struct table *t, size_t at)
{
	for (size_t r = 0; r < t->n_head; r++) {
		const struct cell *cell = &t->head[r].cell[at];
		struct head own = heading_parse(cell->text);
		struct head left = heading_parse(cell[-1].text);
		if (own.unknown > 0 && !heading_has_speed(&own) &&
		    (own.means & (ROLE_WORDS | KIND_WORDS)) == 0 &&
		    (left.means & (WORD_PRODUCT | KIND_WORDS)) != 0)
			return true;
	}
	return false;
}

/* The numbers of a column.  n, rises, falls, first, last, most: of its sieves,
 * from coarse to fine, without the pan; sum: with the pan.  The others are of
 * all rows: how many cells are filled and how many are numbers, the least and
 * the greatest number, and how many pairs of neighbours there are, differ by 1,
 * are the same. */
struct shape {
	int n, rises, falls;
	double first, last, most, sum, pan;
	size_t filled, numbers, pairs, steps, same;
	double least_of_all, most_of_all;
};

static struct shape
summarise_column_numbers(const struct column *c)
{
	const struct table *t = c->table;
	struct shape s = {.first = NAN,
	    .last = NAN,
	    .pan = NAN,
	    .least_of_all = INFINITY,
	    .most_of_all = -INFINITY};
	double before = NAN;
	for (size_t i = 0; i < t->n_row; i++) {
		double v = site_column_value_in_row(c, i);
		s.filled += t->row[i].cell[c->at].value != AS_ABSENT;
		s.pairs += !isnan(v) && !isnan(before);
		s.steps += fabs(v - before) == 1;
		s.same += v == before;
		before = v;
		if (isnan(v))
			continue;
		s.numbers++;
		s.least_of_all = fmin(s.least_of_all, v);
		s.most_of_all = fmax(s.most_of_all, v);
		s.sum += v;
		if (!isnan(t->mm[i]) && t->mm[i] <= 0) {
			s.pan = v;
			continue;
		}
		s.rises += v > s.last;
		s.falls += v < s.last;
		s.first = s.n == 0 ? v : s.first;
		s.last = v;
		s.most = fmax(s.most, v);
		s.n++;
	}
	return s;
}

static bool
is_within_percent(double value, double whole, double percent)
{
	return fabs(value - whole) <= percent / 100 * whole;
}

/* Returns the total that a line below the table states, in the column's own
 * unit, or NAN. */
static double
stated_total_of_column(const struct column *c)
{
	const struct table *t = c->table;
	double v;
	for (size_t i = 0; i < t->n_foot; i++) {
		uint64_t means =
		    lexicon_text_meanings(t->foot[i].cell[0].text, NULL);
		if ((means & WORD_TOTAL) != 0 &&
		    number_value_of_cell(t->foot[i].cell[c->at], &v))
			return v;
	}
	return NAN;
}

/* Guesses from the sum of the numbers retained whether they are per cent,
 * fractions or masses.  Returns false if it is unclear. */
static bool
guess_retained_unit_from_sum(
    const struct shape *s, double total, enum unit_scale *scale)
{
	/* Without a pan, the finest part is missing from the sum. */
	double least = !isnan(s->pan) ? 0.95 : 0.8;
	bool percent =
	    s->sum >= 100 * least && s->sum <= 105 && s->most <= 100.5;
	bool fraction = s->sum >= least && s->sum <= 1.05 && s->most <= 1.005;
	*scale = OF_100;
	if (is_within_percent(s->sum, 100, 1.05) && s->most <= 100.5)
		return true;
	if (is_within_percent(s->sum, 1, 1.05) && s->most <= 1.005)
		*scale = OF_1;
	else if (!percent && !fraction && (!isnan(s->pan) || !isnan(total)))
		*scale = OF_MASS;
	else { /* near 100 or 1, but not near enough */
		bool mass =
		    s->most > 100.5 && !is_within_percent(s->first, 100, 1);
		*scale = mass ? OF_MASS : fraction ? OF_1 : *scale;
		return false;
	}
	return true;
}

/* Guesses the quantity from the numbers alone.  Returns false if several are
 * possible. */
static bool
guess_quantity_from_numbers(const struct shape *s, double total,
    enum unit_kind *kind, enum unit_scale *scale)
{
	bool hill = s->rises > 0 && s->falls > 0;
	bool peak = s->first >= s->most && s->rises <= 1;
	*scale = s->most <= 1 + 1e-9 ? OF_1 : OF_100;
	if (hill && peak &&
	    (is_within_percent(s->most, 100, 1) ||
		is_within_percent(s->most, 1, 1))) {
		*kind = PASSING; /* one cell is wrong */
		return true;
	}
	if (hill) {
		*kind = RETAINED;
		return guess_retained_unit_from_sum(s, total, scale);
	}
	if (s->rises > 0) {
		*kind = CUMULATIVE;
		double end = !isnan(s->pan) ? s->pan : s->last;
		if (!isnan(s->pan) && s->pan < s->last) {
			*kind = RETAINED;
			return guess_retained_unit_from_sum(s, total, scale);
		}
		if (end > 101)
			*scale = OF_MASS;
		return s->n > 2 && *scale != OF_MASS &&
		       (is_within_percent(end, 100, 10) ||
			   is_within_percent(end, 1, 10)) &&
		       s->sum > 1.2 * end;
	}
	if (!isnan(s->pan) && s->pan > 0.015 * s->most) {
		*kind = RETAINED; /* nothing passes the pan */
		return guess_retained_unit_from_sum(s, total, scale) &&
		       s->n > 2;
	}
	*kind = PASSING;
	if (s->most > 100.5) {
		*kind = RETAINED;
		*scale = OF_MASS;
		return !isnan(s->pan) && s->n > 2 && s->pan > 0;
	}
	if (*scale == OF_1)
		return is_within_percent(s->first, 1, 0.1) && s->n > 2 &&
		       s->falls > 1;
	return is_within_percent(s->first, 100, 0.6) ||
	       (!is_within_percent(s->sum, 100, 3) && s->n > 2 &&
		   s->first > 20);
}

/* True if the numbers can be the quantity that the heading states. */
static bool
can_numbers_be_quantity(const struct shape *s, enum unit_kind kind)
{
	bool falls = s->falls > 0, rises = s->rises > 0;
	if (kind == PASSING)
		return !rises || (falls && s->first >= 0.9 * s->most);
	if (kind == CUMULATIVE)
		return !falls || (rises && s->last >= 0.9 * s->most);
	return rises || !falls || s->n <= 2 ||
	       !(is_within_percent(s->first, 100, 1) ||
		   is_within_percent(s->first, 1, 0.1));
}

/* Decides whether a column headed "retained", whose numbers rise throughout, is
 * the mass on each sieve or cumulative.  Returns false if both are possible. */
static bool
choose_mass_or_cumulative(
    struct column *c, const struct shape *s, double total, enum unit_kind *kind)
{
	bool share = s->most <= 100.5 && (c->said.means & WORD_GRAMS) == 0;
	double whole = s->most <= 1.005 ? 1 : 100;
	*kind = CUMULATIVE;
	if (!isnan(s->pan) && s->pan < s->last)
		*kind = RETAINED;
	else if (share && is_within_percent(s->sum, whole, 1.05))
		*kind = RETAINED;
	else if (share && s->sum > 1.05 * whole &&
		 is_within_percent(s->most, whole, 25))
		assume(c, "cumulative: the parts would sum to %.3g", s->sum);
	else if (!isnan(total) && is_within_percent(s->sum, total, 1))
		*kind = RETAINED;
	else if (!(!isnan(s->pan) && !isnan(total) &&
		     is_within_percent(s->pan, total, 0.1) &&
		     s->sum > 1.05 * total))
		return false;
	return true;
}

/* Finds the scale that the heading states and the numbers allow.  Returns false
 * if it is unclear. */
static bool
choose_percent_or_grams(struct column *c, const struct shape *s,
    enum unit_kind kind, double total, enum unit_scale *scale)
{
	uint64_t means = c->said.means;
	double whole = kind == PASSING  ? s->first
		       : !isnan(s->pan) ? s->pan
					: s->last;
	bool one = s->most <= 1 + 1e-9;
	/* "g or %": the numbers decide. */
	if ((means & WORD_PERCENT) != 0 && (means & WORD_GRAMS) != 0)
		return kind == RETAINED &&
		       guess_retained_unit_from_sum(s, total, scale);
	if ((means & WORD_PERCENT) != 0) {
		*scale = OF_100;
		if (!one || s->most <= 0)
			return true;
		*scale = OF_1;
		return false;
	}
	if ((means & WORD_GRAMS) != 0) {
		*scale = OF_MASS;
		return kind != PASSING;
	}
	if ((means & WORD_SHARE) != 0) {
		/* 1.002 is taken for a fraction, and refused as too large. */
		one = one || (kind == PASSING && s->most <= 1.05);
		*scale = one ? OF_1 : OF_100;
		return one || (kind == PASSING &&
				  is_within_percent(s->first, 100, 0.6));
	}
	if ((means & WORD_MASS) != 0 && kind != PASSING &&
	    (!isnan(s->pan) || !isnan(total))) {
		*scale = OF_MASS;
		return true;
	}
	if (kind == RETAINED)
		return guess_retained_unit_from_sum(s, total, scale);
	*scale = one ? OF_1 : OF_100;
	if (s->most > 100.5) {
		*scale = OF_MASS;
		return kind == CUMULATIVE && !isnan(s->pan);
	}
	if (one && s->most > 0)
		return is_within_percent(whole, 1, 1.05) && s->n > 2;
	return kind == PASSING || is_within_percent(whole, 100, 25);
}

/* True, with *unit set, if the heading alone defines the unit: either the sheet
 * has the form of tipspeed-site(5), in which product@69 is per cent passing
 * unless its numbers both rise and fall; or the user gave the heading (told),
 * and its words leave nothing open. */
static bool
is_unit_defined_by_heading(
    const struct column *c, const struct shape *s, bool told, size_t *unit)
{
	uint64_t words = c->said.means & (KIND_WORDS | SCALE_WORDS);
	bool own = c->table->n_head == 1 && !c->table->across &&
		   strncmp(c->table->head[0].cell[0].text, "size_", 5) == 0;
	if (c->said.unknown > 0 || (!own && (!told || words == 0)))
		return false;
	for (size_t i = 0; i < SITE_N_UNIT; i++)
		if (lexicon_text_meanings(SITE_UNITS[i].suffix, NULL) ==
		    words) {
			*unit = i;
			return words != 0 ||
			       ((s->rises == 0 || s->falls == 0 ||
				    is_within_percent(s->first, 100, 0.6)) &&
				   s->most > 1);
		}
	return false;
}

/* True if the sieves are classes between two sieves, as for retained masses. */
static bool
has_size_classes(const struct table *t)
{
	/* 3/8 of an inch is not a class. */
	for (size_t i = 0; i < t->n_row && t->unit.series == SIEVE_NONE; i++)
		if (sieve_cell_is_class(t->sheet, t->row[i].cell[0]))
			return true;
	return false;
}

/* Reports a column that is called per cent but has no number above 1. */
static void
refuse_small_percentages(struct column *c, const struct shape *s)
{
	const struct site_unit *unit = &SITE_UNITS[c->unit];
	if (unit->scale != OF_100 || s->n < 3 || s->most > 1 ||
	    !is_within_percent(
		unit->kind == RETAINED ? s->sum : s->most, 1, 1.05))
		return;
	sheet_report_fault(c->table->sheet, c->head,
	    "expected %s, got nothing above 1 in column %zu\ncall it fraction, "
	    "retained_fraction or cum_retained_fraction",
	    tr(unit->words), c->table->number[c->at]);
}

/* Guesses the quantity of a column whose headings state none, in their unit if
 * they state one.  Returns false if it is unclear. */
static bool
guess_quantity_in_stated_unit(struct column *c, const struct shape *s,
    double total, enum unit_kind *kind, enum unit_scale *scale)
{
	uint64_t scales = c->said.means & SCALE_WORDS;
	bool sure = guess_quantity_from_numbers(s, total, kind, scale);
	if ((c->said.means & KIND_WORDS) == WORD_SUMS && *kind == RETAINED)
		sure = false;
	/* Grams that rise and fall are the masses on each sieve. */
	bool grams = (scales & WORD_GRAMS) != 0 &&
		     (scales & WORD_PERCENT) == 0 && *kind == RETAINED &&
		     s->rises > 0 && s->falls > 0;
	return scales == 0
		   ? sure
		   : choose_percent_or_grams(c, s, *kind, total, scale) &&
			 (sure || grams);
}

/* Takes the quantity that the headings state.  Returns false if it is
 * unclear. */
static bool
read_column_quantity_of_heading(struct column *c, const struct shape *s,
    double total, bool told, enum unit_kind *kind, enum unit_scale *scale)
{
	uint64_t kinds = c->said.means & KIND_WORDS;
	bool sure = true;
	*scale = OF_100;
	*kind = (kinds & WORD_PASSES) != 0 ? PASSING
		: (kinds & WORD_SUMS) != 0 ? CUMULATIVE
					   : RETAINED;
	bool both = (kinds & WORD_PASSES) != 0 && (kinds & WORD_STAYS) != 0;
	if (*kind == RETAINED && s->falls == 0 && s->rises > 1 && !told)
		sure = choose_mass_or_cumulative(c, s, total, kind);
	sure = choose_percent_or_grams(c, s, *kind, total, scale) && sure;
	bool possible = told || can_numbers_be_quantity(s, *kind);
	if (!possible) /* then propose what the numbers suggest */
		guess_quantity_from_numbers(s, total, kind, scale);
	bool falls = s->falls > 0 && s->rises == 0 && s->sum > 102;
	return sure && !both && possible &&
	       !(*kind == RETAINED && *scale == OF_100 && falls);
}

/* True if rows "-16 mm", "-11.2 mm" have the masses from each size down to the
 * next, and the last row what passes the finest: there is no pan, and
 * percentages or fractions sum to the whole. */
static bool
has_masses_down_to_next_size(const struct column *c, const struct shape *s)
{
	const struct site_unit *unit = &SITE_UNITS[c->unit];
	bool whole = unit->scale == OF_MASS ||
		     is_within_percent(s->sum, unit->most, 1.05);
	return c->table->below && unit->kind == RETAINED && isnan(s->pan) &&
	       whole;
}

static void
infer_column_quantity_and_unit(struct column *c, bool told)
{
	struct shape s = summarise_column_numbers(c);
	double total = stated_total_of_column(c);
	if (c->role == SD || s.n == 0)
		return;
	bool classes = has_size_classes(c->table);
	if (!classes && is_unit_defined_by_heading(c, &s, told, &c->unit)) {
		if (told)
			refuse_small_percentages(c, &s);
		c->to_next = has_masses_down_to_next_size(c, &s);
		return;
	}
	enum unit_kind kind;
	enum unit_scale scale;
	bool title = !told && c->table->basis != 0 &&
		     (c->said.means & (KIND_WORDS | SCALE_WORDS)) == 0;
	bool sure = true;
	if (title) { /* unless the numbers clearly are something else */
		c->said.means |= c->table->basis;
		sure =
		    !guess_quantity_from_numbers(&s, total, &kind, &scale) ||
		    (kind == PASSING) == ((c->table->basis & WORD_PASSES) != 0);
	}
	bool words = (c->said.means & (WORD_PASSES | WORD_STAYS)) != 0;
	sure = (words ? read_column_quantity_of_heading(
			    c, &s, total, told, &kind, &scale)
		      : guess_quantity_in_stated_unit(
			    c, &s, total, &kind, &scale)) &&
	       sure;
	bool doubtful = classes && kind != RETAINED;
	/* What is between two sieves does not include what is above. */
	if (classes && kind == CUMULATIVE)
		kind = RETAINED;
	c->unit = site_unit_index(kind, scale);
	bool usual = words || (kind == PASSING && scale == OF_100);
	if (!title && (!usual || (c->said.means & SCALE_WORDS) == 0))
		assume(c, "as %s", tr(SITE_UNITS[c->unit].words));
	c->to_next = has_masses_down_to_next_size(c, &s);
	if (c->to_next)
		assume(c, "from the size of each row down to the next");
	c->open = c->open || !sure || doubtful ||
		  (c->table->below && kind != PASSING && !c->to_next);
}

/* Returns the number without a unit that can be a tip speed in m/s: 63.6, but
 * not the 1 of "Prov 1"; 0 if there is none, or more than one.  It is from 30
 * to 100; if whole, from 40 on, and in a heading where it cannot number the
 * sample. */
static double
unitless_speed_in_heading(const struct head *said)
{
	double found = 0;
	bool numbered =
	    (said->means & WORD_SAMPLE) != 0 && (said->means & WORD_SPEED) == 0;
	if ((said->means & WORD_OTHER) != 0)
		return 0;
	for (size_t i = 0; i < said->n_number; i++) {
		double v = said->number[i];
		bool whole = v == floor(v);
		if (v < 30 || v > 100 || (whole && (numbered || v < 40)))
			continue;
		if (found > 0)
			return 0;
		found = v;
	}
	return found;
}

/* True if a heading is only a number that cannot be a tip speed, such as
 * minutes.  Then the numbers beside it are not speeds either. */
static bool
is_number_heading_but_no_speed(const struct head *said)
{
	uint64_t words = said->means & ~(uint64_t)WORD_FILLER;
	return said->n_number == 1 && said->unknown == 0 && words == 0 &&
	       said->unit == SPEED_NO_UNIT &&
	       (said->number[0] < 20 || said->number[0] > 110);
}

static void
infer_column_speed(struct column *c, const struct surroundings *near)
{
	const struct head *said = &c->said;
	double bare = unitless_speed_in_heading(said);
	bool told_rpm = said->rpm == 0 && !(near->speed > 0) && near->rpm > 0 &&
			c->role == PRODUCT && !(bare > 0);
	if (said->several) { /* none is proposed */
		c->open = true;
		return;
	}
	if (said->speed > 0) {
		c->speed = said->speed;
	} else if (said->rpm > 0 || told_rpm) {
		c->rpm = told_rpm ? near->rpm : said->rpm;
		c->speed = speed_in_unit_to_mps(c->rpm, SPEED_RPM, near->rotor);
	} else if (bare > 0 && said->unknown == 0) {
		c->speed = bare;
		/* A speed that spreads over the feed from the left may not be
		 * its own. */
		if (c->role != FEED || !said->spread)
			assume(c, "tip speeds in m/s");
	} else if (near->speed > 0 && c->role == PRODUCT) {
		c->speed = near->speed;
	}
	bool counted = c->rpm > 0 || said->unit == SPEED_FT_MIN;
	if (c->speed > SITE_FASTEST ||
	    (counted && c->speed > 0 && c->speed < 20)) {
		c->open = true;
		c->speed = c->rpm = 0;
	}
	if (c->speed > 0)
		c->speed = round(c->speed * 1e4) / 1e4;
}

static void
infer_column_role(struct column *c, const struct surroundings *near)
{
	uint64_t role = c->said.means & ROLE_WORDS;
	uint64_t context = near->context & (WORD_FEED | WORD_PRODUCT);
	c->role = NO_ROLE;
	c->open = c->open || (c->said.spread &&
				 is_heading_unlike_left_one(c->table, c->at));
	if ((role & WORD_SD) != 0)
		c->role = SD;
	else if (role == WORD_FEED)
		c->role = FEED;
	else if (role != 0 && role != WORD_PRODUCT)
		c->open = true;
	else if (role == WORD_PRODUCT || heading_has_speed(&c->said))
		c->role = PRODUCT;
	else if (context == WORD_FEED)
		c->role = FEED;
	else if (near->speed > 0 || near->rpm > 0 || context == WORD_PRODUCT ||
		 (unitless_speed_in_heading(&c->said) > 0 &&
		     c->said.unknown == 0))
		c->role = PRODUCT;
}

static void __attribute__((format(printf, 3, 4)))
leave_out(struct site *site, const struct column *c, const char *format, ...)
{
	va_list ap;
	va_start(ap, format);
	FREED char *what = xvasprintf(tr(format), ap);
	va_end(ap);
	/* "column 5"; or a line, if the samples are in lines. */
	FREED char *where =
	    xasprintf(c->table->across ? tr("line %zu") : tr("column %zu"),
		c->table->number[c->at]);
	/* Tables below each other have the same columns. */
	for (size_t i = 0; i < site->n_left_out; i++)
		if (strcmp(site->left_out[i].key, where) == 0 &&
		    strcmp(site->left_out[i].value, what) == 0)
			return;
	site_notes_append(&site->left_out, &site->n_left_out, where, what);
}

/* True if a column counts 1, 2, 3 and so on, up or down, or has the same number
 * throughout: it is not a curve. */
static bool
is_counting_or_constant_column(const struct column *c, const struct shape *s)
{
	double first = site_column_value_in_row(c, 0),
	       last = site_column_value_in_row(c, c->table->n_row - 1);
	bool whole = first == floor(first);
	bool small = fabs(first - 1) < 2 || fabs(last - 1) < 2;
	bool constant = s->same == s->pairs;
	bool limit = constant && (first == 100 || first == 0);
	bool speed =
	    constant && c->said.speed == 0 && c->said.unit != SPEED_NO_UNIT;
	return s->pairs > 2 && (whole || speed) && !limit &&
	       (c->said.means & ROLE_WORDS) == 0 &&
	       ((s->steps == s->pairs && small) || constant);
}

/* Leaves out a column that is not a sample, and notes why.  Returns true if it
 * was left out. */
static bool
leave_out_non_sample_column(const struct column *c, struct site *site)
{
	struct shape s = summarise_column_numbers(c);
	bool words = s.numbers * 2 < s.filled;
	uint64_t means = c->said.means;
	const char *head = c->head.text;
	uint64_t own = lexicon_text_meanings(head, NULL);
	uint64_t sample = ROLE_WORDS | KIND_WORDS;
	/* An empty column sd@70 says that a repeat has no deviations. */
	bool deviation = (means & WORD_SD) != 0 && heading_has_speed(&c->said);
	if (is_counting_or_constant_column(c, &s)) {
		leave_out(
		    site, c, "row numbers, or the same number in each row");
	} else if (s.filled == 0 && !deviation) {
		leave_out(site, c, "it is empty");
	} else if ((means & WORD_LIMIT) != 0 ||
		   ((own & WORD_LOSS) != 0 && (own & sample) == 0)) {
		leave_out(site, c,
		    "%s: looks like a limit, or calculated or rejected values",
		    head);
	} else if (words && (means & ROLE_WORDS) == 0) {
		const struct table *t = c->table;
		bool day =
		    t->day != NULL && t->day[c->at] != NULL &&
		    strcmp(t->day[c->at], t->row[0].cell[c->at].text) == 0;
		if (!day || site_find_unreadable_day(t, c->at) != NULL)
			leave_out(site, c, "%s: it contains words", head);
	} else if ((means & WORD_OTHER) != 0 && (means & sample) == 0) {
		leave_out(site, c, "%s: no sample", head);
	} else if ((means & (WORD_SIZE | WORD_MM | WORD_UM | WORD_MESH)) != 0 &&
		   (means & (sample | SCALE_WORDS)) == 0 &&
		   c->said.speed == 0 && !c->said.range) {
		leave_out(site, c, "%s: the sieves again", head);
	} else {
		return false;
	}
	return true;
}

/* Takes the speed of all samples from a column that repeats it in each row, as
 * in a long table with one sample. */
static void
set_speed_from_constant_column(
    const struct column *c, struct surroundings *near)
{
	static const uint64_t COUNTED = WORD_PASSES | WORD_STAYS |
					WORD_PERCENT | WORD_GRAMS | WORD_FEED |
					WORD_PRODUCT;
	bool about =
	    (c->said.means & WORD_SPEED) != 0 || c->said.unit != SPEED_NO_UNIT;
	if (!about || heading_has_speed(&c->said) ||
	    (c->said.means & COUNTED) != 0)
		return;
	struct shape s = summarise_column_numbers(c);
	if (s.least_of_all == s.most_of_all && s.most_of_all > 0)
		near->speed = speed_in_unit_to_mps(
		    s.most_of_all, c->said.unit, near->rotor);
}

/* Reports a column with the same mass throughout, that of empty sieves, beside
 * one of full sieves, unless headings explain them.  The mass retained is the
 * difference between the two. */
static void
refuse_tare_column(const struct column *column, size_t n)
{
	double tare = 0;
	for (size_t i = 0; i < n; i++) {
		const struct column *c = &column[i];
		struct shape s = summarise_column_numbers(c);
		bool whole = s.numbers == c->table->n_row &&
			     (c->said.means & (KIND_WORDS | ROLE_WORDS)) == 0;
		if (whole && tare > 0 && s.least_of_all >= tare &&
		    s.most_of_all > tare)
			sheet_report_fault(c->table->sheet,
			    c->table->row[0].cell[c->at],
			    "expected masses retained, got nothing below %g in "
			    "column %zu: empty and full sieves?\nwrite their "
			    "differences as a column: mass retained",
			    tare, c->table->number[c->at - 1]);
		bool same = whole && s.least_of_all == s.most_of_all;
		tare = same && s.most_of_all > 0 ? s.most_of_all : 0;
	}
}

/* Returns a new column with what its headings state. */
static struct column
make_column_from_headings(struct table *t, size_t at)
{
	struct column c = {.table = t, .at = at, .pan = NAN};
	bool own = false;
	c.head = t->row[0].cell[at];
	for (size_t r = t->n_head; r-- > 0 && !own;) {
		const struct cell *cell = find_heading_cell(t, r, at, &own);
		c.head = cell != NULL ? *cell : c.head;
	}
	const struct cell *name = samples_name_of_column(t, at);
	if (t->across && name != NULL)
		c.head = *name;
	c.said = combine_column_headings(t, at);
	return c;
}

/* True if a column is retained in a unit that only its numbers suggest. */
static bool
is_guessed_retained(const struct column *c, enum unit_scale scale)
{
	return c->unit == site_unit_index(RETAINED, scale) &&
	       (c->said.means & SCALE_WORDS) == 0 &&
	       isnan(stated_total_of_column(c));
}

/* Takes for percentages what was taken for masses only because it does not sum
 * to 100, if other columns of the table, from the ith on, are percentages.  The
 * sum is then reported. */
static void
take_odd_masses_for_percentages(struct columns *all, size_t i)
{
	size_t percent = 0;
	for (size_t k = i; k < all->n; k++)
		percent += is_guessed_retained(&all->column[k], OF_100);
	for (; percent > 0 && i < all->n; i++) {
		struct column *c = &all->column[i];
		struct shape s = summarise_column_numbers(c);
		if (is_guessed_retained(c, OF_MASS) && s.most <= 100.5 &&
		    s.sum > 50 && s.sum < 150)
			c->unit = site_unit_index(RETAINED, OF_100);
	}
}

/* Proposes for an open column, from the ith on, which may be mass on each sieve
 * or cumulative, what another one with the same words in its headings is. */
static void
propose_quantity_of_like_columns(struct columns *all, size_t i)
{
	const uint64_t words = KIND_WORDS | SCALE_WORDS;
	for (size_t first = i; i < all->n; i++) {
		struct column *c = &all->column[i];
		for (size_t k = first; c->open && k < all->n; k++) {
			const struct column *like = &all->column[k];
			if (!like->open && like->role != SD &&
			    SITE_UNITS[like->unit].kind != PASSING &&
			    SITE_UNITS[c->unit].kind != PASSING &&
			    ((like->said.means ^ c->said.means) & words) == 0)
				c->unit = like->unit;
		}
	}
}

void
classify_columns(struct table *t, const struct surroundings *near,
    struct columns *all, struct site *site)
{
	struct surroundings around = *near;
	struct error_list *errors = t->sheet->errors;
	FREED struct column *column = xcalloc(t->n_col, sizeof *column);
	size_t n = 0, first = all->n;
	bool counted = false; /* bare numbers in headings are not speeds */
	for (; n + 1 < t->n_col && !error_is_stop_requested(errors); n++) {
		column[n] = make_column_from_headings(t, n + 1);
		set_speed_from_constant_column(&column[n], &around);
		counted |= is_number_heading_but_no_speed(&column[n].said);
	}
	if (!around.told)
		refuse_tare_column(column, n);
	all->column =
	    xrealloc(all->column, all->n + t->n_col, sizeof *all->column);
	for (size_t i = 0; i < n && !error_is_stop_requested(errors); i++) {
		struct column c = column[i];
		if (counted && c.said.n_number == 1)
			c.said.n_number = 0;
		bool named = around.samples->n > 0;
		bool sheet = samples_is_sheet_named(around.samples, t->sheet);
		if (((!named || sheet) &&
			leave_out_non_sample_column(&c, site)) ||
		    (named && !samples_apply_to_column(around.samples, &c)))
			continue;
		infer_column_role(&c, &around);
		infer_column_speed(&c, &around);
		/* In a line, an empty cell below a speed may mean the same
		 * speed, or have been forgotten. */
		if (t->across && c.said.spread && c.role == PRODUCT)
			c.open = true;
		infer_column_quantity_and_unit(&c, around.told);
		all->column[all->n++] = c;
	}
	take_odd_masses_for_percentages(all, first);
	propose_quantity_of_like_columns(all, first);
}

static bool
is_reading_interrupted(const struct columns *all)
{
	return all->n > 0 &&
	       error_is_stop_requested(all->column[0].table->sheet->errors);
}

/* Returns the rank of a column among the quantities of one sample: masses
 * first, because they are exact and include the pan, then those that need the
 * least conversion; last masses that cannot be converted, as there is neither a
 * pan nor a total. */
static int
column_preference_by_quantity(const struct column *c)
{
	const struct site_unit *unit = &SITE_UNITS[c->unit];
	if (c->open)
		return 9;
	if (unit->kind == RETAINED && unit->scale == OF_MASS)
		return !isnan(summarise_column_numbers(c).pan) ||
			       !isnan(stated_total_of_column(c))
			   ? 0
			   : 4;
	return unit->kind == PASSING ? 1 : unit->kind == CUMULATIVE ? 2 : 3;
}

/* Returns the words in a column's headings that are unknown or have digits.
 * The caller frees the text. */
static char *
sample_name_from_headings(const struct column *c)
{
	FREED char *head = layout_column_heading_text(c->table, c->at);
	char *rest = head, *name = xstrdup("");
	for (char *word; (word = strtok_r(rest, " ,;()[]@", &rest));) {
		size_t unknown, n = strlen(word);
		lexicon_text_meanings(word, &unknown);
		if ((unknown > 0 && n > 1) ||
		    strpbrk(word, "0123456789") != NULL)
			xappend_to_list(&name, " ", "%s", word);
	}
	return name;
}

/* True if two columns are the same sample in two quantities, at least one of
 * which is stated. */
static bool
is_same_sample_in_other_quantity(const struct column *a, const struct column *b)
{
	bool stated =
	    ((a->said.means | b->said.means) & (KIND_WORDS | SCALE_WORDS)) != 0;
	/* Below a title, headings state quantities, so the 1 of "1-Q3" does not
	 * number a sample. */
	bool titled = a->role != NO_ROLE &&
		      ((a->said.means | b->said.means) & ROLE_WORDS) == 0;
	bool numbers = titled || a->speed > 0 ||
		       (a->said.n_number == b->said.n_number &&
			   (a->said.n_number == 0 ||
			       a->said.number[0] == b->said.number[0]));
	bool same = a->table == b->table && a->role == b->role &&
		    a->role != SD && fabs(a->speed - b->speed) < 1e-3 &&
		    a->rpm == b->rpm && numbers &&
		    (SITE_UNITS[a->unit].kind != SITE_UNITS[b->unit].kind ||
			SITE_UNITS[a->unit].scale != SITE_UNITS[b->unit].scale);
	if (!same || a->role != NO_ROLE || !stated)
		return same && a->role != NO_ROLE;
	FREED char *one = sample_name_from_headings(a),
		   *other = sample_name_from_headings(b);
	return text_is_same_folded(one, other);
}

/* Returns the words in a column's headings that tell its sample from others:
 * unknown words, and ranges such as 0/4.  Labels of one or two letters are
 * omitted, as are words that say when the sample was taken.  The caller frees
 * the text. */
static char *
distinctive_words_of_sample(const struct column *c)
{
	FREED char *head = layout_column_heading_text(c->table, c->at);
	FREED char *folded = text_fold_case_and_accents(head);
	char *words = xstrdup("");
	for (char *p = folded; *p != '\0';) {
		size_t n = strcspn(p, " ,;()[]@\n");
		bool dot = n > 1 && p[n - 1] == '.'; /* "Tue." */
		FREED char *word = xstrndup(p, n - dot);
		bool range = strchr(word, '/') != NULL &&
			     strspn(word, "0123456789/.") == n && n > 2;
		bool letters = strpbrk(word, "0123456789") == NULL && n > 2 &&
			       strcmp(word, "iii") != 0;
		struct datetime m;
		bool time =
		    datetime_parse(word, &m) || lexicon_is_word_of_time(word);
		size_t unknown;
		lexicon_text_meanings(word, &unknown);
		char *end = word + strcspn(word, "0123456789");
		bool machine = *end != '\0' && (lexicon_word_meanings(word,
						    (size_t)(end - word)) &
						   WORD_MACHINE) != 0;
		if (!time && (range || machine || (letters && unknown > 0)))
			xappend_to_list(&words, " ", "%s", word);
		p += n + (p[n] != '\0');
	}
	return words;
}

/* True if two samples at one speed may be repeats: their distinctive words, x
 * and y, are the same, and they do not come from machines with different
 * numbers. */
static bool
may_samples_be_repeats(const struct column *a, const char *x,
    const struct column *b, const char *y)
{
	bool machine = ((a->said.means | b->said.means) & WORD_MACHINE) != 0;
	return strcmp(x, y) == 0 &&
	       !(machine && a->said.n_number > 0 && b->said.n_number > 0 &&
		   a->said.number[0] != b->said.number[0]);
}

/* Marks as open the products of a table that a row of names, cell [t->n_col],
 * gives to different sites or machines. */
static void
mark_products_of_different_sites(
    struct columns *all, const struct table *t, const struct cell *cell)
{
	struct column *first = NULL;
	for (size_t i = 0; i < all->n; i++) {
		struct column *c = &all->column[i];
		if (c->table != t || c->role != PRODUCT ||
		    cell[c->at].text[0] == '\0')
			continue;
		first = first != NULL ? first : c;
		if (text_is_same_folded(cell[first->at].text, cell[c->at].text))
			continue;
		c->open = first->open = true;
		c->whose = cell[c->at].text;
		first->whose = cell[first->at].text;
	}
}

static void
mark_other_site_samples_to_ask(struct columns *all)
{
	const struct table *t = NULL;
	for (size_t i = 0; i < all->n && !is_reading_interrupted(all); i++) {
		if (all->column[i].table == t)
			continue;
		t = all->column[i].table;
		for (size_t r = 0; r < t->n_head; r++)
			if (lexicon_is_label_of_sites(t->head[r].cell[0].text))
				mark_products_of_different_sites(
				    all, t, t->head[r].cell);
		for (size_t r = 0; r < t->n_site; r++)
			mark_products_of_different_sites(
			    all, t, t->site[r].cell);
	}
}

static void
mark_unlike_repeats_to_ask(struct columns *all)
{
	FREED char **words = xcalloc(all->n, sizeof(*words));
	for (size_t i = 0; i < all->n && !is_reading_interrupted(all); i++) {
		struct column *a = &all->column[i];
		if (a->role != PRODUCT || !(a->speed > 0))
			continue;
		words[i] = distinctive_words_of_sample(a);
		for (size_t k = 0; k < i; k++) {
			struct column *b = &all->column[k];
			if (words[k] == NULL ||
			    fabs(a->speed - b->speed) > 1e-3 ||
			    a->table != b->table ||
			    may_samples_be_repeats(a, words[i], b, words[k]))
				continue;
			a->open = b->open = a->unlike = b->unlike = true;
		}
	}
	for (size_t i = 0; i < all->n; i++)
		free(words[i]);
}

/* Drops means of samples that are in the sheet themselves.  "Feed (avg)" is the
 * feed if there is no other. */
static void
drop_mean_columns(struct columns *all, struct site *site)
{
	for (size_t i = 0; i < all->n && !is_reading_interrupted(all); i++) {
		const struct column *c = &all->column[i];
		size_t others = 0;
		for (size_t k = 0; k < all->n; k++) {
			const struct column *o = &all->column[k];
			others += k != i && o->role == c->role &&
				  (o->said.means & WORD_MEAN) == 0 &&
				  fabs(o->speed - c->speed) < 1e-3;
		}
		bool mean = (c->said.means & WORD_MEAN) != 0;
		if (mean && others == 1 && c->speed > 0)
			all->column[i].open = true;
		if (!mean || (others < 2 && c->speed > 0) ||
		    (others == 0 && (all->n < 3 || c->role == FEED)))
			continue;
		leave_out(site, c, "%s: the mean of samples that are read",
		    c->head.text);
		site_column_drop(all, i--);
	}
}

static void
drop_columns_of_same_sample(struct columns *all, struct site *site)
{
	for (size_t i = 0; i < all->n && !is_reading_interrupted(all); i++)
		for (size_t k = 0; k < all->n; k++) {
			const struct column *a = &all->column[i];
			const struct column *b = &all->column[k];
			if (i == k || a->twin > 0 || b->twin > 0 ||
			    !is_same_sample_in_other_quantity(a, b) ||
			    column_preference_by_quantity(a) <
				column_preference_by_quantity(b) ||
			    (column_preference_by_quantity(a) ==
				    column_preference_by_quantity(b) &&
				i < k))
				continue;
			leave_out(site, a,
			    "%s: the sample of column %zu again, as %s",
			    a->head.text, b->table->number[b->at],
			    tr(SITE_UNITS[a->unit].words));
			all->column[i].twin = b->table->number[b->at];
			all->column[i].role = NO_ROLE;
			all->column[i].open = false;
			xfree_and_set(&all->column[i].assumed, NULL);
			break;
		}
}

/* If there is only one feed, makes it the feed of all runs, even if the speed
 * to its left spreads over it. */
static void
use_only_feed_for_all_runs(struct columns *all)
{
	bool only = site_column_count_by_role(all, NULL, FEED) == 1;
	for (size_t i = 0; i < all->n && only && all->n > 2; i++) {
		struct column *c = &all->column[i];
		if (c->role == FEED && c->said.spread)
			c->speed = c->rpm = 0;
	}
}

/* Returns false if two feeds have the same heading, as they may be repeats. */
static bool
are_feed_headings_distinct(const struct columns *all)
{
	for (size_t i = 0; i < all->n; i++)
		for (size_t k = 0; k < i; k++) {
			const struct column *a = &all->column[i],
					    *b = &all->column[k];
			FREED char *one =
			    layout_column_heading_text(a->table, a->at);
			FREED char *two =
			    layout_column_heading_text(b->table, b->at);
			if (a->role == FEED && b->role == FEED &&
			    text_is_same_folded(one, two))
				return false;
		}
	return true;
}

/* True if there are as many feeds as products, and their order pairs them:
 * feeds and products alternate, or three or more feeds come all before or all
 * after the products.  The feeds have no speed, or that of the product to their
 * left, which spreads over them. */
static bool
are_feeds_in_order_of_products(const struct columns *all)
{
	size_t feeds = 0, changes = 0;
	for (size_t i = 0; i < all->n; i++) {
		const struct column *c = &all->column[i];
		bool feed = c->role == FEED &&
			    (!(c->speed > 0) || (feeds > 0 && c->said.spread));
		bool product =
		    c->role == PRODUCT && c->speed > 0 && !c->said.spread;
		if ((!feed && !product) || c->table != all->column[0].table)
			return false;
		feeds += feed;
		changes += i > 0 && c->role != c[-1].role;
	}
	return 2 * feeds == all->n && ((feeds >= 2 && changes + 1 == all->n) ||
					  (feeds >= 3 && changes == 1 &&
					      are_feed_headings_distinct(all)));
}

/* Gives each feed the speed of a product, in their order. */
static void
assign_product_speeds_to_feeds(struct columns *all)
{
	if (!are_feeds_in_order_of_products(all))
		return;
	struct column *product = all->column;
	for (size_t i = 0; i < all->n; i++) {
		struct column *feed = &all->column[i];
		if (feed->role != FEED)
			continue;
		while (product->role != PRODUCT)
			product++;
		feed->speed = product->speed;
		feed->rpm = product->rpm;
		assume(feed, "feeds of the products, in their order");
		product++;
	}
}

/* If no column is called feed, and only one has no role, takes that for the
 * feed. */
static void
guess_feed_column(struct columns *all, size_t feeds)
{
	struct column *only = NULL;
	size_t n = 0;
	for (size_t i = 0; i < all->n; i++) {
		if (all->column[i].role != NO_ROLE || all->column[i].twin > 0)
			continue;
		only = &all->column[i];
		n++;
	}
	if (n != 1 || feeds > 0)
		return;
	only->role = FEED;
	/* A file with one sample, beside a file of products, has the feed. */
	size_t own = 0, others = 0;
	const char *path = only->table->sheet->path;
	for (size_t i = 0; i < all->n; i++) {
		const struct column *c = &all->column[i];
		bool same = strcmp(c->table->sheet->path, path) == 0;
		own += same && c->twin == 0;
		others += !same;
	}
	if (own == 1 && others > 0)
		assume(only, "as the feed");
	else
		only->open = true;
}

/* Numbers a column among those of its role and speed.  A speed within 1e-3 m/s
 * of that of a column before becomes equal to it, so that of three speeds in a
 * row the first and the last do not count as one and as two. */
static void
number_column_of_speed(struct columns *all, size_t i)
{
	struct column *c = &all->column[i];
	c->nth = 0;
	for (size_t k = 0; k < i; k++) {
		const struct column *before = &all->column[k];
		if (fabs(before->speed - c->speed) > 1e-3)
			continue;
		c->speed = before->speed;
		c->nth += before->role == c->role;
	}
}

void
classify_columns_together(
    struct columns *all, struct site *site, bool told, bool *wants_rotor)
{
	size_t feeds = site_column_count_by_role(all, NULL, FEED);
	size_t products = site_column_count_by_role(all, NULL, PRODUCT);
	for (size_t i = 0; i < all->n && !is_reading_interrupted(all); i++) {
		struct column *c = &all->column[i];
		*wants_rotor |= c->rpm > 0 && !(c->speed > 0);
		if (c->role != NO_ROLE)
			continue;
		struct shape s = summarise_column_numbers(c);
		enum unit_kind kind;
		enum unit_scale scale;
		bool curve = s.n > 2 && guess_quantity_from_numbers(
					    &s, NAN, &kind, &scale);
		bool unknown =
		    c->said.unknown > 0 && !curve &&
		    (c->said.means & (KIND_WORDS | SCALE_WORDS)) == 0;
		if (unknown && feeds + products > 0) {
			leave_out(site, c, "%s: neither feed nor product",
			    c->head.text);
			site_column_drop(all, i--);
		}
	}
	drop_mean_columns(all, site);
	drop_columns_of_same_sample(all, site);
	guess_feed_column(all, feeds);
	use_only_feed_for_all_runs(all);
	assign_product_speeds_to_feeds(all);
	if (!told) {
		mark_unlike_repeats_to_ask(all);
		mark_other_site_samples_to_ask(all);
	}
	for (size_t i = 0; i < all->n && !is_reading_interrupted(all); i++) {
		struct column *c = &all->column[i];
		if (c->twin > 0)
			continue;
		c->open = c->open || c->role == NO_ROLE ||
			  (c->role != FEED && !(c->speed > 0));
		number_column_of_speed(all, i);
	}
}

char *
classify_describe_column(const struct column *c)
{
	char speed[32];
	const char *role = c->role == NO_ROLE ? "product" : SITE_ROLES[c->role];
	char *text = xstrdup(role);
	bool wants = c->role != FEED;
	if (c->speed > 0)
		xappend(
		    &text, "@%s", text_shortest_exact_number(c->speed, speed));
	else if (wants)
		xappend(&text, "@SPEED");
	const char *suffix = SITE_UNITS[c->unit].suffix;
	if (c->role != SD)
		xappend(&text, " %s",
		    suffix[0] != '\0' ? suffix + 1 : "passing_pct");
	return text;
}

/* From the column heading to its role, unit and speed, and from its cells to
 * passing in percent.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/site_column.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "base/xalloc.h"

const char *const SITE_ROLES[3] = {"feed", "product", "sd"};

const struct site_unit SITE_UNITS[SITE_N_UNIT] = {
    {"", PASSING, 100, "passing from 0 to 100 %"},
    {"_passing_pct", PASSING, 100, "passing from 0 to 100 %"},
    {"_fraction", FRACTION, 1, "a fraction from 0 to 1"},
    {"_retained_g", RETAINED_G, 1e12, "mass retained, 0 g or more"},
    {"_retained_pct", RETAINED_PCT, 100, "mass retained, 0 to 100 %"},
    {"_cum_retained_pct", CUM_RETAINED, 100, "mass retained, 0 to 100 %"},
};

/* Speeds nearer than this, m/s, are one run, as for site_run_at. */
static const double SAME_SPEED = 1e-3;

/* Above this a tip speed is a slip of the pen; m/s. */
static const double FASTEST = 200;

static bool
is_of(const struct column *c, enum role role, double speed)
{
	return c->role == role && fabs(c->speed - speed) <= SAME_SPEED;
}

size_t
site_column_repeats(const struct table *t, enum role role, double speed)
{
	size_t n = 0;
	for (size_t i = 0; i < t->n_column; i++)
		n += is_of(&t->column[i], role, speed);
	return n;
}

struct column *
site_column_find(
    const struct table *t, enum role role, double speed, size_t nth)
{
	size_t wanted = site_column_repeats(t, role, speed) > 1 ? nth : 0;
	for (size_t i = 0; i < t->n_column; i++)
		if (is_of(&t->column[i], role, speed) &&
		    t->column[i].nth == wanted)
			return &t->column[i];
	return NULL;
}

/* What the words of a head say: whose numbers, and what they count. */
enum {
	A_FEED = 1,
	A_PRODUCT = 2,
	AN_SD = 4,
	PASSES = 8,
	STAYS = 16,
	SUMS = 32,
	SHARE = 64,
	PERCENT = 128,
	GRAMS = 256
};

/* What heads are made of, here and in Swedish plants. */
static const struct {
	const char *word;
	unsigned means;
} WORDS[] = {{"feed", A_FEED}, {"ingaende", A_FEED}, {"inmatning", A_FEED},
    {"pamatning", A_FEED}, {"product", A_PRODUCT}, {"produkt", A_PRODUCT},
    {"utgaende", A_PRODUCT}, {"sd", AN_SD}, {"standardavvikelse", AN_SD},
    {"passing", PASSES}, {"pass", PASSES}, {"passerande", PASSES},
    {"retained", STAYS}, {"siktrest", STAYS}, {"cum", SUMS},
    {"cumulative", SUMS}, {"ack", SUMS}, {"ackumulerad", SUMS},
    {"fraction", SHARE}, {"andel", SHARE}, {"pct", PERCENT}, {"%", PERCENT},
    {"procent", PERCENT}, {"g", GRAMS}, {"gram", GRAMS}, {"at", 0}, {"vid", 0},
    {"material", 0}, {"mangd", 0}, {"rotorhastighet", 0},
    {"periferihastighet", 0}};

/* Which words say which row of SITE_UNITS. */
static const struct {
	unsigned words;
	size_t unit;
} UNITS[] = {{0, 0}, {PERCENT, 1}, {PASSES, 1}, {PASSES | PERCENT, 1},
    {SUMS | PASSES, 1}, {SUMS | PASSES | PERCENT, 1}, {SHARE, 2},
    {PASSES | SHARE, 2}, {GRAMS, 3}, {STAYS | GRAMS, 3}, {STAYS | PERCENT, 4},
    {SUMS | STAYS | PERCENT, 5}};

/* What the words of n bytes of a folded head mean together; false where one is
 * not understood. */
static bool
read_words(const char *text, size_t n, unsigned *means)
{
	static const char BETWEEN[] = " _-.,:()[]";
	const char *end = text + n;
	for (*means = 0; text < end; text += n) {
		n = 1;
		if (strchr(BETWEEN, *text) != NULL)
			continue;
		while (text[0] != '%' && text + n < end && text[n] != '%' &&
		       strchr(BETWEEN, text[n]) == NULL)
			n++;
		size_t w = 0;
		while (w < ARRAY_LEN(WORDS) &&
		       (strlen(WORDS[w].word) != n ||
			   strncmp(WORDS[w].word, text, n) != 0))
			w++;
		if (w == ARRAY_LEN(WORDS))
			return false;
		*means |= WORDS[w].means;
	}
	return true;
}

/* Role and unit.  Of a unit alone (retained_g@69), and of a speed alone
 * (69 m/s), the product's. */
static bool
find_role(unsigned means, bool has_speed, struct column *c)
{
	unsigned role = means & (A_FEED | A_PRODUCT | AN_SD);
	unsigned words = means & ~role;
	c->role = role == A_FEED ? FEED : role == AN_SD ? SD : PRODUCT;
	if (role == AN_SD)
		return words == 0;
	for (size_t i = 0; i < ARRAY_LEN(UNITS); i++) {
		c->unit = UNITS[i].unit;
		if (words == UNITS[i].words)
			return role == A_FEED || role == A_PRODUCT ||
			       (role == 0 && (words != 0 || has_speed));
	}
	return false;
}

/* What to do about a speed that is none: people write the rotor's turns, the
 * day of the sample or the unit of the column. */
static const char *
speed_hint(const char *text, double v)
{
	/* Digits, a sign, digits and that sign again. */
	size_t n = strspn(text, "0123456789");
	size_t m = text[n] != '\0' ? strspn(text + n + 1, "0123456789") : 0;
	bool sign = text[n] == '-' || text[n] == '/' || text[n] == '.';
	if (n > 0 && m > 0 && sign && text[n + 1 + m] == text[n])
		return "write a date in the header lines (sampled,2026-11-02), "
		       "and the tip speed after @, as in product@69";
	if (v > FASTEST || strstr(text, "rpm") != NULL ||
	    strstr(text, "varv") != NULL || strstr(text, "/min") != NULL)
		return "is this rpm? tip speed (m/s) = 3.1416 x rotor diameter "
		       "(m) x rpm / 60, as in product@69";
	n = strlen(text);
	if (n > 1 &&
	    (strcmp(text + n - 2, " g") == 0 || strstr(text, "(g)") != NULL))
		return "write the unit before the @: product_retained_g@69";
	return "write the speed with its unit, or after @: product 69 m/s or "
	       "product@69";
}

/* 69, 69.5, "69 m/s" or 69m/s; text is changed. */
static bool
find_speed(struct table *t, char *text, struct column *c)
{
	size_t n = strlen(text);
	if (n >= 3 && strcmp(text + n - 3, "m/s") == 0)
		text[n - 3] = '\0';
	char *comma = strchr(text, ',');
	if (comma != NULL && t->sheet->separator != ',')
		*comma = '.';
	double v = 0;
	bool good = text_number(text, &v);
	c->speed = v;
	if (good && v > SAME_SPEED && v <= FASTEST)
		return true;
	return sheet_wanted(t->sheet, c->head,
	    "a tip speed above 0, up to 200 m/s", "%s",
	    speed_hint(text, good ? v : 0));
}

/* The speed's text, cut out of the head: what stands after @, or before m/s;
 * NULL where it has none.  The caller frees. */
static char *
cut_speed(char *word)
{
	char *at = strchr(word, '@'), *unit = strstr(word, "m/s");
	char *from = unit;
	if (at != NULL) {
		*at = '\0';
		return xstrdup(text_trim(at + 1));
	}
	if (unit == NULL)
		return NULL;
	while (from > word && from[-1] == ' ')
		from--;
	while (from > word && strchr("0123456789.,", from[-1]) != NULL)
		from--;
	/* The comma of "Produkt,69 m/s". */
	from += strspn(from, ".,");
	char *speed = xstrndup(from, (size_t)(unit - from));
	memset(from, ' ', (size_t)(unit + 3 - from));
	return speed;
}

static bool
refuse_head(struct table *t, const struct column *c, const char *word)
{
	unsigned means;
	size_t n = strcspn(word, "0123456789");
	const char *hint =
	    "use feed, feed@69, product@69 or sd@69; feed and product may have "
	    "_fraction, _passing_pct, _retained_g, _retained_pct or "
	    "_cum_retained_pct before the @; remove other columns";
	bool turns =
	    strstr(word, "rpm") != NULL || strstr(word, "varv") != NULL;
	if (word[n] != '\0' && (n == 0 || turns ||
				   (read_words(word, n, &means) &&
				       (means & (A_FEED | A_PRODUCT)) != 0)))
		hint = speed_hint(turns ? word : word + n, 0);
	else if (read_words(word, strlen(word), &means) && (means & STAYS) != 0)
		hint = "state grams or per cent: product_retained_g@69 or "
		       "product_retained_pct@69";
	else if (t->told_heads)
		hint = "remove the column, or change its heading likewise";
	else
		t->told_heads = true;
	return sheet_wanted(t->sheet, c->head, "a column heading", "%s", hint);
}

/* Only the feed of all runs may be without a speed. */
static bool
split_head(struct table *t, char *word, struct column *c)
{
	unsigned means;
	char *speed = cut_speed(word);
	bool good = (read_words(word, strlen(word), &means) &&
			find_role(means, speed != NULL, c)) ||
		    refuse_head(t, c, word);
	c->speed = 0;
	if (good && speed != NULL)
		good = find_speed(t, speed, c);
	else if (good && c->role != FEED)
		good = sheet_wanted(t->sheet, c->head,
		    "a column heading with a tip speed",
		    "write the speed in m/s after @: %s%s@69",
		    SITE_ROLES[c->role], SITE_UNITS[c->unit].suffix);
	free(speed);
	return good;
}

/* Takes the number off the end of "product@69 (2)", as repeats are shown; their
 * order is that of the columns. */
static void
cut_repeat(char *word)
{
	char *open = strrchr(word, '(');
	size_t n = open != NULL ? strspn(open + 1, "0123456789") : 0;
	if (n == 0 || strcmp(open + 1 + n, ")") != 0)
		return;
	*open = '\0';
	if (strchr(word, '@') == NULL && strstr(word, "m/s") == NULL)
		*open = '(';
}

/* Whether it may stand beside an earlier column of its role and speed: the one
 * feed has no repeats, and what is given in another unit as well is rather the
 * same sample. */
static bool
may_repeat(const struct column *c, const struct column *twin)
{
	return c->speed > 0 &&
	       SITE_UNITS[c->unit].kind == SITE_UNITS[twin->unit].kind;
}

bool
site_column_head(struct table *t, struct column *c)
{
	char *word = text_fold(c->head.text);
	cut_repeat(word);
	bool good = split_head(t, word, c);
	free(word);
	if (!good)
		return false;
	c->nth = site_column_repeats(t, c->role, c->speed);
	const struct column *twin = site_column_find(t, c->role, c->speed, 0);
	if (twin == NULL || may_repeat(c, twin))
		return true;
	return sheet_fault(t->sheet, c->head,
	    "duplicate column: %s is already at column %d\n"
	    "keep one of the two%s",
	    c->head.text, twin->head.column,
	    c->speed > 0 ? "; repeats at one speed have one unit" : "");
}

/* Percent that the parts of a sieving may miss of the whole. */
static const double SUM_TOLERANCE = 0.5;

/* Of the mass put on the sieves, as EN 933-1 allows. */
static const double MASS_TOLERANCE = 0.01;

double
site_column_round(double v, double per_unit)
{
	return round(v * per_unit) / per_unit + 0.0;
}

size_t
site_column_count(const struct table *t, const struct column *c)
{
	size_t n = 0;
	for (size_t i = 0; i < t->n_row; i++)
		n += t->mm[i] > 0 && !isnan(c->pct[i]);
	return n;
}

static bool
is_retained(const struct column *c)
{
	enum unit_kind kind = SITE_UNITS[c->unit].kind;
	return kind == RETAINED_G || kind == RETAINED_PCT;
}

/* "product_fraction@69": the header of c with another unit. */
static const char *
other_head(const struct column *c, const char *suffix, char buf[static 64])
{
	char speed[32] = "";
	if (c->speed > 0)
		text_exact(c->speed, speed);
	snprintf(buf, 64, "%s%s%s%s", SITE_ROLES[c->role], suffix,
	    c->speed > 0 ? "@" : "", speed);
	return buf;
}

static bool
in_range(struct table *t, struct column *c, struct cell cell, double v)
{
	char head[64];
	if (c->role == SD && (v > 100 || site_column_round(v, 1e12) <= 0))
		return sheet_wanted(t->sheet, cell,
		    "a standard deviation above 0, up to 100",
		    "write it in percentage points of passing");
	if (v >= 0 && v <= SITE_UNITS[c->unit].most)
		return true;
	bool percent = SITE_UNITS[c->unit].kind == FRACTION && v > 1;
	/* One percent in a column of fractions says it for all of them. */
	if (percent && c->told_percent)
		return false;
	c->told_percent = c->told_percent || percent;
	return sheet_wanted(t->sheet, cell, SITE_UNITS[c->unit].wanted,
	    percent ? "divide by 100, or change the column heading to %s"
		    : "check the number%.0s",
	    other_head(c, "", head));
}

/* The pan holds what no sieve holds; a curve of passing ends there at 0. */
static bool
read_pan(struct table *t, struct column *c, struct cell cell, double v)
{
	c->pan = v;
	bool cumulative = SITE_UNITS[c->unit].kind == CUM_RETAINED;
	if (is_retained(c))
		return in_range(t, c, cell, v);
	if (v == (cumulative ? 100 : 0))
		return true;
	return sheet_wanted(t->sheet, cell,
	    cumulative ? "100 % above the pan" : "nothing passing the pan",
	    "leave the cell empty");
}

static void
read_cells(struct table *t, struct column *c)
{
	for (size_t i = 0; i < t->n_row; i++) {
		struct cell cell = sheet_cell(&t->row[i], c->at);
		double v;
		c->pct[i] = NAN;
		if (cell.text[0] == '\0' || t->row[i].n > t->head->n)
			continue;
		bool good = sheet_number(t->sheet, cell, "a number", &v);
		if (good && t->mm[i] <= 0)
			good = read_pan(t, c, cell, v);
		else if (good && (good = in_range(t, c, cell, v)))
			c->pct[i] = v;
		c->faulty = c->faulty || !good;
	}
}

/* What a column of passing seems to have instead: "_retained_pct" or
 * "_retained_g", or NULL. sum: of its numbers.  Passing falls from its first
 * number; what sieves retain rises to its largest and falls again, and sums to
 * 100 %, less a pan that is not there, or to any number of grams. */
static const char *
seems_retained(const struct table *t, const struct column *c, double *sum)
{
	double first = NAN, last = NAN, largest = 0;
	size_t rises = 0, falls = 0;
	*sum = 0;
	for (size_t i = 0; i < t->n_row; i++) {
		double v;
		struct cell cell = sheet_cell(&t->row[i], c->at);
		if (cell.text[0] == '\0' || isnan(t->mm[i]))
			continue;
		if (!sheet_value(t->sheet, cell, &v))
			return NULL;
		*sum += v;
		rises += v > last;
		falls += v < last;
		first = isnan(first) ? v : first;
		largest = fmax(largest, v);
		last = v;
	}
	bool hill = first <= largest / 2;
	double most = 100 + 2 * SUM_TOLERANCE, least = hill ? 90 : 200 - most;
	if (rises > 0 && t->told_retained)
		return ""; /* one of the others like it */
	if (rises == 0 || falls == 0 || *sum < least)
		return NULL;
	if (*sum <= most)
		return "_retained_pct";
	return hill && rises > 1 ? "_retained_g" : NULL;
}

/* One guess for the sheet, in place of a fault for each cell. */
static void
tell_retained(struct table *t, struct column *c, const char *suffix, double sum)
{
	char head[64];
	c->faulty = true;
	for (size_t i = 0; i < t->n_row; i++)
		c->pct[i] = NAN;
	if (t->told_retained)
		return;
	t->told_retained = true;
	bool grams = strcmp(suffix, "_retained_g") == 0;
	sheet_fault(t->sheet, c->head,
	    "expected passing in column %s; this looks like %s retained on "
	    "each sieve%s: the numbers rise and fall and sum to %.9g\n"
	    "change the column heading to %s, and other such columns likewise",
	    c->head.text, grams ? "grams" : "mass", grams ? "" : ", %",
	    site_column_round(sum, 10), other_head(c, suffix, head));
}

/* A column of percent without any above 1. */
static void
check_percent(struct table *t, struct column *c)
{
	char head[64];
	double most = isnan(c->pan) ? 0 : c->pan;
	for (size_t i = 0; i < t->n_row; i++)
		most = c->pct[i] > most ? c->pct[i] : most;
	bool percent = c->role != SD && SITE_UNITS[c->unit].most == 100;
	if (!percent || most <= 0 || most > 1)
		return;
	sheet_fault(t->sheet, c->head,
	    "expected percent, got nothing above %g in column %s\n"
	    "multiply by 100, or change the column heading to %s",
	    most, c->head.text, other_head(c, "_fraction", head));
	c->faulty = true;
}

/* Whether a sheet's own total is the sum of the column, or it has none. */
static bool
agrees(struct table *t, const struct column *c, double sum)
{
	double total;
	struct cell cell = {0};
	if (t->total != NULL)
		cell = sheet_cell(t->total, c->at);
	if (t->total == NULL || cell.text[0] == '\0')
		return true;
	if (!sheet_number(t->sheet, cell, "a number", &total))
		return false;
	return fabs(total - sum) <= MASS_TOLERANCE * total ||
	       sheet_fault(t->sheet, cell,
		   "expected %.9g g, the sum of column %s, got %s\n"
		   "up to %g %% may be lost in sieving: were digits "
		   "transposed, or a sieve forgotten?",
		   site_column_round(sum, 1e6), c->head.text, cell.text,
		   100 * MASS_TOLERANCE);
}

/* What the sieves and the pan hold together: the mass in g, or 100 %.  0 after
 * a fault. */
static double
total_retained(struct table *t, struct column *c)
{
	char head[64];
	bool grams = SITE_UNITS[c->unit].kind == RETAINED_G;
	double sum = isnan(c->pan) ? 0 : c->pan;
	for (size_t i = 0; i < t->n_row; i++)
		sum += isnan(c->pct[i]) ? 0 : c->pct[i];
	if (grams && isnan(c->pan)) {
		sheet_fault(t->sheet, c->head,
		    "expected the mass in the pan, got none in column %s\n"
		    "add a last row: pan, with the mass below the finest sieve "
		    "(0 if there was none)",
		    c->head.text);
	} else if (grams && !(sum > 0)) {
		sheet_fault(t->sheet, c->head,
		    "expected a mass, got 0 g in column %s\n"
		    "fill the column or remove it",
		    c->head.text);
	} else if (!grams &&
		   (sum > 100 + SUM_TOLERANCE ||
		       (!isnan(c->pan) && sum < 100 - SUM_TOLERANCE))) {
		sheet_fault(t->sheet, c->head,
		    "expected retained percentages that sum to 100 %%, got %g "
		    "in column %s\n"
		    "check the numbers, or change the column heading to %s",
		    sum, c->head.text,
		    other_head(c, "_cum_retained_pct", head));
	} else {
		return !grams || agrees(t, c, sum) ? (grams ? sum : 100) : 0;
	}
	return 0;
}

/* Retained on each sieve to passing: what is left below. */
static void
convert_retained(struct table *t, struct column *c)
{
	double total = c->faulty || t->lost ? 0 : total_retained(t, c);
	double left = total;
	c->faulty = total <= 0;
	for (size_t i = 0; i < t->n_row; i++) {
		if (isnan(c->pct[i]))
			continue;
		left -= c->pct[i];
		c->pct[i] = total > 0 ? 100 * fmax(left, 0) / total : NAN;
	}
}

/* To percent passing with 12 decimals, as site_write writes it. */
static void
convert(struct table *t, struct column *c)
{
	enum unit_kind kind = SITE_UNITS[c->unit].kind;
	if (is_retained(c))
		convert_retained(t, c);
	for (size_t i = 0; i < t->n_row; i++) {
		double v = c->pct[i];
		if (kind == FRACTION)
			v *= 100;
		else if (kind == CUM_RETAINED)
			v = 100 - v;
		c->pct[i] = site_column_round(v, 1e12);
	}
}

static void
check_rise(struct table *t, struct column *c)
{
	char p[32], q[32], mm[32];
	size_t last = t->n_row;
	for (size_t i = 0; i < t->n_row; i++) {
		if (isnan(c->pct[i]) || isnan(t->mm[i]))
			continue;
		bool finer = last < t->n_row && t->mm[i] < t->mm[last];
		if (finer && c->pct[i] > c->pct[last])
			sheet_fault(t->sheet, sheet_cell(&t->row[i], c->at),
			    "passing rises from %s to %s at %s mm (finer "
			    "sieve, more passing)\n"
			    "check this row and the one above: passing cannot "
			    "rise on a finer sieve",
			    text_exact(c->pct[last], p),
			    text_exact(c->pct[i], q), text_exact(t->mm[i], mm));
		last = i;
	}
}

/* The feed's largest grains must be known: some sieve passes them all. */
static void
check_coarsest(struct table *t, struct column *c)
{
	static const double series[] = {63, 45, 31.5, 22.4, 16, 11.2, 8, 5.6, 4,
	    2, 1, .5, .25, .125, .063}; /* EN 933, mm */
	char p[32], mm[32], next[64];
	size_t i = 0, s = ARRAY_LEN(series);
	while (i < t->n_row && (isnan(c->pct[i]) || !(t->mm[i] > 0)))
		i++;
	if (i == t->n_row || c->pct[i] >= 100)
		return;
	while (s > 0 && series[s - 1] <= t->mm[i])
		s--;
	const char *all =
	    is_retained(c) || SITE_UNITS[c->unit].kind == CUM_RETAINED ? "0"
	    : SITE_UNITS[c->unit].kind == FRACTION                     ? "1"
								       : "100";
	text_exact(t->mm[i], mm);
	if (s > 0)
		snprintf(next, sizeof next, "%g mm", series[s - 1]);
	else
		snprintf(next, sizeof next, "a sieve coarser than %s mm", mm);
	sheet_fault(t->sheet, sheet_cell(&t->row[i], c->at),
	    "expected 100 %% passing on the coarsest feed sieve, got %s %% at "
	    "%s mm\n"
	    "add %s with %s",
	    text_exact(c->pct[i], p), mm, next, all);
}

/* "97,5 %" is 97,5 in a column of per cent, "42,5 g" 42,5 in one of grams. */
static void
drop_unit(struct table *t, const struct column *c)
{
	bool grams = SITE_UNITS[c->unit].kind == RETAINED_G;
	size_t rows = t->n_row + (t->total != NULL); /* the sums are next */
	for (size_t i = 0; i < rows; i++) {
		char *text = sheet_cell(&t->row[i], c->at).text;
		size_t n = strlen(text);
		if (n < 2 || text[n - 1] != (grams ? 'g' : '%'))
			continue;
		n -= n > 3 && memcmp(text + n - 3, "\xC2\xA0", 2) == 0 ? 3
		     : text[n - 2] == ' '                              ? 2
								       : 1;
		text[n] = '\0';
	}
}

void
site_column_values(struct table *t, struct column *c)
{
	c->pct = xdoubles(t->n_row);
	c->pan = NAN;
	double sum;
	if (SITE_UNITS[c->unit].kind != FRACTION)
		drop_unit(t, c);
	const char *suffix =
	    c->role != SD && SITE_UNITS[c->unit].kind == PASSING
		? seems_retained(t, c, &sum)
		: NULL;
	if (suffix != NULL) {
		tell_retained(t, c, suffix, sum);
		return;
	}
	read_cells(t, c);
	check_percent(t, c);
	convert(t, c);
	if (c->role != SD)
		check_rise(t, c);
	if (c->role == FEED && !c->faulty && !t->lost)
		check_coarsest(t, c);
	size_t least = c->role == FEED ? 2 : 1;
	if (c->role == SD || c->faulty || t->lost ||
	    site_column_count(t, c) >= least)
		return;
	sheet_fault(t->sheet, c->head,
	    "expected %zu or more sieves, got %zu in column %s\n"
	    "fill the column or remove it",
	    least, site_column_count(t, c), c->head.text);
}

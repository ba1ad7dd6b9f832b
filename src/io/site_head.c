/* From the head of a column to its role, unit and speed.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "base/xalloc.h"
#include "io/site_column.h"

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

struct column *
site_column_find(const struct table *t, enum role role, double speed)
{
	for (size_t i = 0; i < t->n_column; i++)
		if (t->column[i].role == role &&
		    fabs(t->column[i].speed - speed) <= SAME_SPEED)
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

/* The speed's text, cut out of the head: what stands behind @, or before m/s;
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

bool
site_column_head(struct table *t, struct column *c)
{
	char *word = text_fold(c->head.text);
	bool good = split_head(t, word, c);
	free(word);
	if (!good)
		return false;
	const struct column *twin = site_column_find(t, c->role, c->speed);
	if (twin == NULL)
		return true;
	return sheet_fault(t->sheet, c->head,
	    "duplicate column: %s is already at column %d\n"
	    "%s",
	    c->head.text, twin->head.column,
	    c->speed > 0 && c->unit == twin->unit
		? "average the two, or change one speed: each run needs a "
		  "speed of its own"
		: "keep one of the two");
}

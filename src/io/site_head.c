/* From the head of a column to its role, unit and speed.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "io/site_column.h"

const char *const SITE_ROLES[3] = {"feed", "product", "sd"};

const struct site_unit SITE_UNITS[SITE_N_UNIT] = {
    {"", PASSING, 100, "passing from 0 to 100 %"},
    {"_passing_pct", PASSING, 100, "passing from 0 to 100 %"},
    {"_fraction", FRACTION, 1, "a fraction from 0 to 1"},
    {"_retained_g", RETAINED_G, 1e12, "mass retained, 0 g or more,"},
    {"_retained_pct", RETAINED_PCT, 100, "mass retained, 0 to 100 %,"},
    {"_cum_retained_pct", CUM_RETAINED, 100, "mass retained, 0 to 100 %,"},
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

/* A bare unit, retained_g@69, is the product's. */
static bool
find_word(const char *word, struct column *c)
{
	char name[40];
	c->role = SD;
	c->unit = 0;
	if (strcmp(word, SITE_ROLES[SD]) == 0)
		return true;
	for (c->unit = 0; c->unit < SITE_N_UNIT; c->unit++) {
		const char *suffix = SITE_UNITS[c->unit].suffix;
		for (c->role = FEED; c->role <= PRODUCT; c->role++) {
			snprintf(name, sizeof name, "%s%s", SITE_ROLES[c->role],
			    suffix);
			if (strcmp(word, name) == 0)
				return true;
		}
		c->role = PRODUCT;
		if (suffix[0] != '\0' && strcmp(word, suffix + 1) == 0)
			return true;
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
		return "a date belongs into the heading (sampled,2026-11-02); "
		       "behind @ stands the tip speed, as in product@69";
	if (v > FASTEST || strstr(text, "rpm") != NULL ||
	    strstr(text, "/min") != NULL)
		return "turns of the rotor a minute? tip speed in m/s = "
		       "3.1416 x rotor diameter in m x turns / 60, as in "
		       "product@69";
	n = strlen(text);
	if (n > 1 &&
	    (strcmp(text + n - 2, " g") == 0 || strstr(text, "(g)") != NULL))
		return "grams are said before the @, as in "
		       "product_retained_g@69";
	return "write the speed behind @, as in product@69";
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
	    "a tip speed above 0, up to 200 m/s,", "%s",
	    speed_hint(text, good ? v : 0));
}

/* The speed behind the @, which only the feed of all runs may lack. */
static bool
split_head(struct table *t, char *word, struct column *c)
{
	char *at = strchr(word, '@');
	if (at != NULL)
		*at = '\0';
	if (!find_word(text_trim(word), c)) {
		size_t digits = strcspn(word, "0123456789");
		bool lacks_at = at == NULL && word[digits] != '\0' &&
				(strncmp(word, "feed", 4) == 0 ||
				    strncmp(word, "product", 7) == 0);
		return sheet_wanted(t->sheet, c->head, "a column header", "%s",
		    lacks_at ? speed_hint(word + digits, 0)
			     : "understood are feed, feed@69, product@69 and "
			       "sd@69; feed "
			       "and product also with _fraction, _passing_pct, "
			       "_retained_g, _retained_pct, _cum_retained_pct "
			       "before "
			       "the @");
	}
	c->speed = 0;
	if (at != NULL)
		return find_speed(t, text_trim(at + 1), c);
	if (c->role == FEED)
		return true;
	return sheet_wanted(t->sheet, c->head, "a column with its tip speed",
	    "write the speed in m/s behind @: %s@69", SITE_ROLES[c->role]);
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
	    "%s was wanted once, found at column %d already\n%s", c->head.text,
	    twin->head.column,
	    c->speed > 0 ? "each run has a speed of its own: average the two, "
			   "or change one"
			 : "keep one of the two");
}

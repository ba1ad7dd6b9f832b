/* Speeds are cut out of the text first; what is left are words.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/sitefile/column_header.h"

#include <ctype.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "base/xalloc.h"
#include "io/sitefile/units.h"
#include "io/sitefile/lexicon.h"

/* Longer ones before those that they begin with. */
static const struct {
	const char *text;
	enum speed_unit unit;
} UNITS[] = {{"m/sec", SPEED_MPS}, {"m/sek", SPEED_MPS}, {"m/s", SPEED_MPS},
    {"mps", SPEED_MPS}, {"m s-1", SPEED_MPS}, {"m.s-1", SPEED_MPS},
    {"ms-1", SPEED_MPS}, {"km/h", SPEED_KMH}, {"km/t", SPEED_KMH},
    {"kmh", SPEED_KMH}, {"kph", SPEED_KMH}, {"ft/min", SPEED_FT_MIN},
    {"fpm", SPEED_FT_MIN}, {"ft/sec", SPEED_FT_S}, {"ft/s", SPEED_FT_S},
    {"fps", SPEED_FT_S}, {"rpm", SPEED_RPM}, {"r.p.m.", SPEED_RPM},
    {"rev/min", SPEED_RPM}, {"r/min", SPEED_RPM}, {"varv/min", SPEED_RPM},
    {"v/min", SPEED_RPM}, {"u/min", SPEED_RPM}, {"upm", SPEED_RPM},
    {"tr/min", SPEED_RPM}, {"kierr/min", SPEED_RPM}, {"1/min", SPEED_RPM},
    {"min-1", SPEED_RPM}};

/* Units of other things: a number before one of them is no speed. */
static const char *const OTHER_UNITS[] = {"mm", "um", "\xC2\xB5m", "\xCE\xBCm",
    "cm", "micron", "inch", "in.", "\"", "g", "kg", "%", "t/h", "tph", "ton",
    "t", "kw", "h", "hz", "a", "s", "v", "bar", "min", "pct", "\xC2\xB0"};

static bool
is_letter(char c)
{
	return isalpha((unsigned char)c) || (c & 0x80) != 0;
}

/* The unit at text, and its length. */
static enum speed_unit
unit_at(const char *text, size_t *n)
{
	for (size_t i = 0; i < ARRAY_LEN(UNITS); i++) {
		*n = strlen(UNITS[i].text);
		if (strncmp(text, UNITS[i].text, *n) == 0 &&
		    !is_letter(text[*n]))
			return UNITS[i].unit;
	}
	*n = 0;
	return SPEED_NO_UNIT;
}

static bool
other_unit_at(const char *text)
{
	for (size_t i = 0; i < ARRAY_LEN(OTHER_UNITS); i++) {
		size_t n = strlen(OTHER_UNITS[i]);
		if (strncmp(text, OTHER_UNITS[i], n) == 0 &&
		    !is_letter(text[n]))
			return true;
	}
	return false;
}

double
head_mps(double number, enum speed_unit unit, double rotor)
{
	switch (unit) {
	case SPEED_KMH:
		return number / 3.6;
	case SPEED_FT_MIN:
		return number * 0.00508;
	case SPEED_FT_S:
		return number * 0.3048;
	case SPEED_RPM:
		/* To a hundredth: rpm are known to one in a thousand. */
		return round(100 * units_mps(number, rotor)) / 100;
	default:
		return number;
	}
}

/* Whether speeds in a unit have four digits and more. */
static bool
has_thousands(enum speed_unit unit)
{
	return unit == SPEED_RPM || unit == SPEED_FT_MIN;
}

/* Blanks that do not break become others. */
static void
plain_blanks(char *s)
{
	static const char *const BLANKS[] = {
	    "\xC2\xA0", "\xE2\x80\xAF", "\xE2\x80\x89"};
	char *to = s;
	for (const char *p = s; *p != '\0';) {
		size_t n = 0;
		for (size_t b = 0; b < ARRAY_LEN(BLANKS); b++)
			if (strncmp(p, BLANKS[b], strlen(BLANKS[b])) == 0)
				n = strlen(BLANKS[b]);
		*to++ = n > 0 || *p == '\n' ? ' ' : *p;
		p += n > 0 ? n : 1;
	}
	*to = '\0';
}

/* A number at *text, which moves after it: 63,6 or 63.6, 1 350 or 1,350 where
 * rpm follow.  False for dates, times and ranges (0/8, 2026-05-03), which are
 * moved over. */
static bool
number_at(const char **text, double *value)
{
	static const char DIGITS[] = "0123456789";
	const char *p = *text;
	char copy[32] = "";
	size_t n = strspn(p, DIGITS), parts = 1, k = 0;
	memcpy(copy, p, n > 15 ? 15 : n);
	p += n;
	size_t after = 0;
	if ((*p == '.' || *p == ',') && isdigit((unsigned char)p[1])) {
		after = strspn(p + 1, DIGITS);
		snprintf(copy + strlen(copy), 16, ".%.*s",
		    (int)(after > 12 ? 12 : after), p + 1);
		p += 1 + after;
	}
	while (strchr("-/.:", *p) != NULL && *p != '\0' &&
	       isdigit((unsigned char)p[1])) {
		parts++;
		p += 1 + strspn(p + 1, DIGITS);
	}
	*text = p;
	const char *blank = *p == ' ' ? p + 1 : p;
	if (parts == 1 && after == 0 && *p == ' ' && n <= 3 &&
	    strspn(p + 1, DIGITS) == 3) {
		const char *unit = p + 4 + strspn(p + 4, " ");
		if (has_thousands(unit_at(unit, &k))) {
			strncat(copy, p + 1, 3);
			*text = p + 4;
		}
	} else if (after == 3 && has_thousands(unit_at(blank, &k))) {
		memmove(strchr(copy, '.'), strchr(copy, '.') + 1, 4);
	}
	return parts == 1 && text_number(copy, value);
}

/* Notes what a number says, with the unit after it, which *text moves over. */
static void
take_number(struct head *head, const char **text, double value, bool at)
{
	size_t n;
	const char *p = *text + strspn(*text, " ([");
	enum speed_unit unit = unit_at(p, &n);
	if (unit == SPEED_NO_UNIT && at)
		unit = SPEED_MPS;
	if (unit == SPEED_NO_UNIT && other_unit_at(p))
		return;
	if (unit == SPEED_NO_UNIT) {
		if (head->n_number < HEAD_NUMBERS)
			head->number[head->n_number++] = value;
		return;
	}
	*text = n > 0 ? p + n : *text;
	double *slot = unit == SPEED_RPM ? &head->rpm : &head->speed;
	double said = unit == SPEED_RPM ? value : head_mps(value, unit, 0);
	head->several =
	    head->several || (*slot > 0 && fabs(*slot - said) > 0.05);
	/* Of 12520 ft/min (63.6 m/s) the later, which is in m/s, is closer. */
	*slot = said;
	head->unit = unit;
}

struct head
head_read(const char *text)
{
	struct head head = {0};
	char *folded = text_fold(text);
	plain_blanks(folded);
	char *words = xcalloc(strlen(folded) + 1, 1);
	size_t n = 0, k;
	bool at = false;
	for (const char *p = folded; *p != '\0';) {
		bool inside = p > folded && is_letter(p[-1]);
		double value;
		enum speed_unit unit = inside ? SPEED_NO_UNIT : unit_at(p, &k);
		if (unit != SPEED_NO_UNIT) {
			if (head.unit == SPEED_NO_UNIT)
				head.unit = unit;
			p += k;
			words[n++] = ' ';
		} else if (isdigit((unsigned char)*p)) {
			bool minus = p > folded + 1 && p[-1] == '-' && at;
			bool good = number_at(&p, &value);
			head.several = head.several || minus;
			bool speed =
			    unit_at(p + strspn(p, " "), &k) != SPEED_NO_UNIT;
			if (good && (!inside || speed))
				take_number(&head, &p, value, at);
			words[n++] = ' ';
			at = false;
		} else {
			at = *p == '@' || (at && strchr(" -", *p) != NULL);
			words[n++] = *p == '@' ? ' ' : *p;
			p++;
		}
	}
	head.means = vocabulary_text(words, &head.unknown);
	free(words);
	free(folded);
	return head;
}

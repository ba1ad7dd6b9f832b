/* Parses a heading: first removes the speeds from its text, then treats the
 * rest as words.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/sitefile/column_header.h"

#include <ctype.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "base/xalloc.h"
#include "core/psd/rotor_speed.h"
#include "io/cells/number.h"
#include "io/sitefile/lexicon.h"

/* A unit that begins with another one stands before it. */
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
    {"min-1", SPEED_RPM}, {"giri/min", SPEED_RPM}, {"об/мин", SPEED_RPM},
    {"м/с", SPEED_MPS}};

/* Units of other quantities: a number before one of them is not a speed. */
static const char *const OTHER_UNITS[] = {"mm", "um", "\xC2\xB5m", "\xCE\xBCm",
    "cm", "micron", "inch", "in.", "\"", "g", "kg", "%", "t/h", "tph", "ton",
    "t", "kw", "h", "hz", "a", "s", "v", "bar", "min", "pct", "\xC2\xB0"};

bool
text_is_letter_byte(char c)
{
	return isalpha((unsigned char)c) || (c & 0x80) != 0;
}

/* Returns the unit of speed that the text begins with, and its length in *n. */
static enum speed_unit
speed_unit_at(const char *text, size_t *n)
{
	for (size_t i = 0; i < ARRAY_LEN(UNITS); i++) {
		*n = strlen(UNITS[i].text);
		if (strncmp(text, UNITS[i].text, *n) == 0 &&
		    !text_is_letter_byte(text[*n]))
			return UNITS[i].unit;
	}
	*n = 0;
	return SPEED_NO_UNIT;
}

static bool
is_unit_other_than_speed(const char *text)
{
	for (size_t i = 0; i < ARRAY_LEN(OTHER_UNITS); i++) {
		size_t n = strlen(OTHER_UNITS[i]);
		if (strncmp(text, OTHER_UNITS[i], n) == 0 &&
		    !text_is_letter_byte(text[n]))
			return true;
	}
	return false;
}

bool
heading_has_speed(const struct head *head)
{
	return head->speed > 0 || head->rpm > 0;
}

enum speed_unit
heading_speed_unit(const struct head *head)
{
	bool turns =
	    head->unit == SPEED_NO_UNIT && (head->means & WORD_RPM) != 0;
	return turns ? SPEED_RPM : head->unit;
}

bool
heading_is_of_other_part(const struct head *head)
{
	return (head->means & WORD_ROTOR) == 0 &&
	       (head->unknown > 0 ||
		   (head->means & (WORD_SIZE | WORD_FEED)) != 0);
}

double
speed_in_unit_to_mps(double number, enum speed_unit unit, double rotor)
{
	switch (unit) {
	case SPEED_KMH:
		return number / 3.6;
	case SPEED_FT_MIN:
		return number * 0.00508;
	case SPEED_FT_S:
		return number * 0.3048;
	case SPEED_RPM:
		return rotor_speed_from_rpm(number, rotor);
	default:
		return number;
	}
}

/* True if speeds in this unit have four digits or more. */
static bool
is_unit_of_four_digit_speeds(enum speed_unit unit)
{
	return unit == SPEED_RPM || unit == SPEED_FT_MIN;
}

/* Replaces no-break spaces and line ends with spaces. */
static void
replace_nonbreaking_blanks(char *s)
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

/* Reads a number at *text and moves *text past it: 63,6 or 63.6 or, before rpm,
 * 1 350 or 1,350.  Returns false for dates, times and ranges (0/8, 2026-05-03),
 * but moves *text past them. */
static bool
parse_number_at(const char **text, double *value)
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
	size_t group = number_thousands_separator_bytes(p);
	if (parts == 1 && after == 0 && group > 0 && n <= 3 &&
	    strspn(p + group, DIGITS) == 3) {
		const char *end = p + group + 3;
		if (is_unit_of_four_digit_speeds(
			speed_unit_at(end + strspn(end, " "), &k))) {
			strncat(copy, end - 3, 3);
			*text = end;
		}
	} else if (after == 3 &&
		   is_unit_of_four_digit_speeds(speed_unit_at(blank, &k))) {
		memmove(strchr(copy, '.'), strchr(copy, '.') + 1, 4);
	}
	return parts == 1 && text_parse_number(copy, value);
}

/* Returns the text after a unit of mass, or the text itself if it does not
 * begin with one. */
static const char *
skip_unit_of_mass(const char *text)
{
	size_t n = strspn(text, "k") + 1;
	bool grams =
	    n <= 2 && text[n - 1] == 'g' && !text_is_letter_byte(text[n]);
	return grams ? text + n : text;
}

/* Adds a number to the heading, with the unit that follows it at *text, and
 * moves *text past the unit. */
static void
add_number_to_parsed_heading(
    struct head *head, const char **text, double value, bool at)
{
	size_t n;
	const char *p = *text + strspn(*text, " ([");
	enum speed_unit unit = speed_unit_at(p, &n);
	if (unit == SPEED_NO_UNIT && at)
		unit = SPEED_MPS;
	if (unit == SPEED_NO_UNIT && is_unit_other_than_speed(p)) {
		/* The g of "Soil A (100g)" is not the unit of the column. */
		*text = skip_unit_of_mass(p);
		return;
	}
	if (unit == SPEED_NO_UNIT) {
		if (head->n_number < HEAD_NUMBERS)
			head->number[head->n_number++] = value;
		return;
	}
	*text = n > 0 ? p + n : *text;
	double *slot = unit == SPEED_RPM ? &head->rpm : &head->speed;
	double said =
	    unit == SPEED_RPM ? value : speed_in_unit_to_mps(value, unit, 0);
	head->several =
	    head->several || (*slot > 0 && fabs(*slot - said) > 0.05);
	/* In 12520 ft/min (63.6 m/s) the later speed is more exact. */
	*slot = said;
	head->unit = unit;
}

/* The previous number in a heading.  at: only its @ makes it a speed.  unit: it
 * has a unit of speed.  end: where it ends, with its unit; NULL if there is no
 * previous number. */
struct before {
	const char *end;
	double value;
	bool at, unit;
};

/* True if n bytes are "or", "to", ".." or the like, which link two numbers to
 * one quantity. */
static bool
is_link_between_numbers(const char *text, size_t n)
{
	static const char *const LINKS[] = {"..", "...", "\xE2\x80\xA6", "&",
	    "+", "or", "and", "to", "oder", "und", "bis", "eller", "och",
	    "till", "til", "ou", "et", "tai", "ja"};
	for (size_t i = 0; i < ARRAY_LEN(LINKS); i++)
		if (strlen(LINKS[i]) == n && strncmp(text, LINKS[i], n) == 0)
			return true;
	return false;
}

/* True if a number without a unit of speed, at `text`, may be a second value of
 * the speed before it: @74 approx 75, 74 m/s or 75.  In @74 sample 3, a known
 * word says what else it is. */
static bool
is_second_value_of_speed(
    const struct before *before, const char *text, double value)
{
	bool near = value < 1.5 * before->value && before->value < 1.5 * value;
	if (before->end == NULL || !(before->at || (before->unit && near)))
		return false;
	size_t unknown;
	FREED char *gap =
	    xasprintf("%.*s", (int)(text - before->end), before->end);
	uint64_t means = lexicon_text_meanings(gap, &unknown);
	return unknown > 0 ||
	       (before->unit && (means & ~(uint64_t)WORD_FILLER) == 0);
}

/* True if the number at `text` and the previous one belong to the same speed:
 * @6 9, @69..70, 74 or 75 m/s; but not in "Cut 3 - 69 m/s".  unit: the number
 * at `text` has a unit of speed. */
static bool
is_number_part_of_same_speed(
    const struct before *before, const char *text, double value, bool unit)
{
	static const char *const DASHES[] = {
	    "-", "\xE2\x80\x93", "\xE2\x80\x94", "/", "~"};
	if (before->end == NULL || (!before->at && !unit))
		return false;
	const char *gap = before->end + strspn(before->end, " ");
	size_t n = (size_t)(text - gap);
	while (n > 0 && gap[n - 1] == ' ')
		n--;
	if (n == 0)
		return before->at;
	bool near = before->at || (value < 1.5 * before->value &&
				      before->value < 1.5 * value);
	for (size_t i = 0; near && i < ARRAY_LEN(DASHES); i++)
		if (strlen(DASHES[i]) == n && strncmp(gap, DASHES[i], n) == 0)
			return true;
	return is_link_between_numbers(gap, n);
}

/* True if the characters around a number make it part of another number: 7.4e1,
 * .69, 1E+02.  from, to: its digits in the text; at: an @ precedes it. */
static bool
is_part_of_other_number(
    const char *text, const char *from, const char *to, bool at)
{
	const char *p = from;
	while (p > text && isalpha((unsigned char)p[-1]))
		p--;
	if (p > text && p < from && isdigit((unsigned char)p[-1]))
		return true;
	if (from > text && from[-1] == '+')
		return true;
	if (from > text && from[-1] == '.' &&
	    (from == text + 1 || !text_is_letter_byte(from[-2])))
		return true;
	return at && *to != '\0' && strchr(" ,;:()[]_\"", *to) == NULL &&
	       !(*to == '.' && (to[1] == ' ' || to[1] == '\0'));
}

/* Reads the number at *text into the heading and moves *text past it. */
static void
parse_heading_number(struct head *head, const char *start, const char **text,
    bool at, struct before *before)
{
	const char *from = *text;
	double value = 0;
	size_t n;
	bool inside = from > start && text_is_letter_byte(from[-1]);
	bool minus = from > start + 1 && from[-1] == '-' && at;
	bool good = parse_number_at(text, &value);
	const char *to = *text;
	bool speed = speed_unit_at(to + strspn(to, " "), &n) != SPEED_NO_UNIT;
	at = at && good;
	head->several =
	    head->several || minus ||
	    (good && (at || speed) &&
		is_part_of_other_number(start, from, to, at && !speed)) ||
	    (good &&
		is_number_part_of_same_speed(before, from, value, speed)) ||
	    (good && !inside && !speed &&
		!is_unit_other_than_speed(to + strspn(to, " ")) &&
		is_second_value_of_speed(before, from, value));
	if (good && (!inside || speed))
		add_number_to_parsed_heading(head, text, value, at);
	*before = (struct before){
	    good ? (speed ? *text : to) : NULL, value, at && !speed, speed};
}

/* Returns the length of what separates the two sizes of a range, such as "-" or
 * "-d-", or 0 if p does not begin with one. */
static size_t
length_of_range_separator(const char *p)
{
	static const char *const BETWEEN[] = {
	    "-d-", "/d/", "-", "/", " - ", "\xE2\x80\x93"};
	for (size_t i = 0; i < ARRAY_LEN(BETWEEN); i++) {
		size_t n = strlen(BETWEEN[i]);
		if (strncmp(p, BETWEEN[i], n) == 0 &&
		    isdigit((unsigned char)p[n]))
			return n;
	}
	return 0;
}

/* True if a text contains a range of two sizes; a date, which has three
 * numbers, is not one. */
static bool
is_size_range_in_text(const char *text)
{
	static const char NUMBER[] = "0123456789.,";
	for (const char *p = text; *p != '\0'; p++) {
		size_t n = strspn(p, NUMBER),
		       between = length_of_range_separator(p + n);
		if (n == 0 || !isdigit((unsigned char)*p))
			continue;
		p += n;
		if (between == 0) {
			p--;
			continue;
		}
		size_t second = strspn(p + between, NUMBER);
		p += between + second;
		bool date = second == 4 || n == 4;
		if (!date && length_of_range_separator(p) == 0)
			return true;
		p += strspn(p, "0123456789.,-/");
		p--;
	}
	return false;
}

/* True for the 3 of m3 or cm3, which are not units of length. */
static bool
is_length_exponent(const char *text, const char *p)
{
	bool alone = !isalnum((unsigned char)p[1]) && (*p == '2' || *p == '3');
	const char *from = p;
	while (from > text && text_is_letter_byte(from[-1]))
		from--;
	size_t n = (size_t)(p - from);
	return alone && n > 0 && n <= 2 && p[-1] == 'm' &&
	       (n == 1 || strchr("cdm", from[0]) != NULL);
}

/* Reads a folded text.  words gets the text without numbers and units of speed,
 * rest the text without speeds; each has room for the whole text. */
static struct head
parse_speeds_out_of_text(const char *folded, char *words, char *rest)
{
	struct head head = {0};
	struct before before = {0};
	size_t n = 0, m = 0, k;
	bool at = false;
	for (const char *p = folded; *p != '\0';) {
		bool inside = p > folded && text_is_letter_byte(p[-1]);
		enum speed_unit unit =
		    inside ? SPEED_NO_UNIT : speed_unit_at(p, &k);
		if (unit != SPEED_NO_UNIT) {
			if (head.unit == SPEED_NO_UNIT)
				head.unit = unit;
			p += k;
			words[n++] = ' ';
		} else if (isdigit((unsigned char)*p)) {
			const char *from = p;
			bool power = is_length_exponent(folded, p);
			parse_heading_number(&head, folded, &p, at, &before);
			words[n++] = power ? *from : ' ';
			bool speed = before.at || before.unit;
			while (!speed && from < p)
				rest[m++] = *from++;
			at = false;
		} else {
			at = *p == '@' || (at && strchr(" -.+", *p) != NULL);
			words[n++] = *p == '@' ? ' ' : *p;
			rest[m++] = *p++;
		}
	}
	words[n] = rest[m] = '\0';
	head.range = is_size_range_in_text(folded);
	head.means = lexicon_text_meanings(words, &head.unknown);
	return head;
}

/* True for the speed of a belt or feeder, which is not that of the rotor. */
static bool
is_heading_of_belt_speed(const char *folded)
{
	static const char *const SAID[] = {"belt speed", "belt velocity",
	    "conveyor speed", "feeder belt", "feeder speed", "bandhast",
	    "bandgeschw", "vitesse de bande", "velocidad de banda",
	    "velocidad de cinta", "hihnan nopeus"};
	for (size_t i = 0; i < ARRAY_LEN(SAID); i++)
		if (strstr(folded, SAID[i]) != NULL)
			return true;
	return false;
}

/* Reads a heading.  *left gets the text without its speeds, which the caller
 * frees. */
static struct head
parse_heading_text(const char *text, char **left)
{
	FREED char *folded = text_fold_case_and_accents(text);
	replace_nonbreaking_blanks(folded);
	FREED char *words = xcalloc(strlen(folded) + 1, 1);
	*left = xcalloc(strlen(folded) + 1, 1);
	struct head head = parse_speeds_out_of_text(folded, words, *left);
	if (is_heading_of_belt_speed(folded))
		head = (struct head){.means = WORD_OTHER};
	return head;
}

struct head
heading_parse(const char *text)
{
	FREED char *left = NULL;
	return parse_heading_text(text, &left);
}

/* The slowest speed in a name, m/s; "12 MS" may be initials. */
static const double SLOWEST_IN_NAME = 20;

/* Returns the whole number that ends just before p, or -1. */
static double
whole_number_ending_at(const char *text, const char *p)
{
	const char *from = p;
	while (from > text && isdigit((unsigned char)from[-1]))
		from--;
	return from < p ? strtod(from, NULL) : -1;
}

struct head
heading_parse_file_name(const char *name)
{
	static const char *const WRITTEN[] = {"ms", "m s", "m-s", "m.s"};
	FREED char *text = text_fold_case_and_accents(name);
	for (char *p = text; *p != '\0'; p++)
		*p = *p == '_' ? ' ' : *p;
	FREED char *said = xstrdup("");
	for (const char *p = text; *p != '\0';) {
		const char *unit = p + (*p == ' ');
		bool after = p > text &&
			     whole_number_ending_at(text, p) >= SLOWEST_IN_NAME;
		size_t n = 0;
		for (size_t i = 0; i < ARRAY_LEN(WRITTEN) && after; i++) {
			size_t length = strlen(WRITTEN[i]);
			if (strncmp(unit, WRITTEN[i], length) == 0 &&
			    !text_is_letter_byte(unit[length]))
				n = length;
		}
		if (n > 0)
			xappend(&said, " m/s");
		else
			xappend(&said, "%c", *p);
		p = n > 0 ? unit + n : p + 1;
	}
	return heading_parse(said);
}

char *
heading_without_speeds(const char *text)
{
	char *left;
	parse_heading_text(text, &left);
	return left;
}

/* True if a word of n bytes is, or begins with, a number that counts or dates
 * something; not if it has a unit, or one follows at `next`, or it is a range
 * of sizes. */
static bool
is_unitless_number(const char *word, size_t n, const char *next)
{
	size_t digits = 0, more;
	while (digits < n && strchr("0123456789.", word[digits]) != NULL)
		digits++;
	if (digits == 0)
		return false;
	FREED char *tail = xstrndup(word + digits, n - digits);
	bool range = (tail[0] == '/' || tail[0] == '-') &&
		     strspn(tail + 1, "0123456789.,") == strlen(tail) - 1;
	lexicon_text_meanings(tail, &more);
	bool unit =
	    tail[0] != '\0' && strpbrk(tail, "0123456789") == NULL && more == 0;
	size_t follows = strcspn(next, " ,;:()[]@\n");
	bool measured = digits == n && follows > 0 &&
			(lexicon_word_meanings(next, follows) &
			    (WORD_MM | WORD_UM | WORD_M | WORD_INCH |
				WORD_GRAMS | WORD_PERCENT)) != 0;
	return !range && !unit && !measured;
}

/* True if a word is a name: it is unknown, or has a number that is not a
 * measurement. */
static bool
is_word_a_name(const char *word, size_t n, const char *next)
{
	FREED char *copy = xstrndup(word, n);
	size_t unknown;
	lexicon_text_meanings(copy, &unknown);
	bool letters = strpbrk(copy, "0123456789") == NULL;
	bool own = !letters && strspn(copy, "0123456789") == 0;
	return letters ? unknown > 0 && n > 1
		       : own || is_unitless_number(word, n, next);
}

/* True if text a contains a name that is not a word of b.  Both are folded. */
static bool
has_name_absent_from_other(const char *a, const char *b)
{
	static const char ENDS[] = " ,;:()[]@\n";
	for (const char *p = a; *p != '\0';) {
		size_t n = strcspn(p, ENDS);
		const char *next = p + n + strspn(p + n, ENDS);
		bool found = n == 0 || !is_word_a_name(p, n, next);
		for (const char *q = b; *q != '\0' && !found;) {
			size_t m = strcspn(q, ENDS);
			found = m == n && strncmp(p, q, n) == 0;
			q += m + strspn(q + m, ENDS);
		}
		if (!found)
			return true;
		p = next;
	}
	return false;
}

bool
heading_names_differ(const char *a, const char *b)
{
	FREED char *one = heading_without_speeds(a),
		   *other = heading_without_speeds(b);
	return has_name_absent_from_other(one, other) &&
	       has_name_absent_from_other(other, one);
}

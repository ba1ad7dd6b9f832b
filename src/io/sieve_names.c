/* One table of the named sieves, in the words of their standard.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/sieve_names.h"

#include <ctype.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "base/xalloc.h"

/* ASTM E11-20, Table 1, alternative and standard designation; coarsest first.
 * Openings are the standard's own, which are not the inches times 25.4. */
static const struct {
	const char *name;
	double mm;
} SIEVES[] = {{"5 in", 125}, {"4.24 in", 106}, {"4 in", 100}, {"3 1/2 in", 90},
    {"3 in", 75}, {"2 1/2 in", 63}, {"2.12 in", 53}, {"2 in", 50},
    {"1 3/4 in", 45}, {"1 1/2 in", 37.5}, {"1 1/4 in", 31.5}, {"1.06 in", 26.5},
    {"1 in", 25}, {"7/8 in", 22.4}, {"3/4 in", 19}, {"5/8 in", 16},
    {"0.530 in", 13.2}, {"1/2 in", 12.5}, {"7/16 in", 11.2}, {"3/8 in", 9.5},
    {"5/16 in", 8}, {"0.265 in", 6.7}, {"1/4 in", 6.3}, {"No. 3 1/2", 5.6},
    {"No. 4", 4.75}, {"No. 5", 4}, {"No. 6", 3.35}, {"No. 7", 2.8},
    {"No. 8", 2.36}, {"No. 10", 2}, {"No. 12", 1.7}, {"No. 14", 1.4},
    {"No. 16", 1.18}, {"No. 18", 1}, {"No. 20", 0.85}, {"No. 25", 0.71},
    {"No. 30", 0.6}, {"No. 35", 0.5}, {"No. 40", 0.425}, {"No. 45", 0.355},
    {"No. 50", 0.3}, {"No. 60", 0.25}, {"No. 70", 0.212}, {"No. 80", 0.18},
    {"No. 100", 0.15}, {"No. 120", 0.125}, {"No. 140", 0.106},
    {"No. 170", 0.09}, {"No. 200", 0.075}, {"No. 230", 0.063},
    {"No. 270", 0.053}, {"No. 325", 0.045}, {"No. 400", 0.038},
    {"No. 450", 0.032}, {"No. 500", 0.025}, {"No. 635", 0.02}};

enum kind { NO_NAME, NUMBER, INCHES };

/* After the first of the words that the text begins with, and spaces; the text
 * itself where it begins with none. */
static const char *
behind(const char *text, const char *const *word, size_t n)
{
	for (size_t i = 0; i < n; i++) {
		size_t length = strlen(word[i]);
		if (strncmp(text, word[i], length) == 0)
			return text + length + strspn(text + length, " ");
	}
	return text;
}

/* "4", "3/8", "3 1/2" or "0.530" at *text, which begins with a digit and moves
 * after it and spaces. */
static double
read_mixed(const char **text)
{
	double whole = 0, part = 0, of = 1;
	int n = 0;
	if (sscanf(*text, "%lf %lf / %lf %n", &whole, &part, &of, &n) < 3) {
		n = 0;
		whole = 0;
		if (sscanf(*text, "%lf / %lf %n", &part, &of, &n) < 2) {
			sscanf(*text, "%lf %n", &whole, &n);
			part = 0;
		}
	}
	*text += n;
	return whole + part / of;
}

static enum kind
read_name(const char *text, double *value)
{
	static const char *const SIGNS[] = {
	    "#", "no.", "no", "n\xC2\xBA", "n\xC2\xB0"};
	static const char *const UNITS[] = {
	    "inches", "inch", "in.", "in", "\"", "\xE2\x80\xB3"};
	char *folded = text_fold(text);
	char *whole = text_trim(folded);
	const char *p = behind(whole, SIGNS, ARRAY_LEN(SIGNS));
	enum kind kind = p > whole ? NUMBER : INCHES;
	*value = isdigit((unsigned char)*p) ? read_mixed(&p) : NAN;
	const char *end =
	    kind == INCHES ? behind(p, UNITS, ARRAY_LEN(UNITS)) : p;
	if (!isfinite(*value) || *value <= 0 || *end != '\0' ||
	    (kind == INCHES && end == p))
		kind = NO_NAME;
	free(folded);
	return kind;
}

double
sieve_names_mm(const char *text)
{
	double wanted, value;
	enum kind kind = read_name(text, &wanted);
	for (size_t i = 0; kind != NO_NAME && i < ARRAY_LEN(SIEVES); i++)
		if (read_name(SIEVES[i].name, &value) == kind &&
		    fabs(value - wanted) < 1e-9)
			return SIEVES[i].mm;
	return kind == NO_NAME ? 0 : NAN;
}

bool
sieve_names_is_number(const char *text)
{
	double value;
	return read_name(text, &value) == NUMBER;
}

char *
sieve_names_nearest(const char *text)
{
	double wanted, value;
	enum kind kind = read_name(text, &wanted);
	size_t n = ARRAY_LEN(SIEVES), finer = 0;
	for (; finer < n; finer++) {
		enum kind other = read_name(SIEVES[finer].name, &value);
		if (other == NUMBER && (kind == INCHES || value > wanted))
			break;
		if (other == INCHES && kind == INCHES && value < wanted)
			break;
	}
	char *list = xstrdup("");
	for (size_t i = finer > 0 ? finer - 1 : 0; i < n && i <= finer; i++)
		xlist(
		    &list, " and ", "%s (%g mm)", SIEVES[i].name, SIEVES[i].mm);
	return list;
}

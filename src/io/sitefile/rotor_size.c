/* Scans a text word by word.  A number with a unit of length, after or before a
 * word for the rotor, is its diameter.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/sitefile/rotor_size.h"

#include <ctype.h>
#include <math.h>
#include <string.h>

#include "base/text.h"
#include "base/xalloc.h"
#include "io/sitefile/column_header.h"
#include "io/sitefile/lexicon.h"

static const double LEAST_MM = 100, MOST_MM = 5000;

/* What the words read so far suggest.  rotor, diameter: there was a word for
 * it, and none for something else since.  unit: the unit that followed these
 * words, in mm, or 0.  ahead: the last number, mm, if only blanks and words for
 * a diameter have followed it.  alone: a diameter may be the rotor's although
 * the rotor is not named.  found: what rotor_diameter_mm_in_text returns. */
struct search {
	bool machine, alone, rotor, diameter;
	double unit, ahead, found;
};

/* Returns the folded text, with the word "diameter" in place of each sign for
 * it that is not part of another word: O with a stroke, phi, and U+2300. */
static char *
replace_diameter_signs(const char *text)
{
	static const char *const SIGNS[] = {"\xC3\x98", "\xC3\xB8", "\xCE\xA6",
	    "\xCF\x86", "\xCF\x95", "\xE2\x8C\x80"};
	FREED char *plain = xstrdup("");
	for (const char *p = text; *p != '\0';) {
		size_t n = 0;
		for (size_t i = 0; i < ARRAY_LEN(SIGNS); i++)
			if (strncmp(p, SIGNS[i], strlen(SIGNS[i])) == 0)
				n = strlen(SIGNS[i]);
		bool sign = n > 0 &&
			    (p == text || !text_is_letter_byte(p[-1])) &&
			    !text_is_letter_byte(p[n]);
		if (sign)
			xappend(&plain, " diameter ");
		else
			xappend(&plain, "%c", *p);
		p += sign ? n : 1;
	}
	return text_fold_case_and_accents(plain);
}

static bool
is_word_for_diameter(const char *word, size_t n)
{
	static const char *const WORDS[] = {"diameter", "dia", "diam",
	    "durchmesser", "diametre", "diametro", "halkaisija", "diametern"};
	for (size_t i = 0; i < ARRAY_LEN(WORDS); i++)
		if (strlen(WORDS[i]) == n && strncmp(word, WORDS[i], n) == 0)
			return true;
	return false;
}

static size_t
length_of_word(const char *p)
{
	size_t n = 0;
	while (text_is_letter_byte(p[n]))
		n++;
	return n;
}

/* Returns the length of a unit, n bytes at p, in mm; 0 if it is not a unit of
 * length. */
static double
mm_of_unit(const char *p, size_t n)
{
	if (*p == '"')
		return 25.4;
	if (n == 0 || p[n] == '/')
		return 0;
	if (n == 2 && strncmp(p, "cm", 2) == 0)
		return 10;
	uint64_t means = lexicon_word_meanings(p, n);
	return (means & WORD_MM) != 0     ? 1
	       : (means & WORD_INCH) != 0 ? 25.4
	       : (means & WORD_M) != 0    ? 1000
					  : 0;
}

static bool
is_possible_rotor_mm(double mm)
{
	return mm >= LEAST_MM && mm <= MOST_MM;
}

static void
record_rotor_diameter(struct search *s, double mm)
{
	if (!is_possible_rotor_mm(mm))
		return;
	bool differs =
	    s->found < 0 || (s->found > 0 && fabs(mm - s->found) > 0.5);
	s->found = differs ? -1 : mm;
}

/* Reads a number of n bytes, with a decimal point or comma, at *text, moves
 * *text past it, and returns it in mm.  In 1,050 mm the comma separates
 * thousands, as no rotor is as small as 1.05 mm. */
static double
parse_number_in_mm(const char **text, size_t n, double unit)
{
	char copy[24] = "";
	size_t whole = strspn(*text, "0123456789");
	double v;
	memcpy(copy, *text, n < sizeof copy ? n : sizeof copy - 1);
	*text += n;
	bool sign = whole < n && whole < sizeof copy;
	if (sign)
		copy[whole] = '.';
	if (!text_parse_number(copy, &v))
		return 0;
	bool thousands =
	    sign && n == whole + 4 && !is_possible_rotor_mm(v * unit);
	return v * unit * (thousands ? 1000 : 1);
}

static size_t
length_of_number(const char *p)
{
	size_t n = strspn(p, "0123456789");
	bool decimals =
	    (p[n] == '.' || p[n] == ',') && isdigit((unsigned char)p[n + 1]);
	return decimals ? n + 1 + strspn(p + n + 1, "0123456789") : n;
}

/* True if a number that ends at `end` has no unit and is not part of a range.
 * after: what follows its blanks, which begins with a word of `word` bytes. */
static bool
is_number_without_unit(const char *end, const char *after, size_t word)
{
	if (word > 0)
		return is_word_for_diameter(after, word);
	return *end == '\0' || (strchr("-/:%", *end) == NULL &&
				   !isdigit((unsigned char)*after));
}

static void
parse_rotor_diameter_number(struct search *s, const char **text)
{
	size_t n = length_of_number(*text);
	const char *after = *text + n + strspn(*text + n, " -");
	size_t word = *after == '"' ? 1 : length_of_word(after);
	double unit = mm_of_unit(after, word);
	bool bare = is_number_without_unit(*text + n, after, word);
	bool meant = s->rotor || (s->diameter && s->alone);
	double mm = parse_number_in_mm(text, n, unit > 0 ? unit : 1);
	if (meant && unit > 0)
		record_rotor_diameter(s, mm);
	else if (meant && s->unit > 0 && bare)
		record_rotor_diameter(s, mm * s->unit);
	else if (bare && meant && (s->diameter || s->machine))
		record_rotor_diameter(
		    s, mm < 10 && mm != floor(mm) ? 1000 * mm : mm);
	s->ahead = !meant && unit > 0 ? mm : 0;
	s->rotor = s->diameter = false;
	s->unit = 0;
	*text = unit > 0 ? after + word : *text;
	*text += unit > 0 && **text == '.'; /* the point of "in." */
}

static void
rotor_parse_word(struct search *s, const char *word, size_t n)
{
	uint64_t means = lexicon_word_meanings(word, n);
	double unit = mm_of_unit(word, n);
	if (is_word_for_diameter(word, n)) {
		s->diameter = true;
	} else if ((means & WORD_ROTOR) != 0) {
		record_rotor_diameter(s, s->ahead);
		s->ahead = s->unit = 0;
		s->rotor = true;
		s->diameter = (means & WORD_SIZE) != 0;
	} else if (unit > 0 && (s->rotor || s->diameter)) {
		s->unit = unit;
	} else if ((means & WORD_FILLER) == 0 && strncmp(word, "d", n) != 0) {
		s->rotor = s->diameter = false;
		s->ahead = 0;
	}
}

/* True if a diameter in this line may be the rotor's although the rotor is not
 * named: the line is about a machine or a speed, and not about sieves, which
 * have diameters too. */
static bool
is_unnamed_rotor_diameter(const char *text, const char *folded)
{
	struct head head = heading_parse(text);
	for (const char *p = folded; *p != '\0';) {
		size_t n = length_of_word(p);
		if (n > 1 && !is_word_for_diameter(p, n) &&
		    (lexicon_word_meanings(p, n) & (WORD_SIZE | WORD_ROTOR)) ==
			WORD_SIZE)
			return false;
		p += n > 0 ? n : 1;
	}
	return (head.means & (WORD_MACHINE | WORD_ROTOR)) != 0 ||
	       heading_has_speed(&head);
}

double
rotor_diameter_mm_in_text(const char *text, bool machine)
{
	FREED char *folded = replace_diameter_signs(text);
	struct search s = {.machine = machine};
	s.alone = is_unnamed_rotor_diameter(text, folded);
	for (const char *p = folded; *p != '\0';) {
		size_t n = length_of_word(p);
		if (isdigit((unsigned char)*p)) {
			parse_rotor_diameter_number(&s, &p);
			continue;
		}
		bool joins = *p == '-' && p > folded && p[-1] != ' ';
		if (n > 0)
			rotor_parse_word(&s, p, n);
		else if (*p != ' ' && !joins)
			s.ahead = 0;
		p += n > 0 ? n : 1;
	}
	return s.found;
}

/* Reads speeds as one types them: several in a row, and in rpm, which it
 * converts to tip speeds: v = pi D n / 60.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/run/speeds.h"

#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "base/xalloc.h"
#include "cmd/ask/condition.h"
#include "cmd/session/call_paths.h"
#include "core/psd/rotor_speed.h"
#include "core/psd/site.h"

static const char RPM[] = "rpm", RPM_IS[] = "rpm=";

/* True if the word is "rpm=1500..1700:50", or "rpm=1500" for a command that has
 * speeds= and not rpm=, and therefore stands for speeds=. */
static bool
is_speed_list_in_rpm(const struct command *of, const char *word)
{
	return strncmp(word, RPM_IS, strlen(RPM_IS)) == 0 &&
	       ((command_option_index(of, RPM) == OPTIONS &&
		    command_option_index(of, "speeds") < OPTIONS) ||
		   strstr(word, "..") != NULL || strchr(word, ',') != NULL);
}

/* True if the value is a number, list or range with the unit "rpm", or begins
 * with a number too large for a tip speed. */
static bool
is_value_in_rpm(const char *value)
{
	enum { MOST_RPM = 20000 };
	double first = strtod(value, NULL);
	bool digit = *value >= '0' && *value <= '9';
	bool turns = first > SITE_FASTEST && first <= MOST_RPM;
	while (*(value += strspn(value, "0123456789.,:")) != '\0') {
		if (!text_is_same_but_case(value, RPM, strlen(RPM)))
			return false;
		value += strlen(RPM);
		turns = true;
	}
	return digit && turns;
}

/* Returns the value in word i, after "from=" or from its beginning, if it is in
 * rpm and belongs to an option in m/s; otherwise NULL. */
static const char *
find_typed_speed_in_rpm(const struct words *words, size_t i)
{
	const struct command *command = words->command;
	char *word = words->text[i];
	const char *equals = strchr(word, '=');
	const char *value = equals != NULL ? equals + 1 : word;
	char *const one[] = {word};
	const struct command *of = command_find_by_options(command, one, 1);
	bool bare = equals == NULL || is_speed_list_in_rpm(of, word);
	const char *before = (command->flags & COMMAND_SETTINGS) != 0
				 ? words->text[i - 1]
				 : of->bare;
	FREED char *name = !bare ? xstrndup(word, (size_t)(equals - word))
				 : xstrdup(before != NULL ? before : "");
	size_t at = command_option_index(of, name);
	bool speed = at < OPTIONS
			 ? strcmp(command_option_at(of, at)->unit, "m/s") == 0
			 : bare && command_takes_speeds(command);
	return speed && is_value_in_rpm(value) ? value : NULL;
}

/* Returns the diameter of rotor_mm= or else of the site in use, m; 0 if neither
 * states it.  s: NULL without a site in use. */
static double
rotor_diameter_m(struct session *s, const struct words *words)
{
	static const char OPTION[] = "rotor_mm=";
	double mm;
	for (size_t i = 1; i < words->n; i++)
		if (strncmp(words->text[i], OPTION, strlen(OPTION)) == 0 &&
		    value_parse_number(
			words->text[i] + strlen(OPTION), "mm", &mm))
			return mm / 1000;
	return s != NULL && s->n_entry > 0
		   ? session_current_site_entry(s)->site->rotor
		   : 0;
}

/* Expands "1500..1600:50" to "1500,1550,1600", because equal steps in rpm need
 * not be round steps in m/s.  Returns other texts unchanged.  The caller frees
 * it. */
static char *
expand_rpm_range_text(const char *turns)
{
	enum { MOST = 200 };
	const char *dots = strstr(turns, "..");
	const char *colon = dots != NULL ? strchr(dots, ':') : NULL;
	double from = strtod(turns, NULL);
	double to = colon != NULL ? strtod(dots + 2, NULL) : 0;
	double step = colon != NULL ? strtod(colon + 1, NULL) : 0;
	if (!(step > 0) || !(to > from) || (to - from) / step > MOST)
		return xstrdup(turns);
	char *list = xstrdup("");
	for (double n = from; n <= to + step * 1e-9; n += step)
		xappend_to_list(&list, ",", "%g", n);
	return list;
}

/* Returns the tip speed, m/s, of a number in rpm; without a site the rotor is
 * that of rotor_mm=. */
static double
tip_speed_from_rpm(struct session *s, double rpm, double diameter)
{
	return s != NULL && s->n_entry > 0
		   ? site_speed_from_rpm(
			 session_current_site_entry(s)->site, rpm, diameter)
		   : rotor_speed_from_rpm(rpm, diameter);
}

/* Converts each number in the text from rpm to m/s and removes the units.  The
 * caller frees the result. */
static char *
convert_rpm_text_to_mps(struct session *s, const char *turns, double diameter)
{
	char *text = xstrdup("");
	while (*turns != '\0') {
		size_t n = strspn(turns, "0123456789");
		if (n > 0 && turns[n] == '.' && turns[n + 1] != '.')
			n += 1 + strspn(turns + n + 1, "0123456789");
		if (n == 0 && text_is_same_but_case(turns, RPM, strlen(RPM))) {
			turns += strlen(RPM);
			continue;
		}
		FREED char *number = xstrndup(turns, n);
		if (n > 0)
			xappend(&text, "%g",
			    tip_speed_from_rpm(
				s, strtod(number, NULL), diameter));
		else
			xappend(&text, "%c", *turns);
		turns += n > 0 ? n : 1;
	}
	return text;
}

/* Returns the length of a speed in rpm at a place of a word whose other parts
 * are not speeds: "power=1485rpm:210:120" or, at the end of a file of add or
 * load, "cut.csv@1528rpm".  Returns 0 if there is none. */
static size_t
length_of_rpm_within_word(
    const struct command *command, const char *word, const char *at)
{
	static const char POWER[] = "power=";
	const char *sign = call_path_at_sign(word);
	bool power = strncmp(word, POWER, strlen(POWER)) == 0 && at > word &&
		     strchr("=,;", at[-1]) != NULL;
	size_t which; /* of the commands that read cuts */
	bool file = text_find_word_in_list("add load", command->name, &which) &&
		    sign != NULL && at == sign + 1 && strchr(word, '=') == NULL;
	double rpm;
	size_t n = power || file ? strspn(at, "0123456789.") : 0;
	FREED char *number = xstrndup(at, n);
	const char *end = at + n + strlen(RPM);
	bool ends = n > 0 && text_parse_typed_number(number, &rpm) &&
		    text_is_same_but_case(at + n, RPM, strlen(RPM)) &&
		    (file ? *end == '\0' : !isalnum((unsigned char)*end));
	return ends ? n + strlen(RPM) : 0;
}

/* Converts such speeds.  s: NULL for a command such as load, whose file has
 * another rotor than the site in use. */
static void
convert_rpm_within_words_to_mps(struct session *s, struct words *words)
{
	double diameter = rotor_diameter_m(s, words);
	for (size_t i = 1; i < words->n && diameter > 0; i++) {
		FREED char *now = xstrdup("");
		for (const char *word = words->text[i], *at = word;
		     *at != '\0';) {
			size_t n =
			    length_of_rpm_within_word(words->command, word, at);
			FREED char *part = xstrndup(at, n > 0 ? n : 1);
			FREED char *speed =
			    n > 0 ? convert_rpm_text_to_mps(s, part, diameter)
				  : NULL;
			xappend(&now, "%s", n > 0 ? speed : part);
			at += n > 0 ? n : 1;
		}
		if (strcmp(now, words->text[i]) != 0)
			words_replace_by_one(words, i, 1, now);
	}
}

/* Says what to add where speeds are in rpm and the rotor is not known. */
static bool
error_rotor_unknown(struct session *s, const struct words *words,
    struct place place, size_t i, struct error *error)
{
	bool has = command_option_index(words->command, "rotor_mm") < OPTIONS;
	error_set_at(error, ERROR_USAGE, place.file, place.line,
	    words->column[i],
	    "expected the rotor's diameter with rpm, which %s does not state",
	    session_current_site_entry(s)->site->name);
	return has ? error_set_hint(error,
			 "add rotor_mm=DIAMETER, or a line rotor_mm in the "
			 "site file")
		   : error_set_hint(error,
			 "write: load FILE rotor_mm=DIAMETER, or a line "
			 "rotor_mm in the site file");
}

bool
speeds_convert_from_rpm(struct session *s, struct words *words,
    struct place place, struct error *error)
{
	const struct command *command = words->command;
	if (command == NULL)
		return true;
	bool needs_site = (command->flags & COMMAND_NEEDS_SITE) != 0;
	convert_rpm_within_words_to_mps(needs_site ? s : NULL, words);
	size_t n = 0;
	for (size_t i = 1; i < words->n; i++)
		n += find_typed_speed_in_rpm(words, i) != NULL;
	double diameter = n > 0 ? rotor_diameter_m(s, words) : 0;
	if (!(diameter > 0) && s->n_entry == 0)
		return true;
	for (size_t i = 1; i < words->n && n > 0; i++) {
		char *word = words->text[i];
		const char *turns = find_typed_speed_in_rpm(words, i);
		if (turns == NULL)
			continue;
		bool bare =
		    turns == word || is_speed_list_in_rpm(command, word);
		int digits = (int)strspn(turns, "0123456789.");
		bool number =
		    strpbrk(turns, ",:") == NULL && strstr(turns, "..") == NULL;
		bool option = n == 1 && bare && number &&
			      !command_takes_speeds(command) &&
			      command_option_index(command, RPM) < OPTIONS;
		if (!option && !(diameter > 0))
			return error_rotor_unknown(s, words, place, i, error);
		FREED char *steps = expand_rpm_range_text(turns);
		FREED char *speeds =
		    convert_rpm_text_to_mps(s, steps, diameter);
		FREED char *now =
		    option ? xasprintf("rpm=%.*s", digits, turns)
		    : bare && (strchr(steps, ',') != NULL || turns != word)
			? xasprintf("speeds=%s", speeds)
			: xasprintf(
			      "%.*s%s", (int)(turns - word), word, speeds);
		words_replace_by_one(words, i, 1, now);
	}
	return true;
}

/* True if the word is a speed, a range "66..81:5", or a list.  *list: it is a
 * range, or its commas must be between numbers, as in "66,70,74" and "71.5,77";
 * "69,74" may mean 69.74. */
static bool
is_speed_or_range_or_list(const char *word, bool *list)
{
	const char *dots = strstr(word, "..");
	size_t n = strspn(word, dots != NULL ? "0123456789.:" : "0123456789.,");
	size_t commas = 0, points = 0;
	for (size_t i = 0; i < n; i++) {
		commas += word[i] == ',';
		points += word[i] == '.';
	}
	*list = commas > 1 || (commas > 0 && points > 0) || dots != NULL;
	return n > 0 && isdigit((unsigned char)word[0]) &&
	       (word[n] == '\0' || text_is_same_folded(word + n, RPM) ||
		   text_is_same_folded(word + n, "m/s"));
}

/* Returns the word as an item of a list, where commas separate numbers.  The
 * caller frees it. */
static char *
format_speed_as_list_item(const char *word, bool list)
{
	size_t n = strlen(word);
	if (n > 3 && text_is_same_folded(word + n - 3, "m/s"))
		n -= 3;
	char *part = xstrndup(word, n);
	for (char *c = part; *c != '\0' && !list; c++)
		if (*c == ',')
			*c = '.';
	return part;
}

/* True if a word such as "69,74" is two speeds: both are within the usual
 * range, and nothing was measured at 69.74 m/s.  Other words with a comma, such
 * as "69,5", are one number, and so is each word of a command that takes one
 * speed.  Notes how it was read if it could be either. */
static bool
is_two_speeds(
    struct session *s, const char *word, const char *command, bool takes_list)
{
	unsigned one, two;
	double from, to, speed;
	int n = 0;
	if (sscanf(word, "%3u,%3u%n", &one, &two, &n) != 2 || word[n] != '\0')
		return false;
	FREED char *number = format_speed_as_list_item(word, false);
	const struct site *site =
	    s->n_entry > 0 ? session_current_site_entry(s)->site : NULL;
	settings_default_speed_range(&s->set, site, &from, &to);
	bool measured = site != NULL &&
			text_parse_typed_number(number, &speed) &&
			site_run_at_speed(site, speed) < site->n_run;
	bool usual = one >= from && one <= to && two >= from && two <= to;
	if (measured || (!usual && (one < 10 || two < 10)))
		return false;
	if (!takes_list)
		session_print_note(s, "read %s as %s m/s: %s takes one speed",
		    word, number, command);
	else if (usual)
		session_print_note(s,
		    "read %s as two speeds; for %s m/s type %s", word, number,
		    number);
	else
		session_print_note(s,
		    "read %s as %s m/s; for two speeds type: %s %u %u", word,
		    number, command, one, two);
	return takes_list && usual;
}

/* Drops "at" before the first speed after the command's name, and the words
 * `between` two of them. */
static void
drop_words_between_speeds(struct words *words, const char *between)
{
	bool list;
	size_t which;
	for (size_t i = 1; i + 1 < words->n; i++) {
		const char *word = words->text[i], *next = words->text[i + 1];
		if (text_find_word_in_list(
			i == 1 ? "at" : between, word, &which) &&
		    is_speed_or_range_or_list(next, &list))
			words_replace_by_one(words, i, 2, next);
		else if (!is_speed_or_range_or_list(word, &list))
			return;
	}
}

/* Turns "68 to 78" and "68-78" after the command's name into "68..78", but
 * leaves "66,68-78", which may be two or three speeds. */
static void
join_words_to_speed_range(struct words *words)
{
	for (size_t n = 1; n <= 3 && n < words->n; n += 2) {
		FREED char *typed = n == 1
					? xstrdup(words->text[1])
					: xasprintf("%s %s %s", words->text[1],
					      words->text[2], words->text[3]);
		size_t length;
		const char *sign = conditions_find_range_sign(typed, &length);
		if (sign == NULL || *sign == '.' ||
		    (n == 1 && strchr(typed, ',') != NULL))
			continue;
		const char *to = sign + length + strspn(sign + length, " ");
		while (sign > typed && sign[-1] == ' ')
			sign--;
		FREED char *low = xstrndup(typed, (size_t)(sign - typed));
		bool list;
		if (!is_speed_or_range_or_list(low, &list) || list ||
		    !is_speed_or_range_or_list(to, &list))
			continue;
		FREED char *from = format_speed_as_list_item(low, false);
		FREED char *range = xasprintf("%s..%s", from, to);
		words_replace_by_one(words, 1, n, range);
	}
}

void
speeds_join_words_to_list(struct session *s, struct words *words)
{
	static char OPTION[] = "speeds=";
	char *const word[] = {OPTION};
	const struct command *command = words->n > 1 ? words->command : NULL;
	const struct command *lister =
	    command != NULL ? command_find_by_options(command, word, 1) : NULL;
	bool several =
	    lister != NULL && command_option_index(lister, "speeds") < OPTIONS;
	bool one = command != NULL && command->bare != NULL &&
		   strcmp(command->bare, "speed") == 0;
	if (several || one ||
	    (command != NULL && command_takes_speeds(command)))
		drop_words_between_speeds(
		    words, several ? "and vs" : "and vs to");
	if (!several) {
		if (one)
			is_two_speeds(s, words->text[1], command->name, false);
		return;
	}
	join_words_to_speed_range(words);
	/* The parser handles a single word if there is a bare option. */
	bool bare = lister == command && command->bare != NULL;
	bool lists = false, list;
	size_t n = 1;
	FREED char *joined = xstrdup(OPTION);
	for (; n < words->n && is_speed_or_range_or_list(words->text[n], &list);
	     n++) {
		list = list || (!bare && is_two_speeds(s, words->text[n],
					     command->name, true));
		FREED char *part =
		    format_speed_as_list_item(words->text[n], list);
		xappend(&joined, n > 1 ? ",%s" : "%s", part);
		lists = lists || list;
	}
	if (n > 2 || lists || (n > 1 && lister == command && !bare))
		words_replace_by_one(words, 1, n - 1, joined);
}

/* What may stand behind an option: numbers, ranges, choices, text.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/parse.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "base/xalloc.h"

/* Cuts a unit off the end of a number: "74m/s", "11.2 mm". */
static void
cut_unit(char *text, const char *unit)
{
	if (unit[0] != '\0' && text_ends(text, unit))
		text[strlen(text) - strlen(unit)] = '\0';
}

bool
value_number(const char *word, const char *unit, double *value)
{
	char *text = xstrdup(word);
	cut_unit(text, unit);
	bool ok = text_number(text, value);
	free(text);
	return ok;
}

/* A control room shows the rotor's turns. */
static const char TURNS[] =
    "is this rpm? tip speed (m/s) = 3.1416 x rotor diameter (m) x rpm / 60";

/* The next step where a number is written as in another language. */
static bool
hint_number(
    const struct command_option *option, const char *word, struct error *error)
{
	char *copy = xstrdup(word);
	char *comma = strchr(copy, ',');
	char *dash = copy[0] != '\0' ? strchr(copy + 1, '-') : NULL;
	double low, high;
	cut_unit(copy, option->unit);
	if (strcmp(option->unit, "m/s") == 0 && strstr(word, "rpm") != NULL) {
		error_hint(error, "%s", TURNS);
	} else if (comma != NULL) {
		*comma = '.';
		bool right = text_number(copy, &low);
		error_hint(
		    error, "use a decimal point: %s", right ? copy : "11.2");
	} else if (dash != NULL && option->kind == VALUE_NUMBERS) {
		*dash = '\0';
		if (text_number(copy, &low) && text_number(dash + 1, &high))
			error_hint(error,
			    "write a range with two points: %s..%s", copy,
			    dash + 1);
	}
	free(copy);
	return false;
}

static bool
number(const struct command_option *option, const char *word, double *value,
    struct error *error)
{
	bool ok = value_number(word, option->unit, value);
	const char *in = option->unit[0] != '\0' ? " in " : "";
	const char *space = option->unit[0] != '\0' ? " " : "";
	if (!ok && option->kind == VALUE_NUMBER && strchr(word, ',') != NULL) {
		error_set(error, ERROR_USAGE, "%s: expected a number, got '%s'",
		    option->name, word);
		return hint_number(option, word, error);
	}
	if (!ok) {
		error_set(error, ERROR_USAGE,
		    "%s: expected a number%s%s, got '%s'", option->name, in,
		    option->unit, word);
		return hint_number(option, word, error);
	}
	if (*value < option->least || *value > option->most) {
		error_set(error, ERROR_USAGE,
		    "expected %s from %g to %g%s%s, got %s", option->name,
		    option->least, option->most, space, option->unit, word);
		return *value > option->most &&
		       strcmp(option->unit, "m/s") == 0 &&
		       error_hint(error, "%s", TURNS);
	}
	return true;
}

static bool
add_number(const struct command_option *option, const char *word,
    struct value *value, struct error *error)
{
	double v;
	if (!number(option, word, &v, error))
		return false;
	value->list = xrealloc(value->list, value->n + 1, sizeof v);
	value->list[value->n++] = v;
	return true;
}

/* a..b or a..b:step; the step defaults to 1. */
static bool
range(const struct command_option *option, char *word, char *dots,
    struct value *value, struct error *error)
{
	enum { MOST = 2000 };
	double from, to, step = 1;
	char *colon = strchr(dots + 2, ':');
	*dots = '\0';
	if (colon != NULL)
		*colon = '\0';
	struct command_option step_of = *option;
	step_of.name = "the step";
	step_of.least = 0.001;
	bool ok = number(option, word, &from, error) &&
		  number(option, dots + 2, &to, error) &&
		  (colon == NULL || number(&step_of, colon + 1, &step, error));
	if (!ok)
		return false;
	double steps = floor((to - from) / step + 1e-9);
	if (steps < 0)
		return error_set(error, ERROR_USAGE,
		    "%s: expected a range from low to high, got %g to %g",
		    option->name, from, to);
	if (steps >= MOST)
		return error_set(error, ERROR_USAGE,
		    "%s: expected a range of at most %d steps, got %.0f",
		    option->name, (int)MOST, steps);
	for (double i = 0; i <= steps; i++) {
		value->list = xrealloc(value->list, value->n + 1, sizeof from);
		value->list[value->n++] = from + i * step;
	}
	return true;
}

static bool
numbers(const struct command_option *option, const char *word,
    struct value *value, struct error *error)
{
	char *text = xstrdup(word);
	char *dots = strstr(text, "..");
	bool ok = true;
	if (dots != NULL) {
		ok = range(option, text, dots, value, error);
	} else {
		for (char *part = text; ok && part != NULL;) {
			char *comma = strchr(part, ',');
			if (comma != NULL)
				*comma = '\0';
			ok = add_number(option, part, value, error);
			part = comma != NULL ? comma + 1 : NULL;
		}
	}
	free(text);
	if (ok && value->n == 0)
		return error_set(error, ERROR_USAGE,
		    "%s: expected numbers (65,74 or 65..85:5)", option->name);
	return ok;
}

static bool
wrong_whole(
    const struct command_option *option, const char *word, struct error *error)
{
	char *limits = command_limits(option);
	error_set(error, ERROR_USAGE,
	    "%s: expected a whole number, %s; got '%s'", option->name, limits,
	    word);
	free(limits);
	return false;
}

bool
value_wanted(const struct command_option *option, struct error *error)
{
	char *limits = command_limits(option);
	error_set(error, ERROR_USAGE, "%s: expected a value: %s", option->name,
	    limits);
	free(limits);
	return false;
}

static bool
wrong_choice(
    const struct command_option *option, const char *word, struct error *error)
{
	if (word[0] == '\0')
		return value_wanted(option, error);
	error_set(error, ERROR_USAGE, "%s: expected one of %s; got '%s'",
	    option->name, option->choices, word);
	char *copy = xstrdup(option->choices), *save = NULL;
	char *folded = text_fold(word);
	for (char *choice = strtok_r(copy, " ", &save); choice != NULL;
	     choice = strtok_r(NULL, " ", &save))
		if (text_distance(choice, folded) <= strlen(choice) / 3)
			error_hint(error, "did you mean '%s'?", choice);
	free(folded);
	free(copy);
	return false;
}

bool
value_take(const struct command_option *option, const char *word,
    struct value *value, struct error *error)
{
	value->text = word;
	switch (option->kind) {
	case VALUE_NUMBER:
		return number(option, word, &value->number, error);
	case VALUE_NUMBERS:
		return numbers(option, word, value, error);
	case VALUE_WHOLE:
		if (text_whole(word, &value->whole) &&
		    (double)value->whole >= option->least &&
		    (double)value->whole <= option->most)
			return true;
		return wrong_whole(option, word, error);
	case VALUE_CHOICE:
		if (text_choice(option->choices, word, &value->choice))
			return true;
		return wrong_choice(option, word, error);
	default:
		return word[0] != '\0' ||
		       error_set(error, ERROR_USAGE, "%s: expected a value",
			   option->name);
	}
}

/* Converts revolutions per minute to tip speeds: v = pi D n / 60.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/run/turns.h"

#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "base/xalloc.h"
#include "io/sitefile/column_header.h"

static const char RPM[] = "rpm";

/* Whether the operands of a command are speeds. */
static bool
takes_speeds(const struct command *command)
{
	const char *usage = command->operands.usage;
	return usage != NULL && strstr(usage, "SPEED") != NULL &&
	       (command->flags & COMMAND_FILES) == 0;
}

/* The value of a word, behind "from=" or from its beginning, if it is a number,
 * a list or a range in revolutions per minute of something that has m/s; else
 * NULL. */
static const char *
turns_in(const struct command *command, const char *word)
{
	const char *equals = strchr(word, '=');
	const char *value = equals != NULL ? equals + 1 : word;
	FREED char *name =
	    equals != NULL
		? xstrndup(word, (size_t)(equals - word))
		: xstrdup(command->bare != NULL ? command->bare : "");
	size_t i = command_option_index(command, name);
	bool speed = i < OPTIONS ? strcmp(command_option_at(command, i)->unit,
				       "m/s") == 0
				 : equals == NULL && takes_speeds(command);
	bool number = *value >= '0' && *value <= '9' && text_ends(value, RPM) &&
		      value[strspn(value, "0123456789.,:rpm")] == '\0';
	return speed && number ? value : NULL;
}

/* The words' rotor_mm=, m, else the site's diameter; 0 where neither is. */
static double
diameter_of(struct session *s, const struct words *words)
{
	static const char OPTION[] = "rotor_mm=";
	double mm;
	for (size_t i = 1; i < words->n; i++)
		if (strncmp(words->text[i], OPTION, strlen(OPTION)) == 0 &&
		    value_number(words->text[i] + strlen(OPTION), "mm", &mm))
			return mm / 1000;
	return s->n_entry > 0 ? session_entry(s)->site->rotor : 0;
}

/* The text with each of its numbers as the tip speed of so many turns, and
 * without the units; the caller frees. */
static char *
speeds_of(const char *turns, double diameter)
{
	char *text = xstrdup("");
	while (*turns != '\0') {
		size_t n = strspn(turns, "0123456789");
		if (n > 0 && turns[n] == '.' && turns[n + 1] != '.')
			n += 1 + strspn(turns + n + 1, "0123456789");
		if (n == 0 && strncmp(turns, RPM, strlen(RPM)) == 0) {
			turns += strlen(RPM);
			continue;
		}
		FREED char *number = xstrndup(turns, n);
		char *more = n > 0 ? xasprintf("%s%g", text,
					 head_mps(strtod(number, NULL),
					     SPEED_RPM, diameter))
				   : xasprintf("%s%c", text, *turns);
		free(text);
		text = more;
		turns += n > 0 ? n : 1;
	}
	return text;
}

/* How many words are in turns. */
static size_t
turns_count(const struct command *command, const struct words *words)
{
	size_t n = 0;
	for (size_t i = 1; i < words->n; i++)
		n += turns_in(command, words->text[i]) != NULL;
	return n;
}

bool
turns_to_speeds(struct session *s, struct words *words, struct place place,
    struct error *error)
{
	const struct command *command =
	    command_find_typed(words->text[0], place.prompt);
	size_t n = command != NULL ? turns_count(command, words) : 0;
	double diameter = n > 0 ? diameter_of(s, words) : 0;
	if (!(diameter > 0) && s->n_entry == 0)
		return true;
	for (size_t i = 1; i < words->n && n > 0; i++) {
		char **word = &words->text[i];
		const char *turns = turns_in(command, *word);
		if (turns == NULL)
			continue;
		bool option =
		    n == 1 && turns == *word &&
		    !(diameter > 0 && takes_speeds(command)) &&
		    command_option_index(command, RPM) < OPTIONS &&
		    strspn(turns, "0123456789.") + strlen(RPM) == strlen(turns);
		if (!option && !(diameter > 0))
			return error_at(error, ERROR_USAGE, place.file,
			    place.line, words->column[i],
			    "expected the rotor's diameter with rpm, which %s "
			    "does not state\n"
			    "add rotor_mm=DIAMETER to the line, where the "
			    "command has it, or a line rotor_mm to the site "
			    "file",
			    session_entry(s)->site->name);
		FREED char *speeds = speeds_of(turns, diameter);
		char *now = option
				? xasprintf("rpm=%.*s",
				      (int)strspn(turns, "0123456789."), turns)
				: xasprintf("%.*s%s", (int)(turns - *word),
				      *word, speeds);
		free(*word);
		*word = now;
	}
	return true;
}

/* Joins the words of each condition, and of quantities, in a line.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/ask/condition_words.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "base/xalloc.h"
#include "cmd/ask/condition.h"
#include "cmd/ask/quantity_words.h"

/* Whether a word is that of an option, "speed=72", or of a setting. */
static bool
is_option_word(const struct command *command, const char *word)
{
	size_t n = strcspn(word, "=");
	FREED char *name = xstrndup(word, n);
	return command_option_index(command, name) < OPTIONS &&
	       (word[n] == '=' || (command->flags & COMMAND_SETTINGS) != 0);
}

/* Whether a word goes on with the condition before it. */
static bool
is_condition_continued(
    const struct command *command, const char *before, const char *word)
{
	FREED char *with = xasprintf("%s ", word);
	bool most, begins = quantities_is_beginning_of_text(word) ||
			    conditions_parse_max_or_min(with, &most) != NULL;
	return !is_option_word(command, word) && strchr(word, ' ') == NULL &&
	       !(begins && conditions_is_likely_complete(before));
}

/* Where the conditions begin; 0 where the command takes none. */
static size_t
find_first_condition_word(const struct words *words)
{
	const struct command *command = words->command;
	bool takes =
	    command != NULL && (command->flags & COMMAND_CONDITIONS) != 0;
	if (takes && (command->flags & COMMAND_SETTINGS) == 0)
		return 1;
	return takes && words->n > 3 && text_same_folded(words->text[1], "goal")
		   ? 2
		   : 0;
}

/* Joins the words that go on with the condition at word i, unless it is quoted.
 * The goal that is set is one word, with commas between conditions, which may
 * be quoted one by one. */
static void
join_words_of_condition(struct words *words, size_t i)
{
	const struct command *command = words->command;
	FREED char *joined = xstrdup(words->text[i]);
	size_t begin = 0, n = 1;
	bool set = (command->flags & COMMAND_SETTINGS) != 0;
	if ((strchr(joined, ' ') != NULL && !set) ||
	    is_option_word(command, joined))
		return;
	for (; i + n < words->n; n++) {
		const char *word = words->text[i + n];
		bool on = is_condition_continued(command, joined + begin, word);
		if (!on && (!set || is_option_word(command, word)))
			break;
		if (!on)
			begin = strlen(joined) + strlen(", ");
		xappend(&joined, on ? " %s" : ", %s", word);
	}
	words_replace(words, i, n, joined);
}

/* Whether a text is a quantity as it stands: "passing 2", but not "passing". */
static bool
is_complete_quantity(const char *text)
{
	static const struct partition SHARP = {0, 1};
	const char *comma = strrchr(text, ',');
	struct quantity q;
	struct error none = {0};
	return quantities_parse_one(
	    comma != NULL ? comma + 1 : text, &SHARP, &q, &none);
}

/* Whether a limit, "< 5" or "= 40..50", is among the words. */
static bool
has_limit_among_words(const struct words *words)
{
	for (size_t i = 1; i < words->n; i++)
		if (strpbrk(words->text[i], "<>") != NULL ||
		    words->text[i][0] == '=' ||
		    strstr(words->text[i], " =") != NULL)
			return true;
	return false;
}

/* Makes "of=passing 2,P80" of the words that name quantities, where the command
 * or one that it stands for lists them. */
static void
join_quantity_words(struct words *words)
{
	size_t i = 1, n = words->n;
	while (i < n && !quantities_is_beginning_of_text(words->text[i]))
		i++;
	if (i == n || (words->command->flags & COMMAND_QUANTITIES) == 0)
		return;
	FREED char *list = xasprintf("of=%s", words->text[i]);
	bool fast = i > 1; /* the speed stands before them */
	size_t first = i++;
	for (; i < n; i++) {
		const char *word = words->text[i];
		bool whole = is_complete_quantity(list + strlen("of="));
		bool begins = quantities_is_beginning_of_text(word);
		if (strchr(word, '=') != NULL ||
		    (whole && !begins && !fast &&
			isdigit((unsigned char)word[0])))
			break;
		xappend(&list,
		    whole && (begins || isdigit((unsigned char)word[0]))
			? ",%s"
			: " %s",
		    word);
	}
	words_replace(words, first, i - first, list);
}

/* "passing 2 > 30, fines < 5": the comma between conditions says no more than
 * the blank does. */
static void
drop_comma_at_end(char *word)
{
	size_t n = strlen(word);
	if (n > 1 && word[n - 1] == ',' && strchr(word, ' ') == NULL)
		word[n - 1] = '\0';
}

void
conditions_join_words(struct words *words)
{
	size_t from = find_first_condition_word(words);
	if (words->command != NULL &&
	    (from == 0 || !has_limit_among_words(words)))
		join_quantity_words(words);
	if (from == 0)
		return;
	for (size_t i = from; i + 1 < words->n; i++)
		drop_comma_at_end(words->text[i]);
	for (size_t i = from; i < words->n; i++)
		join_words_of_condition(words, i);
}

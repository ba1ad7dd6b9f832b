/* Joins the words of each condition in a line, and those of quantities.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/ask/condition_words.h"

#include <ctype.h>
#include <string.h>

#include "base/text.h"
#include "base/xalloc.h"
#include "cmd/ask/condition.h"
#include "cmd/ask/quantity_words.h"

/* True if a word is an option, "speed=72", or the name of a setting. */
static bool
is_option_word(const struct command *command, const char *word)
{
	size_t n = strcspn(word, "=");
	FREED char *name = xstrndup(word, n);
	return command_option_index(command, name) < OPTIONS &&
	       (word[n] == '=' || (command->flags & COMMAND_SETTINGS) != 0);
}

/* Puts spaces around the = of "fm=4", which would otherwise be taken for an
 * option that the command does not have, and of "p80=5,p20>1", for one that it
 * has. */
static void
separate_quantity_from_value(struct words *words, size_t i)
{
	const char *word = words->text[i];
	size_t n = strcspn(word, " <>=");
	bool list = word[n] == '=' && strpbrk(word + n + 1, "<>=") != NULL;
	if (word[n] != '=' || (is_option_word(words->command, word) && !list) ||
	    !quantities_is_beginning_of_text(word))
		return;
	FREED char *apart = xasprintf("%.*s = %s", (int)n, word, word + n + 1);
	words_replace_by_one(words, i, 1, apart);
}

static bool
is_beginning_of_condition(const char *word)
{
	FREED char *with = xasprintf("%s ", word);
	bool most;
	return quantities_is_beginning_of_text(word) ||
	       conditions_parse_max_or_min(with, &most) != NULL ||
	       text_is_same_folded(word, "at");
}

/* If "and" and a condition follow word i, puts a comma in the place of "and".
 */
static void
replace_and_by_comma(struct words *words, size_t i)
{
	if (i + 2 >= words->n ||
	    !text_is_same_folded(words->text[i + 1], "and") ||
	    !is_beginning_of_condition(words->text[i + 2]))
		return;
	FREED char *with = xasprintf("%s,", words->text[i]);
	words_replace_by_one(words, i, 2, with);
}

/* True if a word continues the condition before it.  "speed=74" does not after
 * a limit: it is an option, which the command may not have. */
static bool
does_word_continue_condition(
    const struct command *command, const char *before, const char *word)
{
	bool option = strpbrk(before, "<>=") != NULL &&
		      isalpha((unsigned char)word[0]) &&
		      strchr(word, '=') != NULL;
	return !is_option_word(command, word) && strchr(word, ' ') == NULL &&
	       !((option || is_beginning_of_condition(word)) &&
		   conditions_is_likely_complete(before));
}

/* Returns the index after the next setting, from word i on, whose value has
 * several words. */
static size_t
index_after_setting_of_words(const struct words *words, size_t i)
{
	size_t which;
	while (i < words->n &&
	       !text_find_word_in_list("goal quantity", words->text[i], &which))
		i++;
	return i + 1;
}

/* Returns the index of the first word of a condition, or 0 if the command
 * takes no conditions. */
static size_t
find_first_condition_word(const struct words *words)
{
	const struct command *command = words->command;
	bool takes =
	    command != NULL && (command->flags & COMMAND_CONDITIONS) != 0;
	bool speed = takes && command->bare != NULL && words->n > 1 &&
		     value_is_speed(words->text[1]);
	if (takes && (command->flags & COMMAND_SETTINGS) == 0)
		return speed ? 2 : 1;
	size_t value = takes ? index_after_setting_of_words(words, 1) : 0;
	return value + 1 < words->n ? value : 0;
}

/* Removes the comma at the end of a condition, as in "passing 2 > 30, fines <
 * 5".  Returns false if there is none. */
static bool
drop_comma_at_end(char *text)
{
	size_t n = strlen(text);
	bool comma = n > 1 && text[n - 1] == ',';
	if (comma)
		text[n - 1] = '\0';
	return comma;
}

/* Joins the words that continue the condition at word i, unless that was
 * quoted.  In `set goal`, all conditions become one word, separated by commas,
 * and each of them may have been quoted. */
static void
join_words_of_condition(struct words *words, size_t i)
{
	const struct command *command = words->command;
	FREED char *joined = xstrdup(words->text[i]);
	size_t begin = 0, n = 1;
	bool set = (command->flags & COMMAND_SETTINGS) != 0;
	bool alone = (strchr(joined, ' ') != NULL && !set) ||
		     is_option_word(command, joined);
	for (; i + n < words->n; n++) {
		const char *word = words->text[i + n];
		bool on =
		    !drop_comma_at_end(joined) && !alone &&
		    does_word_continue_condition(command, joined + begin, word);
		if (!on && (!set || is_option_word(command, word)))
			break;
		if (!on)
			begin = strlen(joined) + strlen(", ");
		xappend(&joined, on ? " %s" : ", %s", word);
	}
	words_replace_by_one(words, i, n, joined);
}

/* True if the last item of a list is a complete quantity: "passing 2", not
 * "passing". */
static bool
is_last_quantity_complete(const char *text)
{
	const char *comma = strrchr(text, ',');
	struct quantity q;
	return quantities_parse_one(
	    comma != NULL ? comma + 1 : text, &PARTITION_IDEAL, &q, NULL);
}

/* True if one of the words has a limit, "< 5", "= 40..50" or "at least 5". */
static bool
has_limit_among_words(const struct words *words)
{
	for (size_t i = 1; i < words->n; i++)
		if (strpbrk(words->text[i], "<>") != NULL ||
		    words->text[i][0] == '=' ||
		    text_is_same_folded(words->text[i], "at") ||
		    strstr(words->text[i], " =") != NULL)
			return true;
	return false;
}

/* If the command can take quantities as plain words, replaces these by
 * "of=passing 2,P80". */
static void
join_quantities_to_option(struct words *words)
{
	size_t i = 1, n = words->n;
	while (i < n && !quantities_is_beginning_of_text(words->text[i]))
		i++;
	if (i == n || (words->command->flags & COMMAND_QUANTITIES) == 0)
		return;
	FREED char *list = xasprintf("of=%s", words->text[i]);
	bool fast = i > 1; /* a speed precedes them */
	size_t first = i++;
	for (; i < n; i++) {
		const char *word = words->text[i];
		bool whole = is_last_quantity_complete(list + strlen("of="));
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
	words_replace_by_one(words, first, i - first, list);
}

void
conditions_join_words(struct words *words)
{
	size_t from = find_first_condition_word(words);
	for (size_t i = from; i > 0 && i < words->n; i++) {
		replace_and_by_comma(words, i);
		separate_quantity_from_value(words, i);
	}
	if (words->command != NULL &&
	    (from == 0 || !has_limit_among_words(words)))
		join_quantities_to_option(words);
	if (from == 0)
		return;
	bool set = (words->command->flags & COMMAND_SETTINGS) != 0;
	while (from < words->n) {
		join_words_of_condition(words, from++);
		if (set)
			from = index_after_setting_of_words(words, from);
	}
}

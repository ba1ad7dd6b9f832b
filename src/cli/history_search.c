/* readline 8.2 frees a line's changes twice where its own searches put a line
 * of the history in the place of one that was changed.  These put it there as
 * if it were typed, which every other key and undo go on from.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/history_search.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <readline/history.h>
#include <readline/readline.h>

#include "base/text.h"
#include "base/xalloc.h"

/* The search that is under way: what is looked for, where the last line found
 * stands, and the line as it was before, which is behind them all. */
static struct {
	char *wanted, *typed;
	int place;
} at;

static void
put_line(const char *line, int point)
{
	rl_begin_undo_group();
	rl_delete_text(0, rl_end);
	rl_point = 0;
	rl_insert_text(line);
	rl_end_undo_group();
	rl_point = point < rl_end ? point : rl_end;
}

static void
history_search_begin(void)
{
	free(at.wanted);
	free(at.typed);
	at.typed = xstrdup(rl_line_buffer);
	at.wanted = xstrndup(rl_line_buffer, (size_t)rl_point);
	at.place = where_history();
}

/* Whether a line of the history is wanted; what stands there already is not. */
static bool
history_search_is_wanted(const char *line, bool anywhere)
{
	const char *found = strstr(line, at.wanted);
	return found != NULL && (anywhere || found == line) &&
	       strcmp(line, rl_line_buffer) != 0;
}

static int
history_search_search(bool on, bool anywhere, bool goes_on)
{
	if (!goes_on)
		history_search_begin();
	int step = on ? 1 : -1, place = at.place + step;
	for (; place >= 0 && place < history_length; place += step) {
		const HIST_ENTRY *entry = history_get(history_base + place);
		if (entry == NULL ||
		    !history_search_is_wanted(entry->line, anywhere))
			continue;
		at.place = place;
		put_line(entry->line, (int)strlen(at.wanted));
		return 0;
	}
	if (on && at.place < history_length) {
		at.place = history_length;
		put_line(at.typed, (int)strlen(at.wanted));
		return 0;
	}
	rl_ding();
	return 0;
}

static int go_back(int count, int key), go_on(int count, int key),
    look_back(int count, int key), look_on(int count, int key);

static bool
history_search_goes_on(void)
{
	return rl_last_func == go_back || rl_last_func == go_on ||
	       rl_last_func == look_back || rl_last_func == look_on;
}

/* Lines that begin with what is wanted. */
static int
go_back(int count, int key)
{
	(void)count, (void)key;
	return history_search_search(false, false, history_search_goes_on());
}

static int
go_on(int count, int key)
{
	(void)count, (void)key;
	return history_search_search(true, false, history_search_goes_on());
}

/* Lines that have it anywhere. */
static int
look_back(int count, int key)
{
	(void)count, (void)key;
	return history_search_search(false, true, history_search_goes_on());
}

static int
look_on(int count, int key)
{
	(void)count, (void)key;
	return history_search_search(true, true, history_search_goes_on());
}

static const struct {
	const char *name;
	rl_command_func_t *theirs, *ours;
} SEARCHES[] = {
    {"history-search-backward", rl_history_search_backward, go_back},
    {"history-search-forward", rl_history_search_forward, go_on},
    {"history-substring-search-backward", rl_history_substr_search_backward,
	look_back},
    {"history-substring-search-forward", rl_history_substr_search_forward,
	look_on},
};

void
typed_search_names(void)
{
	/* The first function of a name is the one that settings get. */
	for (size_t i = 0; i < ARRAY_LEN(SEARCHES); i++)
		rl_add_defun(SEARCHES[i].name, SEARCHES[i].ours, -1);
}

static void
replace_in(Keymap map, size_t i)
{
	char **keys = rl_invoking_keyseqs_in_map(SEARCHES[i].theirs, map);
	for (size_t k = 0; keys != NULL && keys[k] != NULL; k++) {
		rl_bind_keyseq_in_map(keys[k], SEARCHES[i].ours, map);
		free(keys[k]);
	}
	free(keys);
}

void
typed_search_keys(void)
{
	for (size_t i = 0; i < ARRAY_LEN(SEARCHES); i++) {
		replace_in(emacs_standard_keymap, i);
		replace_in(vi_movement_keymap, i);
		replace_in(vi_insertion_keymap, i);
	}
}

/* Keeps typed lines in a file, which is only appended to, one line per write,
 * and searches them.  In readline 8.2, the built-in searches free an edited
 * line's undo list twice when they replace it with a line from the history.
 * Ours insert the line as if it had been typed, so undo and all other keys work
 * as usual.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/history.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <readline/history.h>
#include <readline/readline.h>

#include "base/tr.h"
#include "base/xalloc.h"
#include "io/fs/file.h"
#include "io/fs/xdg.h"

/* Lines held in memory; the file may have more. */
enum { MOST = 5000 };

static char *path; /* of the file; NULL: none is kept */
static bool opened;

static void
stop_saving_history(const char *why)
{
	fprintf(stderr, tr("the history cannot be saved: %s\n"), why);
	xfree_and_set(&path, NULL);
}

static void
append_to_history_file(const char *bytes)
{
	struct error error = {0};
	if (path != NULL && !file_append_bytes(path, FILE_PRIVATE, bytes,
				strlen(bytes), &error))
		stop_saving_history(error.text);
}

void
typed_history_open(bool with_file)
{
	opened = true;
	using_history();
	stifle_history(MOST);
	if (!with_file)
		return;
	path = xdg_user_file_path("XDG_STATE_HOME", ".local/state", "history");
	if (path == NULL) {
		stop_saving_history(tr("HOME is not set"));
		return;
	}
	free(xdg_make_parent_folders(path));
	read_history(path);
	append_to_history_file("");
}

void
typed_history_add(const char *line)
{
	HIST_ENTRY *last = history_length > 0
			       ? history_get(history_base + history_length - 1)
			       : NULL;
	if (line[strspn(line, " \t")] == '\0' ||
	    (last != NULL && strcmp(last->line, line) == 0))
		return;
	add_history(line);
	FREED char *whole = xasprintf("%s\n", line);
	append_to_history_file(whole);
}

void
typed_history_close(void)
{
	xfree_and_set(&path, NULL);
	opened = false;
}

bool
typed_history_is_open(void)
{
	return opened;
}

/* ---- Searches ---- */

/* The current search.  wanted: the text searched for.  place: the index of the
 * last line found.  typed: the line as it was before the search, which follows
 * the newest line found. */
static struct {
	char *wanted, *typed;
	int place;
} search;

static void
replace_edited_line(const char *line, int point)
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
	free(search.wanted);
	xfree_and_set(&search.typed, xstrdup(rl_line_buffer));
	search.wanted = xstrndup(rl_line_buffer, (size_t)rl_point);
	search.place = where_history();
}

static rl_command_func_t history_search_prefix_backward,
    history_search_prefix_forward, history_search_anywhere_backward,
    history_search_anywhere_forward;

static const struct {
	const char *name;
	rl_command_func_t *theirs, *ours;
} SEARCHES[] = {
    {"history-search-backward", rl_history_search_backward,
	history_search_prefix_backward},
    {"history-search-forward", rl_history_search_forward,
	history_search_prefix_forward},
    {"history-substring-search-backward", rl_history_substr_search_backward,
	history_search_anywhere_backward},
    {"history-substring-search-forward", rl_history_substr_search_forward,
	history_search_anywhere_forward},
};

static bool
is_history_search_continued(void)
{
	size_t i = 0;
	while (i < ARRAY_LEN(SEARCHES) && SEARCHES[i].ours != rl_last_func)
		i++;
	return i < ARRAY_LEN(SEARCHES);
}

/* Goes to the next line that begins with the text searched for or, if
 * `anywhere`, contains it.  on: to a newer line, not an older one. */
static int
go_to_next_history_match(bool on, bool anywhere)
{
	if (!is_history_search_continued())
		history_search_begin();
	int step = on ? 1 : -1, place = search.place + step;
	for (; place >= 0 && place < history_length; place += step) {
		const HIST_ENTRY *entry = history_get(history_base + place);
		if (entry == NULL || strcmp(entry->line, rl_line_buffer) == 0)
			continue;
		const char *found = strstr(entry->line, search.wanted);
		if (found == NULL || (!anywhere && found != entry->line))
			continue;
		search.place = place;
		replace_edited_line(entry->line, (int)strlen(search.wanted));
		return 0;
	}
	if (on && search.place < history_length) {
		search.place = history_length;
		replace_edited_line(search.typed, (int)strlen(search.wanted));
		return 0;
	}
	rl_ding();
	return 0;
}

static int
history_search_prefix_backward(int count, int key)
{
	(void)count, (void)key;
	return go_to_next_history_match(false, false);
}

static int
history_search_prefix_forward(int count, int key)
{
	(void)count, (void)key;
	return go_to_next_history_match(true, false);
}

static int
history_search_anywhere_backward(int count, int key)
{
	(void)count, (void)key;
	return go_to_next_history_match(false, true);
}

static int
history_search_anywhere_forward(int count, int key)
{
	(void)count, (void)key;
	return go_to_next_history_match(true, true);
}

void
history_search_add_to_readline(void)
{
	/* If several functions have the same name, the user's settings get the
	 * first. */
	for (size_t i = 0; i < ARRAY_LEN(SEARCHES); i++)
		rl_add_defun(SEARCHES[i].name, SEARCHES[i].ours, -1);
}

static void
rebind_history_search_keys(Keymap map, size_t i)
{
	char **keys = rl_invoking_keyseqs_in_map(SEARCHES[i].theirs, map);
	for (size_t k = 0; keys != NULL && keys[k] != NULL; k++) {
		rl_bind_keyseq_in_map(keys[k], SEARCHES[i].ours, map);
		free(keys[k]);
	}
	free(keys);
}

void
history_search_bind_keys(void)
{
	for (size_t i = 0; i < ARRAY_LEN(SEARCHES); i++) {
		rebind_history_search_keys(emacs_standard_keymap, i);
		rebind_history_search_keys(vi_movement_keymap, i);
		rebind_history_search_keys(vi_insertion_keymap, i);
	}
}

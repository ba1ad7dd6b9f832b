/* Text being typed on the full screen: a line, with completion and history, or
 * a short word or number.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TUI_WIDGETS_EDIT_H
#define TIPSPEED_TUI_WIDGETS_EDIT_H

#include <stdbool.h>
#include <stddef.h>

#include "cmd/session/session.h"

/* text [n]: UTF-8.  at: offset of the cursor.  back: lines back in the history.
 * offers: completions of the word at `start`, separated by two spaces, or NULL.
 * Of these, `shown` are shown, beginning with number `from`; another Tab shows
 * the next.  fresh: where a proposed name starts, or 0; the first letter typed
 * replaces that name. */
struct edit {
	bool active;
	char text[2000];
	size_t n, at;
	int back;
	char *offers;
	size_t start, from, shown, fresh;
};

enum edit_result { EDIT_ON, EDIT_DONE, EDIT_GIVEN_UP };

void edit_begin(struct edit *t, const char *text);

/* Begins editing, with a name proposed after the text. */
void edit_begin_with_proposal(
    struct edit *t, const char *text, const char *name);

/* Handles a key.  code: a key code of ncurses if special, else a character. */
enum edit_result edit_handle_key(
    struct edit *t, const struct session *s, int code, bool special);
void edit_stop_editing(struct edit *t);

/* Returns offer n, of `length` bytes, or NULL if there are fewer. */
const char *edit_get_nth_offered_completion(
    const struct edit *t, size_t n, size_t *length);

/* Returns the offer from which Tab continues: the one after those shown, or the
 * first. */
size_t edit_first_unshown_completion(const struct edit *t);

/* Replaces the word with offer n. */
void edit_insert_completion(struct edit *t, size_t n);

/* Adds a letter to a text of fewer than `most` bytes, or deletes the last
 * letter.  Returns false if the key does neither or there is nothing to
 * delete. */
bool edit_insert_or_erase_letter(
    struct edit *t, int code, bool special, size_t most);

#endif

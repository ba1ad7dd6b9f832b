/* What is being typed on the full screen: a line, with completion and history,
 * or a word or number of a few letters.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TUI_WIDGETS_EDIT_H
#define TIPSPEED_TUI_WIDGETS_EDIT_H

#include <stdbool.h>
#include <stddef.h>

#include "cmd/session/session.h"

/* text [n], UTF-8; at: the cursor, an offset.  back: how many lines of the
 * history up; offers: what completion found for the word at `start`, for show,
 * two blanks between them, or NULL; from: the first that is shown, of so many;
 * Tab again goes on to the next.  fresh: where a name begins that was proposed,
 * which a letter replaces; or 0. */
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

/* With a name proposed behind it. */
void edit_propose(struct edit *t, const char *text, const char *name);

/* Takes a key (code: of ncurses where special, else a character). */
enum edit_result edit_key(
    struct edit *t, const struct session *s, int code, bool special);
void edit_end(struct edit *t);

/* Offer n, length bytes; NULL where there are not so many. */
const char *edit_offer(const struct edit *t, size_t n, size_t *length);

/* Where Tab goes on in the offers: behind those that are shown, or to the
 * first. */
size_t edit_next(const struct edit *t);

/* Puts the n-th of the offers in place of the word. */
void edit_take(struct edit *t, size_t n);

/* Takes a letter of ASCII into what has `most` of them, or takes the last one
 * back; false where the key is neither, or there is none. */
bool edit_letter(struct edit *t, int code, bool special, size_t most);

#endif

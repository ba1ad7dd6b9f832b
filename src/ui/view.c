/* Scrolling, choosing, drawing.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "ui/view.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <curses.h>

#include "base/text.h"
#include "base/xalloc.h"
#include "ui/pane.h"
#include "ui/screen.h"

/* How many lines there are, and columns of the widest one. */
static void
measure(struct viewer *v)
{
	for (const char *p = v->text; *p != '\0'; v->lines++) {
		size_t n = strcspn(p, "\n");
		char *line = xstrndup(p, n);
		int columns = text_width(line);
		v->columns = columns > v->columns ? columns : v->columns;
		free(line);
		p += n + (p[n] == '\n');
	}
}

void
view_close(struct tui *t)
{
	free(t->viewer.text);
	t->viewer = (struct viewer){0};
}

void
view_text(struct tui *t, char *text)
{
	view_close(t);
	t->viewer = (struct viewer){.text = text};
	measure(&t->viewer);
}

void
view_keys(struct tui *t)
{
	struct typing word = t->viewer.word;
	char *text = NULL;
	size_t n = 0;
	FILE *out = text_memory(&text, &n);
	keys_list(word.text, out);
	fclose(out);
	view_text(t, text);
	t->viewer.keys = true;
	t->viewer.word = word;
}

/* The last frame may have been of other text there. */
void
view_message(struct tui *t)
{
	enum { MARGIN = 2, LEAST = 8 };
	int rows, columns, lines = 0;
	screen_size(&rows, &columns);
	const struct places l = places_make(rows, columns, 0);
	columns = columns > LEAST + MARGIN ? columns - MARGIN : LEAST;
	char *text = text_wrapped(t->message, columns);
	for (const char *c = text; *c != '\0'; c++)
		lines += *c == '\n';
	if (lines > places_message_rows(&l) && t->viewer.text == NULL)
		view_text(t, text);
	else
		free(text);
}

/* A character of the word after '/'; false where it is none. */
static bool
find(struct tui *t, int code, bool special)
{
	struct typing *word = &t->viewer.word;
	if (!t->viewer.keys || (!word->active && code != '/'))
		return false;
	if (word->active && !typing_letter(word, code, special, VIEWER_WORD))
		return false;
	if (word->active)
		view_keys(t);
	word->active = true;
	return true;
}

static int
within(int x, int least, int most)
{
	return x < least || most < least ? least : x > most ? most : x;
}

/* Scrolls as far as the body of the frame wants: the size may be another. */
static void
fit(struct tui *t)
{
	struct viewer *v = &t->viewer;
	int rows = t->places.body.rows > 1 ? t->places.body.rows : 1;
	v->at = within(v->at, 0, v->lines - 1);
	if (v->keys)
		v->top = within(v->top, v->at - rows + 1, v->at);
	v->top = within(v->top, 0, v->lines - rows);
	v->left = within(v->left, 0, v->columns - t->places.body.columns);
}

static void
scroll_by(struct tui *t, int by)
{
	*(t->viewer.keys ? &t->viewer.at : &t->viewer.top) += by;
	fit(t);
}

const struct key *
view_key(struct tui *t, int code, bool special)
{
	struct viewer *v = &t->viewer;
	const struct key *key = keys_find(code, t->page), *chosen = NULL;
	int page = t->places.body.rows > 2 ? t->places.body.rows - 1 : 1;
	if (find(t, code, special))
		return NULL;
	if (key != NULL && key->act == ACT_LIST) {
		scroll_by(t, key->amount);
		return NULL;
	}
	if (key != NULL && key->act == ACT_MOVE && !v->keys) {
		v->left += key->amount * (t->places.body.columns + 1) / 2;
		fit(t);
		return NULL;
	}
	if (special && (code == KEY_NPAGE || code == KEY_PPAGE)) {
		scroll_by(t, code == KEY_NPAGE ? page : -page);
		return NULL;
	}
	if (code == ' ') {
		scroll_by(t, page);
		return NULL;
	}
	if (v->keys && (code == '\n' || code == '\r'))
		chosen = keys_nth(v->word.text, (size_t)v->at);
	else if (code == ':')
		chosen = key;
	view_close(t);
	return chosen;
}

/* The list of keys has one space between a key and what it does where it is
 * narrow. */
static void
squeeze(char *line)
{
	char *to = line;
	for (const char *from = line + strspn(line, " "); *from != '\0'; from++)
		if (from[0] != ' ' || from[1] != ' ')
			*to++ = *from;
	*to = '\0';
}

/* One line of the text.  Returns what of it there is no room for. */
static char *
draw_line(const struct tui *t, int row, const char *text, size_t n)
{
	enum { NARROW = 60 };
	const struct viewer *v = &t->viewer;
	const struct area *body = &t->places.body;
	bool chosen = v->keys && row + v->top == v->at;
	char *line = xstrndup(text, n), *rest = NULL;
	if (v->keys && body->columns < NARROW)
		squeeze(line);
	const char *shown = line;
	char left[TEXT_SHOWN];
	for (int c = 0; c < v->left && *shown != '\0';)
		c += text_show(&shown, left);
	screen_series(body, row, 0, SERIES_TEXT,
	    chosen ? LOOK_REVERSE : LOOK_PLAIN, shown);
	if (chosen && strlen(line) > (size_t)body->columns)
		rest = xstrdup(line + body->columns);
	free(line);
	return rest;
}

void
view_draw(struct tui *t)
{
	fit(t);
	const struct area *body = &t->places.body;
	const struct viewer *v = &t->viewer;
	char *rest = NULL;
	int line = -v->top;
	for (const char *p = v->text; *p != '\0'; line++) {
		size_t n = strcspn(p, "\n");
		char *cut = draw_line(t, line, p, n);
		rest = cut != NULL ? cut : rest;
		p += n + (p[n] == '\n');
	}
	bool below = v->lines - v->top > body->rows,
	     aside = !v->keys && v->columns - v->left > body->columns;
	char *hints = xasprintf("%s%s%s", below ? "more below: Down  " : "",
	    aside ? "more right: Right  " : "",
	    v->keys ? "Esc back  / find a word  Enter run it"
		    : "any other key: back");
	t->cursor =
	    (struct cursor){body->row + (v->keys ? v->at - v->top : 0), 0};
	if (v->word.active && t->places.hints.rows > 0) {
		t->cursor.row = t->places.hints.row;
		t->cursor.column = screen_text(
		    &t->places.hints, 0, 0, LOOK_BOLD, "/%s", v->word.text);
	} else if (rest != NULL)
		screen_text(&t->places.hints, 0, 0, LOOK_REVERSE, "%s", rest);
	else
		pane_hints(&t->places.hints, LOOK_REVERSE, hints);
	free(hints);
	free(rest);
}

/* Text on the whole screen: what commands print, and the list of keys.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "base/xalloc.h"
#include "ui/pane.h"
#include "ui/screen.h"

/* The list of keys has one blank between a key and what it does where it is
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
pane_text(const struct tui *t, int *row, int *column)
{
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
	    v->keys ? "Esc goes back  / finds a word  Enter does it"
		    : "any other key goes back");
	*row = body->row + (v->keys ? v->at - v->top : 0);
	*column = 0;
	if (v->filtering && t->places.hints.rows > 0) {
		*row = t->places.hints.row;
		*column = screen_text(
		    &t->places.hints, 0, 0, LOOK_BOLD, "/%s", v->word);
	} else if (rest != NULL)
		screen_text(&t->places.hints, 0, 0, LOOK_REVERSE, "%s", rest);
	else
		pane_hints(&t->places.hints, LOOK_REVERSE, hints);
	free(hints);
	free(rest);
}

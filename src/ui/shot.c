/* Presses keys by their names and draws frames without a terminal.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "ui/shot.h"

#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "base/xalloc.h"
#include "ui/act.h"
#include "ui/control.h"
#include "ui/frame.h"
#include "ui/pages.h"
#include "ui/pump.h"
#include "ui/screen.h"
#include "ui/tui_state.h"

/* Of the keys those that are not pressed yet, while there are any. */
static char *keys_left;
static char *letters; /* of one of them, typed into an answer */
static bool asks;     /* a question stands on the picture */

/* What the loop does between two keys; the clock goes on by a second, so that
 * the same keys give the same picture on any machine. */
static void
press(struct tui *t, int code, bool special)
{
	act_key(t, code, special);
	t->clock++;
	control_pump(t);
	control_predict(t);
	pages_update(t);
	if (!asks)
		frame_draw(t);
}

/* The next of the keys answers; without one the picture is that of the
 * question. */
static bool
answer(struct tui *t, int *code, bool *special)
{
	*special = false;
	frame_draw(t);
	if (letters == NULL || *letters == '\0')
		letters =
		    keys_left != NULL ? strtok_r(NULL, " ", &keys_left) : NULL;
	if (letters != NULL && keys_code(letters, code)) {
		*special = *code > 255;
		letters = NULL;
		return true;
	}
	asks = letters == NULL || t->inquiry == NULL;
	if (asks)
		return false;
	const char *next = letters;
	*code = (int)text_next(&next);
	letters += next - letters;
	return true;
}

const struct tui_ways SHOT_WAYS = {.answer = answer};

/* A word that is typed: a speed, or into a line. */
static bool
is_typed(const struct tui *t, const char *word)
{
	return t->typing.active || t->viewer.word.active ||
	       word[strspn(word, "0123456789.")] == '\0';
}

static bool
press_word(struct tui *t, const char *word, struct error *error)
{
	int code;
	if (strcmp(word, "^Z") == 0) {
		error_set(error, ERROR_USAGE,
		    "^Z needs a shell, and there is none here");
		return error_hint(error, "leave it out");
	}
	if (keys_code(word, &code)) {
		press(t, code, code > 255);
		return true;
	}
	if (!is_typed(t, word)) {
		error_set(error, ERROR_USAGE, "there is no key '%s'", word);
		return error_hint(error,
		    "use the names of tipspeed-tui(1), separated by "
		    "spaces: keys=\"Left Space c\"");
	}
	while (*word != '\0')
		press(t, (int)text_next(&word), false);
	return true;
}

static bool
press_all(struct tui *t, const char *keys, struct error *error)
{
	char *copy = xstrdup(keys);
	bool ok = true;
	asks = false;
	for (char *word = strtok_r(copy, " ", &keys_left);
	     ok && word != NULL && !t->leave && !t->session->quit;
	     word = strtok_r(NULL, " ", &keys_left)) {
		ok = press_word(t, word, error);
		if (ok && pump_signal() != 0)
			ok = error_set(error, ERROR_SYSTEM,
			    "interrupted at the key '%s'", word);
	}
	free(copy);
	keys_left = letters = NULL;
	return ok;
}

/* The open one, as it stands; the copy is drawn, so that nothing of it
 * changes. */
static bool
draw_open(const struct screen_request *request, struct error *error)
{
	struct tui t = *control_open();
	if (request->keys[0] != '\0') {
		error_set(error, ERROR_USAGE,
		    "keys= is for use outside full-screen mode");
		return error_hint(
		    error, "press the keys here, then type :screen");
	}
	if (request->page > 0)
		t.page = (enum page)(request->page - 1);
	t.row = NULL;
	t.rows_at = 0;
	pages_update(&t);
	frame_draw(&t);
	free(t.row);
	return true;
}

static bool
draw_new(struct session *s, const struct screen_request *request,
    struct error *error)
{
	struct tui t;
	control_begin(&t, s, &SHOT_WAYS);
	control_predict(&t);
	frame_draw(&t);
	if (request->page > 0)
		press(&t, '0' + request->page, false);
	bool ok = press_all(&t, request->keys, error);
	/* Before the session has its streams again: what a search that ends
	 * here says is not for the picture. */
	control_keep(&t);
	control_end(&t);
	return ok;
}

struct canvas *
shot_draw(struct session *s, const struct screen_request *request,
    struct error *error)
{
	struct screen_request r = *request;
	bool open = control_open() != NULL;
	int rows = 30, columns = 100;
	if (open)
		screen_size(&rows, &columns);
	r.rows = r.rows > 0 ? r.rows : rows;
	r.columns = r.columns > 0 ? r.columns : columns;
	if (open && !r.charset_asked)
		r.charset = screen_charset();
	if (open && !r.colours_asked)
		r.colours = screen_depth();
	struct display *was =
	    screen_aside(r.rows, r.columns, r.charset, r.colours);
	bool ok = open ? draw_open(&r, error) : draw_new(s, &r, error);
	struct canvas *canvas = screen_back(was);
	if (ok)
		return canvas;
	canvas_free(canvas);
	return NULL;
}

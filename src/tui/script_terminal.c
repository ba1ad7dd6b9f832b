/* Presses keys by their names and draws frames without a terminal.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "tui/script_terminal.h"

#include <limits.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "base/xalloc.h"
#include "tui/keymap.h"
#include "tui/control.h"
#include "tui/frame.h"
#include "tui/pane.h"
#include "cli/signals.h"
#include "tui/screen.h"
#include "tui/tui_state.h"
#include "tui/watch.h"
#include "tui/view.h"

/* The keys not pressed yet, or NULL. */
static char *keys_left;
static char *letters; /* of a word that is being typed into an answer */
static bool asks;     /* the picture shows a question */

/* Does what the screen's loop does for a key.  The clock advances by a second,
 * so that the same keys give the same picture on any machine. */
static void
press_key_in_script(struct tui *t, int code, bool special)
{
	keymap_handle_key(t, code, special);
	t->clock++;
	watch_run_due_fit_steps(t);
	view_update(t);
	if (!asks)
		frame_draw(t);
}

/* Answers with the next key.  If there is none, the picture shows the
 * question. */
static bool
answer_with_next_key(struct tui *t, int *code, bool *special)
{
	*special = false;
	frame_draw(t);
	if (letters == NULL || *letters == '\0')
		letters =
		    keys_left != NULL ? strtok_r(NULL, " ", &keys_left) : NULL;
	if (letters != NULL && keys_code_of_name(letters, code)) {
		*special = *code > 255;
		letters = NULL;
		return true;
	}
	asks = letters == NULL || t->inquiry == NULL;
	if (asks)
		return false;
	const char *next = letters;
	*code = (int)text_next_code_point(&next);
	letters += next - letters;
	return true;
}

const struct tui_callbacks SCRIPT_CALLBACKS = {.answer = answer_with_next_key};

/* Returns true for a word that is typed: into a line, or a speed. */
static bool
is_word_typed_as_text(const struct tui *t, const char *word)
{
	return keymap_is_typed_as_text(t, (unsigned char)word[0]) ||
	       word[strspn(word, "0123456789.")] == '\0';
}

/* Removes a count such as "*5" from the end of a word.  Returns how often the
 * key is to be pressed. */
static long
parse_key_repeat_count(char *word)
{
	char *sign = strrchr(word, '*'), *end;
	if (sign == NULL || sign == word || sign[1] < '0' || sign[1] > '9')
		return 1;
	long n = strtol(sign + 1, &end, 10);
	if (*end != '\0')
		return 1;
	*sign = '\0';
	return n;
}

/* Counts the keys pressed and limits them, because each draws a frame and may
 * need a prediction. */
static bool
count_and_limit_pressed_keys(
    const char *word, long n, long *pressed, struct error *error)
{
	enum { MOST = 9999 };
	if (n <= MOST - *pressed) {
		*pressed += n;
		return true;
	}
	return error_set(error, ERROR_USAGE,
	    "keys: expected at most %d keys, got %ld with '%s'\n"
	    "press fewer: Right*5 counts as five",
	    (int)MOST, n > LONG_MAX - *pressed ? LONG_MAX : *pressed + n, word);
}

static bool
press_keys_of_word(
    struct tui *t, char *word, long *pressed, struct error *error)
{
	int code;
	long n =
	    is_word_typed_as_text(t, word) ? 1 : parse_key_repeat_count(word);
	if (strcmp(word, "^Z") == 0) {
		error_set(error, ERROR_USAGE,
		    "^Z needs a shell, and there is none here");
		return error_set_hint(error, "leave it out");
	}
	bool key = keys_code_of_name(word, &code);
	if (!count_and_limit_pressed_keys(
		word, key ? n : text_width_in_columns(word), pressed, error))
		return false;
	if (key) {
		for (; n > 0 && !t->leave &&
		       signals_get_ending_or_interrupt() == 0;
		     n--)
			press_key_in_script(t, code, code > 255);
		return true;
	}
	if (!is_word_typed_as_text(t, word)) {
		error_set(error, ERROR_USAGE, "there is no key '%s'", word);
		return error_set_hint(error,
		    "use the names of tipspeed-tui(1), separated by "
		    "spaces: keys=\"Left Space c\"");
	}
	const char *letter = word;
	while (*letter != '\0')
		press_key_in_script(
		    t, (int)text_next_code_point(&letter), false);
	return true;
}

static bool
press_keys_of_script(struct tui *t, const char *keys, struct error *error)
{
	FREED char *copy = xstrdup(keys);
	bool ok = true;
	long pressed = 0;
	asks = false;
	for (char *word = strtok_r(copy, " ", &keys_left);
	     ok && word != NULL && !t->leave && !t->session->quit;
	     word = strtok_r(NULL, " ", &keys_left)) {
		ok = press_keys_of_word(t, word, &pressed, error);
		if (ok && signals_get_ending_or_interrupt() != 0)
			ok = error_set(error, ERROR_SYSTEM,
			    "interrupted at the key '%s'", word);
	}
	keys_left = letters = NULL;
	return ok;
}

/* Returns what `describe` calls the plot of the page, or NULL. */
static char *
plot_arguments_of_page(const struct tui *t)
{
	char *(*words)(const struct tui *) = pages_current(t)->words;
	return t->n_drawn == 0 ? NULL
	       : words != NULL ? words(t)
			       : pane_curves_plot_arguments(t);
}

/* Draws the open screen and leaves it as it was.  During a script, it is
 * brought up to date first, because what it showed may be gone. */
static bool
draw_open_screen(struct screen_request *request, struct error *error)
{
	if (request->keys[0] != '\0') {
		error_set(error, ERROR_USAGE,
		    "keys= is for use outside full-screen mode");
		return error_set_hint(
		    error, "press the keys here, then type :screen");
	}
	struct tui *t = control_current_screen();
	const struct tui was = *t;
	const bool stale = t->running_line != NULL;
	t->aside = true;
	t->picker.on = false;
	if (stale) {
		control_discard_outdated_state(t);
		view_predict_unrecorded(t);
	}
	if (request->page > 0)
		pages_go_to(t, (enum page)(request->page - 1));
	pages_update(t);
	frame_draw(t);
	tui_clear_click_areas(t);
	t->aside = was.aside;
	t->picker.on = was.picker.on;
	t->ui = was.ui;
	t->filter = was.filter;
	t->layout = was.layout;
	if (stale)
		t->view.current = was.view.current;
	return true;
}

static bool
draw_temporary_screen(
    struct session *s, struct screen_request *request, struct error *error)
{
	struct tui t;
	control_open_screen(&t, s, &SCRIPT_CALLBACKS);
	view_predict_at_slider(&t);
	if (request->page > 0) {
		frame_draw(&t);
		press_key_in_script(&t,
		    keys_code_of_page((enum page)(request->page - 1)), false);
	} else {
		pages_update(&t);
		frame_draw(&t);
	}
	bool ok = press_keys_of_script(&t, request->keys, error);
	if (ok && request->words && t.viewer.text == NULL)
		request->picture = plot_arguments_of_page(&t);
	/* While output is still captured: what a search prints when it ends is
	 * not part of the picture. */
	tui_stop_fit(&t);
	control_close_screen(&t);
	return ok;
}

struct canvas *
script_draw_screen(
    struct session *s, struct screen_request *request, struct error *error)
{
	struct screen_request r = *request;
	bool open = control_current_screen() != NULL;
	int rows = 30, columns = 100;
	if (open)
		screen_size(&rows, &columns);
	r.rows = r.rows > 0 ? r.rows : rows;
	r.columns = r.columns > 0 ? r.columns : columns;
	if (open && !r.charset_asked)
		r.charset = screen_charset();
	if (open && !r.colours_asked)
		r.colours = screen_colour_count();
	struct display *was =
	    screen_begin_offscreen(r.rows, r.columns, r.charset, r.colours);
	screen_omit_charts_and_lines(r.words);
	bool ok = open ? draw_open_screen(&r, error)
		       : draw_temporary_screen(s, &r, error);
	struct canvas *canvas = screen_end_offscreen(was);
	request->picture = r.picture;
	if (ok)
		return canvas;
	canvas_free(canvas);
	return NULL;
}

/* Scrolls, searches and draws text on the whole screen.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "tui/widgets/viewer.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "base/tr.h"
#include "base/xalloc.h"
#include "tui/acts.h"
#include "tui/pane.h"
#include "tui/screen.h"

/* Returns the text with its long lines wrapped to the screen, but those of
 * tables, which have more than a space between two columns. */
static char *
wrap_long_lines(const char *text, int columns)
{
	char *all = NULL;
	size_t size = 0, n;
	FILE *out = text_open_memory(&all, &size);
	for (const char *p = text; *p != '\0'; p += n + (p[n] == '\n')) {
		n = strcspn(p, "\n");
		FREED char *line = xstrndup(p, n);
		if (strstr(line + strspn(line, " "), "  ") != NULL ||
		    text_width_in_columns(line) <= columns)
			fprintf(out, "%s\n", line);
		else
			text_print_wrapped(line, 0, columns, out);
	}
	fclose(out);
	return all;
}

static void
viewer_free_lines(struct viewer *v)
{
	for (int i = 0; i < v->lines; i++)
		free(v->line[i]);
	free(v->line);
	v->line = NULL;
	v->lines = v->columns = 0;
}

/* Splits the text into lines that fit the screen, and finds the width of the
 * longest. */
static void
viewer_split_into_lines(struct viewer *v)
{
	int rows;
	screen_size(&rows, &v->screen);
	FREED char *text = wrap_long_lines(v->text, v->screen);
	viewer_free_lines(v);
	for (const char *p = text; *p != '\0'; v->lines++) {
		size_t n = strcspn(p, "\n");
		char *line = xstrndup(p, n);
		int columns = text_width_in_columns(line);
		v->columns = columns > v->columns ? columns : v->columns;
		v->line =
		    xrealloc(v->line, (size_t)v->lines + 1, sizeof *v->line);
		v->line[v->lines] = line;
		p += n + (p[n] == '\n');
	}
}

void
viewer_close(struct tui *t)
{
	tui_clear_click_areas(t);
	struct viewer *v = &t->viewer;
	viewer_free_lines(v);
	if (v->text != NULL && !v->keys) {
		xfree_and_set(&t->closed, v->text);
	} else {
		free(v->text);
	}
	*v = (struct viewer){0};
}

void
viewer_show_text(struct tui *t, char *text)
{
	viewer_close(t);
	t->viewer = (struct viewer){.text = text, .at = -1};
	viewer_split_into_lines(&t->viewer);
}

void
act_show_last_text(struct tui *t, const struct key *key)
{
	(void)key;
	if (t->closed != NULL)
		viewer_show_text(t, xstrdup(t->closed));
	else
		tui_set_message(t, false, "no text has been shown yet");
}

/* Lists the keys whose line contains the word. */
static void
show_list_of_keys(struct tui *t)
{
	struct edit word = t->viewer.word;
	char *text = NULL;
	size_t n = 0;
	FILE *out = text_open_memory(&text, &n);
	keys_print_list(
	    t->ui.page, word.text, tui_slider_range(t).rotor > 0, out);
	fclose(out);
	viewer_show_text(t, text);
	t->viewer.keys = true;
	t->viewer.word = word;
	t->viewer.at = 0;
	viewer_scroll(t, 0);
}

void
act_list_keys(struct tui *t, const struct key *key)
{
	(void)key;
	show_list_of_keys(t);
}

/* Makes a layout of its own, because that of the last frame may be another. */
void
viewer_show_long_message(struct tui *t)
{
	enum { MARGIN = 2, LEAST = 8 };
	int rows, columns;
	screen_size(&rows, &columns);
	const struct layout l =
	    layout_make(rows, columns, (struct layout_ask){0});
	columns = columns > LEAST + MARGIN ? columns - MARGIN : LEAST;
	if (text_count_rows(t->message, columns) >
		layout_count_message_rows(&l) &&
	    t->viewer.text == NULL)
		viewer_show_text(t, xstrdup(t->message));
}

static bool
has_line_searched_word(const struct viewer *v, int line)
{
	return text_contains_folded(v->line[line], v->word.text);
}

/* Returns how many lines before line `before` contain the word. */
static int
count_matching_lines_before(const struct viewer *v, int before)
{
	int n = 0;
	for (int i = 0; i < before; i++)
		n += has_line_searched_word(v, i);
	return n;
}

static int
clamp_to_range(int x, int least, int most)
{
	return x < least || most < least ? least : x > most ? most : x;
}

/* Returns the number of rows of the text.  The list of keys is in two columns
 * if all of it then fits. */
static int
count_text_rows(const struct tui *t)
{
	enum { TWO = 76 };
	const struct viewer *v = &t->viewer;
	const struct area *body = &t->layout.body;
	bool two = v->keys && v->word.n == 0 && body->columns >= TWO &&
		   v->lines > body->rows && v->lines <= 2 * body->rows;
	return two ? (v->lines + 1) / 2 : v->lines;
}

/* Keeps the position within the text, because the screen's size may have
 * changed. */
static void
clamp_scroll_position(struct tui *t)
{
	struct viewer *v = &t->viewer;
	int rows = t->layout.body.rows > 1 ? t->layout.body.rows : 1;
	if (v->keys) {
		v->at = clamp_to_range(v->at, 0, v->lines - 1);
		v->top = clamp_to_range(v->top, v->at - rows + 1, v->at);
	}
	v->top = clamp_to_range(v->top, 0, count_text_rows(t) - rows);
	v->left =
	    clamp_to_range(v->left, 0, v->columns - t->layout.body.columns);
}

/* Goes to a line with the word, and scrolls it to the middle if it was not
 * visible. */
static void
viewer_go_to_line(struct tui *t, int line)
{
	struct viewer *v = &t->viewer;
	int rows = t->layout.body.rows;
	v->at = line;
	if (line >= 0 && (line < v->top || line >= v->top + rows))
		v->top = line - rows / 2;
	clamp_scroll_position(t);
}

/* Returns the first line that contains the word, beginning at a line and going
 * in steps of `by`, around the ends too; -1 if there is none. */
static int
find_line_with_word(const struct viewer *v, int from, int by)
{
	for (int i = 0; i < v->lines; i++) {
		int line = (from + i * by + 2 * v->lines) % v->lines;
		if (has_line_searched_word(v, line))
			return line;
	}
	return -1;
}

/* Handles a key while the word after / is typed, or the / itself.  Returns
 * false for other keys. */
static bool
handle_text_search_key(struct tui *t, int code, bool special)
{
	struct viewer *v = &t->viewer;
	struct edit *word = &v->word;
	if (!word->active && (special || code != '/'))
		return false;
	if (!word->active) {
		word->active = true;
		return true;
	}
	if (code == '\n' && !special && !v->keys) {
		word->active = false;
		return true;
	}
	if (!edit_insert_or_erase_letter(word, code, special, VIEWER_WORD))
		return false;
	if (v->keys) {
		show_list_of_keys(t);
	} else {
		int from = v->at >= 0 ? v->at : v->top;
		v->at = -1;
		if (word->n > 0)
			viewer_go_to_line(t, find_line_with_word(v, from, 1));
	}
	return true;
}

/* In the list of keys, moves the choice instead. */
void
viewer_scroll(struct tui *t, int by)
{
	struct viewer *v = &t->viewer;
	if (!v->keys) {
		v->top += by;
		clamp_scroll_position(t);
		return;
	}
	int keys = (int)keys_count_listed(t->ui.page, v->word.text);
	v->at = clamp_to_range(v->at + by, 0, keys - 1);
	clamp_scroll_position(t);
}

/* Clears the word searched for.  Returns false if there was none. */
static bool
clear_searched_word(struct tui *t)
{
	struct viewer *v = &t->viewer;
	if (!v->word.active && v->word.n == 0)
		return false;
	v->word = (struct edit){0};
	if (v->keys)
		show_list_of_keys(t);
	else
		v->at = -1;
	return true;
}

/* Handles a key that moves through the text.  Returns false for other keys. */
static bool
handle_scroll_key(struct tui *t, const struct key *key, int code)
{
	struct viewer *v = &t->viewer;
	int page = t->layout.body.rows > 2 ? t->layout.body.rows - 1 : 1;
	key_action *act = key != NULL ? key->act : NULL;
	int steps = act == act_move_list_or_slider ? key->amount : 0;
	int way = steps > 0 ? 1 : -1, rows = count_text_rows(t);
	if (act == act_move_in_list)
		viewer_scroll(t, key->amount);
	else if (abs(steps) == FAR)
		viewer_scroll(t, -way * page);
	else if (steps != 0 && !v->keys)
		v->left += way * (t->layout.body.columns + 1) / 2;
	else if (steps != 0)
		viewer_scroll(t, rows < v->lines ? way * rows : 0);
	else if (code == ' ')
		viewer_scroll(t, page);
	else if (act == act_move_to_end)
		viewer_scroll(
		    t, key->amount == TO_LEAST ? -v->lines : v->lines);
	else if (!v->keys && v->word.n > 0 && (code == 'n' || code == 'N'))
		viewer_go_to_line(
		    t, code == 'N' ? find_line_with_word(v, v->at - 1, -1)
				   : find_line_with_word(v, v->at + 1, 1));
	else
		return false;
	clamp_scroll_position(t);
	return true;
}

/* Returns true if a key changes results or the speed: a key pressed to close a
 * text, or to go through it as in other programs, must not do that.  A first
 * calibration replaces nothing, so it may. */
static bool
is_key_changing_results(const struct tui *t, const struct key *key)
{
	const struct entry *entry = tui_current_site_entry(t);
	bool first = entry != NULL && !entry->has_params &&
		     !session_is_calibrating(t->session);
	return key->where & CHANGES && !(key->act == act_calibrate && first);
}

/* Returns true if a key, which has closed the text, does nothing else. */
static bool
does_key_only_close_viewer(
    struct tui *t, const struct key *key, int code, bool keys)
{
	if (code == ESCAPE || code == '\n')
		return true;
	if (key == NULL)
		return false;
	if (key->act == act_leave_screen || (keys && key->act == act_list_keys))
		return true;
	if (is_key_changing_results(t, key) && code != INTERRUPT)
		tui_set_message(t, false, "%s again: %s", key->name,
		    keys_text_for_speed_unit(
			key->what, tui_slider_range(t).rotor > 0));
	return is_key_changing_results(t, key);
}

bool
viewer_handle_key(struct tui *t, int code, bool special, const struct key **run)
{
	struct viewer *v = &t->viewer;
	const struct key *key = keys_find_by_code(code, t->ui.page);
	code = special ? 0 : code == '\r' ? '\n' : code;
	if (handle_text_search_key(t, code, special) ||
	    handle_scroll_key(t, key, code) ||
	    (code == ESCAPE && clear_searched_word(t)))
		return true;
	bool keys = v->keys;
	if (keys && code == '\n') {
		*run = keys_nth_listed(t->ui.page, v->word.text, (size_t)v->at);
		if (*run != NULL)
			viewer_close(t);
		return true;
	}
	/* The message, which says how to show the report again, stays when the
	 * report is closed. */
	t->keep_message = t->keep_message || v->report;
	viewer_close(t);
	return does_key_only_close_viewer(t, key, code, keys);
}

/* Leaves one space between a key and what it does, for a narrow screen. */
static void
squeeze_spaces(char *line)
{
	char *to = line;
	for (const char *from = line + strspn(line, " "); *from != '\0'; from++)
		if (from[0] != ' ' || from[1] != ' ')
			*to++ = *from;
	*to = '\0';
}

/* Chooses the key that was clicked; the Enter that follows runs it. */
static void
on_click_choose_key(struct tui *t, const struct mouse_event *touched)
{
	t->viewer.at = (int)touched->item;
}

/* Draws a line of the text.  In the list of keys, a line that is too long is
 * cut; if it is the chosen one, returns the rest of it, which the caller frees,
 * else NULL. */
static char *
viewer_draw_line(struct tui *t, int n)
{
	enum { NARROW = 60 };
	static const char MORE[] = " ..";
	const struct viewer *v = &t->viewer;
	const int rows = count_text_rows(t);
	struct area body = t->layout.body;
	bool found = !v->keys && v->word.n > 0 && has_line_searched_word(v, n);
	char *line = xstrdup(v->line[n]), *rest = NULL;
	if (v->keys && body.columns < NARROW)
		squeeze_spaces(line);
	if (rows < v->lines)
		body.columns /= 2;
	body.column = n / rows * body.columns;
	int room = body.columns - (int)strlen(MORE);
	if (v->keys && strlen(line) > (size_t)body.columns && room > 0) {
		rest = xstrdup(line + room);
		snprintf(line + room, sizeof MORE, "%s", MORE);
	}
	const char *shown = line;
	char left[TEXT_SHOWN];
	for (int c = 0; c < v->left && *shown != '\0';)
		c += text_escape_next_character(&shown, left);
	screen_draw_clipped_text(&body, n % rows - v->top, 0, SERIES_TEXT,
	    n == v->at ? LOOK_REVERSE
	    : found    ? LOOK_BOLD
		       : LOOK_PLAIN,
	    shown);
	free(line);
	if (n == v->at)
		return rest;
	free(rest);
	return NULL;
}

/* Draws the word searched for, and the number of lines that contain it.
 * Returns the cursor's column. */
static int
draw_search_word_and_count(struct tui *t)
{
	const struct viewer *v = &t->viewer;
	const struct area *hints = &t->layout.hints;
	int number = v->keys || v->at < 0
			 ? 0
			 : count_matching_lines_before(v, v->at + 1);
	const size_t keys =
	    v->keys ? keys_count_listed(t->ui.page, v->word.text) : 0;
	int lines = v->keys ? 0 : count_matching_lines_before(v, v->lines);
	char *found = v->word.n == 0 ? NULL
		      : v->keys      ? xasprintf(tr("%zu keys"), keys)
				     : xasprintf(tr("%d lines"), lines);
	if (number > 0 && found != NULL) {
		FREED char *matches = found;
		found = xasprintf(tr("line %d of %s"), number, matches);
	}
	int at = pane_draw_search_word(t, hints, v->word.text, found,
	    keys > 0         ? tr("Enter run it  Esc clear")
	    : v->keys        ? tr("Esc clear")
	    : v->word.active ? tr("Enter keep  Esc clear")
			     : tr("n next  N previous  Esc clear"));
	free(found);
	return at;
}

/* Draws what Enter does in the list of keys, if all of it fits. */
static bool
draw_what_enter_does(struct tui *t)
{
	const struct viewer *v = &t->viewer;
	const struct key *key =
	    v->keys ? keys_nth_listed(t->ui.page, v->word.text, (size_t)v->at)
		    : NULL;
	if (key == NULL)
		return false;
	FREED char *words = xasprintf(tr("Enter: %s"),
	    keys_text_for_speed_unit(key->what, tui_slider_range(t).rotor > 0));
	bool room = text_width_in_columns(words) <= t->layout.hints.columns;
	if (room)
		pane_draw_key_hints(t, words);
	return room;
}

static void
viewer_draw_hints(struct tui *t)
{
	const struct area *body = &t->layout.body;
	const struct viewer *v = &t->viewer;
	bool below = count_text_rows(t) - v->top > body->rows,
	     aside = !v->keys && v->columns - v->left > body->columns;
	FREED char *hints =
	    xasprintf("%s%s%s", below ? tr("Down more below  ") : "",
		aside ? tr("Right more right  ") : "",
		v->keys ? tr("Esc back  / find a word  Enter run it")
			: tr("Esc back  / search"));
	pane_draw_key_hints(
	    t, t->running_line != NULL ? tr("Esc stops") : hints);
}

/* After a change of the screen's width, splits the text into other lines, and
 * goes to about the same place. */
static void
viewer_split_for_other_width(struct viewer *v)
{
	int rows, columns, lines = v->lines;
	screen_size(&rows, &columns);
	if (v->screen == columns || lines == 0)
		return;
	viewer_split_into_lines(v);
	v->top = v->top * v->lines / lines;
	v->at = v->keys ? v->at : -1;
}

void
viewer_draw(struct tui *t)
{
	viewer_split_for_other_width(&t->viewer);
	clamp_scroll_position(t);
	const struct area *body = &t->layout.body;
	const struct viewer *v = &t->viewer;
	char *rest = NULL;
	const int rows = count_text_rows(t),
		  columns = body->columns / (rows < v->lines ? 2 : 1);
	for (int n = v->top; n < v->lines; n++) {
		int row = n % (rows > 0 ? rows : 1) - v->top;
		if (row >= body->rows)
			continue;
		char *cut = viewer_draw_line(t, n);
		rest = cut != NULL ? cut : rest;
		if (v->keys &&
		    keys_nth_listed(t->ui.page, v->word.text, (size_t)n))
			hits_add_handler_and_key(&t->hits,
			    area_of_columns_in_row(
				body, row, n / rows * columns, columns),
			    on_click_choose_key, (size_t)n, '\n');
	}
	int at = v->lines > 0 ? v->at % rows - v->top : 0;
	t->cursor =
	    (struct cursor){body->row + (at > 0 && at < body->rows ? at : 0),
		v->at > 0 ? v->at / rows * columns : 0};
	if ((v->word.active || v->word.n > 0) && t->layout.hints.rows > 0) {
		int column = draw_search_word_and_count(t);
		if (v->word.active)
			t->cursor =
			    (struct cursor){t->layout.hints.row, column};
	} else if (rest != NULL)
		screen_draw_text(
		    &t->layout.hints, 0, 0, LOOK_REVERSE, "%s", rest);
	else if (!draw_what_enter_does(t))
		viewer_draw_hints(t);
	free(rest);
}

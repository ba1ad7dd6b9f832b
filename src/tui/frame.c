/* Draws what surrounds every page: heading, slider, last command, status,
 * hints.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "tui/frame.h"

#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "base/tr.h"
#include "base/xalloc.h"
#include "cmd/ask/fit.h"
#include "cmd/fit/job.h"
#include "cmd/ask/trust_light.h"
#include "tui/widgets/response_strip.h"
#include "tui/widgets/file_picker.h"
#include "tui/widgets/dialog.h"
#include "tui/pane.h"
#include "tui/widgets/list.h"
#include "tui/screen.h"
#include "tui/widgets/track.h"
#include "tui/widgets/panel.h"
#include "tui/widgets/viewer.h"

/* Writes a page's key and name for the heading.  On a narrow screen the other
 * pages have no names; on a very narrow one, nor has the open page. */
static const char *
page_tab_text(const struct tui *t, size_t p, int columns, char text[static 24])
{
	bool here = p == t->ui.page;
	const char *name = columns >= 76 || (here && columns >= 34)
			       ? tr(PAGE_HEADINGS[p])
			       : "";
	const char *gap = name[0] != '\0' ? " " : "";
	const char *open = here ? "[" : columns >= 76 ? " " : "";
	snprintf(text, 24, "%s%c%s%s%s", open, keys_code_of_page((enum page)p),
	    gap, name, here ? "]" : "");
	return text;
}

/* Returns the site's name, with a feed that is not its own if there is room. */
static char *
short_site_label(const struct tui *t, int columns)
{
	const char *name = tui_current_site(t)->name,
		   *other = tui_other_feed(t);
	FREED char *with = xasprintf(tr("%s, with %s"), name, other);
	bool fits = text_width_in_columns(with) < columns;
	return xstrdup(other[0] != '\0' && fits ? with : name);
}

static void
draw_screen_header(struct tui *t)
{
	const struct area *area = &t->layout.header;
	const struct entry *entry = tui_current_site_entry(t);
	char text[24];
	int help = area->columns >= 76 ? 8 : 0, column = area->columns - help;
	for (size_t p = 0; p < PAGES; p++)
		column -=
		    (int)strlen(page_tab_text(t, p, area->columns, text)) + 1;
	struct area left = *area;
	left.columns = column < 1 ? 0 : column - 1;
	FREED char *label =
	    entry != NULL
		? session_site_label(tui_site_entry_for_prediction(t)->site)
	    : left.columns < 18 ? xstrdup(tr("no site"))
				: xstrdup(tr("no site is loaded"));
	bool room = text_width_in_columns(label) + 11 <= left.columns;
	if (text_width_in_columns(label) >= left.columns && entry != NULL)
		xfree_and_set(&label, short_site_label(t, left.columns));
	screen_draw_text(&left, 0, 0, LOOK_BOLD, "%s%s",
	    room ? tr("tipspeed  ") : "", label);
	column = column < 0 ? 0 : column;
	for (size_t p = 0; p < PAGES; p++) {
		int from = column;
		column = screen_draw_text(area, 0, column,
		    p == t->ui.page ? LOOK_REVERSE : LOOK_PLAIN, "%s",
		    page_tab_text(t, p, area->columns, text));
		hits_add_key_area(&t->hits,
		    area_of_columns_in_row(area, 0, from, column - from),
		    keys_code_of_page((enum page)p));
		column++;
	}
	if (help == 0)
		return;
	screen_draw_text(area, 0, column, LOOK_DIM, " ? help");
	hits_add_key_area(
	    &t->hits, area_of_columns_in_row(area, 0, column, help), '?');
}

/* Moves the cursor to where the line is clicked. item: offset of the first byte
 * shown. */
static void
on_click_typed_line(struct tui *t, const struct mouse_event *touched)
{
	const char *at = t->line.text + touched->item;
	char left[TEXT_SHOWN];
	for (int c = 1; c < touched->column && *at != '\0';)
		c += text_escape_next_character(&at, left);
	t->line.at = (size_t)(at - t->line.text);
}

/* Draws the line being typed, or the last command.  Returns the column of the
 * cursor. */
static int
draw_command_line(struct tui *t, const struct area *area)
{
	if (t->line.active) {
		size_t from;
		int at = pane_draw_typed_line(
		    area, t->goal_field ? tr("goal: ") : ":", &t->line, &from);
		hits_add_mouse_handler(
		    &t->hits, HIT_PRESS, *area, on_click_typed_line, from);
		return at;
	}
	hits_add_key_area(&t->hits, *area, ':');
	const char *tail =
	    t->failed ? tr("(failed)") : tr("(last action, as a command)");
	int column = screen_draw_text(
	    area, 0, 0, 0, ": %s", t->command != NULL ? t->command : "");
	if (t->command != NULL &&
	    column + 4 + text_width_in_columns(tail) < area->columns)
		screen_draw_text(area, 0,
		    area->columns - text_width_in_columns(tail) - 1, LOOK_DIM,
		    "%s", tail);
	return 0;
}

/* Draws the message.  If it is too long for its row, it begins in the row
 * above, that of the last command.  If there is no such row, or a line is being
 * typed there, it continues in the row of hints.  Returns true if it covers the
 * hints. */
static bool
frame_draw_message(const struct tui *t, const struct area *row)
{
	struct area area = *row;
	FREED char *text = xasprintf("%s%s", t->bad ? "! " : "", t->message);
	bool wide = text_width_in_columns(text) > area.columns,
	     above = row == &t->layout.status && !t->line.active,
	     hints = wide && !above && t->layout.hints.rows > 0;
	if (wide)
		area.rows = layout_count_message_rows(&t->layout);
	if (area.rows == 2 && !hints)
		area.row--;
	screen_clear_area(&area);
	screen_draw_wrapped(&area, 0, t->bad ? LOOK_BOLD : LOOK_PLAIN, text);
	return hints;
}

/* Draws the state of a search or another job. */
static int
draw_job_state(const struct tui *t, const struct area *area)
{
	const struct session *s = t->session;
	if (!s->job.fits) {
		FREED char *at = s->job.type->task_words(s);
		return screen_draw_text(area, 0, 0, LOOK_BOLD,
		    area->columns < 60 ? "%s  %s" : N_("%s  %s: Esc stops"),
		    t->held ? tr("PAUSED") : tr("WORKING"), at);
	}
	struct calibrate_status st = calibration_status(s->job.calibration);
	return screen_draw_text(area, 0, 0, LOOK_BOLD,
	    area->columns < 34 ? "%s %zu/%zu"
	    : st.state == CALIBRATE_POLISHING
		? N_("%s  generation %zu of %zu, polishing")
		: N_("%s  generation %zu of %zu"),
	    t->held ? tr("PAUSED") : tr("CALIBRATING"), st.generation,
	    s->job.options.generations);
}

/* Draws what to do next.  If there is little room, leaves out the reason. */
static int
draw_what_to_do_next(const struct area *area, const char *words)
{
	const char *ready = tr("READY  "), *act = strstr(words, ": ");
	int room = area->columns - text_width_in_columns(words);
	return screen_draw_text(area, 0, 0, 0, "%s%s",
	    room >= text_width_in_columns(ready) ? ready : "",
	    room < 0 && act != NULL ? act + 2 : words);
}

/* Returns how good the parameters of the site are, or what to do first.  The
 * caller frees it. */
static char *
site_calibration_status_text(struct tui *t, int columns)
{
	const struct session *s = t->session;
	const struct entry *entry = tui_current_site_entry(t);
	if (entry == NULL)
		return xstrdup(tr("no site: o opens a sheet"));
	if (!entry->has_params)
		return xstrdup(site_count_products(entry->site) > 0
				   ? tr("not calibrated: f calibrates")
				   : tr("no product: type :guess"));
	char *verdict = panel_trust_text(
	    t, columns - text_width_in_columns(tr("READY  ")), columns);
	if (verdict[0] != '\0')
		return verdict;
	free(verdict);
	return entry->has_fit
		   ? xasprintf("%s%s",
			 fit_has_too_few_data(&entry->fit) ? "" : tr("fit "),
			 verdict_on_fit(
			     entry, light_of_answer_or_fit(s, entry, NULL)))
		   : xasprintf(
			 tr("parameters %s"), origin_of_params_text(entry));
}

/* Draws site_calibration_status_text or, during a search, the state of the
 * search, because the text would have to be computed anew for each frame. */
static void
draw_status_row(struct tui *t, const struct area *area)
{
	FREED char *words =
	    session_is_calibrating(t->session)
		? NULL
		: site_calibration_status_text(t, area->columns);
	int column = words == NULL ? draw_job_state(t, area)
				   : draw_what_to_do_next(area, words);
	char right[64];
	snprintf(right, sizeof right,
	    t->mouse ? tr("mouse on  %s  %d colours")
		     : tr("mouse off  %s  %d colours"),
	    screen_charset() == CHARSET_ASCII ? tr("ascii") : tr("utf8"),
	    screen_colour_count());
	int from = area->columns - text_width_in_columns(right) - 1;
	if (from > column + 2)
		screen_draw_text(area, 0, from, LOOK_DIM, "%s", right);
}

static void
on_click_completion(struct tui *t, const struct mouse_event *touched)
{
	edit_insert_completion(&t->line, touched->item);
}

/* Draws the completions of a word, and ".." if there are more, which Tab
 * shows. */
static void
draw_completions(struct tui *t, const struct area *area)
{
	struct edit *y = &t->line;
	enum { MORE = 3 };
	int column = 0;
	size_t i = y->from, n;
	const char *offer = edit_get_nth_offered_completion(y, i, &n);
	for (; offer != NULL;
	     offer = edit_get_nth_offered_completion(y, ++i, &n)) {
		char *text = xstrndup(offer, n);
		int width = text_width_in_columns(text), from = column,
		    room = area->columns - from - MORE;
		if (width > room && from > 0) {
			free(text);
			break;
		}
		column = screen_draw_text(area, 0, from, 0, "%s", text);
		hits_add_mouse_handler(&t->hits, HIT_PRESS,
		    area_of_columns_in_row(area, 0, from, column - from),
		    on_click_completion, i);
		column += 2;
		free(text);
	}
	y->shown = i - y->from;
	if (offer != NULL || y->from > 0)
		screen_draw_text(area, 0, area->columns - MORE, 0, " ..");
}

/* Draws the word by which rows are filtered, and the number of rows that
 * contain it. */
static void
draw_filter_word(struct tui *t, const struct area *area)
{
	FREED char *found = xasprintf(tr("%zu of %zu"),
	    list_count_matching_rows(t), pages_current(t)->list->n(t));
	int at = pane_draw_search_word(
	    t, area, t->filter.text, found, tr("Enter keep it  Esc all rows"));
	if (t->filter.active && area->rows > 0)
		t->cursor = (struct cursor){area->row, at};
}

static bool
is_list_filter_shown(const struct tui *t)
{
	return (t->filter.active || t->filter.n > 0) &&
	       pages_current(t)->list != NULL;
}

/* Returns the hints for what is being typed, or NULL. */
static const char *
key_hints_while_typing(const struct tui *t)
{
	const struct edit *line = &t->line;
	if (!line->active)
		return t->speed.n > 0 ? N_("Enter go there  Esc give up")
				      : NULL;
	if (t->goal_field)
		return line->n > 0
			   ? N_("Enter set it  Tab complete  ^U clear  "
				"Esc give up")
			   : N_("Enter no goal  Tab lists  Esc give up");
	return strstr(line->text, " > ") != NULL
		   ? N_("Enter write  Esc give up  table: .csv .xlsx .json, "
			"plot: .svg .png .pdf")
		   : N_("Enter run  Tab complete  Up earlier lines  Esc give "
			"up");
}

static void
frame_draw_key_hints(struct tui *t)
{
	const struct page_ops *page = pages_current(t);
	const char *typing = key_hints_while_typing(t);
	if (typing == NULL && is_list_filter_shown(t)) {
		draw_filter_word(t, &t->layout.hints);
		return;
	}
	const char *keys =
	    page->hints != NULL ? page->hints : page->hints_now(t);
	FREED char *hints = typing != NULL
				? xstrdup(typing)
				: keys_hint_row_text(tr(keys), t->ui.page);
	pane_draw_key_hints(t, hints);
}

static void
draw_typed_speed(struct tui *t, const struct area *note)
{
	bool narrow = note->columns < 24;
	const char *typed = t->speed.text + (t->speed.text[0] == '=');
	/* A number above SITE_FASTEST must be rpm: no tip speed is as high. */
	struct slider_range range = tui_slider_range(t);
	bool part = range.rotor > 0 && !slider_has_speed(range, atof(typed));
	const char *unit = strpbrk(typed, "rpms") != NULL ? ""
			   : atof(typed) > SITE_FASTEST   ? " rpm"
			   : part                         ? ""
							  : " m/s";
	int at = screen_draw_text(
	    note, 0, 0, LOOK_BOLD, narrow ? "%s" : N_("speed: %s"), typed);
	screen_draw_text(note, 0, at, LOOK_BOLD,
	    narrow && unit[0] != '\0' ? N_("_%s, Enter") : N_("_%s (Enter)"),
	    unit);
	t->cursor = (struct cursor){note->row, at};
}

/* Returns true if the status is shown in the row of the command, because it has
 * no row of its own and matters more.  On the smallest screens it matters more
 * only while a job runs. */
static bool
is_status_in_command_row(const struct tui *t)
{
	const struct layout *l = &t->layout;
	return l->status.rows == 0 &&
	       (l->hints.rows > 0 || session_is_calibrating(t->session));
}

/* Draws the row of messages: what is being typed there, the message, or the
 * status.  Returns true if it covers the hints. */
static bool
draw_message_row(struct tui *t, const struct area *note)
{
	const struct layout *l = &t->layout;
	if (t->speed.text[0] != '\0') {
		draw_typed_speed(t, note);
	} else if (t->line.active && t->line.offers != NULL) {
		draw_completions(t, note);
	} else if (is_list_filter_shown(t) && l->hints.rows == 0) {
		screen_clear_area(note);
		draw_filter_word(t, note);
	} else if (t->message[0] != '\0' && note != &l->track) {
		return frame_draw_message(t, note);
	} else if (note == &l->status || is_status_in_command_row(t)) {
		draw_status_row(t, note);
	}
	return false;
}

static void
draw_bottom_rows(struct tui *t)
{
	struct layout *l = &t->layout;
	const struct area *note = l->status.rows > 0    ? &l->status
				  : l->command.rows > 0 ? &l->command
							: &l->track;
	const struct area *line = l->command.rows > 0 ? &l->command : &l->track;
	bool typing = t->line.active;
	bool taken = line == note && (t->message[0] || t->speed.text[0] ||
					 is_status_in_command_row(t));
	/* While a line is typed, a click elsewhere does nothing. */
	if (typing)
		hits_clear_click_areas(&t->hits);
	if (typing || (l->command.rows > 0 && !taken)) {
		if (typing && line == &l->track)
			screen_clear_area(line);
		int at = draw_command_line(t, line);
		if (typing)
			t->cursor = (struct cursor){line->row, at};
	}
	/* A line typed in the row of messages has its completions in the row of
	 * hints. */
	bool offers = t->line.offers != NULL && l->hints.rows > 0;
	if (note == line && typing && offers)
		draw_completions(t, &l->hints);
	else if ((note == line && typing) || !draw_message_row(t, note))
		frame_draw_key_hints(t);
}

/* Draws the question over the last rows of the screen, at any size. */
static void
draw_yes_no_question(struct tui *t, int rows, int columns)
{
	FREED char *asks = xasprintf("%s %c/%c", t->question, tr_yes_letter(),
		       tr_letter_for_no()),
		   *text = text_wrapped(asks, columns);
	int n = text_count_rows(asks, columns);
	struct area area = {rows - n, 0, n, columns};
	screen_clear_area(&area);
	screen_draw_wrapped(&area, 0, LOOK_BOLD, asks);
	text[strlen(text) - 1] = '\0';
	const char *last = strrchr(text, '\n');
	int end = text_width_in_columns(last != NULL ? last + 1 : text);
	t->cursor = (struct cursor){rows - 1, end};
	/* The text ends with "y/n", and only these react to the mouse. */
	hits_clear_click_areas(&t->hits);
	hits_add_key_area(&t->hits,
	    area_of_columns_in_row(&area, n - 1, end < 4 ? 0 : end - 4, 2),
	    'y');
	hits_add_key_area(
	    &t->hits, area_of_columns_in_row(&area, n - 1, end - 1, 2), 'n');
}

static void
frame_draw_page(struct tui *t)
{
	const struct page_ops *page = pages_current(t);
	const struct area *caption = &t->layout.caption;
	if (caption->rows > 0 &&
	    (page->caption == NULL || !page->caption(t, caption)))
		track_draw_heading(t);
	if (page->strip)
		response_strip_draw(t);
	panel_draw_row_of_numbers(t);
	page->draw(t);
	draw_bottom_rows(t);
}

/* Moves the slider by the wheel, over the track, the strip and the plot. */
static void
on_wheel_move_slider(struct tui *t, const struct mouse_event *touched)
{
	tui_set_slider_position(t, tui_slider_position(t) - touched->by);
}

static void
on_wheel_scroll_text(struct tui *t, const struct mouse_event *touched)
{
	viewer_scroll(t, touched->by);
}

static int
side_panel_columns(const struct page_ops *page, int columns)
{
	enum { MIDDLE = 100, WIDE = 120 };
	if (columns >= WIDE)
		return page->wide_side;
	return columns >= MIDDLE && page->middle_side > 0 ? page->middle_side
							  : page->side;
}

/* Adds the areas where the wheel acts.  What is drawn later lies on top of
 * them. */
static void
add_wheel_areas(struct tui *t, bool viewing)
{
	const struct layout *l = &t->layout;
	struct hits *hits = &t->hits;
	const struct area over[] = {l->plot, l->legend, l->differences,
	    l->numbers, l->caption, l->strip, l->certainty, l->track};
	if (viewing)
		hits_add_mouse_handler(
		    hits, HIT_WHEEL, l->body, on_wheel_scroll_text, 0);
	for (size_t i = 0; !viewing && i < ARRAY_LEN(over); i++)
		hits_add_mouse_handler(
		    hits, HIT_WHEEL, over[i], on_wheel_move_slider, 0);
	if (!viewing && list_has_rows(t))
		list_add_wheel_area(t, l->body);
}

void
frame_draw(struct tui *t)
{
	int rows, columns;
	screen_set_theme(t->session->set.theme);
	screen_begin_frame(&rows, &columns);
	const struct page_ops *page = pages_current(t);
	bool viewing = t->viewer.text != NULL, list = t->picker.on && !viewing;
	int list_rows = page->list_rows != NULL ? page->list_rows(t) : 0;
	bool beside = list_rows == 0;
	bool site = tui_current_site_entry(t) != NULL;
	const struct layout_ask ask = {
	    beside && site ? side_panel_columns(page, columns) : 0,
	    beside && page->differences, site && page->strip, !site,
	    tui_slider_range(t).rotor > 0, list_rows};
	t->layout = viewing || list ? layout_make_for_text(rows, columns)
				    : layout_make(rows, columns, ask);
	hits_clear_click_areas(&t->hits);
	t->n_drawn = 0;
	add_wheel_areas(t, viewing);
	draw_screen_header(t);
	t->cursor = (struct cursor){
	    site ? t->layout.track.row : t->layout.command.row, 0};
	if (t->layout.track.rows > 0 && site)
		track_draw(t);
	if (viewing)
		viewer_draw(t);
	else if (list)
		file_picker_draw(t);
	else
		frame_draw_page(t);
	if (t->question != NULL && !viewing)
		draw_yes_no_question(t, rows, columns);
	if (t->inquiry != NULL)
		dialog_draw(t, rows, columns);
	screen_show_frame(t->cursor.row, t->cursor.column);
}

/* What stands around every page: heading, slider, last command, state, hints.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "ui/frame.h"

#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "base/xalloc.h"
#include "cmd/answers.h"
#include "cmd/fit.h"
#include "cmd/light.h"
#include "core/breakage.h"
#include "ui/dialogue.h"
#include "ui/page_predict.h"
#include "ui/pages.h"
#include "ui/screen.h"
#include "ui/view.h"

/* How a page is called in the heading: in full, by its number but for the one
 * that is open, or all by their numbers. */
static const char *
tab_text(const struct tui *t, size_t p, int columns, char text[static 24])
{
	bool here = p == t->page;
	const char *name =
	    columns >= 76 || (here && columns >= 34) ? PAGE_OPS[p]->name : "";
	const char *gap = name[0] != '\0' ? " " : "";
	const char *open = here ? "[" : columns >= 76 ? " " : "";
	snprintf(
	    text, 24, "%s%zu%s%s%s", open, p + 1, gap, name, here ? "]" : "");
	return text;
}

static void
draw_header(struct tui *t)
{
	const struct area *area = &t->places.header;
	const struct entry *entry = tui_entry(t);
	char text[24];
	int help = area->columns >= 76 ? 8 : 0, column = area->columns - help;
	for (size_t p = 0; p < PAGES; p++)
		column -= (int)strlen(tab_text(t, p, area->columns, text)) + 1;
	struct area left = *area;
	left.columns = column < 1 ? 0 : column - 1;
	char *label = entry != NULL       ? session_label(entry->site)
		      : left.columns < 18 ? xstrdup("no site")
					  : xstrdup("no site is loaded");
	bool room = text_width(label) + 11 <= left.columns,
	     fits = text_width(label) < left.columns || entry == NULL;
	screen_text(&left, 0, 0, LOOK_BOLD, "%s%s", room ? "tipspeed  " : "",
	    fits ? label : entry->site->name);
	free(label);
	column = column < 0 ? 0 : column;
	for (size_t p = 0; p < PAGES; p++) {
		int from = column;
		column = screen_text(area, 0, column,
		    p == t->page ? LOOK_REVERSE : LOOK_PLAIN, "%s",
		    tab_text(t, p, area->columns, text));
		t->tab[p] = (struct tab){from, column - from};
		column++;
	}
	if (help > 0)
		screen_text(area, 0, column, LOOK_DIM, " ? help");
}

enum { MOST_MARKS = 300 };

/* The speeds that were measured and those that the parameters were trained at,
 * also where that was on another site.  Returns how many. */
static size_t
take_marks(const struct entry *entry, struct slider_range range,
    struct slider_mark mark[static MOST_MARKS])
{
	const struct origin *o = entry->origin;
	bool trained = origin_trained(entry);
	size_t n = 0;
	for (size_t i = 0; trained && i < o->n_speed && n < MOST_MARKS; i++)
		mark[n++] = (struct slider_mark){
		    slider_tenths(range, o->speed[i]), true};
	for (size_t r = 0; r < entry->site->n_run && n < MOST_MARKS; r++) {
		double v = entry->site->run[r].speed;
		size_t i = 0;
		while (trained && i < o->n_speed && o->speed[i] != v)
			i++;
		if (entry->site->run[r].product.n > 0 &&
		    (!trained || i == o->n_speed))
			mark[n++] =
			    (struct slider_mark){slider_tenths(range, v),
				!trained && entry->train[r]};
	}
	return n;
}

static void
draw_track(struct tui *t)
{
	struct area track = places_track(&t->places);
	const struct entry *entry = tui_entry(t);
	struct slider_range range = tui_range(t);
	struct slider_mark mark[MOST_MARKS];
	size_t n = entry != NULL ? take_marks(entry, range, mark) : 0;
	char *text = xcalloc((size_t)track.columns + 1, 1);
	int at = slider_draw(text, track.columns, range, t->tenths, mark, n);
	bool focus = t->focus == NULL;
	const char *close = strchr(text + at, ']');
	int length = close != NULL ? (int)(close - text) - at + 1 : 1;
	screen_text(&track, 0, 0, 0, "%s", text);
	screen_text(&track, 0, at, focus ? LOOK_REVERSE : LOOK_BOLD, "%.*s",
	    length, text + at);
	if (track.column > 0) {
		screen_text(&t->places.track, 0, 0, 0, "%3d", range.least / 10);
		screen_text(&t->places.track, 0, t->places.track.columns - 3, 0,
		    "%d", range.most / 10);
	}
	free(text);
	t->cursor.column = track.column + at + (length > 1 ? 1 : 0);
}

/* Speed and energy, and what the signs of the track mean. */
static void
draw_caption(const struct tui *t)
{
	static const char *const SIGNS[] = {
	    "  | trained  o held out  step 0.1", "  | trained  o held out", ""};
	const struct area *area = &t->places.caption;
	double speed = t->tenths / 10.0;
	bool beyond = t->shown.product.n > 0 &&
		      answers_extrapolates(tui_entry(t), t->shown.speed);
	const char *word = beyond ? "x EXTRAPOLATED" : "x extrapolated";
	int room = area->columns - (beyond ? (int)strlen(word) + 1 : 0);
	int column = screen_text(area, 0, 0, 0, "%s%.1f%s",
	    room >= 36 ? "rotor tip speed " : "", speed,
	    room >= 8 ? " m/s" : "");
	if (column + 11 <= room)
		column = screen_text(
		    area, 0, column, 0, "  %.0f J/kg", energy_specific(speed));
	room = area->columns - (int)strlen(word);
	size_t i = 0;
	while (SIGNS[i][0] != '\0' && column + 2 + (int)strlen(SIGNS[i]) > room)
		i++;
	int from = room - (int)strlen(SIGNS[i]);
	if (SIGNS[i][0] != '\0' || beyond)
		from = screen_text(
		    area, 0, from, beyond ? LOOK_BOLD : LOOK_DIM, "%s", word);
	screen_text(area, 0, from, LOOK_DIM, "%s", SIGNS[i]);
}

/* Returns the column of the cursor in it. */
static int
draw_command(const struct tui *t, const struct area *area)
{
	const struct typing *y = &t->typing;
	if (y->active) {
		/* The line moves to the left where it is too long. */
		char *head = xstrndup(y->text, y->at);
		int before = text_width(head), room = area->columns - 2;
		free(head);
		const char *shown = y->text;
		char left[TEXT_SHOWN];
		while (before > room && *shown != '\0')
			before -= text_show(&shown, left);
		screen_text(area, 0, 0, LOOK_BOLD, ":%s", shown);
		return 1 + before;
	}
	const char *tail = "(last action, as a command)";
	int column = screen_text(
	    area, 0, 0, 0, ": %s", t->command != NULL ? t->command : "");
	if (t->command != NULL &&
	    column + 4 + (int)strlen(tail) < area->columns)
		screen_text(area, 0, area->columns - (int)strlen(tail) - 1,
		    LOOK_DIM, "%s", tail);
	return 0;
}

/* One too long for its row goes on in the row of hints, or begins in that of
 * the command where there are none.  Returns whether it takes the hints. */
static bool
draw_message(const struct tui *t, const struct area *row)
{
	struct area area = *row;
	char *text = xasprintf("%s%s", t->bad ? "! " : "", t->message);
	bool wide = text_width(text) > area.columns,
	     hints = wide && t->places.hints.rows > 0;
	if (wide)
		area.rows = places_message_rows(&t->places);
	if (area.rows == 2 && !hints)
		area.row--;
	for (int r = 0; r < area.rows; r++)
		screen_text(&area, r, 0, 0, "%*s", area.columns, "");
	screen_words(&area, 0, t->bad ? LOOK_BOLD : LOOK_PLAIN, text);
	free(text);
	return hints;
}

/* What the site's parameters are worth, or how the search stands. */
static void
draw_state(const struct tui *t, const struct area *area)
{
	const struct session *s = t->session;
	const struct entry *entry = tui_entry(t);
	int column;
	if (session_busy(s)) {
		struct calibrate_status st =
		    calibration_status(s->job.calibration);
		column = screen_text(area, 0, 0, LOOK_BOLD,
		    area->columns < 34 ? "%s %zu/%zu"
				       : "%s  generation %zu of %zu%s",
		    t->held ? "PAUSED" : "CALIBRATING", st.generation,
		    s->job.options.generations,
		    st.state == CALIBRATE_POLISHING ? ", polishing" : "");
	} else if (entry == NULL) {
		column = screen_text(
		    area, 0, 0, 0, "READY  no site: type :load FILE");
	} else if (!entry->has_params) {
		column = screen_text(area, 0, 0, 0, "READY  %s",
		    site_products(entry->site) > 0
			? "not calibrated: f calibrates"
			: "no product: type :guess");
	} else if (entry->has_fit) {
		column = screen_text(area, 0, 0, 0, "READY  %s%s",
		    fit_too_few(&entry->fit) ? "" : "fit ",
		    light_verdict(s, entry, NULL));
	} else {
		column = screen_text(
		    area, 0, 0, 0, "READY  parameters %s", origin_words(entry));
	}
	char right[64];
	snprintf(right, sizeof right, "mouse %s  %s  %d colours",
	    t->mouse ? "on" : "off",
	    screen_charset() == CHARSET_ASCII ? "ascii" : "utf8",
	    screen_depth());
	int from = area->columns - (int)strlen(right) - 1;
	if (from > column + 2)
		screen_text(area, 0, from, LOOK_DIM, "%s", right);
}

/* What a word may become; ".." where there is more. */
static void
draw_offers(const struct area *area, const char *offers)
{
	bool more = text_width(offers) > area->columns;
	char *text = xstrdup(offers);
	pane_cut(text, area->columns - (more ? 4 : 0));
	screen_text(area, 0, 0, 0, "%s%s", text, more ? "  .." : "");
	free(text);
}

static void
draw_hints(const struct tui *t)
{
	const struct page_ops *page = pages_open(t);
	pane_hints(&t->places.hints, LOOK_DIM,
	    page->hints != NULL ? page->hints : page->hints_now(t));
}

/* A speed being typed stands where messages do. */
static void
draw_lower(struct tui *t)
{
	bool wide = false;
	struct places *l = &t->places;
	const struct area *note = l->status.rows > 0    ? &l->status
				  : l->command.rows > 0 ? &l->command
							: &l->track;
	const struct area *line = l->command.rows > 0 ? &l->command : &l->track;
	bool typing = t->typing.active;
	bool taken = line == note && (t->message[0] || t->speed.text[0] ||
					 session_busy(t->session));
	if (typing || (l->command.rows > 0 && !taken)) {
		if (typing && line == &l->track)
			screen_text(line, 0, 0, 0, "%*s", line->columns, "");
		int at = draw_command(t, line);
		if (typing)
			t->cursor = (struct cursor){line->row, at};
	}
	if (note == line && typing)
		return;
	if (t->speed.text[0] != '\0') {
		bool narrow = note->columns < 24;
		int at = screen_text(note, 0, 0, LOOK_BOLD,
		    narrow ? "%s" : "speed: %s", t->speed.text);
		screen_text(note, 0, at, LOOK_BOLD,
		    narrow ? "_ m/s, Enter" : "_ m/s (Enter)");
		t->cursor = (struct cursor){note->row, at};
	} else if (typing && t->typing.offers != NULL)
		draw_offers(note, t->typing.offers);
	else if (t->message[0] != '\0' && note != &l->track)
		wide = draw_message(t, note);
	else if (note == &l->status || session_busy(t->session))
		draw_state(t, note);
	if (!wide)
		draw_hints(t);
}

/* Over the last rows of whatever the screen shows, at any size. */
static void
draw_question(struct tui *t, int rows, int columns)
{
	char *asks = xasprintf("%s y/n", t->question),
	     *text = text_wrapped(asks, columns);
	int n = 0;
	for (const char *p = text; *p != '\0'; p++)
		n += *p == '\n';
	struct area area = {rows - n, 0, n, columns};
	for (int r = 0; r < n; r++)
		screen_text(&area, r, 0, 0, "%*s", columns, "");
	screen_words(&area, 0, LOOK_BOLD, asks);
	text[strlen(text) - 1] = '\0';
	const char *last = strrchr(text, '\n');
	t->cursor = (struct cursor){
	    rows - 1, text_width(last != NULL ? last + 1 : text)};
	free(text);
	free(asks);
}

static void
draw_page(struct tui *t)
{
	const struct page_ops *page = pages_open(t);
	const struct area *caption = &t->places.caption;
	if (caption->rows > 0 &&
	    (page->caption == NULL || !page->caption(t, caption)))
		draw_caption(t);
	page_predict_numbers(t);
	page->draw(t);
	draw_lower(t);
}

void
frame_draw(struct tui *t)
{
	int rows, columns;
	screen_begin(&rows, &columns);
	const struct page_ops *page = pages_open(t);
	bool viewing = t->viewer.text != NULL;
	t->places = viewing
			? places_text(rows, columns)
			: places_make(rows, columns,
			      columns >= 120 ? page->wide_side : page->side);
	t->scrubber = (struct area){0};
	draw_header(t);
	t->cursor = (struct cursor){t->places.track.row, 0};
	screen_rule(&t->places.rule);
	if (t->places.track.rows > 0)
		draw_track(t);
	if (viewing)
		view_draw(t);
	else
		draw_page(t);
	if (t->question != NULL && !viewing)
		draw_question(t, rows, columns);
	if (t->inquiry != NULL)
		dialogue_draw(t, rows, columns);
	screen_show(t->cursor.row, t->cursor.column);
}

/* From keys of the table to what they do.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "ui/act.h"

#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <curses.h>

#include "base/text.h"
#include "base/xalloc.h"
#include "cmd/answers.h"
#include "cmd/outlook.h"
#include "cmd/fit.h"
#include "ui/control.h"
#include "ui/page_predict.h"
#include "ui/pages.h"
#include "ui/screen.h"
#include "ui/view.h"

enum { ESCAPE = 27, DELETE = 127 };

/* Of a run its feed is taken, too: the curves then meet what was measured. */
static void
to_run(struct tui *t, struct slider_range range, const struct site *site,
    int where)
{
	double speed = where == TO_SLOWEST   ? site->run[0].speed
		       : where == TO_FASTEST ? site->run[site->n_run - 1].speed
					     : answers_middle(site);
	t->tenths = slider_tenths(range, speed);
	t->feed = site->run[site_run_nearest(site, speed)].speed;
}

static void
move_to(struct tui *t, int where)
{
	const struct slider_range range = tui_range(t);
	const struct entry *entry = tui_entry(t);
	if (where == TO_LEAST)
		t->tenths = range.least;
	else if (where == TO_MOST)
		t->tenths = range.most;
	else if (entry != NULL)
		to_run(t, range, entry->site, where);
}

/* Between the slider and what the page has. */
static void
next_focus(struct tui *t)
{
	const struct page_ops *page = pages_open(t);
	bool can = page->takes_focus ||
		   (page->can_focus != NULL && page->can_focus(t));
	t->focus = can && t->focus == NULL ? page : NULL;
}

/* Puts a name for the file after `>`: "tierp-74.0.csv"; of the plot of two
 * predictions an image. */
static void
propose_file(const struct tui *t, char **line)
{
	if (tui_entry(t) == NULL)
		return;
	char *name = text_slug(tui_entry(t)->key);
	xappend(line, "%s-%.1f.%s", name, t->tenths / 10.0,
	    t->pin.site[0] != '\0' ? "svg" : "csv");
	free(name);
}

/* The command of a key that has one, with the speed or the picture in it.  The
 * caller frees. */
static char *
compose(const struct tui *t, const struct key *key)
{
	const char *hole = strstr(key->command, "%s");
	if (hole == NULL)
		return xstrdup(key->command);
	char *(*words)(const struct tui *) = pages_open(t)->words;
	words = words != NULL ? words : pane_curves_words;
	char *where = key->act == ACT_TELL ? words(t) : tui_where(t);
	char *line;
	if (key->act == ACT_EXPORT && t->pin.site[0] != '\0')
		line = xasprintf("plot psd %s beside=%s other=%.1f > ", where,
		    t->pin.site, t->pin.speed);
	else
		line = xasprintf("%.*s%s%s", (int)(hole - key->command),
		    key->command, where, hole + 2);
	free(where);
	if (key->act == ACT_EXPORT)
		propose_file(t, &line);
	return line;
}

static void
run_key(struct tui *t, const struct key *key)
{
	char *line = compose(t, key);
	if (key->act == ACT_TYPE || key->act == ACT_EXPORT) {
		t->message[0] = '\0';
		typing_begin(&t->typing, line);
	} else if (key->act == ACT_RUN || key->act == ACT_TELL) {
		control_typed(t, line);
	} else {
		control_keep(t);
		control_run(t, line);
	}
	free(line);
}

/* Goes on to the next choice. */
static void
correct(struct tui *t)
{
	static const char *const NEXT[] = {[CORRECTION_ALL] = "train",
	    [CORRECTION_TRAIN] = "off",
	    [CORRECTION_OFF] = "all"};
	char *line =
	    xasprintf("set correction %s", NEXT[t->session->set.correction]);
	control_typed(t, line);
	free(line);
}

static void
fit(struct tui *t, const struct key *key)
{
	pages_go(t, PAGE_FIT);
	run_key(t, key);
}

/* Pauses, goes on, or takes a stopped one up again. */
static void
hold(struct tui *t, const struct key *key)
{
	const struct session *s = t->session;
	if (session_busy(s)) {
		t->ran = tui_searched(t);
		t->held = !t->held;
		t->due = t->started = t->clock;
		tui_say(t, false,
		    t->held ? "paused: Space continues" : "continuing");
	} else if (s->job.calibration != NULL) {
		run_key(t, key);
	} else {
		tui_say(t, false, "no calibration is running: f starts one");
	}
}

static void
set_pace(struct tui *t, int by)
{
	t->pace = pane_moved(t->pace, by, PACE_COUNT);
	t->due = t->clock;
	if (t->pace == PACE_FULL)
		tui_say(t, false, "generations a second: as many as possible");
	else
		tui_say(t, false, "speed of display: %g generation%s a second",
		    PACES[t->pace], PACES[t->pace] > 1 ? "s" : "");
}

/* The prediction itself is kept, so that it stays what it was when the site is
 * calibrated again. */
static void
pin(struct tui *t)
{
	bool kept = t->pin.site[0] != '\0';
	const struct prediction *last = &t->shown;
	prediction_free(&t->kept);
	memset(&t->kept, 0, sizeof t->kept);
	memset(&t->pin, 0, sizeof t->pin);
	if (kept) {
		tui_say(t, false, "unpinned");
	} else if (t->now.site[0] == '\0') {
		tui_say(t, true, "no prediction yet: f calibrates");
	} else {
		t->pin = t->now;
		t->kept = prediction_copy(last);
		tui_say(t, false,
		    "pinned %s at %.1f m/s: go to another speed or site; e "
		    "exports both",
		    t->pin.site, t->pin.speed);
	}
}

static void
band(struct tui *t)
{
	const struct entry *entry = tui_entry(t);
	t->band = !t->band;
	if (!t->band || t->now.site[0] == '\0')
		return;
	bool known = t->shown.low != NULL;
	tui_say(t, false, "%s%s",
	    known ? "" : outlook_why_none(t->session, entry),
	    !known && entry->has_fit && fit_too_few(&entry->fit) ? ""
	    : !known                ? "; f calibrates"
	    : screen_depth() >= 256 ? "band on: 80 % uncertainty"
				    : "band on: 80 % uncertainty; not visible "
				      "where thinner than half a row");
}

static void
stop(struct tui *t)
{
	if (session_busy(t->session))
		control_keep(t);
	else
		tui_say(t, false, "no calibration to stop: q quits");
}

static void
toggle_mouse(struct tui *t)
{
	bool on = !t->mouse && screen_mouse(true);
	if (t->mouse)
		screen_mouse(false);
	tui_say(t, false,
	    on         ? "mouse on: Shift and drag selects text"
	    : t->mouse ? "mouse off: drag selects text, M turns it on"
		       : "this terminal has no mouse");
	t->mouse = screen_mouse_on();
}

/* What changes how the screen looks and no more. */
static void
show_act(struct tui *t, const struct key *key)
{
	switch (key->act) {
	case ACT_PAGE:
		pages_go(t, (enum page)key->amount);
		break;
	case ACT_FOCUS:
		next_focus(t);
		break;
	case ACT_CROSS:
		page_predict_cross(t);
		break;
	case ACT_BAND:
		band(t);
		break;
	case ACT_PIN:
		pin(t);
		break;
	case ACT_HELP:
		view_keys(t);
		break;
	case ACT_MOUSE:
		toggle_mouse(t);
		break;
	case ACT_REDRAW:
		screen_resize();
		break;
	case ACT_SUSPEND:
		raise(SIGTSTP); /* the loop answers it */
		break;
	case ACT_LEAVE:
		t->leave = true;
		break;
	default: /* none on this page */
		break;
	}
}

/* Does what a key is for; nothing for NULL. */
static void
act(struct tui *t, const struct key *key)
{
	if (key == NULL)
		return;
	/* From the list of keys one of another page may be chosen. */
	enum page page = t->page;
	while (!(key->pages & (1U << page)))
		page = (page + 1) % PAGES;
	bool (*own)(struct tui *, const struct key *) = PAGE_OPS[page]->key;
	if (own != NULL && own(t, key))
		return;
	switch (key->act) {
	case ACT_MOVE:
	case ACT_FINE:
		t->tenths = slider_clamp(tui_range(t), t->tenths + key->amount);
		break;
	case ACT_TO:
		move_to(t, key->amount);
		break;
	case ACT_RUN:
	case ACT_TELL:
	case ACT_TYPE:
	case ACT_EXPORT:
		run_key(t, key);
		break;
	case ACT_CORRECT:
		correct(t);
		break;
	case ACT_FIT:
		fit(t, key);
		break;
	case ACT_HOLD:
		hold(t, key);
		break;
	case ACT_KEEP:
	case ACT_STOP:
		stop(t);
		break;
	case ACT_PACE:
		set_pace(t, key->amount);
		break;
	default:
		show_act(t, key);
	}
}

static void
type_key(struct tui *t, int code, bool special)
{
	struct typing *y = &t->typing;
	enum typing_result result = typing_key(y, t->session, code, special);
	if (result == TYPING_ON)
		return;
	typing_end(y);
	if (result == TYPING_DONE)
		control_typed(t, y->text);
}

/* Digits of a speed; the first are pages, but after a 0. */
static bool
digit_key(struct tui *t, int code, bool special)
{
	struct typing *y = &t->speed;
	bool digit = code >= '0' && code <= '9',
	     back = code == DELETE || code == '\b';
	if (y->n == 0 && !(digit && (code == '0' || code > '0' + PAGES)))
		return false;
	if (back || ((digit || code == '.') && y->n < SPEED_LETTERS))
		return typing_letter(y, code, special, SPEED_LETTERS);
	if (code == '\n' || code == '\r') {
		struct slider_range range = tui_range(t);
		if (!slider_read(range, y->text, &t->tenths))
			tui_say(t, true,
			    "expected a speed from %d to %d m/s, got %s",
			    range.least / 10, range.most / 10, y->text);
	}
	typing_begin(y, "");
	return code == '\n' || code == '\r' || code == ESCAPE;
}

/* What was pressed follows the mouse. */
static bool
follow(struct tui *t, int row, int column, bool pressed)
{
	const struct page_ops *page = pages_open(t);
	struct area track = places_track(&t->places);
	if (page->mouse != NULL && page->mouse(t, row, column, pressed))
		return true;
	if (pressed && !area_has(&t->places.track, row, column))
		return false;
	if (pressed)
		t->focus = NULL;
	t->tenths =
	    slider_at(tui_range(t), column - track.column, track.columns);
	return true;
}

static void
press(struct tui *t, const MEVENT *e)
{
	for (size_t p = 0; p < PAGES; p++) {
		const struct tab *tab = &t->tab[p];
		if (e->y != t->places.header.row ||
		    t->places.header.rows == 0 || e->x < tab->column ||
		    e->x >= tab->column + tab->columns)
			continue;
		typing_begin(&t->speed, "");
		act_key(t, '1' + (int)p, false);
	}
	if (follow(t, e->y, e->x, true))
		t->dragging = true;
}

static void
act_mouse(struct tui *t)
{
	MEVENT e;
	if (getmouse(&e) != OK || t->typing.active)
		return;
	if (t->viewer.text != NULL) {
		if (e.bstate & (BUTTON4_PRESSED | BUTTON5_PRESSED))
			act_key(t,
			    e.bstate & BUTTON4_PRESSED ? KEY_UP : KEY_DOWN,
			    true);
		return;
	}
	if (e.bstate & BUTTON4_PRESSED)
		t->tenths = slider_clamp(tui_range(t), t->tenths + 1);
	else if (e.bstate & BUTTON5_PRESSED)
		t->tenths = slider_clamp(tui_range(t), t->tenths - 1);
	else if (e.bstate & (BUTTON1_PRESSED | BUTTON1_CLICKED))
		press(t, &e);
	else if (t->dragging && (e.bstate & REPORT_MOUSE_POSITION))
		follow(t, e.y, e.x, false);
	if (e.bstate & (BUTTON1_RELEASED | BUTTON1_CLICKED))
		t->dragging = false;
}

void
act_key(struct tui *t, int code, bool special)
{
	if (special && (code == KEY_ENTER || code == KEY_BACKSPACE)) {
		code = code == KEY_ENTER ? '\n' : DELETE;
		special = false;
	}
	/* A character beyond ASCII is no key: its number may be one's. */
	if (!special && code > DELETE && !t->typing.active)
		return;
	const struct key *key = keys_find(code, t->page);
	if (special && code == KEY_MOUSE) {
		act_mouse(t);
	} else if (key != NULL &&
		   (key->act == ACT_SUSPEND || key->act == ACT_REDRAW)) {
		act(t, key);
	} else if (t->typing.active) {
		type_key(t, code, special);
	} else if (t->viewer.text != NULL) {
		act(t, view_key(t, code, special));
	} else if (!digit_key(t, code, special)) {
		act(t, key);
		if (key == NULL && code > ' ' && code < DELETE)
			tui_say(t, false,
			    "this key has no function: ? lists the keys");
	}
}

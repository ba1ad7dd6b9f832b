/* From keys of the table to what they do.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "tui/keymap.h"

#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <curses.h>

#include "base/text.h"
#include "base/tr.h"
#include "base/xalloc.h"
#include "cmd/ask/answers.h"
#include "cmd/session/files.h"
#include "cmd/ask/outlook.h"
#include "cmd/ask/fit.h"
#include "tui/widgets/response_strip.h"
#include "tui/widgets/file_picker.h"
#include "tui/control.h"
#include "tui/widgets/goal.h"
#include "tui/pages/page_predict.h"
#include "tui/pages.h"
#include "tui/widgets/list.h"
#include "tui/screen.h"
#include "tui/widgets/track.h"
#include "tui/cmdline.h"
#include "tui/widgets/view.h"
#include "tui/watch.h"

enum { ESCAPE = 27, DELETE = 127 };

static void
to_run(struct tui *t, struct slider_range range, const struct site *site,
    int where)
{
	double speed = where == TO_SLOWEST   ? site->run[0].speed
		       : where == TO_FASTEST ? site->run[site->n_run - 1].speed
					     : site_middle(site);
	t->tenths = slider_tenths(range, speed);
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
	bool can = pages_can_focus(t) && t->focus == NULL;
	t->focus = can ? pages_open(t) : NULL;
	/* What was said of the arrows holds no longer. */
	tui_say(t, false, "%s", "");
}

/* A name for the file: "tierp-74.0.xlsx", which a spreadsheet opens whatever
 * its decimal sign; for a session the script that holds it, or the first name
 * that is free.  The caller frees. */
static char *
propose_file(const struct tui *t, const struct key *key)
{
	bool saved;
	const char *holder = files_holder(t->session, &saved);
	if (key->act == ACT_SAVE && holder != NULL)
		return xasprintf(
		    "\"%s\"%s", holder, saved ? "" : " replace=on");
	char *slug =
	    text_slug(tui_entry(t) != NULL ? tui_entry(t)->key : "session");
	char *name = key->act == ACT_SAVE
			 ? xasprintf("%s.tip", slug)
			 : xasprintf("%s-%.1f.xlsx", slug, t->tenths / 10.0);
	for (int i = 2; key->act == ACT_SAVE && access(name, F_OK) == 0; i++) {
		free(name);
		name = xasprintf("%s-%d.tip", slug, i);
	}
	free(slug);
	return name;
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
	char *line = key->act == ACT_EXPORT
			 ? tui_asks(t)
			 : xasprintf("%.*s%s%s", (int)(hole - key->command),
			       key->command, where, hole + 2);
	free(where);
	if (key->act == ACT_EXPORT)
		xappend(&line, " > ");
	return line;
}

static void
run_key(struct tui *t, const struct key *key)
{
	char *line = compose(t, key);
	if (key->act == ACT_TYPE) {
		t->message[0] = '\0';
		typing_begin(&t->typing, line);
	} else if (key->act == ACT_EXPORT || key->act == ACT_SAVE) {
		char *name = propose_file(t, key);
		t->message[0] = '\0';
		typing_propose(&t->typing, line, name);
		free(name);
	} else if (key->act == ACT_RUN || key->act == ACT_TELL) {
		typed_line_run(t, line);
	} else {
		watch_keep(t);
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
	typed_line_run(t, line);
	free(line);
}

static void
fit(struct tui *t, const struct key *key)
{
	if (tui_entry(t) == NULL) {
		tui_say(t, true, TUI_NO_SITE);
		return;
	}
	pages_go(t, PAGE_FIT);
	run_key(t, key);
}

static void
export_shown(struct tui *t, const struct key *key)
{
	const struct entry *entry = tui_entry(t);
	if (entry == NULL || !entry->has_params)
		tui_say(t, true, "%s", tui_why_none(t));
	else
		run_key(t, key);
}

/* Pauses, goes on, or takes a stopped one up again. */
static void
hold(struct tui *t, const struct key *key)
{
	const struct session *s = t->session;
	if (session_busy(s)) {
		watch_hold(t, !t->held);
		tui_say(t, false,
		    t->held ? N_("paused: Space continues") : N_("continuing"));
	} else if (s->job.calibration != NULL) {
		run_key(t, key);
	} else {
		tui_say(t, false, "no calibration is running: f starts one");
	}
}

static void
set_pace(struct tui *t, int by)
{
	int from = t->pace == PACE_AUTO ? PACE_USUAL : t->pace;
	t->pace = pane_moved(from, by, PACE_COUNT);
	t->due = t->clock;
	if (t->pace == PACE_AUTO)
		tui_say(t, false,
		    "generations a second: few while the best gains much");
	else if (t->pace == PACE_FULL)
		tui_say(t, false, "generations a second: as many as possible");
	else
		tui_say(t, false,
		    tr_n("speed of display: %g generation a second",
			"speed of display: %g generations a second",
			PACES[t->pace] > 1 ? 2 : 1),
		    PACES[t->pace]);
}

static void
pin(struct tui *t)
{
	const struct numbers was = t->pin;
	char *where = tui_where(t), *line = xasprintf("pin %s", where);
	if (was.site[0] == '\0' && t->now.site[0] == '\0')
		tui_say(t, true, "%s", tui_why_none(t));
	else if (!control_run(t, was.site[0] != '\0' ? "pin off" : line))
		; /* it has said why */
	else if (was.site[0] != '\0')
		tui_say(t, false,
		    "unpinned %s at %.1f m/s: u pins it again, x what is "
		    "shown now",
		    was.site, was.speed);
	else
		tui_say(t, false,
		    session_busy(t->session)
			? N_("pinned %s at %.1f m/s: go to another speed or "
			     "site; e exports both; of a search that runs, it "
			     "is not saved")
			: N_("pinned %s at %.1f m/s: go to another speed or "
			     "site; e exports both"),
		    t->pin.site, t->pin.speed);
	free(where);
	free(line);
}

static void
band(struct tui *t)
{
	const struct entry *entry = tui_entry(t);
	t->band = !t->band;
	t->message[0] = '\0';
	if (!t->band || t->now.site[0] == '\0')
		return;
	bool known = t->shown.low != NULL;
	tui_say(t, false,
	    known || (entry->has_fit && fit_too_few(&entry->fit))
		? "%s%s"
		: N_("%s%s; f calibrates"),
	    known ? "" : outlook_why_none(t->session, entry),
	    !known ? ""
	    : screen_charset() != CHARSET_ASCII
		? tr("band on: 80 % uncertainty")
		: tr("band on: 80 % uncertainty; not visible where thinner "
		     "than "
		     "a row"));
}

static void
stop(struct tui *t)
{
	if (session_busy(t->session))
		watch_keep(t);
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
	    on         ? N_("mouse on: Shift and drag selects text")
	    : t->mouse ? N_("mouse off: drag selects text, M turns it on")
		       : N_("this terminal has no mouse"));
	t->mouse = screen_mouse_on();
}

/* What is wanted, and to where it is so. */
static void
aim(struct tui *t, const struct key *key)
{
	switch (key->act) {
	case ACT_QUANTITY:
		above_next(t, key->amount);
		break;
	case ACT_GOAL:
		goal_open(t);
		break;
	case ACT_LIMIT:
	case ACT_BEST:
		track_go(t, key);
		break;
	default: /* none on this page */
		break;
	}
}

/* Where Esc leads. */
static void
back(struct tui *t)
{
	bool predict = t->page == PAGE_PREDICT;
	t->message[0] = '\0';
	if (t->wish != NULL) {
		t->wish = NULL;
		return;
	}
	if (rows_forget(t))
		return;
	if (session_busy(t->session) && !t->session->job.fits)
		watch_keep(t);
	else if (predict && t->cross)
		page_predict_cross(t);
	else if (predict && t->runs)
		t->runs = false;
	else if (t->focus != NULL && !pages_open(t)->takes_focus)
		t->focus = NULL;
	else if (!predict)
		pages_go(t, PAGE_PREDICT);
	else
		tui_say(t, false, "nothing is left to go back from: q quits");
}

/* Keys of lists, on a page without one. */
static void
nothing_here(struct tui *t, const struct key *key)
{
	tui_say(t, false,
	    key->act == ACT_CHOOSE ? N_("there is nothing to open on this page")
				   : N_("this page has no list to look "
					"through: Sites, ? and texts "
					"have"));
}

static void
leave_act(struct tui *t, const struct key *key)
{
	switch (key->act) {
	case ACT_KEEP:
	case ACT_STOP:
		stop(t);
		break;
	case ACT_SUSPEND:
		raise(SIGTSTP); /* the loop answers it */
		break;
	case ACT_LEAVE:
		t->leave = true;
		break;
	default:
		aim(t, key);
		break;
	}
}

/* What changes how the screen looks and no more. */
static void
show_act(struct tui *t, const struct key *key)
{
	switch (key->act) {
	case ACT_PAGE:
		pages_go(t, (enum page)key->amount);
		break;
	case ACT_BACK:
		back(t);
		break;
	case ACT_CHOOSE:
	case ACT_FILTER:
		nothing_here(t, key);
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
	case ACT_FILES:
		chooser_open(t, CHOOSER_FILES);
		break;
	case ACT_AGAIN:
		view_again(t);
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
	default:
		leave_act(t, key);
		break;
	}
}

/* Whether a key is about the speed of the slider: first that is to be the one
 * which was asked for. */
static bool
is_about_speed(enum key_act act)
{
	return act == ACT_PIN || act == ACT_EXPORT || act == ACT_TELL ||
	       act == ACT_TYPE || act == ACT_SAVE || act == ACT_LIMIT ||
	       act == ACT_BEST;
}

/* Does what a key is for; nothing for NULL. */
static void
act(struct tui *t, const struct key *key)
{
	if (key == NULL)
		return;
	/* From the list of keys one of another page may be chosen. */
	enum page page = t->page;
	if (is_about_speed(key->act))
		track_wished(t, true);
	while (!(key->pages & (1U << page)))
		page = (page + 1) % PAGES;
	bool (*own)(struct tui *, const struct key *) = PAGE_OPS[page]->key;
	if ((own != NULL && own(t, key)) || rows_key(t, key))
		return;
	switch (key->act) {
	case ACT_MOVE:
	case ACT_FINE:
		t->wish = NULL;
		t->tenths = slider_clamp(tui_range(t), t->tenths + key->amount);
		break;
	case ACT_TO:
		t->wish = NULL;
		move_to(t, key->amount);
		break;
	case ACT_RUN:
	case ACT_TELL:
	case ACT_TYPE:
	case ACT_SAVE:
		run_key(t, key);
		break;
	case ACT_EXPORT:
		export_shown(t, key);
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
	if (t->goal_field) {
		char *line = goal_key(t, code, special);
		if (line != NULL)
			control_run(t, line);
		free(line);
		return;
	}
	enum typing_result result = typing_key(y, t->session, code, special);
	if (result == TYPING_ON)
		return;
	typing_end(y);
	if (result == TYPING_DONE)
		typed_line_run(t, y->text);
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
	if (code == ',')
		code = '.';
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

/* Over a line that is typed only what belongs to it was said to be touched; a
 * speed that was begun ends where another thing is, but for its own keys. */
static void
touch(struct tui *t, enum touch_kind kind, int row, int column)
{
	const struct touch *at = touch_at(&t->touches, row, column);
	bool own = at != NULL && (at->code == '\n' || at->code == ESCAPE);
	if (kind == TOUCH_PRESS && !own)
		typing_begin(&t->speed, "");
	touch_mouse(t, &t->touches, kind, row, column, act_key);
}

/* What an event of ncurses means. */
static void
act_mouse(struct tui *t,
    void (*touched)(struct tui *t, enum touch_kind kind, int row, int column))
{
	MEVENT e;
	if (getmouse(&e) != OK)
		return;
	if (e.bstate & (BUTTON1_PRESSED | BUTTON1_CLICKED))
		touched(t, TOUCH_PRESS, e.y, e.x);
	else if (e.bstate & (BUTTON4_PRESSED | BUTTON5_PRESSED))
		touched(t, e.bstate & BUTTON4_PRESSED ? TOUCH_UP : TOUCH_DOWN,
		    e.y, e.x);
	else if (e.bstate & REPORT_MOUSE_POSITION)
		touched(t, TOUCH_DRAG, e.y, e.x);
	if (e.bstate & (BUTTON1_RELEASED | BUTTON1_CLICKED))
		touch_release(&t->touches);
}

static void
note_key(struct tui *t, int code, bool special)
{
	t->pointed.is = true;
	t->pointed.code = code;
	t->pointed.special = special;
}

static void
touch_answer(struct tui *t, enum touch_kind kind, int row, int column)
{
	touch_mouse(t, &t->touches, kind, row, column, note_key);
}

bool
act_pointed(struct tui *t, int *code, bool *special)
{
	t->pointed.is = false;
	act_mouse(t, touch_answer);
	*code = t->pointed.code;
	*special = t->pointed.special;
	return t->pointed.is;
}

/* A key of the page, also after it has closed a text. */
static void
page_key(struct tui *t, int code, bool special)
{
	const struct key *key = keys_find(code, t->page);
	if (t->chooser.on && chooser_key(t, code, special))
		return;
	if (rows_letter(t, code, special) ||
	    digit_key(t, code, special))
		return;
	act(t, key);
	if (key == NULL && code > ' ' && code < DELETE)
		tui_say(t, false, "this key has no function: ? lists the keys");
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
	const struct key *key = keys_find(code, t->page), *run = NULL;
	if (special && code == KEY_MOUSE) {
		act_mouse(t, touch);
	} else if (key != NULL &&
		   (key->act == ACT_SUSPEND || key->act == ACT_REDRAW)) {
		act(t, key);
	} else if (t->typing.active) {
		type_key(t, code, special);
	} else if (t->viewer.text == NULL ||
		   !view_key(t, code, special, &run)) {
		page_key(t, code, special);
	} else {
		act(t, run);
	}
}

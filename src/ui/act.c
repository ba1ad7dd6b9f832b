/* From keys of the table to what they do.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "ui/act.h"

#include <limits.h>
#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/xalloc.h"
#include "cmd/answers.h"
#include "cmd/doubt.h"
#include "cmd/fit.h"
#include "ui/compose.h"
#include "ui/conduct.h"
#include "ui/pane.h"
#include "ui/screen.h"
#include "ui/view.h"

enum { ESCAPE = 27, DELETE = 127 };

/* A list moves up and down, whatever the focus is. */
static int
moved(int at, int by, size_t n)
{
	int to = at + by;
	return n == 0 || to < 0 ? 0 : to >= (int)n ? (int)n - 1 : to;
}

static void
move_generation(struct tui *t, int by)
{
	int at = (int)tui_generation(t) - 1;
	tui_look_at(t, (size_t)moved(at, by, tui_past(t).n) + 1);
}

/* Up is a higher passing. */
static void
move_level(struct tui *t, int by)
{
	enum { STEP = 5, LEAST = 5, MOST = 95 };
	int to = t->level - by * STEP;
	t->level = to < LEAST ? LEAST : to > MOST ? MOST : to;
}

static void
move_focus(struct tui *t, int by)
{
	switch (t->focus) {
	case FOCUS_SPEED:
		t->tenths = slider_clamp(tui_range(t), t->tenths + by);
		break;
	case FOCUS_CROSS:
		/* Sieves stand coarsest first, the plot finest first. */
		t->cross_at =
		    (size_t)moved((int)t->cross_at, -by, t->shown.product.n);
		break;
	case FOCUS_GENERATION:
		move_generation(t, by);
		break;
	case FOCUS_SITE:
		t->site_at =
		    (size_t)moved((int)t->site_at, by, t->session->n_entry);
		break;
	}
}

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
	if (t->focus == FOCUS_GENERATION && where <= TO_MOST)
		tui_look_at(t, where == TO_LEAST ? 1 : tui_past(t).n);
	else if (where == TO_LEAST)
		t->tenths = range.least;
	else if (where == TO_MOST)
		t->tenths = range.most;
	else if (entry != NULL)
		to_run(t, range, entry->site, where);
}

/* Whether the arrows can move it here. */
static bool
can_focus(const struct tui *t, enum focus focus)
{
	switch (focus) {
	case FOCUS_CROSS:
		return t->cross && t->page == PAGE_PREDICT;
	case FOCUS_GENERATION:
		return t->page == PAGE_FIT && tui_past(t).n > 0;
	case FOCUS_SITE:
		return t->page == PAGE_SITES;
	default:
		return true;
	}
}

/* Many arrows at once: of the generations where these are gone through, else of
 * the slider. */
static void
move_far(struct tui *t, int by)
{
	if (t->focus == FOCUS_GENERATION)
		move_generation(t, by);
	else
		t->tenths = slider_clamp(tui_range(t), t->tenths + by);
}

static void
next_focus(struct tui *t, int by)
{
	enum { COUNT = FOCUS_SITE + 1 };
	int focus = (int)t->focus;
	do
		focus = (focus + by + COUNT) % COUNT;
	while (!can_focus(t, (enum focus)focus));
	t->focus = (enum focus)focus;
}

static void
go_to(struct tui *t, enum page page)
{
	t->page = page;
	if (page == PAGE_SITES)
		t->focus = FOCUS_SITE;
	else if (!can_focus(t, t->focus) || t->focus == FOCUS_SITE)
		t->focus = FOCUS_SPEED;
}

static void
run_key(struct tui *t, const struct key *key)
{
	char *line = compose_line(t, key);
	if (key->act == ACT_TYPE || key->act == ACT_EXPORT) {
		t->message[0] = '\0';
		typing_begin(&t->typing, line);
	} else if (key->act == ACT_RUN || key->act == ACT_TELL) {
		conduct_typed(t, line);
	} else {
		conduct_keep(t);
		conduct_run(t, line);
	}
	free(line);
}

static void
fit(struct tui *t, const struct key *key)
{
	go_to(t, PAGE_FIT);
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
		tui_say(
		    t, false, t->held ? "paused: Space goes on" : "going on");
	} else if (s->job.calibration != NULL) {
		run_key(t, key);
	} else {
		tui_say(t, false, "no calibration is under way: f starts one");
	}
}

static void
set_pace(struct tui *t, int by)
{
	t->pace = moved(t->pace, by, PACE_COUNT);
	t->due = t->clock;
	if (t->pace == PACE_FULL)
		tui_say(t, false, "pace: as fast as it can");
	else
		tui_say(t, false, "pace: %g generation%s a second",
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
		tui_say(t, false, "no longer kept");
	} else if (t->now.site[0] == '\0') {
		tui_say(t, true, "nothing is predicted yet: f calibrates");
	} else {
		t->pin = t->now;
		t->kept = *last;
		t->kept.feed = psd_copy(&last->feed);
		t->kept.product = psd_copy(&last->product);
		tui_say(t, false,
		    "%s at %.1f m/s is kept beside: go to another speed or "
		    "site; e exports both",
		    t->pin.site, t->pin.speed);
	}
}

static void
cross(struct tui *t)
{
	t->cross = !t->cross && t->shown.product.n > 0;
	if (t->cross && t->cross_at == 0)
		t->cross_at = t->shown.product.n / 3;
	if (t->cross)
		t->page = PAGE_PREDICT;
	t->focus = t->cross ? FOCUS_CROSS : FOCUS_SPEED;
	if (t->shown.product.n == 0)
		tui_say(t, true, "nothing is predicted yet: f calibrates");
	else if (t->cross)
		tui_say(t, false,
		    "left and right: the sieve; up and down: the passing; Tab: "
		    "the speed again");
}

static void
band(struct tui *t)
{
	const struct entry *entry = tui_entry(t);
	t->band = !t->band;
	if (!t->band || t->now.site[0] == '\0')
		return;
	bool known = doubt_band(t->session, entry, &t->shown) != NULL;
	tui_say(t, false, "%s%s", known ? "" : doubt_why_none(entry),
	    !known && entry->has_fit && fit_too_few(&entry->fit) ? ""
	    : !known ? "; f calibrates"
	    : screen_depth() >= 256
		? "band on: 80 % of the fits"
		: "band on: 80 % of the fits; where thinner than half a row "
		  "it does not show");
}

static void
next_picture(struct tui *t)
{
	t->picture = t->picture == PLOT_PSD           ? PLOT_CONVERGENCE
		     : t->picture == PLOT_CONVERGENCE ? PLOT_SPREAD
						      : PLOT_PSD;
}

static void
stop(struct tui *t)
{
	if (session_busy(t->session))
		conduct_keep(t);
	else
		tui_say(
		    t, false, "nothing runs that could be stopped: q leaves");
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
		go_to(t, (enum page)key->amount);
		break;
	case ACT_FOCUS:
		next_focus(t, key->amount);
		break;
	case ACT_CROSS:
		cross(t);
		break;
	case ACT_BAND:
		band(t);
		break;
	case ACT_PIN:
		pin(t);
		break;
	case ACT_PICTURE:
		next_picture(t);
		break;
	case ACT_HELP:
		view_keys(t, "");
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
	default:
		t->leave = true;
	}
}

/* Does what a key is for; nothing for NULL. */
static void
act(struct tui *t, const struct key *key)
{
	if (key == NULL)
		return;
	switch (key->act) {
	case ACT_MOVE:
		move_focus(t, key->amount);
		break;
	case ACT_FINE:
		move_far(t, key->amount);
		break;
	case ACT_TO:
		move_to(t, key->amount);
		break;
	case ACT_LIST:
		if (t->page == PAGE_SITES)
			t->focus = FOCUS_SITE;
		if (t->page == PAGE_DATA)
			t->data_top = (size_t)moved(
			    (int)t->data_top, key->amount, INT_MAX);
		else if (t->focus == FOCUS_CROSS)
			move_level(t, key->amount);
		else if (t->focus != FOCUS_SPEED)
			move_focus(t, key->amount);
		break;
	case ACT_RUN:
	case ACT_TELL:
	case ACT_TYPE:
	case ACT_EXPORT:
	case ACT_CHOOSE:
		run_key(t, key);
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
		conduct_typed(t, y->text);
}

/* Digits of a speed; 1 to 5 are pages, but behind a 0. */
static bool
digit_key(struct tui *t, int code)
{
	size_t n = strlen(t->digits);
	bool digit = code >= '0' && code <= '9';
	if (n == 0 && !(digit && (code == '0' || code > '5')))
		return false;
	if ((digit || code == '.') && n + 1 < sizeof t->digits) {
		t->digits[n] = (char)code;
		t->digits[n + 1] = '\0';
	} else if (code == '\n' || code == '\r') {
		struct slider_range range = tui_range(t);
		if (!slider_read(range, t->digits, &t->tenths))
			tui_say(t, true,
			    "a speed from %d to %d m/s was wanted, not %s",
			    range.least / 10, range.most / 10, t->digits);
		t->digits[0] = '\0';
	} else if (code == DELETE || code == '\b') {
		t->digits[n - 1] = '\0';
	} else {
		t->digits[0] = '\0';
		return code == ESCAPE;
	}
	return true;
}

void
act_key(struct tui *t, int code, bool special)
{
	if (special && (code == PANE_ENTER || code == PANE_BACKSPACE)) {
		code = code == PANE_ENTER ? '\n' : DELETE;
		special = false;
	}
	/* A character beyond ASCII is no key: its number may be one's. */
	if (!special && code > DELETE && !t->typing.active)
		return;
	const struct key *key = keys_find(code, t->page);
	if (special && code == PANE_MOUSE) {
		act_mouse(t);
	} else if (key != NULL &&
		   (key->act == ACT_SUSPEND || key->act == ACT_REDRAW)) {
		act(t, key);
	} else if (t->typing.active) {
		type_key(t, code, special);
	} else if (t->viewer.text != NULL) {
		act(t, view_key(t, code, special));
	} else if (!digit_key(t, code)) {
		act(t, key);
		if (key == NULL && code > ' ' && code < DELETE)
			tui_say(t, false,
			    "this key does nothing: ? lists the keys");
	}
}

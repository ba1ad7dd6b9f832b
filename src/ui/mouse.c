/* The mouse: where it was pressed is what it drags.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <curses.h>

#include "ui/act.h"
#include "ui/pane.h"

/* What was pressed follows the mouse. */
static void
follow(struct tui *t, int column)
{
	struct area track = pane_track(t);
	const struct area *s = &t->scrubber;
	size_t n = tui_past(t).n;
	if (t->focus != FOCUS_GENERATION) {
		t->tenths = slider_at(
		    tui_range(t), column - track.column, track.columns);
		return;
	}
	if (n == 0 || s->columns < 2)
		return;
	int at = column - s->column;
	at = at < 0 ? 0 : at >= s->columns ? s->columns - 1 : at;
	tui_look_at(t, 1 + (size_t)at * (n - 1) / (size_t)(s->columns - 1));
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
		t->digits[0] = '\0';
		act_key(t, '1' + (int)p, false);
	}
	bool scrubber = area_has(&t->scrubber, e->y, e->x);
	if (!scrubber && !area_has(&t->places.track, e->y, e->x))
		return;
	t->dragging = true;
	t->focus = scrubber ? FOCUS_GENERATION : FOCUS_SPEED;
	follow(t, e->x);
}

void
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
		follow(t, e.x);
	if (e.bstate & (BUTTON1_RELEASED | BUTTON1_CLICKED))
		t->dragging = false;
}

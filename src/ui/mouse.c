/* The mouse: where it was pressed is what it drags.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <curses.h>

#include "ui/act.h"
#include "ui/pane.h"

static void
press(struct tui *t, const MEVENT *e)
{
	for (size_t p = 0; p < PAGES; p++)
		if (e->y == t->layout.header.row && t->layout.header.rows > 0 &&
		    e->x >= t->tab[p].column &&
		    e->x < t->tab[p].column + t->tab[p].columns)
			act_key(t, '1' + (int)p, false);
	struct area track = pane_track(t);
	if (area_has(&t->layout.track, e->y, e->x)) {
		t->dragging = true;
		t->focus = FOCUS_SPEED;
		t->tenths = slider_at(e->x - track.column, track.columns);
	}
}

void
act_mouse(struct tui *t)
{
	MEVENT e;
	struct area track = pane_track(t);
	if (getmouse(&e) != OK || t->typing.active)
		return;
	if (t->viewer.text != NULL) {
		if (e.bstate & (BUTTON4_PRESSED | BUTTON5_PRESSED))
			act_key(
			    t, e.bstate & BUTTON4_PRESSED ? 'k' : 'j', false);
		return;
	}
	if (e.bstate & BUTTON4_PRESSED)
		t->tenths = slider_clamp(t->tenths + 1);
	else if (e.bstate & BUTTON5_PRESSED)
		t->tenths = slider_clamp(t->tenths - 1);
	else if (e.bstate & (BUTTON1_PRESSED | BUTTON1_CLICKED))
		press(t, &e);
	else if (t->dragging && (e.bstate & REPORT_MOUSE_POSITION))
		t->tenths = slider_at(e.x - track.column, track.columns);
	if (e.bstate & (BUTTON1_RELEASED | BUTTON1_CLICKED))
		t->dragging = false;
}

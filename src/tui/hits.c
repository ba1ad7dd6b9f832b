/* A list of areas and their actions.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "tui/hits.h"

#include <stdlib.h>

#include "base/xalloc.h"

void
hits_clear_click_areas(struct hits *hits)
{
	hits->n = 0;
}

void
hits_free(struct hits *hits)
{
	free(hits->at);
	*hits = (struct hits){0};
}

static void
hits_add_area(struct hits *hits, struct hit touch)
{
	if (touch.area.rows < 1 || touch.area.columns < 1)
		return;
	hits->at = xrealloc(hits->at, hits->n + 1, sizeof *hits->at);
	hits->at[hits->n++] = touch;
}

void
hits_add_mouse_handler(struct hits *hits, unsigned kinds, struct area area,
    mouse_action *way, size_t item)
{
	hits_add_area(hits, (struct hit){area, kinds, way, item, 0});
}

void
hits_add_key_area(struct hits *hits, struct area area, int code)
{
	hits_add_area(hits, (struct hit){area, HIT_PRESS, NULL, 0, code});
}

void
hits_add_handler_and_key(struct hits *hits, struct area area, mouse_action *way,
    size_t item, int code)
{
	hits_add_area(hits, (struct hit){area, HIT_PRESS, way, item, code});
}

static void
call_area_handler(struct tui *t, const struct hit *touch, enum hit_kind kind,
    int row, int column)
{
	int by = kind == HIT_UP ? -1 : kind == HIT_DOWN ? 1 : 0;
	if (touch->way != NULL)
		touch->way(t, &(struct mouse_event){kind, row - touch->area.row,
				  column - touch->area.column, by, touch->area,
				  touch->item});
}

bool
hits_dispatch_mouse(struct tui *t, struct hits *hits, enum hit_kind kind,
    int row, int column, void (*key)(struct tui *t, int code, bool special))
{
	struct hit pressed = hits->pressed;
	if (kind == HIT_DRAG) {
		if (pressed.kinds & HIT_DRAG)
			call_area_handler(t, &pressed, kind, row, column);
		return pressed.kinds & HIT_DRAG;
	}
	for (size_t i = hits->n; i-- > 0;) {
		/* A copy, because the handler may draw and so change the
		 * list. */
		struct hit touch = hits->at[i];
		if (!(touch.kinds & kind) ||
		    !area_has_cell(&touch.area, row, column))
			continue;
		call_area_handler(t, &touch, kind, row, column);
		if (touch.code != 0)
			key(t, touch.code, touch.code > 255);
		else if (kind == HIT_PRESS)
			hits->pressed = touch;
		return true;
	}
	return false;
}

const struct hit *
hits_find_area_at(const struct hits *hits, int row, int column)
{
	for (size_t i = hits->n; i-- > 0;)
		if (area_has_cell(&hits->at[i].area, row, column))
			return &hits->at[i];
	return NULL;
}

void
hits_end_drag(struct hits *hits)
{
	hits->pressed = (struct hit){0};
}

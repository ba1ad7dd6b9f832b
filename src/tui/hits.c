/* A list of areas with what they do.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "tui/hits.h"

#include <stdlib.h>

#include "base/xalloc.h"

void
hits_clear(struct hits *hits)
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
hits_add(struct hits *hits, struct area area, hit_way *way, size_t item)
{
	hits_add_area(
	    hits, (struct hit){.area = area, .way = way, .item = item});
}

void
hits_add_key(struct hits *hits, struct area area, int code, bool special)
{
	hits_add_area(
	    hits, (struct hit){.area = area, .code = code, .special = special});
}

void
hits_add_both(
    struct hits *hits, struct area area, hit_way *way, size_t item, int code)
{
	hits_add_area(hits,
	    (struct hit){.area = area, .way = way, .item = item, .code = code});
}

static bool
hand_on(struct tui *t, const struct hit *touch, enum hit_kind kind, int row,
    int column)
{
	return touch->way(
	    t, &(struct touched){kind, row - touch->area.row,
		   column - touch->area.column, touch->area, touch->item});
}

bool
hits_mouse(struct tui *t, struct hits *hits, enum hit_kind kind, int row,
    int column, void (*key)(struct tui *t, int code, bool special))
{
	if (kind == HIT_DRAG)
		return hits->pressed.way != NULL &&
		       hand_on(t, &hits->pressed, kind, row, column);
	for (size_t i = hits->n; i-- > 0;) {
		/* What it does may draw, and so change the list. */
		struct hit touch = hits->at[i];
		if (!area_has(&touch.area, row, column))
			continue;
		bool presses = touch.code != 0 && kind == HIT_PRESS;
		if (touch.way != NULL ? !hand_on(t, &touch, kind, row, column)
				      : !presses)
			continue;
		if (presses)
			key(t, touch.code, touch.special);
		else if (kind == HIT_PRESS)
			hits->pressed = touch;
		return true;
	}
	return false;
}

const struct hit *
hits_at(const struct hits *hits, int row, int column)
{
	for (size_t i = hits->n; i-- > 0;)
		if (area_has(&hits->at[i].area, row, column))
			return &hits->at[i];
	return NULL;
}

void
hits_release(struct hits *hits)
{
	hits->pressed = (struct hit){0};
}

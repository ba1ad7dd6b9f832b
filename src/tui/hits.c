/* A list of areas with what they do.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "tui/hits.h"

#include <stdlib.h>

#include "base/xalloc.h"

void
touch_clear(struct touches *touches)
{
	touches->n = 0;
}

void
touch_free(struct touches *touches)
{
	free(touches->at);
	*touches = (struct touches){0};
}

static void
add(struct touches *touches, struct touch touch)
{
	if (touch.area.rows < 1 || touch.area.columns < 1)
		return;
	touches->at =
	    xrealloc(touches->at, touches->n + 1, sizeof *touches->at);
	touches->at[touches->n++] = touch;
}

void
touch_add(
    struct touches *touches, struct area area, touch_way *way, size_t item)
{
	add(touches, (struct touch){.area = area, .way = way, .item = item});
}

void
touch_add_key(struct touches *touches, struct area area, int code, bool special)
{
	add(touches,
	    (struct touch){.area = area, .code = code, .special = special});
}

void
touch_add_both(struct touches *touches, struct area area, touch_way *way,
    size_t item, int code)
{
	add(touches, (struct touch){
			 .area = area, .way = way, .item = item, .code = code});
}

static bool
hand_on(struct tui *t, const struct touch *touch, enum touch_kind kind, int row,
    int column)
{
	return touch->way(
	    t, &(struct touched){kind, row - touch->area.row,
		   column - touch->area.column, touch->area, touch->item});
}

bool
touch_mouse(struct tui *t, struct touches *touches, enum touch_kind kind,
    int row, int column, void (*key)(struct tui *t, int code, bool special))
{
	if (kind == TOUCH_DRAG)
		return touches->pressed.way != NULL &&
		       hand_on(t, &touches->pressed, kind, row, column);
	for (size_t i = touches->n; i-- > 0;) {
		/* What it does may draw, and so change the list. */
		struct touch touch = touches->at[i];
		if (!area_has(&touch.area, row, column))
			continue;
		bool presses = touch.code != 0 && kind == TOUCH_PRESS;
		if (touch.way != NULL ? !hand_on(t, &touch, kind, row, column)
				      : !presses)
			continue;
		if (presses)
			key(t, touch.code, touch.special);
		else if (kind == TOUCH_PRESS)
			touches->pressed = touch;
		return true;
	}
	return false;
}

const struct touch *
touch_at(const struct touches *touches, int row, int column)
{
	for (size_t i = touches->n; i-- > 0;)
		if (area_has(&touches->at[i].area, row, column))
			return &touches->at[i];
	return NULL;
}

void
touch_release(struct touches *touches)
{
	touches->pressed = (struct touch){0};
}

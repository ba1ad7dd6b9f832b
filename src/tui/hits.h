/* What of a frame can be touched: each thing says so while it is drawn, and the
 * mouse asks.  What is drawn last lies on top.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TUI_HITS_H
#define TIPSPEED_TUI_HITS_H

#include <stdbool.h>
#include <stddef.h>

#include "tui/layout.h"

struct tui;

/* TOUCH_DRAG goes to what was pressed, wherever the mouse is by then. */
enum touch_kind { TOUCH_PRESS, TOUCH_DRAG, TOUCH_UP, TOUCH_DOWN };

/* row, column: from the top left of the area, negative or beyond it where it
 * was dragged off; item: what was given with it. */
struct touched {
	enum touch_kind kind;
	int row, column;
	struct area area;
	size_t item;
};

/* Does what the mouse asks for; false: it has no part in that kind, and what
 * lies below is asked. */
typedef bool touch_way(struct tui *t, const struct touched *touched);

struct touch {
	struct area area;
	touch_way *way; /* or NULL */
	size_t item;
	int code; /* a key that is pressed then, or 0 */
	bool special;
};

/* Those of a frame, n of them; pressed: what a drag goes to, way NULL: none. */
struct touches {
	size_t n;
	struct touch *at;
	struct touch pressed;
};

/* For a new frame; what is being dragged stays. */
void touch_clear(struct touches *touches);
void touch_free(struct touches *touches);

/* Areas without a cell are left out. */
void touch_add(
    struct touches *touches, struct area area, touch_way *way, size_t item);

/* A press there is the key: code and special as in act_key. */
void touch_add_key(
    struct touches *touches, struct area area, int code, bool special);

/* A press there does its part by the way, and then is the key, too. */
void touch_add_both(struct touches *touches, struct area area, touch_way *way,
    size_t item, int code);

/* Hands on what the mouse did at a cell; false where nobody took it.  A key
 * goes to `key`. */
bool touch_mouse(struct tui *t, struct touches *touches, enum touch_kind kind,
    int row, int column, void (*key)(struct tui *t, int code, bool special));

/* The topmost that has the cell, or NULL. */
const struct touch *touch_at(
    const struct touches *touches, int row, int column);

/* The button was let go of. */
void touch_release(struct touches *touches);

#endif

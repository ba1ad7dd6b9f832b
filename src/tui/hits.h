/* What of a frame can be touched: each thing says so while it is drawn, and the
 * mouse asks.  What is drawn last lies on top.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TUI_HITS_H
#define TIPSPEED_TUI_HITS_H

#include <stdbool.h>
#include <stddef.h>

#include "tui/layout.h"

struct tui;

/* HIT_DRAG goes to what was pressed, wherever the mouse is by then. */
enum hit_kind { HIT_PRESS, HIT_DRAG, HIT_UP, HIT_DOWN };

/* row, column: from the top left of the area, negative or beyond it where it
 * was dragged off; item: what was given with it. */
struct touched {
	enum hit_kind kind;
	int row, column;
	struct area area;
	size_t item;
};

/* Does what the mouse asks for; false: it has no part in that kind, and what
 * lies below is asked. */
typedef bool hit_way(struct tui *t, const struct touched *touched);

struct hit {
	struct area area;
	hit_way *way; /* or NULL */
	size_t item;
	int code; /* a key that is pressed then, or 0 */
	bool special;
};

/* Those of a frame, n of them; pressed: what a drag goes to, way NULL: none. */
struct hits {
	size_t n;
	struct hit *at;
	struct hit pressed;
};

/* For a new frame; what is being dragged stays. */
void hits_clear(struct hits *hits);
void hits_free(struct hits *hits);

/* Areas without a cell are left out. */
void hits_add(struct hits *hits, struct area area, hit_way *way, size_t item);

/* A press there is the key: code and special as in keymap_key. */
void hits_add_key(struct hits *hits, struct area area, int code, bool special);

/* A press there does its part by the way, and then is the key, too. */
void hits_add_both(
    struct hits *hits, struct area area, hit_way *way, size_t item, int code);

/* Hands on what the mouse did at a cell; false where nobody took it.  A key
 * goes to `key`. */
bool hits_mouse(struct tui *t, struct hits *hits, enum hit_kind kind, int row,
    int column, void (*key)(struct tui *t, int code, bool special));

/* The topmost that has the cell, or NULL. */
const struct hit *hits_at(const struct hits *hits, int row, int column);

/* The button was let go of. */
void hits_release(struct hits *hits);

#endif

/* The areas of a frame that react to the mouse.  Each is added as it is drawn;
 * the last is on top.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TUI_HITS_H
#define TIPSPEED_TUI_HITS_H

#include <stdbool.h>
#include <stddef.h>

#include "tui/layout.h"

struct tui;

/* Mouse actions, as bits.  HIT_DRAG goes to the area that was pressed, wherever
 * the mouse is now. */
enum hit_kind {
	HIT_PRESS = 1,
	HIT_DRAG = 2,
	HIT_UP = 4,
	HIT_DOWN = 8,
	HIT_SLIDE = HIT_PRESS | HIT_DRAG,
	HIT_WHEEL = HIT_UP | HIT_DOWN
};

/* A mouse event in an area.  row, column: from its top left; negative or beyond
 * the area after a drag out of it.  by: rows by which the wheel moves a list
 * down.  item: as passed to hits_add_mouse_handler. */
struct mouse_event {
	enum hit_kind kind;
	int row, column, by;
	struct area area;
	size_t item;
};

/* Handles a mouse event. */
typedef void mouse_action(struct tui *t, const struct mouse_event *touched);

struct hit {
	struct area area;
	unsigned kinds;
	mouse_action *way; /* or NULL */
	size_t item;
	int code; /* a key to press then, or 0 */
};

/* The n areas of a frame.  pressed: the area that receives a drag; none if its
 * way is NULL. */
struct hits {
	size_t n;
	struct hit *at;
	struct hit pressed;
};

/* Clears the areas for a new frame, except the one being dragged. */
void hits_clear_click_areas(struct hits *hits);
void hits_free(struct hits *hits);

/* Adds an area that handles these kinds, unless it has no cells. */
void hits_add_mouse_handler(struct hits *hits, unsigned kinds, struct area area,
    mouse_action *way, size_t item);

/* Adds an area in which a press acts as a key (above 255: a special key of
 * ncurses). */
void hits_add_key_area(struct hits *hits, struct area area, int code);

/* Adds an area in which a press is handled by `way` and then acts as the
 * key. */
void hits_add_handler_and_key(struct hits *hits, struct area area,
    mouse_action *way, size_t item, int code);

/* Passes a mouse action at a cell to the areas that contain it; a key that
 * an area stands for goes to `key`.  Returns false if none handled it. */
bool hits_dispatch_mouse(struct tui *t, struct hits *hits, enum hit_kind kind,
    int row, int column, void (*key)(struct tui *t, int code, bool special));

/* Returns the topmost area that contains the cell, or NULL. */
const struct hit *hits_find_area_at(
    const struct hits *hits, int row, int column);

/* Ends a drag: the button was released. */
void hits_end_drag(struct hits *hits);

#endif

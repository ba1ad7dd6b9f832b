/* The slider's track on the screen and its heading; keys and the mouse that
 * move the slider.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TUI_WIDGETS_TRACK_H
#define TIPSPEED_TUI_WIDGETS_TRACK_H

#include "tui/tui_state.h"

void track_draw(struct tui *t);

/* Draws the rule above the track, with the quantity, the goal, the speed, and
 * the meaning of the signs. */
void track_draw_heading(struct tui *t);

/* A mouse_action: moves the slider to where the mouse was pressed or
 * dragged. */
void track_on_mouse(struct tui *t, const struct mouse_event *touched);

/* Runs the key that waits for the goal's speeds (pending_key) if they are
 * known.  If `now`, computes them first.  Drops the key if the slider has been
 * moved since it was pressed. */
void track_run_pending_key(struct tui *t, bool now);

/* Signs on the track for training speeds, for held-out speeds, and beyond all
 * these; UTF-8. */
struct track_signs {
	const char *trained, *held_out, *beyond;
};
struct track_signs track_signs(void);

/* True if a run's speed is one of those at which the parameters were
 * trained. */
bool track_is_training_run(const struct entry *entry, size_t run);

#endif

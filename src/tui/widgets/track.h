/* The track of the slider on the screen, its heading, and how keys and mouse
 * move the slider.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TUI_WIDGETS_TRACK_H
#define TIPSPEED_TUI_WIDGETS_TRACK_H

#include "tui/tui_state.h"

void track_draw(struct tui *t);

/* Draws a rule with what is above the track: the goal, the speed, and the
 * meaning of the signs. */
void track_draw_heading(struct tui *t);

/* Moves the slider to where the mouse is pressed or dragged; see hit_way. */
void track_touch(struct tui *t, const struct touched *touched);

/* Runs the waiting key, if the speeds are known or `now` asks to compute them
 * at once.  The key is dropped if the slider was moved since. */
void track_wished(struct tui *t, bool now);

/* Signs on the track where parameters were trained, where a run was held out,
 * and beyond all those speeds; UTF-8. */
struct track_signs {
	const char *trained, *held_out, *beyond;
};
struct track_signs track_signs(void);

/* True if parameters were trained at the speed of a run. */
bool track_trained(const struct entry *entry, size_t run);

#endif

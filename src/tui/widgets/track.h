/* The track of the slider on the screen, its heading, and where keys and mouse
 * take the slider.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TUI_WIDGETS_TRACK_H
#define TIPSPEED_TUI_WIDGETS_TRACK_H

#include "tui/tui_state.h"

void track_draw(struct tui *t);

/* A rule with what stands above the track, the goal, the speed, and what the
 * signs mean. */
void track_heading(struct tui *t);

/* Wherever it is pressed the slider goes, and follows; see hit_way. */
bool track_touch(struct tui *t, const struct touched *touched);

/* Does what the kept key is for, where the speeds are known or are to be worked
 * out now.  Who has moved the slider since then wants something else. */
void track_wished(struct tui *t, bool now);

/* What stands where parameters were trained at, where a run was held out, and
 * beyond all those speeds; UTF-8. */
struct track_signs {
	const char *trained, *held_out, *beyond;
};
struct track_signs track_signs(void);

/* Whether parameters were trained at the speed of a run. */
bool track_trained(const struct entry *entry, size_t run);

#endif

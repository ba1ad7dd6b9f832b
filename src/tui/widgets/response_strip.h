/* A quantity over all speeds of the slider, in the same columns above its
 * track.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TUI_WIDGETS_RESPONSE_STRIP_H
#define TIPSPEED_TUI_WIDGETS_RESPONSE_STRIP_H

#include "tui/tui_state.h"

/* What was worked out; opaque. */
struct strip;

struct strip *strip_new(void);
void strip_free(struct strip *strip);

/* The quantity that is shown first: P80. */
struct quantity strip_usual(void);

/* Works out a part of the curve, or else of the goal, unless the slider has
 * just been moved: some 10 ms.  Without a terminal all of it. */
void strip_update(struct tui *t);

/* Point i of the curve, from the slowest speed on: value, low and high as they
 * are shown.  False where it is not known, or there are no more. */
bool strip_point(
    const struct tui *t, size_t i, double *speed, double value[static 3]);

/* How long until there is such a part to work out, s; INFINITY: none. */
double strip_wait(const struct tui *t);

/* Draws it, when all is known: dashed where speeds are extrapolated, its band
 * as a shade, limits on it as dotted lines, what was measured and where the
 * slider stands as marks. */
void strip_draw(struct tui *t);

#endif

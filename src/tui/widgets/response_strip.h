/* A quantity plotted at every speed of the slider, just above the slider's
 * track and aligned with its columns.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TUI_WIDGETS_RESPONSE_STRIP_H
#define TIPSPEED_TUI_WIDGETS_RESPONSE_STRIP_H

#include "tui/tui_state.h"

/* What was computed; opaque. */
struct strip;

struct strip *strip_new(void);
void strip_free(struct strip *strip);

/* Returns the quantity that is shown first: P80. */
struct quantity strip_usual(void);

/* Computes a part of the curve, or else of the goal, unless the slider has just
 * been moved: some 10 ms.  Without a terminal computes all of it. */
void strip_update(struct tui *t);

/* Reads point i of the curve, from the slowest speed on: value, low and high as
 * they are shown.  False if it is not known, or there are no more. */
bool strip_point(
    const struct tui *t, size_t i, double *speed, double value[static 3]);

/* Returns how long until such a part can be computed, s; INFINITY: none is
 * left. */
double strip_wait(const struct tui *t);

/* Draws the strip once all of it is known: dashed where speeds are
 * extrapolated, its band as a shade, limits as dotted lines, measured values
 * and the slider as marks. */
void strip_draw(struct tui *t);

#endif

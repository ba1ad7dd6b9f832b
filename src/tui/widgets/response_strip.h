/* A quantity plotted at every speed of the slider, just above the track and
 * aligned with its columns.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TUI_WIDGETS_RESPONSE_STRIP_H
#define TIPSPEED_TUI_WIDGETS_RESPONSE_STRIP_H

#include "tui/tui_state.h"

/* Returns the default quantity, P80. */
struct quantity response_strip_default_quantity(void);

/* Computes a part of the curve or, after that, of the goal, for some 10 ms,
 * unless the slider has just been moved.  Without a terminal, computes all of
 * it. */
void response_strip_update(struct tui *t);

/* Returns the time, s, until the next such part can be computed, or INFINITY if
 * there is none. */
double strip_seconds_to_wait(const struct tui *t);

/* Draws the strip once it is complete: the curve, dashed where extrapolated,
 * its band shaded, limits as dotted lines, and marks for measured values and
 * for the slider. */
void response_strip_draw(struct tui *t);

#endif

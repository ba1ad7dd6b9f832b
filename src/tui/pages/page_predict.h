/* The page Predict: the curves, and the numbers at the slider's speed.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TUI_PAGES_PAGE_PREDICT_H
#define TIPSPEED_TUI_PAGES_PAGE_PREDICT_H

#include "tui/pane.h"

/* The crosshair on, which opens the page, or off. */
void page_predict_cross(struct tui *t);

/* The crosshair on, at the sieve nearest to a size, m. */
void page_predict_read(struct tui *t, double size);

/* Adds the pinned answer, if any, to what plot and describe are asked for, with
 * the feed that it was predicted with. */
void page_predict_beside(const struct tui *t, char **words);

#endif

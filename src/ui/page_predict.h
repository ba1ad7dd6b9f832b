/* The page Predict: the curves, and the numbers at the slider's speed.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_UI_PAGE_PREDICT_H
#define TIPSPEED_UI_PAGE_PREDICT_H

#include "ui/pane.h"

/* The crosshair on, which opens the page, or off. */
void page_predict_cross(struct tui *t);

/* The row of numbers that takes the side panel's place, on any page. */
void page_predict_numbers(struct tui *t);

#endif

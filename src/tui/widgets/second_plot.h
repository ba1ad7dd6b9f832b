/* The second plot of page Predict, right of the curves on a screen that is wide
 * enough: what does not change with the slider.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TUI_WIDGETS_SECOND_PLOT_H
#define TIPSPEED_TUI_WIDGETS_SECOND_PLOT_H

#include "tui/tui_state.h"

/* In its place, where it has one. */
void second_draw(struct tui *t);
void second_free(struct tui *t);

/* Adds the command that describes it to that of the curves, where it has a
 * place. */
void second_words(const struct tui *t, char **words);

/* The next of those there are: response, residuals, what is pinned of another
 * site. */
void second_next(struct tui *t);

#endif

/* What is shown of the session, struct view: one prediction and what follows
 * from it, made again when what it depends on (struct view_key) changes.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TUI_VIEW_H
#define TIPSPEED_TUI_VIEW_H

#include "tui/tui_state.h"

/* Updates the basis after anything that may have changed the session. */
void view_mark_changed(struct tui *t);

/* Computes what a frame shows: the prediction at the slider, which is also made
 * the session's latest answer, then what the open page shows beside it; of long
 * computations, a part in the time between two keys. */
void view_update(struct tui *t);

/* Computes the prediction alone. */
void view_predict(struct tui *t);

/* As view_predict, but without an answer to the session, until the next. */
void view_form(struct tui *t);

void view_free(struct tui *t);

#endif

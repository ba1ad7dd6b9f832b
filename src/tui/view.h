/* What is shown of the session, struct view: one prediction, and what follows
 * from it, made anew where what it is of (struct view_key) is another.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TUI_VIEW_H
#define TIPSPEED_TUI_VIEW_H

#include "tui/tui_state.h"

/* After anything that may have changed the session. */
void view_look(struct tui *t);

/* What a frame shows: the prediction at the slider, of which the session is
 * told, then what the open page shows beside it, and of what takes long a part
 * in the time between two keys. */
void view_update(struct tui *t);

/* The prediction alone. */
void view_predict(struct tui *t);

/* The same, of which the session is not told. */
void view_form(struct tui *t);

void view_free(struct tui *t);

#endif

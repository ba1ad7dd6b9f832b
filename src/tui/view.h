/* struct view, the content shown: one prediction and results derived from it,
 * recomputed when its struct prediction_key changes.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TUI_VIEW_H
#define TIPSPEED_TUI_VIEW_H

#include "tui/tui_state.h"

/* Must be called after anything that may have changed the session.  Discards
 * the results that are then out of date. */
void view_discard_outdated(struct tui *t);

/* Computes the content of a frame: the prediction at the slider's speed, which
 * also becomes the session's latest answer, then what else the open page shows.
 * Long computations advance by a part between keys. */
void view_update(struct tui *t);

/* Computes the prediction alone. */
void view_predict_at_slider(struct tui *t);

/* As view_predict_at_slider, but does not make the prediction the session's
 * answer.  It is shown until the next one. */
void view_predict_unrecorded(struct tui *t);

void view_free(struct tui *t);

#endif

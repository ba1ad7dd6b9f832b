/* Checks the product at the slider's speed against the chosen grading envelope.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TUI_WIDGETS_ENVELOPE_CHECK_H
#define TIPSPEED_TUI_WIDGETS_ENVELOPE_CHECK_H

#include "cmd/ask/envelope.h"
#include "tui/tui_state.h"

/* Brings the check up to date with the slider's speed and with the session.
 * What does not depend on the speed is kept, so that a step of the slider only
 * reads the curve of its prediction, without draws. */
void envelope_check_update(struct tui *t);
void envelope_check_free(struct tui *t);

/* Returns the check at the slider's speed.  Returns NULL if no envelope is
 * chosen, there is no prediction, none of the envelope's sieves is within the
 * range of the feed's sieves, or a calibration is running. */
const struct grading *envelope_check_at_slider(const struct tui *t);

#endif

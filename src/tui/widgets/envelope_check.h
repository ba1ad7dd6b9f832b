/* The grading envelope in use, worked out at the slider's speed.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TUI_WIDGETS_ENVELOPE_CHECK_H
#define TIPSPEED_TUI_WIDGETS_ENVELOPE_CHECK_H

#include "cmd/ask/envelope.h"
#include "tui/tui_state.h"

/* As the slider or the session is now.  What does not change with the speed is
 * kept; a step reads the curve of its prediction, without draws. */
void envelope_check_update(struct tui *t);
void envelope_check_free(struct tui *t);

/* At that speed; NULL where no envelope is in use, none of its sieves is in the
 * range of the feed's, or a calibration runs. */
const struct grading *envelope_check_now(const struct tui *t);

#endif

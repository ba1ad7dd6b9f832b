/* What the Sites page tells of each site at the slider's speed.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_UI_ROWS_H
#define TIPSPEED_UI_ROWS_H

#include "ui/tui_state.h"

/* Where that page is open.  What does not hang on the speed is worked out when
 * the session has changed only (rows_at 0). */
void rows_update(struct tui *t);

#endif

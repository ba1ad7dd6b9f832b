/* Text that is pasted into the full screen, between the marks that terminals
 * put around it: it is typed into the line that is open, and never run.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_UI_PASTE_H
#define TIPSPEED_UI_PASTE_H

#include "ui/tui_state.h"

/* True for a mark and for what stands between two, which is dealt with. */
bool paste_key(struct tui *t, int code, bool special);

/* The end of what is pasted, also where its mark does not come. */
void paste_end(struct tui *t);

#endif

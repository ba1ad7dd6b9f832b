/* Lines typed on the full screen: their meaning at the slider's speed, and
 * their effect on a running search.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TUI_CMDLINE_H
#define TIPSPEED_TUI_CMDLINE_H

#include "tui/tui_state.h"

/* Run a typed line.  cmdline_run shows its output, except a prediction that the
 * page shows anyway; cmdline_show shows that as well. */
void cmdline_run(struct tui *t, const char *line);
void cmdline_show(struct tui *t, const char *line);

#endif

/* Lines typed on the full screen: their meaning at the slider's speed, and
 * their effect on a running search.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TUI_CMDLINE_H
#define TIPSPEED_TUI_CMDLINE_H

#include "tui/tui_state.h"

/* Runs a typed line and shows its output, except a prediction that the page
 * shows anyway. */
void cmdline_run_line(struct tui *t, const char *line);

#endif

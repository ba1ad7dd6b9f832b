/* Lines typed on the full screen: what they mean at the slider's place, and
 * their effect on a search under way.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TUI_CMDLINE_H
#define TIPSPEED_TUI_CMDLINE_H

#include "tui/tui_state.h"

/* Runs a typed line.  cmdline_run shows what it prints, except a prediction
 * that the page shows anyway; cmdline_show shows that, too. */
void cmdline_run(struct tui *t, const char *line);
void cmdline_show(struct tui *t, const char *line);

#endif

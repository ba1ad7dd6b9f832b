/* Lines typed on the full screen: what they mean with the slider somewhere, and
 * what they do to a search that is under way.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TUI_CMDLINE_H
#define TIPSPEED_TUI_CMDLINE_H

#include "tui/tui_state.h"

/* Runs a typed line.  What it prints is shown, but of a prediction that the
 * page shows; of the other that, too. */
void cmdline_run(struct tui *t, const char *line);
void cmdline_show(struct tui *t, const char *line);

#endif

/* The first minute: what can be done while there is no site.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TUI_PAGES_START_PAGE_H
#define TIPSPEED_TUI_PAGES_START_PAGE_H

#include "base/tr.h"
#include "tui/tui_state.h"

/* Draws it in the body. */
void first_draw(struct tui *t);

/* Takes a key of the list; false: it is none of them. */
bool first_key(struct tui *t, const struct key *key);

#define FIRST_HINTS \
	N_("Up/Down, Enter choose  ? keys  q quit  o open  : command")

#endif

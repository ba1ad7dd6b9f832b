/* The start page: what to do while no site is loaded.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TUI_PAGES_START_PAGE_H
#define TIPSPEED_TUI_PAGES_START_PAGE_H

#include "base/tr.h"
#include "tui/tui_state.h"

/* Draws the page in the body. */
void start_page_draw(struct tui *t);

/* Its list, which has no rows if a site is loaded. */
extern const struct page_list START_LIST;

#define START_HINTS N_("Up/Down, Enter choose  ?  q  o open  :")

#endif

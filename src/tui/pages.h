/* The open page, which is one of SCREEN_PAGES.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TUI_PAGES_H
#define TIPSPEED_TUI_PAGES_H

#include "tui/pane.h"

/* The names of the pages in the heading. */
extern const char *const PAGE_HEADINGS[PAGES];

/* pages_current returns the open page; pages_go_to opens a page. */
const struct page_ops *pages_current(const struct tui *t);
void pages_go_to(struct tui *t, enum page page);

/* Calls `update` of the open page, see page_ops; does nothing if it has
 * none. */
void pages_update(struct tui *t);

#endif

/* The pages of the full screen, in the order of their numbers.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TUI_PAGES_H
#define TIPSPEED_TUI_PAGES_H

#include "tui/pane.h"

extern const struct page_ops *const PAGE_OPS[PAGES];

/* The one that is open; and to open one. */
const struct page_ops *pages_open(const struct tui *t);
void pages_go(struct tui *t, enum page page);

/* See page_ops; nothing where the page has no such thing. */
void pages_update(struct tui *t);

#endif

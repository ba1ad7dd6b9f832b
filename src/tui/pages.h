/* The pages of the full screen, in the order of their numbers.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TUI_PAGES_H
#define TIPSPEED_TUI_PAGES_H

#include "tui/pane.h"

extern const struct page_ops *const PAGE_OPS[PAGES];

/* The one that is open; and to open one: what the arrows move changes with it,
 * where it has to. */
const struct page_ops *pages_open(const struct tui *t);
void pages_go(struct tui *t, enum page page);

/* Whether the arrows can move something of the open page's own. */
bool pages_can_focus(const struct tui *t);

/* See page_ops; nothing where the page has no such thing. */
void pages_update(struct tui *t);

#endif

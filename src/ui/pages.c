/* The table of pages.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "ui/pages.h"

const struct page_ops *const PAGE_OPS[PAGES] = {[PAGE_PREDICT] = &page_predict,
    [PAGE_FIT] = &page_fit,
    [PAGE_DATA] = &page_data,
    [PAGE_PARITY] = &page_parity,
    [PAGE_SITES] = &page_sites};

const struct page_ops *
pages_open(const struct tui *t)
{
	return PAGE_OPS[t->page];
}

void
pages_go(struct tui *t, enum page page)
{
	t->page = page;
	const struct page_ops *ops = pages_open(t);
	if (ops->takes_focus)
		t->focus = ops;
	else if (t->focus != ops || !ops->can_focus(t))
		t->focus = NULL;
}

void
pages_update(struct tui *t)
{
	if (pages_open(t)->update != NULL)
		pages_open(t)->update(t);
}

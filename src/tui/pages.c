/* The table of pages.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "tui/pages.h"

#include "tui/widgets/response_strip.h"

const struct page_ops *const PAGE_OPS[PAGES] = {[PAGE_PREDICT] = &page_predict,
    [PAGE_FIT] = &page_fit,
    [PAGE_DATA] = &page_data,
    [PAGE_PARITY] = &page_parity,
    [PAGE_SITES] = &page_sites};

const struct page_ops *
pages_open(const struct tui *t)
{
	return PAGE_OPS[t->ui.page];
}

bool
pages_can_focus(const struct tui *t)
{
	const struct page_ops *ops = pages_open(t);
	return ops->takes_focus || (ops->list != NULL && ops->list->n(t) > 0) ||
	       (ops->can_focus != NULL && ops->can_focus(t));
}

void
pages_go(struct tui *t, enum page page)
{
	if (t->ui.page != page) {
		t->filter = (struct edit){0};
		tui_untouch(t);
	}
	t->ui.page = page;
	const struct page_ops *ops = pages_open(t);
	if (ops->takes_focus)
		t->ui.focus = ops;
	else if (t->ui.focus != ops || !pages_can_focus(t))
		t->ui.focus = NULL;
}

void
pages_update(struct tui *t)
{
	if (t->picker.on)
		t->picker.rows->update(t);
	strip_update(t);
	if (pages_open(t)->update != NULL)
		pages_open(t)->update(t);
}

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
pages_current(const struct tui *t)
{
	return PAGE_OPS[t->ui.page];
}

void
pages_go_to(struct tui *t, enum page page)
{
	if (t->ui.page != page) {
		t->filter = (struct edit){0};
		t->ui.cell.on = false;
		tui_clear_hits(t);
	}
	t->ui.page = page;
}

void
pages_update(struct tui *t)
{
	if (t->picker.on)
		t->picker.rows->update(t);
	strip_update(t);
	if (pages_current(t)->update != NULL)
		pages_current(t)->update(t);
}

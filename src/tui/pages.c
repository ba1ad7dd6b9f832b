/* The open page.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "tui/pages.h"

#include "tui/widgets/response_strip.h"

#define PAGE_ADDRESS(NUMBER, name, heading, key) &page_##name,
#define PAGE_HEADING(NUMBER, name, heading, key) heading,

const char *const PAGE_HEADINGS[PAGES] = {SCREEN_PAGES(PAGE_HEADING)};

const struct page_ops *
pages_current(const struct tui *t)
{
	static const struct page_ops *const OF[PAGES] = {
	    SCREEN_PAGES(PAGE_ADDRESS)};
	return OF[t->ui.page];
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

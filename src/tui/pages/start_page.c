/* The start page: a list of ways to open a site.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "tui/pages/start_page.h"

#include "base/tr.h"
#include "base/xalloc.h"
#include "tui/acts.h"
#include "tui/widgets/file_picker.h"
#include "tui/pane.h"
#include "tui/screen.h"
#include "tui/widgets/list.h"

/* The ways to open a site, each with the list of files that it opens. */
static const struct {
	const char *name, *what;
	enum picker_list list;
} WAYS[] = {{N_("Open a sheet"),
		N_("Sieve analyses of the feed and of the product at two "
		   "speeds or more, "
		   "from Excel, LibreOffice or CSV. The list shows how each "
		   "file would be "
		   "read. The key o opens it later."),
		PICK_FILES},
    {N_("Go on with a saved session"),
	N_("Brings back what the key w saved in a file that ends in .tip: "
	   "sites with their fits, the goal and the pinned prediction."),
	PICK_SESSIONS},
    {N_("Try a site that comes with tipspeed"),
	N_("Quarries of the paper with their rock and tip speeds; their curves "
	   "are reconstructed from it."),
	PICK_SHIPPED},
    {N_("Estimate from rock type and top size"),
	N_("Where only the feed was sampled: from the materials of other "
	   "quarries, with a wide band. Choose the sheet with the feed, then "
	   "complete the command."),
	PICK_FEEDS}};

static size_t
count_start_choices(const struct tui *t)
{
	return tui_current_entry(t) == NULL ? ARRAY_LEN(WAYS) : 0;
}

static void
open_start_choice(struct tui *t)
{
	size_t at = t->ui.list[PAGE_PREDICT].at;
	if (at < ARRAY_LEN(WAYS))
		picker_open(t, WAYS[at].list);
}

const struct page_list START_LIST = {
    .n = count_start_choices, .open = open_start_choice};

static void
draw_start_choice(struct tui *t, const struct area *line, size_t i,
    unsigned look, const void *of)
{
	(void)t, (void)of;
	screen_text(line, 0, 1, look, "%s", tr(WAYS[i].name));
}

/* In the middle, with a description of the chosen way if there is room. */
void
start_page_draw(struct tui *t)
{
	enum { WIDEST = 64, GAPS = 3, WHAT = 4 };
	struct area area = pane_list_area(t);
	int n = ARRAY_LEN(WAYS);
	if (area.columns > WIDEST) {
		area.column += (area.columns - WIDEST) / 2;
		area.columns = WIDEST;
	}
	bool title = area.rows >= n + 2, what = area.rows >= n + GAPS + WHAT;
	int spare = area.rows - n - (title ? 2 : 0) - (what ? 1 + WHAT : 0);
	int row = spare > 0 ? spare / 3 : 0;
	if (title)
		screen_text(&area, row, 0, LOOK_BOLD, "No site is loaded yet:");
	row += title ? 2 : 0;
	area.row += row;
	area.rows -= row;
	row = rows_draw(t, &area, draw_start_choice, NULL);
	if (what)
		screen_draw_wrapped(&area, row + 1, 0,
		    tr(WAYS[t->ui.list[PAGE_PREDICT].at].what));
}

/* Shows text, through a pager where it is taller than the screen.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_UI_PAGER_H
#define TIPSPEED_UI_PAGER_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

/* Results held back until it is known how tall they are.  Write to file. */
struct page {
	FILE *file;
	char *text;
	size_t n, shown;
};

/* False when there is no memory: then nothing is held back. */
bool page_open(struct page *page);

/* Shows on standard output what was written since the last time.  paged: a
 * pager may be used. */
void page_show(struct page *page, bool paged);

void page_close(struct page *page);

#endif

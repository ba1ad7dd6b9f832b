/* Shows text, through a pager where it is taller than the screen.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_UI_PAGER_H
#define TIPSPEED_UI_PAGER_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

#include "cmd/session.h"

/* What a line has to say, held back until it is known how tall it is.  The
 * session's results go to file, and with them its notes while they are held. */
struct page {
	struct session *session;
	FILE *file, *out, *notes;
	char *text;
	size_t n, shown;
};

void page_open(struct page *page, struct session *s);

/* Holds notes back, too, so that they stand beside their results.  Nothing for
 * NULL. */
void page_hold(struct page *page);

/* Shows on standard output what is new, through a pager where it is tall, and
 * lets notes through again. */
void page_show(struct page *page);

/* Gives the session back its streams. */
void page_close(struct page *page);

#endif

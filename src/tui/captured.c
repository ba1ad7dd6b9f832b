/* Captures the output of commands: one line goes to the message row, more to
 * the viewer.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "tui/captured.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/xalloc.h"
#include "tui/screen.h"
#include "tui/widgets/viewer.h"

void
captured_discard_output(struct tui *t)
{
	struct screen screen = {.drawing = screen_charset() != CHARSET_ASCII};
	screen_size(&screen.rows, &screen.columns);
	t->session->screen = screen;
	rewind(t->captured);
	fflush(t->captured);
}

void
captured_show_error(
    void *t, const struct error *e, const char *line, const char *name)
{
	char place[sizeof e->file + 32] = "";
	(void)line, (void)name;
	if (e->line > 0 && strcmp(e->file, ERROR_TYPED) != 0)
		snprintf(place, sizeof place, "%s:%d:%d: ", e->file, e->line,
		    e->column);
	tui_set_message(t, true, "%s%s%s%s", place, e->text,
	    e->hint[0] != '\0' ? ": " : "", e->hint);
}

void
captured_show_output(struct tui *t)
{
	fflush(t->captured);
	size_t n = t->captured_n;
	while (n > 0 && t->captured_text[n - 1] == '\n')
		n--;
	char *text = xstrndup(t->captured_text, n);
	if (strchr(text, '\n') != NULL) {
		viewer_show_text(t, text);
		return;
	}
	if (n > 0)
		tui_set_message(t, false, "%s", text);
	free(text);
}

/* The history's file is only ever appended to, a line a write.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "ui/typed.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <readline/history.h>

#include "base/xalloc.h"
#include "io/home.h"

/* Lines held in memory; the file may have more. */
enum { MOST = 5000 };

static int file = -1;
static bool opened;

void
typed_open(bool with_file)
{
	opened = true;
	using_history();
	stifle_history(MOST);
	if (!with_file)
		return;
	char *path = home_path("XDG_STATE_HOME", ".local/state", "history");
	if (path == NULL) {
		fputs("the history is not kept: HOME is not set\n", stderr);
		return;
	}
	char *closed = home_make_folders(path);
	if (closed == NULL)
		file =
		    open(path, O_WRONLY | O_APPEND | O_CREAT | O_CLOEXEC, 0600);
	if (file < 0)
		fprintf(stderr, "the history is not kept: %s: %s\n", path,
		    strerror(errno));
	read_history(path);
	free(closed);
	free(path);
}

void
typed_add(const char *line)
{
	HIST_ENTRY *last = history_length > 0
			       ? history_get(history_base + history_length - 1)
			       : NULL;
	if (line[strspn(line, " \t")] == '\0' ||
	    (last != NULL && strcmp(last->line, line) == 0))
		return;
	add_history(line);
	if (file < 0)
		return;
	char *whole = xasprintf("%s\n", line);
	size_t n = strlen(whole);
	if (write(file, whole, n) != (ssize_t)n) {
		fprintf(stderr, "the history is no longer kept: %s\n",
		    strerror(errno));
		close(file);
		file = -1;
	}
	free(whole);
}

void
typed_close(void)
{
	if (file >= 0)
		close(file);
	file = -1;
	opened = false;
}

bool
typed_is_open(void)
{
	return opened;
}

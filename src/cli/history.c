/* The file of typed lines.  It is only appended to, one line per write.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/history.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <readline/history.h>

#include "base/tr.h"
#include "base/xalloc.h"
#include "io/fs/file.h"
#include "io/fs/xdg.h"

/* Lines held in memory; the file may have more. */
enum { MOST = 5000 };

static char *path; /* NULL: it is not kept */
static bool opened;

static void
stop_saving_history(const char *why)
{
	fprintf(stderr, tr("the history cannot be saved: %s\n"), why);
	free(path);
	path = NULL;
}

static void
append_to_history_file(const char *bytes)
{
	struct error error = {0};
	if (path != NULL && !file_append_bytes(path, FILE_PRIVATE, bytes,
				strlen(bytes), &error))
		stop_saving_history(error.text);
}

void
typed_history_open(bool with_file)
{
	opened = true;
	using_history();
	stifle_history(MOST);
	if (!with_file)
		return;
	path = xdg_user_file_path("XDG_STATE_HOME", ".local/state", "history");
	if (path == NULL) {
		stop_saving_history(tr("HOME is not set"));
		return;
	}
	free(xdg_make_parent_folders(path));
	read_history(path);
	append_to_history_file("");
}

void
typed_history_add(const char *line)
{
	HIST_ENTRY *last = history_length > 0
			       ? history_get(history_base + history_length - 1)
			       : NULL;
	if (line[strspn(line, " \t")] == '\0' ||
	    (last != NULL && strcmp(last->line, line) == 0))
		return;
	add_history(line);
	FREED char *whole = xasprintf("%s\n", line);
	append_to_history_file(whole);
}

void
typed_history_close(void)
{
	free(path);
	path = NULL;
	opened = false;
}

bool
typed_history_is_open(void)
{
	return opened;
}

/* Finds a manual page and passes it to man(1).
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/manpage.h"

#include <limits.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/xalloc.h"

/* Returns the path of a page in the folder man beside the program or, for a
 * page that is not generated, beside the program's folder.  Returns NULL if
 * there is none, or if the path has a quote and so could not be given to a
 * shell.  The caller frees it. */
static char *
manpage_beside_program(const char *page)
{
	static const char *const FOLDERS[] = {"man", "../man"};
	char self[PATH_MAX];
	ssize_t n = readlink("/proc/self/exe", self, sizeof self - 1);
	if (n < 0)
		return NULL;
	self[n] = '\0';
	char *slash = strrchr(self, '/');
	if (slash == NULL || strchr(self, '\'') != NULL)
		return NULL;
	*slash = '\0';
	for (size_t i = 0; i < ARRAY_LEN(FOLDERS); i++) {
		char *path = xasprintf("%s/%s/%s", self, FOLDERS[i], page);
		if (access(path, R_OK) == 0)
			return path;
		free(path);
	}
	return NULL;
}

/* Runs a command in a shell and frees it.  Returns true if it succeeds. */
static bool
run_shell_command(char *command)
{
	bool ok = system(command) == 0;
	free(command);
	return ok;
}

bool
manpage_show(const char *page)
{
	char *beside = manpage_beside_program(page);
	if (beside != NULL) {
		bool shown =
		    run_shell_command(xasprintf("man -l '%s'", beside));
		free(beside);
		return shown;
	}
	int name = (int)strcspn(page, ".");
	const char *section = page + name + 1;
	return run_shell_command(xasprintf(
		   "man -w %s %.*s >/dev/null 2>&1", section, name, page)) &&
	       run_shell_command(xasprintf("man %s %.*s", section, name, page));
}

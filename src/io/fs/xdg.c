/* Makes the paths and folders of the user's files.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/fs/xdg.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "base/xalloc.h"

char *
xdg_user_file_path(const char *variable, const char *folder, const char *name)
{
	const char *base = getenv(variable), *home = getenv("HOME");
	/* The specification says to ignore a relative path. */
	if (base != NULL && base[0] == '/')
		return xasprintf("%s/tipspeed/%s", base, name);
	if (home == NULL || home[0] != '/')
		return NULL;
	return xasprintf("%s/%s/tipspeed/%s", home, folder, name);
}

char *
xdg_make_parent_folders(const char *path)
{
	char *folder = xstrdup(path);
	for (char *p = folder + 1; (p = strchr(p, '/')) != NULL; p++) {
		*p = '\0';
		if (mkdir(folder, 0700) != 0 && errno != EEXIST)
			return folder;
		*p = '/';
	}
	free(folder);
	return NULL;
}

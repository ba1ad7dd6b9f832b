/* Paths and folders of the user's own files.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "ui/home.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "base/xalloc.h"

char *
home_path(const char *variable, const char *folder, const char *name)
{
	const char *base = getenv(variable), *home = getenv("HOME");
	/* The specification says to pass over a relative path. */
	if (base != NULL && base[0] == '/')
		return xasprintf("%s/tipspeed/%s", base, name);
	if (home == NULL || home[0] != '/')
		return NULL;
	return xasprintf("%s/%s/tipspeed/%s", home, folder, name);
}

bool
home_make_folders(const char *path)
{
	char *copy = xstrdup(path);
	bool ok = true;
	for (char *p = strchr(copy + 1, '/'); ok && p != NULL;
	     p = strchr(p + 1, '/')) {
		*p = '\0';
		ok = mkdir(copy, 0700) == 0 || errno == EEXIST;
		*p = '/';
	}
	free(copy);
	return ok;
}

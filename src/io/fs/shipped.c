/* Finds the shipped files relative to the program, which may have been moved or
 * installed below another root, or else where it was configured to be
 * installed.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/fs/shipped.h"

#include <limits.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/text.h"
#include "base/xalloc.h"

/* Returns a folder beside that of the program, or NULL if it does not exist. */
static char *
folder_beside_program(const char *folder)
{
	char self[PATH_MAX];
	ssize_t n = readlink("/proc/self/exe", self, sizeof self - 1);
	self[n > 0 ? n : 0] = '\0';
	for (int up = 0; up < 2; up++) {
		char *slash = strrchr(self, '/');
		if (slash == NULL)
			return NULL;
		*slash = '\0';
	}
	char *path = xasprintf("%s/%s/", self, folder);
	if (access(path, R_OK) == 0)
		return path;
	free(path);
	return NULL;
}

char *
shipped_sites_folder(void)
{
	static const char TREE[] = "data/sites/";
	static const char *const BESIDE[] = {
	    "data/sites", "share/tipspeed/sites"};
	char *folder = access(TREE, R_OK) == 0 ? xstrdup(TREE) : NULL;
	for (size_t i = 0; folder == NULL && i < ARRAY_LEN(BESIDE); i++)
		folder = folder_beside_program(BESIDE[i]);
	return folder != NULL ? folder : xstrdup(SITES_DIR "/");
}

/* Returns a file in a folder relative to that of the sites. */
static char *
shipped_file_in_folder(const char *name, const char *from)
{
	if (strchr(name, '/') != NULL)
		return NULL;
	FREED char *slug = text_slug(name), *folder = shipped_sites_folder();
	char *path = xasprintf("%s%s%s.csv", folder, from, slug);
	if (access(path, R_OK) == 0)
		return path;
	free(path);
	return NULL;
}

char *
shipped_site_path(const char *name)
{
	return shipped_file_in_folder(name, "");
}

char *
shipped_energies_path(const char *name)
{
	return shipped_file_in_folder(name, "../energy/");
}

char *
shipped_example_path(const char *path)
{
	static const char DATA[] = "data/";
	if (strncmp(path, DATA, strlen(DATA)) != 0)
		return NULL;
	FREED char *folder = shipped_sites_folder();
	folder[strlen(folder) - strlen("sites/")] = '\0';
	char *file = xasprintf("%s%s", folder, path + strlen(DATA));
	if (access(file, R_OK) == 0)
		return file;
	free(file);
	return NULL;
}

/* Temporary file, fsync, rename.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/replace.h"

#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/xalloc.h"

/* All of it in the open file, and that on the disk.  Closes it. */
static bool
write_through(
    int fd, void (*write)(const void *data, FILE *out), const void *data)
{
	FILE *out = fdopen(fd, "w");
	if (out == NULL) {
		close(fd);
		return false;
	}
	write(data, out);
	bool good = fflush(out) == 0 && !ferror(out) && fsync(fd) == 0;
	int reason = errno;
	good = fclose(out) == 0 && good;
	errno = reason;
	return good;
}

/* A new file beside path with its rights, if it exists; -1 with errno. */
static int
open_beside(const char *path, const char *beside)
{
	struct stat about;
	bool there = stat(path, &about) == 0;
	/* A rename would put a file in the place of a folder or a device. */
	if (there && !S_ISREG(about.st_mode)) {
		errno = S_ISDIR(about.st_mode) ? EISDIR : EINVAL;
		return -1;
	}
	int fd = open(beside, O_WRONLY | O_CREAT | O_EXCL, 0666);
	if (fd >= 0 && there)
		fchmod(fd, about.st_mode & 0777);
	return fd;
}

bool
replace_file(const char *path, void (*write)(const void *data, FILE *out),
    const void *data, struct error *error)
{
	char *beside = xasprintf("%s.%ld.tmp", path, (long)getpid());
	int fd = open_beside(path, beside);
	bool made = fd >= 0;
	bool good =
	    made && write_through(fd, write, data) && rename(beside, path) == 0;
	int reason = errno;
	if (made && !good)
		unlink(beside);
	free(beside);
	if (good)
		return true;
	return error_at(error, ERROR_SYSTEM, path, 0, 0,
	    "cannot be saved: %s\n"
	    "check the folder, its rights and the room on the disk",
	    strerror(reason));
}

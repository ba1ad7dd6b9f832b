/* A program holds a lock on its file, which tells others that it is running,
 * even if all have the same process number, as in containers.  The lock of a
 * killed program is gone.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/fs/autosave_file.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/text.h"
#include "base/xalloc.h"
#include "io/fs/file.h"
#include "io/fs/xdg.h"

/* How many files of other runs are kept. */
enum { MOST = 5 };

struct autosave_file {
	char *path; /* NULL: no file yet */
	int fd;     /* open on it, with the lock, or -1 */
};

struct autosave_file *
autosave_file_new(void)
{
	struct autosave_file *kept = xcalloc(1, sizeof *kept);
	kept->fd = -1;
	return kept;
}

void
autosave_file_close(struct autosave_file *kept)
{
	if (kept->fd >= 0)
		close(kept->fd);
	kept->fd = -1;
	xfree_and_set(&kept->path, NULL);
}

void
autosave_file_free(struct autosave_file *kept)
{
	if (kept == NULL)
		return;
	autosave_file_close(kept);
	free(kept);
}

void
autosave_file_remove(struct autosave_file *kept)
{
	if (kept->path != NULL)
		unlink(kept->path);
	autosave_file_close(kept);
}

/* Reads `about` and `when` of a file.  Returns false for the file of a running
 * program, and for an empty one, which it removes. */
static bool
read_autosave_details(struct autosave_left *file)
{
	struct stat info;
	char head[200] = "";
	int fd =
	    open(file->path, O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK);
	if (fd < 0)
		return false;
	bool left = fstat(fd, &info) == 0 && S_ISREG(info.st_mode) &&
		    flock(fd, LOCK_SH | LOCK_NB) == 0;
	bool filled = left && read(fd, head, sizeof head - 1) > 2;
	if (left && !filled)
		unlink(file->path);
	close(fd);
	if (!filled)
		return false;
	head[strcspn(head, "\n")] = '\0';
	bool text = text_is_utf8(head, strlen(head));
	file->about = xstrdup(text ? head + 2 : "?");
	file->when = info.st_mtim;
	if (localtime(&file->when.tv_sec) == NULL) /* too far from now */
		file->when.tv_sec = 0;
	return true;
}

static int
compare_files_newer_first(const void *a, const void *b)
{
	const struct timespec *x = &((const struct autosave_left *)a)->when;
	const struct timespec *y = &((const struct autosave_left *)b)->when;
	if (x->tv_sec != y->tv_sec)
		return x->tv_sec < y->tv_sec ? 1 : -1;
	return (x->tv_nsec < y->tv_nsec) - (x->tv_nsec > y->tv_nsec);
}

struct autosave_left *
autosave_list_left_files(size_t *n)
{
	struct autosave_left *file = NULL;
	FREED char *folder =
	    xdg_user_file_path("XDG_STATE_HOME", ".local/state", "");
	DIR *dir = folder != NULL ? opendir(folder) : NULL;
	*n = 0;
	for (struct dirent *e; dir != NULL && (e = readdir(dir)) != NULL;) {
		if (strncmp(e->d_name, "session-", 8) != 0 ||
		    !text_ends_with(e->d_name, ".tip"))
			continue;
		struct autosave_left one = {
		    .path = xasprintf("%s%s", folder, e->d_name)};
		if (read_autosave_details(&one)) {
			file = xrealloc(file, *n + 1, sizeof *file);
			file[(*n)++] = one;
		} else {
			free(one.path);
		}
	}
	if (dir != NULL)
		closedir(dir);
	if (*n > 0)
		qsort(file, *n, sizeof *file, compare_files_newer_first);
	return file;
}

void
autosave_left_free(struct autosave_left *file, size_t n)
{
	for (size_t i = 0; i < n; i++) {
		free(file[i].path);
		free(file[i].about);
	}
	free(file);
}

static void
remove_oldest_autosaves(void)
{
	size_t n;
	struct autosave_left *file = autosave_list_left_files(&n);
	for (size_t i = MOST; i < n; i++)
		unlink(file[i].path);
	autosave_left_free(file, n);
}

/* Makes an empty file with a new name, which only the user can read.  It keeps
 * its permissions when it is replaced. */
static bool
make_autosave_file(struct autosave_file *kept, struct error *error)
{
	time_t now = time(NULL);
	int fd = -1;
	for (; fd < 0; now++) {
		char name[64], day[32];
		strftime(day, sizeof day, "%Y%m%d-%H%M%S", localtime(&now));
		snprintf(name, sizeof name, "session-%s-%ld.tip", day,
		    (long)getpid());
		xfree_and_set(&kept->path,
		    xdg_user_file_path("XDG_STATE_HOME", ".local/state", name));
		if (kept->path == NULL)
			return error_set(
			    error, ERROR_SYSTEM, "HOME is not set");
		FREED char *closed = xdg_make_parent_folders(kept->path);
		if (closed == NULL)
			fd = open(kept->path,
			    O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
		if (fd < 0 && (closed != NULL || errno != EEXIST))
			return error_set_at(error, ERROR_SYSTEM,
			    closed != NULL ? closed : kept->path, 0, 0, "%s",
			    strerror(errno));
	}
	kept->fd = fd;
	flock(fd, LOCK_EX);
	remove_oldest_autosaves();
	return true;
}

bool
autosave_file_write(struct autosave_file *kept,
    void (*write)(const void *data, FILE *out), const void *data,
    struct error *error)
{
	bool first = kept->fd < 0;
	if (first && !make_autosave_file(kept, error)) {
		autosave_file_close(kept);
		return false;
	}
	if (!file_replace_using_writer(
		kept->path, FILE_PRIVATE, write, data, error)) {
		if (first)
			autosave_file_remove(kept);
		return false;
	}
	int fd = open(kept->path, O_RDONLY | O_CLOEXEC);
	if (fd >= 0) {
		flock(fd, LOCK_EX);
		close(kept->fd);
		kept->fd = fd;
	}
	return true;
}

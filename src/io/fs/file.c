/* A file is replaced by these steps: temporary file, fsync, rename, fsync of
 * the folder.
 *
 * A temporary file is locked (flock) as long as its writer runs.  One without a
 * lock belongs to a writer that was killed, and can be removed.  Its name is
 * random, because process numbers recur, especially in containers.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#define _XOPEN_SOURCE 700 /* realpath */
#include "io/fs/file.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <inttypes.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/text.h"
#include "base/xalloc.h"

static const char PREFIX[] = ".tipspeed-", SUFFIX[] = ".tmp";

static bool
report_cannot_write(const char *path, int reason, struct error *error)
{
	return error_set(error, ERROR_SYSTEM,
	    "cannot write %s: %s\n"
	    "check the folder, its permissions and the free space",
	    path, strerror(reason));
}

bool
file_exists(const char *path)
{
	struct stat about;
	return stat(path, &about) == 0 && !S_ISDIR(about.st_mode);
}

const char *
file_name_without_folders(const char *path)
{
	const char *slash = strrchr(path, '/');
	return slash != NULL ? slash + 1 : path;
}

/* Returns the folder of a path, with its slash; "./" if it has none. */
static char *
folder_of_path(const char *path)
{
	size_t n = (size_t)(file_name_without_folders(path) - path);
	return n > 0 ? xstrndup(path, n) : xstrdup("./");
}

char *
file_real_folder(const char *path)
{
	FREED char *folder = folder_of_path(path);
	return realpath(folder, NULL);
}

/* Returns the path that a symbolic link points to, from the link's own folder;
 * NULL if path is not a link. */
static char *
symlink_target(const char *path)
{
	char to[4096];
	ssize_t n = readlink(path, to, sizeof to - 1);
	if (n < 0)
		return NULL;
	to[n] = '\0';
	if (to[0] == '/')
		return xstrdup(to);
	FREED char *folder = folder_of_path(path);
	return xasprintf("%s%s", folder, to);
}

/* Returns the file that a path leads to after all links; it need not exist. */
static char *
resolve_symlinks(const char *path)
{
	enum { MOST = 40 }; /* as many as the system follows */
	char *at = xstrdup(path), *next;
	for (int i = 0; i < MOST && (next = symlink_target(at)) != NULL; i++) {
		free(at);
		at = next;
	}
	return at;
}

/* A signal ends it, so that ^C works where nobody reads from a pipe. */
static bool
write_all_bytes(int fd, const char *bytes, size_t n)
{
	while (n > 0) {
		ssize_t written = write(fd, bytes, n);
		if (written < 0)
			return false;
		bytes += written;
		n -= (size_t)written;
	}
	return true;
}

/* Syncs a folder, because the name of a new file is on disk only then.  Some
 * file systems have nothing to sync there, and report EINVAL. */
static bool
sync_folder(const char *folder)
{
	int fd = open(folder, O_RDONLY | O_CLOEXEC | O_NOCTTY);
	if (fd < 0)
		return errno == EACCES;
	bool good = fsync(fd) == 0 || errno == EINVAL;
	int reason = errno;
	close(fd);
	errno = reason;
	return good;
}

/* Removes files left in the folder by writers that were killed. */
static void
remove_left_over_files(const char *folder)
{
	DIR *dir = opendir(folder);
	for (struct dirent *d; dir != NULL && (d = readdir(dir)) != NULL;) {
		if (strncmp(d->d_name, PREFIX, sizeof PREFIX - 1) != 0 ||
		    !text_ends_with(d->d_name, SUFFIX))
			continue;
		int fd = openat(dirfd(dir), d->d_name,
		    O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
		struct stat about;
		if (fd >= 0 && fstat(fd, &about) == 0 &&
		    S_ISREG(about.st_mode) && flock(fd, LOCK_EX | LOCK_NB) == 0)
			unlinkat(dirfd(dir), d->d_name, 0);
		if (fd >= 0)
			close(fd);
	}
	if (dir != NULL)
		closedir(dir);
}

/* Opens and locks a new file with a name of its own.  Returns -1 with errno on
 * failure.  Another program may remove it as left over before it is locked;
 * then it makes another one. */
static int
open_new_locked_file(const char *folder, mode_t rights, char **name)
{
	for (;;) {
		uint64_t random;
		if (getrandom(&random, sizeof random, 0) !=
		    (ssize_t)sizeof random)
			return -1;
		*name = xasprintf(
		    "%s%s%016" PRIx64 "%s", folder, PREFIX, random, SUFFIX);
		int fd = open(*name,
		    O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC,
		    rights);
		struct stat about;
		if (fd >= 0)
			flock(fd, LOCK_EX);
		if (fd >= 0 && fstat(fd, &about) == 0 && about.st_nlink > 0)
			return fd;
		int reason = errno;
		if (fd >= 0)
			close(fd);
		xfree_and_set(name, NULL);
		if (fd < 0 && reason != EEXIST && reason != EINTR) {
			errno = reason;
			return -1;
		}
	}
}

/* Gives a file the owner and the permissions of the one it replaces, which the
 * umask may have changed.  Only root can change the owner. */
static bool
copy_owner_and_mode(int fd, const struct stat *old)
{
	struct stat about;
	if (fstat(fd, &about) != 0)
		return false;
	bool same = about.st_uid == old->st_uid && about.st_gid == old->st_gid;
	if (!same && fchown(fd, old->st_uid, old->st_gid) != 0)
		errno = 0;
	return fchmod(fd, old->st_mode & 0777) == 0;
}

/* Writes a new file and renames it to path.  old: about the existing file, or
 * NULL.  Returns false with errno on failure. */
static bool
write_file_and_rename(const char *path, const struct stat *old,
    enum file_rights rights, const char *bytes, size_t n)
{
	char *folder = folder_of_path(path), *name = NULL;
	mode_t mode = old != NULL ? old->st_mode & 0777 : rights;
	remove_left_over_files(folder);
	int fd = open_new_locked_file(folder, mode, &name);
	/* Renamed before it is closed, as closing gives up the lock.  Once it
	 * is synced, close has nothing more to report. */
	bool good = fd >= 0 && (old == NULL || copy_owner_and_mode(fd, old)) &&
		    write_all_bytes(fd, bytes, n) && fsync(fd) == 0 &&
		    rename(name, path) == 0;
	int reason = errno;
	if (fd >= 0 && !good)
		unlink(name);
	if (fd >= 0)
		close(fd);
	if (good && !sync_folder(folder)) {
		good = false;
		reason = errno;
	}
	free(folder);
	free(name);
	errno = reason;
	return good;
}

/* Returns false with errno if the path is a folder or cannot be looked up.
 * *there: it exists. */
static bool
stat_file_to_write(const char *path, struct stat *about, bool *there)
{
	*there = stat(path, about) == 0;
	if (*there && S_ISDIR(about->st_mode))
		errno = EISDIR;
	return *there ? !S_ISDIR(about->st_mode) : errno == ENOENT;
}

/* Returns the standard stream that goes to the file, as with > /dev/stdout in a
 * script whose output is redirected, or NULL.  To replace that file would lose
 * what was printed, and to append at its end would be overwritten. */
static FILE *
find_standard_stream(const char *path)
{
	FILE *const streams[] = {stdout, stderr};
	struct stat file, out;
	bool there = stat(path, &file) == 0 && S_ISREG(file.st_mode);
	for (size_t i = 0; there && i < ARRAY_LEN(streams); i++)
		if (fstat(fileno(streams[i]), &out) == 0 &&
		    file.st_dev == out.st_dev && file.st_ino == out.st_ino)
			return streams[i];
	return NULL;
}

bool
file_replace_contents(const char *path, enum file_rights rights,
    const char *bytes, size_t n, struct error *error)
{
	struct stat about;
	bool there;
	if (!stat_file_to_write(path, &about, &there))
		return report_cannot_write(path, errno, error);
	if (there &&
	    (!S_ISREG(about.st_mode) || find_standard_stream(path) != NULL))
		return file_append_bytes(path, rights, bytes, n, error);
	/* A rename checks only the permissions of the folder. */
	if (there && access(path, W_OK) != 0)
		return report_cannot_write(path, errno, error);
	FREED char *target = resolve_symlinks(path);
	sigset_t all, before;
	sigfillset(&all);
	sigprocmask(SIG_BLOCK, &all, &before);
	bool good = write_file_and_rename(
	    target, there ? &about : NULL, rights, bytes, n);
	int reason = errno;
	sigprocmask(SIG_SETMASK, &before, NULL);
	return good || report_cannot_write(path, reason, error);
}

bool
file_check_csv_name(const char *path, struct error *error)
{
	static const char *const ENDS[] = {".ods", ".xls", ".xlsb", ".xlsm",
	    ".xlsx", ".json", ".md", ".html", ".pdf", ".svg", ".png"};
	const size_t n = ARRAY_LEN(ENDS);
	return text_file_ending(path, ENDS, n) == n ||
	       error_set(error, ERROR_USAGE,
		   "expected a file name that ends in .csv, got %s\n"
		   "this command writes CSV, which spreadsheet programs open; "
		   "results go to > FILE",
		   path);
}

bool
file_replace_using_writer(const char *path, enum file_rights rights,
    void (*write)(const void *data, FILE *out), const void *data,
    struct error *error)
{
	FREED char *text = NULL;
	size_t n = 0;
	FILE *memory = text_open_memory(&text, &n);
	write(data, memory);
	return fclose(memory) == 0
		   ? file_replace_contents(path, rights, text, n, error)
		   : report_cannot_write(path, ENOMEM, error);
}

/* Appends to an open file.  If the disk is full, what was written is cut off
 * again, unless somebody else has appended meanwhile. */
static bool
append_bytes_or_undo(int fd, const char *bytes, size_t n)
{
	struct stat before, after;
	if (fstat(fd, &before) != 0)
		return false;
	bool file = S_ISREG(before.st_mode);
	if (write_all_bytes(fd, bytes, n) && (!file || fsync(fd) == 0))
		return true;
	int reason = errno;
	if (file && fstat(fd, &after) == 0 && after.st_size > before.st_size &&
	    after.st_size <= before.st_size + (off_t)n &&
	    ftruncate(fd, before.st_size) != 0)
		reason = errno;
	errno = reason;
	return false;
}

bool
file_append_bytes(const char *path, enum file_rights rights, const char *bytes,
    size_t n, struct error *error)
{
	FILE *stream = find_standard_stream(path);
	if (stream != NULL)
		return (fflush(stream) == 0 &&
			   write_all_bytes(fileno(stream), bytes, n)) ||
		       report_cannot_write(path, errno, error);
	int fd = open(
	    path, O_WRONLY | O_APPEND | O_CREAT | O_CLOEXEC | O_NOCTTY, rights);
	bool good = fd >= 0 && append_bytes_or_undo(fd, bytes, n);
	int reason = errno;
	if (fd >= 0)
		close(fd);
	return good || report_cannot_write(path, reason, error);
}

const char FILE_SHEET_ENDINGS[] = ".csv .tsv .txt .xlsx .ods";

bool
file_has_sheet_ending(const char *path)
{
	FREED char *folded = text_fold_case_and_accents(path);
	const char *end = strrchr(folded, '.');
	size_t i;
	return end != NULL &&
	       text_find_word_in_list(FILE_SHEET_ENDINGS, end, &i);
}

bool
file_check_writable(const char *path, bool append, struct error *error)
{
	struct stat about;
	bool there;
	if (!stat_file_to_write(path, &about, &there))
		return report_cannot_write(path, errno, error);
	FREED char *target = resolve_symlinks(path),
		   *folder = folder_of_path(target);
	bool in_place = there && (append || !S_ISREG(about.st_mode) ||
				     find_standard_stream(path) != NULL);
	bool ok = (!there || access(path, W_OK) == 0) &&
		  (in_place || access(folder, W_OK | X_OK) == 0);
	return ok || report_cannot_write(path, errno, error);
}

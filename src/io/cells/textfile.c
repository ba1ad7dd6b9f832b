/* Reads the bytes of a file and rejects those that are not text.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/cells/textfile.h"

#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/tr.h"
#include "base/xalloc.h"
#include "io/cells/encoding.h"
#include "io/fs/shipped.h"

/* Returns the offset of the first control character, such as NUL, or n. */
static size_t
offset_of_control_character(const char *text, size_t n)
{
	size_t i = 0;
	while (i < n && ((unsigned char)text[i] >= 0x20 ||
			    memchr("\t\n\r\f", text[i], 4) != NULL))
		i++;
	return i;
}

static char *
refuse_large_file(
    const char *path, double bytes, size_t most, struct error_list *errors)
{
	error_set_at(error_list_add_item(errors), ERROR_DATA, path, 0, 0,
	    "expected at most %d MB, got %.1f MB\n"
	    "a site file has a few kB: is this the right file?",
	    (int)(most / 1000000), bytes / 1e6);
	return NULL;
}

static char *
refuse_invalid_text(const char *path, const char *text, size_t bad,
    const char *what, struct error_list *errors)
{
	int line = 1, column = 1;
	for (size_t i = 0; i < bad; i++) {
		bool pair = text[i] == '\r' && text[i + 1] == '\n';
		if (text[i] == '\n' || (text[i] == '\r' && !pair)) {
			line++;
			column = 1;
		} else if ((text[i] & 0xC0) != 0x80) {
			column++;
		}
	}
	error_set_at(error_list_add_item(errors), ERROR_DATA, path, line,
	    column,
	    "%s\n"
	    "save the spreadsheet as .xlsx, .ods or \"CSV UTF-8\"",
	    tr(what));
	return NULL;
}

char *
textfile_decode(const char *path, const char *bytes, size_t n,
    const char **note, struct error_list *errors)
{
	*note = "";
	if (n > 3 && memcmp(bytes, "PK\3\4", 4) == 0)
		return refuse_invalid_text(path, bytes, 0,
		    N_("expected text, got a workbook (.xlsx, .ods)"), errors);
	struct decoded d = encoding_decode(bytes, n);
	size_t control = offset_of_control_character(d.text, d.n);
	char *text = NULL;
	if (control < d.n)
		refuse_invalid_text(path, d.text, control,
		    N_("expected text, got a binary file"), errors);
	else if (d.wrong != NULL)
		refuse_invalid_text(path, d.text, d.bad, d.wrong, errors);
	else if (d.text[strspn(d.text, " \t\r\n")] == '\0')
		error_set_at(error_list_add_item(errors), ERROR_DATA, path, 1,
		    1,
		    "expected text, got an empty file\n"
		    "save it again in the program that wrote it");
	else
		text = encoding_to_nfc(d.text);
	if (d.encoding == ENCODING_1252)
		*note =
		    tr("read as Windows-1252: check names and units such as "
		       "å and µ");
	free(d.text);
	return text;
}

/* Reads to the end, or until there are more than `most` bytes, in growing
 * pieces, because the size of a pipe is not known.  Returns NULL with errno set
 * if the system refuses. */
static char *
read_bytes_to_end(FILE *file, size_t most, size_t *n)
{
	char *bytes = NULL;
	*n = 0;
	for (size_t got = 1, room = 0; got > 0 && *n <= most; *n += got) {
		if (*n == room) {
			room = room * 2 + 16384;
			bytes = xrealloc(bytes, room, 1);
		}
		got = fread(bytes + *n, 1, room - *n, file);
	}
	if (!ferror(file))
		return bytes;
	int reason = errno;
	free(bytes);
	errno = reason;
	return NULL;
}

char *
textfile_hint_after_failed_open(const char *path)
{
	FREED char *example = shipped_example_path(path);
	return example != NULL
		   ? xasprintf(
			 tr("the file that the examples use is %s"), example)
		   : xstrdup(tr("check the name (quote names with spaces), the "
				"folder and its permissions"));
}

static char *
report_unreadable_file(
    const char *path, const char *why, struct error_list *errors)
{
	bool several = errno == EISDIR || strpbrk(path, "*?") != NULL;
	FREED char *hint = textfile_hint_after_failed_open(path);
	error_set_at(error_list_add_item(errors), ERROR_SYSTEM, path, 0, 0,
	    "cannot read: %s\n%s", why,
	    several ? tr("name each file, or let the shell expand the "
			 "pattern: tipspeed FOLDER/*.csv")
		    : hint);
	return NULL;
}

/* Returns true if there is something to read, or the end of the file. */
static bool
wait_until_pipe_is_readable(int fd, const char **why)
{
	enum { PATIENCE_MS = 60000 };
	struct pollfd in = {.fd = fd, .events = POLLIN};
	int got = poll(&in, 1, PATIENCE_MS);
	*why = got < 0 ? strerror(errno)
		       : tr("nothing was written to this pipe for a minute");
	return got > 0;
}

static bool
is_null_device(const struct stat *about)
{
	struct stat null;
	return S_ISCHR(about->st_mode) && stat("/dev/null", &null) == 0 &&
	       about->st_rdev == null.st_rdev;
}

FILE *
textfile_open(const char *path, const char **why)
{
	struct stat about;
	FILE *file = NULL;
	/* Without O_NONBLOCK, open would wait for a pipe's writer for ever. */
	int fd = open(path, O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
	bool good = fd >= 0 && fstat(fd, &about) == 0;
	if (good && S_ISDIR(about.st_mode)) {
		good = false;
		errno = EISDIR;
	}
	*why = strerror(errno);
	if (good && S_ISFIFO(about.st_mode))
		good = wait_until_pipe_is_readable(fd, why);
	else if (good && !S_ISREG(about.st_mode) && !is_null_device(&about)) {
		good = false;
		*why = tr("expected a file or a pipe, got a device");
	}
	if (good &&
	    (fcntl(fd, F_SETFL, 0) != 0 || (file = fdopen(fd, "rb")) == NULL))
		*why = strerror(errno);
	int reason = errno;
	if (file == NULL && fd >= 0)
		close(fd);
	errno = reason;
	return file;
}

char *
textfile_read_bytes(const char *path, enum textfile_bytes most, size_t *n,
    struct error_list *errors)
{
	const char *why;
	FILE *file = textfile_open(path, &why);
	if (file == NULL)
		return report_unreadable_file(path, why, errors);
	struct stat about;
	char *bytes = NULL;
	if (fstat(fileno(file), &about) == 0 && S_ISREG(about.st_mode) &&
	    about.st_size > (off_t)most)
		refuse_large_file(path, (double)about.st_size, most, errors);
	else if ((bytes = read_bytes_to_end(file, most, n)) == NULL)
		report_unreadable_file(path, strerror(errno), errors);
	fclose(file);
	if (bytes == NULL || *n <= most)
		return bytes;
	free(bytes);
	return refuse_large_file(path, (double)*n, most, errors);
}

char *
textfile_read(
    const char *path, enum textfile_bytes most, struct error_list *errors)
{
	size_t n;
	const char *note;
	FREED char *bytes = textfile_read_bytes(path, most, &n, errors);
	return bytes != NULL ? textfile_decode(path, bytes, n, &note, errors)
			     : NULL;
}

char *
textfile_join_built_in_lines(const char *const *line)
{
	char *text = xstrdup("");
	for (; *line != NULL; line++)
		xappend(&text, "%s", *line);
	return text;
}

/* Unpacks parts of a zip file with libzip, within limits.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/cells/archive.h"

#include <stdlib.h>

#include <zip.h>

#include "base/tr.h"
#include "base/xalloc.h"

struct archive {
	zip_t *zip;
	size_t unpacked, most;
};

struct archive *
archive_open(const char *bytes, size_t n, size_t most, char **wrong)
{
	zip_error_t error;
	zip_error_init(&error);
	zip_source_t *source = zip_source_buffer_create(bytes, n, 0, &error);
	zip_t *zip = source != NULL
			 ? zip_open_from_source(source, ZIP_RDONLY, &error)
			 : NULL;
	struct archive *archive = NULL;
	if (zip != NULL) {
		archive = xcalloc(1, sizeof *archive);
		archive->zip = zip;
		archive->most = most;
	} else {
		*wrong = xstrdup(zip_error_strerror(&error));
		zip_source_free(source);
	}
	zip_error_fini(&error);
	return archive;
}

void
archive_close(struct archive *archive)
{
	if (archive == NULL)
		return;
	zip_discard(archive->zip);
	free(archive);
}

bool
archive_has_entry(const struct archive *archive, const char *name)
{
	return zip_name_locate(archive->zip, name, ZIP_FL_NOCASE) >= 0;
}

const char *
archive_entry_name(const struct archive *archive, size_t i)
{
	return zip_get_name(archive->zip, i, 0);
}

double
archive_unpacked_size(const struct archive *archive)
{
	double bytes = 0;
	zip_int64_t n = zip_get_num_entries(archive->zip, 0);
	for (zip_int64_t i = 0; i < n; i++) {
		zip_stat_t about;
		if (zip_stat_index(archive->zip, (zip_uint64_t)i, 0, &about) ==
			0 &&
		    (about.valid & ZIP_STAT_SIZE) != 0)
			bytes += (double)about.size;
	}
	return bytes;
}

/* Reads an entry to its end, whatever size the archive states.  Returns NULL if
 * it is damaged or exceeds the limit. */
static char *
unpack_entry_to_end(struct archive *archive, zip_file_t *file, size_t *n)
{
	char *bytes = NULL;
	zip_int64_t got = 1;
	*n = 0;
	for (size_t room = 0; got > 0 && archive->unpacked <= archive->most;) {
		if (*n == room) {
			room = room * 2 + 65536;
			bytes = xrealloc(bytes, room + 1, 1);
		}
		got = zip_fread(file, bytes + *n, room - *n);
		*n += got > 0 ? (size_t)got : 0;
		archive->unpacked += got > 0 ? (size_t)got : 0;
	}
	if (got == 0) {
		bytes[*n] = '\0';
		return bytes;
	}
	free(bytes);
	return NULL;
}

char *
archive_unpack_entry(
    struct archive *archive, const char *name, size_t *n, char **wrong)
{
	zip_int64_t at = zip_name_locate(archive->zip, name, ZIP_FL_NOCASE);
	zip_stat_t about;
	if (at < 0) {
		*wrong = xasprintf(tr("%s is missing"), name);
		return NULL;
	}
	if (zip_stat_index(archive->zip, (zip_uint64_t)at, 0, &about) == 0 &&
	    (about.valid & ZIP_STAT_ENCRYPTION_METHOD) != 0 &&
	    about.encryption_method != ZIP_EM_NONE) {
		*wrong = xasprintf(tr("%s has a password"), name);
		return NULL;
	}
	zip_file_t *file = zip_fopen_index(archive->zip, (zip_uint64_t)at, 0);
	char *bytes =
	    file != NULL ? unpack_entry_to_end(archive, file, n) : NULL;
	if (bytes == NULL && archive->unpacked > archive->most)
		*wrong = xasprintf(tr("more than %d MB unpacked"),
		    (int)(archive->most / 1000000));
	else if (bytes == NULL)
		*wrong = xasprintf("%s: %s", name,
		    file != NULL ? zip_file_strerror(file)
				 : zip_strerror(archive->zip));
	if (file != NULL)
		zip_fclose(file);
	return bytes;
}

/* A list of paths as they were given.  They are resolved only when compared, so
 * that links are recognised, and files that another program has replaced.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/session/files.h"

#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "base/text.h"
#include "base/tr.h"
#include "base/xalloc.h"
#include "io/fs/file.h"
#include "io/sitefile/site_write.h"

struct files {
	size_t n, uses;
	/* Each path has one of these for reading and one for writing. */
	struct use_of_file {
		char *path;
		size_t number;   /* of its last use, counting all uses */
		bool written;    /* otherwise read */
		bool has_digest; /* of what was read then */
		uint64_t digest;
	} * use;
	/* The script that holds the session, or NULL, and whether the session
	 * was saved to it. */
	char *holder;
	bool saved;
};

struct files *
files_new(void)
{
	return xcalloc(1, sizeof(struct files));
}

static struct use_of_file *
record_use_of_file(struct session *s, const char *path, bool written)
{
	struct files *f = s->files;
	size_t i = 0;
	while (i < f->n && (f->use[i].written != written ||
			       strcmp(f->use[i].path, path) != 0))
		i++;
	if (i == f->n) {
		f->use = xgrow_by_one(f->use, f->n++, sizeof *f->use);
		f->use[i] = (struct use_of_file){
		    .path = xstrdup(path), .written = written};
	}
	f->use[i].number = f->uses++;
	return &f->use[i];
}

bool
files_compute_digest(const char *path, uint64_t *digest)
{
	struct stat file;
	char piece[1 << 14];
	/* Reading from a FIFO would take its data away from the command. */
	FILE *in = stat(path, &file) == 0 && S_ISREG(file.st_mode)
		       ? fopen(path, "rb")
		       : NULL;
	if (in == NULL)
		return false;
	*digest = TEXT_DIGEST_START;
	for (size_t n; (n = fread(piece, 1, sizeof piece, in)) > 0;)
		*digest = text_fnv1a_digest(*digest, piece, n);
	bool good = !ferror(in);
	fclose(in);
	return good;
}

void
files_record_read(struct session *s, const char *path)
{
	struct use_of_file *use = record_use_of_file(s, path, false);
	use->has_digest = files_compute_digest(path, &use->digest);
}

size_t
files_count_all_uses(const struct session *s)
{
	return s->files->uses;
}

const char *
files_path_of_nth_read(const struct session *s, size_t number, uint64_t *digest)
{
	const struct use_of_file *use = s->files->use;
	for (size_t i = 0; i < s->files->n; i++, use++)
		if (use->number == number && use->has_digest) {
			*digest = use->digest;
			return use->path;
		}
	return NULL;
}

void
files_record_written(struct session *s, const char *path)
{
	record_use_of_file(s, path, true);
}

void
files_set_session_script_path(struct session *s, const char *path, bool saved)
{
	xfree_and_set(&s->files->holder, xstrdup(path));
	s->files->saved = saved;
	if (saved)
		files_record_written(s, path);
}

const char *
files_session_script_path(const struct session *s, bool *saved)
{
	if (saved != NULL)
		*saved = s->files->saved;
	return s->files->holder;
}

void
files_free(struct files *files)
{
	free(files->holder);
	for (size_t i = 0; i < files->n; i++)
		free(files->use[i].path);
	free(files->use);
	free(files);
}

static bool
is_path_of_same_file(const char *path, const struct stat *file)
{
	struct stat other;
	return path != NULL && stat(path, &other) == 0 &&
	       other.st_dev == file->st_dev && other.st_ino == file->st_ino;
}

/* True if the file is among those written or, if `written` is false, among
 * those read. */
static bool
is_file_in_read_or_written_list(
    const struct session *s, const struct stat *file, bool written)
{
	const struct files *f = s->files;
	for (size_t i = 0; i < f->n; i++)
		if (f->use[i].written == written &&
		    is_path_of_same_file(f->use[i].path, file))
			return true;
	return false;
}

bool
files_is_written(const struct session *s, const char *path)
{
	struct stat file;
	return stat(path, &file) == 0 &&
	       is_file_in_read_or_written_list(s, &file, true);
}

static bool
is_store_file(const struct session *s, const struct stat *file)
{
	static const char *const PARTS[] = {"", "-wal", "-shm"};
	bool same = false;
	for (size_t i = 0; i < ARRAY_LEN(PARTS); i++) {
		FREED char *path =
		    xasprintf("%s%s", store_path(s->store), PARTS[i]);
		same = same || is_path_of_same_file(path, file);
	}
	return same;
}

bool
files_may_write(
    const struct session *s, const char *path, bool append, struct error *error)
{
	struct stat file;
	if (stat(path, &file) != 0 || !S_ISREG(file.st_mode))
		return file_check_writable(path, append, error);
	bool store = is_store_file(s, &file);
	bool script =
	    is_path_of_same_file(files_session_script_path(s, NULL), &file);
	if (store || script || is_file_in_read_or_written_list(s, &file, false))
		return error_set(error, ERROR_SYSTEM,
		    store ? N_("%s is the store and cannot be overwritten by a "
			       "result\nuse another file name")
		    : script
			? N_("%s holds this session and cannot be overwritten "
			     "by a result\nuse another file name")
			: N_("%s was read by this session and cannot be "
			     "overwritten\nuse another file name"),
		    path);
	return file_check_writable(path, append, error);
}

bool
files_check_replace(
    const struct args *args, const char *path, struct error *error)
{
	struct stat info;
	return args->replace || stat(path, &info) != 0 ||
	       error_set(error, ERROR_USAGE,
		   "%s already exists\n"
		   "use replace=on to overwrite it",
		   path);
}

bool
files_may_overwrite(const struct session *s, const struct args *args,
    const char *path, struct error *error)
{
	return file_check_csv_name(path, error) &&
	       files_may_write(s, path, false, error) &&
	       files_check_replace(args, path, error);
}

bool
files_write_site(struct session *s, const struct args *args,
    const struct site *site, const char *path, struct error *error)
{
	size_t rows;
	if (!files_may_overwrite(s, args, path, error) ||
	    !site_save(site, path, &rows, error))
		return false;
	files_record_written(s, path);
	session_print_note(s, "wrote %s: %zu rows", path, rows);
	return true;
}

bool
files_confirm_replace(struct session *s, const char *path, struct error *error)
{
	struct stat file;
	if (s->hooks.confirm == NULL || s->scripts > s->typed_depth ||
	    stat(path, &file) != 0 || !S_ISREG(file.st_mode) ||
	    file.st_size == 0 ||
	    is_file_in_read_or_written_list(s, &file, true))
		return true;
	FREED char *question = xasprintf(tr("%s exists: replace it?"), path);
	bool yes = s->hooks.confirm(s, question, false);
	return yes || error_set(error, ERROR_USAGE,
			  "%s was not replaced\n"
			  "use another file name",
			  path);
}

/* Materials in and out of the store's file.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/store.h"

#include <errno.h>
#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "base/text.h"
#include "base/xalloc.h"
#include "io/home.h"
#include "io/store_schema.h"

/* memory: the one database of ":memory:", NULL for a file. */
struct store {
	char *path;
	bool own_folder; /* it may be made */
	sqlite3 *memory;
};

struct store *
store_new(const char *path)
{
	struct store *store = xcalloc(1, sizeof *store);
	store->own_folder = path == NULL;
	store->path = path != NULL ? xstrdup(path)
				   : home_path("XDG_DATA_HOME", ".local/share",
					 "store.db");
	if (store->path == NULL)
		store->path = xstrdup("");
	return store;
}

void
store_free(struct store *store)
{
	if (store == NULL)
		return;
	sqlite3_close(store->memory);
	free(store->path);
	free(store);
}

const char *
store_path(const struct store *store)
{
	return store->path;
}

int64_t
store_bytes(const struct store *store)
{
	struct stat file;
	return stat(store->path, &file) == 0 ? (int64_t)file.st_size : -1;
}

/* The folders above the file, for this user alone. */
static bool
make_folders(const char *path, struct error *error)
{
	char *closed = home_make_folders(path);
	if (closed == NULL)
		return true;
	error_at(error, ERROR_SYSTEM, closed, 0, 0,
	    "cannot create the store's folder: %s\n"
	    "check its permissions, or use another store: --store=PATH",
	    strerror(errno));
	free(closed);
	return false;
}

/* *db is NULL where there is nothing to read. */
static bool
begin(struct store *store, bool make, sqlite3 **db, struct error *error)
{
	*db = store->memory;
	if (*db != NULL)
		return true;
	if (store->path[0] == '\0')
		return error_set(error, ERROR_SYSTEM,
		    "no place for the store: HOME is not set\n"
		    "name a file with --store=PATH");
	if (make && store->own_folder && !make_folders(store->path, error))
		return false;
	if (!schema_open(store->path, make, db, error))
		return false;
	if (strcmp(store->path, ":memory:") == 0)
		store->memory = *db;
	return true;
}

static void
end(struct store *store, sqlite3 *db)
{
	if (db != store->memory)
		sqlite3_close(db);
}

/* "SELECT fold, digest, name, ..." or "INSERT ... VALUES (?, ?, ?, ...)": the
 * fields follow fold and digest. */
static char *
columns(const char *before, bool marks, const char *after)
{
	char *sql = xstrdup(before);
	for (size_t i = 0; i < FIELD_COUNT; i++)
		xappend(&sql, ", %s", marks ? "?" : FIELDS[i].name);
	xappend(&sql, "%s", after);
	return sql;
}

static const char *
column_text(sqlite3_stmt *stmt, int i)
{
	const char *text = (const char *)sqlite3_column_text(stmt, i);
	return text != NULL ? text : "";
}

static char *
digest_text(const struct stored *m)
{
	return xasprintf("%016" PRIx64, stored_digest(m));
}

/* A name as it can be read and typed, whoever made it: shown, and cut. */
static char *
label_of(const char *name)
{
	enum { MOST = 60 };
	char *label = text_shown(name);
	size_t n = strlen(label);
	for (n = n < MOST ? n : MOST; (label[n] & 0xC0) == 0x80;)
		n--;
	label[n] = '\0';
	for (char *p = label; (p = strchr(p, '"')) != NULL;)
		*p = '\'';
	return label;
}

/* False for a material that no import would take. */
static bool
check_fields(const struct stored *m, struct error *error)
{
	const struct field *f = FIELDS;
	while (f < FIELDS + FIELD_COUNT && stored_fits(m, f))
		f++;
	if (f == FIELDS + FIELD_COUNT)
		return true;
	char *label = label_of(m->name), *wanted = stored_wanted(m, f),
	     *found = stored_found(m, f);
	error_set(error, ERROR_DATA,
	    "material '%s', field %s: expected %s, got '%.60s'\n"
	    "correct the source of this material",
	    label, f->name, wanted, found);
	free(label);
	free(wanted);
	free(found);
	return false;
}

/* Whether a row is what was put.  It has its name also as fold, by which it is
 * found. */
static bool
check_row(const struct stored *m, const char *fold, const char *digest,
    struct error *error)
{
	char *of_name = text_fold(m->name), *of_row = digest_text(m);
	char *label = label_of(m->name);
	bool good = check_fields(m, error);
	if (good && (strcmp(of_name, fold) != 0 || strcmp(of_row, digest) != 0))
		good = error_set(error, ERROR_DATA,
		    "the store is damaged: '%s' is not what was remembered",
		    label);
	if (!good)
		error_hint(error, "run 'forget \"%s\"', then remember it again",
		    label);
	free(of_name);
	free(of_row);
	free(label);
	return good;
}

/* The row stmt stands on.  False when it is not what was put. */
static bool
take_row(const struct store *store, sqlite3_stmt *stmt, struct stored *m,
    struct error *error)
{
	*m = stored_new();
	for (int i = 0; i < FIELD_COUNT; i++) {
		const struct field *f = &FIELDS[i];
		bool none = sqlite3_column_type(stmt, i + 2) == SQLITE_NULL;
		if (f->kind == FIELD_TEXT)
			stored_set_text(m, f, column_text(stmt, i + 2));
		else if (f->kind == FIELD_NUMBER && !none)
			stored_set_number(
			    m, f, sqlite3_column_double(stmt, i + 2));
		else if (f->kind == FIELD_WHOLE && !none)
			stored_set_whole(
			    m, f, sqlite3_column_int64(stmt, i + 2));
		else if (f->kind >= FIELD_MODEL)
			stored_set_written(m, f, column_text(stmt, i + 2));
	}
	if (check_row(m, column_text(stmt, 0), column_text(stmt, 1), error))
		return true;
	if (error != NULL)
		error_place(error, store->path, 0, 0);
	stored_free(m);
	return false;
}

static bool
read_rows(struct store *store, sqlite3 *db, struct stored_list *list,
    struct error *error)
{
	char *sql = columns(
	    "SELECT fold, digest", false, " FROM material ORDER BY fold");
	sqlite3_stmt *stmt = NULL;
	int code = sqlite3_prepare_v2(db, sql, -1, &stmt, NULL);
	free(sql);
	bool ok = code == SQLITE_OK || schema_fail(db, store->path, error);
	while (ok && (code = sqlite3_step(stmt)) == SQLITE_ROW) {
		struct stored m;
		ok = take_row(store, stmt, &m, error);
		if (ok)
			stored_list_add(list, m);
	}
	if (ok && code != SQLITE_DONE)
		ok = schema_fail(db, store->path, error);
	sqlite3_finalize(stmt);
	return ok;
}

bool
store_list(struct store *store, struct stored_list *list, struct error *error)
{
	sqlite3 *db;
	if (!begin(store, false, &db, error))
		return false;
	bool ok = db == NULL || read_rows(store, db, list, error);
	end(store, db);
	return ok;
}

bool
store_list_all(
    struct store *store, struct stored_list *list, struct error *error)
{
	if (!store_list(store, list, error))
		return false;
	stored_table3(list);
	return true;
}

static void
bind_text(sqlite3_stmt *stmt, int i, const char *text)
{
	sqlite3_bind_text(stmt, i, text, -1, SQLITE_TRANSIENT);
}

/* What is not known stays NULL. */
static void
bind_row(sqlite3_stmt *stmt, const struct stored *m)
{
	char *fold = text_fold(m->name), *digest = digest_text(m);
	sqlite3_reset(stmt);
	sqlite3_clear_bindings(stmt);
	bind_text(stmt, 1, fold);
	bind_text(stmt, 2, digest);
	for (int i = 0; i < FIELD_COUNT; i++) {
		const struct field *f = &FIELDS[i];
		if (f->kind == FIELD_TEXT)
			bind_text(stmt, i + 3, stored_text(m, f));
		else if (f->kind == FIELD_NUMBER &&
			 isfinite(stored_number(m, f)))
			sqlite3_bind_double(stmt, i + 3, stored_number(m, f));
		else if (f->kind == FIELD_WHOLE && stored_whole(m, f) >= 0)
			sqlite3_bind_int64(stmt, i + 3, stored_whole(m, f));
		if (f->kind < FIELD_MODEL)
			continue;
		char *text = stored_written(m, f);
		bind_text(stmt, i + 3, text);
		free(text);
	}
	free(fold);
	free(digest);
}

static bool
put_row(struct store *store, sqlite3 *db, sqlite3_stmt *stmt,
    const struct stored *m, struct error *error)
{
	bind_row(stmt, m);
	if (sqlite3_step(stmt) == SQLITE_DONE)
		return true;
	if ((sqlite3_errcode(db) & 0xFF) != SQLITE_CONSTRAINT)
		return schema_fail(db, store->path, error);
	return error_set(error, ERROR_USAGE,
	    "the store has a material '%s' already\n"
	    "choose another name, or replace it with replace=on",
	    m->name);
}

static bool
put_rows(struct store *store, sqlite3 *db, const struct stored *item, size_t n,
    bool replace, struct error *error)
{
	char *head = columns(replace ? "INSERT OR REPLACE INTO material "
				       "(fold, digest"
				     : "INSERT INTO material (fold, digest",
	    false, ") VALUES (?, ?");
	char *sql = columns(head, true, ")");
	sqlite3_stmt *stmt = NULL;
	int code = sqlite3_prepare_v2(db, sql, -1, &stmt, NULL);
	bool ok = code == SQLITE_OK || schema_fail(db, store->path, error);
	for (size_t i = 0; ok && i < n; i++)
		ok = check_fields(&item[i], error) &&
		     put_row(store, db, stmt, &item[i], error);
	sqlite3_finalize(stmt);
	free(head);
	free(sql);
	return ok;
}

/* Ends a transaction: keeps it all, or nothing when ok is false. */
static bool
commit(struct store *store, sqlite3 *db, bool ok, struct error *error)
{
	ok = ok && schema_run(db, store->path, "COMMIT", error);
	if (!ok)
		sqlite3_exec(db, "ROLLBACK", NULL, NULL, NULL);
	return ok;
}

bool
store_put(struct store *store, const struct stored *item, size_t n,
    bool replace, struct error *error)
{
	sqlite3 *db;
	if (!begin(store, true, &db, error))
		return false;
	bool ok = schema_run(db, store->path, "BEGIN IMMEDIATE", error);
	if (ok) {
		ok = put_rows(store, db, item, n, replace, error);
		ok = commit(store, db, ok, error);
	}
	end(store, db);
	return ok;
}

/* The fold of the row whose name is shown so, which the caller frees; NULL if
 * there is none. */
static char *
fold_shown_as(sqlite3 *db, const char *name)
{
	sqlite3_stmt *stmt = NULL;
	char *fold = NULL;
	sqlite3_prepare_v2(
	    db, "SELECT fold, name FROM material", -1, &stmt, NULL);
	while (fold == NULL && sqlite3_step(stmt) == SQLITE_ROW) {
		char *label = label_of(column_text(stmt, 1));
		if (text_same(label, name))
			fold = xstrdup(column_text(stmt, 0));
		free(label);
	}
	sqlite3_finalize(stmt);
	return fold;
}

/* *n: how many rows went. */
static bool
delete_row(struct store *store, sqlite3 *db, const char *fold, int *n,
    struct error *error)
{
	sqlite3_stmt *stmt = NULL;
	sqlite3_prepare_v2(
	    db, "DELETE FROM material WHERE fold = ?", -1, &stmt, NULL);
	if (stmt != NULL)
		bind_text(stmt, 1, fold);
	bool ok = sqlite3_step(stmt) == SQLITE_DONE ||
		  schema_fail(db, store->path, error);
	sqlite3_finalize(stmt);
	*n = ok ? sqlite3_changes(db) : 0;
	return ok;
}

/* By name, else by what errors call it. */
static bool
forget_row(
    struct store *store, sqlite3 *db, const char *name, struct error *error)
{
	int n;
	char *fold = text_fold(name);
	bool ok = delete_row(store, db, fold, &n, error);
	free(fold);
	fold = ok && n == 0 ? fold_shown_as(db, name) : NULL;
	if (fold != NULL)
		ok = delete_row(store, db, fold, &n, error);
	free(fold);
	if (!ok || n > 0)
		return ok;
	return error_set(error, ERROR_USAGE,
	    "the store has no material '%s'\n"
	    "run 'materials origin=own' to list its materials",
	    name);
}

bool
store_forget(struct store *store, const char *name, struct error *error)
{
	sqlite3 *db;
	if (!begin(store, false, &db, error))
		return false;
	if (db == NULL)
		return error_set(error, ERROR_USAGE,
		    "the store has no material '%s'\n"
		    "run 'remember' first: the store is empty",
		    name);
	bool ok = forget_row(store, db, name, error);
	end(store, db);
	return ok;
}

/* SQLite, set up so that a kill at any moment loses nothing that was said to be
 * stored: a write-ahead log, synced at every commit.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/store_schema.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#include "base/text.h"
#include "base/xalloc.h"
#include "config.h"

/* How long to wait for another program. */
enum { WAIT_MS = 5000, PAUSE_MS = 20 };

/* fold: the name without case and accents.  digest: of the row, see
 * stored_digest.  about: the program that made this schema. */
const char *const SCHEMA_STEPS[STORE_SCHEMA] = {
    "CREATE TABLE about (program TEXT NOT NULL);CREATE TABLE material ( fold "
    "TEXT PRIMARY KEY NOT NULL, digest TEXT NOT NULL, name TEXT NOT NULL, site "
    "TEXT NOT NULL, rock TEXT, top_size_mm REAL, machine TEXT, provenance "
    "TEXT, site_digest TEXT, origin TEXT NOT NULL, beta1 REAL NOT NULL, beta2 "
    "REAL NOT NULL, beta3 REAL NOT NULL, beta4 REAL NOT NULL, f_mat REAL NOT "
    "NULL, e0_min REAL NOT NULL, alpha REAL NOT NULL, method TEXT NOT NULL, "
    "appearance TEXT NOT NULL, k REAL NOT NULL, misfit REAL, rmse_pct REAL, "
    "holdout_pct REAL, seed INTEGER, options TEXT, generations INTEGER, stop "
    "TEXT, date TEXT, note TEXT, version TEXT);",
    "ALTER TABLE material ADD COLUMN train_mps TEXT;",
    "ALTER TABLE material ADD COLUMN model TEXT NOT NULL DEFAULT 'grunditz';"
    "ALTER TABLE material ADD COLUMN params TEXT NOT NULL DEFAULT '';"
    "UPDATE material SET params = 'beta1=' || exact(beta1) || ' beta2=' || "
    "exact(beta2) || ' beta3=' || exact(beta3) || ' beta4=' || exact(beta4) || "
    "' f_mat=' || exact(f_mat) || ' e0_min=' || exact(e0_min) || ' alpha=' || "
    "exact(alpha);"
    "ALTER TABLE material DROP COLUMN beta1;"
    "ALTER TABLE material DROP COLUMN beta2;"
    "ALTER TABLE material DROP COLUMN beta3;"
    "ALTER TABLE material DROP COLUMN beta4;"
    "ALTER TABLE material DROP COLUMN f_mat;"
    "ALTER TABLE material DROP COLUMN e0_min;"
    "ALTER TABLE material DROP COLUMN alpha;"};

/* exact(number): the shortest text that reads back the same, for the steps. */
static void
exact(sqlite3_context *context, int n, sqlite3_value **value)
{
	char number[32];
	(void)n;
	sqlite3_result_text(context,
	    text_exact(sqlite3_value_double(value[0]), number), -1,
	    SQLITE_TRANSIENT);
}

/* The kind of error, its words and the next step, by SQLite's result code. */
static const struct problem {
	int code;
	enum error_kind kind;
	const char *text, *hint;
} PROBLEMS[] = {
    {SQLITE_BUSY, ERROR_SYSTEM,
	"another program is using the store and did not release it within 5 s",
	"try again; this session keeps its data"},
    {SQLITE_LOCKED, ERROR_SYSTEM, "the store is in use",
	"try again; this session keeps its data"},
    {SQLITE_READONLY, ERROR_SYSTEM, "the store cannot be written to",
	"check the permissions of the file and its folder, or use another with "
	"--store=PATH"},
    {SQLITE_PERM, ERROR_SYSTEM, "the store cannot be opened",
	"check the permissions of the file and its folder"},
    {SQLITE_CANTOPEN, ERROR_SYSTEM, "the store cannot be opened",
	"check the name, the folder and its permissions, or use another with "
	"--store=PATH"},
    {SQLITE_FULL, ERROR_SYSTEM, "the store cannot grow: the disk is full",
	"free some space and try again; this session keeps its data"},
    {SQLITE_IOERR, ERROR_SYSTEM, "the store cannot be read or written",
	"check the disk and its free space; this session keeps its data"},
    {SQLITE_CORRUPT, ERROR_DATA, "the store is damaged",
	"move the file away, and import the newest export into a new one"},
    {SQLITE_NOTADB, ERROR_DATA,
	"this is not a store of tipspeed, or it is damaged",
	"move the file away, or use another with --store=PATH"}};

bool
schema_fail(sqlite3 *db, const char *path, struct error *error)
{
	int code = db != NULL ? sqlite3_errcode(db) & 0xFF : SQLITE_NOMEM;
	int reason = db != NULL ? sqlite3_system_errno(db) : 0;
	for (size_t i = 0; i < ARRAY_LEN(PROBLEMS); i++) {
		const struct problem *p = &PROBLEMS[i];
		if (p->code != code)
			continue;
		/* SQLite tries a file it may not make once more without making
		 * it, and then misses it: ENOENT says too little. */
		bool why = reason != 0 && reason != ENOENT &&
			   p->kind == ERROR_SYSTEM && code != SQLITE_BUSY;
		return error_at(error, p->kind, path, 0, 0, "%s%s%s\n%s",
		    p->text, why ? ": " : "", why ? strerror(reason) : "",
		    p->hint);
	}
	return error_at(error, ERROR_SYSTEM, path, 0, 0, "the store fails: %s",
	    db != NULL ? sqlite3_errmsg(db) : "no memory");
}

bool
schema_run(sqlite3 *db, const char *path, const char *sql, struct error *error)
{
	return sqlite3_exec(db, sql, NULL, NULL, NULL) == SQLITE_OK ||
	       schema_fail(db, path, error);
}

/* The first value of the first row as text, which the caller frees; NULL
 * without a row or after a failure. */
static char *
ask(sqlite3 *db, const char *sql)
{
	sqlite3_stmt *stmt = NULL;
	char *text = NULL;
	if (sqlite3_prepare_v2(db, sql, -1, &stmt, NULL) == SQLITE_OK &&
	    sqlite3_step(stmt) == SQLITE_ROW)
		text =
		    xstrdup(sqlite3_column_type(stmt, 0) == SQLITE_NULL
				? ""
				: (const char *)sqlite3_column_text(stmt, 0));
	sqlite3_finalize(stmt);
	return text;
}

/* A whole number; -1 after a failure. */
static long
ask_whole(sqlite3 *db, const char *sql)
{
	char *text = ask(db, sql);
	long value = text != NULL ? strtol(text, NULL, 10) : -1;
	free(text);
	return value;
}

/* A file that is written is in WAL mode from then on.  To change the mode takes
 * the whole file, and SQLite does not wait for that by itself. */
static bool
use_wal(sqlite3 *db, const char *path, struct error *error)
{
	const struct timespec pause = {0, PAUSE_MS * 1000000L};
	for (int waited = 0;; waited += PAUSE_MS) {
		char *mode = ask(db, "PRAGMA journal_mode = WAL");
		bool done = mode != NULL && (strcmp(mode, "wal") == 0 ||
						strcmp(mode, "memory") == 0);
		bool busy =
		    mode == NULL && (sqlite3_errcode(db) & 0xFF) == SQLITE_BUSY;
		free(mode);
		if (done)
			return true;
		if (!busy || waited >= WAIT_MS)
			return schema_fail(db, path, error);
		nanosleep(&pause, NULL);
	}
}

/* Within a transaction: the version is asked anew, as another program may have
 * done the work meanwhile. */
static bool
run_steps(sqlite3 *db, const char *path, struct error *error)
{
	long version = ask_whole(db, "PRAGMA user_version");
	if (version < 0)
		return schema_fail(db, path, error);
	for (long i = version; i < STORE_SCHEMA; i++)
		if (!schema_run(db, path, SCHEMA_STEPS[i], error))
			return false;
	if (version >= STORE_SCHEMA)
		return true;
	char *end = sqlite3_mprintf(
	    "DELETE FROM about;INSERT INTO about VALUES (%Q);PRAGMA "
	    "application_id = %d;PRAGMA user_version = %d;",
	    "tipspeed " PACKAGE_VERSION, (int)SCHEMA_APPLICATION,
	    (int)STORE_SCHEMA);
	bool ok = schema_run(db, path, end, error);
	sqlite3_free(end);
	return ok;
}

static bool
migrate(sqlite3 *db, const char *path, struct error *error)
{
	if (!schema_run(db, path, "BEGIN IMMEDIATE", error))
		return false;
	if (run_steps(db, path, error) && schema_run(db, path, "COMMIT", error))
		return true;
	sqlite3_exec(db, "ROLLBACK", NULL, NULL, NULL);
	return false;
}

/* Every page and every index; stores are small. */
static bool
check_integrity(sqlite3 *db, const char *path, struct error *error)
{
	char *found = ask(db, "PRAGMA integrity_check(1)");
	bool ok = found != NULL && strcmp(found, "ok") == 0;
	if (found == NULL)
		schema_fail(db, path, error);
	else if (!ok)
		error_at(error, ERROR_DATA, path, 0, 0,
		    "the store is damaged: %.200s\n"
		    "move the file away, and import the newest export into a "
		    "new one",
		    found);
	free(found);
	return ok;
}

static bool
refuse_newer(sqlite3 *db, const char *path, long version, struct error *error)
{
	char *program = ask(db, "SELECT program FROM about");
	error_at(error, ERROR_DATA, path, 0, 0,
	    "the store was written by %.60s (schema %ld); this is tipspeed %s, "
	    "which reads schemas up to %d\n"
	    "use that program, or another store with --store=PATH",
	    program != NULL ? program : "a newer tipspeed", version,
	    PACKAGE_VERSION, (int)STORE_SCHEMA);
	free(program);
	return false;
}

/* What the file is: *version 0 for an empty one. */
static bool
look(sqlite3 *db, const char *path, long *version, struct error *error)
{
	if (sqlite3_errcode(db) != SQLITE_OK)
		return schema_fail(db, path, error);
	long tables = ask_whole(db, "SELECT count(*) FROM sqlite_master");
	if (tables < 0)
		return schema_fail(db, path, error);
	long application = ask_whole(db, "PRAGMA application_id");
	*version = ask_whole(db, "PRAGMA user_version");
	bool fresh = tables == 0 && application == 0 && *version == 0;
	if (!fresh && (application != SCHEMA_APPLICATION || *version <= 0))
		return error_at(error, ERROR_DATA, path, 0, 0,
		    "expected a store of tipspeed, got a database of another "
		    "program\n"
		    "use another file with --store=PATH");
	if (*version > STORE_SCHEMA)
		return refuse_newer(db, path, *version, error);
	return fresh || check_integrity(db, path, error);
}

static sqlite3 *
connect(const char *path, bool make)
{
	sqlite3 *db = NULL;
	int flags = SQLITE_OPEN_READWRITE | (make ? SQLITE_OPEN_CREATE : 0);
	if (sqlite3_open_v2(path, &db, flags, NULL) != SQLITE_OK)
		return db;
	sqlite3_extended_result_codes(db, 1);
	sqlite3_create_function_v2(db, "exact", 1,
	    SQLITE_UTF8 | SQLITE_DIRECTONLY, NULL, exact, NULL, NULL, NULL);
	sqlite3_busy_timeout(db, WAIT_MS);
	sqlite3_exec(db,
	    "PRAGMA foreign_keys = ON; PRAGMA synchronous = FULL;PRAGMA "
	    "trusted_schema = OFF; PRAGMA cell_size_check = ON",
	    NULL, NULL, NULL);
	return db;
}

/* SQLite reads a file in WAL mode only where it can write beside it.  In a
 * folder that is closed to us, and without a log of another program, the file
 * itself is all there is to read. */
static sqlite3 *
connect_closed_folder(const char *path)
{
	char *log = xasprintf("%s-wal", path);
	bool alone = access(log, F_OK) != 0;
	free(log);
	if (!alone)
		return NULL;
	char *uri = xstrdup("file:");
	for (const char *p = path; *p != '\0'; p++)
		xappend(&uri, strchr("?#%", *p) != NULL ? "%%%02X" : "%c", *p);
	xappend(&uri, "?immutable=1");
	sqlite3 *db = NULL;
	sqlite3_open_v2(uri, &db, SQLITE_OPEN_READONLY | SQLITE_OPEN_URI, NULL);
	free(uri);
	return db;
}

static bool
prepare(
    sqlite3 *db, const char *path, bool make, long version, struct error *error)
{
	bool stale = version < STORE_SCHEMA && (make || version > 0);
	return (!stale || migrate(db, path, error)) &&
	       (!make || use_wal(db, path, error));
}

/* Opens and looks; for reading, in a closed folder too. */
static sqlite3 *
open_to(
    const char *path, bool make, long *version, bool *ok, struct error *error)
{
	sqlite3 *db = connect(path, make), *closed = NULL;
	*ok = look(db, path, version, error);
	int code = sqlite3_errcode(db) & 0xFF;
	bool beside = code == SQLITE_CANTOPEN || code == SQLITE_READONLY;
	if (!*ok && !make && beside)
		closed = connect_closed_folder(path);
	if (closed == NULL)
		return db;
	sqlite3_close(db);
	*ok = look(closed, path, version, error);
	return closed;
}

bool
schema_open(const char *path, bool make, sqlite3 **db, struct error *error)
{
	bool ok;
	long version = 0;
	struct stat about;
	*db = NULL;
	if (stat(path, &about) == 0 && !S_ISREG(about.st_mode))
		return error_at(error, ERROR_SYSTEM, path, 0, 0,
		    "the store cannot be opened: this is a folder, a pipe or a "
		    "device\n"
		    "use another with --store=PATH");
	if (!make && access(path, F_OK) != 0)
		return true;
	sqlite3 *opened = open_to(path, make, &version, &ok, error);
	ok = ok && prepare(opened, path, make, version, error);
	if (ok && (make || version > 0))
		*db = opened;
	else
		sqlite3_close(opened);
	return ok;
}

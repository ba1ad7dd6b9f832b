/* Reads and writes materials in the store's file.
 *
 * SQLite uses a write-ahead log, synced at every commit, so a kill at any
 * moment loses nothing that was reported as stored.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/store/store.h"

#include <errno.h>
#include <inttypes.h>
#include <math.h>
#include <sqlite3.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#include "base/text.h"
#include "base/xalloc.h"
#include "config.h"
#include "io/fs/xdg.h"

/* How long to wait for another program. */
enum { WAIT_MS = 5000, PAUSE_MS = 20 };

/* fold: the name without case and accents.  digest: of the row, see
 * material_make_digest.  about: the program that made this schema. */
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
    "ALTER TABLE material DROP COLUMN alpha;",
    "ALTER TABLE material ADD COLUMN basis TEXT;"};

/* exact(number): the shortest text that reads back the same, for the steps. */
static void
sql_function_exact(sqlite3_context *context, int n, sqlite3_value **value)
{
	char number[32];
	(void)n;
	sqlite3_result_text(context,
	    text_shortest_exact_number(sqlite3_value_double(value[0]), number),
	    -1, SQLITE_TRANSIENT);
}

/* folded(text): without case and accents, as names and rocks are compared. */
static void
sql_function_folded(sqlite3_context *context, int n, sqlite3_value **value)
{
	const char *text = (const char *)sqlite3_value_text(value[0]);
	(void)n;
	sqlite3_result_text(context,
	    text_fold_case_and_accents(text != NULL ? text : ""), -1, free);
}

/* Returns a name, possibly of another user, as it can be read and typed:
 * escaped and shortened. */
static char *
short_escaped_name(const char *name)
{
	enum { MOST = 60 };
	char *label = text_with_control_escaped(name);
	label[text_bytes_within(label, MOST)] = '\0';
	for (char *p = label; (p = strchr(p, '"')) != NULL;)
		*p = '\'';
	return label;
}

/* shown(name): as short_escaped_name. */
static void
sql_function_shown(sqlite3_context *context, int n, sqlite3_value **value)
{
	const char *text = (const char *)sqlite3_value_text(value[0]);
	(void)n;
	sqlite3_result_text(
	    context, short_escaped_name(text != NULL ? text : ""), -1, free);
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

/* Sets the error for the latest failure of db, which may be NULL.  Returns
 * false. */
static bool
set_error_from_sqlite(sqlite3 *db, const char *path, struct error *error)
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

/* Runs SQL without results.  False with the error set. */
static bool
run_sql(sqlite3 *db, const char *path, const char *sql, struct error *error)
{
	return sqlite3_exec(db, sql, NULL, NULL, NULL) == SQLITE_OK ||
	       set_error_from_sqlite(db, path, error);
}

/* Returns the first value of the first row as text, which the caller frees;
 * NULL without a row or after a failure. */
static char *
query_first_text(sqlite3 *db, const char *sql)
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

/* Returns a whole number; -1 after a failure. */
static long
query_first_integer(sqlite3 *db, const char *sql)
{
	FREED char *text = query_first_text(db, sql);
	return text != NULL ? strtol(text, NULL, 10) : -1;
}

/* Sets WAL mode, which a file then keeps.  Changing the mode needs the whole
 * file, for which SQLite does not wait by itself. */
static bool
set_wal_mode(sqlite3 *db, const char *path, struct error *error)
{
	const struct timespec pause = {0, PAUSE_MS * 1000000L};
	for (int waited = 0;; waited += PAUSE_MS) {
		FREED char *mode =
		    query_first_text(db, "PRAGMA journal_mode = WAL");
		bool done = mode != NULL && (strcmp(mode, "wal") == 0 ||
						strcmp(mode, "memory") == 0);
		bool busy =
		    mode == NULL && (sqlite3_errcode(db) & 0xFF) == SQLITE_BUSY;
		if (done)
			return true;
		if (!busy || waited >= WAIT_MS)
			return set_error_from_sqlite(db, path, error);
		nanosleep(&pause, NULL);
	}
}

/* Runs the steps within a transaction, in which the version is read again, as
 * another program may have migrated the file meanwhile. */
static bool
run_migration_steps(sqlite3 *db, const char *path, struct error *error)
{
	long version = query_first_integer(db, "PRAGMA user_version");
	if (version < 0)
		return set_error_from_sqlite(db, path, error);
	for (long i = version; i < STORE_SCHEMA; i++)
		if (!run_sql(db, path, SCHEMA_STEPS[i], error))
			return false;
	if (version >= STORE_SCHEMA)
		return true;
	char *end = sqlite3_mprintf(
	    "DELETE FROM about;INSERT INTO about VALUES (%Q);PRAGMA "
	    "application_id = %d;PRAGMA user_version = %d;",
	    "tipspeed " PACKAGE_VERSION, (int)SCHEMA_APPLICATION,
	    (int)STORE_SCHEMA);
	bool ok = run_sql(db, path, end, error);
	sqlite3_free(end);
	return ok;
}

/* Ends a transaction: keeps it all, or nothing when ok is false. */
static bool
commit_or_roll_back(sqlite3 *db, const char *path, bool ok, struct error *error)
{
	ok = ok && run_sql(db, path, "COMMIT", error);
	if (!ok)
		sqlite3_exec(db, "ROLLBACK", NULL, NULL, NULL);
	return ok;
}

static bool
migrate_schema(sqlite3 *db, const char *path, struct error *error)
{
	return run_sql(db, path, "BEGIN IMMEDIATE", error) &&
	       commit_or_roll_back(
		   db, path, run_migration_steps(db, path, error), error);
}

/* Checks every page and index of a small store.  In a large one that takes
 * longer than everything else (0.3 s for 100,000 materials), and each row read
 * has its digest. */
static bool
check_database_integrity(sqlite3 *db, const char *path, struct error *error)
{
	const long small = 1024;
	if (query_first_integer(db, "PRAGMA page_count") > small)
		return true;
	FREED char *found = query_first_text(db, "PRAGMA integrity_check(1)");
	bool ok = found != NULL && strcmp(found, "ok") == 0;
	if (found == NULL)
		set_error_from_sqlite(db, path, error);
	else if (!ok)
		error_at(error, ERROR_DATA, path, 0, 0,
		    "the store is damaged: %.200s\n"
		    "move the file away, and import the newest export into a "
		    "new one",
		    found);
	return ok;
}

static bool
refuse_newer_store(
    sqlite3 *db, const char *path, long version, struct error *error)
{
	FREED char *program = query_first_text(db, "SELECT program FROM about");
	error_at(error, ERROR_DATA, path, 0, 0,
	    "the store was written by %.60s (schema %ld); this is tipspeed %s, "
	    "which reads schemas up to %d\n"
	    "use that program, or another store with --store=PATH",
	    program != NULL ? program : "a newer tipspeed", version,
	    PACKAGE_VERSION, (int)STORE_SCHEMA);
	return false;
}

/* Checks what the file is.  *version: 0 for an empty one. */
static bool
check_database_version(
    sqlite3 *db, const char *path, long *version, struct error *error)
{
	if (sqlite3_errcode(db) != SQLITE_OK)
		return set_error_from_sqlite(db, path, error);
	long tables =
	    query_first_integer(db, "SELECT count(*) FROM sqlite_master");
	if (tables < 0)
		return set_error_from_sqlite(db, path, error);
	long application = query_first_integer(db, "PRAGMA application_id");
	*version = query_first_integer(db, "PRAGMA user_version");
	bool fresh = tables == 0 && application == 0 && *version == 0;
	if (!fresh && (application != SCHEMA_APPLICATION || *version <= 0))
		return error_at(error, ERROR_DATA, path, 0, 0,
		    "expected a store of tipspeed, got a database of another "
		    "program\n"
		    "use another file with --store=PATH");
	if (*version > STORE_SCHEMA)
		return refuse_newer_store(db, path, *version, error);
	return fresh || check_database_integrity(db, path, error);
}

static void
add_sql_functions(sqlite3 *db)
{
	const int flags =
	    SQLITE_UTF8 | SQLITE_DIRECTONLY | SQLITE_DETERMINISTIC;
	sqlite3_create_function_v2(
	    db, "exact", 1, flags, NULL, sql_function_exact, NULL, NULL, NULL);
	sqlite3_create_function_v2(db, "folded", 1, flags, NULL,
	    sql_function_folded, NULL, NULL, NULL);
	sqlite3_create_function_v2(
	    db, "shown", 1, flags, NULL, sql_function_shown, NULL, NULL, NULL);
}

static sqlite3 *
open_sqlite_file(const char *path, bool make)
{
	sqlite3 *db = NULL;
	int flags = SQLITE_OPEN_READWRITE | (make ? SQLITE_OPEN_CREATE : 0);
	if (sqlite3_open_v2(path, &db, flags, NULL) != SQLITE_OK)
		return db;
	sqlite3_extended_result_codes(db, 1);
	add_sql_functions(db);
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
open_sqlite_in_closed_folder(const char *path)
{
	FREED char *log = xasprintf("%s-wal", path);
	bool alone = access(log, F_OK) != 0;
	if (!alone)
		return NULL;
	FREED char *uri = xstrdup("file:");
	for (const char *p = path; *p != '\0'; p++)
		xappend(&uri, strchr("?#%", *p) != NULL ? "%%%02X" : "%c", *p);
	xappend(&uri, "?immutable=1");
	sqlite3 *db = NULL;
	sqlite3_open_v2(uri, &db, SQLITE_OPEN_READONLY | SQLITE_OPEN_URI, NULL);
	add_sql_functions(db);
	return db;
}

/* By which materials are filtered.  No step of the schema: a program that knows
 * nothing of it keeps it, and a store without it can be read. */
static const char INDEX[] = "CREATE INDEX IF NOT EXISTS material_near ON "
			    "material (rock, top_size_mm, fold)";

static bool
store_create_or_migrate(
    sqlite3 *db, const char *path, bool make, long version, struct error *error)
{
	bool stale = version < STORE_SCHEMA && (make || version > 0);
	return (!stale || migrate_schema(db, path, error)) &&
	       (!make || (set_wal_mode(db, path, error) &&
			     run_sql(db, path, INDEX, error)));
}

/* Opens and checks the file; for reading, also in a folder without write
 * access. */
static sqlite3 *
open_checked_database(
    const char *path, bool make, long *version, bool *ok, struct error *error)
{
	sqlite3 *db = open_sqlite_file(path, make), *closed = NULL;
	*ok = check_database_version(db, path, version, error);
	int code = sqlite3_errcode(db) & 0xFF;
	bool beside = code == SQLITE_CANTOPEN || code == SQLITE_READONLY;
	if (!*ok && !make && beside)
		closed = open_sqlite_in_closed_folder(path);
	if (closed == NULL)
		return db;
	sqlite3_close(db);
	*ok = check_database_version(closed, path, version, error);
	return closed;
}

/* Opens a file, or ":memory:".  make: a file that is missing or empty becomes a
 * store; without it *db is then NULL, which is no error.  A file of an older
 * schema is brought up to date, all steps or none.  False: *db is NULL. */
static bool
open_database(const char *path, bool make, sqlite3 **db, struct error *error)
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
	sqlite3 *opened =
	    open_checked_database(path, make, &version, &ok, error);
	ok = ok && store_create_or_migrate(opened, path, make, version, error);
	if (ok && (make || version > 0))
		*db = opened;
	else
		sqlite3_close(opened);
	return ok;
}

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
				   : xdg_user_file_path("XDG_DATA_HOME",
					 ".local/share", "store.db");
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

bool
store_is_store_file(const char *path)
{
	static const char HEAD[] = "SQLite format 3";
	char head[sizeof HEAD] = "";
	FILE *in = fopen(path, "rb");
	bool same = in != NULL &&
		    fread(head, 1, sizeof head, in) == sizeof head &&
		    memcmp(head, HEAD, sizeof head) == 0;
	if (in != NULL)
		fclose(in);
	return same;
}

int64_t
store_file_bytes(const struct store *store)
{
	struct stat file;
	return stat(store->path, &file) == 0 ? (int64_t)file.st_size : -1;
}

/* Makes the folders above the file, for this user alone. */
static bool
make_folders_of_store(const char *path, struct error *error)
{
	FREED char *closed = xdg_make_parent_folders(path);
	if (closed == NULL)
		return true;
	error_at(error, ERROR_SYSTEM, closed, 0, 0,
	    "cannot create the store's folder: %s\n"
	    "check its permissions, or use another store: --store=PATH",
	    strerror(errno));
	return false;
}

/* *db is NULL where there is nothing to read. */
static bool
store_connect(struct store *store, bool make, sqlite3 **db, struct error *error)
{
	*db = store->memory;
	if (*db != NULL)
		return true;
	if (store->path[0] == '\0')
		return error_set(error, ERROR_SYSTEM,
		    "no place for the store: HOME is not set\n"
		    "name a file with --store=PATH");
	if (make && store->own_folder &&
	    !make_folders_of_store(store->path, error))
		return false;
	if (!open_database(store->path, make, db, error))
		return false;
	if (strcmp(store->path, ":memory:") == 0)
		store->memory = *db;
	return true;
}

static void
close_database_unless_memory(struct store *store, sqlite3 *db)
{
	if (db != store->memory)
		sqlite3_close(db);
}

/* "SELECT fold, digest, name, ..." or "INSERT ... VALUES (?, ?, ?, ...)": the
 * fields follow fold and digest. */
static char *
sql_listing_fields(const char *before, bool marks, const char *after)
{
	char *sql = xstrdup(before);
	for (size_t i = 0; i < FIELD_COUNT; i++)
		xappend(&sql, ", %s", marks ? "?" : FIELDS[i].name);
	xappend(&sql, "%s", after);
	return sql;
}

static const char *
sql_column_text(sqlite3_stmt *stmt, int i)
{
	const char *text = (const char *)sqlite3_column_text(stmt, i);
	return text != NULL ? text : "";
}

static char *
material_digest_text(const struct material *m)
{
	return xasprintf("%016" PRIx64, material_make_digest(m));
}

/* False for a material that no import would accept. */
static bool
check_material_fields(const struct material *m, struct error *error)
{
	const struct field *f = FIELDS;
	while (f < FIELDS + FIELD_COUNT && material_is_field_valid(m, f))
		f++;
	if (f == FIELDS + FIELD_COUNT)
		return true;
	FREED char *label = short_escaped_name(m->name),
		   *wanted = material_valid_values_text(m, f),
		   *found = material_faulty_value_text(m, f);
	error_set(error, ERROR_DATA,
	    "material '%s', field %s: expected %s, got '%.60s'\n"
	    "correct the source of this material",
	    label, f->name, wanted, found);
	return false;
}

/* True if a row is unchanged since it was stored.  Its name is also stored
 * folded, by which it is found. */
static bool
is_row_unchanged(const struct material *m, const char *fold, const char *digest,
    struct error *error)
{
	FREED char *of_name = text_fold_case_and_accents(m->name),
		   *of_row = material_digest_text(m);
	FREED char *label = short_escaped_name(m->name);
	bool good = check_material_fields(m, error);
	if (good && (strcmp(of_name, fold) != 0 || strcmp(of_row, digest) != 0))
		good = error_set(error, ERROR_DATA,
		    "the store is damaged: '%s' is not what was remembered",
		    label);
	if (!good)
		error_hint(error, "run 'forget \"%s\"', then remember it again",
		    label);
	return good;
}

/* Reads the row of stmt.  False if it is not as it was stored. */
static bool
read_checked_material_row(const struct store *store, sqlite3_stmt *stmt,
    struct material *m, struct error *error)
{
	*m = material_empty();
	for (int i = 0; i < FIELD_COUNT; i++) {
		const struct field *f = &FIELDS[i];
		bool known = sqlite3_column_type(stmt, i + 2) != SQLITE_NULL;
		if (f->kind == FIELD_NUMBER && known)
			*material_number_of_field(m, f) =
			    sqlite3_column_double(stmt, i + 2);
		else if (f->kind == FIELD_WHOLE && known)
			*material_integer_of_field(m, f) =
			    sqlite3_column_int64(stmt, i + 2);
		else if (known)
			material_set_field(m, f, sql_column_text(stmt, i + 2));
	}
	if (is_row_unchanged(
		m, sql_column_text(stmt, 0), sql_column_text(stmt, 1), error))
		return true;
	if (error != NULL)
		error_set_place(error, store->path, 0, 0);
	material_free(m);
	return false;
}

/* Returns the condition of a query.  ?1 name, ?2 rock, ?3 and ?4 the least and
 * the largest top size, ?5 the top size wanted, ?6 the number of rows, ?7 their
 * distance. */
static char *
where_clause(const struct store_query *q)
{
	/* Rows that are not wanted are not read: an index has what tells. */
	char *where = xstrdup(
	    q->first > 0 ? " FROM material WHERE fold IN (SELECT fold FROM "
			   "material WHERE 1"
			 : " FROM material WHERE 1");
	if (q->name != NULL)
		xappend(&where, " AND fold = ?1");
	if (q->rock != NULL && q->most == 0)
		xappend(&where,
		    " AND rock IN (SELECT rock FROM material GROUP BY rock "
		    "HAVING folded(rock) = ?2)");
	if (q->top_most > 0)
		xappend(&where, " AND top_size_mm BETWEEN ?3 AND ?4");
	/* Those of the rock first, then by how often the one size goes into the
	 * other; what is not stated is the farthest. */
	if (q->most > 0)
		xappend(&where,
		    " AND fold IN (SELECT fold FROM material ORDER BY "
		    "folded(rock) <> ?2 OR ?2 = '', ifnull(max(top_size_mm / "
		    "?5, ?5 / top_size_mm), 1e99), fold LIMIT ?6)");
	if (q->apart > 1)
		xappend(&where, " AND fold IN (SELECT fold FROM material "
				"WHERE rowid %% ?7 = 0)");
	if (q->first > 0)
		xappend(&where, " ORDER BY fold LIMIT ?6)");
	return where;
}

static void
bind_text(sqlite3_stmt *stmt, int i, const char *text)
{
	sqlite3_bind_text(stmt, i, text, -1, SQLITE_TRANSIENT);
}

static void
bind_query_values(sqlite3_stmt *stmt, const struct store_query *q)
{
	FREED char *name =
	    text_fold_case_and_accents(q->name != NULL ? q->name : "");
	FREED char *rock =
	    text_fold_case_and_accents(q->rock != NULL ? q->rock : "");
	bind_text(stmt, 1, name);
	bind_text(stmt, 2, rock);
	sqlite3_bind_double(stmt, 3, q->top_least);
	sqlite3_bind_double(stmt, 4, q->top_most);
	sqlite3_bind_double(stmt, 5, q->top);
	sqlite3_bind_int64(
	    stmt, 6, (sqlite3_int64)(q->first > 0 ? q->first : q->most));
	sqlite3_bind_int64(stmt, 7, (sqlite3_int64)q->apart);
}

static bool
store_read_rows(struct store *store, sqlite3 *db, const struct store_query *q,
    struct material_list *list, struct error *error)
{
	FREED char *where = where_clause(q),
		   *after = xasprintf("%s ORDER BY fold", where);
	FREED char *sql =
	    sql_listing_fields("SELECT fold, digest", false, after);
	sqlite3_stmt *stmt = NULL;
	int code = sqlite3_prepare_v2(db, sql, -1, &stmt, NULL);
	bool ok =
	    code == SQLITE_OK || set_error_from_sqlite(db, store->path, error);
	bind_query_values(stmt, q);
	while (ok && (code = sqlite3_step(stmt)) == SQLITE_ROW) {
		struct material m;
		ok = read_checked_material_row(store, stmt, &m, error);
		if (ok)
			material_list_add(list, m);
	}
	if (ok && code != SQLITE_DONE)
		ok = set_error_from_sqlite(db, store->path, error);
	sqlite3_finalize(stmt);
	return ok;
}

bool
store_find_materials(struct store *store, const struct store_query *query,
    struct material_list *list, struct error *error)
{
	sqlite3 *db;
	if (!store_connect(store, false, &db, error))
		return false;
	bool ok = db == NULL || store_read_rows(store, db, query, list, error);
	close_database_unless_memory(store, db);
	return ok;
}

bool
store_list_materials(
    struct store *store, struct material_list *list, struct error *error)
{
	return store_find_materials(
	    store, &(struct store_query){0}, list, error);
}

bool
store_has_material(struct store *store, const char *name)
{
	struct material_list own = {0};
	const struct store_query query = {.name = name};
	store_find_materials(store, &query, &own, NULL);
	bool found = own.n > 0;
	material_list_free(&own);
	return found;
}

bool
store_count_materials(struct store *store, size_t *n, struct error *error)
{
	sqlite3 *db;
	*n = 0;
	if (!store_connect(store, false, &db, error))
		return false;
	long found = db != NULL ? query_first_integer(
				      db, "SELECT count(*) FROM material")
				: 0;
	bool ok = found >= 0 || set_error_from_sqlite(db, store->path, error);
	*n = ok ? (size_t)found : 0;
	close_database_unless_memory(store, db);
	return ok;
}

/* Calls take for the first column of each row of a query, whose ?1 is a folded
 * beginning, ?2 past all that begin so, and ?3 how many rows to take. */
static bool
visit_texts_of_query(struct store *store, const char *sql, const char *fold,
    size_t most, void (*take)(void *data, const char *text), void *data,
    struct error *error)
{
	sqlite3 *db;
	sqlite3_stmt *stmt = NULL;
	int code = SQLITE_DONE;
	if (!store_connect(store, false, &db, error))
		return false;
	/* The last code point. */
	FREED char *past = xasprintf("%s\xF4\x8F\xBF\xBF", fold);
	if (db != NULL)
		code = sqlite3_prepare_v2(db, sql, -1, &stmt, NULL);
	if (sqlite3_bind_parameter_count(stmt) > 0) {
		bind_text(stmt, 1, fold);
		bind_text(stmt, 2, past);
		sqlite3_bind_int64(stmt, 3, (sqlite3_int64)most);
	}
	while (stmt != NULL && (code = sqlite3_step(stmt)) == SQLITE_ROW)
		take(data, sql_column_text(stmt, 0));
	bool ok = code == SQLITE_DONE ||
		  set_error_from_sqlite(db, store->path, error);
	sqlite3_finalize(stmt);
	close_database_unless_memory(store, db);
	return ok;
}

bool
store_visit_words(struct store *store, enum store_word what,
    void (*take)(void *data, const char *word), void *data, struct error *error)
{
	static const char *const SQL[] = {
	    [STORE_NAMES] = "SELECT name FROM material ORDER BY fold",
	    [STORE_ROCKS] = "SELECT rock FROM material GROUP BY rock"};
	return visit_texts_of_query(store, SQL[what], "", 0, take, data, error);
}

bool
store_visit_names_beginning(struct store *store, const char *beginning,
    size_t most, void (*take)(void *data, const char *name), void *data,
    struct error *error)
{
	static const char SQL[] =
	    "WITH matching AS (SELECT fold FROM material WHERE fold >= ?1 AND "
	    "fold < ?2) SELECT name FROM material WHERE fold IN (SELECT fold "
	    "FROM matching ORDER BY fold LIMIT ?3) OR fold = (SELECT max(fold) "
	    "FROM matching) ORDER BY fold";
	FREED char *fold = text_fold_case_and_accents(beginning);
	return visit_texts_of_query(store, SQL, fold, most, take, data, error);
}

/* Binds a material to a row; unknown values stay NULL. */
static void
bind_material(sqlite3_stmt *stmt, const struct material *m)
{
	FREED char *fold = text_fold_case_and_accents(m->name),
		   *digest = material_digest_text(m);
	sqlite3_reset(stmt);
	sqlite3_clear_bindings(stmt);
	bind_text(stmt, 1, fold);
	bind_text(stmt, 2, digest);
	for (int i = 0; i < FIELD_COUNT; i++) {
		const struct field *f = &FIELDS[i];
		FREED char *text = material_field_to_text(m, f);
		bool number = f->kind == FIELD_NUMBER || f->kind == FIELD_WHOLE;
		if (f->kind == FIELD_NUMBER && text[0] != '\0')
			sqlite3_bind_double(
			    stmt, i + 3, *material_number_of_field(m, f));
		else if (!number || text[0] != '\0')
			bind_text(stmt, i + 3, text);
	}
}

static bool
store_put_row(struct store *store, sqlite3 *db, sqlite3_stmt *stmt,
    const struct material *m, struct error *error)
{
	bind_material(stmt, m);
	if (sqlite3_step(stmt) == SQLITE_DONE)
		return true;
	if ((sqlite3_errcode(db) & 0xFF) != SQLITE_CONSTRAINT)
		return set_error_from_sqlite(db, store->path, error);
	return error_set(error, ERROR_USAGE,
	    "the store already has a material '%s'\nchoose another name, or "
	    "add replace=on to the line",
	    m->name);
}

static bool
store_put_rows(struct store *store, sqlite3 *db, const struct material *item,
    size_t n, bool replace, struct error *error)
{
	FREED char *head =
	    sql_listing_fields(replace ? "INSERT OR REPLACE INTO material "
					 "(fold, digest"
				       : "INSERT INTO material (fold, digest",
		false, ") VALUES (?, ?");
	FREED char *sql = sql_listing_fields(head, true, ")");
	sqlite3_stmt *stmt = NULL;
	int code = sqlite3_prepare_v2(db, sql, -1, &stmt, NULL);
	bool ok =
	    code == SQLITE_OK || set_error_from_sqlite(db, store->path, error);
	for (size_t i = 0; ok && i < n; i++)
		ok = check_material_fields(&item[i], error) &&
		     store_put_row(store, db, stmt, &item[i], error);
	sqlite3_finalize(stmt);
	return ok;
}

bool
store_put_materials(struct store *store, const struct material *item, size_t n,
    bool replace, struct error *error)
{
	sqlite3 *db;
	if (!store_connect(store, true, &db, error))
		return false;
	bool ok =
	    run_sql(db, store->path, "BEGIN IMMEDIATE", error) &&
	    commit_or_roll_back(db, store->path,
		store_put_rows(store, db, item, n, replace, error), error);
	close_database_unless_memory(store, db);
	return ok;
}

/* Deletes a row by its name, otherwise by the name shown in errors. */
static bool
delete_material_row(
    struct store *store, sqlite3 *db, const char *name, struct error *error)
{
	static const char *const SQL[] = {"DELETE FROM material WHERE fold = ?",
	    "DELETE FROM material WHERE fold = (SELECT fold FROM material "
	    "WHERE folded(shown(name)) = ? LIMIT 1)"};
	FREED char *fold = text_fold_case_and_accents(name);
	for (size_t i = 0; i < ARRAY_LEN(SQL); i++) {
		sqlite3_stmt *stmt = NULL;
		sqlite3_prepare_v2(db, SQL[i], -1, &stmt, NULL);
		bind_text(stmt, 1, fold);
		bool ok = sqlite3_step(stmt) == SQLITE_DONE ||
			  set_error_from_sqlite(db, store->path, error);
		sqlite3_finalize(stmt);
		if (!ok || sqlite3_changes(db) > 0)
			return ok;
	}
	return error_set(error, ERROR_USAGE,
	    "the store has no material '%s'\n"
	    "run 'materials origin=own' to list its materials",
	    name);
}

bool
store_remove_material(
    struct store *store, const char *name, struct error *error)
{
	sqlite3 *db;
	if (!store_connect(store, false, &db, error))
		return false;
	if (db == NULL)
		return error_set(error, ERROR_USAGE,
		    "the store has no material '%s'\n"
		    "run 'remember' first: the store is empty",
		    name);
	bool ok = delete_material_row(store, db, name, error);
	close_database_unless_memory(store, db);
	return ok;
}

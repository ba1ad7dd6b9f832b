/* Reads and writes materials in the store's file.
 *
 * SQLite uses a write-ahead log, which is synced at every commit, so a kill at
 * any moment loses nothing that was reported as stored.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "io/store/store.h"

#include <errno.h>
#include <inttypes.h>
#include <sqlite3.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#include "base/text.h"
#include "base/tr.h"
#include "base/xalloc.h"
#include "config.h"
#include "io/fs/xdg.h"

/* How long to wait for another program, and between attempts. */
enum { WAIT_MS = 5000, PAUSE_MS = 20 };

/* fold: the name without case and accents.  digest: that of the row, see
 * material_compute_digest.  about: the program that made this schema. */
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

/* db: NULL unless it is open; ":memory:" stays open. */
struct store {
	char *path;
	bool own_folder; /* the default one, which may be made */
	sqlite3 *db;
};

/* SQL function exact(number), for SCHEMA_STEPS: the shortest text that reads
 * back as the same number. */
static void
sql_function_exact(sqlite3_context *context, int n, sqlite3_value **value)
{
	char number[32];
	(void)n;
	sqlite3_result_text(context,
	    text_shortest_exact_number(sqlite3_value_double(value[0]), number),
	    -1, SQLITE_TRANSIENT);
}

/* SQL function folded(text): the text without case and accents, as names and
 * rocks are compared. */
static void
sql_function_folded(sqlite3_context *context, int n, sqlite3_value **value)
{
	const char *text = (const char *)sqlite3_value_text(value[0]);
	(void)n;
	sqlite3_result_text(context,
	    text_fold_case_and_accents(text != NULL ? text : ""), -1, free);
}

/* Returns a name, which may come from another user, escaped and shortened so
 * that it can be read and typed. */
static char *
short_escaped_name(const char *name)
{
	enum { MOST = 60 };
	char *label = text_with_control_escaped(name);
	label[text_bytes_up_to_limit(label, MOST)] = '\0';
	for (char *p = label; (p = strchr(p, '"')) != NULL;)
		*p = '\'';
	return label;
}

/* SQL function shown(name): short_escaped_name. */
static void
sql_function_shown(sqlite3_context *context, int n, sqlite3_value **value)
{
	const char *text = (const char *)sqlite3_value_text(value[0]);
	(void)n;
	sqlite3_result_text(
	    context, short_escaped_name(text != NULL ? text : ""), -1, free);
}

/* For each of SQLite's result codes: the kind of error, what it says, and what
 * to do. */
static const struct problem {
	int code;
	enum error_kind kind;
	const char *text, *hint;
} PROBLEMS[] = {{SQLITE_BUSY, ERROR_SYSTEM,
		    N_("another program is using the store and did not release "
		       "it within 5 s"),
		    N_("try again; this session keeps its data")},
    {SQLITE_LOCKED, ERROR_SYSTEM, N_("the store is in use"),
	N_("try again; this session keeps its data")},
    {SQLITE_READONLY, ERROR_SYSTEM, N_("the store cannot be written to"),
	N_("check the permissions of the file and its folder, or use another "
	   "with --store=PATH")},
    {SQLITE_PERM, ERROR_SYSTEM, N_("the store cannot be opened"),
	N_("check the permissions of the file and its folder")},
    {SQLITE_CANTOPEN, ERROR_SYSTEM, N_("the store cannot be opened"),
	N_("check the name, the folder and its permissions, or use another "
	   "with --store=PATH")},
    {SQLITE_FULL, ERROR_SYSTEM, N_("the store cannot grow: the disk is full"),
	N_("free some space and try again; this session keeps its data")},
    {SQLITE_IOERR, ERROR_SYSTEM, N_("the store cannot be read or written"),
	N_("check the disk and its free space; this session keeps its data")},
    {SQLITE_CORRUPT, ERROR_DATA, N_("the store is damaged"),
	N_("move the file away, and import the newest export into a new one")},
    {SQLITE_NOTADB, ERROR_DATA,
	N_("this is not a store of tipspeed, or it is damaged"),
	N_("move the file away, or use another with --store=PATH")}};

static const char *
sql_column_text(sqlite3_stmt *stmt, int i)
{
	const char *text = (const char *)sqlite3_column_text(stmt, i);
	return text != NULL ? text : "";
}

/* Returns SQLite's code for the latest failure; SQLITE_NOMEM if there is no
 * database at all. */
static int
sqlite_error_code(const struct store *store)
{
	return store->db != NULL ? sqlite3_errcode(store->db) & 0xFF
				 : SQLITE_NOMEM;
}

/* Sets the error for the latest failure.  Returns false. */
static bool
set_error_from_sqlite(const struct store *store, struct error *error)
{
	int code = sqlite_error_code(store);
	int reason = store->db != NULL ? sqlite3_system_errno(store->db) : 0;
	for (size_t i = 0; i < ARRAY_LEN(PROBLEMS); i++) {
		const struct problem *p = &PROBLEMS[i];
		if (p->code != code)
			continue;
		/* If it may not make the file, SQLite tries again to open it
		 * without making it, and reports ENOENT, which says too
		 * little. */
		bool why = reason != 0 && reason != ENOENT &&
			   p->kind == ERROR_SYSTEM && code != SQLITE_BUSY;
		return error_set_at(error, p->kind, store->path, 0, 0,
		    "%s%s%s\n%s", tr(p->text), why ? ": " : "",
		    why ? strerror(reason) : "", tr(p->hint));
	}
	return error_set_at(error, ERROR_SYSTEM, store->path, 0, 0,
	    "the store failed: %s",
	    store->db != NULL ? sqlite3_errmsg(store->db) : tr("no memory"));
}

/* Runs SQL that has no results.  Returns false with the error set on
 * failure. */
static bool
run_sql(struct store *store, const char *sql, struct error *error)
{
	return sqlite3_exec(store->db, sql, NULL, NULL, NULL) == SQLITE_OK ||
	       set_error_from_sqlite(store, error);
}

/* Returns the first value of the first row as text, which the caller frees;
 * NULL if there is no row, or after a failure. */
static char *
query_first_text(struct store *store, const char *sql)
{
	sqlite3_stmt *stmt = NULL;
	char *text = NULL;
	if (sqlite3_prepare_v2(store->db, sql, -1, &stmt, NULL) == SQLITE_OK &&
	    sqlite3_step(stmt) == SQLITE_ROW)
		text = xstrdup(sql_column_text(stmt, 0));
	sqlite3_finalize(stmt);
	return text;
}

/* Returns the first value of the first row as a whole number, or -1 after a
 * failure. */
static long
query_first_integer(struct store *store, const char *sql)
{
	FREED char *text = query_first_text(store, sql);
	return text != NULL ? strtol(text, NULL, 10) : -1;
}

/* Sets WAL mode, which the file then keeps.  Changing the mode needs exclusive
 * use of the file, for which SQLite does not wait by itself. */
static bool
set_wal_mode(struct store *store, struct error *error)
{
	const struct timespec pause = {0, PAUSE_MS * 1000000L};
	for (int waited = 0;; waited += PAUSE_MS) {
		FREED char *mode =
		    query_first_text(store, "PRAGMA journal_mode = WAL");
		if (mode != NULL &&
		    (strcmp(mode, "wal") == 0 || strcmp(mode, "memory") == 0))
			return true;
		bool busy =
		    mode == NULL && sqlite_error_code(store) == SQLITE_BUSY;
		if (!busy || waited >= WAIT_MS)
			return set_error_from_sqlite(store, error);
		nanosleep(&pause, NULL);
	}
}

/* Runs `change` as one transaction: all of it takes effect, or nothing. */
static bool
run_in_transaction(struct store *store,
    bool (*change)(struct store *, const void *of, struct error *),
    const void *of, struct error *error)
{
	if (!run_sql(store, "BEGIN IMMEDIATE", error))
		return false;
	if (change(store, of, error) && run_sql(store, "COMMIT", error))
		return true;
	sqlite3_exec(store->db, "ROLLBACK", NULL, NULL, NULL);
	return false;
}

/* Upgrades the file to STORE_SCHEMA.  Reads its version again, as another
 * program may have upgraded it meanwhile. */
static bool
migrate_schema(struct store *store, const void *none, struct error *error)
{
	(void)none;
	long version = query_first_integer(store, "PRAGMA user_version");
	if (version < 0)
		return set_error_from_sqlite(store, error);
	if (version >= STORE_SCHEMA)
		return true;
	for (long i = version; i < STORE_SCHEMA; i++)
		if (!run_sql(store, SCHEMA_STEPS[i], error))
			return false;
	FREED char *end =
	    xasprintf("DELETE FROM about;INSERT INTO about VALUES "
		      "('tipspeed " PACKAGE_VERSION
		      "');PRAGMA application_id = %d;PRAGMA user_version = %d;",
		(int)SCHEMA_APPLICATION, (int)STORE_SCHEMA);
	return run_sql(store, end, error);
}

/* Checks every page and index of a small store.  In a large one that takes
 * longer than everything else (0.3 s for 100,000 materials); but each row read
 * has its digest. */
static bool
check_database_integrity(struct store *store, struct error *error)
{
	const long small = 1024;
	if (query_first_integer(store, "PRAGMA page_count") > small)
		return true;
	FREED char *found =
	    query_first_text(store, "PRAGMA integrity_check(1)");
	if (found == NULL)
		return set_error_from_sqlite(store, error);
	return strcmp(found, "ok") == 0 ||
	       error_set_at(error, ERROR_DATA, store->path, 0, 0,
		   "the store is damaged: %.200s\n"
		   "move the file away, and import the newest export into a "
		   "new one",
		   found);
}

static bool
refuse_newer_store(struct store *store, long version, struct error *error)
{
	FREED char *program =
	    query_first_text(store, "SELECT program FROM about");
	return error_set_at(error, ERROR_DATA, store->path, 0, 0,
	    "the store was written by %.60s (schema %ld); this is tipspeed %s, "
	    "which reads schemas up to %d\n"
	    "use that program, or another store with --store=PATH",
	    program != NULL ? program : "a newer tipspeed", version,
	    PACKAGE_VERSION, (int)STORE_SCHEMA);
}

/* Checks that the file is a store that this program can read.  *version gets
 * its schema, 0 for an empty file. */
static bool
check_database_version(struct store *store, long *version, struct error *error)
{
	long tables = sqlite_error_code(store) == SQLITE_OK
			  ? query_first_integer(
				store, "SELECT count(*) FROM sqlite_master")
			  : -1;
	if (tables < 0)
		return set_error_from_sqlite(store, error);
	long application = query_first_integer(store, "PRAGMA application_id");
	*version = query_first_integer(store, "PRAGMA user_version");
	bool fresh = tables == 0 && application == 0 && *version == 0;
	if (!fresh && (application != SCHEMA_APPLICATION || *version <= 0))
		return error_set_at(error, ERROR_DATA, store->path, 0, 0,
		    "expected a store of tipspeed, got a database of another "
		    "program\n"
		    "use another file with --store=PATH");
	if (*version > STORE_SCHEMA)
		return refuse_newer_store(store, *version, error);
	return fresh || check_database_integrity(store, error);
}

/* Opens a file or URI; closes the database that was open. */
static void
open_sqlite(struct store *store, const char *path, int flags)
{
	static const struct {
		const char *name;
		void (*call)(sqlite3_context *, int, sqlite3_value **);
	} FUNCTIONS[] = {{"exact", sql_function_exact},
	    {"folded", sql_function_folded}, {"shown", sql_function_shown}};
	const int kind = SQLITE_UTF8 | SQLITE_DIRECTONLY | SQLITE_DETERMINISTIC;
	sqlite3_close(store->db);
	store->db = NULL;
	if (sqlite3_open_v2(path, &store->db, flags, NULL) != SQLITE_OK)
		return;
	sqlite3_extended_result_codes(store->db, 1);
	for (size_t i = 0; i < ARRAY_LEN(FUNCTIONS); i++)
		sqlite3_create_function_v2(store->db, FUNCTIONS[i].name, 1,
		    kind, NULL, FUNCTIONS[i].call, NULL, NULL, NULL);
	sqlite3_busy_timeout(store->db, WAIT_MS);
	sqlite3_exec(store->db,
	    "PRAGMA foreign_keys = ON; PRAGMA synchronous = FULL;PRAGMA "
	    "trusted_schema = OFF; PRAGMA cell_size_check = ON",
	    NULL, NULL, NULL);
}

/* Opens a store in a folder without write access.  SQLite normally reads a file
 * in WAL mode only if it can write beside it; without a log of another program,
 * the file is complete and can be read as immutable. */
static void
open_store_in_read_only_folder(struct store *store)
{
	FREED char *uri = xstrdup("file:");
	for (const char *p = store->path; *p != '\0'; p++)
		xappend(&uri, strchr("?#%", *p) != NULL ? "%%%02X" : "%c", *p);
	xappend(&uri, "?immutable=1");
	open_sqlite(store, uri, SQLITE_OPEN_READONLY | SQLITE_OPEN_URI);
}

/* The index for filtering materials.  It is not a step of the schema: older
 * programs keep it without knowing it, and stores without it can be read. */
static const char INDEX[] = "CREATE INDEX IF NOT EXISTS material_near ON "
			    "material (rock, top_size_mm, fold)";

/* Opens and checks the file; if only for reading, also in a folder without
 * write access.  Upgrades an older schema, all steps or none.  make: an empty
 * or missing file becomes a store. */
static bool
open_and_check_database(
    struct store *store, bool make, long *version, struct error *error)
{
	FREED char *log = xasprintf("%s-wal", store->path);
	open_sqlite(store, store->path,
	    SQLITE_OPEN_READWRITE | (make ? SQLITE_OPEN_CREATE : 0));
	bool ok = check_database_version(store, version, error);
	int code = sqlite_error_code(store);
	if (!ok && !make && access(log, F_OK) != 0 &&
	    (code == SQLITE_CANTOPEN || code == SQLITE_READONLY)) {
		open_store_in_read_only_folder(store);
		ok = check_database_version(store, version, error);
	}
	bool stale = *version < STORE_SCHEMA && (make || *version > 0);
	return ok &&
	       (!stale ||
		   run_in_transaction(store, migrate_schema, NULL, error)) &&
	       (!make || (set_wal_mode(store, error) &&
			     run_sql(store, INDEX, error)));
}

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
	sqlite3_close(store->db);
	free(store->path);
	free(store);
}

const char *
store_path(const struct store *store)
{
	return store->path;
}

bool
store_is_sqlite_file(const char *path)
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
store_file_size(const struct store *store)
{
	struct stat file;
	return stat(store->path, &file) == 0 ? (int64_t)file.st_size : -1;
}

static void
store_close(struct store *store)
{
	if (strcmp(store->path, ":memory:") == 0)
		return;
	sqlite3_close(store->db);
	store->db = NULL;
}

/* Opens the file, or ":memory:".  make: a missing or empty file becomes a
 * store; otherwise such a file, or a home that is closed to the user, leaves db
 * NULL, which is not an error.  Returns false on failure, with db NULL. */
static bool
store_open(struct store *store, bool make, struct error *error)
{
	const char *path = store->path;
	struct stat about;
	long version = 0;
	if (store->db != NULL)
		return true;
	if (path[0] == '\0')
		return error_set(error, ERROR_SYSTEM,
		    "no place for the store: HOME is not set\n"
		    "name a file with --store=PATH");
	FREED char *closed =
	    make && store->own_folder ? xdg_make_parent_folders(path) : NULL;
	if (closed != NULL)
		return error_set_at(error, ERROR_SYSTEM, closed, 0, 0,
		    "cannot create the store's folder: %s\n"
		    "check its permissions, or use another store: --store=PATH",
		    strerror(errno));
	if (stat(path, &about) == 0 && !S_ISREG(about.st_mode))
		return error_set_at(error, ERROR_SYSTEM, path, 0, 0,
		    "the store cannot be opened: this is a folder, a pipe or a "
		    "device\n"
		    "use another with --store=PATH");
	if (!make && access(path, F_OK) != 0 &&
	    (errno == ENOENT || store->own_folder))
		return true;
	bool ok = open_and_check_database(store, make, &version, error);
	if (ok && (make || version > 0))
		return true;
	sqlite3_close(store->db);
	store->db = NULL;
	return ok;
}

/* Returns SQL in which all fields, or a ? for each, follow `before`: "SELECT
 * fold, digest, name, ..." or "INSERT ... VALUES (?, ?, ?, ...)". */
static char *
sql_with_all_fields(const char *before, bool marks, const char *after)
{
	char *sql = xstrdup(before);
	for (size_t i = 0; i < FIELD_COUNT; i++)
		xappend(&sql, ", %s", marks ? "?" : FIELDS[i].name);
	xappend(&sql, "%s", after);
	return sql;
}

static char *
material_digest_text(const struct material *m)
{
	return xasprintf("%016" PRIx64, material_compute_digest(m));
}

/* Returns false with an error for a material that an import would not
 * accept. */
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
	return error_set(error, ERROR_DATA,
	    "material '%s', field %s: expected %s, got '%.60s'\n"
	    "correct the source of this material",
	    label, f->name, wanted, found);
}

/* Returns true if a row is unchanged since it was stored; else false with an
 * error.  A row is found by its folded name, which is stored too. */
static bool
is_stored_material_intact(const struct material *m, const char *fold,
    const char *digest, struct error *error)
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
		error_set_hint(error,
		    "run 'forget \"%s\"', then remember it again", label);
	return good;
}

/* A function that takes a row of a result; returns false to stop reading. */
typedef bool take_row(const struct store *store, sqlite3_stmt *stmt, void *data,
    struct error *error);

/* Adds the material of a row to a list.  Returns false if the row has changed
 * since it was stored. */
static bool
add_material_of_intact_row(const struct store *store, sqlite3_stmt *stmt,
    void *data, struct error *error)
{
	struct material m = material_make_empty();
	for (int i = 0; i < FIELD_COUNT; i++) {
		const struct field *f = &FIELDS[i];
		bool known = sqlite3_column_type(stmt, i + 2) != SQLITE_NULL;
		if (f->kind == FIELD_NUMBER && known)
			*material_number_field_pointer(&m, f) =
			    sqlite3_column_double(stmt, i + 2);
		else if (f->kind == FIELD_WHOLE && known)
			*material_integer_field_pointer(&m, f) =
			    sqlite3_column_int64(stmt, i + 2);
		else if (known)
			material_set_field(&m, f, sql_column_text(stmt, i + 2));
	}
	if (is_stored_material_intact(&m, sql_column_text(stmt, 0),
		sql_column_text(stmt, 1), error)) {
		material_list_add(data, m);
		return true;
	}
	if (error != NULL)
		error_set_place(error, store->path, 0, 0);
	material_free(&m);
	return false;
}

static bool
read_count_from_row(const struct store *store, sqlite3_stmt *stmt, void *data,
    struct error *error)
{
	(void)store;
	(void)error;
	*(size_t *)data = (size_t)sqlite3_column_int64(stmt, 0);
	return true;
}

/* The function that visits each word, and its data. */
struct visitor {
	void (*take)(void *data, const char *word);
	void *data;
};

static bool
visit_first_column_text(const struct store *store, sqlite3_stmt *stmt,
    void *data, struct error *error)
{
	const struct visitor *visitor = data;
	(void)store;
	(void)error;
	visitor->take(visitor->data, sql_column_text(stmt, 0));
	return true;
}

static void
sql_bind_text(sqlite3_stmt *stmt, int i, const char *text)
{
	sqlite3_bind_text(stmt, i, text, -1, SQLITE_TRANSIENT);
}

/* Binds ?1 to the name, ?2 the rock, ?3 and ?4 the smallest and the largest top
 * size, ?5 the top size wanted, ?6 the number of rows, ?7 q->apart.  A
 * statement may use only some of them. */
static void
bind_query_values(sqlite3_stmt *stmt, const struct store_query *q)
{
	FREED char *name =
	    text_fold_case_and_accents(q->name != NULL ? q->name : "");
	FREED char *rock =
	    text_fold_case_and_accents(q->rock != NULL ? q->rock : "");
	sql_bind_text(stmt, 1, name);
	sql_bind_text(stmt, 2, rock);
	sqlite3_bind_double(stmt, 3, q->top_least);
	sqlite3_bind_double(stmt, 4, q->top_most);
	sqlite3_bind_double(stmt, 5, q->top);
	sqlite3_bind_int64(
	    stmt, 6, (sqlite3_int64)(q->first > 0 ? q->first : q->most));
	sqlite3_bind_int64(stmt, 7, (sqlite3_int64)q->apart);
}

/* Runs a statement and calls take for each row.  Without a file there are no
 * rows. */
static bool
visit_query_rows(struct store *store, const char *sql,
    const struct store_query *q, take_row *take, void *data,
    struct error *error)
{
	sqlite3_stmt *stmt = NULL;
	int code = SQLITE_DONE;
	bool ok = true;
	if (!store_open(store, false, error))
		return false;
	if (store->db != NULL)
		code = sqlite3_prepare_v2(store->db, sql, -1, &stmt, NULL);
	if (stmt != NULL)
		bind_query_values(stmt, q);
	while (ok && stmt != NULL && (code = sqlite3_step(stmt)) == SQLITE_ROW)
		ok = take(store, stmt, data, error);
	if (ok && code != SQLITE_DONE)
		ok = set_error_from_sqlite(store, error);
	sqlite3_finalize(stmt);
	store_close(store);
	return ok;
}

/* Returns the FROM and WHERE clauses of a query, whose values bind_query_values
 * binds.  The caller frees them. */
static char *
sql_selecting_materials(const struct store_query *q)
{
	/* Rows are selected by the index alone, so only those wanted are
	 * read. */
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
	/* Those of the rock first, then by the ratio of the two sizes; a size
	 * that is not stated is the farthest. */
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
	xappend(&where, " ORDER BY fold");
	return where;
}

bool
store_find_materials(struct store *store, const struct store_query *query,
    struct material_list *list, struct error *error)
{
	FREED char *where = sql_selecting_materials(query);
	FREED char *sql =
	    sql_with_all_fields("SELECT fold, digest", false, where);
	return visit_query_rows(
	    store, sql, query, add_material_of_intact_row, list, error);
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
	*n = 0;
	return visit_query_rows(store, "SELECT count(*) FROM material",
	    &(struct store_query){0}, read_count_from_row, n, error);
}

bool
store_visit_names_or_rocks(struct store *store, enum store_word what,
    void (*take)(void *data, const char *word), void *data, struct error *error)
{
	static const char *const SQL[] = {
	    [STORE_NAMES] = "SELECT name FROM material ORDER BY fold",
	    [STORE_ROCKS] = "SELECT rock FROM material GROUP BY rock"};
	return visit_query_rows(store, SQL[what], &(struct store_query){0},
	    visit_first_column_text, &(struct visitor){take, data}, error);
}

bool
store_visit_names_with_prefix(struct store *store, const char *beginning,
    size_t most, void (*take)(void *data, const char *name), void *data,
    struct error *error)
{
	/* 1114111 is the last code point. */
	static const char SQL[] =
	    "WITH matching AS (SELECT fold FROM material WHERE fold >= ?1 AND "
	    "fold < ?1 || char(1114111)) SELECT name FROM material WHERE fold "
	    "IN (SELECT fold FROM matching ORDER BY fold LIMIT ?6) OR fold = "
	    "(SELECT max(fold) FROM matching) ORDER BY fold";
	const struct store_query query = {.name = beginning, .first = most};
	return visit_query_rows(store, SQL, &query, visit_first_column_text,
	    &(struct visitor){take, data}, error);
}

/* Binds a material to a row; unknown values stay NULL. */
static void
bind_material_to_sql(sqlite3_stmt *stmt, const struct material *m)
{
	FREED char *fold = text_fold_case_and_accents(m->name),
		   *digest = material_digest_text(m);
	sqlite3_reset(stmt);
	sqlite3_clear_bindings(stmt);
	sql_bind_text(stmt, 1, fold);
	sql_bind_text(stmt, 2, digest);
	for (int i = 0; i < FIELD_COUNT; i++) {
		const struct field *f = &FIELDS[i];
		FREED char *text = material_field_to_text(m, f);
		bool number = f->kind == FIELD_NUMBER || f->kind == FIELD_WHOLE;
		if (f->kind == FIELD_NUMBER && text[0] != '\0')
			sqlite3_bind_double(
			    stmt, i + 3, *material_number_field_pointer(m, f));
		else if (!number || text[0] != '\0')
			sql_bind_text(stmt, i + 3, text);
	}
}

/* The arguments of store_save_materials. */
struct put {
	const struct material *item;
	size_t n;
	bool replace;
};

static bool
insert_material(struct store *store, sqlite3_stmt *stmt,
    const struct material *m, struct error *error)
{
	if (!check_material_fields(m, error))
		return false;
	bind_material_to_sql(stmt, m);
	if (sqlite3_step(stmt) == SQLITE_DONE)
		return true;
	if (sqlite_error_code(store) != SQLITE_CONSTRAINT)
		return set_error_from_sqlite(store, error);
	return error_set(error, ERROR_USAGE,
	    "the store already has a material '%s'\nchoose another name, or "
	    "add replace=on to the line",
	    m->name);
}

static bool
insert_materials(struct store *store, const void *of, struct error *error)
{
	const struct put *put = of;
	FREED char *head = sql_with_all_fields(
	    put->replace ? "INSERT OR REPLACE INTO material (fold, digest"
			 : "INSERT INTO material (fold, digest",
	    false, ") VALUES (?, ?");
	FREED char *sql = sql_with_all_fields(head, true, ")");
	sqlite3_stmt *stmt = NULL;
	bool ok =
	    sqlite3_prepare_v2(store->db, sql, -1, &stmt, NULL) == SQLITE_OK ||
	    set_error_from_sqlite(store, error);
	for (size_t i = 0; ok && i < put->n; i++)
		ok = insert_material(store, stmt, &put->item[i], error);
	sqlite3_finalize(stmt);
	return ok;
}

bool
store_save_materials(struct store *store, const struct material *item, size_t n,
    bool replace, struct error *error)
{
	const struct put put = {item, n, replace};
	bool ok = store_open(store, true, error) &&
		  run_in_transaction(store, insert_materials, &put, error);
	store_close(store);
	return ok;
}

bool
store_remove_material(
    struct store *store, const char *name, struct error *error)
{
	/* Find it by its name, otherwise by the name that errors show. */
	static const char SQL[] =
	    "DELETE FROM material WHERE fold = ifnull((SELECT fold FROM "
	    "material WHERE fold = ?1), (SELECT fold FROM material WHERE "
	    "folded(shown(name)) = ?1 LIMIT 1)) RETURNING 1";
	const struct store_query query = {.name = name};
	size_t n = 0;
	if (!store_open(store, false, error))
		return false;
	bool none = store->db == NULL;
	if (!visit_query_rows(
		store, SQL, &query, read_count_from_row, &n, error))
		return false;
	return n > 0 ||
	       error_set(error, ERROR_USAGE,
		   none ? N_("the store has no material '%s'\n"
			     "run 'remember' first: the store is empty")
			: N_("the store has no material '%s'\n"
			     "run 'materials origin=own' to list its "
			     "materials"),
		   name);
}

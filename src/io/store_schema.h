/* The store's file: opening it, its schema and how it changed, and what SQLite
 * says in plain words.  Used by store only.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_STORE_SCHEMA_H
#define TIPSPEED_IO_STORE_SCHEMA_H

#include <sqlite3.h>
#include <stdbool.h>

#include "base/error.h"
#include "io/store.h"

/* "tips" in ASCII: PRAGMA application_id of a store. */
enum { SCHEMA_APPLICATION = 0x74697073 };

/* What brings a file from schema i to i + 1, at index i. */
extern const char *const SCHEMA_STEPS[STORE_SCHEMA];

/* Opens a file, or ":memory:".  make: a file that is missing or empty becomes a
 * store; without it *db is then NULL, which is no error.  A file of an older
 * schema is brought up to date, all steps or none.  False: *db is NULL. */
bool schema_open(
    const char *path, bool make, sqlite3 **db, struct error *error);

/* Runs SQL without results.  False with the error set. */
bool schema_run(
    sqlite3 *db, const char *path, const char *sql, struct error *error);

/* The error for the newest failure of db, NULL allowed.  Returns false. */
bool schema_fail(sqlite3 *db, const char *path, struct error *error);

#endif

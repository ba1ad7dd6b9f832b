/* The store: the user's own calibrations, in a file that remains after the
 * session.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_STORE_STORE_H
#define TIPSPEED_IO_STORE_STORE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "base/error.h"
#include "io/store/material.h"

/* A store opens its file for each call and closes it afterwards, so nothing is
 * lost if the file is moved or the program killed in between.  Materials are on
 * disk when store_save_materials returns.  Several programs may use one file at
 * the same time; a program waits for another one for at most 5 s. */
struct store;

/* Makes a store.  path: a file; ":memory:" for a store that exists only as long
 * as this object; NULL for $XDG_DATA_HOME/tipspeed/store.db, by default in
 * ~/.local/share.  Does not touch the file yet, and cannot fail. */
struct store *store_new(const char *path);
void store_free(struct store *store);

/* Returns the path of the store's file, to be shown to people. */
const char *store_path(const struct store *store);

/* True if a file is an SQLite database, as a store is. */
bool store_is_sqlite_file(const char *path);

/* Returns the size of the file in bytes, or -1 if there is none (yet), as for
 * ":memory:". */
int64_t store_file_size(const struct store *store);

/* STORE_SCHEMA: the version of the schema that a store is upgraded to when it
 * is opened.  SCHEMA_APPLICATION: PRAGMA application_id of a store, "tips" in
 * ASCII. */
enum { STORE_SCHEMA = 4, SCHEMA_APPLICATION = 0x74697073 };

/* The statements at index i upgrade a file from schema i to i + 1. */
extern const char *const SCHEMA_STEPS[STORE_SCHEMA];

/* Adds the user's own materials to the list, in the order of their names.  If
 * there is no file, adds none and does not make the file.
 *
 * This and the following functions fail with ERROR_SYSTEM if the system refuses
 * access or another program holds the file, and with ERROR_DATA if the file is
 * damaged, not tipspeed's or of a newer version.  The file is then
 * unchanged. */
bool store_list_materials(
    struct store *store, struct material_list *list, struct error *error);

/* Which of the user's own materials to select; all zeros select all of them.
 * most: at most this many, those nearest to rock ("": any) and to the top size
 * `top`, mm; if most is 0, they must be of that rock, and have a top size from
 * top_least to top_most, mm.  first: at most this many, in the order of names.
 * apart: only one in this many. */
struct store_query {
	const char *name, *rock; /* ignoring case and accents; NULL: any */
	double top_least, top_most, top;
	size_t most, first, apart;
};

/* Adds the selected materials to the list, in the order of their names. */
bool store_find_materials(struct store *store, const struct store_query *query,
    struct material_list *list, struct error *error);

/* True if the store has a material with this name, ignoring case and
 * accents. */
bool store_has_material(struct store *store, const char *name);

/* Sets *n to the number of materials in the store. */
bool store_count_materials(struct store *store, size_t *n, struct error *error);

/* Calls take for the name of each material in the store, or for each of their
 * rocks once. */
enum store_word { STORE_NAMES, STORE_ROCKS };
bool store_visit_names_or_rocks(struct store *store, enum store_word what,
    void (*take)(void *data, const char *word), void *data,
    struct error *error);

/* Calls take for names that begin with `beginning`, ignoring case and accents:
 * the first `most` in order and, if there are more, also the last one.  So what
 * is common to the beginnings of these is common to all names. */
bool store_visit_names_with_prefix(struct store *store, const char *beginning,
    size_t most, void (*take)(void *data, const char *name), void *data,
    struct error *error);

/* Stores n materials, all or none.  Makes the file and, for the default path,
 * its folders.  A material with the same name (ignoring case and accents) is
 * replaced or, without `replace`, causes ERROR_USAGE. */
bool store_save_materials(struct store *store, const struct material *item,
    size_t n, bool replace, struct error *error);

/* Removes the material with this name; ERROR_USAGE if there is none. */
bool store_remove_material(
    struct store *store, const char *name, struct error *error);

#endif

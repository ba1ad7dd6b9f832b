/* The store: the user's own calibrations in a file that outlives the session.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_IO_STORE_STORE_H
#define TIPSPEED_IO_STORE_STORE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "base/error.h"
#include "io/store/material.h"

/* A file is opened for each call and closed after it, so that nothing is lost
 * when the file is moved away, or the program killed, in between.  What has
 * been put is on the disk when the call returns.  Several programs may use one
 * file at the same time; one that waits for another gives up after 5 s. */
struct store;

/* path: a file; ":memory:" for a store that ends with this one; NULL for
 * $XDG_DATA_HOME/tipspeed/store.db, by default in ~/.local/share.  Opens and
 * makes nothing yet, and cannot fail. */
struct store *store_new(const char *path);
void store_free(struct store *store);

/* Where the store is, for people. */
const char *store_path(const struct store *store);

/* Whether a file is a database such as stores are. */
bool store_is(const char *path);

/* Bytes of the file; -1 where there is none (yet), as for ":memory:". */
int64_t store_bytes(const struct store *store);

/* The schema that files have once they were opened, and "tips" in ASCII: PRAGMA
 * application_id of a store. */
enum { STORE_SCHEMA = 4, SCHEMA_APPLICATION = 0x74697073 };

/* What brings a file from schema i to i + 1, at index i. */
extern const char *const SCHEMA_STEPS[STORE_SCHEMA];

/* Adds the user's own materials to the list, in the order of their names; none
 * where there is no file, and none is made.
 *
 * This and the following fail with ERROR_SYSTEM where the system refuses or
 * another program holds the file, and with ERROR_DATA where the file is
 * damaged, not tipspeed's or of a newer version; the file is then unchanged. */
bool store_list(
    struct store *store, struct stored_list *list, struct error *error);

/* Some of the user's own materials; of zeros: all.  most: only so many of those
 * nearest to rock ("": any) and top, the wanted top size, mm; else they must
 * have rock and a size from top_least to top_most, mm; first: only the first so
 * many by name; apart: only every so many-th. */
struct store_query {
	const char *name, *rock; /* without case and accents; NULL: any */
	double top_least, top_most, top;
	size_t most, first, apart;
};

/* Adds those to the list, in the order of their names. */
bool store_find(struct store *store, const struct store_query *query,
    struct stored_list *list, struct error *error);

/* The number of the user's materials. */
bool store_count(struct store *store, size_t *n, struct error *error);

/* Calls take for each name, or once for each rock, that the user's materials
 * have. */
enum store_word { STORE_NAMES, STORE_ROCKS };
bool store_each(struct store *store, enum store_word what,
    void (*take)(void *data, const char *word), void *data,
    struct error *error);

/* Calls take for the names that begin so, without case and accents: for the
 * first `most` in their order, and, where there are more, for the last, so that
 * what these have in common, all have. */
bool store_begin(struct store *store, const char *beginning, size_t most,
    void (*take)(void *data, const char *name), void *data,
    struct error *error);

/* Puts n materials, all or none; makes the file, and for the default path its
 * folders.  One of the same name (without case and accents) is replaced, or
 * refused with ERROR_USAGE. */
bool store_put(struct store *store, const struct stored *item, size_t n,
    bool replace, struct error *error);

/* Takes the material of that name out; ERROR_USAGE if there is none. */
bool store_forget(struct store *store, const char *name, struct error *error);

#endif

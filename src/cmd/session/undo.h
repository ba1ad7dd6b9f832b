/* Steps back and forth, and what they go between.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_SESSION_UNDO_H
#define TIPSPEED_CMD_SESSION_UNDO_H

#include <stdbool.h>
#include <stddef.h>

#include "cmd/session/journal.h"
#include "cmd/session/session.h"

/* All of a session that can be undone, and the place in its journal, at one
 * moment. */
struct snapshot;

struct snapshot *snapshot_take(const struct session *s);
void snapshot_free(struct snapshot *snapshot);

/* True when the session is another than it was then. */
bool snapshot_differs(const struct snapshot *snapshot, const struct session *s);

/* Same result of same search. */
bool snapshot_same_fit(const struct fit *a, const struct fit *b);

/* How many steps can be undone now. */
size_t undo_depth(const struct session *s);

/* One more step: the session was as in `before`, which is taken.  Steps beyond
 * `depth`, which the command's own script made, become part of it; what could
 * be redone is lost.  floor: the depth before the outermost script, whose steps
 * push out no older ones; SIZE_MAX outside scripts. */
void undo_push(struct session *s, struct snapshot *before, size_t depth,
    size_t floor, const char *label);

/* The session as it was one step before; as it was before that was undone.  The
 * step's label, or NULL where there is none. */
const char *undo_back(struct session *s);
const char *undo_forth(struct session *s);

struct undo *undo_new(void);
void undo_free(struct undo *undo);

#endif

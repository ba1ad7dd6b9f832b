/* Undo and redo, and the snapshots they restore.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_SESSION_UNDO_H
#define TIPSPEED_CMD_SESSION_UNDO_H

#include <stdbool.h>
#include <stddef.h>

#include "cmd/session/journal.h"
#include "cmd/session/session.h"

/* What undo can restore of a session, and its place in the journal, at one
 * moment. */
struct snapshot;

struct snapshot *snapshot_take(const struct session *s);
void snapshot_free(struct snapshot *snapshot);

/* True if the session differs from the snapshot. */
bool snapshot_differs(const struct snapshot *snapshot, const struct session *s);

/* True if both entries are of one site with the same parameters and fit. */
bool snapshot_same_entry(const struct entry *a, const struct entry *b);

/* True if both fits are the same result of the same search. */
bool snapshot_same_fit(const struct fit *a, const struct fit *b);

/* Returns how many steps can be undone now. */
size_t undo_depth(const struct session *s);

/* Adds an undo step: the session was as in `before`, which undo_push takes
 * over.  Steps beyond `depth`, made by the command's own script, become part of
 * it; steps that could be redone are dropped.  floor: the depth before the
 * outermost script, whose steps push out no older ones; SIZE_MAX outside
 * scripts. */
void undo_push(struct session *s, struct snapshot *before, size_t depth,
    size_t floor, const char *label);

/* undo_back restores the session before the last step, undo_forth that before
 * the last undo.  Return the step's label, or NULL where there is none. */
const char *undo_back(struct session *s);
const char *undo_forth(struct session *s);

struct undo *undo_new(void);
void undo_free(struct undo *undo);

#endif

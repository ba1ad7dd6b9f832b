/* Undo and redo, and the snapshots that they restore.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_SESSION_UNDO_H
#define TIPSPEED_CMD_SESSION_UNDO_H

#include <stdbool.h>
#include <stddef.h>

#include "cmd/session/journal.h"
#include "cmd/session/session.h"

/* What undo can restore of a session, and the place in the journal, at one
 * moment. */
struct snapshot;

struct snapshot *snapshot_take_session(const struct session *s);
void snapshot_free(struct snapshot *snapshot);

/* True if the session differs from the snapshot. */
bool snapshot_differs(const struct snapshot *snapshot, const struct session *s);

/* True if both entries have the same site, parameters and fit. */
bool session_entries_are_equal(const struct entry *a, const struct entry *b);

/* True if both fits are the same result of the same search. */
bool fits_are_equal(const struct fit *a, const struct fit *b);

/* Returns the number of steps that can be undone. */
size_t undo_count_steps(const struct session *s);

/* Adds a step that undoes back to `before`, of which it takes ownership.  Steps
 * beyond `depth`, made by the command's own script, become part of it; steps
 * that could be redone are dropped.  floor: the depth before the outermost
 * script, whose steps do not push out older ones; SIZE_MAX outside scripts. */
void undo_push_step(struct session *s, struct snapshot *before, size_t depth,
    size_t floor, const char *label);

/* undo_last_step restores the session as it was before the last step,
 * undo_redo_step as it was before the last undo.  Both return the label of the
 * step, or NULL if there is none. */
const char *undo_last_step(struct session *s);
const char *undo_redo_step(struct session *s);

struct undo *undo_new(void);
void undo_free(struct undo *undo);

#endif

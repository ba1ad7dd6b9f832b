/* Steps back and forth.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_UNDO_H
#define TIPSPEED_CMD_UNDO_H

#include <stddef.h>

#include "cmd/journal.h"
#include "cmd/session.h"
#include "cmd/snapshot.h"

/* How many steps can be undone now. */
size_t undo_depth(const struct session *s);

/* One more step: the session was as in `before`, which is taken, and the
 * journal at `mark`.  Steps beyond `depth`, which the command's own script
 * made, become part of it; what could be redone is lost.  floor: the depth
 * before the outermost script, whose steps push out no older ones; SIZE_MAX
 * outside scripts. */
void undo_push(struct session *s, struct snapshot *before, struct mark mark,
    size_t depth, size_t floor, const char *label);

struct undo *undo_new(void);
void undo_free(struct undo *undo);

#endif

/* All of a session that can be undone, at one moment.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_SNAPSHOT_H
#define TIPSPEED_CMD_SNAPSHOT_H

#include <stdbool.h>

#include "cmd/session.h"

/* Sites are borrowed: the session keeps every one to its end. */
struct snapshot;

struct snapshot *snapshot_take(const struct session *s);
void snapshot_free(struct snapshot *snapshot);

/* The session as it was then.  Its newest answers are forgotten. */
void snapshot_put(struct session *s, const struct snapshot *snapshot);

/* True when the session is another than it was then. */
bool snapshot_differs(const struct snapshot *snapshot, const struct session *s);

/* Same result of same search. */
bool snapshot_same_fit(const struct fit *a, const struct fit *b);

#endif

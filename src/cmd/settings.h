/* Settings: what is said of each and where it is kept is a row of SETTINGS;
 * set, undo, save, reset and help follow from it.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_SETTINGS_H
#define TIPSPEED_CMD_SETTINGS_H

#include "cmd/command.h"
#include "cmd/session.h"

/* What is set in a session that has just begun. */
struct choices settings_default(void);

/* Bounds, seed and timing are compared too. */
bool settings_same(const struct choices *a, const struct choices *b);

/* The value as `set` would be given it; the caller frees. */
char *settings_text(const struct setting *row, const struct choices *set);

#endif

/* From a key and the state to the line it stands for.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_UI_COMPOSE_H
#define TIPSPEED_UI_COMPOSE_H

#include "ui/tui_state.h"

/* The command of a key that has one, with the speed, the site or the picture in
 * it.  The caller frees. */
char *compose_line(const struct tui *t, const struct key *key);

#endif

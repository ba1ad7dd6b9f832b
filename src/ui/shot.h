/* The full screen as a picture: drawn as it is on a terminal, but aside of it.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_UI_SHOT_H
#define TIPSPEED_UI_SHOT_H

#include "cmd/pictures.h"

struct tui;

/* The full screen that is open from now on; NULL: none. */
void shot_of(const struct tui *t);

/* The next of the keys that are pressed, as the answer to a question; 0: there
 * is none, and the picture is that of the question. */
int shot_answer(void);

/* What the request asks for, see there.  Without an open screen one is begun on
 * the session, its keys do what they do, and it is left.  NULL with an error
 * where a key has no such name, or a signal came. */
struct canvas *shot_draw(struct session *s,
    const struct screen_request *request, struct error *error);

#endif

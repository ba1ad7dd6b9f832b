/* A full screen on the session of a desk, drawn aside, in the source tree.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_TESTS_UNIT_STAGE_H
#define TIPSPEED_TESTS_UNIT_STAGE_H

#include <stdlib.h>

#include "base/xalloc.h"
#include "desk.h"
#include "tui/control.h"
#include "tui/screen.h"
#include "tui/script_terminal.h"

/* keys: how many were pressed, where a test counts them. */
struct stage {
	struct tui t;
	struct desk *desk;
	struct display *was;
	size_t keys;
};

/* Runs `line` first, or nothing for NULL. */
static inline struct stage *
stage_new(
    int rows, int columns, enum charset charset, int depth, const char *line)
{
	struct stage *stage = xcalloc(1, sizeof *stage);
	void *desk;
	desk_open(&desk);
	stage->desk = desk;
	if (line != NULL)
		desk_expect(stage->desk, line);
	stage->was = screen_begin_offscreen(rows, columns, charset, depth);
	control_open_screen(&stage->t, stage->desk->session, &SCRIPT_CALLBACKS);
	return stage;
}

static inline int
stage_close(void **state)
{
	struct stage *stage = *state;
	void *desk = stage->desk;
	control_close_screen(&stage->t);
	canvas_free(screen_end_offscreen(stage->was));
	free(stage);
	return desk_close(&desk);
}

#endif

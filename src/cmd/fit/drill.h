/* A drill under way: a hidden plant, and what was asked of it.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_FIT_DRILL_H
#define TIPSPEED_CMD_FIT_DRILL_H

#include "cmd/session/session.h"
#include "core/check/drill.h"

/* Samples were taken at speeds [n], m/s; answer: a speed, or NAN.  One never
 * changes once made: each sample makes another, so that a step can be undone
 * by going back to the one before. */
enum { DRILL_SAMPLES = 16 };
struct drill {
	struct drill_plant plant;
	size_t n, credits;
	double speed[DRILL_SAMPLES], answer;
};

#endif

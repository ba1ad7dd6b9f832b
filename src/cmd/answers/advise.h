/* Finds the next sample that would most narrow a band.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_ANSWERS_ADVISE_H
#define TIPSPEED_CMD_ANSWERS_ADVISE_H

#include "cmd/ask/asked.h"
#include "core/psd/quantity.h"

/* A sample that could be taken.  width: the expected width of the band once it
 * is taken, in the unit shown; repeat: this speed was sampled before. */
struct sample_advice {
	double speed, width;
	bool repeat;
};

/* If no single sample narrows the band by this share, several are advised. */
#define ADVISE_WORTH 0.05

/* Finds the sample that would most narrow the band of a quantity at the
 * question's speed.  Also sets the width of that band, and in exact_width its
 * width if the tip speeds were exact.  Returns false if there is no band. */
bool advise_find_best_sample(const struct session *s, const struct question *q,
    const struct quantity *of, struct sample_advice *best, double *width,
    double *exact_width);

#endif

/* Finds the next sample that would narrow a band most.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_ANSWERS_ADVISE_H
#define TIPSPEED_CMD_ANSWERS_ADVISE_H

#include "cmd/ask/asked.h"
#include "core/psd/quantity.h"

/* A possible sample.  width: expected width of the band after it, in the units
 * shown; repeat: the speed was sampled before. */
struct sample_advice {
	double speed, width;
	bool repeat;
};

/* If no single sample narrows the band by this share, take several. */
#define ADVISE_WORTH 0.05

/* Finds the best sample for a quantity of a question at its speed, the
 * current width of the band, and its width if the tip speeds were exact.
 * Returns false if there is no band. */
bool advise_find_best_sample(const struct session *s, const struct question *q,
    const struct quantity *of, struct sample_advice *best, double *width,
    double *exact_width);

#endif

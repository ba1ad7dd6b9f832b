/* Finds the next sample that narrows a band most.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_ANSWERS_ADVISE_H
#define TIPSPEED_CMD_ANSWERS_ADVISE_H

#include "cmd/ask/asked.h"
#include "core/psd/quantity.h"

/* A possible sample.  width: of the band expected after it, as people see it;
 * repeat: that speed was sampled already. */
struct advised {
	double speed, width;
	bool repeat;
};

/* If no single sample narrows the band by this share of it, several are
 * advised. */
#define ADVISE_WORTH 0.05

/* Finds the best sample for a quantity of a question at its speed, and the
 * width of the band now; false if there is no band to narrow. */
bool advise_best(const struct session *s, const struct question *q,
    const struct quantity *of, struct advised *best, double *width);

#endif

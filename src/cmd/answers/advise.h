/* Which sample next narrows a band most.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_ANSWERS_ADVISE_H
#define TIPSPEED_CMD_ANSWERS_ADVISE_H

#include "cmd/ask/asked.h"
#include "core/psd/quantity.h"

/* A sample that could be taken.  width: of the band, expected after it, as
 * people see it; repeat: there is one at that speed. */
struct advised {
	double speed, width;
	bool repeat;
};

/* A share of the band; where no sample narrows it by more, several are
 * wanted. */
#define ADVISE_WORTH 0.05

/* The best for a quantity of a question at its speed, and the width of the band
 * now; false where there is no band to narrow. */
bool advise_best(const struct session *s, const struct question *q,
    const struct quantity *of, struct advised *best, double *width);

#endif

/* A fit as calibrate shows it.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_FIT_FIT_REPORT_H
#define TIPSPEED_CMD_FIT_FIT_REPORT_H

#include "cmd/session/session.h"

/* A site's fit, with its fields; seconds: how long it took.  detail: with the
 * table of its parameters and what the search did, which programs have in any
 * case; else how good it is, in a few lines. */
struct answer *fit_answer(const struct session *s, const struct entry *entry,
    const struct bounds *bounds, double seconds, bool detail);

/* What json has of an entry's fit, but for its ranges. */
void fit_put(struct fields *o, const struct entry *entry, const char *verdict,
    double seconds);

#endif

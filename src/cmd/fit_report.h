/* A fit as calibrate shows it.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_FIT_REPORT_H
#define TIPSPEED_CMD_FIT_REPORT_H

#include "cmd/session.h"

/* The table of a site's fit, with its fields; seconds: how long it took. */
struct answer *fit_answer(const struct session *s, const struct entry *entry,
    const struct bounds *bounds, double seconds);

/* What json has of an entry's fit, but for its ranges. */
void fit_put(struct fields *o, const struct session *s,
    const struct entry *entry, double seconds);

#endif

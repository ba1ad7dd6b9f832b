/* The report of a fit, as calibrate shows it.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_FIT_FIT_REPORT_H
#define TIPSPEED_CMD_FIT_FIT_REPORT_H

#include "cmd/session/session.h"

/* Returns the report of a site's fit, with its fields; seconds: how long it
 * took.  detail: with the table of parameters and the course of the search,
 * which programs get in any case; else a few lines on how good it is. */
struct answer *fit_answer(const struct session *s, const struct entry *entry,
    const struct bounds *bounds, double seconds, bool detail);

/* Puts the fields that json has of an entry's fit, except for its ranges. */
void fit_put(struct fields *o, const struct entry *entry, const char *verdict,
    double seconds);

#endif

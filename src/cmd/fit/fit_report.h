/* The report of a fit, as shown by calibrate.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_FIT_FIT_REPORT_H
#define TIPSPEED_CMD_FIT_FIT_REPORT_H

#include "cmd/session/session.h"

/* Returns the report of a site's fit, with its fields.  seconds: duration of
 * the search.  detail: include the table of parameters and the course of the
 * search, which programs always get; otherwise a few lines on the quality of
 * the fit. */
struct answer *fit_build_report(const struct session *s,
    const struct entry *entry, const struct bounds *bounds, double seconds,
    bool detail);

/* Returns the answer to what was last asked about: by default, the passing of
 * predict's first sentence at the usual speed of the site.  All 0 if the entry
 * is not calibrated or answers are about another feed. */
struct former fit_last_asked_answer(
    const struct session *s, const struct entry *entry);

/* Puts the JSON fields of an entry's fit, except its ranges. */
void fit_put_fields(struct fields *o, const struct entry *entry,
    const char *verdict, double seconds);

#endif

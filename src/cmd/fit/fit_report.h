/* The report on a fit, as shown by calibrate.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_FIT_FIT_REPORT_H
#define TIPSPEED_CMD_FIT_FIT_REPORT_H

#include "cmd/session/session.h"

/* Returns the report on a site's fit, with its fields.  seconds: how long the
 * search took.  detail: show people the table of parameters and the course of
 * the search too, which programs always get; otherwise a few lines on the
 * quality of the fit. */
struct answer *fit_build_report(const struct session *s,
    const struct entry *entry, const struct bounds *bounds, double seconds,
    bool detail);

/* Returns the current answer for the quantity and the speed last asked about;
 * by default, for the passing of predict's first sentence at the site's usual
 * speed.  All members are 0 if the entry has no fit, a calibration is running,
 * or `set feed` names another feed than the mean. */
struct former fitted_answer_to_last_question(
    const struct session *s, const struct entry *entry);

/* Puts the fields of an entry's fit, except the ranges of its parameters. */
void fit_put_fields(struct fields *o, const struct entry *entry,
    const char *verdict, double seconds);

#endif

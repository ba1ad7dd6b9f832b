/* The chosen grading envelope, in a plot of size distributions.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_DRAW_PLOTS_LIMITS_H
#define TIPSPEED_CMD_DRAW_PLOTS_LIMITS_H

#include "cmd/session/session.h"
#include "core/answer/predict.h"
#include "plot/chart.h"

/* Styles of the upper and the lower limits. */
extern const struct chart_series PLOTS_LIMITS[2];

/* Adds the limits on sieves within the axis, behind all curves.
 * notes: describe them in words.  Adds nothing if no envelope is chosen. */
void plots_envelope_add_limits(
    struct chart *chart, const struct session *s, bool notes);

/* Fills only the product in part: the fraction to which the chosen envelope
 * applies, read off the prediction's curve.  Free with prediction_free.
 * Returns false if the envelope is for the whole product. */
bool plots_envelope_cut_product(const struct session *s,
    const struct entry *entry, const struct prediction *whole,
    struct prediction *part);

/* Returns the envelope's fraction, "0/4.75", or "".  The caller frees it. */
char *plots_envelope_fraction_text(const struct session *s);

#endif

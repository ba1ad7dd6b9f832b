/* The grading envelope in use, in a plot of size distributions.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_DRAW_PLOTS_LIMITS_H
#define TIPSPEED_CMD_DRAW_PLOTS_LIMITS_H

#include "cmd/session/session.h"
#include "core/answer/predict.h"
#include "plot/chart.h"

/* Styles of the upper and the lower limits. */
extern const struct chart_series PLOTS_LIMITS[2];

/* Adds the limits on sieves within the axis, behind what is added later; notes:
 * says in words what they are.  Adds nothing where no envelope is chosen. */
void plots_limits_add(struct chart *chart, const struct session *s, bool notes);

/* Puts into part the product of the fraction that the envelope in use is for,
 * read off the prediction's curve, and nothing else of the prediction; free
 * with prediction_free.  False where the envelope is for the whole product. */
bool plots_limits_fraction(const struct session *s, const struct entry *entry,
    const struct prediction *whole, struct prediction *part);

/* Returns the envelope's fraction, "0/4.75"; "" where it has none.  The caller
 * frees. */
char *plots_limits_words(const struct session *s);

#endif

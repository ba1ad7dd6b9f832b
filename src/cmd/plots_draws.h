/* Plots of what was drawn: correlation and profile.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_PLOTS_DRAWS_H
#define TIPSPEED_CMD_PLOTS_DRAWS_H

#include "cmd/session.h"
#include "plot/chart.h"

/* NULL with an error where the site has no calibration or, of correlation, no
 * draws; chart_free.  param: its name; NULL: e0_min. */
struct chart *plots_draws_profile(
    struct session *s, const char *param, struct error *error);
struct chart *plots_draws_correlation(struct session *s, struct error *error);

#endif

/* All runs of a site at once: feeds, measured products, predicted ones.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_DRAW_PLOTS_RUNS_H
#define TIPSPEED_CMD_DRAW_PLOTS_RUNS_H

#include "cmd/draw/plot_request.h"

/* The paper's figure 7: each run's product as measured, solid, and as the model
 * alone predicts it from the run's own feed, dashed; with `speeds` its figure
 * 9, predictions at speeds that were not measured, from the feed that is asked
 * about.  Without parameters what was measured alone. */
plot_make plots_runs;

#endif

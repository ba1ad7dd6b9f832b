/* A chart about a site.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_DRAW_SITE_CHART_H
#define TIPSPEED_CMD_DRAW_SITE_CHART_H

#include <stdbool.h>

#include "cmd/session/session.h"
#include "core/psd/site.h"
#include "plot/chart.h"

/* Title "Tierp, Granite, 11.2 mm: ..." and where the site's data are from; it
 * takes the axes. */
struct chart *site_chart(const struct site *site, struct axis x, struct axis y,
    const char *format, ...) __attribute__((format(printf, 4, 5)));

/* The looks that several series of a chart take in turn; the first 23
 * differ without colour. */
struct chart_series site_chart_look(size_t i);

/* That of what was measured in a run, the same in every plot: marks alone, full
 * ones where the model was fitted to it.  Repeats look alike. */
struct chart_series site_chart_run(
    const struct site *site, size_t run, bool held_out);

/* Says below a chart where its measured products were moved to the feed by so
 * much, 0..1, that it has to be known, see moved_by. */
void site_chart_moved(struct chart *chart, double most);

/* Measured products of so many speeds, those nearest to its own, has psd, and
 * says how many others there are. */
enum { SITE_CHART_RUNS = 12 };
size_t site_chart_left_out(const struct site *site);

#endif

/* Charts of a site.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_DRAW_SITE_CHART_H
#define TIPSPEED_CMD_DRAW_SITE_CHART_H

#include <stdbool.h>

#include "cmd/session/session.h"
#include "core/psd/site.h"
#include "plot/chart.h"

/* Returns a chart titled "Tierp, Granite, 11.2 mm: ..", with the source of the
 * site's data.  Takes ownership of the axes. */
struct chart *site_chart(const struct site *site, struct axis x, struct axis y,
    const char *format, ...) __attribute__((format(printf, 4, 5)));

/* Returns style i of those used in turn for several series in a chart; the
 * first 23 differ even without colour. */
struct chart_series site_chart_style(size_t i);

/* Returns the style for a run's measurements, the same in every plot: marks
 * only, filled unless held_out.  Repeats look alike. */
struct chart_series site_chart_run(
    const struct site *site, size_t run, bool held_out);

/* Notes below a chart that its measured products were moved to the feed, if the
 * largest move, 0..1 (moved_largest), is large enough to mention. */
void site_chart_moved(struct chart *chart, double most);

/* psd shows the measured products at the SITE_CHART_RUNS speeds nearest to its
 * own; site_chart_speeds_left_out returns the number of other speeds. */
enum { SITE_CHART_RUNS = 12 };
size_t site_chart_speeds_left_out(const struct site *site);

#endif

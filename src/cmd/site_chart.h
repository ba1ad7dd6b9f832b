/* A chart about a site.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_SITE_CHART_H
#define TIPSPEED_CMD_SITE_CHART_H

#include "core/site.h"
#include "plot/chart.h"

/* Title "Tierp, Granite, 11.2 mm: ..." and where the site's data are from; it
 * takes the axes. */
struct chart *site_chart(const struct site *site, struct axis x, struct axis y,
    const char *format, ...) __attribute__((format(printf, 4, 5)));

#endif

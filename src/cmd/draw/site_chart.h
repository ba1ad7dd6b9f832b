/* Charts of a site.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_DRAW_SITE_CHART_H
#define TIPSPEED_CMD_DRAW_SITE_CHART_H

#include <stdbool.h>

#include "cmd/ask/forecast.h"
#include "plot/chart.h"

/* Returns a chart titled "Tierp, Granite, 11.2 mm: ..", with the source of the
 * site's data.  Takes ownership of the axes. */
struct chart *site_chart_new(const struct site *site, struct axis x,
    struct axis y, const char *format, ...)
    __attribute__((format(printf, 4, 5)));

/* Returns an axis with a tick at each sieve; size [n]: the sieves, m. */
struct axis site_chart_sieve_axis(const double *size, size_t n);

/* Adds a size distribution, in mm and %, and takes ownership of the name.
 * finer: the same curve at more sizes, from which values between the points are
 * read, or NULL. */
void site_chart_add_psd(struct chart *chart, struct chart_series look,
    const struct psd *psd, const struct psd *finer, char *name);

/* Sets the x axis to sizes, with ticks at the sieves of all series. */
void site_chart_set_sieve_axis(struct chart *chart);

/* Sets point k of a series: at x, a figure with its band, in the unit shown. */
void site_chart_set_point_with_band(
    struct chart_series *s, size_t k, double x, struct figure at);

/* Completes a series of figures.  A point without a band gets one of no width,
 * and one whose lower end lies below the finest sieve a band on one side.  If
 * no point has a band, the series has none either. */
void site_chart_close_band_at_gaps(struct chart_series *s);

/* Fills line [n], series with equally many points, with the first n quantities
 * of a forecast at evenly spaced speeds from..to, m/s. */
void site_chart_fill_forecast_by_speed(struct forecast *f, size_t n,
    double from, double to, struct chart_series *const *line);

/* Converts the axis of a chart, and all drawn along it, from m/s to rpm if the
 * site's sheet is in rpm. */
void site_chart_show_speeds_in_rpm(
    struct chart *chart, const struct site *site);

/* The styles of a feed, of a line to compare others with, and of a
 * prediction. */
extern const struct chart_series SITE_CHART_FEED, SITE_CHART_LEVEL,
    SITE_CHART_PREDICTED;

/* Returns the style of series i of several in a chart.  The first 23 differ
 * even without colour. */
struct chart_series site_chart_series_style(size_t i);

/* Returns the style for a run's measurements, the same in every plot: marks
 * only, filled unless held_out.  Repeats look alike. */
struct chart_series site_chart_run_style(
    const struct site *site, size_t run, bool held_out);

/* Notes below a chart what hollow marks mean, if it has any, and how many
 * measured speeds are not drawn. */
void site_chart_note_run_marks(struct chart *chart, const struct site *site);

/* Notes below a chart that its measured products were moved to the feed, if
 * this is worth mentioning.  most: the largest move, 0..1, from
 * largest_change_by_moving_to_feed. */
void site_chart_note_moved_products(struct chart *chart, double most);

/* psd shows the measured products at the SITE_CHART_SPEEDS speeds nearest to
 * its own.  site_chart_count_speeds_left_out returns how many speeds that
 * leaves out. */
enum { SITE_CHART_SPEEDS = 12 };
size_t site_chart_count_speeds_left_out(const struct site *site);

/* Returns the fraction of the product to which the chosen envelope applies;
 * without an envelope it is the whole product.
 * session_envelope_size_fraction_text returns it as "0/4.75", or "" for the
 * whole product.  The caller frees the text. */
struct fraction session_envelope_size_fraction(const struct session *s);
char *session_envelope_size_fraction_text(const struct session *s);

#endif

/* energy: plots the number of impacts per particle in each half octave of
 * energy.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/draw/plots.h"

#include <math.h>

#include "base/tr.h"
#include "base/xalloc.h"
#include "cmd/session/energies.h"
#include "cmd/draw/site_chart.h"
#include "core/model/breakage.h"

/* This many bins are drawn as one, which spans half an octave. */
enum { TOGETHER = 8, POINTS = SPECTRUM_BINS / TOGETHER };

/* Fills a series with the impacts per particle in each half octave or, if
 * particles were not counted, the share of the impacts, %.  first: only the
 * first impact of each particle. */
static void
fill_impact_energy_series(struct chart_series *series, const struct spectrum *s,
    const struct spectrum_size *whole, bool first)
{
	double all = spectrum_impacts_above(whole, 0, false).mass;
	double per = s->counted ? whole->mass : all / 100;
	for (size_t i = 0; i < POINTS; i++) {
		double sum = 0;
		for (size_t b = i * TOGETHER; b < (i + 1) * TOGETHER; b++)
			sum +=
			    first ? whole->first[b].mass : whole->all[b].mass;
		series->x[i] = spectrum_bin_edge(i * TOGETHER + TOGETHER / 2);
		series->y[i] = sum / per;
	}
}

static void
add_impact_energy_curves(
    struct chart *chart, const struct energies *e, bool main, size_t place)
{
	const struct spectrum *s = e->c.spectrum;
	FREED struct spectrum_size *whole = spectrum_merge_sizes(s);
	const struct chart_series of_first = {
	    .series = SERIES_FEED, .line = CHART_DASHED, .ascii = '-'};
	FREED char *speed =
	    s->speed > 0 ? xasprintf(" (%g m/s)", s->speed) : xstrdup("");
	fill_impact_energy_series(
	    chart_add(chart,
		main ? SITE_CHART_PREDICTED : site_chart_series_style(place),
		POINTS, "%s%s", e->name, speed),
	    s, whole, false);
	if (main && s->ordered)
		fill_impact_energy_series(
		    chart_add(chart, of_first, POINTS,
			"first impact above %g J/kg", e->cut),
		    s, whole, true);
}

/* Draws how often particles are hit, by energy: for the energies in use, with a
 * curve of its own for the first impacts, and for the others that were
 * loaded. */
struct chart *
plots_impact_energies(
    struct session *s, const struct plot_request *q, struct error *error)
{
	(void)q;
	const struct energies *e = energies_last_read(s, error);
	if (e == NULL)
		return NULL;
	const struct spectrum *of = e->c.spectrum;
	double E = of->speed > 0 ? specific_energy_at_speed(of->speed) : NAN;
	struct chart *chart = chart_new(tr("collision energies"),
	    e->c.about[0] != '\0' ? e->c.about : tr("origin not stated"),
	    axis_new_log(
		tr("energy of an impact, J/kg"), 0.01, fmax(1e4, 2 * E)),
	    axis_new_linear("", 0, 1));
	for (size_t i = 0; i < s->n_energies; i++)
		if (s->energies[i] != e &&
		    s->energies[i]->c.spectrum->counted == of->counted)
			add_impact_energy_curves(
			    chart, s->energies[i], false, i);
	add_impact_energy_curves(chart, e, true, 0);
	axis_free(&chart->y);
	chart->y =
	    axis_new_linear(of->counted ? tr("impacts per particle and half "
					     "octave, -")
					: tr("share of impacts per half "
					     "octave, %"),
		0, chart_find_extent(chart).y[1]);
	chart_add_rule(chart, SERIES_BREAK, e->cut, "cut %g J/kg", e->cut);
	if (E > 0)
		chart_add_rule(
		    chart, SERIES_CROSSHAIR, E, "v^2/2: %.0f J/kg", E);
	return chart;
}

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
enum { BINS_PER_POINT = 8, POINTS = SPECTRUM_BINS / BINS_PER_POINT };

static const char *
origin_of_energies(const struct energies *e)
{
	return e->c.about[0] != '\0' ? e->c.about : tr("origin not stated");
}

/* Returns " (69 m/s)", or "" if the speed is not stated.  The caller frees
 * it. */
static char *
speed_in_brackets(const struct energies *e)
{
	double speed = e->c.spectrum->speed;
	return speed > 0 ? xasprintf(" (%g m/s)", speed) : xstrdup("");
}

/* Fills a series with the impacts per particle in each half octave or, if
 * particles were not counted, the share of the impacts, %.  first: only the
 * first impact of each particle. */
static void
fill_impact_energy_series(struct chart_series *series, const struct energies *e,
    const struct spectrum_size *whole, bool first)
{
	const struct spectrum *s = e->c.spectrum;
	double all = spectrum_impacts_above(whole, 0, false).mass;
	double per = s->counted ? whole->mass : all / 100;
	chart_add_point_names(series);
	for (size_t i = 0; i < POINTS; i++) {
		double sum = 0;
		for (size_t b = i * BINS_PER_POINT;
		     b < (i + 1) * BINS_PER_POINT; b++)
			sum +=
			    first ? whole->first[b].mass : whole->all[b].mass;
		series->x[i] =
		    spectrum_bin_edge(i * BINS_PER_POINT + BINS_PER_POINT / 2);
		series->y[i] = sum / per;
		series->whose[i].about = xstrdup(origin_of_energies(e));
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
	FREED char *speed = speed_in_brackets(e);
	fill_impact_energy_series(
	    chart_add(chart,
		main ? SITE_CHART_PREDICTED : site_chart_series_style(place),
		POINTS, "%s%s", e->name, speed),
	    e, whole, false);
	if (main && s->ordered)
		fill_impact_energy_series(
		    chart_add(chart, of_first, POINTS,
			"first impact above %g J/kg%s", e->cut, speed),
		    e, whole, true);
}

static void
add_specific_energy_rule(struct chart *chart, const struct energies *e)
{
	double speed = e->c.spectrum->speed;
	double E = specific_energy_at_speed(speed);
	FREED char *at = speed_in_brackets(e);
	if (speed > 0)
		chart_add_rule(
		    chart, SERIES_CROSSHAIR, E, "v^2/2%s: %.0f J/kg", at, E);
}

/* True if a chart of energies e shows those of `other`, too. */
static bool
are_drawn_together(const struct energies *e, const struct energies *other)
{
	return other != e &&
	       other->c.spectrum->counted == e->c.spectrum->counted;
}

/* Returns the origin of all energies that are drawn, each after its name if
 * there are several.  The caller frees it. */
static char *
origins_of_drawn_energies(const struct session *s, const struct energies *e)
{
	char *all = xstrdup("");
	for (size_t i = 0; i < s->n_energies; i++)
		if (are_drawn_together(e, s->energies[i]))
			xappend_to_list(&all, ". ", "%s: %s",
			    s->energies[i]->name,
			    origin_of_energies(s->energies[i]));
	if (all[0] != '\0')
		xappend_to_list(&all, ". ", "%s: ", e->name);
	xappend(&all, "%s", origin_of_energies(e));
	return all;
}

/* Returns the axis of the energies drawn, which ends beyond all of v^2/2. */
static struct axis
energy_axis(const struct session *s)
{
	double most = 1e4;
	for (size_t i = 0; i < s->n_energies; i++) {
		double speed = s->energies[i]->c.spectrum->speed;
		if (speed > 0)
			most = fmax(most, 2 * specific_energy_at_speed(speed));
	}
	return axis_new_log(tr("energy of an impact, J/kg"), 0.01, most);
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
	FREED char *about = origins_of_drawn_energies(s, e);
	struct chart *chart = chart_new(tr("collision energies"), about,
	    energy_axis(s), axis_new_linear("", 0, 1));
	for (size_t i = 0; i < s->n_energies; i++)
		if (are_drawn_together(e, s->energies[i])) {
			add_impact_energy_curves(
			    chart, s->energies[i], false, i);
			add_specific_energy_rule(chart, s->energies[i]);
		}
	add_impact_energy_curves(chart, e, true, 0);
	axis_free(&chart->y);
	chart->y =
	    axis_new_linear(of->counted ? tr("impacts per particle and half "
					     "octave, -")
					: tr("share of impacts per half "
					     "octave, %"),
		0, chart_find_extent(chart).y[1]);
	chart_add_rule(chart, SERIES_BREAK, e->cut, "cut %g J/kg", e->cut);
	add_specific_energy_rule(chart, e);
	return chart;
}

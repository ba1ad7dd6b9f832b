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
energies_origin_text(const struct energies *e)
{
	return e->c.about[0] != '\0' ? e->c.about : tr("origin not stated");
}

/* Returns " (69 m/s)", or "" if the speed is not stated.  The caller frees
 * it. */
static char *
speed_in_brackets_text(const struct energies *e)
{
	double speed = e->c.spectrum->speed;
	return speed > 0 ? xasprintf(" (%g m/s)", speed) : xstrdup("");
}

/* Fills a series with the impacts per particle in each half octave or, if
 * particles were not counted, the share of the impacts, %.  first: only the
 * first impact of each particle. */
static void
fill_energy_spectrum_series(struct chart_series *series,
    const struct energies *e, const struct spectrum_size *whole, bool first)
{
	const struct spectrum *s = e->c.spectrum;
	double all = spectrum_impacts_above_energy(whole, 0, false).mass;
	double per = s->counted ? whole->mass : all / 100;
	chart_allocate_point_names(series);
	for (size_t i = 0; i < POINTS; i++) {
		double sum = 0;
		for (size_t b = i * BINS_PER_POINT;
		     b < (i + 1) * BINS_PER_POINT; b++)
			sum +=
			    first ? whole->first[b].mass : whole->all[b].mass;
		series->x[i] =
		    spectrum_bin_edge(i * BINS_PER_POINT + BINS_PER_POINT / 2);
		series->y[i] = sum / per;
		series->whose[i].about = xstrdup(energies_origin_text(e));
	}
}

static void
add_impact_energy_curves(
    struct chart *chart, const struct energies *e, bool main, size_t place)
{
	const struct spectrum *s = e->c.spectrum;
	FREED struct spectrum_size *whole = spectrum_sum_over_sizes(s);
	const struct chart_series of_first = {
	    .series = SERIES_FEED, .line = CHART_DASHED, .ascii = '-'};
	FREED char *speed = speed_in_brackets_text(e);
	fill_energy_spectrum_series(
	    chart_append_series(chart,
		main ? SITE_CHART_PREDICTED : site_chart_series_style(place),
		POINTS, "%s%s", e->name, speed),
	    e, whole, false);
	if (main && s->ordered)
		fill_energy_spectrum_series(
		    chart_append_series(chart, of_first, POINTS,
			"first impact above %g J/kg%s", e->cut, speed),
		    e, whole, true);
}

static void
add_rule_at_specific_energy(struct chart *chart, const struct energies *e)
{
	double speed = e->c.spectrum->speed;
	double E = specific_energy_at_speed(speed);
	FREED char *at = speed_in_brackets_text(e);
	if (speed > 0)
		chart_add_vertical_rule(
		    chart, SERIES_CROSSHAIR, E, "v^2/2%s: %.0f J/kg", at, E);
}

/* True if a chart of energies e shows those of `other`, too. */
static bool
are_energies_in_same_chart(
    const struct energies *e, const struct energies *other)
{
	return other != e &&
	       other->c.spectrum->counted == e->c.spectrum->counted;
}

/* Returns the origin of all energies that are drawn, each after its name if
 * there are several.  The caller frees it. */
static char *
drawn_energies_origin_text(const struct session *s, const struct energies *e)
{
	char *all = xstrdup("");
	for (size_t i = 0; i < s->n_energies; i++)
		if (are_energies_in_same_chart(e, s->energies[i]))
			xappend_to_list(&all, ". ", "%s: %s",
			    s->energies[i]->name,
			    energies_origin_text(s->energies[i]));
	if (all[0] != '\0')
		xappend_to_list(&all, ". ", "%s: ", e->name);
	xappend(&all, "%s", energies_origin_text(e));
	return all;
}

/* Returns the axis of the energies drawn, which ends beyond all of v^2/2. */
static struct axis
impact_energy_axis(const struct session *s)
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
	FREED char *about = drawn_energies_origin_text(s, e);
	struct chart *chart = chart_new(tr("collision energies"), about,
	    impact_energy_axis(s), axis_new_linear("", 0, 1));
	for (size_t i = 0; i < s->n_energies; i++)
		if (are_energies_in_same_chart(e, s->energies[i])) {
			add_impact_energy_curves(
			    chart, s->energies[i], false, i);
			add_rule_at_specific_energy(chart, s->energies[i]);
		}
	add_impact_energy_curves(chart, e, true, 0);
	axis_free(&chart->y);
	chart->y =
	    axis_new_linear(of->counted ? tr("impacts per particle and half "
					     "octave, -")
					: tr("share of impacts per half "
					     "octave, %"),
		0, chart_compute_extent(chart).y[1]);
	chart_add_vertical_rule(
	    chart, SERIES_BREAK, e->cut, "cut %g J/kg", e->cut);
	add_rule_at_specific_energy(chart, e);
	return chart;
}

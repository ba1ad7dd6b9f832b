/* Charts titled with the site's name, with the source of its data below, and
 * the styles of series.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/draw/site_chart.h"

#include <math.h>
#include <stdarg.h>
#include <stdlib.h>

#include "base/tr.h"
#include "base/xalloc.h"
#include "cmd/ask/answers.h"
#include "cmd/ask/moved.h"
#include "cmd/ask/quantity_words.h"
#include "core/psd/rotor_speed.h"
#include "io/formats/spec.h"
#include "io/sitefile/units.h"

struct chart *
site_chart_new(const struct site *site, struct axis x, struct axis y,
    const char *format, ...)
{
	va_list ap;
	va_start(ap, format);
	FREED char *words = xvasprintf(tr(format), ap),
		   *label = session_site_label(site);
	va_end(ap);
	FREED char *title = xasprintf("%s: %s", label, words);
	FREED char *clause = site_provenance_first_clause(
		       site, "provenance not stated"),
		   *about = site_translate_provenance(clause);
	return chart_new(title, about, x, y);
}

struct axis
site_chart_sieve_axis(const double *size, size_t n)
{
	FREED double *mm = xcalloc_doubles(n);
	for (size_t i = 0; i < n; i++)
		mm[i] = units_m_to_mm(size[i]);
	return axis_new_sieves(tr("size, mm"), mm, n);
}

static void
fill_series_from_psd(struct chart_series *s, const struct psd *psd)
{
	for (size_t i = 0; i < psd->n; i++) {
		s->x[i] = units_m_to_mm(psd->size[i]);
		s->y[i] = units_fraction_to_pct(psd->passing[i]);
	}
}

void
site_chart_add_psd(struct chart *chart, struct chart_series look,
    const struct psd *psd, const struct psd *finer, char *name)
{
	struct chart_series *s =
	    chart_append_series(chart, look, psd->n, "%s", name);
	s->psd = true;
	fill_series_from_psd(s, psd);
	if (finer != NULL)
		fill_series_from_psd(
		    chart_allocate_finer_points(s, finer->n), finer);
	free(name);
}

void
site_chart_set_sieve_axis(struct chart *chart)
{
	size_t n = 0;
	FREED double *mm = NULL;
	for (size_t i = 0; i < chart->n; i++) {
		const struct chart_series *s = chart->series[i];
		mm = xrealloc(mm, n + s->n + 1, sizeof *mm);
		for (size_t j = 0; j < s->n; j++)
			mm[n++] = s->x[j];
	}
	chart->x = axis_new_sieves(tr("size, mm"), mm, n);
}

void
site_chart_set_point_with_band(
    struct chart_series *s, size_t k, double x, struct figure at)
{
	if (s->low == NULL)
		series_allocate_band(s);
	s->x[k] = x;
	s->y[k] = at.value;
	s->low[k] = at.low;
	s->high[k] = at.high;
}

void
site_chart_close_band_at_gaps(struct chart_series *s)
{
	bool band = false;
	for (size_t k = 0; k < s->n; k++) {
		band = band || isfinite(s->low[k]) || isfinite(s->high[k]);
		s->low[k] = isnan(s->low[k]) ? s->y[k] : s->low[k];
		s->high[k] = isnan(s->high[k]) ? s->y[k] : s->high[k];
	}
	if (!band)
		series_remove_band(s);
}

void
site_chart_fill_forecast_by_speed(struct forecast *f, size_t n, double from,
    double to, struct chart_series *const *line)
{
	size_t points = line[0]->n;
	for (size_t k = 0; k < points; k++) {
		double speed =
		    from + (to - from) * (double)k / (double)(points - 1);
		forecast_set_speed(f, speed);
		for (size_t i = 0; i < n; i++)
			site_chart_set_point_with_band(line[i], k, speed,
			    forecast_value_in_shown_unit(f, i));
	}
	for (size_t i = 0; i < n; i++)
		site_chart_close_band_at_gaps(line[i]);
}

void
site_chart_show_speeds_in_rpm(struct chart *chart, const struct site *site)
{
	if (!answers_is_sheet_in_rpm(site))
		return;
	const double rpm = rotor_speed_to_rpm(1, site->rotor);
	struct axis axis = axis_new_linear(
	    tr("rotor speed, rpm"), rpm * chart->x.low, rpm * chart->x.high);
	size_t n = 0;
	axis.low = rpm * chart->x.low;
	axis.high = rpm * chart->x.high;
	for (size_t i = 0; i < axis.n; i++)
		if (axis.tick[i].at >= axis.low && axis.tick[i].at <= axis.high)
			axis.tick[n++] = axis.tick[i];
	axis.n = n;
	axis_free(&chart->x);
	chart->x = axis;
	for (size_t i = 0; i < chart->n; i++)
		for (size_t k = 0; k < chart->series[i]->n; k++)
			chart->series[i]->x[k] *= rpm;
	for (size_t i = 0; i < chart->n_rule; i++)
		chart->rule[i].x *= rpm;
}

const struct chart_series SITE_CHART_FEED = {.series = SERIES_FEED,
			      .line = CHART_DOTTED,
			      .ascii = '.'},
			  SITE_CHART_LEVEL = {.series = SERIES_TEXT,
			      .line = CHART_DOTTED,
			      .ascii = '.'},
			  SITE_CHART_PREDICTED = {.series = SERIES_PREDICTED,
			      .line = CHART_SOLID,
			      .ascii = '#'};

struct chart_series
site_chart_series_style(size_t i)
{
	static const char MARKS[] = "v^ox*+@&$%szNHKTUYAEMRW", ASCII[] = "=-~_";
	static const enum chart_line LINES[] = {
	    CHART_SOLID, CHART_DASHED, CHART_LONG};
	enum { COLOURS = sizeof ASCII - 1 };
	return (struct chart_series){
	    .series = (enum series)(SERIES_KIND_1 + i % COLOURS),
	    .line = LINES[i / COLOURS % ARRAY_LEN(LINES)],
	    .ascii = ASCII[i % COLOURS],
	    .mark = MARKS[i % (sizeof MARKS - 1)]};
}

struct chart_series
site_chart_run_style(const struct site *site, size_t run, bool held_out)
{
	enum { COLOURS = 4 };
	unsigned i = 0, n = 0;
	for (size_t r = 0; r <= run; r++) {
		n += site->run[r].product.n > 0 &&
		     !site_run_repeats_speed(site, r);
		i = n > 0 ? n - 1 : 0;
	}
	return (struct chart_series){
	    .series = (enum series)(SERIES_MEASURED_1 + i % COLOURS),
	    .line = CHART_MARKS,
	    .mark = nth_mark_character(i, held_out),
	    .fine = true};
}

void
site_chart_note_run_marks(struct chart *chart, const struct site *site)
{
	size_t left_out = site_chart_count_speeds_left_out(site);
	bool hollow = false;
	for (size_t i = 0; i < chart->n; i++) {
		const struct chart_series *s = chart->series[i];
		hollow = hollow ||
			 (s->fine && point_mark_of_character(s->mark)->hollow);
	}
	if (hollow)
		chart_add_note(chart, "hollow marks: held out from the fit");
	if (left_out > 0)
		chart_add_note(
		    chart, "%zu measured speeds not drawn", left_out);
}

void
site_chart_note_moved_products(struct chart *chart, double most)
{
	if (most > MOVED_MENTIONED)
		chart_add_note(chart, "measured products moved to this feed");
}

size_t
site_chart_count_speeds_left_out(const struct site *site)
{
	size_t n = 0;
	for (size_t i = 0; i < site->n_run; i++)
		n += site->run[i].product.n > 0 &&
		     !site_run_repeats_speed(site, i);
	return n > SITE_CHART_SPEEDS ? n - SITE_CHART_SPEEDS : 0;
}

struct fraction
session_envelope_size_fraction(const struct session *s)
{
	const struct spec *spec = s->spec;
	return (struct fraction){.fine = spec != NULL ? spec->cut[0] : 0,
	    .coarse = spec != NULL ? spec->cut[1] : 0,
	    .partition = PARTITION_IDEAL};
}

char *
session_envelope_size_fraction_text(const struct session *s)
{
	struct fraction fraction = session_envelope_size_fraction(s);
	return fraction_is_screened(&fraction)
		   ? quantities_fraction_text(&fraction)
		   : xstrdup("");
}

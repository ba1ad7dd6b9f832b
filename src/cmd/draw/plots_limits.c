/* Plots the limits of each sieve as two series; screens a product's fraction in
 * the same way, from the curve of the whole.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/draw/plots_limits.h"

#include <math.h>
#include <string.h>

#include "base/tr.h"
#include "base/xalloc.h"
#include "cmd/ask/quantity_words.h"
#include "cmd/ask/screened.h"
#include "io/formats/spec.h"
#include "io/sitefile/units.h"

const struct chart_series PLOTS_LIMITS[2] = {
    {.series = SERIES_TEXT, .line = CHART_DOTTED, .ascii = '\'', .mark = 'T'},
    {.series = SERIES_TEXT, .line = CHART_DOTTED, .ascii = '\'', .mark = 'L'}};

static struct fraction
fraction_of_envelope(const struct spec *spec)
{
	return (struct fraction){.fine = spec != NULL ? spec->cut[0] : 0,
	    .coarse = spec != NULL ? spec->cut[1] : 0,
	    .partition = PARTITION_IDEAL};
}

char *
plots_envelope_fraction_text(const struct session *s)
{
	struct fraction fraction = fraction_of_envelope(s->spec);
	return fraction_is_screened(&fraction)
		   ? quantities_fraction_text(&fraction)
		   : xstrdup("");
}

/* Adds the lower or the upper limits that lie within the axis, if there are
 * any. */
static void
add_envelope_limit_series(
    struct chart *chart, const struct spec *spec, bool least)
{
	const double *limit = least ? spec->least : spec->most;
	size_t n = 0;
	FREED double *at = xcalloc_doubles(2 * spec->n);
	for (size_t i = 0; i < spec->n; i++) {
		double mm = units_mm(spec->size[i]);
		if (mm < chart->x.low || mm > chart->x.high || isnan(limit[i]))
			continue;
		at[2 * n] = mm;
		at[2 * n++ + 1] = units_pct(limit[i]);
	}
	if (n > 0) {
		struct chart_series *series =
		    chart_add(chart, PLOTS_LIMITS[least], n, "%s, %s",
			least ? tr("min") : tr("max"), spec->name);
		for (size_t i = 0; i < n; i++) {
			series->x[i] = at[2 * i];
			series->y[i] = at[2 * i + 1];
		}
		chart_move_last_series_to_back(chart);
	}
}

void
plots_envelope_add_limits(
    struct chart *chart, const struct session *s, bool notes)
{
	const struct spec *spec = s->spec;
	if (spec == NULL)
		return;
	add_envelope_limit_series(chart, spec, true);
	add_envelope_limit_series(chart, spec, false);
	FREED char *cut = plots_envelope_fraction_text(s);
	const char *source =
	    spec->source[0] != '\0' ? spec->source : spec->name;
	if (notes && cut[0] != '\0')
		chart_note(chart, "limits of the fraction %s: %s", cut, source);
	else if (notes)
		chart_note(chart, "limits: %s", source);
}

bool
plots_envelope_cut_product(const struct session *s, const struct entry *entry,
    const struct prediction *whole, struct prediction *part)
{
	struct fraction fraction = fraction_of_envelope(s->spec);
	if (!fraction_is_screened(&fraction))
		return false;
	/* The sizes of the cut are included, so that the curve ends there. */
	const double cut[] = {fraction.fine, fraction.coarse};
	const struct psd *feed = site_feed_of_run(entry->site, whole->feed_run);
	const struct psd *sieves = &whole->product;
	struct psd all = psd_new(sieves->n + ARRAY_LEN(cut));
	all.n = sieves->n;
	memcpy(all.size, sieves->size, sieves->n * sizeof *sieves->size);
	for (size_t i = 0; i < ARRAY_LEN(cut); i++)
		if (cut[i] > 0 && psd_covers_size(feed, cut[i]) &&
		    cut[i] < sieves->size[0])
			all.size[all.n++] = cut[i];
	all.n = psd_sort_distinct_sizes(all.size, all.n, 0);
	/* The curve of the whole product is exact enough for a drawing.  A
	 * response of the fraction's own would take longer than the rest of a
	 * step of the slider. */
	struct psd curve =
	    screened_fraction_of_product(&whole->curve, &fraction);
	for (size_t i = 0; i < all.n; i++)
		all.passing[i] = psd_passing(&curve, all.size[i]);
	psd_free(&curve);
	*part = (struct prediction){.product = all};
	return true;
}

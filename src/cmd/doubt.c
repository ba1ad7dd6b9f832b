/* Uncertainty as commands show it.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/doubt.h"

#include <stdlib.h>
#include <string.h>

#include "base/xalloc.h"
#include "cmd/answers.h"
#include "io/units.h"

struct doubt *
doubt_new(const struct site *site, const struct calibrate_options *options)
{
	struct doubt *d = xcalloc(1, sizeof *d);
	*d = (struct doubt){.holders = 1,
	    .misfit = calibrate_misfit(site, options),
	    .bounds = options->bounds};
	return d;
}

void
doubt_drop(struct doubt *d)
{
	if (d == NULL || --d->holders > 0)
		return;
	misfit_free(d->misfit);
	free(d->uncertainty);
	band_free(&d->band);
	free(d);
}

const struct uncertainty *
doubt_of(const struct entry *entry)
{
	struct doubt *d = entry->doubt;
	if (!entry->has_fit || d == NULL)
		return NULL;
	if (d->uncertainty == NULL)
		d->uncertainty = uncertainty_new(
		    d->misfit, &entry->fit.params, &d->bounds, entry->fit.seed);
	return d->uncertainty;
}

static bool
same_settings(const struct model_settings *a, const struct model_settings *b)
{
	return a->method == b->method && a->appearance == b->appearance &&
	       a->k == b->k;
}

const struct band *
doubt_band(const struct session *s, const struct entry *entry,
    const struct prediction *p)
{
	struct doubt *d = entry->doubt;
	const struct uncertainty *u =
	    same_settings(&s->settings, &entry->fit.settings) ? doubt_of(entry)
							      : NULL;
	if (u == NULL)
		return NULL;
	if (d->band.n == p->product.n && d->band_of.speed == p->speed &&
	    d->band_of.feed_run == p->feed_run &&
	    same_settings(&d->band_of.settings, &s->settings))
		return &d->band;
	band_free(&d->band);
	d->band = uncertainty_band(u, &entry->params,
	    &entry->site->run[p->feed_run].feed, &p->product, s->settings,
	    p->speed);
	d->band_of = (struct band_of){s->settings, p->speed, p->feed_run};
	return &d->band;
}

void
doubt_columns(struct report *r)
{
	report_column(r, "low", "low");
	report_column(r, "high", "high");
}

void
doubt_cells(struct report *r, const struct uncertainty *u, size_t j)
{
	report_number(r, u != NULL ? u->low[j] : NAN, 4);
	report_number(r, u != NULL ? u->high[j] : NAN, 4);
}

void
doubt_note(struct report *r)
{
	report_note(r,
	    "low to high: %d %% of the fits that the data allow lie between",
	    UNCERTAINTY_LEVEL);
}

static json_t *
pair(double low, double high)
{
	return json_pack(
	    "[o, o]", report_json_number(low), report_json_number(high));
}

json_t *
doubt_json(const struct uncertainty *u)
{
	json_t *o = json_object();
	for (size_t j = 0; j < PARAM_COUNT; j++)
		json_object_set_new(
		    o, PARAMS[j].name, pair(u->low[j], u->high[j]));
	return o;
}

static void
set_range(json_t *o, const char *key, const double range[2])
{
	json_object_set_new(o, key, pair(1000 * range[0], 1000 * range[1]));
}

void
doubt_band_json(json_t *o, const struct band *band)
{
	json_object_set_new(
	    o, "low_pct", answers_list_json(band->low, band->n, units_pct));
	json_object_set_new(
	    o, "high_pct", answers_list_json(band->high, band->n, units_pct));
	set_range(o, "p20_range_mm", band->p20);
	set_range(o, "p50_range_mm", band->p50);
	set_range(o, "p80_range_mm", band->p80);
	set_range(o, "break_range_mm", band->break_size);
}

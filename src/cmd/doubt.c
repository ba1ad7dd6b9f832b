/* Uncertainty as commands show it.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/doubt.h"

#include <math.h>
#include <stdlib.h>

#include "base/xalloc.h"
#include "cmd/answers.h"
#include "io/units.h"

const struct uncertainty *
doubt_of(const struct entry *entry)
{
	struct history *h = entry->history;
	if (!entry->has_fit || h == NULL)
		return NULL;
	if (h->uncertainty == NULL)
		h->uncertainty = uncertainty_new(
		    h->misfit, &entry->fit.params, &h->bounds, entry->fit.seed);
	return h->uncertainty;
}

const struct band *
doubt_band(const struct session *s, const struct entry *entry,
    const struct prediction *p)
{
	struct history *h = entry->history;
	const struct uncertainty *u =
	    model_settings_same(&s->set.model, &entry->fit.settings)
		? doubt_of(entry)
		: NULL;
	if (u == NULL)
		return NULL;
	if (h->band.n == p->product.n && h->band_of.speed == p->speed &&
	    h->band_of.feed_run == p->feed_run &&
	    model_settings_same(&h->band_of.settings, &s->set.model))
		return &h->band;
	band_free(&h->band);
	h->band = uncertainty_band(u, &entry->params,
	    &entry->site->run[p->feed_run].feed, &p->product, s->set.model,
	    p->speed);
	h->band_of = (struct band_of){s->set.model, p->speed, p->feed_run};
	return &h->band;
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
	set_range(o, "p20_range_mm", band->p20);
	set_range(o, "p50_range_mm", band->p50);
	set_range(o, "p80_range_mm", band->p80);
	set_range(o, "break_range_mm", band->break_size);
}

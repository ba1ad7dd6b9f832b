/* Uncertainty as commands show it.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/doubt.h"

#include <math.h>
#include <stdlib.h>

#include "base/xalloc.h"
#include "cmd/answers.h"
#include "cmd/fit.h"

const struct uncertainty *
doubt_of(const struct entry *entry)
{
	struct history *h = entry->history;
	if (!entry->has_fit || h == NULL || fit_too_few(&entry->fit))
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

const char *
doubt_why_none(const struct entry *entry)
{
	return !entry->has_fit
		   ? "no band: parameters that are no fit of this site have "
		     "none"
	       : fit_too_few(&entry->fit)
		   ? "no band: too few data for so many parameters"
		   : "no band: the fit was found with other settings";
}

void
doubt_note(struct report *r)
{
	report_note(r,
	    "low to high: %d %% of the fits that the data allow lie between",
	    UNCERTAINTY_LEVEL);
}

void
doubt_put_interval(json_t *o, const struct uncertainty *u)
{
	json_t *interval = u != NULL ? json_object() : json_null();
	for (size_t j = 0; u != NULL && j < PARAM_COUNT; j++)
		answers_put_pair(
		    interval, PARAMS[j].name, u->low[j], u->high[j]);
	json_object_set_new(o, "interval", interval);
}

void
doubt_put_band(json_t *o, const struct band *band)
{
	static const char *const KEYS[] = {
	    "p20_range_mm", "p50_range_mm", "p80_range_mm", "break_range_mm"};
	for (size_t i = 0; i < ARRAY_LEN(KEYS); i++)
		answers_put_pair(o, KEYS[i], 1000 * band->size[i][0],
		    1000 * band->size[i][1]);
}

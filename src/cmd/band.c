/* Uncertainty as commands show it.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/band.h"

#include <math.h>
#include <stdlib.h>

#include "base/xalloc.h"
#include "cmd/answers.h"
#include "cmd/fit.h"

const struct uncertainty *
band_draws(const struct entry *entry)
{
	const struct fit *fit = origin_fit(entry);
	if (fit == NULL || fit_too_few(fit))
		return NULL;
	struct history *h = entry->origin->spread;
	if (h->uncertainty == NULL)
		h->uncertainty = uncertainty_new(
		    h->misfit, &fit->params, &h->bounds, fit->seed);
	return h->uncertainty;
}

const struct band *
band_at(const struct session *s, const struct entry *entry,
    const struct prediction *p)
{
	const struct fit *fit = origin_fit(entry);
	bool same =
	    fit != NULL && model_settings_same(&s->set.model, &fit->settings);
	const struct uncertainty *u = same ? band_draws(entry) : NULL;
	if (u == NULL)
		return NULL;
	struct history *h = entry->origin->spread;
	if (h->band.n == p->product.n && h->band_of.site == entry->site &&
	    h->band_of.speed == p->speed &&
	    h->band_of.feed_run == p->feed_run &&
	    model_settings_same(&h->band_of.settings, &s->set.model))
		return &h->band;
	band_free(&h->band);
	h->band = uncertainty_band(u, &entry->params,
	    &entry->site->run[p->feed_run].feed, &p->product, s->set.model,
	    p->speed);
	h->band_of =
	    (struct band_of){entry->site, s->set.model, p->speed, p->feed_run};
	return &h->band;
}

const char *
band_why_none(const struct entry *entry)
{
	const struct fit *fit = origin_fit(entry);
	return fit == NULL ? "no uncertainty band: the parameters do not come "
			     "from a calibration in this session"
	       : fit_too_few(fit) ? "no uncertainty band: too few data for the "
				    "number of parameters"
				  : "no uncertainty band: the site was "
				    "calibrated with other settings";
}

void
band_note(struct answer *r, const struct entry *entry)
{
	if (entry->has_fit)
		answer_say(r, ANSWER_REMARK,
		    "low, high: %d %% of the fits consistent with the data lie "
		    "between them",
		    UNCERTAINTY_LEVEL);
	else
		answer_say(r, ANSWER_REMARK,
		    "low, high: %d %% of the fits consistent with the data of "
		    "%s lie between them; the difference between the two sites "
		    "is not included",
		    UNCERTAINTY_LEVEL, origin_key(entry));
}

void
band_put_interval(struct fields *o, const struct uncertainty *u)
{
	if (u == NULL) {
		fields_put(o, "interval %g", NAN);
		return;
	}
	struct fields *interval = fields_object(o, "interval");
	const struct breakage *of = breakage_of(&u->draw[0]);
	for (size_t j = 0; j < of->n; j++)
		answers_put_pair(
		    interval, of->parameter[j].name, u->low[j], u->high[j]);
}

void
band_put(struct fields *o, const struct band *band)
{
	for (size_t i = 0; i < ANSWERS_SIZES; i++)
		answers_put_pair(o, ANSWERS_RANGES[i], 1000 * band->size[i][0],
		    1000 * band->size[i][1]);
}

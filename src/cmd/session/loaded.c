/* The entry of a loaded site, and where its parameters are from.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/session/loaded.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "base/tr.h"
#include "base/xalloc.h"

static void
free_cached_ensembles(struct history *h)
{
	for (size_t i = 0; i < ARRAY_LEN(h->kept); i++) {
		ensemble_free(h->kept[i].ensemble);
		h->kept[i].ensemble = NULL;
	}
}

void
history_reset_posteriors(struct history *h, const struct settings *set)
{
	for (size_t i = 0; i < ARRAY_LEN(h->posterior); i++) {
		posterior_free(h->posterior[i]);
		h->posterior[i] = NULL;
		free(h->evidence[i]);
		h->evidence[i] = NULL;
	}
	posterior_free(posterior_end(h->drawing));
	h->drawing = NULL;
	free_cached_ensembles(h);
	h->later.site = NULL;
	h->alarm.site = NULL;
	h->noise = set->noise;
	h->speed_sd = set->speed_sd;
	h->draw_seed = set->draw_seed;
}

void
history_free_ensembles_of_site(struct history *h, const struct site *site)
{
	if (h == NULL)
		return;
	if (h->later.site == site)
		h->later.site = NULL;
	if (h->kept[0].site == site || h->kept[1].site == site)
		free_cached_ensembles(h);
}

const struct entry *
entry_without_scenario(const struct entry *entry)
{
	return entry->scenario != NULL ? entry->scenario->own : entry;
}

double
entry_rotor_of_calibration(const struct entry *entry)
{
	bool known = entry->origin != NULL && entry->origin->history != NULL;
	return known ? entry->origin->history->site->rotor : entry->site->rotor;
}

struct history *
history_new(const struct fit *fit, const struct bounds *bounds, double weight,
    const struct site *site, const bool *train)
{
	struct history *h = xcalloc(1, sizeof *h);
	*h = (struct history){.holders = 1,
	    .fit = *fit,
	    .bounds = *bounds,
	    .weight = weight,
	    .site = site,
	    .train = xcalloc(site->n_run, sizeof *h->train)};
	memcpy(h->train, train, site->n_run * sizeof *train);
	return h;
}

void
history_release(struct history *h)
{
	if (h == NULL || --h->holders > 0)
		return;
	history_reset_posteriors(h, &(struct settings){0});
	free(h->generation);
	free(h->train);
	free(h);
}

static struct origin *
origin_new(char *words, const char *from, const char *provenance)
{
	struct origin *o = xcalloc(1, sizeof *o);
	*o = (struct origin){.holders = 1,
	    .words = words,
	    .from = xstrdup(from),
	    .material = xstrdup(""),
	    .date = xstrdup(""),
	    .provenance = xstrdup(provenance)};
	return o;
}

static void
origin_add_training_speed(struct origin *o, double speed)
{
	o->speed = xrealloc(o->speed, o->n_speed + 1, sizeof *o->speed);
	o->speed[o->n_speed++] = speed;
}

static struct history *
retain_fit_history(struct history *h)
{
	if (h != NULL)
		h->holders++;
	return h;
}

static struct origin *
retain_origin(struct origin *origin)
{
	if (origin != NULL)
		origin->holders++;
	return origin;
}

struct origin *
origin_new_of_fit(const struct entry *entry)
{
	const struct site *site = entry->site;
	struct origin *o =
	    origin_new(xstrdup("found by calibration"), "", site->provenance);
	o->found = true;
	o->digest = site->digest;
	o->history = retain_fit_history(entry->history);
	for (size_t r = 0; r < site->n_run; r++)
		if (entry->train[r] && !site_run_repeats_speed(site, r))
			origin_add_training_speed(o, site->run[r].speed);
	return o;
}

struct origin *
origin_new_by_hand(void)
{
	return origin_new(xstrdup("set by hand"), "", "");
}

struct origin *
origin_new_of_copied_params(const struct entry *from)
{
	struct origin *was = from->origin;
	if (was->from[0] != '\0')
		return retain_origin(was);
	struct origin *o = origin_new(xasprintf(tr("taken from %s"), from->key),
	    from->key, was->provenance);
	o->found = was->found;
	o->digest = was->digest;
	o->history = retain_fit_history(was->history);
	for (size_t i = 0; i < was->n_speed; i++)
		origin_add_training_speed(o, was->speed[i]);
	return o;
}

static void
set_origin_material(struct origin *o, const struct material *m)
{
	xfree_and_set(&o->material, xstrdup(m->name));
	xfree_and_set(&o->date, xstrdup(m->date));
}

struct origin *
origin_new_of_remembered_fit(
    const struct entry *entry, const struct material *m)
{
	struct origin *o = origin_new_of_fit(entry);
	xfree_and_set(&o->words,
	    m->date[0] != '\0'
		? xasprintf(tr("remembered on %s as %s"), m->date, m->name)
		: xasprintf(tr("remembered as %s"), m->name));
	set_origin_material(o, m);
	return o;
}

bool
origin_is_from_store(const struct origin *o)
{
	return o != NULL && o->material[0] != '\0';
}

struct origin *
origin_new_from_store(const struct material *m)
{
	struct origin *o = origin_new(
	    xasprintf(tr("from store: %s"), m->name), m->name, m->provenance);
	set_origin_material(o, m);
	o->digest = strtoull(m->site_digest, NULL, 16);
	FREED char *list = xstrdup(m->train_mps);
	char *next = NULL;
	for (char *word = strtok_r(list, ",", &next); word != NULL;
	     word = strtok_r(NULL, ",", &next)) {
		double speed;
		if (text_parse_number(word, &speed))
			origin_add_training_speed(o, speed);
	}
	o->found = strcmp(m->origin, "hand") != 0 || o->n_speed > 0;
	return o;
}

void
origin_release(struct origin *o)
{
	if (o == NULL || --o->holders > 0)
		return;
	free(o->words);
	free(o->from);
	free(o->material);
	free(o->date);
	free(o->provenance);
	free(o->speed);
	history_release(o->history);
	free(o);
}

bool
origin_is_same(const struct origin *a, const struct origin *b)
{
	return a == b || (a != NULL && b != NULL && a->history == b->history &&
			     strcmp(a->words, b->words) == 0);
}

const struct fit *
origin_fit_behind_params(const struct entry *entry)
{
	bool known = entry->origin != NULL && entry->origin->history != NULL;
	return known ? &entry->origin->history->fit : NULL;
}

const char *
origin_site_key(const struct entry *entry)
{
	bool own = entry->origin == NULL || entry->origin->from[0] == '\0';
	return own ? entry->key : entry->origin->from;
}

bool
origin_has_training_speeds(const struct entry *entry)
{
	return entry->origin != NULL && entry->origin->n_speed > 0;
}

bool
origin_training_speed_range(
    const struct entry *entry, double *slowest, double *fastest)
{
	const struct origin *o = entry->origin;
	const struct site *site = entry->site;
	*slowest = INFINITY;
	*fastest = 0;
	bool other = origin_has_training_speeds(entry);
	size_t n = other ? o->n_speed : site->n_run;
	for (size_t i = 0; i < n; i++) {
		if (!other && !entry->train[i])
			continue;
		double v = other ? o->speed[i] : site->run[i].speed;
		*slowest = fmin(*slowest, v);
		*fastest = fmax(*fastest, v);
	}
	return *fastest > 0;
}

char *
origin_training_speeds_text(const struct origin *o)
{
	if (!o->found)
		return xstrdup(tr("set by hand"));
	FREED char *speeds = xstrdup("");
	for (size_t i = 0; i < o->n_speed; i++)
		xappend_to_list(&speeds, ", ", "%g", o->speed[i]);
	xend_list_with(&speeds, tr(" and "));
	char *text = o->n_speed > 0 ? xasprintf(tr("trained at %s m/s"), speeds)
				    : xstrdup(tr("training speeds not known"));
	const char *kind = tr(site_data_kind(o->provenance));
	if (o->provenance[0] == '\0')
		xappend_to_list(&text, "; ", "%s",
		    tr("the origin of their data is not stated"));
	else if (site_is_data_made_up(o->provenance))
		xappend_to_list(&text, "; ", tr("%s, not measured"), kind);
	else
		xappend_to_list(&text, "; ", "%s", kind);
	if (o->date[0] != '\0')
		xappend_to_list(&text, "; ", tr("remembered on %s"), o->date);
	return text;
}

bool
origin_is_other_site(const struct entry *entry)
{
	const struct origin *o = entry->origin;
	return !entry->has_fit && o != NULL && o->from[0] != '\0' &&
	       !(o->found && o->digest == entry->site->digest);
}

char *
origin_params_source_sentence(const struct entry *entry)
{
	const struct origin *o = entry->origin;
	if (!origin_is_from_store(o) &&
	    (o == NULL || entry->has_fit || o->from[0] == '\0'))
		return xstrdup("");
	if (o->from[0] == '\0')
		return xasprintf(tr("parameters %s"), o->words);
	bool own = !origin_is_other_site(entry);
	FREED char *details = origin_training_speeds_text(o);
	return xasprintf(
	    own && origin_is_from_store(o)
		? tr("parameters from the store: %s (%s), calibrated on the "
		     "same data as this site")
	    : own ? tr("parameters from %s (%s), calibrated on the same data "
		       "as this site")
	    : origin_is_from_store(o)
		? tr("parameters from the store: %s (%s), not "
		     "calibrated on this site")
		: tr("parameters from %s (%s), not calibrated on this site"),
	    o->from, details);
}

void
origin_add_note_to_answer(struct answer *r, const struct entry *entry)
{
	FREED char *sentence = origin_params_source_sentence(entry);
	if (sentence[0] != '\0')
		answer_add_sentence(r,
		    origin_is_other_site(entry) ? ANSWER_WARNING
						: ANSWER_REMARK,
		    "%s", sentence);
}

void
origin_put_param_source(struct fields *o, const struct entry *entry)
{
	const struct origin *from = entry->origin;
	if (from == NULL)
		return;
	struct fields *object = fields_add_object(o, "params_from");
	fields_put_values(
	    object, "origin %s provenance %s", from->words, from->provenance);
	fields_put_numbers(
	    object, "trained_mps", from->speed, from->n_speed, NULL);
}

const char *
origin_of_params_text(const struct entry *entry)
{
	if (entry->has_fit && !origin_is_from_store(entry->origin))
		return tr("found by calibration");
	if (!entry->has_params)
		return tr("not known yet");
	return tr(entry->origin->words);
}

void
entry_clear(struct entry *entry)
{
	free(entry->key);
	free(entry->remembered);
	free(entry->train);
	origin_release(entry->origin);
	history_release(entry->history);
}

void
entries_free(struct entry *entry, size_t n)
{
	for (size_t i = 0; i < n; i++)
		entry_clear(&entry[i]);
	free(entry);
}

struct entry
entry_copy(const struct entry *from)
{
	struct entry to = *from;
	size_t runs = from->site->n_run;
	to.key = xstrdup(from->key);
	if (from->remembered != NULL)
		to.remembered = xstrdup(from->remembered);
	to.origin = retain_origin(from->origin);
	to.train = xcalloc(runs, sizeof *to.train);
	memcpy(to.train, from->train, runs * sizeof *to.train);
	retain_fit_history(to.history);
	return to;
}

/* A fit is kept with its runs, and what follows from it is drawn anew: the
 * draws are a function of runs, fit and seed.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/sheets/remembered.h"

#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "base/xalloc.h"
#include "cmd/fit/job.h"
#include "cmd/session/sites.h"
#include "io/store/basis.h"

char *
remembered_basis(const struct entry *entry)
{
	const struct history *h = entry->history;
	const struct site *site = entry->site;
	bool grown = h->site->digest != site->digest;
	struct basis basis = {.fit = entry->fit,
	    .bounds = h->bounds,
	    .weight = h->weight,
	    .train = h->train,
	    .then = site_copy(h->site),
	    .now = grown ? site_copy(site) : NULL};
	char *text = basis_written(&basis);
	basis.train = NULL;
	basis_clear(&basis);
	return text;
}

static bool
same_curve(const struct psd *a, const struct psd *b)
{
	size_t size = a->n * sizeof *a->size;
	return a->n == b->n && memcmp(a->size, b->size, size) == 0 &&
	       memcmp(a->passing, b->passing, size) == 0;
}

/* The run's place in a site, or n_run. */
static size_t
place_in(const struct site *site, const struct run *run)
{
	size_t r = 0;
	while (r < site->n_run &&
	       (site->run[r].speed != run->speed ||
		   !same_curve(&site->run[r].feed, &run->feed) ||
		   !same_curve(&site->run[r].product, &run->product)))
		r++;
	return r;
}

static bool
has_runs(const struct site *site, const struct site *of)
{
	for (size_t r = 0; r < of->n_run; r++)
		if (place_in(site, &of->run[r]) == site->n_run)
			return false;
	return true;
}

static bool
has_digest(const struct site *site, const struct stored *m)
{
	return strtoull(m->site_digest, NULL, 16) == site->digest;
}

/* The entry is as the calibration left it. */
static void
give_back(struct entry *entry, const struct basis *b, const struct stored *m,
    struct history *h)
{
	entry->fit = b->fit;
	entry->params = m->params;
	entry->has_fit = entry->has_params = true;
	free(entry->train);
	entry->train = xcalloc(entry->site->n_run, sizeof *entry->train);
	for (size_t r = 0; r < h->site->n_run; r++)
		if (h->train[r])
			entry->train[place_in(entry->site, &h->site->run[r])] =
			    true;
	snprintf(entry->options, sizeof entry->options, "%s", m->options);
	history_drop(entry->history);
	entry->history = h;
	origin_drop(entry->origin);
	entry->origin = origin_remembered(entry, m);
}

static void
give_to_other(struct entry *entry, const struct stored *m, struct history *h)
{
	entry->params = m->params;
	entry->has_params = true;
	entry->has_fit = false;
	origin_drop(entry->origin);
	entry->origin = origin_stored(m);
	entry->origin->spread = h;
}

enum remembered
remembered_take(struct session *s, const struct stored *m, size_t *index,
    struct error *error)
{
	struct basis b;
	error->kind = ERROR_NONE;
	if (!basis_read(m, &b, error)) {
		basis_clear(&b);
		return error->kind == ERROR_NONE ? REMEMBERED_NONE
						 : REMEMBERED_FAILED;
	}
	struct site *now = b.now != NULL ? b.now : b.then;
	if (s->n_entry == 0) {
		session_add(s, now);
		*index = s->current;
	} else {
		session_keep_site(s, now);
	}
	if (now != b.then)
		session_keep_site(s, b.then);
	struct entry *entry = &s->entry[*index];
	/* A site that was made here has more digits than its sheet. */
	bool made = b.now == NULL && has_digest(entry->site, m);
	struct history *h = history_new(
	    &b.fit, &b.bounds, b.weight, made ? entry->site : b.then, b.train);
	h->stop = s->hooks.stop;
	bool own = has_runs(entry->site, h->site);
	if (s->job.calibration != NULL && s->job.entry == *index)
		session_let_go(s);
	if (own && b.now != NULL && !has_runs(entry->site, b.now))
		entry->site = b.now;
	if (own)
		give_back(entry, &b, m, h);
	else
		give_to_other(entry, m, h);
	session_forget(s);
	free(b.train);
	return own ? REMEMBERED_OWN : REMEMBERED_OTHER;
}

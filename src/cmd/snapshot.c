/* Copies of what a session holds, for undo and reset.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/snapshot.h"

#include <stdlib.h>
#include <string.h>

#include "base/xalloc.h"
#include "cmd/origin.h"
#include "cmd/settings.h"

struct snapshot {
	size_t n_entry, current;
	struct entry *entry;
	struct choices set;
};

static struct entry *
copy_entries(const struct entry *from, size_t n)
{
	struct entry *to = xcalloc(n + 1, sizeof *to);
	for (size_t i = 0; i < n; i++)
		to[i] = entry_copy(&from[i]);
	return to;
}

struct snapshot *
snapshot_take(const struct session *s)
{
	struct snapshot *snapshot = xcalloc(1, sizeof *snapshot);
	*snapshot = (struct snapshot){.n_entry = s->n_entry,
	    .current = s->current,
	    .entry = copy_entries(s->entry, s->n_entry),
	    .set = s->set};
	return snapshot;
}

void
snapshot_free(struct snapshot *snapshot)
{
	if (snapshot == NULL)
		return;
	entries_free(snapshot->entry, snapshot->n_entry);
	free(snapshot);
}

void
snapshot_put(struct session *s, const struct snapshot *snapshot)
{
	entries_free(s->entry, s->n_entry);
	s->entry = copy_entries(snapshot->entry, snapshot->n_entry);
	s->n_entry = snapshot->n_entry;
	s->current = snapshot->current;
	s->set = snapshot->set;
	session_forget(s);
}

bool
snapshot_same_fit(const struct fit *a, const struct fit *b)
{
	return memcmp(&a->params, &b->params, sizeof a->params) == 0 &&
	       a->misfit == b->misfit && a->stop == b->stop &&
	       a->generations == b->generations &&
	       a->evaluations == b->evaluations && a->seed == b->seed &&
	       a->population == b->population;
}

static bool
same_entry(const struct entry *a, const struct entry *b)
{
	return a->site == b->site && strcmp(a->key, b->key) == 0 &&
	       memcmp(a->train, b->train, a->site->n_run * sizeof *a->train) ==
		   0 &&
	       a->has_params == b->has_params && a->has_fit == b->has_fit &&
	       memcmp(&a->params, &b->params, sizeof a->params) == 0 &&
	       origin_same(a->origin, b->origin) &&
	       snapshot_same_fit(&a->fit, &b->fit);
}

bool
snapshot_differs(const struct snapshot *snapshot, const struct session *s)
{
	if (snapshot->n_entry != s->n_entry ||
	    snapshot->current != s->current ||
	    !settings_same(&snapshot->set, &s->set))
		return true;
	for (size_t i = 0; i < s->n_entry; i++)
		if (!same_entry(&snapshot->entry[i], &s->entry[i]))
			return true;
	return false;
}

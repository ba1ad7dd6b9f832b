/* An undo step holds the session before it; once undone, also the session after
 * it and the lines of the journal in between.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/session/undo.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "base/xalloc.h"

enum { STEPS = 200 };

/* Borrows the sites, logs, envelopes, pins and energies, which the session
 * keeps until it ends. */
struct snapshot {
	struct mark mark;
	size_t n_entry, current;
	struct entry *entry;
	struct plant_log *log;
	const struct spec *spec;
	const struct pin *pin;
	const struct energies *energy;
	struct settings set;
	struct last_asked asked;
};

static struct entry *
copy_site_entries(const struct entry *from, size_t n)
{
	struct entry *to = xcalloc(n + 1, sizeof *to);
	for (size_t i = 0; i < n; i++)
		to[i] = entry_copy(&from[i]);
	return to;
}

struct snapshot *
snapshot_take_session(const struct session *s)
{
	struct snapshot *snapshot = xcalloc(1, sizeof *snapshot);
	*snapshot = (struct snapshot){.mark = journal_current_place(s),
	    .n_entry = s->n_entry,
	    .current = s->current,
	    .entry = copy_site_entries(s->entry, s->n_entry),
	    .log = s->log,
	    .spec = s->spec,
	    .pin = s->pin,
	    .energy = s->energy,
	    .set = s->set,
	    .asked = s->last_asked};
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

/* Restores the session, and discards the answers that it kept. */
static void
restore_snapshot(struct session *s, const struct snapshot *snapshot)
{
	entries_free(s->entry, s->n_entry);
	s->entry = copy_site_entries(snapshot->entry, snapshot->n_entry);
	s->n_entry = snapshot->n_entry;
	s->current = snapshot->current;
	s->log = snapshot->log;
	s->spec = snapshot->spec;
	s->pin = snapshot->pin;
	s->energy = snapshot->energy;
	s->set = snapshot->set;
	s->last_asked = snapshot->asked;
	session_remove_answers(s);
}

bool
fits_are_equal(const struct fit *a, const struct fit *b)
{
	return memcmp(&a->params, &b->params, sizeof a->params) == 0 &&
	       a->misfit == b->misfit && a->stop == b->stop &&
	       a->generations == b->generations &&
	       a->evaluations == b->evaluations && a->seed == b->seed &&
	       a->population == b->population;
}

bool
session_entries_are_equal(const struct entry *a, const struct entry *b)
{
	return a->site == b->site && strcmp(a->key, b->key) == 0 &&
	       memcmp(a->train, b->train, a->site->n_run * sizeof *a->train) ==
		   0 &&
	       a->has_params == b->has_params && a->has_fit == b->has_fit &&
	       memcmp(&a->params, &b->params, sizeof a->params) == 0 &&
	       origin_is_same(a->origin, b->origin) &&
	       fits_are_equal(&a->fit, &b->fit);
}

bool
snapshot_differs(const struct snapshot *snapshot, const struct session *s)
{
	if (snapshot->n_entry != s->n_entry ||
	    snapshot->current != s->current || snapshot->log != s->log ||
	    snapshot->spec != s->spec || snapshot->pin != s->pin ||
	    snapshot->energy != s->energy ||
	    !settings_are_equal_but_for_looks(&snapshot->set, &s->set))
		return true;
	for (size_t i = 0; i < s->n_entry; i++)
		if (!session_entries_are_equal(
			&snapshot->entry[i], &s->entry[i]))
			return true;
	return false;
}

struct step {
	char *label;
	struct snapshot *before, *after; /* after: only of undone steps */
	struct removed_lines tail;       /* likewise */
};

/* The first `done` steps can be undone, the others redone. */
struct undo {
	size_t n, done;
	struct step step[2 * STEPS]; /* the upper half is for scripts */
};

static void
undo_step_free(struct step *step)
{
	free(step->label);
	snapshot_free(step->before);
	snapshot_free(step->after);
	removed_lines_free(&step->tail);
}

static void
remove_undo_steps_after(struct undo *undo, size_t n)
{
	while (undo->n > n)
		undo_step_free(&undo->step[--undo->n]);
}

struct undo *
undo_new(void)
{
	return xcalloc(1, sizeof(struct undo));
}

void
undo_free(struct undo *undo)
{
	remove_undo_steps_after(undo, 0);
	free(undo);
}

size_t
undo_count_steps(const struct session *s)
{
	return s->undo->done;
}

void
undo_push_step(struct session *s, struct snapshot *before, size_t depth,
    size_t floor, const char *label)
{
	struct undo *undo = s->undo;
	remove_undo_steps_after(undo, depth < undo->done ? depth : undo->done);
	bool inner = floor != SIZE_MAX;
	if (undo->n >= (inner ? 2 * STEPS : STEPS)) {
		/* A script that draws many screens may fill both halves. */
		size_t oldest = inner && floor < undo->n ? floor : 0;
		undo_step_free(&undo->step[oldest]);
		undo->n--;
		memmove(&undo->step[oldest], &undo->step[oldest + 1],
		    (undo->n - oldest) * sizeof undo->step[0]);
	}
	undo->step[undo->n++] =
	    (struct step){.label = xstrdup(label), .before = before};
	undo->done = undo->n;
}

const char *
undo_last_step(struct session *s)
{
	if (undo_count_steps(s) == 0)
		return NULL;
	struct step *step = &s->undo->step[--s->undo->done];
	step->after = snapshot_take_session(s);
	step->tail = journal_remove_lines_after(s, step->before->mark);
	restore_snapshot(s, step->before);
	return step->label;
}

const char *
undo_redo_step(struct session *s)
{
	if (s->undo->done == s->undo->n)
		return NULL;
	struct step *step = &s->undo->step[s->undo->done++];
	step->before->mark = journal_current_place(s);
	journal_restore_lines(s, &step->tail);
	restore_snapshot(s, step->after);
	snapshot_free(step->after);
	step->after = NULL;
	return step->label;
}

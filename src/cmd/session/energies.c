/* Reads collision energies, keeps them by file, and makes Eq 3 use the impacts
 * of a file above its cut.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/session/energies.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/text.h"
#include "base/tr.h"
#include "base/xalloc.h"
#include "cmd/session/files.h"
#include "io/fs/file.h"
#include "io/fs/shipped.h"

const struct energies *
energies_last_read(const struct session *s, struct error *error)
{
	if (s->energy == NULL)
		error_set(error, ERROR_USAGE,
		    "no collision energies are loaded\n"
		    "load some: energy load FILE");
	return s->energy;
}

void
energies_free(struct energies *e)
{
	free(e->name);
	free(e->path);
	collisions_clear(&e->c);
	free(e);
}

/* Reports progress to a user at the prompt.  Returns false if the user has
 * interrupted. */
static bool
report_rows_read(void *data, uint64_t rows)
{
	const struct session *s = data;
	const uint64_t often = 1 << 21;
	if (s->prompt && rows % often == 0)
		session_print_note(
		    s, "  %.1f million rows so far", (double)rows / 1e6);
	return s->hooks.stop == NULL || !s->hooks.stop();
}

static char *
file_name_without_extension(const char *path)
{
	char *name = xstrdup(file_name_without_folders(path));
	char *dot = strrchr(name, '.');
	if (dot != NULL && dot != name)
		*dot = '\0';
	return name;
}

const struct energies *
energies_load_file(struct session *s, const char *asked,
    const struct collisions_way *way, double cut, struct error *error)
{
	/* A file at that path comes before a shipped one of that name. */
	FREED char *shipped =
	    !file_exists(asked) ? shipped_energies_path(asked) : NULL;
	const char *path = shipped != NULL ? shipped : asked;
	struct error_list errors = {.stop = s->hooks.stop};
	struct collisions_way told = *way;
	struct collisions c;
	told.progress = report_rows_read;
	told.data = s;
	files_record_read(s, path);
	if (!collisions_read(path, &told, &c, &errors)) {
		session_report_file_faults(s, path, &errors, error);
		return NULL;
	}
	struct energies *e = xcalloc(1, sizeof *e);
	*e = (struct energies){.name = file_name_without_extension(path),
	    .path = xstrdup(path),
	    .cut = cut,
	    .c = c};
	s->energies =
	    xrealloc(s->energies, s->n_energies + 1, sizeof(*s->energies));
	return s->energies[s->n_energies++] = e;
}

bool
energies_use_file_in_model(
    struct session *s, const char *path, struct error *error)
{
	const struct energies *found = NULL;
	if (text_is_same_folded(path, "off")) {
		s->set.energy = NULL;
		s->set.model.impacts = (struct impacts){.n = 0};
		return true;
	}
	for (size_t i = 0; i < s->n_energies; i++)
		if (strcmp(s->energies[i]->path, path) == 0 ||
		    strcmp(s->energies[i]->name, path) == 0)
			found = s->energies[i];
	if (found == NULL)
		found = energies_load_file(s, path,
		    &(struct collisions_way){.speed = NAN}, ENERGIES_CUT,
		    error);
	if (found == NULL)
		return false;
	if (!(found->c.spectrum->speed > 0))
		return error_set(error, ERROR_USAGE,
		    "expected collision energies of a known tip speed, got "
		    "none\nload them with it: energy load %s speed=V",
		    path);
	struct impacts impacts =
	    spectrum_group_impacts_by_energy(found->c.spectrum, found->cut);
	if (impacts.n == 0)
		return error_set(error, ERROR_DATA,
		    "expected impacts above %g J/kg in %s, got none\n"
		    "load them with a lower cut=",
		    found->cut, path);
	if (s->energy == NULL)
		s->energy = found;
	s->set.energy = found->path;
	s->set.model.impacts = impacts;
	return true;
}

/* Returns the energies that the model uses, or NULL. */
static const struct energies *
energies_used_by_model(const struct session *s)
{
	for (size_t j = 0; j < s->n_energies; j++)
		if (s->set.model.impacts.n > 0 &&
		    s->energies[j]->path == s->set.energy)
			return s->energies[j];
	return NULL;
}

void
energies_put_field(struct fields *o, const struct session *s)
{
	const struct energies *e = energies_used_by_model(s);
	if (e != NULL)
		fields_put_values(o, "energies %s", e->name);
}

char *
energies_trust_reason(const struct session *s)
{
	const struct impacts *i = &s->set.model.impacts;
	const struct energies *e = energies_used_by_model(s);
	if (e == NULL)
		return NULL;
	if (!e->c.spectrum->counted)
		return xasprintf(
		    tr("Eq 3 takes one impact per particle from the collision "
		       "energies of %s above %g J/kg, where particles were not "
		       "counted, instead of one impact at v^2/2: as far as is "
		       "known, a simulation, not a measurement"),
		    e->name, e->cut);
	return xasprintf(
	    tr("Eq 3 takes the collision energies of %s (%.2f impacts per "
	       "particle above %g J/kg) instead of one impact at v^2/2: as far "
	       "as is known, a simulation, not a measurement"),
	    e->name, i->number, e->cut);
}

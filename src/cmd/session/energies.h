/* Collision energies in the session.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_SESSION_ENERGIES_H
#define TIPSPEED_CMD_SESSION_ENERGIES_H

#include "cmd/session/session.h"
#include "io/formats/collisions.h"

/* J/kg; impacts below it are not shown and do not count in the model, unless
 * told otherwise. */
enum { ENERGIES_CUT = 10 };

/* A file that was read; not changed afterwards.  name: the file's name without
 * its ending; cut: of the impacts that count, J/kg. */
struct energies {
	char *name, *path;
	double cut;
	struct collisions c;
};

/* Reads a file and keeps it until the session ends.  A file already read in the
 * same way is not read again.  NULL with an error. */
const struct energies *energies_read(struct session *s, const char *path,
    const struct collisions_way *way, double cut, struct error *error);

void energies_free(struct energies *e);

/* Returns the energies read last; NULL with an error where there are none. */
const struct energies *energies_loaded(
    const struct session *s, struct error *error);

/* Makes the model use the energies of a file instead of the single energy
 * (D15), or for "off" the single energy again.  False with an error, also for a
 * file without a speed. */
bool energies_set(struct session *s, const char *path, struct error *error);

/* Returns what Eq 3 uses instead of the single energy, as a reason to doubt;
 * NULL where it uses the single energy.  The caller frees. */
char *energies_words(const struct session *s);

#endif

/* Collision energies that the session has.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_SESSION_ENERGIES_H
#define TIPSPEED_CMD_SESSION_ENERGIES_H

#include "cmd/session/session.h"
#include "io/formats/collisions.h"

/* A file that was read; never changed after.  name: the file's without its
 * ending; cut: that it was read with, J/kg. */
struct energies {
	char *name, *path;
	double cut;
	struct collisions c;
};

/* Reads a file and keeps it to the session's end.  NULL with an error; a
 * file that was read already in the same way is not read again. */
const struct energies *energies_read(struct session *s, const char *path,
    const struct collisions_way *way, struct error *error);

void energies_free(struct energies *e);

/* Those read last; NULL, with an error, where there are none. */
const struct energies *energies_last(
    const struct session *s, struct error *error);

/* A way with nothing given: cut 10 J/kg, 2700 kg/m3. */
struct collisions_way energies_way(void);

/* Has the model take the energies of a file in place of the single one (D15),
 * or that again for "off".  False with an error, for files without a speed
 * too. */
bool energies_set(struct session *s, const char *path, struct error *error);

/* What Eq 3 takes instead of the single energy, as a reason to doubt; NULL
 * where it is the single energy.  The caller frees. */
char *energies_words(const struct session *s);

#endif

/* The session's collision energies.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_SESSION_ENERGIES_H
#define TIPSPEED_CMD_SESSION_ENERGIES_H

#include "cmd/session/session.h"
#include "io/formats/collisions.h"

/* J/kg; by default, impacts with less energy are not shown and not used in the
 * model. */
enum { ENERGIES_CUT = 10 };

/* A file that was read; immutable.  name: the file's name without extension;
 * cut: lowest energy of the impacts used, J/kg. */
struct energies {
	char *name, *path;
	double cut;
	struct collisions c;
};

/* Reads a file, again if it was read before, because it may have changed, and
 * keeps what it read until the session ends.  On failure, returns NULL with an
 * error. */
const struct energies *energies_read_file(struct session *s, const char *path,
    const struct collisions_way *way, double cut, struct error *error);

void energies_free(struct energies *e);

/* Returns the energies last read, or NULL with an error if there are none. */
const struct energies *energies_last_read(
    const struct session *s, struct error *error);

/* Makes the model use the energies in a file, as last read, instead of the
 * single energy (D15), or, for "off", the single energy again.  On failure, or
 * if the file has no speed, returns false with an error. */
bool energies_use_file_in_model(
    struct session *s, const char *path, struct error *error);

/* Puts "energies", the name of the collision energies that the model uses, if
 * it uses any. */
void energies_put_field(struct fields *o, const struct session *s);

/* Returns a reason for the light that names what Eq 3 uses instead of the
 * single energy, or NULL if it uses that.  The caller frees it. */
char *energies_trust_reason(const struct session *s);

#endif

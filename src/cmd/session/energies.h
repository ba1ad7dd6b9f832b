/* The collision energies that the session has read.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_SESSION_ENERGIES_H
#define TIPSPEED_CMD_SESSION_ENERGIES_H

#include "cmd/session/session.h"
#include "io/formats/collisions.h"

/* By default, impacts with less energy than this, J/kg, are neither shown nor
 * used in the model. */
enum { ENERGIES_CUT = 10 };

/* The collision energies of a file; they do not change. */
struct energies {
	/* The file's name without folder and extension, and its path. */
	char *name, *path;
	/* The lowest energy of the impacts that are used, J/kg. */
	double cut;
	struct collisions c;
};

/* Reads a file, or a shipped one of that name, even if it was read before,
 * because it may have changed.  The session keeps the result until it ends.
 * Returns NULL with an error on failure. */
const struct energies *energies_load_file(struct session *s, const char *asked,
    const struct collisions_way *way, double cut, struct error *error);

void energies_free(struct energies *e);

/* Returns the collision energies to show, or NULL with an error if none were
 * loaded. */
const struct energies *energies_last_read(
    const struct session *s, struct error *error);

/* Makes the model use the collision energies in a file, as last read, instead
 * of a single energy (D15); "off" goes back to the single energy.  Returns
 * false with an error on failure, or if the file does not state its speed. */
bool energies_use_file_in_model(
    struct session *s, const char *path, struct error *error);

/* Puts "energies", the name of the collision energies that the model uses, if
 * it uses any. */
void energies_put_field(struct fields *o, const struct session *s);

/* Returns a reason for the light, which says which energies Eq 3 uses; NULL if
 * it uses the single energy.  The caller frees it. */
char *energies_trust_reason(const struct session *s);

#endif

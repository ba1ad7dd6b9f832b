/* What a calibration rests on, from a session to a material and back.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_SHEETS_REMEMBERED_H
#define TIPSPEED_CMD_SHEETS_REMEMBERED_H

#include "cmd/session/session.h"

/* The basis of a calibrated site's fit as a material has it; the caller
 * frees. */
char *remembered_basis(const struct entry *entry);

/* What became of a material that was recalled. */
enum remembered {
	REMEMBERED_FAILED, /* with an error */
	REMEMBERED_NONE,   /* it keeps no runs, or none are wanted */
	REMEMBERED_OWN,    /* it is the site's calibration again */
	REMEMBERED_OTHER   /* the site has the draws of another's */
};

/* Takes the calibration that a material rests on into the session: for the
 * loaded site at *index, whose own it becomes where the site has its runs; or,
 * where no site is loaded, with the site itself, at *index then.  What came to
 * the site since is kept, whichever of the two has it. */
enum remembered remembered_take(struct session *s, const struct stored *m,
    size_t *index, struct error *error);

#endif

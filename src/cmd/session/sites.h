/* The loaded sites: adding, finding, dropping.
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef TIPSPEED_CMD_SESSION_SITES_H
#define TIPSPEED_CMD_SESSION_SITES_H

#include "cmd/session/session.h"

/* Adds a site, which the session then owns, and makes it the one in use.  It
 * replaces a site that was read from the same file. */
void session_add(struct session *s, struct site *site);

/* Keeps a site to the session's end, which then owns it, without loading it. */
void session_keep_site(struct session *s, struct site *site);

/* Takes a site out of those loaded, and discards a calibration of it. */
void session_drop(struct session *s, size_t index);

/* Puts a mended site, which the session then owns, in the place of a loaded
 * one.  What a calibration found on the former is no longer the site's; returns
 * whether there was such.  Other parameters stay. */
bool session_mend(struct session *s, size_t index, struct site *site);

/* Puts a site that has more runs, which the session then owns, in the place of
 * the one in use; from [n_run]: see site_with_cuts.  Its parameters and its fit
 * stay: they are of the former numbers, and the new runs are held out. */
void session_grow(struct session *s, struct site *site, const size_t *from);

/* Finds a loaded site by name without case and accents ("borlange"), by name
 * and top size ("gavle/4") or by key.  Several or none: an error that lists
 * what there is. */
bool session_find(
    struct session *s, const char *name, size_t *index, struct error *error);

/* Takes a site that was read, which the session then owns, or refuses it: where
 * digest, hexadecimal digits or NULL, is another. */
bool session_take(struct session *s, struct site *site, const char *digest,
    struct error *error);

#endif
